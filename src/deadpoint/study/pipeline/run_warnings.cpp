#include "deadpoint/study/pipeline/run_warnings.hpp"

#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/core/units.hpp"
#include "deadpoint/exchange/drift.hpp"
#include "deadpoint/exchange/heat.hpp"
#include "deadpoint/exchange/machine.hpp"
#include "deadpoint/observer.hpp"
#include "deadpoint/study/result/run_result.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace deadpoint::study {

void warn_about(const ThermalHistory& history, const HeatProblem& problem, Observer& observer)
{
    if (history.law_out_of_range)
        observer.warn("a friction law was used at temperatures outside the range of its lubricant; see the joint "
                      "temperatures in history.csv and extend the viscosity table");
    for (std::size_t i = 0; i < problem.surfaces.size(); ++i)
        if (history.film_out_of_range[i])
            observer.warn(fmt::format("surfaces.{}: its film law was used outside its tested range; 'deadpoint heat' "
                                      "shows where it is",
                                      problem.surfaces[i].name));
    if (history.energy.mismatch() > 1e-6 && !nothing_happens(history, problem.time_tolerance))
        observer.warn(fmt::format("the energy balance closes to {:.1e} only; lower numerics.solver_tolerance",
                                  history.energy.mismatch()));
}

void warn_of_extremes(const casefile::Case& input, const Machine& machine, const RunResult& result, Observer& observer)
{
    constexpr double largest_gap = 1e-3;
    constexpr double hottest = zero_celsius + 250;
    if (result.drift) {
        const auto [low, high] = std::ranges::minmax(result.drift->gap.value);
        if (const double gap = -low > high ? low : high; std::abs(gap) > largest_gap)
            observer.warn(fmt::format("the gap E_SW changes by {:+.3g} mm, but presses drift by less than {:.0f} mm: "
                                      "check the expansion of the materials, the heat ('deadpoint heat' shows it) and "
                                      "the films",
                                      1e3 * gap, 1e3 * largest_gap));
    }
    for (std::size_t p = 0; p < machine.parts.size() && p < result.thermal.part_highest.size(); ++p) {
        const auto& name = machine.parts[p].name;
        const double highest = result.thermal.part_highest[p];
        const auto part = input.parts.find(name);
        const bool started_hot = part != input.parts.end() && part->second.initial_temperature.value_or(0) > hottest;
        if (highest > hottest && !started_hot) {
            observer.warn(fmt::format("part '{}' reaches {:.0f} degC, at which oil burns and bearings seize: check the "
                                      "heat ('deadpoint heat' shows it), the films and the conductances around it",
                                      name, highest - zero_celsius));
            return;  // what heats one part too much heats its neighbours too
        }
    }
}

}  // namespace deadpoint::study
