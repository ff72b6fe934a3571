#pragma once

namespace deadpoint {
class Observer;
struct HeatProblem;
struct Machine;
}  // namespace deadpoint
namespace deadpoint::casefile {
struct Case;
}

/// What every run must say before its steps and at its end, full or reduced.
namespace deadpoint::press {

struct ChainFigures;
struct RunResult;

/// Warns of what can be computed but is hardly meant, as far as loads and friction heat tell (question_loads()).
void warn_of_loads(const casefile::Case& input, const Machine& machine, const RunResult& result, Observer& observer);

/// Warns of what a finished run shows: clearances that are used up and a play that is not stated, laws beyond their
/// ranges, an energy balance that does not close, a gap that changes by more than 1 mm and parts above 250 degC, which
/// no press survives, and tables of materials that end.
/// @param chain  of the drift, if there is one
/// @throws DomainError that names the first result that is not a finite number
void finish_run(const casefile::Case& input, const Machine& machine, const HeatProblem& problem,
                const ChainFigures* chain, const RunResult& result, Observer& observer);

}  // namespace deadpoint::press
