#pragma once

#include "deadpoint/core/observer.hpp"

#include <string>

namespace deadpoint::machine {

/// About how many cells of `size` [m] fill a `volume` [m3]: cubes, or regular tetrahedra with this edge.
constexpr double about_hexahedra(double volume, double size) { return volume / (size * size * size); }
constexpr double about_tetrahedra(double volume, double size) { return 8.485 * about_hexahedra(volume, size); }

/// A slip such as "8 um" for "8 mm" must not fill the memory: refuses what this machine cannot even mesh, and says
/// before the work what will take long.
/// @param cells  about so many
/// @param size   [m], as the part has it
/// @throws InputError if the mesh would be larger than the memory
void check_cell_count(const std::string& part, double cells, double size, Observer& observer);

}  // namespace deadpoint::machine
