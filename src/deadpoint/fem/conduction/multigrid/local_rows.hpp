#pragma once

#include "deadpoint/fem/algebra/petsc.hpp"

#include <cstddef>
#include <span>

/// Internal to fem/: what a matrix of PETSc keeps on this rank.
namespace deadpoint::fem {

/// The compressed rows of a sequential matrix, to read.
class CompressedRows {
public:
    explicit CompressedRows(Mat matrix);
    ~CompressedRows();
    CompressedRows(const CompressedRows&) = delete;

    std::size_t count = 0;
    const PetscInt* starts = nullptr;  ///< of each row, and the end
    const PetscInt* columns = nullptr;
    const PetscScalar* values = nullptr;

private:
    Mat matrix_;
};

/// The two parts of this rank's rows (AIJ, on one rank or many): its own columns, and the ghosts, columns that other
/// ranks own.
struct LocalRows {
    explicit LocalRows(Mat matrix);
    Mat own = nullptr;
    Mat other = nullptr;               ///< null on one rank
    std::span<const PetscInt> ghosts;  ///< global numbers of the columns of `other`, sorted
};

/// True if LocalRows can be made of it.
bool is_assembled(Mat matrix);

}  // namespace deadpoint::fem
