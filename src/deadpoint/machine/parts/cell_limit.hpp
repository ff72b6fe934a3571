#pragma once

#include <string>

namespace deadpoint {
class Observer;
}

namespace deadpoint::machine {

/// About how many cells of `size` [m] fill a `volume` [m3]: cubes, or regular tetrahedra with this edge.
constexpr double about_hexahedra(double volume, double size) { return volume / (size * size * size); }
constexpr double about_tetrahedra(double volume, double size) { return 8.485 * about_hexahedra(volume, size); }

/// Refuses a mesh that this machine cannot hold, so that a slip such as "8 um" for "8 mm" does not
/// fill the memory, and warns before a mesh that takes long. @param cells approximate number
/// @param size   [m], as the part has it
/// @throws InputError if the mesh would be larger than the memory
void check_cell_count(const std::string& part, double cells, double size, Observer& observer);

}  // namespace deadpoint::machine
