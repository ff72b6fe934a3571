#pragma once

#include "deadpoint/observer.hpp"

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

/// Internal to api/: observers.
namespace deadpoint {

/// The given observer, or a silent one.
class ObserverOrNone {
public:
    explicit ObserverOrNone(Observer* given) : given_(given) {}
    [[nodiscard]] Observer& get() { return given_ ? *given_ : silent_; }

private:
    Observer* given_;
    Observer silent_;
};

/// Forwards everything and keeps the warnings; each of them once.
class Listener : public Observer {
public:
    explicit Listener(Observer& to) : to_(to) {}
    void stage(std::string_view name) override { to_.stage(name); }
    void progress(double fraction, std::string_view detail) override { to_.progress(fraction, detail); }
    void info(std::string_view text) override { to_.info(text); }
    void warn(std::string_view text) override
    {
        if (std::ranges::find(warnings, text) != warnings.end())
            return;
        warnings.emplace_back(text);
        to_.warn(text);
    }
    [[nodiscard]] bool cancelled() const override { return to_.cancelled(); }
    std::vector<std::string> warnings;

private:
    Observer& to_;
};

}  // namespace deadpoint
