#include "deadpoint/reduce/causes/reduced_adjoint.hpp"

#include "deadpoint/exchange/machine.hpp"
#include "lumps.hpp"
#include "near.hpp"

#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>
#include <numeric>

using namespace deadpoint;
using lumps::steady;

namespace {

constexpr double reference = 288;
constexpr int slices = 120;

/// Two steel rods of 60 slices, 10 mm thick and 100 cm2 wide, that touch at slices 59 and 60: heat takes hours to pass.
lumps::Machine rods()
{
    lumps::Machine machine;
    machine.capacity.assign(slices, 361);
    for (int k = 0; k + 1 < slices; ++k)
        if (k != 59)
            machine.links.emplace_back(k, k + 1, 50);
    machine.interfaces = {{59, 60, 0.01}, {20, 90, 0.002}};
    machine.surfaces = {{0, 0.3}, {119, 0.01}, {75, 0.2}};
    machine.probes = {10, 110};
    return machine;
}

/// Friction, oil, a motor, a film, a flux, a start that is not the reference, and joints that change with the segment.
HeatProblem warming(double step)
{
    HeatProblem problem;
    InterfaceLaw law;
    law.film_a = 700;
    law.film_b = 500;
    law.oil = 150;
    law.oil_temperature = 300;
    law.source = 0;
    problem.interfaces = {law, law};
    problem.interfaces[1].source = 1;
    problem.sources = {{"pin", 1, {}, {}}, {"guide", 1, {}, {}}};
    problem.body_heat = {{"motor", {100, 101}, -1}};
    problem.surfaces = {lumps::film(12), lumps::film(0), lumps::film(4)};
    problem.surfaces[1].kind = SurfaceCondition::Kind::flux;
    problem.surfaces[1].flux = steady(200);
    for (const double duration : {7200.0, 5400.0}) {
        problem.segments.push_back(lumps::segment(problem, duration, 295));
        for (auto& heat : problem.segments.back().heat)
            heat = [](double film) { return LawValue{40 - 0.2 * (film - 290), -0.2, true}; };
        problem.segments.back().body_heat[0] = [](double time) { return 50 + time / 200; };
    }
    problem.segments[1].interfaces = problem.interfaces;
    for (auto& other : problem.segments[1].interfaces)
        other.film_a = 60;
    problem.fixed_step = step;
    return problem;
}

/// Weights of both signs, as the motion of a slide has them.
Eigen::VectorXd weights()
{
    Eigen::VectorXd values(slices);
    for (int k = 0; k < slices; ++k)
        values[k] = 1e-6 * std::sin(0.11 * k + 0.4);
    return values;
}

std::vector<double> values_of(const HeatCauses& causes)
{
    std::vector<double> values{causes.start};
    for (const auto* list : {&causes.friction, &causes.oil, &causes.surfaces, &causes.body_heat})
        values.insert(values.end(), list->begin(), list->end());
    return values;
}

/// Compares the causes on a basis with those in all unknowns.
void check(const HeatProblem& problem, std::size_t row)
{
    lumps::Run run(rods(), problem, 291);
    run.go();
    const Eigen::VectorXd load = lumps::loads_of(run.machine, weights());
    reduce::ReducedAdjoint<lumps::DenseSystem> reduced(
        run.system, heat::FinishedRun<lumps::DenseSystem>{run.run.sources(), run.run.steps(), run.run.start()},
        reference);
    const auto found = reduced.causes(load, row);
    heat::HeatAdjoint<lumps::DenseSystem> exact(run.run, reference);
    exact.weights() = load;
    const auto causes = exact.causes(row);
    CAPTURE(row);
    CAPTURE(found.fields);
    CHECK(causes.fields == 0);
    CHECK(found.fields > 3);
    CHECK(found.fields < 40);
    const auto near = values_of(found), right = values_of(causes);
    const double all = std::accumulate(right.begin(), right.end(), 0.0,
                                       [](double sum, double value) { return sum + std::abs(value); });
    for (std::size_t i = 0; i < right.size(); ++i) {
        CAPTURE(i);
        // The basis grows until two more fields change a cause by 1e-3 of it at most; less is left than twice that.
        CHECK(std::abs(near[i] - right[i]) <= 2e-3 * std::max(std::abs(right[i]), 5e-3 * all));
        CHECK(std::abs(near[i] - right[i]) <= found.change + 1e-9 * all);
    }
    CHECK(found.change < 1e-2 * all);
}

}  // namespace

TEST_CASE("causes on a basis: within a thousandth of those in all unknowns, with two sets of laws")
{
    const auto problem = warming(120);
    check(problem, 105);  // the end
    check(problem, 80);
    check(problem, 40);  // in the first segment
    check(problem, 1);
}

TEST_CASE("causes on a basis where films follow the temperature")
{
    auto problem = warming(120);
    problem.surfaces[0].emissivity = 0.8;
    for (int segment = 0; segment < 2; ++segment)
        problem.surfaces[2].laws.emplace_back([](double air) -> FilmLaw {
            return [air](double t) { return LawValue{3 + 0.05 * (t - air), 0.05, true}; };
        });
    check(problem, 105);
}

TEST_CASE("one basis serves the causes at two times")
{
    const auto problem = warming(120);
    lumps::Run run(rods(), problem, 291);
    run.go();
    const Eigen::VectorXd load = lumps::loads_of(run.machine, weights());
    const heat::FinishedRun<lumps::DenseSystem> over{run.run.sources(), run.run.steps(), run.run.start()};
    reduce::ReducedAdjoint<lumps::DenseSystem> both(run.system, over, reference), one(run.system, over, reference);
    const auto first = both.causes(load, 105);
    const auto again = both.causes(load, 80), alone = one.causes(load, 80);
    CHECK(again.friction[0] == near(alone.friction[0], 1e-3));
    CHECK(again.body_heat[0] == near(alone.body_heat[0], 1e-3));
    CHECK(again.fields < first.fields + alone.fields);
}

TEST_CASE("the basis is large enough where two more fields change no cause; the last two changes are stated")
{
    reduce::CausesSearch search;
    CHECK(!search.known());
    HeatCauses causes;
    causes.friction = {2, -1};
    causes.start = 0.001;
    search.add(causes);
    CHECK(search.known());
    CHECK(search.wants_more(6));
    causes.friction[1] = -1.002;  // 2e-3 of it
    search.add(causes);
    CHECK(search.wants_more(8));
    CHECK(!search.wants_more(100));
    causes.friction[1] = -1.0025;
    causes.start = 0.001008;  // 8e-3 of it, but 5e-4 of the smallest that counts
    search.add(causes);
    CHECK(!search.wants_more(10));
    CHECK(search.result(10).change == near(0.002, 1e-9));
    CHECK(search.result(10).fields == 10);
    CHECK(search.result(10).friction[1] == -1.0025);
}
