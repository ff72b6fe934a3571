#pragma once

#include "deadpoint/observer.hpp"

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

namespace deadpoint::twin {

/// Observer of one run among many: keeps warnings, says nothing, and stops when the study is told to stop.
class PointObserver : public Observer {
public:
    /// @param study  outlives this
    explicit PointObserver(const Observer& study) : study_(study) {}
    void warn(std::string_view text) override
    {
        if (std::ranges::find(warnings, text) == warnings.end())
            warnings.emplace_back(text);
    }
    [[nodiscard]] bool cancelled() const override { return study_.cancelled(); }

    std::vector<std::string> warnings;  ///< each once

private:
    const Observer& study_;
};

}  // namespace deadpoint::twin
