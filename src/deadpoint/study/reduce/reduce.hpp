#pragma once

#include "deadpoint/reduce/offline/build_options.hpp"
#include "deadpoint/study/reduce/free_coefficients.hpp"
#include "deadpoint/study/reduce/reduced_press.hpp"

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
namespace deadpoint::reduce {
struct ResidualTerms;
}

namespace deadpoint::study {

struct ModelParts;

struct ReduceOptions {
    FreeRanges ranges;
    reduce::BuildOptions build;
    /// Unknowns up to which sparse factors solve for fields, which then take about 5 GB; beyond it multigrid.
    long long largest_factor = 1'000'000;
    int full_runs = 0;        ///< with coefficients drawn from the box, of the full model, to compare with
    std::string fields_file;  ///< where the fields of the small model's states are written; empty: nowhere
    /// Existing folder with what was finished before (reduce/kept/build_checkpoint.hpp); empty: none
    std::string checkpoint;
    const ThermalHistory* run = nullptr;  ///< a full run of the case, which then is not computed again
};

/// A reduced model of a case in two sizes. The large one says how far the small one is off.
struct Reduction {
    ReducedPress small, large;
    std::shared_ptr<const reduce::ResidualTerms>
        residual;  ///< of the large one, if BuildOptions asks for a certificate
};

/// What the section [reduce] of a case asks for.
ReduceOptions reduce_options(const casefile::Case& input);

/// Collective under MPI. Goes on from the checkpoint, and keeps there what it finishes.
/// @return nothing after Observer::cancelled()
/// @throws InputError for what cannot be reduced: materials over temperature, prescribed temperatures, and for a
///         checkpoint of another build; IoError if the checkpoint is broken or the file of fields cannot be written
std::optional<Reduction> reduce_case(ModelParts& parts, const casefile::Case& input, const ReduceOptions& options,
                                     Observer& observer);

/// The build of a case by this program, as its checkpoint states it before the mesh is known.
std::string build_text(const casefile::Case& input);

}  // namespace deadpoint::study
