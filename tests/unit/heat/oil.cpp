#include "deadpoint/exchange/machine.hpp"
#include "lumps.hpp"
#include "near.hpp"

#include <cmath>
#include <doctest/doctest.h>

using namespace deadpoint;
using lumps::steady;

namespace {

/// Two joints in series of one circuit: lumps 0-1 and 2-3 with films of 500 W/m2/K on 0.2 m2 and oil of 400 W/m2/K.
HeatProblem two_joints(bool cooled)
{
    HeatProblem problem;
    InterfaceLaw law;
    law.film_a = law.film_b = 500;
    law.oil = 400;
    law.oil_temperature = 300;
    problem.interfaces = {law, law};
    OilCourse circuit;
    circuit.name = "main";
    circuit.joints = {{0}, {1}};
    circuit.cooled = cooled;
    circuit.inlet_temperature = 303;
    circuit.sump_capacity = 20'000;
    circuit.sump_loss = 15;
    circuit.sump_start = 300;
    problem.oil = {circuit};
    problem.segments = {lumps::segment(problem, 4000, 290)};
    problem.segments[0].oil_flow = {60};
    return problem;
}

lumps::Machine four_lumps() { return {{1e5, 1e5, 2e5, 2e5}, {}, {{0, 1, 0.2}, {2, 3, 0.2}}, {}, {0}}; }

}  // namespace

TEST_CASE("oil in series: each joint warms what reaches the next, as a chain of heat exchangers")
{
    const auto problem = two_joints(true);
    lumps::Run run(four_lumps(), problem, 350);
    run.run.begin();
    // All solids at 350 K: a joint's film conducts U A = 0.2 x 400 x 1000 / 1400 W/K between solids and oil.
    const double exchange = 0.2 * 400 * 1000 / 1400.0, flow = 60;
    const double first = exchange * (350 - 303), reaches_second = 303 + first / flow;
    const double second = exchange * (350 - reaches_second);
    const auto& oil = run.run.history().oil[0];
    CHECK(oil.outlet.value[0] == near(reaches_second + second / flow, 1e-12));
    CHECK(oil.heat[0] == near(first + second, 1e-11));  // settled to 1e-9 K
}

TEST_CASE("a sump that feeds the joints itself: energy closes, and the steady state is that of the balance")
{
    auto problem = two_joints(false);
    problem.time_tolerance = 1e-4;
    problem.segments[0].duration = 2e6;  // 48 time constants of 6.2e5 J/K over 15 W/K
    lumps::Run run(four_lumps(), problem, 350);
    const auto& history = run.go();
    CHECK(history.oil[0].sump.value.back() == near(290, 1e-6));  // all cools to the ambient
    CHECK(history.energy.mismatch() < 1e-10);                    // of 4e7 J: rounding of the sums
}

TEST_CASE("a sump and two lumps against the matrix exponential: within the time tolerance, and second order")
{
    // With one joint of equal sides the film lies between: lumps a, b (equal) and sump s are two unknowns.
    HeatProblem problem;
    InterfaceLaw law;
    law.film_a = law.film_b = 500;
    law.oil = 400;
    law.oil_temperature = 300;
    problem.interfaces = {law};
    OilCourse circuit;
    circuit.name = "main";
    circuit.joints = {{0}};
    circuit.cooled = false;
    circuit.sump_capacity = 20'000;
    circuit.sump_loss = 15;
    circuit.sump_start = 300;
    problem.oil = {circuit};
    problem.segments = {lumps::segment(problem, 3000, 290)};
    problem.segments[0].oil_flow = {60};
    const double exchange = 0.2 * 400 * 1000 / 1400.0;
    Eigen::Matrix2d rates;  // of lumps (2 x 1e5 J/K together) and sump
    rates << -exchange / 2e5, exchange / 2e5, exchange / 2e4, -(exchange + 15) / 2e4;
    const Eigen::EigenSolver<Eigen::Matrix2d> modes(rates);
    const Eigen::Matrix2cd shapes = modes.eigenvectors();
    const Eigen::Vector2d start(350 - 290, 300 - 290);
    const Eigen::Vector2cd factors = (modes.eigenvalues() * 3000.0).array().exp();
    const Eigen::Vector2d exact =
        (shapes * factors.asDiagonal() * shapes.inverse() * start.cast<std::complex<double>>()).real();

    const auto sump_error = [&](double fixed_step) {
        problem.fixed_step = fixed_step;
        lumps::Run run({{1e5, 1e5}, {}, {{0, 1, 0.2}}, {}, {0}}, problem, 350);
        return run.go().oil[0].sump.value.back() - 290 - exact[1];
    };
    const double order = std::log2(sump_error(200) / sump_error(100));
    CHECK(order == near(2, 0.05));

    problem.fixed_step = 0;
    problem.time_tolerance = 0.002;
    lumps::Run run({{1e5, 1e5}, {}, {{0, 1, 0.2}}, {}, {0}}, problem, 350);
    const auto& history = run.go();
    CHECK(std::abs(history.oil[0].sump.value.back() - 290 - exact[1]) < 0.002);
    CHECK(std::abs(history.probes[0].value.back() - 290 - exact[0]) < 0.002);
}
