#include "deadpoint/casefile/check/directions.hpp"
#include "deadpoint/casefile/describe/case.hpp"

#include <doctest/doctest.h>
#include <string>

using namespace deadpoint;
using casefile::Case;

namespace {

Case named(const std::string& front, const std::string& left = {}, const std::string& up = {},
           Vec3 gravity = {0, -1, 0})
{
    Case input;
    input.machine.front = front;
    input.machine.left = left;
    input.machine.up = up;
    input.machine.gravity_direction = gravity;
    return input;
}

Viewer seen(const Case& input)
{
    const auto found = casefile::find_viewer(input);
    REQUIRE(std::holds_alternative<Viewer>(found));
    return std::get<Viewer>(found);
}

casefile::Finding refused(const Case& input)
{
    const auto found = casefile::find_viewer(input);
    REQUIRE(std::holds_alternative<casefile::Finding>(found));
    return std::get<casefile::Finding>(found);
}

}  // namespace

TEST_CASE("front, left and up as who stands in front has them")
{
    // A drawing with x to the right and y up is seen from z > 0, as every right-handed system is.
    CHECK(seen(named("")).front == Vec3{0, 0, 1});
    CHECK(seen(named("")).left == Vec3{-1, 0, 0});
    CHECK(seen(named("")).up == Vec3{0, 1, 0});
    // Seen from the other side its right is the left.
    CHECK(seen(named("-z")).left == Vec3{1, 0, 0});
    // From x > 0 the z axis points to the left; from x < 0 to the right.
    CHECK(seen(named("x")).left == Vec3{0, 0, 1});
    CHECK(seen(named("-x")).left == Vec3{0, 0, -1});
    // Left alone says where the front is.
    CHECK(seen(named("", "x")).front == Vec3{0, 0, -1});
    CHECK(seen(named("", "z")).front == Vec3{1, 0, 0});
    CHECK(seen(named("-z", "x", "y")).front == Vec3{0, 0, -1});
    // Up follows gravity: a drawing that is turned by a quarter, its x axis up, has y on the left.
    const auto turned = seen(named("", "", "", {-9.81, 0, 0}));
    CHECK(turned.up == Vec3{1, 0, 0});
    CHECK(turned.left == Vec3{0, 1, 0});
    CHECK(seen(named("", "", "", {0.3, -0.9, 0})).up == Vec3{0, 1, 0});
}

TEST_CASE("names of directions that contradict each other, gravity or the stroke are refused with the right one")
{
    const auto mirrored = refused(named("-z", "-x"));
    CHECK(mirrored.path == "machine.left");
    CHECK(mirrored.help.find("\"x\"") != std::string::npos);
    CHECK(refused(named("y")).path == "machine.front");
    CHECK(refused(named("", "-y")).path == "machine.left");
    CHECK(refused(named("", "", "x")).path == "machine.up");
    CHECK(refused(named("", "", "-y")).path == "machine.up");
    auto lying = named("x", "", "", {0, -1, 0});
    lying.mechanism.stroke_direction = Vec2{1, 0};
    CHECK(seen(lying).front == Vec3{1, 0, 0});
    lying.chain = casefile::Chain{};  // then its corners need names
    CHECK(refused(lying).path == "machine.front");
    lying.machine.front = "-z";
    CHECK(seen(lying).front == Vec3{0, 0, -1});
}
