#include "deadpoint/mechanism/cycle.hpp"

#include "balance.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/mechanism/bottom_dead_point.hpp"
#include "deadpoint/mechanism/turn.hpp"
#include "driver_speed.hpp"
#include "linkages.hpp"
#include "near.hpp"

#include <cmath>
#include <doctest/doctest.h>
#include <limits>
#include <numbers>

using namespace deadpoint;
using doctest::Contains;
using mechanism::CycleRequest;

namespace {

constexpr double pi = std::numbers::pi;
constexpr double crank = 0.025;
constexpr double rod = 0.383;
const double speed = 200 * pi / 30;

/// Horizontal slider-crank with the masses of a small press; assembled at outer dead point, x to the right.
CycleRequest slider_crank_request()
{
    CycleRequest request;
    request.masses = {{}, {30, {0.01, 0.004}, 0.2}, {12, {0.15, 0.01}, 0.15}, {80, {crank + rod, 0.02}, 0}};
    request.speed = mechanism::steady_speed(speed).speed;
    request.positions = 72;
    return request;
}

/// Joint forces of the slider-crank from its textbook equations, at a crank angle from outer dead point.
struct ClosedForm {
    double height, velocity, acceleration;
    Vec2 on_slide;  ///< by the rod
    Vec2 on_crank;  ///< by the rod
    double torque;
    double guide_force, guide_moment;  ///< on the slide

    ClosedForm(const CycleRequest& request, double theta, double w, double alpha, double process, double offset)
    {
        const double g = -request.gravity[1];
        const Vec2 pin{crank * std::cos(theta), crank * std::sin(theta)};
        const double psi = std::asin(-pin[1] / rod);  // of the rod
        const double rate = -crank * w * std::cos(theta) / (rod * std::cos(psi));
        const double spin =
            (-crank * alpha * std::cos(theta) + crank * w * w * std::sin(theta) + rod * rate * rate * std::sin(psi)) /
            (rod * std::cos(psi));
        height = pin[0] + rod * std::cos(psi) - (rod - crank);
        velocity = -pin[1] * w - rod * std::sin(psi) * rate;
        acceleration =
            -pin[1] * alpha - pin[0] * w * w - rod * std::sin(psi) * spin - rod * std::cos(psi) * rate * rate;

        const auto turn = [](const Vec2& v, double a) {
            return Vec2{std::cos(a) * v[0] - std::sin(a) * v[1], std::sin(a) * v[0] + std::cos(a) * v[1]};
        };
        const auto accelerated = [](const Vec2& arm, double w1, double a1) {
            return a1 * Vec2{-arm[1], arm[0]} - w1 * w1 * arm;
        };
        const BodyMass& m2 = request.masses[1];
        const BodyMass& m3 = request.masses[2];
        const BodyMass& m4 = request.masses[3];
        const Vec2 to_centre = turn(m3.centre - Vec2{crank, 0}, psi);
        const Vec2 to_wrist{rod * std::cos(psi), rod * std::sin(psi)};
        const Vec2 a3 = accelerated(pin, w, alpha) + accelerated(to_centre, rate, spin);
        // Force on the rod by the slide: along x from the slide's motion, along y from moments about the crank pin.
        const double x = -(m4.mass * acceleration - process);
        const Vec2 inertia = m3.mass * (a3 + Vec2{0, g});
        const double y = (balance::cross(to_centre, inertia) + m3.inertia * spin + to_wrist[1] * x) / to_wrist[0];
        on_slide = {-x, -y};
        on_crank = Vec2{x, y} - inertia;
        const Vec2 centre2 = turn(m2.centre, theta);
        torque = m2.inertia * alpha + balance::cross(centre2, m2.mass * accelerated(centre2, w, alpha)) +
                 m2.mass * g * centre2[0] - balance::cross(pin, on_crank);
        guide_force = m4.mass * g - on_slide[1];
        // About the wrist pin: weight, inertia and process force do not pass through it.
        const Vec2 arm4 = m4.centre - Vec2{crank + rod, 0};
        const Vec2 load{process - m4.mass * acceleration, -m4.mass * g};
        guide_moment = -(balance::cross(arm4, load) - balance::cross(arm4, {process, 0})) -
                       balance::cross({0, -offset}, {process, 0});
    }
};

void check_against_closed_form(const CycleRequest& request, const CycleHistory& history)
{
    const Linkage linkage = linkages::slider_crank(crank, rod);
    for (std::size_t i = 0; i < history.angle.size(); ++i) {
        const double past = std::remainder(history.angle[i] - history.angle[0], 2 * pi);
        const double slope = request.speed_slope ? request.speed_slope(past) : 0.0;
        const double w = history.speed[i];
        const ClosedForm exact(request, history.angle[i], w, w * slope, history.process_force[i],
                               request.process_force_offset);
        // Absolute, 1e-9 of the largest of each kind: 0.05 m, 0.5 m/s, 12 m/s2, 1 to 50 kN, 1 kN m.
        CHECK(std::abs(history.height[i] - exact.height) < 1e-13);
        CHECK(std::abs(history.slide_speed[i] - exact.velocity) < 1e-10);
        CHECK(std::abs(history.slide_acceleration[i] - exact.acceleration) < 1e-9);
        CHECK(norm(history.joints[2].force[i] + exact.on_slide) < 1e-6);  // on the rod by the slide
        CHECK(norm(history.joints[1].force[i] + exact.on_crank) < 1e-6);  // on the rod by the crank
        CHECK(std::abs(history.drive_torque[i] - exact.torque) < 1e-7);
        CHECK(std::abs(history.joints[3].force[i][0]) < 1e-9);
        CHECK(std::abs(history.joints[3].force[i][1] - exact.guide_force) < 1e-6);
        CHECK(std::abs(history.joints[3].moment[i] - exact.guide_moment) < 1e-7);
        CHECK(std::abs(history.joints[3].sliding[i] - exact.velocity) < 1e-10);
        CHECK(std::abs(history.joints[0].sliding[i] - w) < 1e-12);
    }
    balance::require_balanced(linkage, request, history);
}

CycleHistory run(const CycleRequest& request)
{
    return mechanism::analyse_cycle(linkages::slider_crank(crank, rod), request);
}

}  // namespace

TEST_CASE("slider-crank: motion, joint forces, guide and torque are those of the closed form")
{
    CycleRequest request = slider_crank_request();
    SUBCASE("without process force") {}
    SUBCASE("eccentric process force")
    {
        // Force towards +x while the slide comes in; the line of action lies to the right of +x, which is below.
        request.process_force = mechanism::elastic_contact_of_peak(1e8, 5e4);
        request.process_force_offset = 0.07;
    }
    SUBCASE("weight along the stroke") { request.gravity = {0, 0}; }
    check_against_closed_form(request, run(request));
}

TEST_CASE("slider-crank: figures of the stroke against the closed form")
{
    const CycleRequest request = slider_crank_request();
    const Linkage linkage = linkages::slider_crank(crank, rod);
    const CycleHistory history = run(request);
    const auto figures = mechanism::stroke_figures(linkage, request, history);
    CHECK(figures.stroke == near(2 * crank, 1e-13));
    CHECK(std::abs(std::remainder(figures.bottom_dead_point - pi, 2 * pi)) < 1e-11);
    CHECK(std::abs(std::remainder(figures.top_dead_point, 2 * pi)) < 1e-11);
    CHECK(figures.largest_acceleration == near(crank * speed * speed * (1 + crank / rod), 1e-12));
    // Height over the angle from inner dead point: (L - r) + h = sqrt(L^2 - s^2) - r cos; from the triangle of crank,
    // rod and the distance d = L - r + h of the wrist pin: cos = (d^2 + r^2 - L^2) / (2 r d), counted from outer.
    for (const auto& [share, height] : {std::pair{figures.dwell_10um, 10e-6}, {figures.dwell_100um, 100e-6}}) {
        const double d = rod - crank + height;
        const double from_outer = std::acos((d * d + crank * crank - rod * rod) / (2 * crank * d));
        CHECK(share == near((pi - from_outer) / pi, 1e-9));
    }
    // Largest speed by fine search of the closed form, which is flat there: 1e-5 rad leaves 1e-10.
    double largest = 0;
    for (double theta = 1.3; theta < 1.7; theta += 1e-5)
        largest = std::max(largest, std::abs(ClosedForm(request, theta, speed, 0, 0, 0).velocity));
    CHECK(figures.largest_speed == near(largest, 1e-9));
}

TEST_CASE("slider-crank: force ratio by the tangential force of the crank")
{
    const CycleRequest request = slider_crank_request();
    const auto ratios = mechanism::force_ratios(linkages::slider_crank(crank, rod), run(request));
    CHECK(ratios.size() == 70);  // all but the dead points
    for (const auto& ratio : ratios) {
        // Tangential force at the pin by force in the rod: sin(theta - psi), rod force by slide force: 1 / cos psi.
        const double theta = ratio.past_bottom + pi;
        const double psi = std::asin(-crank * std::sin(theta) / rod);
        CHECK(ratio.advantage == near(std::cos(psi) / std::abs(std::sin(theta - psi)), 1e-10));
        CHECK(ratio.force_by_torque == near(ratio.advantage / crank, 1e-5));
    }
}

TEST_CASE("work of the process appears as mean drive power")
{
    CycleRequest request = slider_crank_request();
    // 30 kN over the last 5 mm, on the way down only: 150 J per turn, 500 W at 200 rpm.
    request.process_force = mechanism::force_over_height({0, 0.0049, 0.0051}, {3e4, 3e4, 0});
    request.positions = 3600;
    const auto drive = mechanism::drive_figures(run(request));
    CHECK(drive.mean_power == near(500, 1e-4));  // sums over a force that jumps at bottom dead point
    CHECK(drive.mean_torque == near(500 / speed, 1e-4));
    CHECK(drive.rms_torque > drive.mean_torque);
}

TEST_CASE("a speed that varies over the turn")
{
    CycleRequest request = slider_crank_request();
    SUBCASE("with a known time: w = w0 / (1 + e cos), t = (angle + e sin(angle)) / w0")
    {
        const double e = 0.3;
        request.speed = [=](double a) { return speed / (1 + e * std::cos(a)); };
        request.speed_slope = [=](double a) { return speed * e * std::sin(a) / std::pow(1 + e * std::cos(a), 2); };
        const CycleHistory history = run(request);
        check_against_closed_form(request, history);
        CHECK(history.period == near(2 * pi / speed, 1e-14));
        for (std::size_t i = 0; i < history.time.size(); ++i) {
            const double angle = history.angle[i] - history.angle[0];
            CHECK(std::abs(history.time[i] - (angle + e * std::sin(angle)) / speed) < 1e-14);
        }
        // Without losses the drive gives back what it gave, and the energy over the turn is that of the torque.
        CHECK(std::abs(mechanism::drive_figures(history).mean_power) <
              1e-9 * mechanism::drive_figures(history).peak_torque * speed);
    }
    SUBCASE("from a table")
    {
        const auto table = mechanism::tabulated_speed({-2.5, -0.4, 0.3, 1.9}, {20, 23, 12, 17});
        request.speed = table.speed;
        request.speed_slope = table.slope;
        request.speed_breaks = table.breaks;
        const CycleHistory history = run(request);
        check_against_closed_form(request, history);
        for (const auto& [angle, value] : {std::pair{-2.5, 20.0}, {-0.4, 23.0}, {0.3, 12.0}, {1.9, 17.0}})
            CHECK(table.speed(angle) == near(value, 1e-14));
        // Simpson's rule with steps of 2 pi / 1e6 on a curve with a continuous derivative: error below 1e-12.
        const int steps = 1000000;
        double period = 0;
        for (int i = 0; i < steps; ++i)
            period += (i % 2 == 0 ? 2.0 : 4.0) / 3 * (2 * pi / steps) / table.speed(-pi + 2 * pi * i / steps);
        CHECK(history.period == near(period, 1e-11));
        for (double angle = -pi; angle < pi; angle += 0.01) {
            CHECK(table.speed(angle) >= 12 - 1e-12);
            CHECK(table.speed(angle) <= 23 + 1e-12);
            const double slope = (table.speed(angle + 1e-6) - table.speed(angle - 1e-6)) / 2e-6;
            CHECK(std::abs(table.slope(angle) - slope) < 1e-4);  // second derivatives up to some hundred, times 1e-6
        }
        CHECK(table.speed(pi) == near(table.speed(-pi), 1e-14));
        for (const double point : table.breaks)  // second derivatives up to some hundred, times 2e-9
            CHECK(std::abs(table.slope(point + 1e-9) - table.slope(point - 1e-9)) < 1e-5);
    }
    SUBCASE("a table of equal speeds is a steady speed")
    {
        const auto table = mechanism::tabulated_speed({-1, 0, 2}, {speed, speed, speed});
        request.speed = table.speed;
        request.speed_slope = table.slope;
        const CycleHistory history = run(request);
        check_against_closed_form(request, history);
        CHECK(history.period == near(2 * pi / speed, 1e-15));
    }
}

TEST_CASE("positions start at bottom dead point and are evenly spaced")
{
    const CycleHistory history = run(slider_crank_request());
    CHECK(history.angle.size() == 72);
    CHECK(std::abs(std::abs(history.angle[0]) - pi) < 1e-10);
    for (std::size_t i = 0; i + 1 < history.angle.size(); ++i)
        CHECK(history.angle[i + 1] - history.angle[i] == near(2 * pi / 72, 1e-13));
    CHECK(std::abs(history.height[0]) < 1e-15);
    CHECK(history.time[36] == near(history.period / 2, 1e-14));
    // The crank's angle in its pose is the driver's.
    for (std::size_t i = 0; i < history.angle.size(); ++i)
        CHECK(std::abs(history.bodies[1].pose[i].angle - history.angle[i]) < 1e-12);
}

TEST_CASE("a massless link passes its force on along its line")
{
    CycleRequest request = slider_crank_request();
    request.masses[2] = {};
    const CycleHistory history = run(request);
    for (std::size_t i = 0; i < history.angle.size(); ++i) {
        const Vec2 line = history.joints[2].centre[i] - history.joints[1].centre[i];
        CHECK(std::abs(balance::cross(line, history.joints[1].force[i])) < 1e-9);
    }
}

TEST_CASE("a slide carried by a moving body: reactions balance")
{
    const Linkage linkage = linkages::quick_return();
    CycleRequest request;
    request.masses = {{}, {3, {0.05, 0.02}, 0.02}, {7, {0.02, -0.1}, 0.1}, {2, {0.1, 0.05}, 0.004}};
    request.speed = mechanism::steady_speed(9).speed;
    request.positions = 60;
    request.process_force = [](double past, double, double) { return 100 * std::cos(past); };
    balance::require_balanced(linkage, request, mechanism::analyse_cycle(linkage, request));
}

TEST_CASE("what is wrong with masses, speed and loads is said with the remedy")
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    CycleRequest request = slider_crank_request();
    const auto refuses = [&](const char* text) { CHECK_THROWS_WITH_AS(run(request), Contains(text), InputError); };
    SUBCASE("mass")
    {
        request.masses[2].mass = -12;
        refuses("body 'rod': mass -12 kg");
    }
    SUBCASE("mass not a number")
    {
        request.masses[2].mass = nan;
        refuses("body 'rod': mass nan kg");
    }
    SUBCASE("centre")
    {
        request.masses[2].centre = {nan, 0};
        refuses("body 'rod'");
    }
    SUBCASE("inertia")
    {
        request.masses[3].inertia = -1;
        refuses("body 'slide': inertia -1 kg m2");
    }
    SUBCASE("inertia without mass")
    {
        request.masses[1].mass = 0;
        refuses("body 'crank' has an inertia of 0.2 kg m2 but no mass");
    }
    SUBCASE("inertia needed")
    {
        request.masses[2].inertia = 0;
        refuses("body 'rod' has mass but no inertia");
    }
    SUBCASE("inertia of a crank whose speed varies")
    {
        request.masses[1].inertia = 0;
        CHECK_NOTHROW(run(request));
        const auto table = mechanism::tabulated_speed({0, 2}, {20, 22});
        request.speed = table.speed;
        request.speed_slope = table.slope;
        refuses("body 'crank' has mass but no inertia");
    }
    SUBCASE("number of masses")
    {
        request.masses.pop_back();
        refuses("the linkage has 4 bodies, but 3 masses are given");
    }
    SUBCASE("no speed")
    {
        request.speed = nullptr;
        refuses("the driver has no speed");
    }
    SUBCASE("speed")
    {
        request.speed = [](double a) { return 3 - a; };
        request.speed_slope = [](double) { return -1.0; };
        refuses("driver's speed is");
    }
    SUBCASE("speed slope")
    {
        request.speed = [](double a) { return 9 - a; };
        refuses("its derivative is not given");
    }
    SUBCASE("positions")
    {
        request.positions = 3;
        refuses("a cycle of 3 positions");
    }
    SUBCASE("offset")
    {
        request.process_force_offset = nan;
        refuses("is not finite");
    }
    SUBCASE("breaks")
    {
        request.speed_breaks = {nan};
        refuses("break of the driver's speed");
    }
    SUBCASE("process force")
    {
        request.process_force = [&](double, double height, double) { return height > 0.02 ? nan : 0.0; };
        CHECK_THROWS_WITH_AS(run(request), Contains("the process force is nan N at"), DomainError);
    }
    SUBCASE("slope not finite")
    {
        request.speed_slope = [&](double) { return nan; };
        CHECK_THROWS_WITH_AS(run(request), Contains("derivative of the driver's speed"), DomainError);
    }
}

TEST_CASE("tables of the driver's speed that cannot be are refused")
{
    using mechanism::tabulated_speed;
    CHECK_THROWS_WITH_AS(mechanism::steady_speed(0), Contains("driver's speed is 0 rad/s"), InputError);
    CHECK_THROWS_WITH_AS(tabulated_speed({}, {}), Contains("0 angles and 0 speeds"), InputError);
    CHECK_THROWS_WITH_AS(tabulated_speed({0, 1}, {3}), Contains("2 angles and 1 speeds"), InputError);
    CHECK_THROWS_WITH_AS(tabulated_speed({0, 1}, {3, -3}), Contains("driver's speed is -3"), InputError);
    CHECK_THROWS_WITH_AS(tabulated_speed({0, 2, 1}, {3, 3, 3}), Contains("does not increase in angle at its point 3"),
                         InputError);
    CHECK_THROWS_WITH_AS(tabulated_speed({0, 2 * pi}, {3, 3}), Contains("spans a whole turn"), InputError);
}

TEST_CASE("a cycle on known positions is the cycle")
{
    const Linkage linkage = linkages::slider_crank(crank, rod);
    CycleRequest request = slider_crank_request();
    const auto known = mechanism::turn_of(linkage, request.positions);
    for (const double factor : {1.0, 1.7}) {
        request.speed = [factor](double) { return factor * speed; };
        const auto alone = mechanism::analyse_cycle(linkage, request);
        const auto found = mechanism::analyse_cycle(linkage, request, known);
        CHECK(found.drive_torque == alone.drive_torque);
        CHECK(found.height == alone.height);
        CHECK(found.time == alone.time);
    }
    request.positions += 1;
    CHECK_THROWS_AS(mechanism::analyse_cycle(linkage, request, known), InputError);
    CHECK_THROWS_AS(mechanism::turn_of(linkage, 3), InputError);
}
