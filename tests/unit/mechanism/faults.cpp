#include "deadpoint/error.hpp"
#include "deadpoint/mechanism/bottom_dead_point.hpp"
#include "deadpoint/mechanism/planar_system.hpp"
#include "linkages.hpp"
#include "near.hpp"

#include <cmath>
#include <doctest/doctest.h>
#include <limits>
#include <numbers>
#include <string>

using namespace deadpoint;
using doctest::Contains;
using mechanism::PlanarSystem;

namespace {

constexpr double pi = std::numbers::pi;

std::string message_of(const Linkage& linkage)
{
    try {
        mechanism::bottom_dead_point(linkage);
    } catch (const InputError& error) {
        return error.what();
    }
    return "no error";
}

/// The number that follows a text.
double number_after(const std::string& message, const std::string& text)
{
    const auto place = message.find(text);
    REQUIRE_MESSAGE(place != std::string::npos, message);
    return std::stod(message.substr(place + text.size()));
}

/// Crank and rocker of equal length, a coupler as long as the frame, and a slide on a rod from the rocker; the crank
/// stands at `angle` when assembled.
Linkage parallelogram(double angle)
{
    const Vec2 crank{0.1 * std::cos(angle), 0.1 * std::sin(angle)};
    const Vec2 rocker = crank + Vec2{0.3, 0};
    const Vec2 pin{rocker[0] + std::sqrt(0.25 - rocker[1] * rocker[1]), 0};
    using linkages::revolute;
    Linkage linkage;
    linkage.bodies = {"frame", "crank", "coupler", "rocker", "rod", "slide"};
    linkage.joints = {revolute("crank_bearing", 1, 0, {0, 0}),    revolute("crank_pin", 2, 1, crank),
                      revolute("rocker_pin", 2, 3, rocker),       revolute("rocker_bearing", 3, 0, {0.3, 0}),
                      revolute("rod_pin", 4, 3, rocker),          revolute("wrist_pin", 4, 5, pin),
                      linkages::slide("guide", 5, 0, pin, {1, 0})};
    linkage.slide_body = 5;
    linkage.stroke_direction = {1, 0};
    return linkage;
}

}  // namespace

TEST_CASE("a rod that is too short: the range that does not close, and by how much it misses")
{
    // The pin moves along y = 370 mm, the rod has 383 mm, the crank 25 mm: it closes while 370 - 25 sin <= 383, that is
    // outside 211.332 to 328.668 degrees; at 270 degrees 370 + 25 - 383 = 12 mm are missing.
    const double assembled = std::asin(0.37 / 0.408) * 180 / pi;
    const std::string message = message_of(linkages::slider_crank(0.025, 0.383, 0.37));
    // The limits are approached in steps of at least 1/32 degree.
    CHECK(std::abs(number_after(message, "cannot close from ") - (211.332 - assembled)) < 0.05);
    CHECK(std::abs(number_after(message, " to ") - (328.668 - assembled)) < 0.05);
    CHECK(number_after(message, "misses by ") == near(12, 1e-3));
    CHECK(std::abs(number_after(message, " mm at ") - (270 - assembled)) < 0.05);
    CHECK(message.find("joint 'crank_pin' of 'rod' and 'crank' misses") != std::string::npos);
    CHECK(message.find("help: check the lengths") != std::string::npos);
}

TEST_CASE("a rod shorter than the throw: the widest miss is told, though the other half of the turn closes again")
{
    // In line, crank 50 mm and rod 40 mm: closed while |50 sin| <= 40, so 10 mm are missing at 90 and at 270 degrees.
    const std::string message = message_of(linkages::slider_crank(0.05, 0.04, 0));
    CHECK(number_after(message, "misses by ") == near(10, 1e-3));
}

TEST_CASE("the range is the same from the other side")
{
    const Linkage linkage = linkages::slider_crank(0.025, 0.383, 0.37);
    const PlanarSystem system(linkage);
    const auto start = system.position(system.assembled());
    std::string forward;
    std::string backward;
    try {
        (void)system.moved(start, 6);
    } catch (const InputError& error) {
        forward = error.what();
    }
    try {
        (void)system.moved(start, -6);
    } catch (const InputError& error) {
        backward = error.what();
    }
    CHECK(std::abs(number_after(forward, "close from ") - number_after(backward, "close from ") - 360) < 0.1);
    CHECK(number_after(backward, "misses by ") == near(12, 1e-3));
}

TEST_CASE("a crank too long for its rocker: the miss is that of the triangle inequality")
{
    // Frame 300, crank 100, coupler 150, rocker 200 mm: at 180 degrees the pins are 400 mm apart, 50 mm too far.
    Linkage linkage = parallelogram(pi / 2);
    const double across = std::hypot(0.3, 0.1);
    const double along = (across * across + 0.15 * 0.15 - 0.2 * 0.2) / (2 * across);
    const double aside = std::sqrt(0.15 * 0.15 - along * along);
    const Vec2 line{0.3 / across, -0.1 / across};
    const Vec2 knee = Vec2{0, 0.1} + along * line + aside * Vec2{-line[1], line[0]};
    linkage.joints[2].centre = knee;
    linkage.joints[4].centre = knee;
    linkage.joints[5].centre = {knee[0] + 0.5, 0};
    linkage.joints[6].centre = {knee[0] + 0.5, 0};
    const std::string message = message_of(linkage);
    CHECK(number_after(message, "misses by ") == near(50, 1e-3));
    CHECK(std::abs(number_after(message, " mm at ") - 90) < 0.1);
}

TEST_CASE("a singular position is named, whether hit or passed")
{
    // At 0 and 180 degrees crank, coupler and rocker lie on one line, and the rocker may turn either way.
    for (const double assembled : {90.0, 91.3}) {
        const std::string message = message_of(parallelogram(assembled * pi / 180));
        CHECK(message.find("the linkage is singular ") != std::string::npos);
        const double at = assembled > 90 ? number_after(message, "near ") : number_after(message, "singular ");
        CHECK(std::abs(at - (180 - assembled)) < 2.1);
        CHECK(message.find("free to move although the driver is held: 'coupler', 'rocker'") != std::string::npos);
        CHECK(message.find("hold the same motion more than once: 'crank_bearing'") != std::string::npos);
    }
}

TEST_CASE("numbers that are not finite are refused by the joint's name")
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    Linkage linkage = linkages::slider_crank(0.025, 0.383);
    SUBCASE("centre") { linkage.joints[2].centre[1] = nan; }
    SUBCASE("direction") { linkage.joints[2].direction[0] = nan; }
    CHECK_THROWS_WITH_AS(PlanarSystem{linkage}, Contains("joint 'wrist_pin': its centre or direction is not finite"),
                         InputError);
    Linkage stroke = linkages::slider_crank(0.025, 0.383);
    stroke.stroke_direction = {nan, 0};
    CHECK_THROWS_WITH_AS(PlanarSystem{stroke}, Contains("the stroke has no direction"), InputError);
    const PlanarSystem system(linkages::slider_crank(0.025, 0.383));
    CHECK_THROWS_WITH_AS((void)system.moved(system.position(system.assembled()), nan), Contains("not finite"),
                         InputError);
}

TEST_CASE("what to free is named: a guide that may turn, else a joint")
{
    Linkage linkage = linkages::slider_crank(0.025, 0.383);
    linkage.joints.push_back(linkage.joints.back());
    linkage.joints.back().name = "second_guide";
    CHECK_THROWS_WITH_AS(PlanarSystem{linkage}, Contains("2 equations too many: let 'guide', 'second_guide' turn"),
                         InputError);
    linkage = linkages::slider_crank(0.025, 0.383);
    linkage.joints.push_back(linkages::revolute("second_pin", 2, 1, linkage.joints[1].centre));
    CHECK_THROWS_WITH_AS(PlanarSystem{linkage}, Contains("2 equations too many: remove one of these joints"),
                         InputError);
    linkage = linkages::slider_crank(0.025, 0.383);
    linkage.joints.back().guides_rotation = false;
    CHECK_THROWS_WITH_AS(PlanarSystem{linkage}, Contains("help: add the joints or guides that are missing"),
                         InputError);
}

TEST_CASE("sensitivity to the lengths: closed form of the slider-crank")
{
    const Linkage linkage = linkages::slider_crank(0.025, 0.383);
    const auto lengths = mechanism::length_sensitivities(linkage, mechanism::bottom_dead_point(linkage));
    const auto of = [&](const std::string& body, const std::string& from, const std::string& to) {
        for (const auto& entry : lengths)
            if (entry.body == body && entry.from == from && entry.to == to)
                return entry;
        FAIL("no such length");
        return lengths.front();
    };
    // Lowest at inner dead point, x = rod - crank: a longer crank lowers the slide, a longer rod lifts it.
    CHECK(of("crank", "crank_bearing", "crank_pin").height_by_length == near(-1, 1e-5));
    CHECK(of("crank", "crank_bearing", "crank_pin").length == near(0.025, 1e-5));
    CHECK(of("rod", "crank_pin", "wrist_pin").height_by_length == near(1, 1e-5));
    CHECK(of("rod", "crank_pin", "wrist_pin").length == near(0.383, 1e-5));
    // On the frame it matters which end stays: the bearing moves the slide away from the guide, the guide does not.
    CHECK(of("frame", "guide", "crank_bearing").height_by_length == near(-1, 1e-5));
    CHECK(std::abs(of("frame", "crank_bearing", "guide").height_by_length) < 1e-12);
    CHECK(lengths.size() == 4);  // guide and wrist pin of the slide coincide
}

TEST_CASE("sensitivity to the lengths agrees with the closure of the changed linkage")
{
    const Linkage linkage = linkages::slider_crank(0.05, 0.2, 0.03);
    const auto bottom = mechanism::bottom_dead_point(linkage);
    Linkage at_bottom = linkage;
    for (std::size_t j = 0; j < linkage.joints.size(); ++j)
        at_bottom.joints[j].centre = bottom.joint_centres[j];
    const PlanarSystem system(at_bottom);
    const auto joint = [&](const std::string& name) {
        for (std::size_t j = 0; j < linkage.joints.size(); ++j)
            if (linkage.joints[j].name == name)
                return j;
        return std::size_t{0};
    };
    for (const auto& entry : mechanism::length_sensitivities(linkage, bottom)) {
        const std::size_t from = joint(entry.from);
        const std::size_t to = joint(entry.to);
        const Vec2 line = (1 / entry.length) * (bottom.joint_centres[to] - bottom.joint_centres[from]);
        double heights[2];
        for (const int side : {0, 1}) {
            std::vector<mechanism::CentreShift> shifts(linkage.joints.size());
            const bool in_b = linkage.bodies[linkage.joints[to].body_b] == entry.body;
            (in_b ? shifts[to].in_b : shifts[to].in_a) = (side == 0 ? -1e-6 : 1e-6) * line;
            const auto poses = system.follow(system.assembled(), 0, 0, shifts);
            heights[side] = mechanism::place(poses[linkage.slide_body], system.slide_point())[0];
        }
        // Central difference over 2 um: rounding 1e-16 / 1e-6.
        CHECK(std::abs((heights[1] - heights[0]) / 2e-6 - entry.height_by_length) < 1e-8);
    }
}
