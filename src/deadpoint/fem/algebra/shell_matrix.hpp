#pragma once

#include "deadpoint/fem/algebra/petsc.hpp"

#include <exception>
#include <functional>

namespace deadpoint {
struct ConvergenceError;
}

/// Internal to fem/: a matrix defined only by its product with a vector.
namespace deadpoint::fem {

/// PETSc calls the product from C frames, through which no exception may pass. If the product
/// throws, the exception is stored, PETSc receives an error code, and use() throws the exception
/// again after PETSc has returned.
class ShellMatrix {
public:
    using Product = std::function<void(Vec in, Vec out)>;

    /// @param rows   on this rank
    /// @param total  rows and columns on all ranks
    ShellMatrix(PetscInt rows, PetscInt total, Product product);
    ShellMatrix(const ShellMatrix&) = delete;

    operator Mat() const { return matrix_; }

    /// Returns what `work` returns, which may multiply with the matrix. @throws what the product threw meanwhile
    template <class Work>
    auto use(const Work& work)
    {
        try {
            return work();
        } catch (const ConvergenceError&) {  // petsc_check() knows the error code only
            throw_kept();
            throw;
        }
    }

private:
    static PetscErrorCode multiply(Mat shell, Vec in, Vec out) noexcept;
    void throw_kept();

    Product product_;
    OwnedMat matrix_;
    std::exception_ptr kept_;
};

}  // namespace deadpoint::fem
