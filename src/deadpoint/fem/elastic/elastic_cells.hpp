#pragma once

#include "deadpoint/exchange/laws/material.hpp"
#include "deadpoint/fem/algebra/petsc.hpp"
#include "deadpoint/fem/space/cell_values.hpp"

#include <vector>

/// Internal to fem/: integrals of the deformation over cells.
namespace deadpoint::fem {

/// Stiffness of a cell, three rows per unknown.
void cell_stiffness(const CellValues& v, const Material& material, std::vector<double>& block);

/// Adds three values per unknown of a cell.
void add_to_cell(Vec target, const std::vector<PetscInt>& unknowns, const std::vector<double>& values);
/// Ends a round of add_to_cell.
void finish(Vec target);

}  // namespace deadpoint::fem
