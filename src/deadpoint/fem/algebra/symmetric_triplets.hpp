#pragma once

#include "deadpoint/fem/algebra/petsc.hpp"

#include <cstddef>
#include <vector>

/// Internal to fem/: the upper half of a symmetric matrix as a list.
namespace deadpoint::fem {

/// Entries of a symmetric matrix on and above its diagonal, each with its row and column, as MUMPS reads them. They
/// take 16 bytes each, two thirds of what both halves take in compressed rows.
class SymmetricTriplets {
public:
    explicit SymmetricTriplets(Mat matrix);

    /// y = A x for several columns at once. @param x, y  this rank's rows of all columns, column by column
    void multiply(PetscInt columns, const double* x, double* y) const;
    /// @param x, y  dense, with the rows of the matrix on each rank
    void multiply(Mat x, Mat y) const;
    void multiply(Vec x, Vec y) const;

    [[nodiscard]] PetscInt size() const { return starts.back(); }
    [[nodiscard]] std::size_t owned() const { return static_cast<std::size_t>(sizes[static_cast<std::size_t>(rank)]); }

    int rank = 0;
    std::vector<int> sizes, starts;  ///< rows of each rank, and the first of them; `starts` ends with the number of all
    std::vector<int> row, column;    ///< of each entry of this rank's rows, counted from 1
    std::vector<double> value;
};

/// Calls use(columns, values of `in`, values of `out`) with this rank's rows of dense matrices or of vectors.
template <class Use>
void with_columns(Mat in, Mat out, const Use& use)
{
    PetscInt columns = 0;
    const double* from = nullptr;
    double* to = nullptr;
    DEADPOINT_PETSC(MatGetSize(in, nullptr, &columns));
    DEADPOINT_PETSC(MatDenseGetArrayRead(in, &from));
    DEADPOINT_PETSC(MatDenseGetArrayWrite(out, &to));
    use(columns, from, to);
    DEADPOINT_PETSC(MatDenseRestoreArrayWrite(out, &to));
    DEADPOINT_PETSC(MatDenseRestoreArrayRead(in, &from));
}

template <class Use>
void with_columns(Vec in, Vec out, const Use& use)
{
    const double* from = nullptr;
    double* to = nullptr;
    DEADPOINT_PETSC(VecGetArrayRead(in, &from));
    DEADPOINT_PETSC(VecGetArrayWrite(out, &to));
    use(1, from, to);
    DEADPOINT_PETSC(VecRestoreArrayWrite(out, &to));
    DEADPOINT_PETSC(VecRestoreArrayRead(in, &from));
}

}  // namespace deadpoint::fem
