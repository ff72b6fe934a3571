#include "deadpoint/core/formula.hpp"

#include "deadpoint/error.hpp"
#include "near.hpp"

#include <doctest/doctest.h>

using namespace deadpoint;

TEST_CASE("a formula has the value of its place and time")
{
    CHECK(Formula("293.15 + 10*x - y*z + t")({1, 2, 3}, 4) == near(301.15, 1e-14));
    CHECK(Formula("x >= 1 && y != 0 ? 300 : 290")({1, 2, 0}, 0) == 300);
    CHECK(Formula("max(290, 2*t)")({}, 200) == 400);
    CHECK(Formula("293.15 + x").depends_on_place());
    CHECK_FALSE(Formula("293.15 + sin(pi*t) + e").depends_on_place());
}

TEST_CASE("a text with no result, several, or an assignment is no formula")
{
    const auto refused = [](const char* text, const char* reason) {
        CAPTURE(text);
        CHECK_THROWS_WITH_AS(Formula{text}, doctest::Contains(reason), InputError);
    };
    refused("", "it is empty");
    refused("  ", "it is empty");
    refused("293,15", "into 2 results");
    refused("293,15,1", "a decimal mark is a point");
    refused("x=5", "it assigns a value");
    refused("t = 300", "it assigns a value");
    refused("300 + (x=1)", "it assigns a value");
    refused("x+=1", "it assigns a value");
    refused("300 +", "is not a formula");
    refused("20 degC", "is not a formula");
}
