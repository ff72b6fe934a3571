#pragma once

#include "deadpoint/exchange/laws/material.hpp"
#include "deadpoint/fem/space/discretisation.hpp"
#include "deadpoint/fem/space/petsc.hpp"
#include <deal.II/hp/fe_values.h>

#include <vector>

/// Internal to fem/: integration over cells.
namespace deadpoint::fem {

class Discretisation;

/// Calls visit(shape functions with gradients, unknowns, part) for each cell of this rank.
template <class Visitor>
void for_each_cell(const Discretisation& space, const Visitor& visit)
{
    dealii::hp::FEValues<3> values(space.mappings, space.elements, space.quadratures,
                                   dealii::update_values | dealii::update_gradients | dealii::update_JxW_values);
    std::vector<dealii::types::global_dof_index> indices;
    for (const auto& cell : space.dofs.active_cell_iterators()) {
        if (!cell->is_locally_owned())
            continue;
        values.reinit(cell);
        const auto& v = values.get_present_fe_values();
        indices.resize(v.dofs_per_cell);
        cell->get_dof_indices(indices);
        visit(v, indices, static_cast<int>(cell->material_id()));
    }
}

/// Stiffness of a cell, three rows per unknown.
void cell_stiffness(const dealii::FEValues<3>& v, const Material& material, std::vector<double>& block);

/// Adds three values per unknown of a cell.
void add_to_cell(Vec target, const std::vector<dealii::types::global_dof_index>& unknowns,
                 const std::vector<double>& values);
/// Ends a round of add_to_cell.
void finish(Vec target);

}  // namespace deadpoint::fem
