#pragma once

#include "deadpoint/exchange/heat.hpp"
#include "deadpoint/heat/balance.hpp"
#include "deadpoint/heat/enclosed_air.hpp"
#include "deadpoint/heat/stage_solver.hpp"

#include <string>
#include <tuple>
#include <vector>

/// State of a run between two steps, without its vectors. With both, the run continues bit by bit.
namespace deadpoint {

constexpr auto members(const Series*) { return std::tuple{&Series::value, &Series::rate}; }
constexpr auto members(const OilHistory*)
{
    return std::tuple{&OilHistory::inlet, &OilHistory::outlet, &OilHistory::sump, &OilHistory::heat,
                      &OilHistory::cooler};
}
constexpr auto members(const EnclosureHistory*)
{
    return std::tuple{&EnclosureHistory::temperature, &EnclosureHistory::from_surfaces, &EnclosureHistory::power,
                      &EnclosureHistory::to_room};
}
constexpr auto members(const EnergyBalance*)
{
    return std::tuple{&EnergyBalance::generated, &EnergyBalance::to_air, &EnergyBalance::to_oil,
                      &EnergyBalance::from_surfaces, &EnergyBalance::stored};
}
constexpr auto members(const ThermalHistory*)
{
    using History = ThermalHistory;
    return std::tuple{&History::time,
                      &History::probes,
                      &History::interface_a,
                      &History::interface_b,
                      &History::part_means,
                      &History::functionals,
                      &History::source_heat,
                      &History::source_temperature,
                      &History::to_air,
                      &History::to_oil,
                      &History::body_heat,
                      &History::oil,
                      &History::enclosures,
                      &History::contributions,
                      &History::energy,
                      &History::rejected_steps,
                      &History::law_out_of_range,
                      &History::film_out_of_range,
                      &History::part_lowest,
                      &History::part_highest};
}

namespace heat {

/// Where a run stands between two steps.
struct RunPlace {
    std::size_t segment = 0;
    double segment_start = 0;     ///< [s]
    std::size_t segment_row = 0;  ///< of the history
    double time = 0;              ///< [s]
    double wanted = 0;            ///< length of the next step [s]
    std::size_t next_field = 0;   ///< index into HeatProblem::field_times
};
constexpr auto members(const RunPlace*)
{
    return std::tuple{&RunPlace::segment, &RunPlace::segment_start, &RunPlace::segment_row,
                      &RunPlace::time,    &RunPlace::wanted,        &RunPlace::next_field};
}

/// Between two steps, the vectors apart.
struct RunState {
    RunPlace place;
    bool slope_known = false;
    double previous_step = 0;  ///< [s]
    int iterations = 0;        ///< of linear solves
    int solves = 0;
    std::vector<double> sumps;            ///< [K]
    std::vector<double> oil_temperature;  ///< where the oil reaches each interface [K]
    std::vector<AirState> air;
    PreconditionerOrigin origin;
    HeatBalance balance;  ///< at the last step's end
    ThermalHistory history;
    std::vector<StepRecord> steps;
};
constexpr auto members(const RunState*)
{
    return std::tuple{&RunState::place,  &RunState::slope_known, &RunState::previous_step,   &RunState::iterations,
                      &RunState::solves, &RunState::sumps,       &RunState::oil_temperature, &RunState::air,
                      &RunState::origin, &RunState::balance,     &RunState::history,         &RunState::steps};
}

/// Reason why a state that was read does not belong to a problem; empty if it does. With a state
/// that fits, the time steps always end.
/// @param like  a state of the problem's run before its first step
std::string misfit(const RunState& read, const RunState& like, const HeatProblem& problem);

}  // namespace heat
}  // namespace deadpoint
