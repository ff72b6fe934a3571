#pragma once

#include "deadpoint/reduce/offline/full_model.hpp"

/// Internal to fem/: terms of joints and films on a basis.
namespace deadpoint::fem {

class BasisFields;
class Discretisation;
class HeatMatrices;

/// Sets joints and films of the terms, whose geometry, functionals and uniform field are there. Ranks take terms in
/// turn. Collective.
/// @param correction  combinations of the fields that are orthonormal
void project_surfaces(const Discretisation& space, const HeatMatrices& matrices, const BasisFields& fields,
                      const Eigen::MatrixXd& correction, const reduce::Truncation& truncation,
                      reduce::DenseTerms& terms);

}  // namespace deadpoint::fem
