#pragma once

#include "deadpoint/press/loads/loads.hpp"

namespace deadpoint {
class Observer;
struct HeatProblem;
struct Machine;
}  // namespace deadpoint
namespace deadpoint::casefile {
struct Case;
}
namespace deadpoint {
class Stopwatch;
}

/// From a case to its heat problem.
namespace deadpoint::press {

class LoadsCache;
struct RunResult;

/// Loads and laws of a case as its heat problem; stores loads and friction in the result. Needs no mesh.
/// @param machine  perhaps without_mesh() @param shared  loads and laws shared with other cases of this machine, or
/// null
/// @throws CaseError, CaseDomainError
HeatProblem run_laws(const casefile::Case& input, const Machine& machine, Vibration vibration, Stopwatch& watch,
                     RunResult& result, Observer& observer, LoadsCache* shared = nullptr);

/// The heat problem alone, without warnings of loads and powers.
/// @throws as run_laws()
HeatProblem heat_with(const casefile::Case& input, const Machine& machine, LoadsCache& shared, Observer& observer);

}  // namespace deadpoint::press
