#include "deadpoint/fem/algebra/shell_matrix.hpp"

#include "near.hpp"

#include <doctest/doctest.h>
#include <stdexcept>
#include <string>

using namespace deadpoint::fem;

namespace {

constexpr PetscInt rows = 20;

struct Unforeseen : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Conjugate gradients on diag(1, 2, ...), which does not end within one product.
struct System {
    explicit System(ShellMatrix::Product product) : matrix(rows, rows, std::move(product))
    {
        DEADPOINT_PETSC(VecCreateSeq(PETSC_COMM_SELF, rows, load.out()));
        DEADPOINT_PETSC(VecDuplicate(load, solution.out()));
        DEADPOINT_PETSC(VecSet(load, 1));
        DEADPOINT_PETSC(KSPCreate(PETSC_COMM_SELF, solver.out()));
        DEADPOINT_PETSC(KSPSetType(solver, KSPCG));
        PC preconditioner = nullptr;
        DEADPOINT_PETSC(KSPGetPC(solver, &preconditioner));
        DEADPOINT_PETSC(PCSetType(preconditioner, PCNONE));
        DEADPOINT_PETSC(KSPSetTolerances(solver, 1e-12, 0, 1e10, 100));
        DEADPOINT_PETSC(KSPSetOperators(solver, matrix, matrix));
    }
    int solved()
    {
        return matrix.use([this] { return solve(solver, load, solution, "a field"); });
    }
    ShellMatrix matrix;
    OwnedVec load, solution;
    OwnedKsp solver;
};

void multiply_by_diagonal(Vec in, Vec out)
{
    DEADPOINT_PETSC(VecCopy(in, out));
    double* values = nullptr;
    DEADPOINT_PETSC(VecGetArray(out, &values));
    for (PetscInt i = 0; i < rows; ++i)
        values[i] *= 1.0 + i;
    DEADPOINT_PETSC(VecRestoreArray(out, &values));
}

std::string failure_of(const ShellMatrix::Product& product)
{
    System system(product);
    try {
        system.solved();
    } catch (const deadpoint::ConvergenceError& error) {
        return error.what();
    }
    return {};
}

}  // namespace

TEST_CASE("a matrix known by its product is solved with")
{
    System system(multiply_by_diagonal);
    CHECK(system.solved() > 2);
    const double* values = nullptr;
    DEADPOINT_PETSC(VecGetArrayRead(system.solution, &values));
    for (PetscInt i = 0; i < rows; ++i)
        CHECK(values[i] == near(1.0 / (1.0 + i), 1e-9));
    DEADPOINT_PETSC(VecRestoreArrayRead(system.solution, &values));
}

TEST_CASE("an exception in the product ends the solve, and comes out of it as it was thrown")
{
    int products = 0;
    System system([&](Vec in, Vec out) {
        if (++products == 3)
            throw Unforeseen("the third product");
        multiply_by_diagonal(in, out);
    });
    CHECK_THROWS_WITH_AS(system.solved(), "the third product", Unforeseen);
    CHECK(products == 3);
    // The next failure has a text of its own: nothing of the first one is left.
    const auto own = failure_of([](Vec, Vec) { throw deadpoint::ConvergenceError("of its own"); });
    CHECK(own == "of its own");
}

TEST_CASE("a solve that ends without a result says why in words")
{
    const auto infinite = failure_of([](Vec, Vec out) { DEADPOINT_PETSC(VecSet(out, PETSC_INFINITY)); });
    CHECK(infinite.find("a value became infinite or not a number") != std::string::npos);
    CHECK(infinite.find("reason") == std::string::npos);
}
