#include "deadpoint/error.hpp"
#include "deadpoint/mechanism/planar_system.hpp"
#include "linkages.hpp"
#include "near.hpp"

#include <cmath>
#include <doctest/doctest.h>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>

using namespace deadpoint;
using mechanism::PlanarMotion;
using mechanism::PlanarSystem;

namespace {
constexpr double pi = std::numbers::pi;

nlohmann::json reference_linkage()
{
    std::ifstream file(std::string(DEADPOINT_TEST_DATA) + "/twelve_body_linkage.json");
    return nlohmann::json::parse(file);
}
}  // namespace

TEST_CASE("slider-crank: position, velocity and acceleration are those of the closed form")
{
    // Crank 25 mm, rod 383 mm, 200 rpm; the published table gives six to seven digits.
    const PlanarSystem system(linkages::slider_crank(0.025, 0.383));
    const double speed = 200 * 2 * pi / 60;
    struct Row {
        double angle, position, velocity, acceleration;
    };
    // The tabulated crank angle counts from outer dead point, where the test linkage is assembled.
    const Row rows[] = {{0, 0.408, 0, -11.682038},
                        {30, 0.404446599, -0.276606553, -9.855700},
                        {90, 0.382183202, -0.523598776, 0.717341},
                        {180, 0.358, 0, 10.250416}};
    for (const Row& row : rows) {
        const auto poses = system.follow(system.assembled(), 0, row.angle * pi / 180);
        const PlanarMotion motion = system.motion(poses, speed);
        const Vec2 pin{0.408, 0};
        CHECK(mechanism::place(poses[3], pin)[0] == near(row.position, 1e-8));
        CHECK(mechanism::velocity_of(poses[3], motion.velocities[3], pin)[0] ==
              near(row.velocity, 2e-9, 1e-15));  // at the dead points rounding of 0.5 m/s
        CHECK(mechanism::acceleration_of(poses[3], motion.velocities[3], motion.accelerations[3], pin)[0] ==
              near(row.acceleration, 1e-6));
    }
}

TEST_CASE("twelve-body linkage: joints and angles over the turn agree with an independent multibody program")
{
    const nlohmann::json data = reference_linkage();
    const double speed = data["omega"];
    for (const auto& set : data["sets"]) {
        const PlanarSystem system(linkages::twelve_body(set["rows"]));
        const auto& assembled = linkages::row_at(set["rows"], 270);
        for (const auto& row : set["rows"]) {
            const double angle = (row["theta_deg"].get<double>() - 270) * pi / 180;
            const auto poses = system.follow(system.assembled(), 0, angle);
            const PlanarMotion motion = system.motion(poses, speed);
            for (const auto& [joint, reference] : row["joint"].items()) {
                const auto carrier = linkages::carrier_of(joint);
                if (carrier < 0)
                    continue;
                const auto start = assembled["joint"][joint]["p"].get<Vec2>();
                const Vec2 p = mechanism::place(poses[carrier], start);
                const Vec2 v = mechanism::velocity_of(poses[carrier], motion.velocities[carrier], start);
                const Vec2 a = mechanism::acceleration_of(poses[carrier], motion.velocities[carrier],
                                                          motion.accelerations[carrier], start);
                // 1e-8 of the largest value of each kind: 1 m, 1 m/s, 20 m/s2.
                CHECK(norm(p - reference["p"].get<Vec2>()) < 1e-8);
                CHECK(norm(v - reference["v"].get<Vec2>()) < 1e-8);
                CHECK(norm(a - reference["a"].get<Vec2>()) < 2e-7);
            }
            for (const auto& [body, reference] : row["body"].items()) {
                const int index = linkages::body_of(body);
                if (index < 0)
                    continue;
                const double turned = reference["angle"].get<double>() - assembled["body"][body]["angle"].get<double>();
                CHECK(std::abs(std::remainder(poses[index].angle - turned, 2 * pi)) < 1e-8);
                CHECK(std::abs(motion.velocities[index].angle - reference["w"].get<double>()) < 2e-7);
                CHECK(std::abs(motion.accelerations[index].angle - reference["alpha"].get<double>()) < 1e-6);
            }
        }
    }
}

TEST_CASE("a slide carried by a moving body: rates agree with finite differences")
{
    // Crank, oscillating guide and block (quick-return mechanism): the slide's normal turns with the guide.
    const PlanarSystem system(linkages::quick_return());
    const double speed = 3.0;
    const double h = 1e-4;
    const auto at = [&](double angle) { return system.follow(system.assembled(), 0, angle); };
    const double angle = 0.7;
    const PlanarMotion motion = system.motion(at(angle), speed, 0.5);
    const auto before = at(angle - h);
    const auto after = at(angle + h);
    for (std::size_t body = 1; body < motion.poses.size(); ++body) {
        const double first = (after[body].angle - before[body].angle) / (2 * h);
        const double second = (after[body].angle - 2 * motion.poses[body].angle + before[body].angle) / (h * h);
        // Central differences: errors of order h^2 = 1e-8 and 1e-16/h^2 = 1e-8.
        CHECK(motion.velocities[body].angle == near(first * speed, 1e-6));
        CHECK(motion.accelerations[body].angle == near(second * speed * speed + first * 0.5, 1e-6));
    }
}

TEST_CASE("a linkage that its joints do not determine is refused with the names of those concerned")
{
    using doctest::Contains;
    SUBCASE("no joint holds the body")
    {
        Linkage linkage = linkages::slider_crank(0.025, 0.383);
        linkage.bodies.push_back("flag");
        CHECK_THROWS_WITH_AS(PlanarSystem{linkage}, Contains("held by no joint: 'flag'"), InputError);
    }
    SUBCASE("a guide is missing")
    {
        Linkage linkage = linkages::slider_crank(0.025, 0.383);
        linkage.joints.back().guides_rotation = false;
        CHECK_THROWS_WITH_AS(PlanarSystem{linkage}, Contains("9 unknowns, 8 equations, rank 8"), InputError);
        CHECK_THROWS_WITH_AS(PlanarSystem{linkage}, Contains("free to move although the driver is held: 'slide'"),
                             InputError);
    }
    SUBCASE("a guide too many")
    {
        Linkage linkage = linkages::slider_crank(0.025, 0.383);
        linkage.joints.push_back(linkage.joints.back());
        linkage.joints.back().name = "second_guide";
        CHECK_THROWS_WITH_AS(PlanarSystem{linkage}, Contains("9 unknowns, 11 equations, rank 9"), InputError);
        CHECK_THROWS_WITH_AS(PlanarSystem{linkage}, Contains("'guide', 'second_guide'"), InputError);
    }
    SUBCASE("the driver does not stand on the ground")
    {
        Linkage linkage = linkages::slider_crank(0.025, 0.383);
        linkage.driver = 1;
        CHECK_THROWS_WITH_AS(PlanarSystem{linkage}, Contains("must be a revolute joint on the ground"), InputError);
    }
    SUBCASE("the rod is too short for a full turn")
    {
        const PlanarSystem system(linkages::slider_crank(0.025, 0.383, 0.37));
        // At a quarter turn the crank pin is 25 mm + 370 mm above the guide: more than the rod reaches.
        CHECK_THROWS_AS((void)system.follow(system.assembled(), 0, 2 * pi), InputError);
    }
}
