#include "deadpoint/press/problem/run_laws.hpp"

#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/core/stopwatch.hpp"
#include "deadpoint/exchange/heat.hpp"
#include "deadpoint/exchange/machine.hpp"
#include "deadpoint/observer.hpp"
#include "deadpoint/press/laws/friction.hpp"
#include "deadpoint/press/loads/loads_cache.hpp"
#include "deadpoint/press/problem/heat.hpp"
#include "deadpoint/press/result/loads_result.hpp"
#include "deadpoint/press/result/run_result.hpp"

#include <memory>

namespace deadpoint::press {

HeatProblem run_laws(const casefile::Case& input, const Machine& machine, Vibration vibration, Stopwatch& watch,
                     RunResult& result, Observer& observer, LoadsCache* shared)
{
    result.symmetry_factor = machine.half_model ? 2 : 1;
    if (const int segment = first_running_segment(input); segment >= 0 && has_loads(input)) {
        watch.start("loads");
        result.loads = shared ? shared->get(input, &machine, segment, vibration)
                              : std::make_shared<const LoadsResult>(compute_loads(input, &machine, segment, vibration));
        for (const auto& warning : result.loads->warnings)
            observer.warn(warning.text);
    }
    watch.start("laws");
    const auto* loads = result.loads.get();
    FrictionLaws friction(input, &machine, loads, shared);
    auto problem = describe_heat(input, machine, observer, loads, friction);
    if (!input.friction.empty())
        result.friction = friction.summaries();
    for (const auto& warning : friction.warnings(result.friction))
        observer.warn(warning);
    return problem;
}

HeatProblem heat_with(const casefile::Case& input, const Machine& machine, LoadsCache& shared, Observer& observer)
{
    std::shared_ptr<const LoadsResult> loads;
    if (const int segment = first_running_segment(input); segment >= 0 && has_loads(input))
        loads = shared.get(input, &machine, segment, Vibration::left_out);
    FrictionLaws friction(input, &machine, loads.get(), &shared);
    return describe_heat(input, machine, observer, loads.get(), friction);
}

}  // namespace deadpoint::press
