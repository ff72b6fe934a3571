#include "near.hpp"
#include "solved_case.hpp"

#include <cmath>
#include <numbers>

// A guide that its slide heats over the stroke.

using namespace verification;

namespace {

constexpr double foot = -0.25, bar_length = 0.3, slider_foot = -0.17, slider_length = 0.04;
constexpr double crank = 0.03, rod = 0.12;
constexpr double section = 2e-3 * 5e-3, conductivity = 50, heat = 1;

/// Steady temperature of a bar of length L with cold ends that takes the heat over [c, d] evenly: the integral of
/// Green's function, y (1 - y'/L) / (k A) below y' and y' (1 - y/L) / (k A) above.
double even(double y, double c, double d)
{
    const double L = bar_length, split = std::clamp(y, c, d);
    const double below = 0.5 * (split * split - c * c) * (1 - y / L);
    const double above = y * ((d - split) - 0.5 * (d * d - split * split) / L);
    return heat / (d - c) * (below + above) / (conductivity * section);
}

/// The mean over a turn of the slider-crank, its slide at height h above bottom dead point.
double swept(double height)
{
    constexpr int count = 20000;
    double sum = 0;
    for (int i = 0; i < count; ++i) {
        const double angle = 2 * std::numbers::pi * i / count, across = crank * std::sin(angle);
        const double h = crank * (1 - std::cos(angle)) + rod - std::sqrt(rod * rod - across * across);
        const double c = slider_foot + h - foot;
        sum += even(height - foot, c, c + slider_length);
    }
    return sum / count;
}

struct Height {
    const char* probe;
    double value;
};
constexpr Height heights[] = {{"at_200", -0.2}, {"at_170", -0.17}, {"at_150", -0.15}, {"at_120", -0.12},
                              {"at_100", -0.1}, {"at_80", -0.08},  {"at_0", 0}};

}  // namespace

TEST_CASE("a guide heated over the stroke: the temperature along it is that of the swept source")
{
    const auto solved = solve("swept-guide");
    const double peak = swept(-0.12);
    double worst = 0;
    for (const auto& [probe, height] : heights) {
        CAPTURE(height);
        const double rise = solved.probe(probe) - 20;
        worst = std::max(worst, std::abs(rise - swept(height)) / peak);
        // The back is colder than the mean of the section by q t / (6 k) = 0.03 K of 127 K. Eight stops in place of the
        // course miss 1.3 % of the variance of the source's place, 5.8e-6 m2, which times half the largest curvature
        // of the profile, q / (k t) = 5e4 K/m2, is 0.15 K.
        CHECK(std::abs(rise - swept(height)) < 1.5e-3 * peak);
    }
    MESSAGE("largest error " << worst << " of the peak of " << peak << " K");
    // All heat leaves by the ends: into the slider go 1e-6 W/m2/K in 40 h, 4e-4 K.
    const auto& energy = solved.history().energy;
    CHECK(energy.generated == near(heat * 40 * 3600, 1e-9));
    CHECK(std::abs(solved.side_a() - 20) < 1e-3);
}

TEST_CASE("a guide that is not swept is heated where the slide is drawn")
{
    const auto solved = solve("swept-guide", {"joints.guide.swept=false"});
    for (const auto& [probe, height] : heights) {
        CAPTURE(height);
        const double rise = solved.probe(probe) - 20;
        const double c = slider_foot - foot;
        CHECK(std::abs(rise - even(height - foot, c, c + slider_length)) < 1.5e-3 * 80);
    }
    CHECK(std::abs(solved.probe("at_100") - 20 - swept(-0.1)) > 5);  // K; what the sweep changes
}

TEST_CASE("a swept guide: heat to both sides and to the oil adds up to the source")
{
    const std::string contact = "joints.guide.interfaces.0.";
    const auto solved =
        solve("swept-guide", {contact + "conductance.side_a=800 W/m^2/K", contact + "oil=300 W/m^2/K"});  // closes 1e-6
    const auto& energy = solved.history().energy;
    CHECK(energy.generated == near(heat * 40 * 3600, 1e-9));
    // Steady: the slider has no other contact, so its face has the mean temperature of the film, for which with the
    // flux q = 1 W / 2 cm2 holds q + h_b (T_b - T_f) + g (T_oil - T_f) = 0 in the mean.
    CHECK(solved.side_a() == near((5000 + 3000 * solved.side_b() + 300 * 20) / 3300, 1e-6));
    CHECK(energy.to_oil > 0.1 * energy.generated);
}
