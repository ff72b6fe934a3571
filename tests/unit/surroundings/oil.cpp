#include "deadpoint/error.hpp"
#include "deadpoint/surroundings/oil_circuit.hpp"
#include "near.hpp"

#include <cmath>
#include <doctest/doctest.h>
#include <limits>

using namespace deadpoint;
using namespace deadpoint::surroundings;

TEST_CASE("oil within a joint: the exchanger's heat, and its limits")
{
    // A joint of 100 W/K in 200 W/K of oil, 20 K apart: the oil closes 1 - exp(-0.5) of the distance.
    CHECK(100 * 20 * mean_approach(0.5) == near(200 * 20 * (1 - std::exp(-0.5)), 1e-14));
    CHECK(mean_approach(0) == 1);
    CHECK(mean_approach(1e-9) == near(1 - 0.5e-9, 1e-15));  // no loss of digits
    CHECK(mean_approach(1e6) == near(1e-6, 1e-14));
}

TEST_CASE("oil: mass flow from volume flow; nonsense is refused")
{
    CHECK(mass_flow_of(20.0 / 60000, 870) == near(0.29, 1e-14));  // 20 l/min
    CHECK_THROWS_AS((void)mass_flow_of(-1, 870), InputError);
    CHECK_THROWS_AS((void)mass_flow_of(1, 0), InputError);
    CHECK_THROWS_AS((void)mass_flow_of(std::numeric_limits<double>::infinity(), 870), InputError);
}
