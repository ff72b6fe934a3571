#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <mutex>
#include <utility>

namespace deadpoint {

/// Values that are computed once for each key. Any number of threads may use them; two that ask for the same at once
/// both compute it.
template <class Key, class Value>
class Memo {
public:
    /// @param most  number of values that are kept
    explicit Memo(std::size_t most) : most_(most) {}
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

}  // namespace deadpoint
