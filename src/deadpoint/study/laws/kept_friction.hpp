#pragma once

#include "deadpoint/exchange/laws/law_table.hpp"
#include "deadpoint/study/laws/loads_key.hpp"
#include "deadpoint/study/result/friction_summary.hpp"

#include <cstddef>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

/// Friction laws that many cases of one machine share.
namespace deadpoint::study {

struct LoadsResult;

/// Values that are computed once for each key. Any number of threads may use them; two that ask for the same at once
/// both compute it.
template <class Key, class Value>
class KeptValues {
public:
    /// @param most  number of values that are kept
    explicit KeptValues(std::size_t most) : most_(most) {}
    /// @param make  computes the value of the key where it is not there
    template <class Make>
    std::shared_ptr<const Value> get(const Key& key, const Make& make)
    {
        if (auto found = find(key))
            return found;
        auto made = std::make_shared<const Value>(make());
        const std::scoped_lock lock(mutex_);
        if (kept_.size() >= most_)
            kept_.clear();
        return kept_.emplace(key, std::move(made)).first->second;
    }

private:
    std::shared_ptr<const Value> find(const Key& key) const
    {
        const std::scoped_lock lock(mutex_);
        const auto found = kept_.find(key);
        return found == kept_.end() ? nullptr : found->second;
    }

    std::size_t most_;
    mutable std::mutex mutex_;
    std::map<Key, std::shared_ptr<const Value>> kept_;
};

/// Duty of the joints of a calibrated law, to which its load part is proportional.
struct LoadDuty {
    double sum = 0;         ///< of mean(F^1.33 |w|) or mean(F |w|), by the kind of the law
    bool unloaded = false;  ///< the joints carry no load
};

/// Viscous shapes of calibrated laws as tables, by lubricant, exponent and, of rolling friction, speed.
using KeptShapes = KeptValues<std::string, LawTable>;

/// What follows from loads, for cases that agree in all that loads depend on. `loads` are others of the same cases.
struct KeptFriction {
    /// Inputs of a law (FrictionLaws) and the loads at which it is wanted.
    using Key = std::pair<std::string, LoadsKey>;
    KeptValues<LoadsKey, std::shared_ptr<const LoadsResult>> loads{16};  ///< at other points, and at references
    KeptValues<Key, LoadDuty> duties{1024};
    KeptValues<Key, FrictionHeat> heats{256};  ///< of physical laws, without their scale
    KeptValues<Key, LawTable> tables{256};     ///< of the same; one takes some tens of kilobytes
    /// Of any loads.
    std::shared_ptr<KeptShapes> shapes = std::make_shared<KeptShapes>(std::size_t{64});
};

}  // namespace deadpoint::study
