#pragma once

#include "deadpoint/fem/space/discretisation.hpp"

#include <ranges>
#include <vector>

/// Internal to fem/: integration over cells.
namespace deadpoint::fem {

/// Shape functions and weights at the points of a rule in one cell after another.
class CellValues {
public:
    /// @param rules  by element index; outlive this, as the space does
    CellValues(const Discretisation& space, const std::vector<Quadrature>& rules);
    explicit CellValues(const Discretisation& space) : CellValues(space, space.quadratures) {}

    /// Moves on to a cell.
    void reinit(std::uint32_t cell);

    [[nodiscard]] unsigned dofs_per_cell() const { return table_->count; }
    [[nodiscard]] auto dof_indices() const { return std::views::iota(0U, table_->count); }
    [[nodiscard]] auto quadrature_point_indices() const { return std::views::iota(0U, rule_->size()); }
    [[nodiscard]] double shape_value(unsigned i, unsigned q) const { return table_->values[q * table_->count + i]; }
    [[nodiscard]] const Vec3& shape_grad(unsigned i, unsigned q) const { return gradients_[q * table_->count + i]; }
    /// Weight of a point, with the size of the cell [m3].
    [[nodiscard]] double JxW(unsigned q) const { return weights_[q]; }
    [[nodiscard]] Vec3 quadrature_point(unsigned q) const { return space_.maps.position(cell_, unit_point(q)); }
    /// The same in the reference cell.
    [[nodiscard]] const Vec3& unit_point(unsigned q) const { return rule_->points[q]; }

private:
    using Slopes = std::vector<Vec3>;
    /// On the reference cell, by point, then by shape function.
    struct Table {
        unsigned count = 0;  ///< of shape functions
        std::vector<double> values;
        Slopes slopes;
        Slopes straight;  ///< of the functions of first degree
    };

    const Discretisation& space_;
    const std::vector<Quadrature>& rules_;
    std::vector<Table> tables_;  ///< by element index
    const Table* table_ = nullptr;
    const Quadrature* rule_ = nullptr;
    std::uint32_t cell_ = 0;
    std::vector<Vec3> corners_;
    std::vector<double> weights_;
    Slopes gradients_;
};

/// Calls visit(values, unknowns, part) for each cell of this rank.
template <class Visitor>
void for_each_cell(const Discretisation& space, const Visitor& visit)
{
    CellValues values(space);
    std::vector<PetscInt> unknowns;
    for (std::uint32_t cell = space.first_cell; cell < space.end_cell; ++cell) {
        values.reinit(cell);
        space.unknowns_of(cell, unknowns);
        visit(values, unknowns, space.part_of(cell));
    }
}

}  // namespace deadpoint::fem
