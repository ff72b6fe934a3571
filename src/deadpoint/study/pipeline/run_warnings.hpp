#pragma once

namespace deadpoint {
class Observer;
struct HeatProblem;
struct Machine;
struct ThermalHistory;
}  // namespace deadpoint
namespace deadpoint::casefile {
struct Case;
}

/// Internal to study/: what a finished run must say about its laws and its balance.
namespace deadpoint::study {

struct RunResult;

/// Warns of laws that left their ranges and of an energy balance that does not close.
void warn_about(const ThermalHistory& history, const HeatProblem& problem, Observer& observer);

/// Warns of a gap that changes by more than 1 mm and of parts above 250 degC: no press survives either, so that a value
/// of the case is wrong.
void warn_of_extremes(const casefile::Case& input, const Machine& machine, const RunResult& result, Observer& observer);

}  // namespace deadpoint::study
