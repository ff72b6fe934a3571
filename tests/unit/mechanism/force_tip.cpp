/// Crank positions that meet the tip of a steep process force.
#include "deadpoint/mechanism/force_tip.hpp"

#include "deadpoint/exchange/cycle.hpp"
#include "deadpoint/mechanism/cycle.hpp"
#include "linkages.hpp"

#include <algorithm>
#include <doctest/doctest.h>
#include <limits>
#include <numbers>

using namespace deadpoint;
using namespace deadpoint::mechanism;

namespace {

constexpr double degree = std::numbers::pi / 180;

/// A slide that moves along x, its bottom dead point at the inner end of its stroke.
const Linkage linkage = linkages::slider_crank(0.04, 0.3);

CycleRequest request_of(ProcessForceLaw law)
{
    CycleRequest request;
    request.masses.assign(4, BodyMass{});
    request.speed = [](double) { return 6.0; };
    request.process_force = std::move(law);
    return request;
}

double peak(const CycleHistory& history) { return *std::ranges::max_element(history.process_force); }

struct Met {
    int positions;
    double before;  ///< largest force at the positions asked for
    double after;   ///< at those found
};

Met meet(const ProcessForceLaw& law, const ForceCorners& corners)
{
    auto request = request_of(law);
    const auto first = analyse_cycle(linkage, request);
    request.positions = positions_for_tip(first, request, corners);
    return {request.positions, peak(first), peak(analyse_cycle(linkage, request))};
}

}  // namespace

TEST_CASE("the tip of a steep table over the height is met to 0.1 %")
{
    // A sheet that breaks: full force at 2.030 mm, none 0.06 mm above and below.
    const std::vector<double> heights{1.97e-3, 2.03e-3, 2.09e-3};
    const auto met = meet(force_over_height(heights, {0, 1e5, 0}), {{}, heights});
    CHECK(met.before < 0.97e5);
    CHECK(met.after >= 0.999e5);
    CHECK(met.after <= 1e5);
    CHECK(met.positions > 720);
    CHECK(met.positions <= 2880);
}

TEST_CASE("the tip of a table over the angle and of a short half sine is met to 0.1 %")
{
    const std::vector<double> angles{-20 * degree, -19.8 * degree, -19.2 * degree};
    const auto table = meet(force_over_angle(angles, {0, 1e5, 0}), {angles, {}});
    CHECK(table.before < 0.9e5);
    CHECK(table.after >= 0.999e5);
    const auto sine = meet(half_sine(1e5, {-5.9 * degree, -4.6 * degree}), {{-5.25 * degree}, {}});
    CHECK(sine.before < 0.9e5);
    CHECK(sine.after >= 0.999e5);
}

TEST_CASE("positions that meet the largest force are left as they are")
{
    CHECK(meet(force_over_angle({-30 * degree, 0, 30 * degree}, {0, 1e5, 0}), {{-30 * degree, 0, 30 * degree}, {}})
              .positions == 720);
    CHECK(meet(force_over_height({0, 0.01}, {1e5, 0}, Strokes::both), {{}, {0, 0.01}}).positions == 720);
    CHECK(meet(elastic_contact_of_peak(1e9, 1e5), {}).positions == 720);
    CHECK(meet({}, {{0.1}, {}}).positions == 720);
    // A height beyond the stroke is never passed.
    CHECK(meet(force_over_height({0, 0.5}, {1e5, 2e5}, Strokes::both), {{}, {0, 0.5}}).positions == 720);
}

TEST_CASE("a force that acts on the way down only and falls from bottom dead point is met before it")
{
    // At bottom dead point itself the law gives half. The slide is 1.3 um above it one position earlier.
    const std::vector<double> heights{0, 0.02e-3};
    const auto met = meet(force_over_height(heights, {1e5, 0}), {{}, heights});
    CHECK(met.before < 0.94e5);
    CHECK(met.after > 0.99e5);
    CHECK(met.positions <= 2880);
}
