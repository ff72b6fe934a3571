/// Requirement: a step is TR-BDF2's, its error estimate is of the size of the error, and its fields between the ends
/// are those of a cubic.
#include "deadpoint/heat/stepper.hpp"

#include "lumps.hpp"
#include "near.hpp"

#include <cmath>
#include <doctest/doctest.h>

using namespace deadpoint;
using namespace deadpoint::heat;

namespace {

using System = lumps::DenseSystem;

/// One lump of 1e4 J/K with a film of 10 W/K: T' = -r (T - 290), r = 1e-3 / s; the probe watches it.
HeatProblem cooling()
{
    HeatProblem problem;
    problem.surfaces = {lumps::film(20)};
    problem.body_heat = {{"motor", {0}, -1}};
    problem.segments = {lumps::segment(problem, 1e4, 290)};
    return problem;
}

struct OneLump {
    explicit OneLump(HeatProblem input = cooling())
        : problem(std::move(input)), system(lumps::terms_of({{1e4}, {}, {}, {{0, 0.5}}, {0}}, problem), problem),
          sources(system, problem), stages(system, sources),
          stepper(system, sources, stages, {system.geometry().layout.probe(0)})
    {
        stepper.now().temperature = 330 * system.parts().uniform;
        stepper.begin_segment(problem.segments[0], 0);
    }
    // A state is a hundred times the lump's temperature, a load a hundredth of the watts.
    [[nodiscard]] double now() const { return stepper.now().temperature[0] / 100; }
    [[nodiscard]] double middle() const { return stepper.middle().temperature[0] / 100; }
    [[nodiscard]] double next() const { return stepper.next().temperature[0] / 100; }
    HeatProblem problem;
    System system;
    HeatSources<System> sources;
    StageSolver<System> stages;
    Stepper<System> stepper;
};

double growth(double z)
{
    const double middle = (1 + diagonal * z) / (1 - diagonal * z);
    return (bdf_middle * middle - bdf_now) / (1 - diagonal * z);
}

constexpr double rate = 1e-3;

}  // namespace

TEST_CASE("a step multiplies the distance to the air by TR-BDF2's growth factor")
{
    for (const double dt : {1.0, 100.0, 5000.0, 1e8}) {
        OneLump at;
        at.stepper.step(0, dt);
        CHECK(at.next() - 290 == near(40 * growth(-rate * dt), 1e-10));
        const double middle = (1 - diagonal * rate * dt) / (1 + diagonal * rate * dt);
        CHECK(at.middle() - 290 == near(40 * middle, 1e-10));
    }
}

TEST_CASE("slopes at the end of a step are those of the equation")
{
    OneLump at;
    at.stepper.step(0, 200);
    const auto& next = at.stepper.next();
    CHECK(next.slope[0] == near(-rate * (next.temperature[0] - 29000), 1e-9));
    CHECK(next.rate.watts[0] == near(next.slope[0], 1e-9));
    CHECK(next.stored[0] == near(next.temperature[0], 1e-15));
}

TEST_CASE("the error estimate of a later step is the error of its quadrature; its order is three")
{
    double last = 0;
    for (const double dt : {80.0, 40.0, 20.0}) {
        OneLump at;
        at.stepper.step(0, dt);
        at.stepper.accept(dt);
        const double start = at.now() - 290;
        const double estimate = at.stepper.step(dt, dt).error;
        const double error = std::abs(start * std::exp(-rate * dt) - (at.next() - 290));
        const double z = -rate * dt, of_middle = (1 + diagonal * z) / (1 - diagonal * z);
        const double by_weights =
            start * z * (error_weights[0] + error_weights[1] * of_middle + error_weights[2] * growth(z));
        CHECK(estimate == near(std::abs(by_weights), 1e-7));  // differences of 300 K
        CHECK(estimate == near(error, 0.1));                  // the companion's own error is z^4
        if (last > 0)
            CHECK(last / estimate ==
                  near(8, 0.065 * dt / 40));  // the next term of the error is smaller by a factor of dt
        last = estimate;
    }
}

TEST_CASE("in a segment's first step the estimate is filtered: a stiff start is not taken for an error without end")
{
    for (const double dt : {20.0, 1e3, 1e5, 1e7}) {
        OneLump at;
        const double z = -rate * dt, of_middle = (1 + diagonal * z) / (1 - diagonal * z);
        const double unfiltered =
            40 * z * (error_weights[0] + error_weights[1] * of_middle + error_weights[2] * growth(z));
        const double estimate = at.stepper.step(0, dt).error;
        CHECK(estimate == near(std::abs(unfiltered) / (1 - diagonal * z), 1e-7));  // differences of 300 K
        CHECK(estimate < 40 * (error_weights[1] - error_weights[0]) / diagonal);   // the limit, however stiff
    }
}

TEST_CASE("steady heat in balance makes no step and no error")
{
    auto problem = cooling();
    problem.segments[0].body_heat[0] = lumps::steady(400);  // 40 K over 10 W/K
    OneLump at(problem);
    const auto outcome = at.stepper.step(0, 500);
    CHECK(outcome.error < 1e-10);
    CHECK(outcome.from_prescribed == 0);
    CHECK(at.next() == near(330, 1e-13));
}

TEST_CASE("with a fixed step there is no error to estimate")
{
    auto problem = cooling();
    problem.fixed_step = 50;
    OneLump at(problem);
    CHECK(at.stepper.step(0, 50).error == 0);
}

TEST_CASE("between the ends of a step lies the cubic through values and slopes")
{
    OneLump at;
    at.stepper.step(0, 300);
    at.stepper.accept(300);
    at.stepper.step(300, 300);
    const auto& now = at.stepper.now();
    const auto& next = at.stepper.next();
    Eigen::VectorXd between(1);
    at.stepper.interpolate(300, 0, between);
    CHECK(between[0] == now.temperature[0]);
    at.stepper.interpolate(300, 1, between);
    CHECK(between[0] == next.temperature[0]);
    // Bernstein's form of the same cubic, written anew.
    for (const double s : {0.2, 0.5, 0.9}) {
        const double p0 = now.temperature[0], p3 = next.temperature[0];
        const double p1 = p0 + 100 * now.slope[0], p2 = p3 - 100 * next.slope[0], r = 1 - s;
        at.stepper.interpolate(300, s, between);
        const double bernstein = r * r * r * p0 + 3 * r * r * s * p1 + 3 * r * s * s * p2 + s * s * s * p3;
        CHECK(between[0] == near(bernstein, 1e-14));
    }
}

TEST_CASE("a first slope is that of the secant until the equation gives one")
{
    OneLump at;
    CHECK_FALSE(at.stepper.slope_known());
    at.stepper.step(0, 100);
    at.stepper.complete_first_slope(100);
    const double secant = (at.stepper.next().temperature[0] - 33000) / 100;
    CHECK(at.stepper.now().slope[0] == near(secant, 1e-13));
    at.stepper.accept(100);
    CHECK(at.stepper.slope_known());
    CHECK(at.stepper.previous_step() == 0);  // the slope before is the secant's, not to be gone on with
    const double known = at.stepper.now().slope[0];
    at.stepper.step(100, 100);
    at.stepper.complete_first_slope(100);
    CHECK(at.stepper.now().slope[0] == known);
    at.stepper.accept(100);
    CHECK(at.stepper.previous_step() == 100);
}

TEST_CASE("a step that was refused leaves no trace: a shorter one gives what it would have given at once")
{
    OneLump refused, direct;
    for (auto* at : {&refused, &direct}) {
        at->stepper.step(0, 50);
        at->stepper.accept(50);
    }
    refused.stepper.step(50, 4000);
    refused.stepper.step(50, 100);
    direct.stepper.step(50, 100);
    CHECK(refused.next() == direct.next());
    CHECK(refused.stepper.next().slope[0] == direct.stepper.next().slope[0]);
}

TEST_CASE("heat that changes in time is taken at the stages' own times")
{
    auto problem = cooling();
    problem.surfaces[0].coefficient = 0;
    problem.segments[0].body_heat[0] = [](double t) { return 100 + 3 * t; };
    OneLump at(problem);
    at.stepper.step(0, 60);
    at.stepper.accept(60);
    at.stepper.step(60, 40);
    CHECK(at.next() == near(330 + (100 * 100 + 1.5 * 100 * 100) / 1e4, 1e-13));
}

TEST_CASE("a new segment forgets the slope, and starts from the temperatures as they are")
{
    auto problem = cooling();
    problem.segments.push_back(lumps::segment(problem, 1e4, 350));
    OneLump at(problem);
    at.stepper.step(0, 100);
    at.stepper.accept(100);
    const double temperature = at.now();
    at.stepper.begin_segment(at.problem.segments[1], 100);
    CHECK_FALSE(at.stepper.slope_known());
    CHECK(at.now() == temperature);
    CHECK(100 * at.stepper.now().rate.watts[0] == near(10 * (350 - temperature), 1e-12));
    at.stepper.step(100, 100);
    CHECK(at.next() - 350 == near((temperature - 350) * growth(-rate * 100), 1e-12));
}
