#pragma once

#include "deadpoint/reduce/offline/build_options.hpp"
#include "deadpoint/twin/model/reduction.hpp"
#include "deadpoint/twin/run/free_coefficients.hpp"

#include <optional>
#include <string>

namespace deadpoint {
class Observer;
struct ThermalHistory;
}  // namespace deadpoint
namespace deadpoint::casefile {
struct Case;
}

/// Building a reduced model of a case.
namespace deadpoint::full {

struct ModelParts;

struct ReduceOptions {
    twin::FreeRanges ranges;
    reduce::BuildOptions build;
    /// Unknowns up to which sparse factors solve for fields, which then take about 5 GB; beyond it multigrid.
    long long largest_factor = 1'000'000;
    int full_runs = 0;        ///< with coefficients drawn from the box, of the full model, to compare with
    std::string fields_file;  ///< where the fields of the small model's states are written; empty: nowhere
    /// Existing folder with what was finished before (reduce/kept/build_checkpoint.hpp); empty: none
    std::string checkpoint;
    const ThermalHistory* run = nullptr;  ///< a full run of the case, which then is not computed again
};

/// What the section [reduce] of a case asks for.
ReduceOptions reduce_options(const casefile::Case& input);

/// Collective under MPI. Goes on from the checkpoint, and keeps there what it finishes.
/// @return nothing after Observer::cancelled()
/// @throws InputError for what cannot be reduced: materials over temperature, prescribed temperatures, and for a
///         checkpoint of another build; IoError if the checkpoint is broken or the file of fields cannot be written
std::optional<twin::Reduction> reduce_case(ModelParts& parts, const casefile::Case& input, const ReduceOptions& options,
                                           Observer& observer);

/// The build of a case by this program, as its checkpoint states it before the mesh is known.
std::string build_text(const casefile::Case& input);

}  // namespace deadpoint::full
