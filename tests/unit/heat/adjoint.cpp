#include "lumps.hpp"

#include <cmath>
#include <doctest/doctest.h>
#include <numeric>

using namespace deadpoint;
using lumps::steady;

namespace {

constexpr double reference = 288;

/// Two segments with friction, a motor, oil, a film and a flux; everything that a cause can be.
HeatProblem all_causes(double motor, double flux, double heat, double oil)
{
    HeatProblem problem;
    InterfaceLaw law;
    law.film_a = 700;
    law.film_b = 500;
    law.oil = 150;
    law.oil_temperature = oil;
    law.source = 0;
    problem.interfaces = {law};
    problem.sources = {{"pin", 1, {}, {}}};
    problem.body_heat = {{"motor", {1, 2}, -1}};
    problem.surfaces = {lumps::film(12), lumps::film(0)};
    problem.surfaces[1].kind = SurfaceCondition::Kind::flux;
    problem.surfaces[1].flux = steady(flux);
    for (const double duration : {2500.0, 1800.0}) {
        problem.segments.push_back(lumps::segment(problem, duration, 295));
        problem.segments.back().heat[0] = [heat](double) { return LawValue{heat, 0, true}; };
        problem.segments.back().body_heat[0] = steady(motor);
    }
    problem.segments[1].interfaces = problem.interfaces;
    problem.segments[1].interfaces[0].film_a = 300;
    problem.fixed_step = 100;
    return problem;
}

lumps::Machine three_lumps() { return {{2e4, 5e4, 3e4}, {{1, 2, 25}}, {{0, 1, 0.1}}, {{2, 0.5}, {0, 0.2}}, {0, 1, 2}}; }

const Eigen::Vector3d weights(0.7, -1.3, 2.1);

double functional(const HeatProblem& problem)
{
    lumps::Run run(three_lumps(), problem, 291);
    run.go();
    return weights.dot(run.run.temperature() - Eigen::Vector3d::Constant(reference));
}

}  // namespace

TEST_CASE("the adjoint of the steps: each cause is its finite difference, and all causes make the functional")
{
    const auto problem = all_causes(80, 200, 150, 300);
    lumps::Run run(three_lumps(), problem, 291);
    const auto& history = run.go();
    const double value = weights.dot(run.run.temperature() - Eigen::Vector3d::Constant(reference));
    heat::HeatAdjoint<lumps::DenseSystem> adjoint(run.run, reference);
    adjoint.weights() = weights;
    const auto causes = adjoint.causes(history.time.size() - 1);

    // The problem is linear in each cause: a difference over the whole of it is exact.
    CHECK(causes.body_heat[0] == doctest::Approx(value - functional(all_causes(0, 200, 150, 300))).epsilon(1e-10));
    CHECK(causes.surfaces[1] == doctest::Approx(value - functional(all_causes(80, 0, 150, 300))).epsilon(1e-10));
    CHECK(causes.friction[0] == doctest::Approx(value - functional(all_causes(80, 200, 0, 300))).epsilon(1e-10));
    CHECK(causes.oil[0] == doctest::Approx(value - functional(all_causes(80, 200, 150, reference))).epsilon(1e-10));
    const double sum = causes.friction[0] + causes.oil[0] + causes.body_heat[0] + causes.start +
                       std::accumulate(causes.surfaces.begin(), causes.surfaces.end(), 0.0);
    CHECK(sum == doctest::Approx(value).epsilon(1e-12));
}

TEST_CASE("causes at an earlier time leave later steps out")
{
    const auto problem = all_causes(80, 200, 150, 300);
    lumps::Run run(three_lumps(), problem, 291);
    const auto& history = run.go();
    heat::HeatAdjoint<lumps::DenseSystem> adjoint(run.run, reference);
    constexpr std::size_t row = 10;
    adjoint.weights() = Eigen::Vector3d(0, 1, 0);
    const auto causes = adjoint.causes(row);
    const double sum = causes.friction[0] + causes.oil[0] + causes.body_heat[0] + causes.start + causes.surfaces[0] +
                       causes.surfaces[1];
    CHECK(sum == doctest::Approx(history.probes[1].value[row] - reference).epsilon(1e-12));
}
