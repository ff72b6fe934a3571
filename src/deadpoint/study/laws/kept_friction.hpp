#pragma once

#include "deadpoint/exchange/laws/operating_point.hpp"
#include "deadpoint/study/laws/loads_key.hpp"
#include "deadpoint/study/result/friction_summary.hpp"

#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

/// Friction laws that many cases of one machine share.
namespace deadpoint::study {

struct LoadsResult;

/// Load part of a calibrated law over that at its reference.
struct LoadRatio {
    double ratio = 1;
    bool unloaded = false;  ///< its joints carry no load at the reference
};

/// Friction heats with their tables, by law, operating point, and the values on which the law depends; and ratios of
/// loads, by law, operating point and reference. Any number of threads may use it.
class KeptFriction {
public:
    using Key = std::tuple<std::string, OperatingPoint, std::vector<double>>;
    [[nodiscard]] std::optional<FrictionHeat> heat(const Key& key) const { return found(heats_, key); }
    void keep(const Key& key, const FrictionHeat& heat) { insert(heats_, key, heat); }
    [[nodiscard]] std::optional<LoadRatio> ratio(const Key& key) const { return found(ratios_, key); }
    void keep(const Key& key, const LoadRatio& ratio) { insert(ratios_, key, ratio); }

private:
    static constexpr std::size_t most = 4096;  ///< a table takes some kilobytes

    template <class Value>
    std::optional<Value> found(const std::map<Key, Value>& kept, const Key& key) const
    {
        const std::scoped_lock lock(mutex_);
        const auto at = kept.find(key);
        return at == kept.end() ? std::nullopt : std::optional(at->second);
    }
    template <class Value>
    void insert(std::map<Key, Value>& kept, const Key& key, const Value& value)
    {
        const std::scoped_lock lock(mutex_);
        if (kept.size() >= most)
            kept.clear();
        kept.emplace(key, value);
    }

    mutable std::mutex mutex_;
    std::map<Key, FrictionHeat> heats_;
    std::map<Key, LoadRatio> ratios_;
};

/// What a case takes from others of its machine that have the same loads.
struct KnownLaws {
    std::shared_ptr<const LoadsResult> first;                       ///< of the first segment in which the press runs
    std::map<LoadsKey, std::shared_ptr<const LoadsResult>> others;  ///< of other segments, and of references
    std::function<std::vector<double>(const std::string&)> values;  ///< on which a friction law depends, by its name
    KeptFriction* kept = nullptr;
};

}  // namespace deadpoint::study
