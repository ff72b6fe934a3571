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

/// Friction heats with their tables, by law, operating point, and the values on which the law depends. Any number of
/// threads may use it.
class KeptFriction {
public:
    using Key = std::tuple<std::string, OperatingPoint, std::vector<double>>;
    [[nodiscard]] std::optional<FrictionHeat> find(const Key& key) const;
    void keep(const Key& key, const FrictionHeat& heat);

private:
    mutable std::mutex mutex_;
    std::map<Key, FrictionHeat> kept_;
};

/// What a case takes from others of its machine that have the same loads.
struct KnownLaws {
    std::shared_ptr<const LoadsResult> first;                       ///< of the first segment in which the press runs
    std::map<LoadsKey, std::shared_ptr<const LoadsResult>> others;  ///< of other segments, and of references
    std::function<std::vector<double>(const std::string&)> values;  ///< on which a friction law depends, by its name
    KeptFriction* kept = nullptr;
};

}  // namespace deadpoint::study
