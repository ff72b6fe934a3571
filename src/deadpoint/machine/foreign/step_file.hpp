#pragma once

#include <string>

namespace deadpoint::machine {

/// What must be known of a STEP file before a library reads it.
struct StepText {
    bool has_unit = false;  ///< it says its unit of length
};

/// Looks at a STEP file: it must begin and end as one, and hold values where values stand. Open CASCADE computes with
/// what it cannot read ("nan"), for ever.
/// @throws IoError if it cannot be read, InputError naming part, file and line
StepText check_step_file(const std::string& part, const std::string& path);

}  // namespace deadpoint::machine
