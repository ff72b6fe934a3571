/// Requirement: a coefficient that grows with the speed has its stated value at the reference speed.
#include "deadpoint/exchange/laws/speed_growth.hpp"

#include "near.hpp"

#include <doctest/doctest.h>

using deadpoint::SpeedGrowth;

TEST_CASE("a coefficient follows (n / n_r)^e, less the share that stays at rest")
{
    constexpr double exact = 1e-15;
    CHECK(SpeedGrowth{0.5, 20, 0}.factor(20) == 1);
    CHECK(SpeedGrowth{0.5, 20, 0}.factor(80) == near(2, exact));
    CHECK(SpeedGrowth{0.5, 20, 0}.factor(-80) == near(2, exact));
    CHECK(SpeedGrowth{0.5, 20, 0}.factor(0) == 0);
    CHECK(SpeedGrowth{0.5, 20, 0.25}.factor(0) == 0.25);
    CHECK(SpeedGrowth{0.5, 20, 0.25}.factor(80) == near(0.25 + 0.75 * 2, exact));
    // without an exponent the speed says nothing, not even at rest
    CHECK(SpeedGrowth{0, 20, 0}.factor(0) == 1);
    CHECK(SpeedGrowth{0, 20, 0}.factor(80) == 1);
}
