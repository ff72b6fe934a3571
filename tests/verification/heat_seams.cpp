#include "near.hpp"
#include "solved_case.hpp"

// Shapes of one part that do not quite meet.

using namespace verification;

TEST_CASE("heat crosses the seam of two shapes of one part, micrometres apart or in each other, as if there were none")
{
    constexpr double flux = 20e3, film = 500, conductivity = 45, length = 0.1;
    const double cold = flux / film, hot = cold + flux * length / conductivity;
    for (const double gap : {-10.0, -1.0, -0.05, 0.0, 0.01, 0.05, 1.0, 10.0}) {
        CAPTURE(gap);
        Case input = read("seamed-bar");
        auto& upper = std::get<deadpoint::OutlineShape>(input.parts.at("bar").shapes[1].form);
        upper.points[0][1] += 1e-6 * gap;
        upper.points[1][1] += 1e-6 * gap;
        const auto solved = solve(input);
        CHECK(solved.machine.parts[0].pieces == 1);
        // Linear elements hold the linear field; what is left is 1e-4 of the length where the seam was moved, and of
        // the last step of the way to the steady state.
        CHECK(solved.probe("hot_end") - 20 == near(hot, 1e-3));
        CHECK(solved.probe("cold_end") - 20 == near(cold, 1e-3));
    }
}
