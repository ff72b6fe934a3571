#pragma once

#include "deadpoint/study/translate_friction.hpp"

#include <string>

/// Friction heat of a run, row by row, and where it comes from.
namespace deadpoint::report {

/// Temperatures at which the heat is told [K].
constexpr double friction_temperatures[] = {293.15, 313.15};

/// Table of the rows, contrast of rigid and flexible shaft, balance of powers; ends with a line break.
std::string friction_text(const study::FrictionSummary& summary);

/// The same as a JSON text (an object), for summary.json.
std::string friction_json(const study::FrictionSummary& summary);

}  // namespace deadpoint::report
