#include "deadpoint/crankshaft/cycle.hpp"

#include "deadpoint/crankshaft/response/periodic_load.hpp"
#include "deadpoint/crankshaft/shaft/check.hpp"
#include "deadpoint/crankshaft/shaft/shaft_loads.hpp"
#include "deadpoint/error.hpp"
#include "near.hpp"
#include "shafts.hpp"

#include <cmath>
#include <doctest/doctest.h>

using namespace deadpoint;
using namespace deadpoint::crankshaft;

namespace {

constexpr double turn = 2 * std::numbers::pi;

/// Steady speed, with the pin pressed down by a smooth pulse of `peak` [N] and swayed sideways.
ShaftLoads smooth_loads(double pin, double peak, double period = 0.3, int positions = 720, double sense = 1)
{
    ShaftLoads loads;
    loads.period = period;
    loads.pin_position = pin;
    for (int n = 0; n < positions; ++n) {
        const double angle = turn * n / positions;
        loads.time.push_back(period * n / positions);
        loads.throw_angle.push_back(0.4 + sense * angle);
        loads.pin_force.push_back({0.05 * peak * std::sin(angle), -peak * std::exp(-5 * (1 - std::cos(angle - 2)))});
    }
    return loads;
}

Vec2 sum_of(const ShaftCycle& cycle, std::size_t n, std::size_t first, std::size_t last)
{
    Vec2 sum{};
    for (std::size_t b = first; b <= last; ++b)
        sum = sum + cycle.bearings[b].force[n];
    return sum;
}

Vec2 mean_of(const std::vector<Vec2>& values)
{
    Vec2 sum{};
    for (const Vec2& value : values)
        sum = sum + value;
    return (1.0 / static_cast<double>(values.size())) * sum;
}

double weight_of(const Shaft& shaft)
{
    double mass = 0;
    for (const Section& section : shaft.sections)
        mass += section_mass(section);
    for (const Disk& disk : shaft.disks)
        mass += disk.mass;
    return 9.81 * mass;
}

/// Largest difference of the bearing forces [N].
double apart(const ShaftCycle& a, const ShaftCycle& b)
{
    double worst = 0;
    for (std::size_t i = 0; i < a.bearings.size(); ++i)
        for (std::size_t n = 0; n < a.time.size(); ++n)
            worst = std::max(worst, norm(a.bearings[i].force[n] - b.bearings[i].force[n]));
    return worst;
}

}  // namespace

TEST_CASE("bearing cycle: its statistics")
{
    const BearingCycle cycle = summarise("left", {{3, 4}, {-6, 8}, {0, 0}, {0, -10}});
    CHECK(cycle.peak == 10);
    CHECK(cycle.peak_x_y[0] == 6);
    CHECK(cycle.peak_x_y[1] == 10);
    CHECK(cycle.mean[0] == near(-0.75, 1e-5));
    CHECK(cycle.mean[1] == near(0.5, 1e-5));
    CHECK(cycle.mean_magnitude == near(6.25, 1e-5));
    CHECK(cycle.rms == near(7.5, 1e-5));
    CHECK(cycle.mean_rolling_load == near((std::pow(5, 1.33) + 2 * std::pow(10, 1.33)) / 4, 1e-5));
    CHECK_THROWS_AS(summarise("left", {}), DomainError);
    CHECK_THROWS_AS(summarise("left", {{std::nan(""), 0}}), DomainError);
}

TEST_CASE("rigid shaft: lever rule for pin, weight, disk, belt and unbalance")
{
    Shaft shaft = shafts::steel();
    shaft.start = -0.1;
    shaft.sections = {{1.2, 0.1, 0, 1000}};
    shaft.disks = {{1.0, 40, 1, 0.6}};
    shaft.bearings = {shafts::bearing("left", 0, 1e8), shafts::bearing("right", 0.8, 1e8)};
    shaft.unbalances = {{0.2, 0.5, std::numbers::pi / 2}};
    ShaftLoads loads = smooth_loads(0.2, 1e4);
    loads.steady = {{1.0, {300, -100}}};
    loads.samples = 720;
    const ShaftCycle cycle = rigid_cycle(shaft, loads);
    const double section = 9.81 * 1000 * std::numbers::pi / 4 * 0.01 * 1.2;  // at 0.5 m
    const double omega = turn / 0.3;
    CHECK(cycle.speed == near(omega, 1e-5));
    for (std::size_t n = 0; n < 720; n += 37) {
        const double throw_angle = loads.throw_angle[n];
        const Vec2 unbalance{-0.5 * omega * omega * std::sin(throw_angle), 0.5 * omega * omega * std::cos(throw_angle)};
        const Vec2 at_crank = loads.pin_force[n] + unbalance;
        const Vec2 right = 0.25 * at_crank + (0.5 / 0.8) * Vec2{0, -section} + 1.25 * Vec2{300, -100 - 9.81 * 40};
        const Vec2 total = at_crank + Vec2{300, -100 - 9.81 * 40 - section};
        // The unbalance's speed is a difference of angles: rounding over the time step.
        CHECK(norm(cycle.bearings[1].force[n] - right) < 1e-6);
        CHECK(norm(cycle.bearings[0].force[n] - (total - right)) < 1e-6);
    }
}

TEST_CASE("rigid shaft: more than two bearings form two seats beside the pin, shared equally")
{
    const Shaft shaft = shafts::table1("elemmid", 5e7);
    ShaftLoads loads = smooth_loads(shafts::crank_middle, 4e4);
    loads.gravity = {0, 0};
    const ShaftCycle cycle = rigid_cycle(shaft, loads);
    for (std::size_t n = 0; n < cycle.time.size(); n += 100) {
        CHECK(norm(cycle.bearings[0].force[n] - cycle.bearings[1].force[n]) == 0);
        CHECK(norm(cycle.bearings[2].force[n] - cycle.bearings[3].force[n]) == 0);
        // Symmetric about the crank's middle.
        CHECK(norm(cycle.bearings[0].force[n] - cycle.bearings[2].force[n]) < 1e-9 * 4e4);
    }
    CHECK(seats_of(shaft, shafts::crank_middle) == std::vector<int>{0, 0, 1, 1});
    const auto seats = seat_cycles(cycle, seats_of(shaft, shafts::crank_middle));
    CHECK(seats[0].name == "bearing 3 + bearing 4");
    CHECK(seats[1].peak == near(2 * cycle.bearings[2].peak, 1e-12));
    // The weight lifts the shaft from the left seat: about -1.4 and +8.0 kN.
    const StaticState resting = static_state(shaft, smooth_loads(shafts::crank_middle, 0));
    const ShaftCycle rigid = rigid_cycle(shaft, smooth_loads(shafts::crank_middle, 0));
    CHECK(sum_of(rigid, 0, 0, 1)[1] == near(1.4e3, 0.05));
    CHECK(sum_of(rigid, 0, 2, 3)[1] == near(-8.0e3, 0.01));
    CHECK(resting.bearing_force[2][1] + resting.bearing_force[3][1] == near(-8.0e3, 0.02));
}

TEST_CASE("rigid shaft: with all bearings on one side of the pin the widest gap divides them")
{
    Shaft shaft = shafts::small_shaft();
    shaft.bearings = {shafts::bearing("a", 0.05, 1e8), shafts::bearing("b", 0.1, 1e8), shafts::bearing("c", 0.4, 1e8)};
    ShaftLoads loads = smooth_loads(0.5, 1e4);
    loads.gravity = {0, 0};
    const ShaftCycle cycle = rigid_cycle(shaft, loads);
    const Vec2 seat_c = ((0.5 - 0.075) / (0.4 - 0.075)) * loads.pin_force[0];
    CHECK(norm(cycle.bearings[2].force[0] - seat_c) < 1e-9 * 1e4);
    CHECK(norm(cycle.bearings[0].force[0] - cycle.bearings[1].force[0]) == 0);
}

TEST_CASE("flexible shaft: stiff and on stiff bearings it gives the rigid reactions")
{
    Shaft shaft = shafts::table1("elemmid", 1e12);
    shaft.youngs_modulus = 2e16;
    shaft.modal_damping = 0.02;
    shaft.unbalances = {{shafts::crank_middle, 2.0, 0.3}};
    ShaftLoads loads = smooth_loads(shafts::crank_middle, 4e4);
    loads.steady = {{shaft.disks[0].position, {500, -200}}};
    const ShaftCycle four_rigid = rigid_cycle(shaft, loads);
    const ShaftCycle four = flexible_cycle(shaft, loads);
    // Within a seat the bearings share a moment, too, which shifts the seat's force by 0.3 % of the overhung weight.
    for (std::size_t n = 0; n < four.time.size(); n += 60)
        for (const std::size_t seat : {0, 2})
            CHECK(norm(sum_of(four_rigid, n, seat, seat + 1) - sum_of(four, n, seat, seat + 1)) < 0.005 * 8e3);

    shaft.bearings = {shaft.bearings[0], shaft.bearings[3]};
    // First mode at several kHz: 2 zeta omega / omega_1 of the pulse leaves 1e-5, its kinks at the samples as much.
    CHECK(apart(rigid_cycle(shaft, loads), flexible_cycle(shaft, loads)) < 1e-4 * 4e4);
}

TEST_CASE("flexible shaft: almost without mass it hands the pin's force on, whatever its bearings' dampers take of it")
{
    Shaft shaft = shafts::small_shaft();
    for (Section& section : shaft.sections)
        section.density *= 1e-6;
    shaft.disks.clear();
    shaft.modal_damping = 0;
    for (Bearing& bearing : shaft.bearings)
        bearing.damping = {{{2e6, 3e5}, {1e5, 4e6}}};  // at the rate of the pulse as much as the springs
    ShaftLoads loads = smooth_loads(0.2, 4e4);
    loads.samples = 720;
    const ShaftCycle cycle = flexible_cycle(shaft, loads);
    REQUIRE(cycle.time.size() == loads.pin_force.size());
    double worst = 0;
    for (std::size_t n = 0; n < cycle.time.size(); ++n)
        worst = std::max(worst, norm(sum_of(cycle, n, 0, 1) - loads.pin_force[n]));
    CHECK(worst < 1e-6 * 4e4);  // what is left of the mass
}

TEST_CASE("flexible shaft: mean reactions balance the mean loads, forces and moments")
{
    Shaft shaft = shafts::table1("literal", 5e8);
    shaft.modal_damping = 0.02;
    shaft.unbalances = {{shafts::crank_middle, 2.0, 0.3}};
    ShaftLoads loads = smooth_loads(shafts::crank_middle, 4e4, 0.1);
    loads.pin_width = 0.204;
    loads.samples = 1440;
    const ShaftCycle cycle = flexible_cycle(shaft, loads);
    const Vec2 pin = mean_of(loads.pin_force);
    Vec2 force{};
    Vec2 moment{};
    for (std::size_t b = 0; b < 4; ++b) {
        force = force + cycle.bearings[b].mean;
        moment = moment + shaft.bearings[b].position * cycle.bearings[b].mean;
    }
    const double weight = weight_of(shaft);
    CHECK(norm(force - pin - Vec2{0, -weight}) < 1e-8 * weight);
    double weight_moment = 9.81 * shaft.disks[0].mass * shaft.disks[0].position;
    double begin = 0;
    for (const Section& section : shaft.sections) {
        weight_moment += 9.81 * section_mass(section) * (begin + 0.5 * section.length);
        begin += section.length;
    }
    CHECK(norm(moment - shafts::crank_middle * pin - Vec2{0, -weight_moment}) < 1e-8 * weight_moment);
}

TEST_CASE("flexible shaft: the three methods agree")
{
    const Shaft shaft = shafts::small_shaft();
    ShaftLoads loads = smooth_loads(0.2, 1e4, 0.02, 90);
    loads.samples = 360;
    const ShaftCycle exact = flexible_cycle(shaft, loads);
    PeriodicSettings settings;
    settings.method = PeriodicMethod::harmonic_balance;
    settings.harmonics = 600;  // the tail behind falls with k^-4
    const double scale = exact.bearings[0].peak;
    CHECK(apart(exact, flexible_cycle(shaft, loads, settings)) < 1e-5 * scale);
    settings.method = PeriodicMethod::newmark;
    settings.steps_per_sample = 16;
    CHECK(apart(exact, flexible_cycle(shaft, loads, settings)) < 1e-3 * scale);
}

TEST_CASE("flexible shaft: turning the other way mirrors the forces")
{
    Shaft shaft = shafts::table1("elemmid", 5e7);
    shaft.modal_damping = 0.02;
    shaft.unbalances = {{0.3, 1.0, 0.5}};
    ShaftLoads forward = smooth_loads(shafts::crank_middle, 4e4);
    forward.samples = 720;
    ShaftLoads backward = forward;
    for (std::size_t n = 0; n < forward.time.size(); ++n) {
        backward.throw_angle[n] = std::numbers::pi - forward.throw_angle[n];
        backward.pin_force[n][0] *= -1;
    }
    Shaft mirrored = shaft;
    mirrored.unbalances[0].angle *= -1;
    const ShaftCycle a = flexible_cycle(shaft, forward);
    const ShaftCycle b = flexible_cycle(mirrored, backward);
    CHECK(b.speed == near(-a.speed, 1e-5));
    for (std::size_t n = 0; n < 720; n += 50)
        for (std::size_t i = 0; i < 4; ++i) {
            const Vec2 f = b.bearings[i].force[n];
            CHECK(norm(a.bearings[i].force[n] - Vec2{-f[0], f[1]}) < 1e-7 * a.bearings[i].peak);
        }
    // The gyroscopic coupling is there at all: the sense matters if nothing is mirrored.
    ShaftLoads reversed = forward;
    for (double& angle : reversed.throw_angle)
        angle = -angle;
    CHECK(apart(a, flexible_cycle(shaft, reversed)) > 1e-3 * a.bearings[0].peak);
}

TEST_CASE("flexible shaft: times of any spacing give what an even grid gives")
{
    Shaft shaft = shafts::small_shaft();
    ShaftLoads even = smooth_loads(0.2, 1e4, 0.1, 1440);
    ShaftLoads uneven = even;
    uneven.time.clear();
    uneven.throw_angle.clear();
    uneven.pin_force.clear();
    for (std::size_t n = 0; n < even.time.size(); n += n % 3 == 0 ? 1 : 2) {
        uneven.time.push_back(even.time[n]);
        uneven.throw_angle.push_back(even.throw_angle[n]);
        uneven.pin_force.push_back(even.pin_force[n]);
    }
    REQUIRE(uneven.time.size() < even.time.size());
    // Linear interpolation over twice the step: curvature of the pulse times h^2 / 8.
    CHECK(apart(flexible_cycle(shaft, even), flexible_cycle(shaft, uneven)) < 1e-4 * 1e4);
}

TEST_CASE("flexible shaft: the turn may begin at any time")
{
    const Shaft shaft = shafts::small_shaft();
    const ShaftLoads loads = smooth_loads(0.2, 1e4);
    ShaftLoads later = loads;
    for (double& time : later.time)
        time += 7 * loads.period;
    // Times of 2.1 to 2.4 s are known to 4e-16 s, of steps of 0.4 ms.
    CHECK(apart(flexible_cycle(shaft, loads), flexible_cycle(shaft, later)) < 1e-8 * 1e4);
}

TEST_CASE("rigid shaft: unbalance at a varying speed is the inertia of its path")
{
    Shaft shaft = shafts::small_shaft();
    shaft.unbalances = {{0.2, 2.0, 0}};
    ShaftLoads loads = smooth_loads(0.2, 0, 0.3, 2880);
    loads.gravity = {0, 0};
    loads.samples = 2880;
    const double omega = turn / 0.3;
    const auto angle_at = [&](double t) { return omega * t + 0.2 * std::sin(omega * t); };
    for (std::size_t n = 0; n < loads.time.size(); ++n)
        loads.throw_angle[n] = angle_at(loads.time[n]);
    const ShaftCycle cycle = rigid_cycle(shaft, loads);
    for (std::size_t n = 0; n < loads.time.size(); n += 111) {
        const double t = loads.time[n];
        const double rate = omega * (1 + 0.2 * std::cos(omega * t));
        const double acceleration = -0.2 * omega * omega * std::sin(omega * t);
        const double c = std::cos(angle_at(t));
        const double s = std::sin(angle_at(t));
        const Vec2 expected{2 * (rate * rate * c + acceleration * s), 2 * (rate * rate * s - acceleration * c)};
        // Differences over 0.1 ms: (omega h)^2.
        CHECK(norm(sum_of(cycle, n, 0, 1) - expected) < 1e-5 * 2 * omega * omega);
    }
}

TEST_CASE("flexible shaft: stiffness that depends on load settles at the mean load")
{
    Shaft shaft = shafts::small_shaft();
    for (Bearing& bearing : shaft.bearings) {
        bearing.hertz_exponent = 1.5;
        bearing.reference_load = 2000;
    }
    const ShaftLoads loads = smooth_loads(0.2, 4e4, 0.1);
    const ShaftCycle cycle = flexible_cycle(shaft, loads);
    const StaticState mean = static_state(shaft, loads);
    for (std::size_t b = 0; b < 2; ++b) {
        CHECK(cycle.stiffness_factor[b] == near(std::cbrt(norm(mean.bearing_force[b]) / 2000), 1e-9));
        CHECK(cycle.stiffness_factor[b] != near(1, 0.01));
        CHECK(norm(cycle.bearings[b].mean - mean.bearing_force[b]) < 1e-3 * norm(mean.bearing_force[b]));
    }
    CHECK(cycle.warnings.empty());
    // Given with the settled stiffness outright, nothing changes.
    CHECK(apart(cycle, flexible_cycle(with_stiffness(shaft, cycle), loads)) < 1e-9 * cycle.bearings[0].peak);
    ShaftLoads light = smooth_loads(0.2, 0, 0.1);
    light.gravity = {0, -0.01};
    const ShaftCycle floating = flexible_cycle(shaft, light);
    REQUIRE(floating.warnings.size() == 2);
    CHECK(floating.warnings[0].text.find("'left'") != std::string::npos);
    CHECK(floating.stiffness_factor[0] == near(std::cbrt(0.01), 1e-5));
}

TEST_CASE("static state: the axis under the pin sags as the flexible shaft does on average")
{
    Shaft shaft = shafts::table1("elemmid", 5e8);
    shaft.modal_damping = 0.02;
    const ShaftLoads loads = smooth_loads(shafts::crank_middle, 4e4);
    const StaticState state = static_state(shaft, loads);
    const ShaftCycle cycle = flexible_cycle(shaft, loads);
    std::size_t pin = 0;
    while (std::abs(state.nodes[pin] - shafts::crank_middle) > 1e-6)
        ++pin;
    const Vec2 mean = mean_of(cycle.pin_deflection);
    CHECK(norm(mean - state.deflection[pin]) < 1e-8 * norm(mean));
}

TEST_CASE("loads: what is wrong is said")
{
    const Shaft shaft = shafts::small_shaft();
    const auto refusal = [&](auto change) {
        ShaftLoads loads = smooth_loads(0.2, 1e4);
        change(loads);
        try {
            flexible_cycle(shaft, loads);
        } catch (const InputError& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    const auto mentions = [](const std::string& text, const char* part) {
        return text.find(part) != std::string::npos;
    };
    CHECK(refusal([](ShaftLoads&) {}).empty());
    CHECK(mentions(refusal([](ShaftLoads& l) { l.pin_force.pop_back(); }), "719 pin forces"));
    CHECK(mentions(refusal([](ShaftLoads& l) { l.period = 0; }), "period"));
    CHECK(mentions(refusal([](ShaftLoads& l) { l.period = 0.2; }), "leave out the last"));
    CHECK(mentions(refusal([](ShaftLoads& l) { l.pin_position = 0.6; }), "not on the shaft"));
    CHECK(mentions(refusal([](ShaftLoads& l) { l.pin_width = 0.5; }), "not on the shaft"));
    CHECK(mentions(refusal([](ShaftLoads& l) { l.steady = {{-0.1, {1, 0}}}; }), "not on the shaft"));
    CHECK(mentions(refusal([](ShaftLoads& l) { l.throw_angle[5] = 0; }), "turns back"));
    CHECK(mentions(refusal([](ShaftLoads& l) { l.time[5] = 0; }), "does not ascend"));
    CHECK(mentions(refusal([](ShaftLoads& l) { l.pin_force[7][1] = std::nan(""); }), "entry 8"));
    CHECK(mentions(refusal([](ShaftLoads& l) { l.samples = 0; }), "samples"));
}
