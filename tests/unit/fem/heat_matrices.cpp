/// Requirement: the matrices of heat conduction are the integrals they stand for, and are integrated once.
#include "deadpoint/fem/conduction/terms/heat_matrices.hpp"

#include "bricks.hpp"
#include "deadpoint/exchange/machine.hpp"
#include "deadpoint/fem/conduction/heat_system.hpp"
#include "deadpoint/heat/run.hpp"
#include "deadpoint/observer.hpp"
#include "near.hpp"

#include <doctest/doctest.h>

using namespace deadpoint;
using namespace deadpoint::fem;
using bricks::Brick;
using bricks::column;
using bricks::dense;

namespace {

const Brick box{{0, 0, 0}, {0.6, 0.4, 0.5}, {2, 1, 2}, false, {}};
constexpr double volume = 0.6 * 0.4 * 0.5;

TimeCourse steady(double value)
{
    return [value](double) { return value; };
}

HeatProblem still()
{
    HeatProblem problem;
    HeatSegment segment;
    segment.duration = 100;
    segment.ambient = steady(290);
    problem.segments = {segment};
    return problem;
}

/// K and M of a machine of steel, with the laws of the problem.
struct Matrices {
    Matrices(const Discretisation& space, HeatProblem input, std::vector<Material> given)
        : problem(std::move(input)), materials(std::move(given)), matrices(space, materials, problem)
    {
        matrices.set_laws(problem.interfaces);
        k = dense(matrices.stiffness());
        m = dense(matrices.mass());
    }
    Matrices(const Discretisation& space, const HeatProblem& input)
        : Matrices(space, input, std::vector<Material>(space.machine.parts.size(), bricks::steel()))
    {}
    HeatProblem problem;
    std::vector<Material> materials;
    HeatMatrices matrices;
    Eigen::MatrixXd k, m;
};

SurfaceCondition film(int surface, double coefficient)
{
    SurfaceCondition condition;
    condition.name = "film";
    condition.surface = surface;
    condition.coefficient = coefficient;
    return condition;
}

InterfaceLaw joint(double film_a, double film_b, double oil)
{
    InterfaceLaw law;
    law.film_a = film_a;
    law.film_b = film_b;
    law.oil = oil;
    law.oil_temperature = 300;
    return law;
}

}  // namespace

TEST_CASE("one cube: entries as on paper")
{
    constexpr double h = 0.2;
    const bricks::Space cube(Brick{{0, 0, 0}, {h, h, h}, {1, 1, 1}, false, {}}, 1);
    const Matrices at(cube.space, still());
    const auto places = cube.space.support_points();
    for (Eigen::Index i = 0; i < 8; ++i)
        for (Eigen::Index j = 0; j < 8; ++j) {
            const Vec3 apart = places[static_cast<std::size_t>(i)] - places[static_cast<std::size_t>(j)];
            const auto edges = std::lround(dot(apart, apart) / (h * h));  // 0, 1, 2 or 3 between two corners
            const double mass = 7800 * 500 * h * h * h / 27 / std::pow(2.0, static_cast<double>(edges));
            CHECK(at.m(i, j) == near(mass, 1e-13));
            // k h (1/3, 0, -1/12, -1/12): products of the line's 1 / h (1 -1) and h / 6 (2 1).
            const std::array<double, 4> share{1 / 3.0, 0, -1 / 12.0, -1 / 12.0};
            CHECK(std::abs(at.k(i, j) - 45 * h * share[static_cast<std::size_t>(edges)]) < 1e-13 * 45 * h);
        }
}

TEST_CASE("the mass of polynomials of the elements' order is their integral")
{
    for (const bool tetrahedra : {false, true})
        for (const int order : {1, 2}) {
            auto brick = box;
            brick.tetrahedra = tetrahedra;
            const bricks::Space part(brick, order);
            const Matrices at(part.space, still());
            const auto one = column(part.space, [](const Vec3&) { return 1.0; });
            const auto x = column(part.space, [](const Vec3& p) { return p[0]; });
            const auto z = column(part.space, [](const Vec3& p) { return p[2]; });
            const double c = 7800 * 500 * volume;
            CHECK(one.dot(at.m * one) == near(c, 1e-12));
            CHECK(x.dot(at.m * x) == near(c * 0.36 / 3, 1e-12));
            CHECK(x.dot(at.m * z) == near(c * 0.3 * 0.25, 1e-12));
            if (order == 2) {
                const auto square = column(part.space, [](const Vec3& p) { return p[0] * p[0]; });
                CHECK(square.dot(at.m * z) == near(c * 0.12 * 0.25, 1e-12));
                CHECK(square.dot(at.m * square) == near(c * std::pow(0.6, 4) / 5, 1e-12));
            }
        }
}

TEST_CASE("conduction of polynomials of the elements' order is the integral of k grad . grad")
{
    for (const bool tetrahedra : {false, true})
        for (const int order : {1, 2}) {
            auto brick = box;
            brick.tetrahedra = tetrahedra;
            const bricks::Space part(brick, order);
            const Matrices at(part.space, still());
            const auto f = column(part.space, [](const Vec3& p) { return 2 * p[0] - 3 * p[1] + p[2]; });
            const auto g = column(part.space, [](const Vec3& p) { return p[0] + p[2]; });
            CHECK(f.dot(at.k * f) == near(45 * volume * 14, 1e-12));
            CHECK(f.dot(at.k * g) == near(45 * volume * 3, 1e-12));
            CHECK((at.k - at.k.transpose()).norm() < 1e-14 * at.k.norm());
            CHECK((at.k * Eigen::VectorXd::Ones(at.k.rows())).norm() < 1e-13 * at.k.norm());
            if (order == 2) {
                const auto square = column(part.space, [](const Vec3& p) { return p[0] * p[0] + p[1] * p[2]; });
                const double mean = 4 * 0.36 / 3 + 0.25 / 3 + 0.16 / 3;  // of 4 x^2 + z^2 + y^2
                CHECK(square.dot(at.k * square) == near(45 * volume * mean, 1e-12));
            }
        }
}

TEST_CASE("a film adds the integral of h T^2 over its surface, by the share that is exposed")
{
    auto machine = bricks::machine_of({box});
    const int whole = bricks::add_surface(machine, 0, 0, true), half = bricks::add_surface(machine, 0, 2, false, 0.5);
    const bricks::Space part(machine, {2});
    auto problem = still();
    problem.surfaces = {film(whole, 20), film(half, 8)};
    const Matrices with(part.space, problem), without(part.space, still());
    const auto y = column(part.space, [](const Vec3& p) { return p[1] * p[1] + p[2]; });
    // Over y = 0..0.4, z = 0..0.5 at x = 0.6; and over x = 0..0.6, y = 0..0.4 at z = 0.
    const double first = 0.5 * std::pow(0.4, 5) / 5 + 2 * std::pow(0.4, 3) / 3 * 0.125 + 0.4 * 0.125 / 3;
    const double second = 0.6 * std::pow(0.4, 5) / 5;
    CHECK(y.dot((with.k - without.k) * y) == near(20 * first + 0.5 * 8 * second, 1e-11));
}

TEST_CASE("a bond between meshes that do not match passes fields whose flux is continuous, and warms none")
{
    auto machine = bricks::machine_of(
        {{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, false, {}}, {{0, 0, 1}, {1, 1, 1.5}, {3, 1, 1}, false, {}}});
    machine.bonds = {bricks::contact(machine, 0, 1, 2)};
    for (const auto& orders : {std::vector<int>{1, 1}, std::vector<int>{2, 1}, std::vector<int>{2, 2}}) {
        const bricks::Space both(machine, orders);
        auto copper = bricks::steel();
        copper.conductivity = 300;
        const Matrices at(both.space, still(), {bricks::steel(), copper});
        CHECK((at.k - at.k.transpose()).norm() < 1e-13 * at.k.norm());
        // z / k on either side of z = 1: the same flux everywhere, so nothing remains but at both ends.
        const auto field =
            column(both.space, [](const Vec3& p) { return p[2] < 1 ? p[2] / 45 : 1 / 45.0 + (p[2] - 1) / 300; });
        // At z = 1 both sides have 1 / 45.
        const Eigen::VectorXd residual = at.k * field;
        const auto places = both.space.support_points();
        double in = 0, out = 0;
        for (std::size_t i = 0; i < places.size(); ++i) {
            const double r = residual[static_cast<Eigen::Index>(i)];
            if (places[i][2] < 1e-9)
                in += r;
            else if (places[i][2] > 1.5 - 1e-9)
                out += r;
            else
                CHECK(std::abs(r) < 1e-12);
        }
        CHECK(in == near(-1, 1e-12));  // 1 W/m2 over 1 m2
        CHECK(out == near(1, 1e-12));
        // No field but a constant conducts nothing: symmetric and, by the penalty, positive.
        const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> modes(at.k);
        CHECK(std::abs(modes.eigenvalues()[0]) < 1e-11 * modes.eigenvalues().maxCoeff());
        CHECK(modes.eigenvalues()[1] > 1e-4 * modes.eigenvalues().maxCoeff());
    }
}

TEST_CASE("where the conductivity follows the temperature its part has a matrix of its own")
{
    auto machine = bricks::machine_of(
        {{{0, 0, 0}, {1, 1, 1}, {1, 1, 1}, false, {}}, {{2, 0, 0}, {3, 1, 1}, {1, 1, 1}, false, {}}});
    const bricks::Space both(machine, {1, 1});
    auto iron = bricks::steel();
    iron.conductivity_table = LinearCurve({290, 400}, {45, 60});
    const Matrices at(both.space, still(), {bricks::steel(), iron}), constant(both.space, still());
    CHECK(constant.matrices.conduction() == nullptr);
    REQUIRE(at.matrices.conduction() != nullptr);
    const auto variable = dense(at.matrices.conduction());
    CHECK((at.k + variable - constant.k).norm() < 1e-13 * constant.k.norm());
    const auto parts = both.space.part_of_unknown();
    for (Eigen::Index i = 0; i < variable.rows(); ++i)
        CHECK((parts[static_cast<std::size_t>(i)] == 0 ? variable.row(i).norm() == 0 : at.k.row(i).norm() == 0));
}

TEST_CASE("other laws change the matrix by their terms alone, and come back to the bit")
{
    auto machine = bricks::machine_of(
        {{{0, 0, 0}, {1, 1, 1}, {2, 1, 1}, false, {}}, {{0, 0, 1}, {1, 1, 2}, {1, 2, 1}, false, {}}});
    machine.interfaces = {bricks::contact(machine, 0, 1, 2)};
    const bricks::Space both(machine, {1, 1});
    auto problem = still();
    problem.interfaces = {joint(300, 200, 0)};
    Matrices at(both.space, problem);
    CHECK(at.matrices.integrations() == 1);
    CHECK_FALSE(at.matrices.set_laws(problem.interfaces));  // nothing to do
    CHECK(at.matrices.set_laws({joint(700, 900, 50)}));
    const auto other = dense(at.matrices.stiffness());
    auto wanted = problem;
    wanted.interfaces = {joint(700, 900, 50)};
    const Matrices direct(both.space, wanted);
    CHECK((other - direct.k).norm() < 1e-14 * direct.k.norm());
    CHECK((other - at.k).norm() > 0.1 * at.k.norm());
    CHECK(at.matrices.set_laws(problem.interfaces));
    CHECK((dense(at.matrices.stiffness()) - at.k).norm() < 1e-14 * at.k.norm());
    CHECK(at.matrices.integrations() == 2);  // K_solid was not kept for one law; it is from then on
}

namespace {

/// Two bricks with a joint and a film, in segments of given joint laws and one duration.
struct Rubbing {
    explicit Rubbing(std::size_t segments, double film_coefficient = 15)
    {
        problem = still();
        problem.surfaces = {film(0, film_coefficient)};
        problem.interfaces = {joint(400, 500, 80)};
        problem.interfaces[0].source = 0;
        problem.sources = {{"pin", 1, {}, {}}};
        problem.fixed_step = 50;
        problem.segments.assign(segments, problem.segments[0]);
        for (std::size_t k = 0; k < segments; ++k) {
            auto& segment = problem.segments[k];
            const double speed = 1 + 0.3 * static_cast<double>(k);
            segment.heat = {LawTable([speed](double) { return LawValue{100 * speed, 0, true}; })};
            segment.interfaces = problem.interfaces;  // conductance and oil follow the speed
            segment.interfaces[0].film_a *= std::pow(speed, 0.6);
            segment.interfaces[0].oil *= std::sqrt(speed);
        }
    }
    static Machine machine()
    {
        auto result = bricks::machine_of(
            {{{0, 0, 0}, {1, 1, 1}, {2, 1, 1}, false, {}}, {{0, 0, 1}, {1, 1, 2}, {1, 2, 1}, false, {}}});
        result.interfaces = {bricks::contact(result, 0, 1, 2)};
        bricks::add_surface(result, 1, 2, true);
        return result;
    }
    HeatProblem problem;
};

/// Runs a problem on a system; its mean temperature of part 0 at the end.
double run(HeatSystem& system, const HeatProblem& problem)
{
    heat::HeatRun<HeatSystem> solved(system, problem);
    DEADPOINT_PETSC(VecSet(solved.temperature(), 290));
    solved.set_media({}, {});
    Observer observer;
    solved.begin();
    return solved.go({}, observer).part_means[0].value.back();
}

}  // namespace

TEST_CASE("ten segments of different speed integrate no more cells than one")
{
    const bricks::Space both(Rubbing::machine(), {1, 1});
    const std::vector<Material> materials(2, bricks::steel());
    const Rubbing one(1), ten(10);
    HeatSystem brief(both.space, materials, one.problem), longer(both.space, materials, ten.problem);
    run(brief, one.problem);
    CHECK(brief.integrations() == 1);
    const double end = run(longer, ten.problem);
    CHECK(longer.integrations() == 1);
    // The laws of the segments were used, though: with those of the first one alone the end is another.
    auto alike = ten;
    for (auto& segment : alike.problem.segments)
        segment.interfaces = alike.problem.segments[0].interfaces;
    HeatSystem other(both.space, materials, alike.problem);
    CHECK(std::abs(run(other, alike.problem) - end) > 1e-4);
}

TEST_CASE("from point to point of a sweep, films, conductances and oil integrate no cell again; a conductivity does")
{
    const bricks::Space both(Rubbing::machine(), {1, 1});
    const std::vector<Material> materials(2, bricks::steel());
    const Rubbing first(10);
    HeatSystem system(both.space, materials, first.problem);
    run(system, first.problem);
    std::vector<Rubbing> points;
    for (const double coefficient : {5.0, 30.0, 80.0})
        points.emplace_back(10, coefficient);
    for (auto& segment : points[1].problem.segments)
        segment.interfaces[0].film_b *= 3;
    for (auto& segment : points[2].problem.segments)
        segment.interfaces[0].oil = 700;
    int all = system.integrations();
    for (const auto& point : points) {
        REQUIRE(system.adopt(point.problem));
        const double got = run(system, point.problem);
        CHECK(system.integrations() == 1);
        // A system made for this point alone agrees: the new coefficients are in.
        HeatSystem alone(both.space, materials, point.problem);
        CHECK(got == near(run(alone, point.problem), 1e-10));  // both to 1e-9 K
    }
    CHECK(system.integrations() == all);
    // Another conductivity takes another system, which integrates its cells.
    auto better = materials;
    better[0].conductivity *= 2;
    HeatSystem other(both.space, better, first.problem);
    all += other.integrations();
    CHECK(all == 2);
    CHECK(std::abs(run(other, first.problem) - run(system, points[2].problem)) > 1e-6);
}

TEST_CASE("a system made for one law integrates once more for the first other one, and never again")
{
    const bricks::Space both(Rubbing::machine(), {1, 1});
    const std::vector<Material> materials(2, bricks::steel());
    const Rubbing one(1), ten(10), more(7, 3);
    HeatSystem system(both.space, materials, one.problem);
    run(system, one.problem);
    CHECK(system.integrations() == 1);
    for (const auto* problem : {&ten.problem, &more.problem, &one.problem}) {
        REQUIRE(system.adopt(*problem));
        run(system, *problem);
        CHECK(system.integrations() == 2);
    }
}

TEST_CASE("what the matrices were not integrated for is not adopted")
{
    const bricks::Space both(Rubbing::machine(), {1, 1});
    const std::vector<Material> materials(2, bricks::steel());
    const Rubbing one(1);
    HeatSystem system(both.space, materials, one.problem);
    auto turning = one.problem;
    turning.segments[0].interfaces[0].turns_fully = true;
    CHECK_FALSE(system.adopt(turning));
    auto radiating = one.problem;
    radiating.surfaces[0].emissivity = 0.5;
    CHECK_FALSE(system.adopt(radiating));
    auto flux = one.problem;
    flux.surfaces[0].kind = SurfaceCondition::Kind::flux;
    CHECK_FALSE(system.adopt(flux));
    auto heated = one.problem;
    heated.body_heat = {{"motor", {0}, -1}};
    CHECK_FALSE(system.adopt(heated));
    CHECK(system.adopt(one.problem));
}
