#pragma once

#include "deadpoint/core/vec.hpp"
#include "deadpoint/fem/space/discretisation.hpp"

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

/// Internal to fem/: transfer of fields between two meshes of the same parts.
namespace deadpoint::fem {

struct PointShape;

/// Cell of a point in a mesh.
struct CellPlace {
    std::uint32_t cell = 0;
    Vec3 unit{};                                               ///< in the reference cell, or beside it
    double outside = std::numeric_limits<double>::infinity();  ///< distance from it, 1 being the cell's size
};

/// Finds the cells of one part by place: bins of a regular grid of about one cell each.
class CellFinder {
public:
    CellFinder(const Discretisation& space, std::uint32_t part);

    /// The cell that holds a point; if none does, the nearest one.
    [[nodiscard]] CellPlace find(const Vec3& position) const;

private:
    using Bin = std::array<int, 3>;
    struct Box {
        Vec3 min{}, max{};
    };
    [[nodiscard]] Box box_of(std::uint32_t cell) const;
    [[nodiscard]] Bin bin_of(const Vec3& position) const;
    [[nodiscard]] std::size_t index(const Bin& bin) const;
    template <class Visitor>
    void for_each_bin(const Bin& from, const Bin& to, const Visitor& visit) const;
    void try_bin(std::size_t bin, const Vec3& position, bool only_boxes, CellPlace& best) const;
    [[nodiscard]] CellPlace place_in(std::uint32_t cell, const Vec3& position) const;

    const Discretisation& space_;
    Box box_;
    Vec3 bin_size_{};
    Bin count_{};
    std::vector<std::uint32_t> begin_;  ///< of each bin in cells_
    std::vector<std::uint32_t> cells_;
};

/// Values at the unknowns of a mesh from a field on another mesh of the same parts: the field's own
/// shape functions in the same part, at the unknown's place. If a position lies outside all cells,
/// because of faceted curves, the nearest cell is extrapolated by at most half its size. Linear
/// fields pass exactly.
///
/// Both meshes outlive this. All functions are collective.
class Transfer {
public:
    Transfer(const Discretisation& from, const Discretisation& to);

    /// P f: this rank's values on the new mesh, `block` per unknown.
    [[nodiscard]] std::vector<double> apply(const std::vector<double>& owned, int block) const;
    /// P^T w: weights on the old mesh with w . (P f) = (P^T w) . f.
    [[nodiscard]] std::vector<double> apply_transposed(const std::vector<double>& owned) const;
    /// The old mesh's shape functions at this rank's unknown `row` of the new one.
    void shape(std::size_t row, PointShape& shape) const { from_.evaluate_at(cell_[row], unit_[row], false, shape); }

private:
    void find_places(std::uint32_t part);

    const Discretisation& from_;
    const Discretisation& to_;
    std::vector<std::uint32_t> cell_;  ///< per owned unknown of to_
    std::vector<Vec3> unit_;           ///< the place in that cell
};

}  // namespace deadpoint::fem
