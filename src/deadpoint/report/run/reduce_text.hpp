#pragma once

#include <string>

namespace deadpoint::twin {
struct Reduction;
}
namespace deadpoint::press {
struct ReducedResult;
}

/// Reduced models as text for the terminal.
namespace deadpoint::report {

/// Size, free coefficients and errors of a model that was built.
std::string reduce_text(const twin::Reduction& reduction);

/// The error of a run on a reduced model, a line or a few.
std::string reduced_run_text(const press::ReducedResult& reduced);

}  // namespace deadpoint::report
