#include "deadpoint/study/laws/kept_friction.hpp"

namespace deadpoint::study {
namespace {

constexpr std::size_t most = 4096;  // a table takes some kilobytes

}  // namespace

std::optional<FrictionHeat> KeptFriction::find(const Key& key) const
{
    const std::scoped_lock lock(mutex_);
    const auto found = kept_.find(key);
    return found == kept_.end() ? std::nullopt : std::optional(found->second);
}

void KeptFriction::keep(const Key& key, const FrictionHeat& heat)
{
    const std::scoped_lock lock(mutex_);
    if (kept_.size() >= most)
        kept_.clear();
    kept_.emplace(key, heat);
}

}  // namespace deadpoint::study
