#include "deadpoint/surroundings/ambient.hpp"

#include "deadpoint/error.hpp"

#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace deadpoint::surroundings {
namespace {

/// Phase since the last maximum, after a check of the course.
double phase(const DailyCourse& course, double time)
{
    if (!(course.amplitude >= 0) || !std::isfinite(course.mean) || !(course.mean - course.amplitude > 0) ||
        !(course.period > 0) || !std::isfinite(course.period) || !std::isfinite(course.time_of_maximum) ||
        !std::isfinite(time))
        throw DomainError(
            fmt::format("daily course with mean {} K, amplitude {} K, maximum at {} s, period {} s, asked "
                        "at {} s\n  help: amplitude not below zero, period positive, all above 0 K",
                        course.mean, course.amplitude, course.time_of_maximum, course.period, time));
    return 2 * std::numbers::pi * std::fmod(time - course.time_of_maximum, course.period) / course.period;
}

}  // namespace

double daily_temperature(const DailyCourse& course, double time)
{
    return course.mean + course.amplitude * std::cos(phase(course, time));
}

}  // namespace deadpoint::surroundings
