#include "deadpoint/fem/algebra/shell_matrix.hpp"

namespace deadpoint::fem {

ShellMatrix::ShellMatrix(PetscInt rows, PetscInt total, Product product) : product_(std::move(product))
{
    DEADPOINT_PETSC(MatCreateShell(PETSC_COMM_WORLD, rows, rows, total, total, this, matrix_.out()));
    DEADPOINT_PETSC(
        MatShellSetOperation(matrix_, MATOP_MULT, reinterpret_cast<void (*)(void)>(&ShellMatrix::multiply)));
}

PetscErrorCode ShellMatrix::multiply(Mat shell, Vec in, Vec out) noexcept
{
    ShellMatrix* self = nullptr;
    if (const PetscErrorCode code = MatShellGetContext(shell, &self); code != 0)
        return code;
    try {
        self->product_(in, out);
        return 0;
    } catch (...) {
        self->kept_ = std::current_exception();
        PetscPushErrorHandler(PetscIgnoreErrorHandler, nullptr);  // otherwise PETSc prints each frame while it returns
        return PETSC_ERR_USER;
    }
}

void ShellMatrix::throw_kept()
{
    if (!kept_)
        return;
    PetscPopErrorHandler();
    std::rethrow_exception(std::exchange(kept_, nullptr));
}

}  // namespace deadpoint::fem
