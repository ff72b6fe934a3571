#pragma once

#include "deadpoint/fem/algebra/petsc.hpp"

#include <span>

/// Internal to fem/: access to PETSc's vectors from C++.
namespace deadpoint::fem {

/// A vector of the same layout, its entries not set.
inline OwnedVec duplicate(Vec vector)
{
    OwnedVec copy;
    DEADPOINT_PETSC(VecDuplicate(vector, copy.out()));
    return copy;
}

/// This rank's entries, to read.
class ConstEntries {
public:
    explicit ConstEntries(Vec vector) : vector_(vector) { DEADPOINT_PETSC(VecGetArrayRead(vector_, &values_)); }
    ~ConstEntries() { VecRestoreArrayRead(vector_, &values_); }
    ConstEntries(const ConstEntries&) = delete;
    [[nodiscard]] const double* data() const { return values_; }
    double operator[](std::size_t i) const { return values_[i]; }
    double operator[](PetscInt i) const { return values_[i]; }

private:
    Vec vector_;
    const double* values_ = nullptr;
};

/// This rank's entries, to change.
class Entries {
public:
    explicit Entries(Vec vector) : vector_(vector) { DEADPOINT_PETSC(VecGetArray(vector_, &values_)); }
    ~Entries() { VecRestoreArray(vector_, &values_); }
    Entries(const Entries&) = delete;
    [[nodiscard]] double* data() { return values_; }
    double& operator[](std::size_t i) { return values_[i]; }
    double& operator[](PetscInt i) { return values_[i]; }

private:
    Vec vector_;
    double* values_ = nullptr;
};

}  // namespace deadpoint::fem
