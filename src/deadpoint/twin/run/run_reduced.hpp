#pragma once

#include "deadpoint/core/memo.hpp"
#include "deadpoint/press/loads/loads_cache.hpp"

#include <string>
#include <vector>

namespace deadpoint {
class Observer;
}
namespace deadpoint::casefile {
struct Case;
}
namespace deadpoint::reduce {
struct ResidualTerms;
}
namespace deadpoint::press {
struct RunResult;
struct StatedError;
}  // namespace deadpoint::press

/// Runs of a case on its reduced model.
namespace deadpoint::twin {

struct ReducedPress;
struct ReducedStates;

enum class ReducedDetail {
    all,     ///< as a full run
    figures  ///< for studies: no causes, no vibration of the crankshaft
};

/// What says how far a reduced run is off.
struct LargeModel {
    const ReducedPress* press = nullptr;              ///< for the estimate of the error; null: no estimate
    const reduce::ResidualTerms* residual = nullptr;  ///< its residual, for certified bounds; null: none
};

/// What runs of similar cases on one press share. Any number of threads may use it.
struct SharedParts {
    press::LoadsCache loads;
    Memo<std::string, std::vector<std::string>> misfits{64};  ///< by the bytes of fixed_case()
};

/// @param states  given those at the times of the fields, for lift_fields(), which then also warns of the frame; null:
///                no fields follow
/// @param shared  what runs on this press share; null: all is computed for this run
/// @throws CaseError as a full run; InputError if the model was built for another press; IoError if the model's machine
///         is not that of the case; DomainError if a result is not finite
press::RunResult run_reduced(const casefile::Case& input, const ReducedPress& press, const LargeModel& large,
                             ReducedDetail detail, Observer& observer, ReducedStates* states = nullptr,
                             SharedParts* shared = nullptr);

/// Difference of a finished reduced run to a full run of the same case, after the first minute.
press::StatedError difference_to_full(const press::RunResult& reduced, const press::RunResult& full);

/// How a case differs from the one a model was built for, in what the model cannot change; a line for each difference.
std::vector<std::string> misfits(const casefile::Case& input, const ReducedPress& press);

/// @throws InputError with the first of misfits(), if there are any; IoError if the model's machine is not that of the
///         case
void require_fit(const casefile::Case& input, const ReducedPress& press);

}  // namespace deadpoint::twin
