#include "../record.hpp"
#include "solved_case.hpp"

#include <cmath>
#include <numbers>

// Rings of second order against conduction through cylinders.

using namespace verification;

TEST_CASE("rings of second order conduct as cylinders do, through a film between meshes that do not match")
{
    const double through = 1 / (std::log(30.0 / 20) / 50 + 2e-4 / 0.03 + std::log(50.0 / 30) / 41);
    const double inner = 60 - 40 * through * std::log(30.0 / 20) / 50;
    const double outer = 20 + 40 * through * std::log(50.0 / 30) / 41;
    for (const bool tetrahedra : {false, true}) {
        const std::string shape = std::string("parts.outer_ring.tetrahedra=") + (tetrahedra ? "true" : "false");
        std::array<double, 2> errors{};
        for (std::size_t i = 0; i < 2; ++i) {
            const auto solved =
                solve("two-rings",
                      {"numerics.order=2", shape, std::string("parts.outer_ring.size=") + (i == 0 ? "13 mm" : "6.5 mm"),
                       std::string("parts.inner_ring.size=") + (i == 0 ? "8.5 mm" : "4.25 mm")});
            const double a = solved.side_a() > solved.side_b() ? solved.side_a() : solved.side_b();
            const double b = solved.side_a() > solved.side_b() ? solved.side_b() : solved.side_a();
            errors[i] = std::max(std::abs(a - inner), std::abs(b - outer));
        }
        MESSAGE(shape << ": errors " << errors[0] << ", " << errors[1] << " K");
        // chords in place of arcs: some 0.1 K, and order 2
        CHECK(errors[1] < 3e-4);
        CHECK((std::log2(errors[0] / errors[1]) > 3 || tetrahedra));  // which are no halves of each other
    }
}
