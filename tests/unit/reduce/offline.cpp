#include "deadpoint/reduce/offline/gram.hpp"
#include "deadpoint/reduce/offline/low_rank.hpp"
#include "deadpoint/reduce/offline/pod.hpp"
#include "deadpoint/reduce/online/box.hpp"
#include "deadpoint/reduce/parallel/in_parallel.hpp"
#include "near.hpp"
#include "rods.hpp"

#include <atomic>
#include <cmath>
#include <doctest/doctest.h>
#include <stdexcept>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

using namespace deadpoint;
using namespace deadpoint::reduce;

namespace {

Eigen::MatrixXd columns_of(Eigen::Index rows, Eigen::Index count)
{
    Draws draws(7);
    Eigen::MatrixXd result(rows, count);
    for (double& value : result.reshaped())
        value = draws.next() - 0.5;
    return result;
}

// With eigenvalues 1, 1/10, 1/100 ...
Eigen::MatrixXd with_falling_eigenvalues(Eigen::Index size)
{
    const Eigen::MatrixXd q = Eigen::HouseholderQR<Eigen::MatrixXd>(columns_of(size, size)).householderQ();
    Eigen::VectorXd values(size);
    for (Eigen::Index k = 0; k < size; ++k)
        values[k] = std::pow(10.0, -static_cast<double>(k));
    return q * values.asDiagonal() * q.transpose();
}

}  // namespace

TEST_CASE("orthonormal combinations of fields")
{
    Eigen::MatrixXd fields = columns_of(40, 8);
    fields.col(5) = 2 * fields.col(3) - fields.col(1);  // nothing new
    fields.col(2) *= 1e-9;                              // small, but new
    const auto combinations =
        orthonormal_combinations(fields.transpose() * fields, {1e-6, 8, std::vector<double>(8, 1)});
    CHECK(combinations.cols() == 7);
    const Eigen::MatrixXd basis = fields * combinations;
    CHECK((basis.transpose() * basis - Eigen::MatrixXd::Identity(7, 7)).norm() < 1e-9);  // one pass of a Gram matrix
    CHECK(std::abs(basis.col(0).dot(fields.col(0))) == near(fields.col(0).norm(), 1e-5));
    const Eigen::VectorXd rest = fields.col(2) - basis * (basis.transpose() * fields.col(2));
    CHECK(rest.norm() < 1e-9 * fields.col(2).norm());
}

TEST_CASE("where a basis has no room for all fields, the largest weight times what is new decides")
{
    const Eigen::MatrixXd fields{
        {1, 0.8, 0.6, 0}, {0, 0.6, 0, 0}, {0, 0, 0.8, 0}, {0, 0, 0, 1}};  // new: 1, 0.6, 0.8, 1
    const Eigen::MatrixXd gram = fields.transpose() * fields;
    const auto chosen = [&](std::vector<double> weights) {
        const auto combinations = orthonormal_combinations(gram, {1e-6, 2, std::move(weights)});
        CHECK(combinations.cols() == 2);
        Eigen::Index largest = 0;
        combinations.col(1).cwiseAbs().maxCoeff(&largest);
        return largest;
    };
    CHECK(chosen({1, 1, 1, 1}) == 3);
    CHECK(chosen({1, 1, 1.26, 1}) == 2);  // 1.26 * 0.8 > 1
    CHECK(chosen({1, 1, 1.24, 1}) == 3);
    CHECK(chosen({1, 1.68, 1.26, 1}) == 2);  // 1.68 * 0.6 > 1, but less than 1.26 * 0.8
    CHECK(chosen({1, INFINITY, 9, 9}) == 1);
}

TEST_CASE("factors of low rank leave out what is below the tolerance")
{
    const auto matrix = with_falling_eigenvalues(60);
    const auto product = [&](const Eigen::MatrixXd& columns) -> Eigen::MatrixXd { return matrix * columns; };
    for (const double tolerance : {1e-2, 1e-5, 1e-8}) {
        const auto factor = low_rank_factor(product, 60, tolerance);
        const double rank = -std::log10(tolerance);
        CHECK(factor.cols() >= rank);
        CHECK(factor.cols() <= rank + 1);
        CHECK((factor * factor.transpose() - matrix).norm() < 1.2 * tolerance);  // the sum of those left out is 1.11
    }
    CHECK(low_rank_factor([](const Eigen::MatrixXd& c) -> Eigen::MatrixXd { return 0 * c; }, 60, 1e-5).cols() == 0);
}

TEST_CASE("a factor keeps the load of the uniform field exactly")
{
    const Eigen::MatrixXd root = columns_of(60, 45);
    const Eigen::MatrixXd matrix = root * root.transpose();
    const Eigen::VectorXd uniform = Eigen::VectorXd::Ones(60);
    const Eigen::VectorXd load = matrix * uniform;
    const auto product = [&](const Eigen::MatrixXd& columns) -> Eigen::MatrixXd { return matrix * columns; };
    const auto factor = low_rank_factor(product, load, uniform, 0.05);
    CHECK(factor.cols() < 45);
    CHECK((factor * (factor.transpose() * uniform) - load).norm() < 1e-9 * load.norm());
    const auto moments = with_falling_eigenvalues(60);
    const auto shorter = cut(factor, 1, moments, 1e-3);
    CHECK(shorter.cols() < factor.cols());
    CHECK((shorter * (shorter.transpose() * uniform) - load).norm() < 1e-9 * load.norm());
    const auto whole = cut(root, 0, Eigen::MatrixXd::Identity(60, 60), 0);
    CHECK((whole * whole.transpose() - matrix).norm() < 1e-9 * matrix.norm());
}

TEST_CASE("a cut leaves out the directions in which the states give off little heat")
{
    const Eigen::MatrixXd factor{{5, 0, 0}, {0, 3, 0}, {0, 0, 0.1}, {0, 0, 0}};
    const Eigen::VectorXd squares{{1, 1e-4, 1, 1}};  // heat of the columns: 25, 9e-4, 0.01
    const Eigen::MatrixXd moments = squares.asDiagonal();
    const auto heat = [&](const Eigen::MatrixXd& of) { return of.cwiseProduct(moments * of).sum(); };
    const auto one = cut(factor, 0, moments, 0.02), two = cut(factor, 0, moments, 1e-3);
    REQUIRE(one.cols() == 1);
    CHECK(heat(one) == near(25, 1e-5));  // the first, and not the second, which is large where no states are
    REQUIRE(two.cols() == 2);
    CHECK(heat(two) == near(25.01, 1e-5));
    CHECK(cut(factor, 1, moments, 100).cols() == 1);
    CHECK(cut(factor, 0, moments, 100).cols() == 0);
    const Eigen::MatrixXd left = factor * factor.transpose() - two * two.transpose();
    CHECK(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(left).eigenvalues().minCoeff() > -1e-12);
}

TEST_CASE("the most frequent states hold the uniform field and what runs did")
{
    const Eigen::VectorXd uniform = Eigen::VectorXd::Constant(30, 2);
    const Eigen::MatrixXd directions = columns_of(30, 3);
    Moments moments(30), none(30);
    moments.add(directions * columns_of(3, 50) + 293 * uniform * Eigen::RowVectorXd::Ones(50));
    const auto basis = most_frequent(moments, none, {uniform, Eigen::MatrixXd::Identity(30, 30), 1e-2}, 4);
    REQUIRE(basis.cols() == 4);
    CHECK((basis.transpose() * basis - Eigen::MatrixXd::Identity(4, 4)).norm() < 1e-10);
    for (const Eigen::VectorXd& field : {uniform, Eigen::VectorXd(directions.col(1))})
        CHECK((field - basis * (basis.transpose() * field)).norm() < 1e-7 * field.norm());
}

TEST_CASE("in a norm that weighs one component, its states come before larger ones of others")
{
    Eigen::MatrixXd states = Eigen::MatrixXd::Zero(6, 2);
    states(2, 0) = 1;    // weighs 1 of 1.01 in x^T x, 1 of 2 with the norm below
    states(4, 1) = 0.1;  // 0.01, and 1.1
    Moments moments(6), none(6);
    moments.add(states);
    const Eigen::VectorXd uniform = Eigen::VectorXd::Unit(6, 0);
    Eigen::MatrixXd norm = Eigen::MatrixXd::Identity(6, 6);
    CHECK(std::abs(most_frequent(moments, none, {uniform, norm, 0}, 2)(2, 1)) == near(1, 1e-5));
    norm(4, 4) = 110;
    const auto basis = most_frequent(moments, none, {uniform, norm, 0}, 2);
    CHECK(std::abs(basis(4, 1)) == near(1, 1e-5));
    CHECK(std::abs(basis(2, 1)) < 1e-12);
}

TEST_CASE("states by conduction span the same, and the solid is diagonal on them")
{
    auto terms = rods::full_terms();
    const auto n = terms.uniform.size();
    Eigen::MatrixXd some(n, 6);
    some << terms.uniform.normalized(), columns_of(n, 5);
    const Eigen::MatrixXd before =
        Eigen::HouseholderQR<Eigen::MatrixXd>(some).householderQ() * Eigen::MatrixXd::Identity(n, 6);
    const auto after = by_conduction(terms, before);
    CHECK(after.col(0) == before.col(0));
    CHECK((after * after.transpose() - before * before.transpose()).norm() < 1e-12);
    Eigen::MatrixXd solid = after.transpose() * terms.solid * after;
    solid.diagonal().setZero();
    CHECK(solid.norm() < 1e-12 * terms.solid.norm());
}

TEST_CASE("draws are those of SplitMix64 on every machine")
{
    Draws draws(1234567);  // its first numbers in the literature: 6457827717110365317, 3203168211198807973
    CHECK(draws.next() == static_cast<double>(6457827717110365317ULL >> 11) * 0x1p-53);
    CHECK(draws.next() == static_cast<double>(3203168211198807973ULL >> 11) * 0x1p-53);
}

TEST_CASE("draws stay in the box, and one of five is without oil")
{
    Draws draws(1);
    int without = 0;
    double least = 1e9, most = 0;
    for (int k = 0; k < 500; ++k) {
        const auto values = draws.values(rods::box());
        for (std::size_t i = 0; i < values.size(); ++i) {
            CHECK(values[i] >= rods::box()[i].from);
            CHECK(values[i] <= rods::box()[i].to);
        }
        without += values[4] == 0 ? 1 : 0;
        least = std::min(least, values[0]);
        most = std::max(most, values[0]);
    }
    CHECK(without > 60);  // 100 expected, with a standard deviation of 9
    CHECK(without < 140);
    CHECK(least < 0.22);  // even in the logarithm: 1.5 % of the draws are below 0.21
    CHECK(most > 4.6);
}

TEST_CASE("values of a box change a problem")
{
    auto problem = rods::problem();
    set_values(problem, rods::box(), {2, 1, 0.5, 4, 3, 0.7, -5});
    CHECK(problem.surfaces[0].coefficient == 24);
    CHECK(problem.surfaces[1].coefficient == 20);
    CHECK(problem.interfaces[0].film_a == 1500);
    CHECK(problem.interfaces[0].film_b == 8000);
    CHECK(problem.interfaces[0].oil == 900);
    CHECK(problem.sources[0].share == 0.7);
    CHECK(problem.segments[0].ambient(0) == 293);
    CHECK(problem.segments[0].ambient(1e6) == near(288, 1e-5));
}

TEST_CASE("work in parallel is done once each, by fewer threads where the system gives no more")
{
    std::vector<std::atomic<int>> calls(50);
    in_parallel(3, calls.size(), [&](std::size_t k) { ++calls[k]; });
    for (const auto& one : calls)
        CHECK(one == 1);
    CHECK_THROWS_AS(in_parallel(2, 9, [](std::size_t k) { k == 5 ? throw std::runtime_error("5") : void(); }),
                    std::runtime_error);

    const pid_t child = fork();  // whose limit of addresses leaves no room for the stack of a thread
    if (child == 0) {
        const rlimit limit{1, 1};
        setrlimit(RLIMIT_AS, &limit);
        int done = 0;
        in_parallel(4, 20, [&](std::size_t) { ++done; });
        _exit(done == 20 ? 0 : 1);
    }
    int status = -1;
    REQUIRE(waitpid(child, &status, 0) == child);
    CHECK(WIFEXITED(status));
    CHECK(WEXITSTATUS(status) == 0);
}
