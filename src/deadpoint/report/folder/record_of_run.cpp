#include "deadpoint/report/folder/record_of_run.hpp"

#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/press/result/loads_result.hpp"
#include "deadpoint/press/result/run_result.hpp"
#include "deadpoint/press/run/run_record.hpp"
#include "deadpoint/press/run/run_summary.hpp"
#include "deadpoint/report/tables/sampled.hpp"

#include <fmt/format.h>
#include <utility>

namespace deadpoint::report {
namespace {

void add_bearings(const press::LoadsResult& loads, press::RunRecord& record)
{
    if (!loads.crankshaft)
        return;
    const auto& by_seat = loads.crankshaft->by_seat;
    for (const auto& [model, seats] : {std::pair{"rigid", &by_seat.rigid}, std::pair{"flexible", &by_seat.flexible}})
        for (const auto& seat : *seats)
            record.loads[fmt::format("crankshaft.{}.seats.{}.peak_N", model, seat.name)] = seat.peak;
}

}  // namespace

press::RunRecord record_of(const casefile::Case& input, std::string hash, const press::RunResult& result)
{
    press::RunRecord record;
    record.machine = input.machine.name;
    record.hash = std::move(hash);
    record.interrupted = result.thermal.interrupted;
    record.initial_temperature = input.machine.initial_temperature;
    record.time = history_times(input, result);
    const auto& steps = result.thermal.time;
    for (const auto& [name, course] : result.probes) {
        record.probes.push_back(name);
        record.rises[name] = sampled(steps, course, record.time, 1, -record.initial_temperature);
    }
    for (const auto& [name, joint] : result.joints)
        record.joint_heat[name] = sampled_linear(steps, joint.heat, record.time, 1, 0);
    if (result.drift)
        for (const auto& [name, series] : dimensions(*result.drift))
            record.chain[name] = sampled(steps, *series, record.time, 1, 0);
    if (result.drift)
        record.gap = press::gap_figures(input, *result.drift);
    if (result.loads) {
        record.has_loads = true;
        add_bearings(*result.loads, record);
    }
    return record;
}

}  // namespace deadpoint::report
