#pragma once

#include "deadpoint/fem/space/petsc.hpp"

/// Internal to fem/: many right sides with one sparse factor.
namespace deadpoint::fem {

/// A dense matrix of that many columns, distributed as the rows of `matrix`.
OwnedMat dense_columns(Mat matrix, PetscInt columns);

/// Solves  matrix X = B  for all columns together and refines the solution with the same factor,
///   X + dX,  matrix dX = B - matrix X,
/// until |dX| <= tolerance |X| for each column: what a conjugate gradient method with the factor as its preconditioner
/// asks for. Collective.
/// @return false if that does not happen in three rounds; the solution is then a first guess
bool solve_refined(Mat matrix, Mat factor, Mat right, Mat solution, double tolerance);

}  // namespace deadpoint::fem
