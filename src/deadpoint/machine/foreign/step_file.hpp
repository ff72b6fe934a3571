#pragma once

#include <string>

namespace deadpoint::machine {

/// Properties of a STEP file that must be known before a library reads it.
struct StepText {
    bool has_unit = false;  ///< it says its unit of length
};

/// Checks a STEP file: it must begin and end correctly, and have values where values are expected.
/// Open CASCADE would compute forever with unreadable values ("nan").
/// @throws IoError if it cannot be read, InputError naming part, file and line
StepText check_step_file(const std::string& part, const std::string& path);

}  // namespace deadpoint::machine
