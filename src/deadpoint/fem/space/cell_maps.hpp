#pragma once

#include "deadpoint/core/vec.hpp"
#include "deadpoint/fem/reference/element.hpp"
#include "deadpoint/fem/reference/matrix3.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace deadpoint {
struct Machine;
}

/// Internal to fem/: maps of cells from their reference cell, the unit cube or the unit tetrahedron, to their place.
namespace deadpoint::fem {

/// Maps of first degree by the corners. Cells of second order with round edges (exchange/round_edges) have maps of
/// second degree; their elements are isoparametric.
class CellMaps {
public:
    /// @param orders    of the elements, 1 or 2, per part
    /// @param elements  see element_index()
    CellMaps(const Machine& machine, const std::vector<int>& orders, const std::vector<ReferenceElement>& elements);

    /// Index of a cell's element in the lists of elements and rules.
    [[nodiscard]] unsigned element_index(std::uint32_t cell) const;
    /// True if some of its edges are round, and its element can follow them.
    [[nodiscard]] bool is_round(std::uint32_t cell) const { return !round_.empty() && round_[cell]; }

    [[nodiscard]] Vec3 position(std::uint32_t cell, const Vec3& unit) const;
    /// Points whose weighted slopes are the map's derivatives: corners, or where the cell is round all nodes of its
    /// element.
    void corners(std::uint32_t cell, std::vector<Vec3>& corners) const;
    /// d position_i / d unit_j.
    [[nodiscard]] Matrix3 jacobian(std::uint32_t cell, const Vec3& unit) const;
    /// The point of the reference cell, or beside it, at a position; false where a distorted cell does not reach so
    /// far.
    bool unit_position(std::uint32_t cell, const Vec3& position, Vec3& unit) const;
    /// The point itself where it lies in the cell's reference cell, else one near it that does.
    [[nodiscard]] Vec3 nearest_inside(std::uint32_t cell, const Vec3& unit) const;

    /// Mean of the corners.
    [[nodiscard]] Vec3 centre(std::uint32_t cell) const;
    /// Longest distance of two corners [m].
    [[nodiscard]] double diameter(std::uint32_t cell) const;
    /// With straight edges [m3].
    [[nodiscard]] double volume(std::uint32_t cell) const;

private:
    [[nodiscard]] bool is_hexahedron(std::uint32_t cell) const;
    [[nodiscard]] const ReferenceElement& of_first_degree(std::uint32_t cell) const
    {
        return elements_[element_index(cell) % 2];
    }
    [[nodiscard]] Vec3 corner(std::uint32_t cell, unsigned corner) const;
    [[nodiscard]] Matrix3 straight_jacobian(std::uint32_t cell, const Vec3& unit) const;

    const Machine& machine_;
    const std::vector<int>& orders_;
    const std::vector<ReferenceElement>& elements_;
    std::vector<bool> round_;  ///< per cell; empty: none
};

/// Lagrange elements by order and kind of cell; see CellMaps::element_index().
std::vector<ReferenceElement> lagrange_elements();

}  // namespace deadpoint::fem
