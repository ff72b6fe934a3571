/// Requirement: solves by the tridiagonal form of a matrix are those of a dense factor of the whole matrix.
#include "deadpoint/reduce/online/shifted_solver.hpp"

#include "deadpoint/heat/system.hpp"

#include <doctest/doctest.h>
#include <limits>
#include <memory>

using namespace deadpoint;
using reduce::ShiftedSolver;

namespace {

constexpr Eigen::Index states = 30, loads = 4, others = 2;

/// A stiff matrix K >= 0 with loads of its own and others.
struct Stiff {
    Stiff()
    {
        std::srand(3);
        const Eigen::MatrixXd any = Eigen::MatrixXd::Random(states, states - 5);
        matrix =
            any * Eigen::VectorXd::LinSpaced(states - 5, -6, 2).array().exp().matrix().asDiagonal() * any.transpose();
        own = Eigen::MatrixXd::Random(states, loads);
        beside = Eigen::MatrixXd::Random(states, others);
        right = Eigen::VectorXd::Random(states);
        set_matrix();
        solver.set_loads(own);
    }
    void set_matrix()
    {
        solver.set_matrix(std::make_shared<const reduce::TridiagonalForm>(reduce::SymmetricMatrix(matrix)));
    }
    Eigen::VectorXd solve(double d, const Eigen::VectorXd& of_own, const Eigen::VectorXd& of_beside)
    {
        Eigen::VectorXd solution;
        solver.set_shift(d);
        solver.solve(right, of_own, beside.leftCols(of_beside.size()), of_beside, solution);
        return solution;
    }
    [[nodiscard]] Eigen::MatrixXd whole(double d) const
    {
        return Eigen::MatrixXd::Identity(states, states) + d * matrix;
    }
    Eigen::MatrixXd matrix, own, beside;
    Eigen::VectorXd right;
    ShiftedSolver solver;
};

}  // namespace

TEST_CASE("for any shift, and back to an earlier one, the solution is that of the dense matrix")
{
    Stiff at;
    for (const double d : {0.0, 0.3, 500.0, 1e5, 0.3}) {
        const Eigen::VectorXd expected = at.whole(d).ldlt().solve(at.right);
        // the condition of the matrix is up to 1e9
        CHECK((at.solve(d, {}, {}) - expected).norm() < 1e-7 * expected.norm());
    }
}

TEST_CASE("more shifts than are kept give the same solutions again")
{
    Stiff at;
    const Eigen::VectorXd first = at.solve(1, {}, {});
    for (int k = 2; k < 80; ++k)
        at.solve(k, {}, {});
    CHECK(at.solve(1, {}, {}) == first);
}

TEST_CASE("terms of low rank, of the solver's own loads and others, are those subtracted from the matrix")
{
    Stiff at;
    const Eigen::VectorXd of_own = Eigen::Vector4d(-0.7, 0, -3, 0.01), of_beside = Eigen::Vector2d(0.02, -5);
    const Eigen::MatrixXd with_own = at.whole(2) - at.own * of_own.asDiagonal() * at.own.transpose();
    const Eigen::VectorXd first = with_own.partialPivLu().solve(at.right);
    CHECK((at.solve(2, of_own, {}) - first).norm() < 1e-10 * first.norm());
    const Eigen::MatrixXd with_all = with_own - at.beside * of_beside.asDiagonal() * at.beside.transpose();
    const Eigen::VectorXd second = with_all.partialPivLu().solve(at.right);
    CHECK((at.solve(2, of_own, of_beside) - second).norm() < 1e-10 * second.norm());
    // Other loads on the same matrix.
    at.own = 2 * at.own;
    at.solver.set_loads(at.own);
    const Eigen::MatrixXd with_others = at.whole(2) - at.own * of_own.asDiagonal() * at.own.transpose();
    const Eigen::VectorXd third = with_others.partialPivLu().solve(at.right);
    CHECK((at.solve(2, of_own, {}) - third).norm() < 1e-10 * third.norm());
}

TEST_CASE("a matrix that is not positive or not finite is refused")
{
    Stiff at;
    CHECK_THROWS_AS(at.solver.set_shift(-100), heat::NotFinite);
    at.matrix(3, 2) = std::numeric_limits<double>::quiet_NaN();
    at.set_matrix();
    CHECK_THROWS_AS(at.solver.set_shift(1), heat::NotFinite);
}
