#pragma once

#include "deadpoint/core/units.hpp"

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace deadpoint::press {
struct FrictionSummary;
}

/// Friction heat at the operating points of a case, law by law, with its parts and the power of the
/// motor.
namespace deadpoint::report {

/// Temperatures at which the heat is stated [K].
constexpr double friction_temperatures[] = {zero_celsius + 20, zero_celsius + 40};

/// For each operating point: table of the friction laws, comparison of rigid and flexible shaft,
/// powers; ends with a line break. Empty without any.
std::string friction_text(const std::vector<press::FrictionSummary>& summaries);

/// The same as a list of objects, one per operating point, for summary.json and heat.json.
nlohmann::ordered_json friction_json(const std::vector<press::FrictionSummary>& summaries);

}  // namespace deadpoint::report
