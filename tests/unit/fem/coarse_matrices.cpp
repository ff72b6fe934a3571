#include "deadpoint/fem/conduction/multigrid/coarse_matrices.hpp"

#include "deadpoint/fem/algebra/vectors.hpp"
#include "deadpoint/fem/conduction/multigrid/float_cycle.hpp"
#include "lattice.hpp"
#include "near.hpp"

#include <array>
#include <cmath>
#include <doctest/doctest.h>
#include <vector>

using namespace deadpoint::fem;
using lattice::Hierarchy;
using lattice::some_load;

namespace {

/// Conjugate gradients with cycles: iterations until the residual is 1e-10 of the first.
int solve(FloatCycle& cycle, Mat matrix, Vec load, Vec solution)
{
    const auto residual = duplicate(load), direction = duplicate(load), product = duplicate(load),
               correction = duplicate(load);
    DEADPOINT_PETSC(VecSet(solution, 0));
    DEADPOINT_PETSC(VecCopy(load, residual));
    double first = 0, size = 0, before = 1;
    DEADPOINT_PETSC(VecNorm(residual, NORM_2, &first));
    for (int iteration = 0; iteration < 200; ++iteration) {
        DEADPOINT_PETSC(VecNorm(residual, NORM_2, &size));
        if (size <= 1e-10 * first)
            return iteration;
        cycle.apply(residual, correction);
        double now = 0, curvature = 0;
        DEADPOINT_PETSC(VecDot(residual, correction, &now));
        if (iteration == 0)
            DEADPOINT_PETSC(VecCopy(correction, direction));
        else
            DEADPOINT_PETSC(VecAYPX(direction, now / before, correction));
        before = now;
        DEADPOINT_PETSC(MatMult(matrix, direction, product));
        DEADPOINT_PETSC(VecDot(direction, product, &curvature));
        DEADPOINT_PETSC(VecAXPY(solution, now / curvature, direction));
        DEADPOINT_PETSC(VecAXPY(residual, -now / curvature, product));
    }
    return 200;
}

double norm(Mat matrix)
{
    double value = 0;
    DEADPOINT_PETSC(MatNorm(matrix, NORM_FROBENIUS, &value));
    return value;
}

}  // namespace

namespace {

// `own` on the diagonal, `other` everywhere else: eigenvalues own + (count - 1) other, and own - other.
OwnedMat full(PetscInt count, double own, double other)
{
    OwnedMat matrix;
    DEADPOINT_PETSC(MatCreateSeqAIJ(PETSC_COMM_SELF, count, count, count, nullptr, matrix.out()));
    for (PetscInt row = 0; row < count; ++row)
        for (PetscInt column = 0; column < count; ++column)
            DEADPOINT_PETSC(MatSetValue(matrix, row, column, row == column ? own : other, INSERT_VALUES));
    DEADPOINT_PETSC(MatAssemblyBegin(matrix, MAT_FINAL_ASSEMBLY));
    DEADPOINT_PETSC(MatAssemblyEnd(matrix, MAT_FINAL_ASSEMBLY));
    return matrix;
}

// Memory that is used next holds large numbers.
void soil_memory()
{
    for (std::size_t count = 4; count < 256; count += 2) {
        std::vector<std::vector<double>> freed;
        for (int block = 0; block < 7; ++block)
            freed.emplace_back(count, 1e3);
    }
}

}  // namespace

TEST_CASE("the largest eigenvalue of a small level is that of its matrix, whatever the memory held before")
{
    for (const double own : {1.0, 3.0}) {
        soil_memory();
        CHECK(largest_eigenvalue(full(40, 2, 1)) == near(20.5, 1e-5));
        soil_memory();
        CHECK(largest_eigenvalue(full(2, own, 0)) == near(1, 1e-5));                 // solved in one iteration
        CHECK(largest_eigenvalue(full(2, own, -0.5)) == near(1 + 0.5 / own, 1e-5));  // in two
        CHECK(largest_eigenvalue(full(1, own, 0)) == near(1, 1e-5));
    }
}

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
    for (const PCType type : lattice::hierarchies()) {
        CAPTURE(type);
        Hierarchy grid(type), other(type);
        CoarseMatrices coarse;
        for (const double factor : {50.0, 0.05}) {
            grid.fill(factor);
            DEADPOINT_PETSC(PCSetUp(grid.multigrid));
            coarse.keep(grid.multigrid, factor);
        }
        FloatCycle cycle(grid.multigrid);
        const auto load = some_load(grid.system, 1), solution = duplicate(load);
        const auto follow = [&](double factor) {
            grid.fill(factor);
            coarse.follow(grid.multigrid, factor);
            cycle.take_values(coarse.bounds());
            const int iterations = solve(cycle, grid.system, load, solution);
            double length = 0;
            DEADPOINT_PETSC(VecNorm(solution, NORM_2, &length));
            return std::pair(iterations, length);
        };
        const auto made_for = [&](double factor) {
            other.fill(factor);
            DEADPOINT_PETSC(PCSetUp(other.multigrid));
            FloatCycle own(other.multigrid);
            own.take_values(smoother_bounds(other.multigrid));
            return solve(own, other.system, load, solution);
        };
        const auto first = follow(5);
        const auto longer = follow(500);
        const auto again = follow(5);
        CHECK(first.second == again.second);  // to the bit, as a resumed run needs
        CHECK(first.first <= made_for(5) + 1);
        CHECK(longer.first <= made_for(500) + 1);
        CHECK(longer.first < 20);  // a good multigrid gains a decimal place in two iterations
    }
}

TEST_CASE("a cycle is symmetric, positive and linear to single precision, for loads of any size")
{
    Hierarchy grid;
    grid.fill(5);
    DEADPOINT_PETSC(PCSetUp(grid.multigrid));
    FloatCycle cycle(grid.multigrid);
    cycle.take_values(smoother_bounds(grid.multigrid));
    const auto one = some_load(grid.system, 1);
    auto other = duplicate(one), of_one = duplicate(one), of_other = duplicate(one);
    DEADPOINT_PETSC(MatMult(grid.conduction, one, other));
    cycle.apply(one, of_one);
    cycle.apply(other, of_other);
    double there = 0, back = 0, itself = 0;
    DEADPOINT_PETSC(VecDot(other, of_one, &there));
    DEADPOINT_PETSC(VecDot(one, of_other, &back));
    DEADPOINT_PETSC(VecDot(other, of_other, &itself));
    CHECK(std::abs(there - back) < 1e-5 * std::abs(there));  // sums of some ten thousand floats
    CHECK(itself > 0);
    for (const double scale : {1e-200, 1e-12, 1e100}) {
        CAPTURE(scale);
        auto scaled = duplicate(one), result = duplicate(one);
        DEADPOINT_PETSC(VecCopy(one, scaled));
        DEADPOINT_PETSC(VecScale(scaled, scale));
        cycle.apply(scaled, result);
        double size = 0, difference = 0;
        DEADPOINT_PETSC(VecNorm(of_one, NORM_2, &size));
        DEADPOINT_PETSC(VecAXPBY(result, -1, 1 / scale, of_one));
        DEADPOINT_PETSC(VecNorm(result, NORM_2, &difference));
        CHECK(difference < 1e-6 * size);
    }
    DEADPOINT_PETSC(VecSet(other, 0));
    cycle.apply(other, of_other);
    DEADPOINT_PETSC(VecNorm(of_other, NORM_2, &itself));
    CHECK(itself == 0);
}
