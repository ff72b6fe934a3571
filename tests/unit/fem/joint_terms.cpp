/// Requirement: what joints and films add to the conduction matrix, term by term, against integrals on paper.
#include "deadpoint/fem/conduction/terms/joint_terms.hpp"

#include "bricks.hpp"
#include "deadpoint/exchange/heat.hpp"
#include "deadpoint/exchange/machine.hpp"
#include "near.hpp"

#include <doctest/doctest.h>
#include <malloc.h>

using namespace deadpoint;
using namespace deadpoint::fem;
using bricks::Brick;
using bricks::column;
using bricks::dense;

namespace {

/// Two blocks, one on the other at z = 1 over 2 x 1 m2, with meshes that do not match.
Machine blocks(bool matching)
{
    auto machine = bricks::machine_of(
        {{{0, 0, 0}, {2, 1, 1}, {2, 1, 1}, false, {}},
         {{0, 0, 1}, {2, 1, 2}, matching ? std::array<int, 3>{2, 1, 1} : std::array<int, 3>{3, 2, 1}, false, {}}});
    machine.interfaces = {bricks::contact(machine, 0, 1, 2)};
    return machine;
}

HeatProblem problem_with(bool turns)
{
    HeatProblem problem;
    InterfaceLaw law;
    law.film_a = 300;
    law.film_b = 200;
    law.turns_fully = turns;
    problem.interfaces = {law};
    problem.segments.resize(1);
    return problem;
}

/// A dense matrix of the terms with these coefficients.
Eigen::MatrixXd matrix_of(const Discretisation& space, const JointTerms& terms, const JointCoefficients& coefficients)
{
    auto couplings = space.cell_couplings();
    terms.add_couplings(couplings);
    const auto matrix = create_matrix(couplings.rows());
    terms.add_to(matrix, {coefficients});
    DEADPOINT_PETSC(MatAssemblyBegin(matrix, MAT_FINAL_ASSEMBLY));
    DEADPOINT_PETSC(MatAssemblyEnd(matrix, MAT_FINAL_ASSEMBLY));
    return dense(matrix);
}

/// A field that lives on one part alone.
Eigen::VectorXd of_part(const Discretisation& space, std::uint32_t part, const bricks::Scalar& field)
{
    auto values = column(space, field);
    const auto parts = space.part_of_unknown();
    for (std::size_t i = 0; i < parts.size(); ++i)
        if (parts[i] != part)
            values[static_cast<Eigen::Index>(i)] = 0;
    return values;
}

double f(const Vec3& x) { return 1 + 2 * x[0] - x[1]; }
double g(const Vec3& x) { return 3 - x[0] + 4 * x[1]; }

// Over x = 0..2, y = 0..1, each factor a + b x + c y: its area times the product of means and of slopes.
double integral(const std::array<double, 3>& p, const std::array<double, 3>& q)
{
    const double mean_p = p[0] + p[1] + 0.5 * p[2], mean_q = q[0] + q[1] + 0.5 * q[2];
    return 2 * (mean_p * mean_q + p[1] * q[1] * 4 / 12 + p[2] * q[2] / 12);
}
constexpr std::array<double, 3> of_f{1, 2, -1}, of_g{3, -1, 4};

}  // namespace

TEST_CASE("a film's coefficients are those of the film eliminated")
{
    InterfaceLaw law;
    law.film_a = 700;
    law.film_b = 200;
    law.oil = 150;
    // Heat of sides and film by their temperatures; the film's row gives nothing.
    Eigen::Matrix3d whole;
    whole << 700, 0, -700, 0, 200, -200, -700, -200, 1050;
    const Eigen::Matrix2d left =
        whole.topLeftCorner<2, 2>() - whole.topRightCorner<2, 1>() * whole.bottomLeftCorner<1, 2>() / whole(2, 2);
    const auto c = coefficients_of(law);
    CHECK(c.aa == near(left(0, 0), 1e-14));
    CHECK(c.bb == near(left(1, 1), 1e-14));
    CHECK(c.across == near(left(0, 1), 1e-14));
    CHECK(c.turning == 0);
    law.turns_fully = true;
    const auto turning = coefficients_of(law);
    CHECK(turning.turning == c.across);
    CHECK(turning.across == 0);
    CHECK(turning.aa == c.aa);
    // Without oil the film passes on what it gets: two resistances in series.
    law.oil = 0;
    CHECK(coefficients_of(law).aa == near(1 / (1 / 700.0 + 1 / 200.0), 1e-14));
    CHECK(coefficients_of(law).aa == near(-coefficients_of(law).turning, 1e-14));
}

TEST_CASE("on matching faces the terms are the mass of bilinear squares")
{
    const bricks::Space both(blocks(true), {1, 1});
    const JointTerms terms(both.space, problem_with(false));
    const auto aa = matrix_of(both.space, terms, {1, 0, 0, 0});
    const auto across = matrix_of(both.space, terms, {0, 0, 1, 0});
    const auto places = both.space.support_points();
    const auto parts = both.space.part_of_unknown();
    // Products of the line's mass h / 6 (2 1; 1 2), h = 1, with cells at x = 0..1 and 1..2.
    const auto line = [](double from, double to, int cells) {
        if (std::abs(from - to) > 1.5)
            return 0.0;
        if (std::abs(from - to) > 0.5)
            return 1 / 6.0;
        return cells == 2 && std::abs(from - 1) < 0.1 ? 4 / 6.0 : 2 / 6.0;
    };
    for (std::size_t i = 0; i < places.size(); ++i)
        for (std::size_t j = 0; j < places.size(); ++j) {
            const auto row = static_cast<Eigen::Index>(i), at = static_cast<Eigen::Index>(j);
            const bool on_face = std::abs(places[i][2] - 1) < 0.1 && std::abs(places[j][2] - 1) < 0.1;
            const double mass = on_face ? line(places[i][0], places[j][0], 2) * line(places[i][1], places[j][1], 1) : 0;
            CHECK(std::abs(aa(row, at) - (parts[i] == 0 && parts[j] == 0 ? mass : 0)) < 1e-14);
            CHECK(std::abs(across(row, at) - (parts[i] != parts[j] ? mass : 0)) < 1e-14);
        }
}

TEST_CASE("on faces that do not match, and of any order, linear fields have their integrals")
{
    for (const auto& orders : {std::vector<int>{1, 1}, std::vector<int>{1, 2}, std::vector<int>{2, 2}}) {
        const bricks::Space both(blocks(false), orders);
        const JointTerms terms(both.space, problem_with(false));
        const auto a = of_part(both.space, 0, f), b = of_part(both.space, 1, g);
        CHECK(a.dot(matrix_of(both.space, terms, {1, 0, 0, 0}) * a) == near(integral(of_f, of_f), 1e-12));
        CHECK(b.dot(matrix_of(both.space, terms, {0, 1, 0, 0}) * b) == near(integral(of_g, of_g), 1e-12));
        const auto across = matrix_of(both.space, terms, {0, 0, 1, 0});
        CHECK(a.dot(across * b) == near(integral(of_f, of_g), 1e-12));
        CHECK((across - across.transpose()).norm() < 1e-14);
        CHECK(std::abs(a.dot(across * a)) < 1e-14);
    }
}

TEST_CASE("a film conducts nothing where both sides are of one temperature, and without oil it loses nothing")
{
    const bricks::Space both(blocks(false), {1, 1});
    const JointTerms terms(both.space, problem_with(false));
    const auto matrix = matrix_of(both.space, terms, coefficients_of(problem_with(false).interfaces[0]));
    CHECK((matrix * Eigen::VectorXd::Ones(matrix.rows())).norm() < 1e-12 * matrix.norm());
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> modes(matrix);
    CHECK(modes.eigenvalues()[0] > -1e-12 * matrix.norm());
    CHECK(matrix.norm() > 10);
}

TEST_CASE("a joint that turns couples the means of both sides")
{
    const bricks::Space both(blocks(false), {1, 1});  // its contact is a plane: no axis, one strip
    const JointTerms terms(both.space, problem_with(true));
    const auto turning = matrix_of(both.space, terms, {0, 0, 0, 1});
    const auto a = of_part(both.space, 0, f), b = of_part(both.space, 1, g);
    CHECK(a.dot(turning * b) == near(2 * 2.5 * 4, 1e-12));  // area, means 1 + 2 - 0.5 and 3 - 1 + 2
    CHECK((turning - turning.transpose()).norm() < 1e-14);
    // A temperature that averages out on one side is not seen by the other.
    const auto odd = of_part(both.space, 0, [](const Vec3& x) { return x[0] - 1; });
    CHECK(std::abs(odd.dot(turning * b)) < 1e-13);
}

TEST_CASE("along the axis of a joint that turns, each strip's mean and slope are coupled")
{
    auto machine = blocks(false);
    CylinderGeometry cylinder;
    cylinder.axis = {1, 0, 0};
    machine.interfaces[0].geometry = cylinder;
    const bricks::Space both(machine, {1, 1});
    const JointTerms terms(both.space, problem_with(true));
    const auto turning = matrix_of(both.space, terms, {0, 0, 0, 1});
    const auto a = of_part(both.space, 0, f), b = of_part(both.space, 1, g);
    // Linear along the axis: what is coupled are the means across it, point by point along it.
    const double expected = integral({1 - 0.5, 2, 0}, {3 + 2, -1, 0});
    CHECK(a.dot(turning * b) == near(expected, 1e-12));
}

TEST_CASE("terms serve joints that turn or do not as they did when integrated")
{
    const bricks::Space both(blocks(true), {1, 1});
    auto mixed = problem_with(false);
    mixed.segments.resize(2);
    mixed.segments[1].interfaces = problem_with(true).interfaces;
    const JointTerms still(both.space, problem_with(false)), turning(both.space, problem_with(true)),
        either(both.space, mixed);
    const auto resting = problem_with(false).interfaces, rotating = problem_with(true).interfaces;
    CHECK(still.serve(resting));
    CHECK_FALSE(still.serve(rotating));
    CHECK_FALSE(turning.serve(resting));
    CHECK(turning.serve(rotating));
    CHECK(either.serve(resting));
    CHECK(either.serve(rotating));
}

TEST_CASE("film terms: of constant films only, by the share that is exposed")
{
    auto machine = blocks(false);
    const int top = bricks::add_surface(machine, 1, 2, true), part = bricks::add_surface(machine, 0, 1, false, 0.25);
    const bricks::Space both(machine, {1, 1});
    HeatProblem problem;
    problem.surfaces.resize(4);
    problem.surfaces[0].surface = problem.surfaces[1].surface = problem.surfaces[2].surface = top;
    problem.surfaces[1].emissivity = 0.5;
    problem.surfaces[2].kind = SurfaceCondition::Kind::flux;
    problem.surfaces[3].surface = part;
    const auto terms = film_terms(both.space, problem);
    REQUIRE(terms.size() == 4);
    CHECK(terms[0].entries() > 0);
    CHECK(terms[1].entries() == 0);
    CHECK(terms[2].entries() == 0);
    const auto matrix = create_matrix(both.space.cell_couplings().rows());
    terms[0].add_to(matrix, 10);
    terms[3].add_to(matrix, 4);
    DEADPOINT_PETSC(MatAssemblyBegin(matrix, MAT_FINAL_ASSEMBLY));
    DEADPOINT_PETSC(MatAssemblyEnd(matrix, MAT_FINAL_ASSEMBLY));
    const auto whole = dense(matrix);
    const auto b = of_part(both.space, 1, g);
    CHECK(b.dot(whole * b) == near(10 * integral(of_g, of_g), 1e-12));
    const auto one = of_part(both.space, 0, [](const Vec3&) { return 1.0; });
    CHECK(one.dot(whole * one) == near(4 * 0.25 * 2, 1e-13));  // 2 x 1 m2 at y = 0, a quarter of it
}

TEST_CASE("entries of a term are summed by place, whatever order they come in")
{
    const bricks::Space part(Brick{}, 1);
    SparseTerm term;
    PointShape shape;
    shape.count = 2;
    shape.dof[0] = 6;
    shape.dof[1] = 2;
    shape.value[0] = 3;
    shape.value[1] = -1;
    term.add(5, 5, 7);
    term.add(shape, shape, 2);
    term.add(2, 6, 100);
    term.add(5, 5, 0.5);
    term.finish();
    CHECK(term.entries() == 5);
    const auto matrix = create_matrix(part.space.cell_couplings().rows());
    term.add_to(matrix, 10);
    term.add_to(matrix, 0);
    insert_block(matrix, shape, shape, 1);
    DEADPOINT_PETSC(MatAssemblyBegin(matrix, MAT_FINAL_ASSEMBLY));
    DEADPOINT_PETSC(MatAssemblyEnd(matrix, MAT_FINAL_ASSEMBLY));
    Eigen::MatrixXd expected = Eigen::MatrixXd::Zero(8, 8);
    expected(5, 5) = 75;
    expected(6, 6) = 21 * 9;
    expected(2, 2) = 21;
    expected(6, 2) = -63;
    expected(2, 6) = -63 + 1000;
    CHECK(dense(matrix) == expected);
}

TEST_CASE("a finished term keeps no memory but that of its entries")
{
    const auto used = [] {
        const auto info = mallinfo2();
        return info.uordblks + info.hblkhd;
    };
    const auto before = used();
    SparseTerm term;
    for (PetscInt k = 0; k < 900'000; ++k)  // 14 MB until they are summed
        term.add(k % 10, k % 7, 1);
    term.finish();
    CHECK(term.entries() == 70);
    CHECK(used() - before < 100'000);
}

TEST_CASE("an empty term adds nothing")
{
    SparseTerm term;
    term.finish();
    CHECK(term.entries() == 0);
    const bricks::Space part(Brick{}, 1);
    const auto matrix = create_matrix(part.space.cell_couplings().rows());
    term.add_to(matrix, 3);
    DEADPOINT_PETSC(MatAssemblyBegin(matrix, MAT_FINAL_ASSEMBLY));
    DEADPOINT_PETSC(MatAssemblyEnd(matrix, MAT_FINAL_ASSEMBLY));
    CHECK(dense(matrix).norm() == 0);
}
