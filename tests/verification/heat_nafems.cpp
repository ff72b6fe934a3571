#include "solved_case.hpp"

// NAFEMS, Background to Benchmarks (1993): heat conduction tests T2, T3 and T4. The digits beyond the published ones
// are from the series solutions.

using namespace verification;
using doctest::Approx;

TEST_CASE("NAFEMS T2: conduction with radiation at the end")
{
    const auto solved = solve("nafems-t2");
    // The temperature along the bar is linear, so that linear elements are exact; what is left is the steady state
    // being reached within the tolerance of a time step, and sigma = 5.67e-8 in the source (0.005 K).
    CHECK(solved.probe("B") + zero_celsius == Approx(927.0076).epsilon(1.2e-5));
}

TEST_CASE("NAFEMS T3: one-dimensional transient conduction")
{
    const auto solved = solve("nafems-t3");
    // Published to 0.01 K. The waves enter sqrt(2 alpha / omega) = 17 mm deep; elements of 1 mm are off by
    // (1 / 17)^2 / 12 = 3e-4 of the local temperature, and by a quarter of that with each halving.
    CHECK(std::abs(solved.probe("x80", 32) - 36.603116) < 0.01);
    CHECK(std::abs(solved.probe("x60", 32) - 8.6678) < 0.005);
    CHECK(std::abs(solved.probe("x40", 32) - 1.1503) < 0.005);
    CHECK(std::abs(solved.probe("x20", 32) - 0.0909) < 0.005);
}

TEST_CASE("NAFEMS T4: two-dimensional conduction with convection")
{
    const auto solved = solve("nafems-t4");
    // Elements of 20 mm near a boundary layer of k/h = 69 mm and a corner where the temperature jumps: 0.3 % of the
    // 100 K across.
    CHECK(std::abs(solved.probe("E") - 18.253757) < 0.1);
    CHECK(std::abs(solved.probe("left") - 35.40115) < 0.05);
    CHECK(std::abs(solved.probe("middle") - 28.31996) < 0.05);
}

TEST_CASE("NAFEMS T4 with elements of second order")
{
    const auto solved = solve("nafems-t4", {"numerics.order=2", "numerics.size=50 mm", "parts.plate.size=50 mm"});
    CHECK(std::abs(solved.probe("E") - 18.253757) < 0.05);
    CHECK(std::abs(solved.probe("left") - 35.40115) < 0.01);
    CHECK(std::abs(solved.probe("middle") - 28.31996) < 0.01);
}
