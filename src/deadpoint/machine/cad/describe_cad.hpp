#pragma once

#include "deadpoint/machine/cad/cad_model.hpp"
#include "deadpoint/machine/cad/step_solids.hpp"

namespace deadpoint::machine {

/// The solids of Open CASCADE as plain values in metres.
CadModel describe_cad(const StepContents& contents);

}  // namespace deadpoint::machine
