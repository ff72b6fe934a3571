#include "deadpoint/fem/conduction/multigrid/conjugate_gradients.hpp"

#include "deadpoint/error.hpp"
#include "deadpoint/fem/conduction/multigrid/coarse_matrices.hpp"
#include "deadpoint/fem/conduction/multigrid/float_cycle.hpp"
#include "lattice.hpp"

#include <cmath>
#include <doctest/doctest.h>
#include <limits>
#include <optional>

using namespace deadpoint::fem;

namespace {

/// M + 5 K with its cycle.
struct Solver : lattice::Hierarchy {
    explicit Solver(PCType type = lattice::hierarchies().front()) : Hierarchy(type)
    {
        fill(5);
        DEADPOINT_PETSC(PCSetUp(multigrid));
        cycle.emplace(PC(multigrid));
        cycle->take_values(smoother_bounds(multigrid));
    }
    [[nodiscard]] Eigen::VectorXd times(const Eigen::VectorXd& values) const
    {
        const auto in = lattice::some_load(system, 1), out = duplicate(in);
        Eigen::Map<Eigen::VectorXd>(Entries(in).data(), values.size()) = values;
        DEADPOINT_PETSC(MatMult(system, in, out));
        return Eigen::Map<const Eigen::VectorXd>(ConstEntries(out).data(), values.size());
    }
    [[nodiscard]] BlockSolution solve(const Eigen::MatrixXd& right, double relative)
    {
        return solve_together(system, *cycle, right, relative, "a test");
    }
    std::optional<FloatCycle> cycle;
};

constexpr Eigen::Index unknowns = lattice::side * lattice::side * lattice::side;

// Columns as unlike as loads are: many waves, sizes of many decades, one that is zero.
Eigen::MatrixXd solutions(Eigen::Index count)
{
    Eigen::MatrixXd result(unknowns, count);
    for (Eigen::Index k = 0; k < count; ++k)
        for (Eigen::Index i = 0; i < unknowns; ++i)
            result(i, k) =
                std::pow(10.0, 4.0 * static_cast<double>(k)) * std::cos(0.01 * static_cast<double>((k + 1) * i));
    result.col(2).setZero();
    return result;
}

}  // namespace

TEST_CASE("blocks are solved for as sharply as asked, whatever the number and size of the loads")
{
    for (const PCType type : lattice::hierarchies()) {
        CAPTURE(type);
        Solver solver(type);
        const Eigen::MatrixXd exact = solutions(11);
        Eigen::MatrixXd right(unknowns, exact.cols());
        for (Eigen::Index k = 0; k < exact.cols(); ++k)
            right.col(k) = solver.times(exact.col(k));
        for (const double relative : {1e-4, 1e-9}) {
            CAPTURE(relative);
            const auto [found, iterations] = solver.solve(right, relative);
            CHECK(iterations <= -1.5 * std::log10(relative));  // 6 and 12 were found; 7 and 17 without conjugation
            for (Eigen::Index k = 0; k < exact.cols(); ++k) {
                CAPTURE(k);
                // What is left is about as large as a correction, by which the iteration ends.
                CHECK((found.col(k) - exact.col(k)).norm() <= 2 * relative * exact.col(k).norm());
            }
            CHECK(found.col(0).isApprox(solver.solve(right.leftCols(1), relative).columns, 2 * relative));
        }
    }
}

TEST_CASE("a load that is not finite ends with an error that names the solution")
{
    Solver solver;
    Eigen::MatrixXd right = Eigen::MatrixXd::Ones(unknowns, 2);
    right(7, 1) = std::numeric_limits<double>::infinity();
    CHECK_THROWS_WITH_AS(static_cast<void>(solver.solve(right, 1e-4)),
                         "a test is not finite; look for a coefficient of the case that cannot be meant",
                         deadpoint::ConvergenceError);
}
