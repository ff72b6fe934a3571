#include "deadpoint/fem/conduction/coarse_matrices.hpp"

#include <array>
#include <doctest/doctest.h>

using namespace deadpoint::fem;

namespace {

constexpr PetscInt side = 24;

// On a cube of side^3 unknowns: `own` on the diagonal besides, and `neighbour` between neighbours.
OwnedMat lattice(double own, double per_neighbour, double neighbour)
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

/// M + d K of a block of metal, and a multigrid for it that keeps its interpolation.
struct Hierarchy {
    OwnedMat mass = lattice(0.5, 1.0 / 12, 1.0 / 12), conduction = lattice(0.01, 1, -1), system;
    OwnedKsp solver;
    PC multigrid = nullptr;

    Hierarchy()
    {
        DEADPOINT_PETSC(MatDuplicate(mass, MAT_COPY_VALUES, system.out()));
        DEADPOINT_PETSC(PetscOptionsSetValue(nullptr, "-lattice_pc_ml_reuse_interpolation", "true"));
        DEADPOINT_PETSC(PetscOptionsSetValue(nullptr, "-lattice_pc_ml_maxCoarseSize", "50"));
        DEADPOINT_PETSC(KSPCreate(PETSC_COMM_SELF, solver.out()));
        DEADPOINT_PETSC(KSPSetOptionsPrefix(solver, "lattice_"));
        DEADPOINT_PETSC(KSPSetType(solver, KSPCG));
        DEADPOINT_PETSC(KSPGetPC(solver, &multigrid));
        DEADPOINT_PETSC(PCSetType(multigrid, PCML));
        DEADPOINT_PETSC(KSPSetFromOptions(solver));
        DEADPOINT_PETSC(KSPSetOperators(solver, system, system));
    }
    void fill(double factor)
    {
        DEADPOINT_PETSC(MatCopy(mass, system, SAME_NONZERO_PATTERN));
        DEADPOINT_PETSC(MatAXPY(system, factor, conduction, SAME_NONZERO_PATTERN));
    }
};

double norm(Mat matrix)
{
    double value = 0;
    DEADPOINT_PETSC(MatNorm(matrix, NORM_FROBENIUS, &value));
    return value;
}

}  // namespace

TEST_CASE("coarse matrices of two step sizes give those of any other")
{
    Hierarchy grid;
    CoarseMatrices coarse;
    for (const double factor : {50.0, 0.05}) {
        CHECK_FALSE(coarse.complete());
        grid.fill(factor);
        DEADPOINT_PETSC(PCSetUp(grid.multigrid));
        coarse.keep(grid.multigrid, factor);
    }
    REQUIRE(coarse.complete());
    PetscInt levels = 0;
    Mat* interpolations = nullptr;
    DEADPOINT_PETSC(PCGetInterpolations(grid.multigrid, &levels, &interpolations));
    REQUIRE(levels >= 3);
    // Between, outside, and as they were.
    for (const double factor : {3.0, 400.0, 0.001, 50.0}) {
        CAPTURE(factor);
        grid.fill(factor);
        coarse.follow(grid.multigrid, factor);
        OwnedMat expected;
        Mat finer = grid.system;
        for (PetscInt level = levels - 1; level > 0; --level) {
            OwnedMat product;
            DEADPOINT_PETSC(
                MatPtAP(finer, interpolations[level - 1], MAT_INITIAL_MATRIX, PETSC_DEFAULT, product.out()));
            expected = std::move(product);
            finer = expected;
            KSP solver = nullptr;
            DEADPOINT_PETSC(level == 1 ? PCMGGetCoarseSolve(grid.multigrid, &solver)
                                       : PCMGGetSmoother(grid.multigrid, level - 1, &solver));
            Mat got = nullptr;
            DEADPOINT_PETSC(KSPGetOperators(solver, nullptr, &got));
            OwnedMat difference;
            DEADPOINT_PETSC(MatDuplicate(got, MAT_COPY_VALUES, difference.out()));
            DEADPOINT_PETSC(MatAXPY(difference, -1, expected, DIFFERENT_NONZERO_PATTERN));
            CHECK(norm(difference) < 1e-12 * norm(expected));  // rounding of sums of some hundred products
        }
    }
    for (PetscInt level = 0; level + 1 < levels; ++level)
        DEADPOINT_PETSC(MatDestroy(&interpolations[level]));
    DEADPOINT_PETSC(PetscFree(interpolations));
}

TEST_CASE("a hierarchy that follows the step size solves as fast as one made for it, whatever came before")
{
    Hierarchy grid;
    CoarseMatrices coarse;
    for (const double factor : {50.0, 0.05}) {
        grid.fill(factor);
        DEADPOINT_PETSC(PCSetUp(grid.multigrid));
        coarse.keep(grid.multigrid, factor);
    }
    OwnedVec load, solution;
    DEADPOINT_PETSC(MatCreateVecs(grid.system, solution.out(), load.out()));
    DEADPOINT_PETSC(VecSet(load, 0));
    DEADPOINT_PETSC(VecSetValue(load, 7, 1.0, INSERT_VALUES));
    DEADPOINT_PETSC(VecAssemblyBegin(load));
    DEADPOINT_PETSC(VecAssemblyEnd(load));
    DEADPOINT_PETSC(KSPSetTolerances(grid.solver, 1e-10, 0, 1e5, 200));
    const auto solve_with = [&](double factor, bool anew) {
        grid.fill(factor);
        DEADPOINT_PETSC(KSPSetReusePreconditioner(grid.solver, anew ? PETSC_FALSE : PETSC_TRUE));
        if (!anew)
            coarse.follow(grid.multigrid, factor);
        const int iterations = solve(grid.solver, load, solution, "the lattice");
        double length = 0;
        DEADPOINT_PETSC(VecNorm(solution, NORM_2, &length));
        return std::pair(iterations, length);
    };
    const auto first = solve_with(5, false);
    const auto longer = solve_with(500, false);
    const auto again = solve_with(5, false);
    CHECK(first.second == again.second);  // to the bit, as a resumed run needs
    CHECK(first.first == solve_with(5, true).first);
    CHECK(longer.first == solve_with(500, true).first);
}
