#pragma once

#include "deadpoint/core/vec.hpp"

#include <array>
#include <cstdint>
#include <span>

namespace deadpoint {
struct VtuGrid;
}

/// A place in the cells of a field file, and the value of a field there.
namespace deadpoint::press {

/// Shares of the corners of a cell in the value at a place.
struct FieldPlace {
    double outside = 0;    ///< distance from the nearest cell [m]; infinite if the part has no cell here
    double cell_size = 0;  ///< largest extent of that cell along an axis [m]
    Vec3 nearest{};        ///< the place itself, or the nearest one in a cell [m]
    std::array<std::uint32_t, 8> nodes{};
    std::array<double, 8> weights{};  ///< sum 1; 0 beyond the corners of the cell
};

/// Finds a place in the cells of one part.
///
/// Between the corners of a cell, values are linear (tetrahedra) or trilinear (hexahedra), as in elements of first
/// order. A hexahedron's local coordinates follow by Newton's method.
///
/// @param parts  number of the part of each cell
FieldPlace find_place(const VtuGrid& grid, std::span<const std::int32_t> parts, std::int32_t part,
                      const Vec3& position);

}  // namespace deadpoint::press
