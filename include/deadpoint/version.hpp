#pragma once

#include <string_view>

namespace deadpoint {

/// Version of these headers, as in the project() line of CMakeLists.txt (a unit test compares the two).
inline constexpr std::string_view version = "0.1.0";

/// Version of the library that is linked: another than `version` where a program meets a library that it was not
/// compiled for. Ends with a zero byte.
std::string_view library_version() noexcept;

}  // namespace deadpoint
