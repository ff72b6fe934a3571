#include "deadpoint/heat/adjoint.hpp"

#include "deadpoint/exchange/machine.hpp"
#include "lumps.hpp"
#include "near.hpp"

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
    return weights.dot(run.temperatures() - Eigen::Vector3d::Constant(reference));
}

}  // namespace

TEST_CASE("the adjoint of the steps: each cause is its finite difference, and all causes make the functional")
{
    const auto problem = all_causes(80, 200, 150, 300);
    lumps::Run run(three_lumps(), problem, 291);
    const auto& history = run.go();
    const double value = weights.dot(run.temperatures() - Eigen::Vector3d::Constant(reference));
    heat::HeatAdjoint<lumps::DenseSystem> adjoint(run.run, reference);
    adjoint.weights() = lumps::loads_of(three_lumps(), weights);
    const auto causes = adjoint.causes(history.time.size() - 1);

    // The problem is linear in each cause: a difference over the whole of it is exact.
    CHECK(causes.body_heat[0] == near(value - functional(all_causes(0, 200, 150, 300)), 1e-10));
    CHECK(causes.surfaces[1] == near(value - functional(all_causes(80, 0, 150, 300)), 1e-10));
    CHECK(causes.friction[0] == near(value - functional(all_causes(80, 200, 0, 300)), 1e-10));
    CHECK(causes.oil[0] == near(value - functional(all_causes(80, 200, 150, reference)), 1e-10));
    const double sum = causes.friction[0] + causes.oil[0] + causes.body_heat[0] + causes.start +
                       std::accumulate(causes.surfaces.begin(), causes.surfaces.end(), 0.0);
    CHECK(sum == near(value, 1e-12));
}

TEST_CASE("causes at an earlier time leave later steps out")
{
    const auto problem = all_causes(80, 200, 150, 300);
    lumps::Run run(three_lumps(), problem, 291);
    const auto& history = run.go();
    heat::HeatAdjoint<lumps::DenseSystem> adjoint(run.run, reference);
    constexpr std::size_t row = 10;
    adjoint.weights() = lumps::loads_of(three_lumps(), Eigen::Vector3d(0, 1, 0));
    const auto causes = adjoint.causes(row);
    const double sum = causes.friction[0] + causes.oil[0] + causes.body_heat[0] + causes.start + causes.surfaces[0] +
                       causes.surfaces[1];
    CHECK(sum == near(history.probes[1].value[row] - reference, 1e-12));
}

namespace {

/// Two lumps whose film gives heat to enclosed air, which has a start and a power of its own.
HeatProblem in_a_cabin()
{
    HeatProblem problem;
    problem.body_heat = {{"motor", {0}, -1}};
    problem.surfaces = {lumps::film(12), lumps::film(5)};
    problem.surfaces[0].enclosure = 0;
    problem.enclosures = {{"cabin", 3000, 4, 305}};
    problem.segments = {lumps::segment(problem, 3000, 295)};
    problem.segments[0].body_heat[0] = steady(120);
    problem.segments[0].enclosure_power = {steady(40)};
    problem.fixed_step = 75;
    return problem;
}

double sum_of(const HeatCauses& causes)
{
    double sum = causes.start;
    for (const auto* list : {&causes.friction, &causes.oil, &causes.surfaces, &causes.body_heat})
        sum = std::accumulate(list->begin(), list->end(), sum);
    return sum;
}

}  // namespace

TEST_CASE("with enclosed air as booked the causes still make the functional")
{
    const auto problem = in_a_cabin();
    lumps::Run run({{2e4, 5e4}, {{0, 1, 30}}, {}, {{1, 0.5}, {0, 0.2}}, {0, 1}}, problem, 291);
    const auto& history = run.go();
    heat::HeatAdjoint<lumps::DenseSystem> adjoint(run.run, reference);
    adjoint.weights() = lumps::loads_of(run.machine, Eigen::Vector2d(1, -2));
    const auto causes = adjoint.causes(history.time.size() - 1);
    const double value = history.probes[0].value.back() - 2 * history.probes[1].value.back() + reference;
    CHECK(sum_of(causes) == near(value, 1e-11));
    CHECK(causes.surfaces[0] < 0);  // air warmer than the reference warms lump 1, which counts with -2
}

TEST_CASE("with films that follow the temperature, each with its mean coefficient, the causes still sum up")
{
    auto problem = in_a_cabin();
    problem.surfaces[0].enclosure = -1;
    problem.enclosures.clear();
    problem.segments[0].enclosure_power.clear();
    problem.surfaces[0].emissivity = 0.8;
    problem.surfaces[1].laws.emplace_back([](double air) -> FilmLaw {
        return [air](double t) { return LawValue{3 + 0.05 * (t - air), 0.05, true}; };
    });
    lumps::Run run({{2e4, 5e4}, {{0, 1, 30}}, {}, {{1, 0.5}, {0, 0.2}}, {0, 1}}, problem, 320);
    const auto& history = run.go();
    heat::HeatAdjoint<lumps::DenseSystem> adjoint(run.run, reference);
    adjoint.weights() = lumps::loads_of(run.machine, Eigen::Vector2d(0, 1));
    const auto causes = adjoint.causes(history.time.size() - 1);
    // One lump a surface: the mean coefficient makes exactly the heat that was lost, to the solve's 1e-7 K.
    CHECK(sum_of(causes) == near(history.probes[1].value.back() - reference, 1e-6));
}

TEST_CASE("heat into a part's volume, with a load zone that moves some of it, is that joint's friction")
{
    auto problem = all_causes(80, 200, 150, 300);
    problem.interfaces[0].heat_part = 1;
    problem.interfaces[0].load_zone = [](const Vec3&) { return 1.0; };
    problem.segments[1].interfaces[0].heat_part = 1;
    problem.segments[1].interfaces[0].load_zone = problem.interfaces[0].load_zone;
    for (auto& segment : problem.segments)
        segment.zoned_heat = {50};
    auto terms = lumps::terms_of(three_lumps(), problem);
    // One watt by the zone less one watt spread evenly: from lump 1 to lump 2.
    const auto zone = static_cast<Eigen::Index>(terms.geometry.layout.zone(0, false));
    terms.functionals.row(zone) = lumps::loads_of(three_lumps(), Eigen::Vector3d(0, -1, 1)).transpose();
    lumps::DenseSystem system(terms, problem);
    heat::HeatRun<lumps::DenseSystem> run(system, problem);
    run.temperature() = 291 * terms.uniform;
    run.set_media({}, {});
    lumps::Quiet observer;
    run.begin();
    const auto& history = run.go({}, observer);
    heat::HeatAdjoint<lumps::DenseSystem> adjoint(run, reference);
    adjoint.weights() = lumps::loads_of(three_lumps(), weights);
    const auto causes = adjoint.causes(history.time.size() - 1);
    const double value =
        weights.dot(lumps::temperatures_of(three_lumps(), run.temperature()) - Eigen::Vector3d::Constant(reference));
    CHECK(sum_of(causes) == near(value, 1e-12));

    for (auto& segment : problem.segments) {
        segment.zoned_heat = {0};
        segment.heat[0] = [](double) { return LawValue{0, 0, true}; };
    }
    lumps::DenseSystem still(terms, problem);
    heat::HeatRun<lumps::DenseSystem> without(still, problem);
    without.temperature() = 291 * terms.uniform;
    without.set_media({}, {});
    without.begin();
    without.go({}, observer);
    const double rest = weights.dot(lumps::temperatures_of(three_lumps(), without.temperature()) -
                                    Eigen::Vector3d::Constant(reference));
    CHECK(causes.friction[0] == near(value - rest, 1e-10));
}

TEST_CASE("two joints that share a source each have their part of its heat as a cause")
{
    auto problem = all_causes(80, 200, 150, 300);
    problem.interfaces.push_back(problem.interfaces[0]);
    problem.interfaces[1].heat_weight = 3;
    for (auto& segment : problem.segments)
        segment.interfaces.clear();
    auto machine = three_lumps();
    machine.interfaces.emplace_back(1, 2, 0.2);
    lumps::Run run(machine, problem, 291);
    const auto& history = run.go();
    heat::HeatAdjoint<lumps::DenseSystem> adjoint(run.run, reference);
    adjoint.weights() = lumps::loads_of(three_lumps(), weights);
    const auto causes = adjoint.causes(history.time.size() - 1);
    const double value = weights.dot(run.temperatures() - Eigen::Vector3d::Constant(reference));
    CHECK(sum_of(causes) == near(value, 1e-12));
    CHECK(causes.friction[0] != near(causes.friction[1], 0.01));
    for (auto& segment : problem.segments)
        segment.heat[0] = [](double) { return LawValue{0, 0, true}; };
    lumps::Run still(machine, problem, 291);
    still.go();
    const double rest = weights.dot(still.temperatures() - Eigen::Vector3d::Constant(reference));
    CHECK(causes.friction[0] + causes.friction[1] == near(value - rest, 1e-10));
}

TEST_CASE("before the first step the start is the only cause")
{
    const auto problem = all_causes(80, 200, 150, 300);
    lumps::Run run(three_lumps(), problem, 291);
    run.go();
    heat::HeatAdjoint<lumps::DenseSystem> adjoint(run.run, reference);
    adjoint.weights() = lumps::loads_of(three_lumps(), weights);
    const auto causes = adjoint.causes(0);
    CHECK(causes.start == near(weights.sum() * (291 - reference), 1e-13));
    CHECK(sum_of(causes) == causes.start);
    CHECK(adjoint.iterations() == 0);
}
