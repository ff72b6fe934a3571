#pragma once

#include <string>
#include <string_view>

namespace deadpoint {

/// A name for something that must not meet what others make at the same time: `prefix` and eight random letters and
/// digits. Whoever makes it still asks the system to make it new.
std::string unique_name(std::string prefix);

/// Whether it is a name that unique_name() gives for this prefix.
bool is_unique_name(std::string_view name, std::string_view prefix);

}  // namespace deadpoint
