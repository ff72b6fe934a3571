#pragma once

#include "deadpoint/core/vec.hpp"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace deadpoint {

/// Three directions by their names, "x" or "-x" for one of a coordinate system.
/// @return their unit vectors; nothing unless there are three of a right-handed system
std::optional<std::array<Vec3, 3>> named_axes(const std::vector<std::string>& names);

}  // namespace deadpoint
