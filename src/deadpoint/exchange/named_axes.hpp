#pragma once

#include "deadpoint/core/vec.hpp"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace deadpoint {

/// A direction by its name, "x" or "-x"; nothing where that is none.
std::optional<Vec3> named_axis(const std::string& name);

/// The name of a unit vector along an axis, "-x"; of another direction its components, "(0.60, -0.80, 0.00)".
std::string axis_name(const Vec3& direction);

/// Where a direction leads to, "x < 0"; of one that is along no axis "towards (0.60, -0.80, 0.00)".
std::string side_name(const Vec3& direction);

/// Three directions by their names, "x" or "-x" for one of a coordinate system.
/// @return their unit vectors; nothing unless there are three of a right-handed system
std::optional<std::array<Vec3, 3>> named_axes(const std::vector<std::string>& names);

}  // namespace deadpoint
