#pragma once

#include <string>
#include <string_view>

namespace deadpoint {

/// A name that differs from names that other processes choose at the same time: `prefix` and eight
/// random letters and digits. The caller must still create the file or folder exclusively.
std::string unique_name(std::string prefix);

/// True if it is a name that unique_name() gives for this prefix.
bool is_unique_name(std::string_view name, std::string_view prefix);

}  // namespace deadpoint
