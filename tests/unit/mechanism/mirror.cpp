#include "deadpoint/mechanism/mirror.hpp"

#include "deadpoint/error.hpp"
#include "deadpoint/exchange/cycle.hpp"
#include "deadpoint/mechanism/planar_system.hpp"
#include "linkages.hpp"

#include <doctest/doctest.h>

using namespace deadpoint;
using doctest::Contains;
using mechanism::mirrored;

namespace {

/// Crank above a slide: its rod pulls a cross head on the plane, from which two links go down to the slide at x =
/// +-0.2.
struct Half {
    Linkage linkage;
    std::vector<bool> twice{false, false, false, false, true, false};
    Half()
    {
        using linkages::revolute;
        using linkages::slide;
        linkage.bodies = {"frame", "crank", "rod", "head", "link", "slide"};
        linkage.joints = {revolute("bearing", 1, 0, {0, 0}),      revolute("crank_pin", 2, 1, {0, -0.05}),
                          revolute("head_pin", 2, 3, {0, -0.4}),  slide("head_guide", 3, 0, {0, -0.4}, {0, 1}),
                          revolute("top", 4, 3, {0, -0.4}),       revolute("bottom", 4, 5, {0.2, -0.8}),
                          slide("gib", 5, 0, {0, -0.9}, {0.0, 1})};
        linkage.slide_body = 5;
    }
};

}  // namespace

TEST_CASE("images follow the originals, reflected and named after them")
{
    Half half;
    half.linkage.joints[5].direction = {0.6, 0.8};
    const auto full = mirrored(half.linkage, half.twice);
    CHECK(full.linkage.bodies == std::vector<std::string>{"frame", "crank", "rod", "head", "link", "slide", "link'"});
    REQUIRE(full.linkage.joints.size() == 9);
    const LinkageJoint& image = full.linkage.joints[8];
    CHECK(image.name == "bottom'");
    CHECK(image.body_a == 6);
    CHECK(image.body_b == 5);
    CHECK(image.centre == Vec2{-0.2, -0.8});
    CHECK(image.direction == Vec2{-0.6, 0.8});
    CHECK(full.bodies[6].original == 4);
    CHECK(full.bodies[6].image);
    CHECK_FALSE(full.bodies[4].image);
    CHECK(full.joints[7].original == 4);
    CHECK(full.joints[7].image);
    CHECK(full.joints[3].original == 3);
    CHECK_FALSE(full.joints[3].image);
    CHECK(full.linkage.slide_body == 5);

    std::vector<BodyMass> masses(6);
    masses[4] = {7, {0.1, -0.6}, 0.3};
    const auto both = mirrored(masses, full);
    REQUIRE(both.size() == 7);
    CHECK(both[6].mass == 7);
    CHECK(both[6].inertia == 0.3);
    CHECK(both[6].centre == Vec2{-0.1, -0.6});
    CHECK(both[4].centre == Vec2{0.1, -0.6});
}

TEST_CASE("a slide that both halves hold off the plane is freed of its guide's hold, and only that one")
{
    const Half half;
    const auto full = mirrored(half.linkage, half.twice);
    REQUIRE(full.freed == std::vector<int>{6});
    CHECK_FALSE(full.linkage.joints[6].guides_rotation);
    CHECK(full.linkage.joints[3].guides_rotation);  // its pins lie on the plane
    CHECK_NOTHROW(mechanism::PlanarSystem{full.linkage});

    Linkage redundant = full.linkage;
    redundant.joints[6].guides_rotation = true;
    CHECK_THROWS_WITH_AS(mechanism::PlanarSystem{redundant}, Contains("18 unknowns, 19 equations, rank 18"),
                         InputError);
    CHECK_THROWS_WITH_AS(mechanism::PlanarSystem{redundant},
                         Contains("1 equation too many: let 'gib' turn (guides_rotation = false)"), InputError);
}

TEST_CASE("what cannot exist twice is refused by name")
{
    Half half;
    const auto refuses = [&](const char* text) {
        CHECK_THROWS_WITH_AS(mirrored(half.linkage, half.twice), Contains(text), InputError);
    };
    SUBCASE("marks")
    {
        half.twice.pop_back();
        refuses("6 bodies, but 5 marks");
    }
    SUBCASE("ground")
    {
        half.twice[0] = true;
        refuses("'frame' is the ground");
    }
    SUBCASE("crank")
    {
        half.twice[1] = true;
        refuses("'crank' is the driven body");
    }
    SUBCASE("slide")
    {
        half.twice[5] = true;
        refuses("'slide' is the slide that carries the tool");
    }
    SUBCASE("name")
    {
        half.linkage.bodies[2] = "link'";
        refuses("the name \"link'\" of the image of 'link' is taken");
    }
}
