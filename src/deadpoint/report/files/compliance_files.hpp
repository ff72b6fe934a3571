#pragma once

#include "deadpoint/report/folder/json_file.hpp"

#include <string>

namespace deadpoint::casefile {
struct Case;
}
namespace deadpoint::study {
struct PressCompliance;
}

/// The static opening under the process force, in the files and the text of a run.
namespace deadpoint::report {

/// Per kilonewton, and at the force of each segment of the operation that states one.
nlohmann::ordered_json compliance_json(const casefile::Case& input, const study::PressCompliance& compliance);

/// Two lines: stiffness and tilt per kilonewton, and the opening at the operation's largest force.
std::string compliance_text(const casefile::Case& input, const study::PressCompliance& compliance);

}  // namespace deadpoint::report
