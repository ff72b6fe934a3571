#pragma once

#include "deadpoint/error.hpp"

#include <petscksp.h>
#include <string>
#include <utility>

/// Internal to fem/: PETSc objects that free themselves, and its error codes as exceptions.
namespace deadpoint::fem {

inline void petsc_check(PetscErrorCode code, const char* call)
{
    if (code != 0)
        throw ConvergenceError(std::string("the linear algebra library failed in ") + call + " (PETSc error " +
                               std::to_string(code) + "); the message above says why, most often memory");
}
#define DEADPOINT_PETSC(call) ::deadpoint::fem::petsc_check((call), #call)

template <class Handle, PetscErrorCode (*destroy)(Handle*)>
class Owned {
public:
    Owned() = default;
    ~Owned() { reset(); }
    Owned(Owned&& other) noexcept : handle_(std::exchange(other.handle_, nullptr)) {}
    Owned& operator=(Owned&& other) noexcept
    {
        std::swap(handle_, other.handle_);
        return *this;
    }
    void reset()
    {
        if (handle_)
            destroy(&handle_);
        handle_ = nullptr;
    }
    operator Handle() const { return handle_; }
    Handle* out()
    {
        reset();
        return &handle_;
    }
    explicit operator bool() const { return handle_ != nullptr; }

private:
    Handle handle_ = nullptr;
};

using OwnedMat = Owned<Mat, MatDestroy>;
using OwnedVec = Owned<Vec, VecDestroy>;
using OwnedKsp = Owned<KSP, KSPDestroy>;
using OwnedPc = Owned<PC, PCDestroy>;
using OwnedScatter = Owned<VecScatter, VecScatterDestroy>;
using OwnedNullSpace = Owned<MatNullSpace, MatNullSpaceDestroy>;

/// The matrix of the solver's equations, which it keeps.
inline Mat matrix_of(KSP solver)
{
    Mat matrix = nullptr;
    DEADPOINT_PETSC(KSPGetOperators(solver, nullptr, &matrix));
    return matrix;
}

/// Solves, checks that it converged, and returns the number of iterations.
/// @throws ConvergenceError with the reason; NotFinite if a value is not finite
int solve(KSP solver, Vec rhs, Vec solution, const char* what);

}  // namespace deadpoint::fem
