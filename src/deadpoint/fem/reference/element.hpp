#pragma once

#include "deadpoint/core/vec.hpp"

#include <cstdint>
#include <vector>

namespace deadpoint {
enum class CellKind : std::uint8_t;
}

namespace deadpoint::fem {

/// Lagrange element of first or second degree on the unit cube or the unit tetrahedron (0, x, y, z). Shape function i
/// is 1 at node i and 0 at the others. Nodes: corners, then edges, on the cube also faces and the middle.
class ReferenceElement {
public:
    /// @param degree  1 or 2
    ReferenceElement(CellKind kind, int degree);

    [[nodiscard]] bool is_cube() const { return cube_; }
    [[nodiscard]] int degree() const { return degree_; }
    [[nodiscard]] unsigned size() const { return static_cast<unsigned>(nodes_.size()); }
    [[nodiscard]] const std::vector<Vec3>& nodes() const { return nodes_; }
    /// Shape function i at a point of the reference cell, or beside it.
    [[nodiscard]] double value(unsigned i, const Vec3& unit) const;
    /// Its derivatives by the reference coordinates.
    [[nodiscard]] Vec3 slope(unsigned i, const Vec3& unit) const;

private:
    bool cube_;
    int degree_;
    std::vector<Vec3> nodes_;
};

}  // namespace deadpoint::fem
