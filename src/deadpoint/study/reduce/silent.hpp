#pragma once

#include "deadpoint/observer.hpp"

/// Internal to study/reduce/.
namespace deadpoint::study {

/// Passes on nothing but the wish to stop.
class Silent : public Observer {
public:
    explicit Silent(const Observer& to) : to_(to) {}
    [[nodiscard]] bool cancelled() const override { return to_.cancelled(); }

private:
    const Observer& to_;
};

}  // namespace deadpoint::study
