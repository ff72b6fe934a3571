#pragma once

#include "deadpoint/press/loads/kept_friction.hpp"
#include "deadpoint/press/loads/loads.hpp"
#include "deadpoint/press/loads/turn_cache.hpp"

#include <cstddef>
#include <future>
#include <list>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

/// Loads that the runs of many similar cases share.
namespace deadpoint::press {

/// What loads of a machine depend on, as bytes: everything of a case but what compute_loads() does not read, and but
/// its parts, which the machine is made of.
std::string loads_part(const casefile::Case& input, int segment);

/// compute_loads() for cases of one machine, which it computes again only where loads_part() differs, and the positions
/// of the linkage only where its geometry does. Keeps the loads that were asked for last, each with the friction laws
/// that follow from them. Any number of threads may use it; one computes loads, others that ask for the same wait.
class LoadsCache {
public:
    /// @param most  number of loads that are kept; those of the shipped press take 2 MB each
    explicit LoadsCache(std::size_t most = 8) : most_(most) {}
    /// As compute_loads(), and its errors.
    std::shared_ptr<const LoadsResult> get(const casefile::Case& input, const Machine* machine, int segment,
                                           Vibration vibration);
    /// Friction laws at loads of this cache, which all cases with these loads share.
    std::shared_ptr<KeptFriction> friction_at(const LoadsResult& loads);
    /// Positions that no speed or force changes.
    [[nodiscard]] TurnCache& turns() { return turns_; }

private:
    using Loads = std::shared_future<std::shared_ptr<const LoadsResult>>;
    using Key = std::pair<std::string, Vibration>;
    struct Entry {
        Key key;
        Loads loads;
        std::shared_ptr<KeptFriction> friction;
    };

    std::size_t most_;
    TurnCache turns_;
    std::mutex mutex_;
    std::list<Entry> kept_;  ///< the last one first
    std::shared_ptr<KeptShapes> shapes_ = std::make_shared<KeptShapes>(std::size_t{64});
};

}  // namespace deadpoint::press
