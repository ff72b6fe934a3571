#include "deadpoint/study/pipeline/loads_cache.hpp"

#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/casefile/files/write.hpp"
#include "deadpoint/study/result/loads_result.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace deadpoint::study {

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
    return fmt::format("{}\n{}", segment, casefile::write_case(read));
}

std::shared_ptr<const LoadsResult> LoadsCache::get(const casefile::Case& input, const Machine* machine, int segment,
                                                   Vibration vibration)
{
    const Key key{loads_part(input, segment), vibration};
    std::packaged_task<std::shared_ptr<const LoadsResult>()> task([&] {
        return std::make_shared<const LoadsResult>(compute_loads(input, machine, segment, vibration, &turns_));
    });
    std::unique_lock lock(mutex_);
    if (const auto found = std::ranges::find(kept_, key, &std::pair<Key, Loads>::first); found != kept_.end()) {
        kept_.splice(kept_.begin(), kept_, found);
        const auto loads = found->second;
        lock.unlock();
        return loads.get();
    }
    const auto loads = kept_.emplace_front(key, task.get_future().share()).second;
    if (kept_.size() > most_)
        kept_.pop_back();
    lock.unlock();
    task();
    return loads.get();
}

}  // namespace deadpoint::study
