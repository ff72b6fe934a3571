/// Requirement: a stage's solution meets the stage's equation with the laws as booked, and what cannot be solved ends
/// with an error that names the cause.
#include "deadpoint/heat/stage_solver.hpp"

#include "lumps.hpp"
#include "near.hpp"

#include <cmath>
#include <doctest/doctest.h>

using namespace deadpoint;
using namespace deadpoint::heat;

namespace {

using System = lumps::DenseSystem;

HeatProblem rubbing(const LawTable& law)
{
    HeatProblem problem;
    InterfaceLaw film;
    film.film_a = 800;
    film.film_b = 400;
    film.source = 0;
    problem.interfaces = {film};
    problem.sources = {{"pin", 1, {}, {}}};
    problem.surfaces = {lumps::film(15)};
    problem.segments = {lumps::segment(problem, 1e4, 290)};
    problem.segments[0].heat[0] = law;
    return problem;
}

struct Stage {
    explicit Stage(HeatProblem input)
        : problem(std::move(input)), system(lumps::terms_of(machine, problem), problem), sources(system, problem),
          stages(system, sources), temperature(system.make_vector()), stored(system.make_vector())
    {
        sources.enter(problem.segments[0]);
        temperature = 300 * system.parts().uniform;
        system.store(temperature, stages.known);
    }
    Rate<Eigen::VectorXd> solve(double factor) { return stages.solve(5, factor, {}, temperature, stored); }
    /// M T + factor (K T - sources(T)) - known, sources as the laws are.
    Eigen::VectorXd residual(double factor)
    {
        Eigen::VectorXd mass(2), conducted(2);
        system.store(temperature, mass);
        system.conduct(temperature, conducted);
        return mass + factor * (conducted - sources.at(5, temperature).watts) - stages.known;
    }
    /// Temperatures of the lumps [K].
    [[nodiscard]] Eigen::VectorXd lumps() const { return lumps::temperatures_of(machine, temperature); }
    lumps::Machine machine{{2e3, 5e3}, {}, {{0, 1, 0.1}}, {{1, 0.5}}, {0}};
    HeatProblem problem;
    System system;
    HeatSources<System> sources;
    StageSolver<System> stages;
    Eigen::VectorXd temperature, stored;
};

LawTable straight()
{
    return LawTable([](double t) { return LawValue{900 - 4 * (t - 290), -4, true}; });
}
LawTable bent()
{
    return LawTable([](double t) {
        const double heat = 900 * std::exp(-0.02 * (t - 290));
        return LawValue{heat, -0.02 * heat, true};
    });
}
LawTable rising()
{
    return LawTable([](double t) { return LawValue{200 + 3 * (t - 290), 3, true}; });
}

}  // namespace

TEST_CASE("a straight law is solved in one linear solve, exactly")
{
    for (const auto& law : {straight(), rising()})
        for (const double factor : {0.5, 50.0, 5e4}) {
            Stage at(rubbing(law));
            at.solve(factor);
            CHECK(at.stages.solves == 1);
            CHECK(at.residual(factor).norm() < 1e-11 * at.stages.known.norm());
        }
}

TEST_CASE("a bent law is solved until its tangent is the law, to a hundred-thousandth of its heat")
{
    for (const double factor : {0.5, 50.0, 5e4}) {
        Stage at(rubbing(bent()));
        const auto rate = at.solve(factor);
        const double heat = at.sources.at(5, at.temperature).balance.source_heat[0];
        CHECK(at.stages.solves <= 6);
        CHECK(std::abs(rate.balance.source_heat[0] - heat) <= 1e-5 * heat);
        CHECK(at.residual(factor).norm() <= 1.1e-5 * factor * heat + 1e-11 * at.stages.known.norm());
    }
}

TEST_CASE("what is booked closes the stage's balance to rounding, bent law or not")
{
    for (const double factor : {5.0, 5e3}) {
        Stage at(rubbing(bent()));
        const auto rate = at.solve(factor);
        const double stored = lumps::watts_of(at.machine, at.stored - at.stages.known).sum();
        CHECK(stored == near(factor * (rate.balance.generated - rate.balance.to_air), 1e-10));
    }
}

TEST_CASE("the rate of a stage is (stored - known) / factor, and is the watts less what is conducted")
{
    Stage at(rubbing(bent()));
    const double factor = 40;
    const auto rate = at.solve(factor);
    CHECK((rate.watts - (at.stored - at.stages.known) / factor).norm() < 1e-12 * rate.watts.norm());
    Eigen::VectorXd conducted(2);
    at.system.conduct(at.temperature, conducted);
    const auto law = at.sources.at(5, at.temperature);
    CHECK((rate.watts - (law.watts - conducted)).norm() < 1e-4 * rate.watts.norm());  // the law's curvature
}

TEST_CASE("a stage of no length keeps the temperature, a long one ends where heat and losses agree")
{
    Stage still(rubbing(straight()));
    still.solve(1e-12);
    CHECK((still.lumps() - Eigen::Vector2d::Constant(300)).norm() < 1e-9);
    Stage at(rubbing(straight()));
    at.solve(1e12);
    // 7.5 W/K to air of 290 K; lump 0 is at the film's temperature then: nothing goes through it.
    const double film_over_lump = 1 / (0.1 * 400);  // per watt into lump 1
    // H = 900 - 4 (T + H / 40 - 290) and H = 7.5 (T - 290)
    const double rise = 900 / (7.5 + 4 * (1 + 7.5 * film_over_lump));
    CHECK(at.lumps()[1] == near(290 + rise, 1e-8));
    CHECK(at.lumps()[0] == near(290 + rise + 7.5 * rise * film_over_lump, 1e-8));
}

TEST_CASE("a film that follows the temperature is iterated until nothing moves")
{
    auto problem = rubbing(straight());
    problem.surfaces[0].emissivity = 0.9;
    Stage at(problem);
    at.solve(500);
    CHECK(at.stages.solves > 1);
    CHECK(at.residual(500).norm() < 1e-6 * 500);  // change below 1e-7 K times some W/K
}

TEST_CASE("a factor's matrix is built once, and the origin of a preconditioner is told")
{
    Stage at(rubbing(straight()));
    CHECK(at.stages.origin().factor < 0);
    at.solve(50);
    CHECK(at.stages.origin().factor == 50);
    CHECK(at.stages.origin().segment == 0);
    CHECK(at.stages.origin().time == 5);
    at.stages.set_origin({3, 7, 11, {290}});
    CHECK(at.stages.origin().time == 7);
    CHECK(at.stages.origin().air == std::vector<double>{290});
    at.solve(50);  // the same matrix serves
    CHECK(at.stages.origin().time == 7);
}

TEST_CASE("linear solves with the sources' slopes are those of the dense matrix")
{
    Stage at(rubbing(straight()));
    at.stages.build(5, 30, at.temperature);
    at.stages.set_source_slopes({-4});
    const Eigen::VectorXd right = Eigen::Vector2d(700, -200);
    Eigen::VectorXd solution(2);
    at.stages.solve_linear(lumps::loads_of(at.machine, right), solution, {1e-13, 0}, "a test");
    // Coefficients of films of 800 and 400 W/m2/K, 0.1 m2: h_a h_b / S = 266.7, and a film of 7.5 W/K.
    const double between = 0.1 * 800 * 400 / 1200.0;
    Eigen::Matrix2d k;
    k << between, -between, -between, between + 7.5;
    const Eigen::Vector2d load(800 / 1200.0, 400 / 1200.0);
    const Eigen::Matrix2d matrix =
        Eigen::Matrix2d(Eigen::Vector2d(2e3, 5e3).asDiagonal()) + 30 * k + 30 * 4 * load * load.transpose();
    CHECK((matrix * lumps::temperatures_of(at.machine, solution) - right).norm() < 1e-12 * right.norm());
    CHECK(at.stages.iterations > 0);
}

TEST_CASE("enclosed air is solved with the stage: its own equation holds at the end")
{
    auto problem = rubbing(straight());
    problem.surfaces[0].enclosure = 0;
    problem.enclosures = {{"cabin", 3000, 4, 295}};
    problem.segments[0].enclosure_power = {lumps::steady(30)};
    Stage at(problem);
    at.sources.air.start_from({295});
    auto start = at.sources.at(0, at.temperature);
    const double dt = 100, factor = diagonal * dt;
    at.sources.air.begin_first_stage(dt, false, start.balance);
    const auto rate = at.solve(factor);
    const double now = at.sources.air.temperatures()[0];
    const double kept = 7.5 * (at.lumps()[1] - now) + 30 - 4 * (now - 290);
    CHECK(3000 * (now - 295) == near(factor * (start.balance.air[0].kept() + kept), 1e-10));
    CHECK(rate.balance.air[0].kept() == near(kept, 1e-10));
}

TEST_CASE("a matrix that is not finite ends with the largest term of the balance")
{
    auto problem = rubbing(straight());
    problem.surfaces[0].name = "front";
    problem.surfaces[0].coefficient = 1e308;
    Stage at(problem);
    CHECK_THROWS_WITH_AS(at.solve(1e6), doctest::Contains("surfaces.front: 1e+308 W/m2/K"), DomainError);
}

TEST_CASE("heat that is not finite ends with an error that tells the time")
{
    auto problem = rubbing({});
    problem.body_heat = {{"motor", {0}, -1}};
    problem.segments[0].body_heat = {[](double) { return std::nan(""); }};
    Stage at(problem);
    CHECK_THROWS_WITH_AS(at.solve(50), doctest::Contains("t = 5"), DomainError);
}

TEST_CASE("a law that jumps has no solution, and the error says what to smooth")
{
    auto problem = rubbing(LawTable([](double t) { return LawValue{t < 300.5 ? 1e4 : 0, 0, true}; }));
    problem.interfaces[0].heat_part = 0;
    Stage at(problem);
    CHECK_THROWS_WITH_AS(at.solve(1), doctest::Contains("smooth it or shorten max_step"), ConvergenceError);
}
