#include "deadpoint/fem/conduction/multigrid/local_rows.hpp"

namespace deadpoint::fem {
namespace {

bool is_of_type(Mat matrix, MatType type)
{
    PetscBool same = PETSC_FALSE;
    DEADPOINT_PETSC(PetscObjectTypeCompare(reinterpret_cast<PetscObject>(matrix), type, &same));
    return same == PETSC_TRUE;
}

}  // namespace

CompressedRows::CompressedRows(Mat matrix) : matrix_(matrix)
{
    PetscBool done = PETSC_FALSE;
    PetscInt rows = 0;
    DEADPOINT_PETSC(MatGetRowIJ(matrix_, 0, PETSC_FALSE, PETSC_FALSE, &rows, &starts, &columns, &done));
    DEADPOINT_PETSC(MatSeqAIJGetArrayRead(matrix_, &values));
    count = static_cast<std::size_t>(rows);
}

CompressedRows::~CompressedRows()
{
    PetscBool done = PETSC_FALSE;
    PetscInt rows = 0;
    MatSeqAIJRestoreArrayRead(matrix_, &values);
    MatRestoreRowIJ(matrix_, 0, PETSC_FALSE, PETSC_FALSE, &rows, &starts, &columns, &done);
}

LocalRows::LocalRows(Mat matrix) : own(matrix)
{
    if (!is_of_type(matrix, MATMPIAIJ))
        return;
    const PetscInt* numbers = nullptr;
    PetscInt count = 0;
    DEADPOINT_PETSC(MatMPIAIJGetSeqAIJ(matrix, &own, &other, &numbers));
    DEADPOINT_PETSC(MatGetSize(other, nullptr, &count));
    ghosts = {numbers, static_cast<std::size_t>(count)};
}

bool is_assembled(Mat matrix) { return is_of_type(matrix, MATSEQAIJ) || is_of_type(matrix, MATMPIAIJ); }

}  // namespace deadpoint::fem
