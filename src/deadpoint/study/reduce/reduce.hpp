#pragma once

#include "deadpoint/reduce/offline/build_options.hpp"
#include "deadpoint/study/reduce/free_coefficients.hpp"
#include "deadpoint/study/reduce/reduced_press.hpp"

#include <string>

namespace deadpoint {
class Observer;
}
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
    int full_runs = 0;        ///< with coefficients drawn from the box, of the full model, to compare with
    std::string fields_file;  ///< where the fields of the small model's states are written; empty: nowhere
};

/// A reduced model of a case in two sizes. The large one says how far the small one is off.
struct Reduction {
    ReducedPress small, large;
    std::shared_ptr<const reduce::ResidualTerms>
        residual;  ///< of the large one, if BuildOptions asks for a certificate
};

/// What the section [reduce] of a case asks for.
ReduceOptions reduce_options(const casefile::Case& input);

/// @throws InputError for what cannot be reduced: materials over temperature, prescribed temperatures; IoError if the
///         file of fields cannot be written
Reduction reduce_case(ModelParts& parts, const casefile::Case& input, const ReduceOptions& options, Observer& observer);

}  // namespace deadpoint::study
