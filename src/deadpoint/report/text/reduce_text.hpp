#pragma once

#include <string>

namespace deadpoint::study {
struct Reduction;
struct ReducedResult;
}  // namespace deadpoint::study

/// Reduced models as text for the terminal.
namespace deadpoint::report {

/// Size, free coefficients and errors of a model that was built.
std::string reduce_text(const study::Reduction& reduction);

/// The error of a run on a reduced model, a line or a few.
std::string reduced_run_text(const study::ReducedResult& reduced);

}  // namespace deadpoint::report
