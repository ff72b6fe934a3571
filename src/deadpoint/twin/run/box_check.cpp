#include "deadpoint/twin/run/box_check.hpp"

#include "deadpoint/twin/run/films_by_part.hpp"
#include "deadpoint/twin/run/free_coefficients.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace deadpoint::twin {
namespace {

using reduce::FreeCoefficient;

/// Smallest and largest value of a coefficient over its members and the segments.
struct Found {
    double least = std::numeric_limits<double>::infinity(), most = -least;
    void add(double value)
    {
        least = std::min(least, value);
        most = std::max(most, value);
    }
};

// Courses of the room's air and of the air that films state for themselves. A film that had none when the press was
// reduced counts from the room's.
Found ambients_in(const FreeCoefficient& coefficient, const HeatProblem& problem)
{
    constexpr int places = 24;  // of each segment
    const auto base_of = [&](std::size_t member) {
        const auto at = std::ranges::find(coefficient.members, member) - coefficient.members.begin();
        return static_cast<std::size_t>(at) < coefficient.base.size() ? coefficient.base[static_cast<std::size_t>(at)]
                                                                      : coefficient.base.front();
    };
    Found found;
    double begin = 0;
    for (const auto& segment : problem.segments) {
        const auto add = [&](const TimeCourse& course, double base) {
            for (int k = 0; k <= places; ++k)
                found.add(course(begin + segment.duration * k / places) - base);
            for (const double time : course.points(begin, begin + segment.duration))
                found.add(course(time) - base);
        };
        add(segment.ambient, coefficient.base.front());
        for (std::size_t s = 0; s < problem.surfaces.size(); ++s)
            if (const auto& own = problem.surfaces[s].ambient)
                add(own, base_of(1 + s));
        begin += segment.duration;
    }
    return found;
}

Found values_in(const FreeCoefficient& coefficient, const HeatProblem& problem, double start)
{
    if (coefficient.kind == FreeCoefficient::Kind::ambient)
        return ambients_in(coefficient, problem);
    const auto here = in_problem(coefficient, problem);
    Found found;
    for (std::size_t segment = 0; segment < problem.segments.size(); ++segment)
        for (std::size_t k = 0; k < here.members.size(); ++k)
            if (const auto value = value_of(here, k, problem, segment, start))
                found.add(*value);
    return found;
}

const char* unit_of(FreeCoefficient::Kind kind)
{
    using enum FreeCoefficient::Kind;
    return kind == oil_temperature || kind == ambient ? " K" : " times that of the reduced case";
}

// Where the reduced case had none, no range tells how much there may be.
std::string text_of(const FreeCoefficient& coefficient, const Found& found)
{
    if (!std::isfinite(found.most))
        return fmt::format("{}: there is none in the reduced case", coefficient.name);
    return fmt::format("{}: {:.4g} to {:.4g}, trained {:.4g} to {:.4g}{}", coefficient.name, found.least, found.most,
                       coefficient.from, coefficient.to, unit_of(coefficient.kind));
}

// Friction laws that the reduced case has not.
void add_unknown(const reduce::Box& box, const HeatProblem& problem, std::vector<std::string>& result)
{
    for (std::size_t r = 0; r < problem.sources.size(); ++r) {
        const auto name = heat_name(problem.sources[r]);
        const auto heats = [&](const HeatSegment& segment) { return static_cast<bool>(segment.heat[r]); };
        if (std::ranges::find(box, name, &FreeCoefficient::name) == box.end() &&
            std::ranges::any_of(problem.segments, heats))
            result.push_back(fmt::format("{}: the reduced case has no such friction law", name));
    }
}

}  // namespace

std::vector<std::string> outside_of(const reduce::Box& box, const SplitProblem& split, double start)
{
    constexpr double rounding = 1e-9;
    std::vector<std::string> result;
    for (const auto& coefficient : box) {
        const auto found = values_in(coefficient, split.problem, start);
        const double slack = rounding * std::max(1.0, coefficient.to);
        if (found.least < coefficient.from - slack || found.most > coefficient.to + slack)
            result.push_back(text_of(coefficient, found));
    }
    add_unknown(box, split.problem, result);
    return result;
}

}  // namespace deadpoint::twin
