#include "../record.hpp"
#include "solved_case.hpp"

// NAFEMS, Background to Benchmarks (1993): heat conduction tests T2, T3 and T4. The digits beyond the published ones
// are from the series solutions.

using namespace verification;

TEST_CASE("NAFEMS T2: conduction with radiation at the end")
{
    const auto solved = solve("nafems-t2");
    // The temperature along the bar is linear, so that linear elements are exact; what is left is the steady state
    // being reached within the tolerance of a time step, and sigma = 5.67e-8 in the source (0.005 K).
    record({"NAFEMS T2: T at B", "NAFEMS (927.0 published); radiation balance", "K", 927.0076, 0.011,
            "0.005 K from sigma = 5.67e-8 of the source, 0.005 K of a step"},
           solved.probe("B") + zero_celsius);
}

TEST_CASE("NAFEMS T3: one-dimensional transient conduction")
{
    const auto solved = solve("nafems-t3");
    // Published to 0.01 K. The waves enter sqrt(2 alpha / omega) = 17 mm deep; elements of 1 mm are off by
    // (1 / 17)^2 / 12 = 3e-4 of the local temperature, and by a quarter of that with each halving.
    const std::string source = "NAFEMS (36.60 published); series", reason = "cells of 1 mm against waves 17 mm deep";
    record({"NAFEMS T3: T at 0.08 m, 32 s", source, "degC", 36.603116, 0.01, reason}, solved.probe("x80", 32));
    record({"NAFEMS T3: T at 0.06 m, 32 s", source, "degC", 8.6678, 0.005, reason}, solved.probe("x60", 32));
    record({"NAFEMS T3: T at 0.04 m, 32 s", source, "degC", 1.1503, 0.005, reason}, solved.probe("x40", 32));
    record({"NAFEMS T3: T at 0.02 m, 32 s", source, "degC", 0.0909, 0.005, reason}, solved.probe("x20", 32));
}

namespace {

void check_t4(const SolvedCase& solved, const std::string& elements, const std::array<double, 3>& tolerance)
{
    const std::string source = "NAFEMS (18.3 published); series", reason = "cells against a layer of k/h = 69 mm";
    record({"NAFEMS T4, " + elements + ": T at (0.6, 0.2) m", source, "degC", 18.253757, tolerance[0],
            reason + " and a corner where the temperature jumps"},
           solved.probe("E"));
    record({"NAFEMS T4, " + elements + ": T at (0, 0.5) m", source, "degC", 35.40115, tolerance[1], reason},
           solved.probe("left"));
    record({"NAFEMS T4, " + elements + ": T at (0.3, 0.5) m", source, "degC", 28.31996, tolerance[2], reason},
           solved.probe("middle"));
}

}  // namespace

TEST_CASE("NAFEMS T4: two-dimensional conduction with convection")
{
    const auto solved = solve("nafems-t4");
    // Elements of 20 mm near a boundary layer of k/h = 69 mm and a corner where the temperature jumps: 0.3 % of the
    // 100 K across.
    check_t4(solved, "first order, 20 mm", {0.1, 0.05, 0.05});
}

TEST_CASE("NAFEMS T4 with elements of second order")
{
    const auto solved = solve("nafems-t4", {"numerics.order=2", "numerics.size=50 mm", "parts.plate.size=50 mm"});
    check_t4(solved, "second order, 50 mm", {0.05, 0.01, 0.01});
}
