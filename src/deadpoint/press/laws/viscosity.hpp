#pragma once

#include "deadpoint/tribology/friction/lubricant.hpp"

#include <string>

namespace deadpoint::casefile {
struct Case;
}

namespace deadpoint::press {

/// Kinematic viscosity of a lubricant of the case over temperature [m2/s], by its table, Walther line or Vogel formula;
/// flagged beyond the table, or outside -20 to 150 degC.
/// @throws InputError naming the lubricant, as the laws; the law throws DomainError naming it
tribology::ViscosityLaw viscosity_law(const casefile::Case& input, const std::string& lubricant);

}  // namespace deadpoint::press
