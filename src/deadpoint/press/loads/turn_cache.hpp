#pragma once

#include "deadpoint/exchange/linkage.hpp"

#include <memory>
#include <mutex>
#include <optional>
#include <utility>

namespace deadpoint::mechanism {
struct Turn;
}

namespace deadpoint::press {

/// Positions of a linkage over a turn and its bottom dead point, which loads at any speed and force share. Keeps those
/// that were asked for last, 20 MB for the shipped press. Any number of threads may use it; one computes while others
/// wait.
class TurnCache {
public:
    /// As mechanism::turn_of(), and its errors.
    std::shared_ptr<const mechanism::Turn> get(const Linkage& linkage, int positions);
    /// As mechanism::bottom_dead_point(), and its errors.
    BottomDeadPointSensitivity bottom(const Linkage& linkage);

private:
    std::mutex mutex_;
    Linkage linkage_;
    int positions_ = 0;
    std::shared_ptr<const mechanism::Turn> turn_;
    std::optional<std::pair<Linkage, BottomDeadPointSensitivity>> bottom_;
};

}  // namespace deadpoint::press
