#include "deadpoint/heat/joints.hpp"

#include "deadpoint/core/error.hpp"

#include <cmath>
#include <doctest/doctest.h>

using namespace deadpoint;
using namespace deadpoint::heat;

namespace {

/// One interface of 0.5 m2 with films of 200 and 300 W/m2/K and oil of 100 W/m2/K at 310 K.
struct OneJoint {
    OneJoint()
    {
        geometry.layout = {1, 2, 0, 0, 0};
        geometry.interface_names = {"pin"};
        geometry.interface_area = {0.5};
        InterfaceLaw law;
        law.film_a = 200;
        law.film_b = 300;
        law.oil = 100;
        law.oil_temperature = 310;
        law.source = 0;
        problem.interfaces = {law};
        problem.sources = {{"pin", 0.5, {}, {}}};
        segment.heat.resize(1);
        segment.ambient = [](double) { return 293.15; };
        values.assign(geometry.layout.count(), 0.0);
        values[geometry.layout.mean(0, false)] = 320;
        values[geometry.layout.mean(0, true)] = 330;
    }
    HeatBalance balance(const HeatLaw& law)
    {
        segment.heat[0] = law;
        JointBalance joints(problem, geometry);
        joints.enter(segment);
        HeatBalance result;
        watts.assign(geometry.layout.count(), 0.0);
        joints.evaluate(values, result, watts);
        return result;
    }
    HeatGeometry geometry;
    HeatProblem problem;
    HeatSegment segment;
    std::vector<double> values, watts;
};

/// Root of tau = start + self share law(tau) by bisection, which needs no slope.
double bisected(const HeatLaw& law, double share, double start, double self)
{
    double low = start - 1000, high = start + 1000;
    for (int i = 0; i < 200; ++i) {
        const double middle = (low + high) / 2;
        (middle - start - self * share * law(middle).value < 0 ? low : high) = middle;
    }
    return (low + high) / 2;
}

// Of the joint above: (200 x 320 + 300 x 330) / 600 + 100 x 310 / 600, and 1 / (0.5 x 600).
constexpr double solids_and_oil = (200 * 320.0 + 300 * 330.0 + 100 * 310.0) / 600;
constexpr double self = 1 / 300.0;

}  // namespace

TEST_CASE("the film temperature holds a source's own heat: falling, rising and kinked laws against bisection")
{
    const HeatLaw falling = [](double t) {
        return LawValue{4000 * std::exp(-0.03 * (t - 293)), -120 * std::exp(-0.03 * (t - 293)), true};
    };
    const HeatLaw rising = [](double t) { return LawValue{500 + 20 * (t - 300), 20, true}; };
    const HeatLaw kinked = [](double t) {
        return t < 324 ? LawValue{2000 - 40 * (t - 320), -40, true} : LawValue{1840 - 5 * (t - 324), -5, true};
    };
    for (const auto& law : {falling, rising, kinked}) {
        OneJoint joint;
        const auto balance = joint.balance(law);
        const double expected = bisected(law, 0.5, solids_and_oil, self);
        CHECK(balance.source_temperature[0] == doctest::Approx(expected).epsilon(1e-11));  // Newton's tolerance
        CHECK(balance.source_heat[0] == doctest::Approx(0.5 * law(expected).value).epsilon(1e-9));
        CHECK(balance.film[0] == doctest::Approx(expected).epsilon(1e-11));  // one interface: the same film
    }
}

TEST_CASE("the slope of a source is that of its heat by the solids' part of the film temperature")
{
    const HeatLaw law = [](double t) { return LawValue{3000 - 30 * (t - 300), -30, true}; };
    OneJoint joint;
    const auto before = joint.balance(law);
    constexpr double step = 1e-3;
    for (const bool side_b : {false, true})
        joint.values[joint.geometry.layout.mean(0, side_b)] += step;
    const auto after = joint.balance(law);
    // Both sides by a kelvin move the solids' part by (200 + 300) / 600.
    const double by_difference = (after.source_heat[0] - before.source_heat[0]) / (step * 500 / 600);
    CHECK(by_difference == doctest::Approx(before.source_slope[0]).epsilon(1e-7));  // the law is straight: rounding
}

TEST_CASE("watts that leave a film are those that enter it")
{
    const HeatLaw law = [](double) { return LawValue{1000, 0, true}; };
    OneJoint joint;
    const auto balance = joint.balance(law);
    // To both sides, as the matrix has it, h_a h_b between them, and to the oil.
    const double film = balance.film[0];
    const double to_sides = 0.5 * (200 * (film - 320) + 300 * (film - 330));
    CHECK(to_sides + balance.to_oil == doctest::Approx(balance.generated).epsilon(1e-12));
    CHECK(balance.generated == doctest::Approx(500).epsilon(1e-15));
    // Loads without the conduction between solids and film: heat by h / S and what the oil's temperature brings.
    const double a = joint.watts[joint.geometry.layout.mean(0, false)];
    CHECK(a == doctest::Approx(500 * 200 / 600.0 + 100 * 310 * 0.5 * 200 / 600.0).epsilon(1e-14));
}

TEST_CASE("a booked tangent restores the heat that the solve took")
{
    const HeatLaw law = [](double t) {
        return LawValue{4000 * std::exp(-0.03 * (t - 300)), -120 * std::exp(-0.03 * (t - 300)), true};
    };
    OneJoint joint;
    joint.segment.heat[0] = law;
    JointBalance joints(joint.problem, joint.geometry);
    joints.enter(joint.segment);
    HeatBalance before, after;
    std::vector<double> watts(joint.geometry.layout.count(), 0.0);
    joints.evaluate(joint.values, before, watts);
    joint.values[joint.geometry.layout.mean(0, false)] += 3;
    watts.assign(watts.size(), 0.0);
    joints.evaluate(joint.values, after, watts);
    const auto corrections = joints.tangent_less_law(before, after);
    const double tangent = before.source_heat[0] + before.source_slope[0] * 3 * 200 / 600.0;
    const double generated = after.generated;
    joints.correct(after, corrections, watts);
    CHECK(std::abs(corrections[0]) > 0.1);  // the law bends: 4000 x 0.03^2 / 2 a kelvin squared
    CHECK(after.source_heat[0] == doctest::Approx(tangent).epsilon(1e-12));
    CHECK(after.generated - generated == doctest::Approx(corrections[0]).epsilon(1e-9));
}

TEST_CASE("an interface that conducts nothing is refused by name")
{
    OneJoint joint;
    joint.problem.interfaces[0].film_a = joint.problem.interfaces[0].film_b = joint.problem.interfaces[0].oil = 0;
    JointBalance joints(joint.problem, joint.geometry);
    CHECK_THROWS_WITH_AS(joints.enter(joint.segment),
                         "interface 'pin' conducts nothing to either side nor to the oil; give it a conductance",
                         DomainError);
}
