#include "deadpoint/press/run/run_warnings.hpp"

#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/casefile/describe/findings.hpp"
#include "deadpoint/casefile/files/case_source.hpp"
#include "deadpoint/core/units.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/exchange/drift.hpp"
#include "deadpoint/exchange/heat.hpp"
#include "deadpoint/exchange/machine.hpp"
#include "deadpoint/observer.hpp"
#include "deadpoint/press/check/plausibility.hpp"
#include "deadpoint/press/drift/chain_figures.hpp"
#include "deadpoint/press/drift/crank_play.hpp"
#include "deadpoint/press/drift/gap_model.hpp"
#include "deadpoint/press/result/run_result.hpp"
#include "deadpoint/press/translate/materials.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <string>
#include <vector>

namespace deadpoint::press {
namespace {

/// Refuses results that are not finite, by their names.
class FiniteCheck {
public:
    explicit FiniteCheck(const std::vector<double>& time) : time_(time) {}
    void operator()(const std::string& what, const std::vector<double>& values) const
    {
        for (std::size_t k = 0; k < values.size(); ++k)
            if (!std::isfinite(values[k]))
                refuse(what, k < time_.size() ? fmt::format(" at t = {:.6g} s", time_[k]) : "");
    }
    void operator()(const std::string& what, const Series& series) const { (*this)(what, series.value); }
    void operator()(const std::string& what, double value) const
    {
        if (!std::isfinite(value))
            refuse(what, "");
    }

private:
    [[noreturn]] static void refuse(const std::string& what, const std::string& when)
    {
        throw DomainError(fmt::format("{} is not a finite number{}\n  help: some value of the case is too large or too "
                                      "small to compute with; 'deadpoint heat' shows heat, conductances and films",
                                      what, when));
    }
    const std::vector<double>& time_;
};

void require_finite_heat(const RunResult& result, const FiniteCheck& check)
{
    for (const auto& [name, probe] : result.probes)
        check("the temperature of probe '" + name + "'", probe);
    for (const auto& [name, sides] : result.interfaces) {
        check("the temperature of '" + name + "'", sides.a);
        check("the temperature of '" + name + "'", sides.b);
    }
    for (const auto& [name, part] : result.parts)
        check("the temperature of part '" + name + "'", part.mean);
    for (const auto& [name, joint] : result.joints)
        check("the heat of joint '" + name + "'", joint.heat);
    for (const auto& [name, circuit] : result.oil) {
        check("the temperature of oil '" + name + "'", circuit.outlet);
        check("the heat of oil '" + name + "'", circuit.heat);
    }
    for (const auto& [name, air] : result.enclosures)
        check("the temperature of the air in '" + name + "'", air.temperature);
    check("the energy balance", result.thermal.energy.stored);
}

void require_finite_drift(const RunResult& result, const FiniteCheck& check)
{
    if (result.drift) {
        check("E_SW", result.drift->gap);
        check("E_CS", result.drift->crank_to_slide);
        check("E_BG", result.drift->bearing_to_ground);
        check("E_WG", result.drift->table_to_ground);
        for (const auto& part : result.drift->by_part)
            check("the share of a part in E_SW", part);
    }
    for (const auto& causes : result.causes)
        for (const auto& [name, share] : causes.joints)
            check("the share of '" + name + "' in E_SW", share);
    if (result.gaps.parallelism) {
        check("the tilt of the slide from left to right", result.gaps.parallelism->left_right);
        check("the tilt of the slide from front to back", result.gaps.parallelism->front_back);
    }
    for (const auto& clearance : result.gaps.clearances)
        check("the clearance of '" + clearance.name + "'", clearance.change);
    if (result.gaps.force)
        check("the force at a fixed die height", *result.gaps.force);
}

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

}  // namespace

void warn_of_loads(const casefile::Case& input, const Machine& machine, const RunResult& result, Observer& observer)
{
    for (const auto& warning : casefile::placed_warnings(input, question_loads(input, machine, result)))
        observer.warn(warning);
}

void finish_run(const casefile::Case& input, const Machine& machine, const HeatProblem& problem,
                const ChainFigures* chain, const RunResult& result, Observer& observer)
{
    const FiniteCheck check(result.thermal.time);
    require_finite_heat(result, check);
    require_finite_drift(result, check);
    if (chain)
        if (const auto warning = play_warning(input, *chain, result.thermal))
            observer.warn(*warning);
    for (const auto& warning : gap_warnings(result.gaps))
        observer.warn(warning);
    warn_about(result.thermal, problem, observer);
    warn_of_extremes(input, machine, result, observer);
    for (const auto& warning : material_warnings(input, machine, result.thermal))
        observer.warn(warning);
}

}  // namespace deadpoint::press
