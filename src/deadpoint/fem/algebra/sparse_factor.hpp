#pragma once

#include "deadpoint/fem/algebra/symmetric_triplets.hpp"

#include <memory>

/// Internal to fem/: a sparse factor of a matrix that is distributed by rows.
namespace deadpoint::fem {

/// L D L^T = A of a symmetric positive definite matrix (MUMPS), in an order of nested dissection (METIS).
///
/// MUMPS is called without PETSc, which hands it no order, and no matrix without copies. METIS' order of a press takes
/// a tenth fewer entries and a quarter fewer operations than MUMPS' own.
class SparseFactor {
public:
    /// @param pattern  its values do not matter
    /// @param block  unknowns of a node, which stay together: rows and columns come in groups of so many
    SparseFactor(const SymmetricTriplets& pattern, int block);
    ~SparseFactor();
    SparseFactor(const SparseFactor&) = delete;
    SparseFactor& operator=(const SparseFactor&) = delete;

    /// Factorises a matrix of the pattern given first, which is not read later.
    /// @throws ConvergenceError if the matrix is singular or memory is short
    void factorise(const SymmetricTriplets& matrix);
    /// solution = A^-1 right, for all columns together, which takes far less time each.
    /// @param right, solution  dense, with the rows of the matrix on each rank
    void solve(Mat right, Mat solution);
    void solve(Vec right, Vec solution);

private:
    struct Mumps;

    void call(int job);
    /// @param right, solution  this rank's rows of all columns, column by column
    void solve(PetscInt columns, const double* right, double* solution);

    std::unique_ptr<Mumps> mumps_;
};

}  // namespace deadpoint::fem
