/// Requirement: what a sensor shows follows from the rows of a run.
#include "deadpoint/calibration/curves.hpp"

#include "near.hpp"

#include <cmath>
#include <doctest/doctest.h>

using namespace deadpoint::calibration;
using Eigen::VectorXd;

TEST_CASE("interpolation is exact for quadratics, piece by piece where segments meet")
{
    const std::vector<double> rows{0, 1, 3, 4, 4, 5, 7};
    const auto f = [](double t) { return t <= 4 ? 2 + t - 0.3 * t * t : 1.2 - 5 * (t - 4) + 2 * (t - 4) * (t - 4); };
    VectorXd values(7);
    for (int k = 0; k < 7; ++k)
        values[k] = f(rows[static_cast<std::size_t>(k)]);
    values[4] = 1.2;
    const std::vector<double> times{0, 0.5, 2.2, 3.9, 4, 4.5, 6, 7};
    const VectorXd found = interpolation(rows, times) * values;
    for (std::size_t k = 0; k < times.size(); ++k)
        CHECK(found[static_cast<Eigen::Index>(k)] == near(f(times[k]), 1e-12));
    CHECK((interpolation({0, 2}, {0.5}) * Eigen::Vector2d(1, 3))[0] == near(1.5, 1e-5));
}

TEST_CASE("a sensor of first order follows a ramp with its lag, and its derivative is that of differences")
{
    // y = t: z = t - c (1 - exp(-t/c)), exact since y is linear between rows.
    const std::vector<double> rows{0, 10, 25, 60, 60, 100};
    VectorXd ramp(6);
    for (int k = 0; k < 6; ++k)
        ramp[k] = rows[static_cast<std::size_t>(k)];
    const double c = 30;
    const auto found = lagged(rows, ramp, c);
    for (int k = 0; k < 6; ++k)
        CHECK(found.value[k] == near(ramp[k] - c * (1 - std::exp(-ramp[k] / c)), 1e-12));
    const double h = 1e-4;
    const VectorXd difference =
        (lagged(rows, ramp, c * std::exp(h)).value - lagged(rows, ramp, c * std::exp(-h)).value) / (2 * h);
    for (int k = 0; k < 6; ++k)
        CHECK(found.by_log_constant[k] == near(difference[k], 1e-6));
}
