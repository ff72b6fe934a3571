#include "deadpoint/heat/joints.hpp"

#include "deadpoint/error.hpp"
#include "deadpoint/heat/balance.hpp"
#include "near.hpp"

#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>
#include <limits>

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

// Film temperature of the joint above without heat [K], and its rise per watt, 1 / (0.5 x 600) [K/W].
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
        CHECK(balance.source_temperature[0] == near(expected, 1e-11));  // Newton's tolerance
        CHECK(balance.source_heat[0] == near(0.5 * law(expected).value, 1e-9));
        CHECK(balance.film[0] == near(expected, 1e-11));  // one interface: the same film
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
    CHECK(by_difference == near(before.source_slope[0], 1e-7));  // the law is straight: rounding
}

TEST_CASE("watts that leave a film are those that enter it")
{
    const HeatLaw law = [](double) { return LawValue{1000, 0, true}; };
    OneJoint joint;
    const auto balance = joint.balance(law);
    // To both sides, as the matrix has it, h_a h_b between them, and to the oil.
    const double film = balance.film[0];
    const double to_sides = 0.5 * (200 * (film - 320) + 300 * (film - 330));
    CHECK(to_sides + balance.to_oil == near(balance.generated, 1e-12));
    CHECK(balance.generated == near(500, 1e-15));
    // Loads without the conduction between solids and film: heat by h / S and what the oil's temperature brings.
    const double a = joint.watts[joint.geometry.layout.mean(0, false)];
    CHECK(a == near(500 * 200 / 600.0 + 100 * 310 * 0.5 * 200 / 600.0, 1e-14));
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
    CHECK(after.source_heat[0] == near(tangent, 1e-12));
    CHECK(after.generated - generated == near(corrections[0], 1e-9));
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

namespace {

/// Two interfaces of 0.5 and 0.2 m2 that share one source by weights of 1 and 3, one of them heated in part 1; and a
/// third one without friction.
struct ThreeJoints {
    ThreeJoints()
    {
        geometry.layout = {3, 4, 0, 0, 0};
        geometry.interface_names = {"journal", "collar", "seal"};
        geometry.interface_area = {0.5, 0.2, 0.3};
        InterfaceLaw law;
        law.film_a = 200;
        law.film_b = 300;
        law.oil = 100;
        law.oil_temperature = 310;
        law.source = 0;
        problem.interfaces = {law, law, law};
        problem.interfaces[1].heat_weight = 3;
        problem.interfaces[1].film_a = 700;
        problem.interfaces[2].source = -1;
        problem.sources = {{"pin", 0.5, {}, {}}};
        segment.heat.resize(1);
        values.assign(geometry.layout.count(), 0.0);
        for (std::size_t i = 0; i < 3; ++i)
            for (const bool side_b : {false, true})
                values[geometry.layout.mean(i, side_b)] = 315 + 4.0 * static_cast<double>(i) + (side_b ? 1.5 : 0);
        for (std::size_t p = 0; p < 4; ++p)
            values[geometry.layout.part(p)] = 325 + static_cast<double>(p);
    }
    HeatBalance balance(const JointBalance& joints)
    {
        HeatBalance result;
        watts.assign(geometry.layout.count(), 0.0);
        joints.evaluate(values, result, watts);
        return result;
    }
    /// Heat that the films conduct to the sides and take from the oil, apart from the formula that is tested.
    [[nodiscard]] double through_films(const HeatBalance& at, const std::vector<double>& oil) const
    {
        double sum = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            const auto& law = problem.interfaces[i];
            for (const bool side_b : {false, true})
                sum += geometry.interface_area[i] * (side_b ? law.film_b : law.film_a) *
                       (at.film[i] - values[geometry.layout.mean(i, side_b)]);
            sum += geometry.interface_area[i] * law.oil * (at.film[i] - oil[i]);
        }
        return sum;
    }
    HeatGeometry geometry;
    HeatProblem problem;
    HeatSegment segment;
    std::vector<double> values, watts;
};

LawValue straight(double t) { return {2000 - 6 * (t - 300), -6, true}; }

}  // namespace

TEST_CASE("interfaces share a source's heat by area times weight")
{
    ThreeJoints at;
    at.segment.heat[0] = straight;
    JointBalance joints(at.problem, at.geometry);
    joints.enter(at.segment);
    CHECK(joints.heat_share(0) == near(0.5 / (0.5 + 3 * 0.2), 1e-15));
    CHECK(joints.heat_share(1) == near(0.6 / (0.5 + 3 * 0.2), 1e-15));
    CHECK(joints.heat_share(2) == 0);
    const auto balance = at.balance(joints);
    // One law at one temperature: the films' mean by their shares.
    const double mean = joints.heat_share(0) * balance.film[0] + joints.heat_share(1) * balance.film[1];
    CHECK(balance.source_temperature[0] == near(mean, 1e-13));
    CHECK(balance.source_heat[0] == near(0.5 * straight(mean).value, 1e-12));
    // All of it leaves through the films.
    CHECK(at.through_films(balance, {310, 310, 310}) == near(balance.generated, 1e-11));
}

TEST_CASE("a watt of a source goes to both sides and the oil by their conductances")
{
    ThreeJoints at;
    at.segment.heat[0] = straight;
    JointBalance joints(at.problem, at.geometry);
    joints.enter(at.segment);
    double to_sides = 0;
    for (const auto& [functional, factor] : joints.source_load(0))
        to_sides += factor;
    const double to_oil = joints.heat_share(0) * 100 / 600 + joints.heat_share(1) * 100 / 1100;
    CHECK(to_sides + to_oil == near(1, 1e-15));
    CHECK(joints.side_share(1, false) == near(700.0 / 1100, 1e-15));
    CHECK(joints.side_share(1, true) == near(300.0 / 1100, 1e-15));
    CHECK(joints.film_sum(1) == 1100);
    CHECK(joints.area(1) == 0.2);
}

TEST_CASE("heat that goes into a part's volume follows that part's temperature and warms no film")
{
    ThreeJoints at;
    at.problem.interfaces[0].heat_part = 1;
    at.problem.interfaces[1].heat_part = 2;
    at.segment.heat[0] = straight;
    JointBalance joints(at.problem, at.geometry);
    joints.enter(at.segment);
    const auto balance = at.balance(joints);
    const double share = 0.5 / 1.1;
    const double mean = share * 326 + (1 - share) * 327;
    CHECK(balance.source_temperature[0] == near(mean, 1e-14));
    CHECK(balance.source_heat[0] == near(0.5 * straight(mean).value, 1e-14));
    CHECK(balance.source_slope[0] == near(-3, 1e-14));  // no heat of its own in the temperature
    CHECK(balance.film[0] == near((200 * 315.0 + 300 * 316.5 + 100 * 310) / 600, 1e-14));
    CHECK(at.watts[at.geometry.layout.part(1)] == near(share * balance.source_heat[0], 1e-14));
    CHECK(at.watts[at.geometry.layout.part(2)] == near((1 - share) * balance.source_heat[0], 1e-14));
    const auto needed = joints.needed();
    CHECK(std::count(needed.begin(), needed.end(), at.geometry.layout.part(1)) == 1);
    CHECK(std::count(needed.begin(), needed.end(), at.geometry.layout.part(0)) == 0);
    CHECK(needed.size() == 6 + 2);
}

TEST_CASE("what the balance needs is all that it reads: other values may be anything")
{
    ThreeJoints at;
    at.problem.interfaces[1].heat_part = 3;
    at.segment.heat[0] = straight;
    JointBalance joints(at.problem, at.geometry);
    joints.enter(at.segment);
    const auto before = at.balance(joints);
    const auto needed = joints.needed();
    for (std::size_t k = 0; k < at.values.size(); ++k)
        if (std::count(needed.begin(), needed.end(), k) == 0)
            at.values[k] = std::nan("");
    const auto after = at.balance(joints);
    CHECK(after.source_heat == before.source_heat);
    CHECK(after.film == before.film);
    CHECK(after.to_oil == before.to_oil);
}

TEST_CASE("a segment's own laws replace those of the problem, an empty list leaves them")
{
    ThreeJoints at;
    JointBalance joints(at.problem, at.geometry);
    at.segment.interfaces = at.problem.interfaces;
    at.segment.interfaces[0].film_a = 50;
    at.segment.interfaces[2].oil_temperature = 333;
    joints.enter(at.segment);
    CHECK(joints.film_sum(0) == 450);
    CHECK(joints.oil_temperature() == std::vector<double>{310, 310, 333});
    at.segment.interfaces.clear();
    joints.enter(at.segment);
    CHECK(joints.film_sum(0) == 600);
    CHECK(&joints.laws() == &at.problem.interfaces);
}

TEST_CASE("a source without a law in a segment rests: it has a temperature but no heat")
{
    ThreeJoints at;
    JointBalance joints(at.problem, at.geometry);
    joints.enter(at.segment);
    const auto balance = at.balance(joints);
    CHECK(balance.source_heat[0] == 0);
    CHECK(balance.source_slope[0] == 0);
    CHECK(balance.generated == 0);
    const double mean = joints.heat_share(0) * balance.film[0] + joints.heat_share(1) * balance.film[1];
    CHECK(balance.source_temperature[0] == near(mean, 1e-14));
    CHECK(at.through_films(balance, {310, 310, 310}) == near(0, 0, 1.2e-5 * 1e-9 * 1e4));  // of some 1e4 W either way
}

TEST_CASE("oil of another temperature: the film that is told beforehand is the one that comes")
{
    ThreeJoints at;
    at.problem.interfaces[0].source = at.problem.interfaces[1].source = -1;  // the heat itself follows the film else
    JointBalance joints(at.problem, at.geometry);
    joints.enter(at.segment);
    const auto before = at.balance(joints);
    std::vector<double> told;
    const std::vector<double> oil{295, 340, 310};
    for (std::size_t i = 0; i < 3; ++i)
        told.push_back(joints.film_with_oil(i, before.film[i], oil[i]));
    joints.set_oil(oil);
    const auto after = at.balance(joints);
    for (std::size_t i = 0; i < 3; ++i)
        CHECK(after.film[i] == near(told[i], 1e-14));
    CHECK(std::abs(at.through_films(after, oil)) < 1e-9);
    CHECK(after.oil_temperature == oil);
}

TEST_CASE("the heat of rings of different temperature comes on top, by the sides' means weighted with their areas")
{
    ThreeJoints at;
    at.problem.sources[0].inner_rings = {{0, false}, {1, false}};
    at.problem.sources[0].outer_rings = {{2, true}};
    at.segment.heat[0] = [](double) { return LawValue{1000, 0, true}; };
    at.segment.ring_heat = {[](double difference) { return 50 * difference; }};
    JointBalance joints(at.problem, at.geometry);
    joints.enter(at.segment);
    const double inner = (0.5 * 315 + 0.2 * 319) / 0.7, outer = 324.5;
    CHECK(at.balance(joints).generated == near(0.5 * (1000 + 50 * (inner - outer)), 1e-13));
    at.segment.ring_heat = {RingHeatLaw()};
    joints.enter(at.segment);
    CHECK(at.balance(joints).generated == near(500, 1e-15));
}

TEST_CASE("a load zone gets its part of the heat by both sides' conductances, or once in a part's volume")
{
    ThreeJoints at;
    const auto anywhere = [](const Vec3&) { return 1.0; };
    at.problem.interfaces[0].load_zone = at.problem.interfaces[1].load_zone = anywhere;
    at.problem.interfaces[1].heat_part = 2;
    at.segment.heat[0] = straight;
    at.segment.zoned_heat = {800};
    JointBalance joints(at.problem, at.geometry);
    joints.enter(at.segment);
    at.balance(joints);
    const auto& layout = at.geometry.layout;
    const double of_first = 0.5 * 800 * 0.5 / 1.1, of_second = 0.5 * 800 * 0.6 / 1.1;
    CHECK(at.watts[layout.zone(0, false)] == near(of_first * 200 / 600, 1e-14));
    CHECK(at.watts[layout.zone(0, true)] == near(of_first * 300 / 600, 1e-14));
    CHECK(at.watts[layout.zone(1, false)] == near(of_second, 1e-14));
    CHECK(at.watts[layout.zone(1, true)] == 0);
    CHECK(at.watts[layout.zone(2, false)] == 0);
}

TEST_CASE("a law out of its range is told, wherever on the way to the film temperature")
{
    ThreeJoints at;
    const auto only_cold = [](double t) { return LawValue{2e5, 0, t < 320}; };
    at.segment.heat[0] = LawTable(only_cold);
    JointBalance joints(at.problem, at.geometry);
    joints.enter(at.segment);
    const auto balance = at.balance(joints);
    CHECK(balance.source_temperature[0] > 320);
    CHECK_FALSE(balance.in_range);
    at.segment.heat[0] = LawTable([](double) { return LawValue{10, 0, true}; });
    joints.enter(at.segment);
    CHECK(at.balance(joints).in_range);
}

TEST_CASE("corrections of a source's heat reach sides and oil as its heat does")
{
    ThreeJoints at;
    at.segment.heat[0] = straight;
    JointBalance joints(at.problem, at.geometry);
    joints.enter(at.segment);
    auto balance = at.balance(joints);
    const auto before = balance;
    const auto watts = at.watts;
    joints.correct(balance, {7}, at.watts);
    CHECK(balance.generated - before.generated == near(7, 1e-12));
    double to_sides = 0;
    for (std::size_t k = 0; k < watts.size(); ++k)
        to_sides += at.watts[k] - watts[k];
    CHECK(to_sides + balance.to_oil - before.to_oil == near(7, 1e-11));
    // The film temperature rises by the source's own resistance.
    const double own =
        std::pow(joints.heat_share(0), 2) / (0.5 * 600) + std::pow(joints.heat_share(1), 2) / (0.2 * 1100);
    CHECK(balance.source_temperature[0] - before.source_temperature[0] == near(7 * own, 1e-9));
}

TEST_CASE("a straight law needs no correction, however far the temperatures went")
{
    ThreeJoints at;
    at.segment.heat[0] = straight;
    JointBalance joints(at.problem, at.geometry);
    joints.enter(at.segment);
    const auto before = at.balance(joints);
    for (double& value : at.values)
        value += 25;
    const auto after = at.balance(joints);
    CHECK(std::abs(after.source_heat[0] - before.source_heat[0]) > 50);
    CHECK(std::abs(joints.tangent_less_law(before, after)[0]) < 1e-9);  // of 1 kW: rounding, Newton to 1e-11
}

TEST_CASE("conductances that are not finite are refused as those that are zero")
{
    ThreeJoints at;
    at.problem.interfaces[2].film_b = std::numeric_limits<double>::infinity();
    JointBalance joints(at.problem, at.geometry);
    CHECK_THROWS_WITH_AS(joints.enter(at.segment), doctest::Contains("interface 'seal'"), DomainError);
}
