#pragma once

#include <string>

namespace deadpoint {
class Observer;
}
namespace deadpoint::casefile {
struct Case;
}
namespace deadpoint::press {
struct FieldOptions;
struct RunResult;
}  // namespace deadpoint::press
namespace deadpoint::twin {
struct ReducedStates;
}

/// The fields of a run on a reduced model.
namespace deadpoint::full {

struct ModelParts;

/// Lifts the temperature of a run from its states and does with it what a full run does with its own: field files with
/// the deformation, stress and openings, and the page's view. Collective.
/// @param parts   of the mesh on which the model was reduced
/// @param file    of the states' fields (docs/rom-file.md)
/// @param result  of the run; sizes, timings and what follows from fields are added
/// @throws as a full run before its time steps; IoError and InputError as fem::read_fields()
void lift_fields(ModelParts& parts, const casefile::Case& input, const std::string& file,
                 const twin::ReducedStates& run, const press::FieldOptions& options, press::RunResult& result,
                 Observer& observer);

}  // namespace deadpoint::full
