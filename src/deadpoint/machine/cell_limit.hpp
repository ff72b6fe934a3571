#pragma once

#include <string>

namespace deadpoint::machine {

/// Of a part: more than any memory here holds.
inline constexpr double most_cells = 2e8;
/// Of a part: from here on meshing takes minutes, and a run hours.
inline constexpr double many_cells = 3e6;

/// About how many cells of `size` [m] a part of `volume` [m3] has: at least so many.
constexpr double about_cells(double volume, double size) { return volume / (size * size * size); }

/// A slip such as "8 um" for "8 mm" must not fill the memory.
/// @throws InputError if it would be more than most_cells
void require_few_cells(const std::string& part, double volume, double size);

}  // namespace deadpoint::machine
