/// Requirement: residuals that are not noise are noticed, noise is not.
#include "deadpoint/calibration/discrepancy.hpp"

#include "deadpoint/calibration/fit.hpp"
#include "linear.hpp"
#include "near.hpp"

#include <cmath>
#include <doctest/doctest.h>

using namespace linear;

namespace {

/// Number of cases in which the model is flagged, of those whose data have `extra` on the first curve.
int flagged(const std::function<double(double)>& extra, int cases, const Noise& noise)
{
    int count = 0;
    for (int k = 0; k < cases; ++k) {
        auto of = problem(Eigen::Vector2d(0.3, 0.2), noise, 100 + static_cast<unsigned>(k));
        for (Index i = 0; i < of.curves[0].time.size(); ++i)
            of.curves[0].measured[i] += extra(of.curves[0].time[i]);
        const auto found = fit(of, VectorXd::Zero(2));
        count += test_model(of, found.prediction).differs ? 1 : 0;
    }
    return count;
}

}  // namespace

TEST_CASE("a right model is flagged in at most a tenth of cases, a wrong course in nearly all")
{
    // Level 0.05, at 60 cases at most 8 with a probability of 0.999.
    CHECK(flagged([](double) { return 0.0; }, 60, {0.1, 0, 0, 1}) <= 8);
    CHECK(flagged([](double) { return 0.0; }, 60, {0.1, 200, 0, 1}) <= 8);
    // A course of twice the noise that no parameter makes.
    CHECK(flagged([](double t) { return 0.2 * std::sin(t / 400); }, 20, {0.1, 0, 0, 1}) >= 19);
}

TEST_CASE("figures of a curve's residuals are those of their definition")
{
    const VectorXd time = even_times(10);
    VectorXd residual(10);
    residual << 1, -1, 1, -1, 1, -1, 1, -1, 1, 1;
    const auto found = residual_of({"c", time, residual, {0.5, 0, 0, 1}}, residual);
    CHECK(found.rms == near(1, 1e-5));
    CHECK(found.bias == near(0.2, 1e-5));
    CHECK(found.chi_square == near(4, 1e-5));
    CHECK(found.lag_one == near((-8 + 1) / 10.0, 1e-5));
    // Chi-square of 40 with 10 degrees of freedom: 1.694e-5 (tables), times three tests.
    CHECK(found.probability == near(3 * 1.694e-5, 1e-3));
}

TEST_CASE("a regular course far below the stated errors is no wrong model, one of their size is")
{
    const VectorXd time = even_times(60);
    VectorXd course(60);
    for (Index k = 0; k < 60; ++k)
        course[k] = std::sin(time[k] / 600);
    const auto probability = [&](double size) {
        return residual_of({"c", time, size * course, {0.1, 0, 0, 1}}, size * course).probability;
    };
    CHECK(probability(0.001) > 0.9);
    CHECK(probability(0.2) < 1e-6);
}
