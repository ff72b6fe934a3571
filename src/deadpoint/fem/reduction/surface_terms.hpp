#pragma once

#include "deadpoint/reduce/offline/full_model.hpp"

/// Internal to fem/: terms of joints and films on a basis.
namespace deadpoint::fem {

class Discretisation;
class HeatMatrices;

/// Sets joints and films of the terms, whose geometry, functionals and uniform field are there. Collective.
/// @param basis  a column for each field, this rank's rows
void project_surfaces(const Discretisation& space, const HeatMatrices& matrices, const Eigen::MatrixXd& basis,
                      const reduce::Truncation& truncation, reduce::DenseTerms& terms);

}  // namespace deadpoint::fem
