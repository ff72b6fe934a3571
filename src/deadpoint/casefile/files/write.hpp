#pragma once

#include <string>

namespace deadpoint::casefile {

struct Case;

/// The case as one TOML text: includes merged, library values filled in, defaults stated, everything with its unit.
/// Reading it back gives the same case bit by bit.
std::string write_case(const Case& c);

/// Hash of the resolved case, 16 hexadecimal digits: equal for equal cases in any notation. It
/// includes the paths of STEP and mesh files, not their contents.
std::string case_hash(const Case& c);

}  // namespace deadpoint::casefile
