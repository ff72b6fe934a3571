/// Requirement: a slow course that a model lacks is found with its whole size, also where unknowns imitate it in part.
#include "deadpoint/calibration/course.hpp"

#include "deadpoint/calibration/fit.hpp"
#include "linear.hpp"
#include "near.hpp"

#include <cmath>
#include <doctest/doctest.h>

using namespace linear;

namespace {

constexpr double noise = 0.1;

/// The linear problem with white noise and a course of this amplitude and time on its first curve.
Problem with_course(double amplitude, double time, unsigned seed)
{
    auto result = problem(Eigen::Vector2d(0.3, 0.2), {noise, 0, 0, 1}, seed, 60);
    if (amplitude > 0) {
        const MatrixXd root = covariance({1e-9, 0, amplitude, time}, result.curves[0].time).llt().matrixL();
        result.curves[0].measured += root * draw(60, seed + 5000);
    }
    return result;
}

std::vector<Course> found(const Problem& of)
{
    const auto best = fit(of, VectorXd::Zero(2));
    return find_courses(of, best.prediction, best.theta, {0, 1}, 2);
}

}  // namespace

TEST_CASE("the amplitude of a course is that with which it was made, on average over many")
{
    // Two grid steps are a factor of 1.35; the mean of 60 logarithms, each known to about a factor of 1.7, to 7 %.
    double sum = 0;
    for (unsigned k = 0; k < 60; ++k)
        sum += std::log(found(with_course(0.5, 2000, k))[0].amplitude / 0.5) / 60;
    CHECK(std::abs(sum) < 0.25);
}

TEST_CASE("noise alone has no course, and a probability that says so")
{
    int flagged = 0, large = 0;
    for (unsigned k = 0; k < 100; ++k) {
        const auto courses = found(with_course(0, 1, 300 + k));
        flagged += course_probability(courses) < 0.05 ? 1 : 0;
        large += courses[0].amplitude > noise ? 1 : 0;
    }
    CHECK(flagged <= 11);  // of 100 at a level of 5 %: at most 11 with a probability of 0.996
    CHECK(large <= 5);
    int seen = 0;
    for (unsigned k = 0; k < 20; ++k)
        seen += course_probability(found(with_course(0.3, 2000, 700 + k))) < 0.05 ? 1 : 0;
    CHECK(seen >= 18);
}

TEST_CASE("a course like an unknown's effect is taken for the unknown where it can be, and widens it")
{
    // The first unknown acts as 1 - exp(-t/1000). Three times the noise in that shape is no course.
    auto of = with_course(0, 1, 42);
    const auto before = found(of)[0].amplitude;
    for (Index k = 0; k < 60; ++k) {
        of.curves[0].measured[k] += 0.3 * (1 - std::exp(-of.curves[0].time[k] / 1000));
        of.curves[1].measured[k] += 0.3 * of.curves[1].time[k] / 1000;
    }
    CHECK(found(of)[0].amplitude == near(before, 0.01));
}

TEST_CASE("groups of curves share a course, and curves of none have none")
{
    auto of = with_course(0.5, 2000, 3);
    const auto best = fit(of, VectorXd::Zero(2));
    const auto none = find_courses(of, best.prediction, best.theta, {1, 1}, 1);
    REQUIRE(none.size() == 1);
    CHECK(none[0].amplitude == 0);
    CHECK(course_probability(none) == 1);
    CHECK(course_probability({}) == 1);
    CHECK(course_probability({{1, 1, std::log(200.0)}, {0, 0, 0}}) == near(0.01, 1e-5));
}
