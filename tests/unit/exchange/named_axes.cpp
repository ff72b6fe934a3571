#include "deadpoint/exchange/named_axes.hpp"

#include <doctest/doctest.h>

using namespace deadpoint;

TEST_CASE("axes by their names and back")
{
    CHECK(named_axis("-y") == Vec3{0, -1, 0});
    for (const char* name : {"x", "y", "z", "-x", "-y", "-z"})
        CHECK(axis_name(*named_axis(name)) == name);
    for (const char* name : {"", "-", "w", "--x", "xy", "+x", "X"})
        CHECK_FALSE(named_axis(name));
    CHECK(axis_name({0.6, -0.8, 0}) == "(0.60, -0.80, 0.00)");
    CHECK(side_name({0, 0, -1}) == "z < 0");
    CHECK(side_name({1, 0, 0}) == "x > 0");
    CHECK(side_name({0.6, -0.8, 0}) == "towards (0.60, -0.80, 0.00)");
    CHECK(named_axes({"x", "z", "-y"}));
    CHECK_FALSE(named_axes({"x", "z", "y"}));  // left-handed
}
