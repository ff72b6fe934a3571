#include "deadpoint/press/loads/loads_cache.hpp"

#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/casefile/syntax/case_bytes.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/press/result/loads_result.hpp"

#include <algorithm>
#include <chrono>
#include <fmt/format.h>

namespace deadpoint::press {

namespace {

std::shared_ptr<KeptFriction> kept_friction(const std::shared_ptr<KeptShapes>& shapes)
{
    auto result = std::make_shared<KeptFriction>();
    result->shapes = shapes;
    return result;
}

/// Loads that are still being computed, or could not be, are no others'.
bool holds(const std::shared_future<std::shared_ptr<const LoadsResult>>& computed, const LoadsResult& loads)
{
    if (computed.wait_for(std::chrono::seconds(0)) != std::future_status::ready)
        return false;
    try {
        return computed.get().get() == &loads;
    } catch (const Error&) {
        return false;
    }
}

}  // namespace

std::string loads_part(const casefile::Case& input, int segment)
{
    auto read = input;
    read.machine.name.clear();
    read.machine.description.clear();
    read.machine.ambient = read.machine.initial_temperature = casefile::MachineSection{}.ambient;
    read.parts.clear();
    read.lubricants.clear();
    read.friction.clear();
    read.oil.clear();
    read.oil_with_speed.clear();
    read.oil_circuits.clear();
    for (auto& [name, joint] : read.joints) {
        joint.friction.clear();
        joint.oil_temperature = casefile::Joint{}.oil_temperature;
        joint.clearance.reset();
        joint.interfaces.clear();
    }
    read.bonds.clear();
    read.surfaces.clear();
    read.heat_sources.clear();
    read.enclosures.clear();
    if (segment >= 0 && segment < static_cast<int>(input.operation.size())) {
        casefile::Segment only;
        only.speed = input.operation[static_cast<std::size_t>(segment)].speed;
        only.force = input.operation[static_cast<std::size_t>(segment)].force;
        read.operation = {only};
    }
    read.probes.clear();
    read.foundation.reset();
    read.preload.clear();
    read.numerics = {};
    read.output = {};
    read.reduce.reset();
    read.reference.reset();
    return fmt::format("{}\n{}", segment, casefile::case_bytes(std::move(read)));
}

std::shared_ptr<const LoadsResult> LoadsCache::get(const casefile::Case& input, const Machine* machine, int segment,
                                                   Vibration vibration)
{
    const Key key{loads_part(input, segment), vibration};
    std::packaged_task<std::shared_ptr<const LoadsResult>()> task([&] {
        return std::make_shared<const LoadsResult>(compute_loads(input, machine, segment, vibration, &turns_));
    });
    std::unique_lock lock(mutex_);
    if (const auto found = std::ranges::find(kept_, key, &Entry::key); found != kept_.end()) {
        kept_.splice(kept_.begin(), kept_, found);
        const auto loads = found->loads;
        lock.unlock();
        return loads.get();
    }
    const auto loads = kept_.emplace_front(Entry{key, task.get_future().share(), kept_friction(shapes_)}).loads;
    if (kept_.size() > most_)
        kept_.pop_back();
    lock.unlock();
    task();
    return loads.get();
}

std::shared_ptr<KeptFriction> LoadsCache::friction_at(const LoadsResult& loads)
{
    const std::scoped_lock lock(mutex_);
    const auto found = std::ranges::find_if(kept_, [&](const Entry& entry) { return holds(entry.loads, loads); });
    return found == kept_.end() ? kept_friction(shapes_) : found->friction;
}

}  // namespace deadpoint::press
