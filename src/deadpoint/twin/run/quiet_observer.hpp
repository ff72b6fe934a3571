#pragma once

#include "deadpoint/observer.hpp"

/// An observer for runs inside of others.
namespace deadpoint::twin {

/// Passes on nothing but the wish to stop.
class Silent : public Observer {
public:
    explicit Silent(const Observer& to) : to_(to) {}
    [[nodiscard]] bool cancelled() const override { return to_.cancelled(); }

private:
    const Observer& to_;
};

}  // namespace deadpoint::twin
