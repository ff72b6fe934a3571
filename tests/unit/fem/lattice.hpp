#pragma once

#include "deadpoint/fem/algebra/petsc.hpp"
#include "deadpoint/fem/algebra/vectors.hpp"

#include <array>
#include <cmath>
#include <petscksp.h>
#include <vector>

/// A cube of unknowns with the mass and conduction of a block of metal.
namespace lattice {

using deadpoint::fem::Entries;
using deadpoint::fem::OwnedMat;
using deadpoint::fem::OwnedPc;
using deadpoint::fem::OwnedVec;

inline constexpr PetscInt side = 24;

// On a cube of side^3 unknowns: `own` on the diagonal besides, and `neighbour` between neighbours.
inline OwnedMat matrix_of(double own, double per_neighbour, double neighbour)
{
    OwnedMat matrix;
    const PetscInt count = side * side * side;
    DEADPOINT_PETSC(MatCreateSeqAIJ(PETSC_COMM_SELF, count, count, 7, nullptr, matrix.out()));
    for (PetscInt row = 0; row < count; ++row) {
        double diagonal = own;
        const std::array<PetscInt, 3> place{row % side, row / side % side, row / side / side},
            step{1, side, side * side};
        for (std::size_t axis = 0; axis < 3; ++axis)
            for (const PetscInt way : {-1, 1}) {
                if (place[axis] + way < 0 || place[axis] + way >= side)
                    continue;
                DEADPOINT_PETSC(MatSetValue(matrix, row, row + way * step[axis], neighbour, INSERT_VALUES));
                diagonal += per_neighbour;
            }
        DEADPOINT_PETSC(MatSetValue(matrix, row, row, diagonal, INSERT_VALUES));
    }
    DEADPOINT_PETSC(MatAssemblyBegin(matrix, MAT_FINAL_ASSEMBLY));
    DEADPOINT_PETSC(MatAssemblyEnd(matrix, MAT_FINAL_ASSEMBLY));
    return matrix;
}

/// The kinds of hierarchy that this PETSc has, the one of runs first.
inline std::vector<PCType> hierarchies()
{
#ifdef PETSC_HAVE_ML
    return {PCML, PCGAMG};
#else
    return {PCGAMG};
#endif
}

/// M + d K of a block of metal, and a multigrid for it that keeps its interpolation.
struct Hierarchy {
    OwnedMat mass = matrix_of(0.5, 1.0 / 12, 1.0 / 12), conduction = matrix_of(0.01, 1, -1), system;
    OwnedPc multigrid;

    explicit Hierarchy(PCType type = hierarchies().front())
    {
        DEADPOINT_PETSC(MatDuplicate(mass, MAT_COPY_VALUES, system.out()));
        DEADPOINT_PETSC(PetscOptionsSetValue(nullptr, "-lattice_pc_ml_reuse_interpolation", "true"));
        DEADPOINT_PETSC(PetscOptionsSetValue(nullptr, "-lattice_pc_ml_maxCoarseSize", "50"));
        DEADPOINT_PETSC(PetscOptionsSetValue(nullptr, "-lattice_pc_gamg_reuse_interpolation", "true"));
        DEADPOINT_PETSC(PetscOptionsSetValue(nullptr, "-lattice_pc_gamg_threshold", "0.01"));
        DEADPOINT_PETSC(PCCreate(PETSC_COMM_SELF, multigrid.out()));
        DEADPOINT_PETSC(PCSetOperators(multigrid, system, system));
        DEADPOINT_PETSC(PCSetType(multigrid, type));
        DEADPOINT_PETSC(PCSetOptionsPrefix(multigrid, "lattice_"));
        DEADPOINT_PETSC(PCSetFromOptions(multigrid));
    }
    void fill(double factor)
    {
        DEADPOINT_PETSC(MatCopy(mass, system, SAME_NONZERO_PATTERN));
        DEADPOINT_PETSC(MatAXPY(system, factor, conduction, SAME_NONZERO_PATTERN));
    }
};

/// A load that no symmetry of the lattice repeats.
inline OwnedVec some_load(Mat matrix, double scale)
{
    OwnedVec load;
    DEADPOINT_PETSC(MatCreateVecs(matrix, nullptr, load.out()));
    Entries entries(load);
    for (PetscInt i = 0; i < side * side * side; ++i)
        entries[i] = scale * std::sin(1.0 + i * i % 1013);
    return load;
}

}  // namespace lattice
