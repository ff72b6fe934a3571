#include "deadpoint/tribology/friction/duty.hpp"

#include "deadpoint/core/vec.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/exchange/cycle.hpp"
#include "near.hpp"

#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>
#include <numbers>
#include <vector>

using namespace deadpoint;
using namespace deadpoint::tribology;

namespace {

constexpr double pi = std::numbers::pi;
constexpr double period = 0.3;

/// A turn at times that bunch up: t = period (u + 0.1 sin(2 pi u) / (2 pi)), with force and sliding as functions of
/// time.
template <class Force, class Sliding>
std::pair<CycleHistory, JointCycle> turn_of(int count, const Force& force, const Sliding& sliding)
{
    CycleHistory turn;
    turn.period = period;
    JointCycle joint;
    for (int i = 0; i < count; ++i) {
        const double u = static_cast<double>(i) / count;
        const double time = period * (u + 0.1 * std::sin(2 * pi * u) / (2 * pi));
        turn.time.push_back(time);
        joint.force.push_back(force(2 * pi * time / period));
        joint.sliding.push_back(sliding(2 * pi * time / period));
        joint.moment.push_back(0);
    }
    return {turn, joint};
}

}  // namespace

TEST_CASE("duty: uneven times are weighted by the trapezoidal rule over the closed turn")
{
    const std::vector<double> weight = turn_weights({0, 0.1, 0.15}, period);
    CHECK(weight[0] == near((0.1 + 0.15) / 0.6, 1e-5));
    CHECK(weight[1] == near(0.15 / 0.6, 1e-5));
    CHECK(weight[2] == near((0.05 + 0.15) / 0.6, 1e-5));
    CHECK(turn_weights({0.05}, period)[0] == near(1, 1e-5));
}

TEST_CASE("duty: means over the turn are those of the product, not products of the means")
{
    // F = (300, 400) (2 + cos), |F| = 500 (2 + cos); w = 3 cos: mean(F |w|) = 500 * 3 (2 * 2/pi + 0) = 6000/pi,
    // mean(w^2) = 4.5, rms(F) = 500 sqrt(4.5), mean |w| = 6/pi.
    const auto force = [](double phase) { return (2 + std::cos(phase)) * Vec2{300, 400}; };
    const auto [turn, joint] = turn_of(4000, force, [](double phase) { return 3 * std::cos(phase); });
    const Duty duty = duty_of(turn, joint);
    // Second order in the step of 1/4000 turn, and |cos| has kinks: 1e-6.
    CHECK(duty_mean(duty, 1, 1) == near(6000 / pi, 1e-6));
    CHECK(duty_mean(duty, 0, 2) == near(4.5, 1e-6));
    CHECK(duty_mean(duty, 0, 1) == near(6 / pi, 1e-6));
    CHECK(std::sqrt(duty_mean(duty, 2, 0)) == near(500 * std::sqrt(4.5), 1e-6));
    CHECK(duty_mean(duty, 1, 0) == near(1000, 1e-6));
    CHECK(std::sqrt(duty_mean(duty, 0, 2)) == near(std::sqrt(4.5), 1e-6));
    CHECK(peak_force(duty) == near(1500, 1e-12));

    // With a load that acts only where the joint rests, the products of means would be far off.
    const auto pulse = [](double phase) { return Vec2{std::pow(std::cos(phase), 8), 0}; };
    const auto [turn_2, joint_2] = turn_of(4000, pulse, [](double phase) { return std::sin(phase); });
    const Duty apart = duty_of(turn_2, joint_2);
    CHECK(duty_mean(apart, 1, 1) == near(2 / (9 * pi), 1e-5));
    CHECK(duty_mean(apart, 1, 0) * duty_mean(apart, 0, 1) > 2 * duty_mean(apart, 1, 1));
}

TEST_CASE("duty: rolling means against the beta function")
{
    const auto [turn, joint] = turn_of(
        4000,
        [](double) {
            return Vec2{0, -2};
        },
        [](double phase) { return std::sin(phase); });
    const Duty duty = duty_of(turn, joint);
    // mean |sin|^q = Gamma((q + 1)/2) / (sqrt(pi) Gamma(q/2 + 1))
    const double q = 5.0 / 3.0;
    CHECK(duty_mean(duty, 0, rolling_drag_exponent) ==
          near(std::tgamma((q + 1) / 2) / (std::sqrt(pi) * std::tgamma(q / 2 + 1)), 1e-6));
    CHECK(duty_mean(duty, rolling_load_exponent, 1) == near(std::pow(2, 1.33) * 2 / pi, 1e-6));
}

TEST_CASE("duty: the peak measure puts the largest load at every sample; a share scales it")
{
    const auto force = [](double phase) { return Vec2{0, 10 * (1 + std::cos(phase))}; };
    const auto [turn, joint] = turn_of(400, force, [](double) { return -2; });
    const Duty duty = duty_of(turn, joint);
    CHECK(duty_mean(measured(duty, LoadMeasure::peak), 1, 1) == near(40, 1e-12));
    CHECK(duty_mean(measured(duty, LoadMeasure::mean), 1, 1) == near(20, 1e-4));
    CHECK(duty_mean(shared(duty, 0.25), 1, 1) == near(duty_mean(duty, 1, 1) / 4, 1e-13));
}

TEST_CASE("duty: bearings of the crankshaft, and guides that carry a moment")
{
    BearingCycle bearing;
    bearing.force = {{3, 4}, {0, 10}, {-6, 8}, {0, 0}};
    const Duty duty = duty_of(bearing, -2);
    CHECK(duty_mean(duty, 1, 1) == near(2 * (5 + 10 + 10) / 4.0, 1e-5));
    CHECK(peak_force(duty) == near(10, 1e-5));

    auto [turn, joint] = turn_of(
        8,
        [](double) {
            return Vec2{-30, 0};
        },
        [](double) { return 1; });
    CHECK(peak_force(guide_duty(turn, joint, {0, 0.5})) == near(30, 1e-5));
    joint.moment.assign(8, -20);  // 40 N up on one end, 40 N down on the other, against 15 N each
    CHECK(peak_force(guide_duty(turn, joint, {0, 0.5})) == near(80, 1e-5));
    CHECK(peak_force(guide_duty(turn, joint, {0, std::nullopt})) == near(30, 1e-5));
    CHECK_THROWS_AS(guide_duty(turn, joint, {0, 0.0}), InputError);
    CHECK_THROWS_AS(guide_duty(turn, joint, {-1, 0.5}), InputError);
}

TEST_CASE("guide faces: each end carries half the force and the couple, and the gib presses what is left")
{
    const auto normal = [](double preload, double force, double moment) {
        return guide_normal_force({preload, 0.5}, force, moment);
    };
    CHECK(normal(0, 30, 20) == near(55 + 25, 1e-5));   // ends: 15 + 40 and 15 - 40
    CHECK(normal(30, 30, 20) == near(55 + 30, 1e-5));  // the second end's 25 stay within the preload
    CHECK(normal(60, 30, 20) == near(2 * 60, 1e-5));   // both do
    CHECK(normal(0, 30, 5) == near(30, 1e-5));         // 25 and 5 on the same face
    for (const double preload : {0.0, 10.0, 20.0})     // without a moment, or without a length
        for (const double force : {-50.0, 0.0, 30.0}) {
            CHECK(normal(preload, force, 0) == near(std::max(2 * preload, std::abs(force)), 1e-5));
            CHECK(guide_normal_force({preload, std::nullopt}, force, 20) == normal(preload, force, 0));
            CHECK(normal(preload, force, 20) == normal(preload, -force, 20));
            CHECK(normal(preload, force, 20) == normal(preload, force, -20));
        }
}

TEST_CASE("each side of a guide carries what presses it")
{
    const auto sides = [](double preload, double force, double moment) {
        return guide_side_forces({preload, 0.5}, force, moment);
    };
    CHECK(sides(20, 0, 0).plus == near(20, 1e-5));   // half of the gib's 2 x 20 at each of two ends
    CHECK(sides(20, 30, 0).plus == near(35, 1e-5));  // 17.5 at each end: (20 + 15) / 2
    CHECK(sides(20, 30, 0).minus == near(5, 1e-5));  // (20 - 15) / 2 at each end
    CHECK(sides(20, 60, 0).plus == near(60, 1e-5));  // the other side has lifted off
    CHECK(sides(20, 60, 0).minus == near(0, 0, 1.2e-5));
    CHECK(sides(0, 30, 20).plus == near(55, 1e-5));   // ends: 15 + 40 and 15 - 40
    CHECK(sides(0, 30, 20).minus == near(25, 1e-5));  // tilted: the second end leans on the other side
    for (const double preload : {0.0, 10.0, 20.0})
        for (const double force : {-50.0, 0.0, 30.0}) {
            const auto both = sides(preload, force, 8);
            CHECK(both.plus + both.minus == near(guide_normal_force({preload, 0.5}, force, 8), 1e-5));
            CHECK(both.plus - both.minus == near(force, 1e-5));  // equilibrium
            CHECK(sides(preload, -force, 8).plus == near(both.minus, 1e-5));
        }
}

TEST_CASE("duties that mean nothing are refused")
{
    CHECK_THROWS_AS(turn_weights({}, period), InputError);
    CHECK_THROWS_AS(turn_weights({0, 0.1, 0.1}, period), InputError);
    CHECK_THROWS_AS(turn_weights({0, 0.1, 0.3}, period), InputError);
    CHECK_THROWS_AS(turn_weights({0, 0.1}, 0), InputError);
    CHECK_THROWS_AS(duty_of(BearingCycle{}, 1), InputError);
    CHECK_THROWS_AS(steady_duty(std::nan(""), 1), InputError);
    CHECK_THROWS_AS(shared(steady_duty(1, 1), -1), InputError);
    CHECK_THROWS_AS(check(Duty{{0.5}, {1}, {1}}), InputError);
    CHECK_THROWS_AS(duty_mean(Duty{{1}, {1}, {}}, 1, 1), InputError);
    auto [turn, joint] = turn_of(
        8,
        [](double) {
            return Vec2{1, 0};
        },
        [](double) { return 1; });
    joint.sliding.pop_back();
    CHECK_THROWS_AS(duty_of(turn, joint), InputError);
}
