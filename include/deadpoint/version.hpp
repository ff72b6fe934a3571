#pragma once

#include <string_view>

namespace deadpoint {

/// Version of the program, as in the project() line of CMakeLists.txt (a unit test compares the two).
inline constexpr std::string_view version = "0.1.0";

}  // namespace deadpoint
