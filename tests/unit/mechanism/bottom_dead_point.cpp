#include "deadpoint/mechanism/bottom_dead_point.hpp"

#include "deadpoint/error.hpp"
#include "deadpoint/mechanism/planar_system.hpp"
#include "linkages.hpp"
#include "near.hpp"

#include <cmath>
#include <doctest/doctest.h>
#include <fstream>
#include <numbers>
#include <set>
#include <stdexcept>

using namespace deadpoint;
using mechanism::CentreShift;
using mechanism::PlanarSystem;

namespace {

constexpr double pi = std::numbers::pi;

nlohmann::json rows_of(double l5a)
{
    std::ifstream file(std::string(DEADPOINT_TEST_DATA) + "/twelve_body_linkage.json");
    const nlohmann::json data = nlohmann::json::parse(file);
    for (const auto& set : data["sets"])
        if (set["l5a"].get<double>() == l5a)
            return set["rows"];
    throw std::runtime_error("no such set");
}

/// Height of the slide over its place with unshifted centres, driver held: the non-linear closure.
double lifted(const Linkage& linkage, const std::vector<CentreShift>& shifts)
{
    const PlanarSystem system(linkage);
    const auto poses = system.follow(system.assembled(), 0, 0, shifts);
    const Vec2 point = system.slide_point();
    return dot(linkage.stroke_direction, mechanism::place(poses[linkage.slide_body], point) - point);
}

double predicted(const Linkage& linkage, const std::vector<CentreShift>& shifts)
{
    const auto bottom = mechanism::bottom_dead_point(linkage);
    double sum = 0;
    for (std::size_t j = 0; j < shifts.size(); ++j)
        sum += dot(bottom.weight[j], shifts[j].in_b - shifts[j].in_a);
    return sum;
}

int joint_named(const Linkage& linkage, const std::string& name)
{
    for (std::size_t j = 0; j < linkage.joints.size(); ++j)
        if (linkage.joints[j].name == name)
            return static_cast<int>(j);
    throw std::runtime_error("no joint named " + name);
}

/// Free thermal expansion of some bodies.
std::vector<CentreShift> expanded(const Linkage& linkage, const std::set<std::string>& bodies, double strain)
{
    std::vector<CentreShift> shifts(linkage.joints.size());
    const Vec2 about{0.3, -0.2};
    for (std::size_t j = 0; j < linkage.joints.size(); ++j) {
        const LinkageJoint& joint = linkage.joints[j];
        if (bodies.contains(linkage.bodies[joint.body_a]))
            shifts[j].in_a = strain * (joint.centre - about);
        if (bodies.contains(linkage.bodies[joint.body_b]))
            shifts[j].in_b = strain * (joint.centre - about);
    }
    return shifts;
}

}  // namespace

TEST_CASE("bottom dead point of the paper's linkage is at a crank angle of 270 degrees, wherever it is assembled")
{
    const nlohmann::json rows = rows_of(0.24);
    Linkage linkage = linkages::twelve_body(rows);
    // The extremum is flat: its place is known to the square root of rounding unless the velocity's zero is sought.
    CHECK(std::abs(mechanism::bottom_dead_point(linkage).crank_angle) < 1e-10);

    const PlanarSystem system(linkage);
    const auto poses = system.follow(system.assembled(), 0, 1.2345);
    Linkage elsewhere = linkage;
    for (std::size_t j = 0; j < linkage.joints.size(); ++j)
        elsewhere.joints[j].centre = system.joint_centre(static_cast<int>(j), poses);
    const auto bottom = mechanism::bottom_dead_point(elsewhere);
    CHECK(bottom.crank_angle == near(-1.2345, 1e-10));
    for (std::size_t j = 0; j < linkage.joints.size(); ++j)
        if (linkage.joints[j].kind == LinkageJoint::Kind::revolute)
            CHECK(norm(bottom.joint_centres[j] - linkage.joints[j].centre) < 1e-10);
}

TEST_CASE("slider-crank: lowest at inner or outer dead point, weight one along the line")
{
    Linkage linkage = linkages::slider_crank(0.025, 0.383);
    auto bottom = mechanism::bottom_dead_point(linkage);
    CHECK(std::abs(std::abs(bottom.crank_angle) - pi) < 1e-10);
    CHECK(bottom.weight[0][0] == near(1.0, 1e-5));
    linkage.stroke_direction = {-1, 0};
    bottom = mechanism::bottom_dead_point(linkage);
    CHECK(std::abs(bottom.crank_angle) < 1e-10);
    CHECK(bottom.joint_centres[2][0] == near(0.408, 1e-5));
}

TEST_CASE("vertical shifts of the frame's pivots at bottom dead point")
{
    // Published sensitivities 0.1045, 0.987, -0.091; a common shift of the whole frame moves the slide by just as much.
    const Linkage linkage = linkages::twelve_body(rows_of(0.24));
    const auto bottom = mechanism::bottom_dead_point(linkage);
    const auto vertical = [&](const char* name) { return bottom.weight[joint_named(linkage, name)][1]; };
    CHECK(vertical("12") == near(0.1045, 5e-4));
    CHECK(vertical("81") == near(0.987, 5e-4));
    CHECK(vertical("61") == near(-0.091, 6e-3));
    CHECK(std::abs(vertical("12") + vertical("81") + vertical("61") - 1) < 1e-13);
    for (const char* guide : {"guide_4", "guide_10", "guide_12"})
        CHECK(std::abs(vertical(guide)) < 1e-13);  // only shifts across the travel count
}

TEST_CASE("weights agree with the closure of shifted centres, joint by joint and on both sides")
{
    for (const double l5a : {0.24, 0.23}) {
        const Linkage linkage = linkages::twelve_body(rows_of(l5a));
        const auto bottom = mechanism::bottom_dead_point(linkage);
        const double h = 1e-6;
        for (std::size_t j = 0; j < linkage.joints.size(); ++j) {
            for (int side = 0; side < 2; ++side) {
                for (int k = 0; k < 2; ++k) {
                    std::vector<CentreShift> plus(linkage.joints.size());
                    std::vector<CentreShift> minus(linkage.joints.size());
                    (side == 0 ? plus[j].in_a : plus[j].in_b)[k] = h;
                    (side == 0 ? minus[j].in_a : minus[j].in_b)[k] = -h;
                    const double slope = (lifted(linkage, plus) - lifted(linkage, minus)) / (2 * h);
                    const double weight = side == 0 ? -bottom.weight[j][k] : bottom.weight[j][k];
                    CHECK(std::abs(slope - weight) < 1e-8);  // rounding 1e-15 over 1e-6, and h^2 curvature
                }
            }
        }
    }
}

TEST_CASE("weights on a linkage whose slide may turn agree with the closure of shifted centres")
{
    // The slide turns when the guided arm that is pinned to it is shifted.
    Linkage linkage = linkages::slider_crank(0.05, 0.2, 0.03);
    linkage.joints.back().guides_rotation = false;
    linkage.bodies.emplace_back("arm");
    linkage.joints.push_back(linkages::revolute("arm_on_slide", 4, 3, {0.3, 0.1}));
    linkage.joints.push_back(linkages::slide("arm_guide", 4, 0, {0.3, 0.1}, {1, 0}));
    const auto bottom = mechanism::bottom_dead_point(linkage);
    Linkage at_bottom = linkage;
    for (std::size_t j = 0; j < linkage.joints.size(); ++j)
        at_bottom.joints[j].centre = bottom.joint_centres[j];
    for (std::size_t j = 0; j < linkage.joints.size(); ++j) {
        std::vector<CentreShift> plus(linkage.joints.size());
        std::vector<CentreShift> minus(linkage.joints.size());
        plus[j].in_b = {0, 1e-6};
        minus[j].in_b = {0, -1e-6};
        const double slope = (lifted(at_bottom, plus) - lifted(at_bottom, minus)) / 2e-6;
        CHECK(std::abs(slope - bottom.weight[j][1]) < 1e-8);
    }
}

TEST_CASE("twenty kelvin on crank and links lower the slide")
{
    // Reference: -145.20 um linear against -144.96 um with the non-linear closure, crank throw included (0.57 um of
    // it).
    const Linkage linkage = linkages::twelve_body(rows_of(0.24));
    const auto shifts = expanded(linkage, {"2", "3", "5", "6", "7", "8", "9", "11"}, 1.09e-5 * 20);
    CHECK(1e6 * predicted(linkage, shifts) == near(-145.20, 4e-5));
    CHECK(1e6 * lifted(linkage, shifts) == near(-144.96, 4e-5));
}

TEST_CASE("a uniform expansion of all bodies scales the machine")
{
    const Linkage linkage = linkages::twelve_body(rows_of(0.24));
    const auto shifts = expanded(linkage, {"ground", "2", "3", "4", "5", "6", "7", "8", "9", "10", "11", "12"}, 1e-4);
    CHECK(std::abs(predicted(linkage, shifts)) < 1e-15);  // all centres still coincide
}

TEST_CASE("a slide that is lowest twice in a turn: the place nearer to the assembled position counts")
{
    // Crank pin in a cross slot: the block goes x = r cos(angle); a stretched pair of links from x = r / 2 at the
    // block's height pulls the slide up whenever the block is off that place, equally far on both sides of it.
    for (const double assembled : {0.9, -0.9, 2.4, -2.4}) {
        const double r = 0.1;
        const Vec2 pin{r * std::cos(assembled), r * std::sin(assembled)};
        const Vec2 low{pin[0], -0.5};
        const double aside = pin[0] - r / 2;
        const Vec2 slide{r / 2, low[1] - std::sqrt(0.09 - aside * aside)};
        Linkage linkage;
        linkage.bodies = {"frame", "crank", "block", "link", "slide"};
        linkage.joints = {linkages::revolute("bearing", 1, 0, {0, 0}),     linkages::slide("slot", 2, 0, low, {1, 0}),
                          linkages::revolute("link_pin", 3, 2, low),       linkages::revolute("slide_pin", 3, 4, slide),
                          linkages::slide("gib", 4, 0, slide, {0, 1}),     linkages::revolute("crank_pin", 1, 5, pin),
                          linkages::slide("cross_slot", 5, 2, pin, {0, 1})};
        linkage.bodies.emplace_back("stone");
        linkage.slide_body = 4;
        // Lowest where r cos(angle) = r / 2, at +-60 degrees.
        const double nearer = assembled > 0 ? pi / 3 : -pi / 3;
        const auto bottom = mechanism::bottom_dead_point(linkage);
        CHECK(bottom.crank_angle == near(nearer - assembled, 1e-9));
    }
}

TEST_CASE("a slide that the crank does not move is refused")
{
    Linkage linkage = linkages::slider_crank(0.025, 0.383);
    linkage.stroke_direction = {0, 1};
    CHECK_THROWS_WITH_AS(mechanism::bottom_dead_point(linkage), doctest::Contains("does not move along the stroke"),
                         InputError);
}
