#include "deadpoint/error.hpp"
#include "deadpoint/exchange/machine.hpp"
#include "deadpoint/heat/tr_bdf2.hpp"
#include "lumps.hpp"
#include "near.hpp"

#include <cmath>
#include <doctest/doctest.h>

using namespace deadpoint;
using lumps::steady;

namespace {

/// A hot lump (0) linked to a cold one (1) that gives heat to air of 290 K; a motor of 100 W in lump 0.
HeatProblem motor(double duration)
{
    HeatProblem problem;
    problem.body_heat = {{"motor", {0}, -1}};
    problem.surfaces = {lumps::film(20)};
    problem.segments = {lumps::segment(problem, duration, 290)};
    problem.segments[0].body_heat[0] = steady(100);
    return problem;
}
lumps::Machine two_lumps() { return {{2e4, 5e4}, {{0, 1, 30}}, {}, {{1, 0.5}}, {0, 1}}; }

/// Temperatures of motor() after a time, by the matrix exponential.
Eigen::Vector2d exact(double time, double start)
{
    Eigen::Matrix2d rates;
    rates << -30 / 2e4, 30 / 2e4, 30 / 5e4, -(30 + 10) / 5e4;
    const Eigen::Vector2d end(290 + 10 + 100 / 30.0, 290 + 10);  // 100 W over 10 W/K, and over 30 W/K
    const Eigen::EigenSolver<Eigen::Matrix2d> modes(rates);
    const Eigen::Matrix2cd shapes = modes.eigenvectors();
    const Eigen::Vector2cd factors = (modes.eigenvalues() * time).array().exp();
    const Eigen::Vector2cd away = (Eigen::Vector2d(start, start) - end).cast<std::complex<double>>();
    return end + (shapes * factors.asDiagonal() * shapes.inverse() * away).real();
}

double error_with_step(double step)
{
    auto problem = motor(2000);
    problem.fixed_step = step;
    lumps::Run run(two_lumps(), problem, 290);
    run.go();
    return (run.temperatures() - exact(2000, 290)).norm();
}

}  // namespace

TEST_CASE("the integrator is of second order in time on a dense system")
{
    const double order = std::log2(error_with_step(200) / error_with_step(100));
    const double finer = std::log2(error_with_step(100) / error_with_step(50));
    CHECK(order == near(2, 0.05));
    CHECK(finer == near(2, 0.03));
}

TEST_CASE("step control keeps the tolerance, and the balance closes to rounding")
{
    auto problem = motor(2e4);
    for (const double tolerance : {0.1, 0.01, 0.001}) {
        problem.time_tolerance = tolerance;
        lumps::Run run(two_lumps(), problem, 290);
        const auto& history = run.go();
        CHECK((run.temperatures() - exact(2e4, 290)).lpNorm<Eigen::Infinity>() < tolerance);
        CHECK(history.energy.mismatch() < 1e-12);
    }
}

TEST_CASE("a step's size factor: a power of two, from the cube root of tolerance over error")
{
    using heat::step_size_factor;
    CHECK(step_size_factor(1e-3, 1e-3, 0, 1) == 0.5 * 2 * 1.0);        // 0.9 < 1: stays
    CHECK(step_size_factor(1e-3 / 12, 1e-3, 0, 1) == 2);               // 0.9 x 12^(1/3) = 2.06
    CHECK(step_size_factor(1e-3 / 10, 1e-3, 0, 1) == 1);               // 1.94
    CHECK(step_size_factor(8e-3, 1e-3, -20, -1) == near(0.25, 1e-5));  // 0.45
    CHECK(step_size_factor(0, 1e-3, 0, 1) == 2);                       // no error at all
    CHECK(heat::fit_step(10, 25) == 10);
    CHECK(heat::fit_step(10, 15) == 7.5);
    CHECK(heat::fit_step(10, 10) == 10);
    CHECK(heat::fit_step(10, 3) == 3);
}

TEST_CASE("falling joint heat: one linear solve a stage books its tangent, and the balance closes")
{
    HeatProblem problem;
    InterfaceLaw law;
    law.film_a = law.film_b = 800;
    law.source = 0;
    problem.interfaces = {law};
    problem.sources = {{"pin", 1, {}, {}}};
    problem.surfaces = {lumps::film(15)};
    problem.segments = {lumps::segment(problem, 2e4, 290)};
    problem.segments[0].heat[0] = [](double t) {
        const double heat = 300 * std::exp(-0.02 * (t - 290));
        return LawValue{heat, -0.02 * heat, true};
    };
    problem.time_tolerance = 0.001;
    lumps::Run run({{2e4, 5e4}, {}, {{0, 1, 0.1}}, {{1, 0.5}}, {0, 1}}, problem, 290);
    const auto& history = run.go();
    CHECK(history.energy.mismatch() < 1e-12);
    // Steady: heat(film) leaves by 7.5 W/K; lumps and film are apart by what flows. Solved by bisection.
    double low = 290, high = 400;
    for (int i = 0; i < 100; ++i) {
        const double body = (low + high) / 2, heat = 7.5 * (body - 290);
        const double film = body + heat / (0.1 * 800);  // lump 0 takes nothing in the end
        (300 * std::exp(-0.02 * (film - 290)) > heat ? low : high) = body;
    }
    lumps::Run longer({{2e4, 5e4}, {}, {{0, 1, 0.1}}, {{1, 0.5}}, {0, 1}}, problem, 290);
    problem.segments[0].duration = 4e5;
    CHECK(longer.go().probes[1].value.back() == near(low, 1e-6));
}

TEST_CASE("a law that jumps under the temperature ends with an error that names the remedy")
{
    HeatProblem problem;
    InterfaceLaw law;
    law.film_a = law.film_b = 800;
    law.source = 0;
    law.heat_part = 0;  // at the temperature of the lump itself
    problem.interfaces = {law};
    problem.sources = {{"pin", 1, {}, {}}};
    problem.segments = {lumps::segment(problem, 2e4, 290)};
    problem.segments[0].heat[0] = [](double t) { return LawValue{t < 291 ? 1e4 : 0, 0, true}; };
    lumps::Run run({{2e3, 5e3}, {}, {{0, 1, 0.1}}, {}, {0}}, problem, 290);
    CHECK_THROWS_AS(run.go(), ConvergenceError);
}

TEST_CASE("enclosed air between two walls against the matrix exponential")
{
    HeatProblem problem;
    problem.surfaces = {lumps::film(10), lumps::film(6)};
    problem.surfaces[0].enclosure = problem.surfaces[1].enclosure = 0;
    problem.enclosures = {{"cabin", 3000, 4, 295}};
    problem.segments = {lumps::segment(problem, 5000, 290)};
    problem.segments[0].enclosure_power = {steady(50)};
    problem.time_tolerance = 0.001;
    lumps::Run run({{2e4, 3e4}, {}, {}, {{0, 2.0}, {1, 1.5}}, {0, 1}}, problem, 310);
    const auto& history = run.go();
    Eigen::Matrix3d rates;  // lumps of 20 and 9 W/K to the air, which has 4 W/K to the room
    rates << -20 / 2e4, 0, 20 / 2e4, 0, -9 / 3e4, 9 / 3e4, 20 / 3e3, 9 / 3e3, -(20 + 9 + 4) / 3e3;
    const Eigen::Vector3d end = Eigen::Vector3d::Constant(290 + 50 / 4.0), start(310, 310, 295);
    const Eigen::EigenSolver<Eigen::Matrix3d> modes(rates);
    const Eigen::Matrix3cd shapes = modes.eigenvectors();
    const Eigen::Vector3cd factors = (modes.eigenvalues() * 5000.0).array().exp();
    const Eigen::Vector3d exact_end =
        end + (shapes * factors.asDiagonal() * shapes.inverse() * (start - end).cast<std::complex<double>>()).real();
    CHECK(std::abs(history.probes[0].value.back() - exact_end[0]) < 0.001);
    CHECK(std::abs(history.probes[1].value.back() - exact_end[1]) < 0.001);
    CHECK(std::abs(history.enclosures[0].temperature.value.back() - exact_end[2]) < 0.001);
    CHECK(history.energy.mismatch() < 1e-12);
}

TEST_CASE("a lump that radiates cools as on paper")
{
    // C dT/dt = -eps sigma A (T^4 - 0) from 600 K: T^-3 grows by 3 eps sigma A / C a second.
    HeatProblem problem;
    problem.surfaces = {lumps::film(0)};
    problem.surfaces[0].emissivity = 0.8;
    problem.segments = {lumps::segment(problem, 2000, 1e-3)};
    problem.time_tolerance = 0.0001;
    lumps::Run run({{5e4}, {}, {}, {{0, 1.0}}, {0}}, problem, 600);
    const double expected = std::pow(std::pow(600.0, -3) + 3 * 0.8 * heat::stefan_boltzmann * 2000 / 5e4, -1 / 3.0);
    // The errors of the steps add up, since a lump that only radiates forgets little of them.
    CHECK(std::abs(run.go().probes[0].value.back() - expected) < 0.001);
}

TEST_CASE("a run that goes on from its state between two steps is the same bit by bit")
{
    HeatProblem problem;
    InterfaceLaw law;
    law.film_a = law.film_b = 800;
    law.oil = 200;
    law.oil_temperature = 300;
    law.source = 0;
    problem.interfaces = {law};
    problem.sources = {{"pin", 1, {}, {}}};
    problem.surfaces = {lumps::film(15), lumps::film(5)};
    problem.surfaces[1].enclosure = 0;
    problem.enclosures = {{"cabin", 3000, 4, 295}};
    OilCourse circuit{"main", {{0}}, false, 0, 2e4, 15, 300};
    problem.oil = {circuit};
    for (const double duration : {3000.0, 4000.0}) {
        problem.segments.push_back(lumps::segment(problem, duration, 290));
        problem.segments.back().oil_flow = {60};
        problem.segments.back().heat[0] = [](double t) { return LawValue{500 - 3 * (t - 290), -3, true}; };
    }
    const lumps::Machine machine{{2e4, 5e4}, {}, {{0, 1, 0.1}}, {{1, 0.5}, {0, 0.3}}, {0, 1}};
    lumps::Run whole(machine, problem, 290), second(machine, problem, 290);

    heat::RunState kept;
    std::vector<Eigen::VectorXd> vectors;
    heat::RunHooks<Eigen::VectorXd> hooks;
    hooks.on_between_steps = [&](bool) {
        if (whole.run.steps().size() != 30)
            return;
        kept = whole.run.state();
        for (const auto* vector : whole.run.vectors())
            vectors.push_back(*vector);
    };
    lumps::Quiet observer;
    whole.run.begin();
    whole.run.go(hooks, observer);
    REQUIRE(vectors.size() == 5);

    second.run.begin();
    REQUIRE(heat::misfit(kept, second.run.state(), problem).empty());
    for (std::size_t k = 0; k < vectors.size(); ++k)
        *second.run.vectors()[k] = vectors[k];
    second.run.restore(kept);
    const auto& resumed = second.run.go({}, observer);
    const auto& history = whole.run.history();
    REQUIRE(resumed.time == history.time);
    CHECK(resumed.probes[0].value == history.probes[0].value);
    CHECK(resumed.oil[0].sump.value == history.oil[0].sump.value);
    CHECK(resumed.enclosures[0].temperature.rate == history.enclosures[0].temperature.rate);
    CHECK(resumed.energy.stored == history.energy.stored);
    CHECK(whole.run.temperature() == second.run.temperature());
}

TEST_CASE("a state of another problem is told from one that fits")
{
    const auto problem = motor(2000);
    lumps::Run run(two_lumps(), problem, 290);
    run.run.begin();
    const auto begun = run.run.state();
    lumps::Quiet observer;
    run.run.go({}, observer);
    auto state = run.run.state();
    CHECK(heat::misfit(state, begun, problem).empty());
    auto other = state;
    other.sumps.push_back(300);
    CHECK(heat::misfit(other, begun, problem) == "its lists are not those of this case");
    other = state;
    other.place.wanted = -1;
    CHECK(heat::misfit(other, begun, problem) == "its times are not those of this case");
    other = state;
    other.history.probes.pop_back();
    CHECK(heat::misfit(other, begun, problem) == "its history is not one of this case");
}
