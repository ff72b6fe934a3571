#include "deadpoint/study/reduce/outside.hpp"

#include "deadpoint/study/reduce/free_coefficients.hpp"
#include "deadpoint/study/reduce/split.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <limits>

namespace deadpoint::study {
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
        for (int k = 0; k <= places; ++k) {
            const double time = begin + segment.duration * k / places;
            found.add(segment.ambient(time) - coefficient.base.front());
            for (std::size_t s = 0; s < problem.surfaces.size(); ++s)
                if (const auto& own = problem.surfaces[s].ambient)
                    found.add(own(time) - base_of(1 + s));
        }
        begin += segment.duration;
    }
    return found;
}

// A case may have other friction laws than the one that was reduced. They are known by their names.
Found heat_in(const FreeCoefficient& coefficient, const HeatProblem& problem, double start)
{
    Found found;
    const auto source = std::ranges::find_if(
        problem.sources, [&](const HeatSource& one) { return "friction." + one.name == coefficient.name; });
    if (source == problem.sources.end() || !(coefficient.base.front() > 0))
        return found;
    const auto index = static_cast<std::size_t>(source - problem.sources.begin());
    for (const auto& segment : problem.segments)
        if (const auto& law = segment.heat[index])
            found.add(source->share * law(start).value / coefficient.base.front());
    return found;
}

Found values_in(const FreeCoefficient& coefficient, const HeatProblem& problem, double start)
{
    if (coefficient.kind == FreeCoefficient::Kind::ambient)
        return ambients_in(coefficient, problem);
    if (coefficient.kind == FreeCoefficient::Kind::heat)
        return heat_in(coefficient, problem, start);
    Found found;
    for (std::size_t segment = 0; segment < problem.segments.size(); ++segment)
        for (std::size_t k = 0; k < coefficient.members.size(); ++k)
            if (const auto value = value_of(coefficient, k, problem, segment, start))
                found.add(*value);
    return found;
}

const char* unit_of(FreeCoefficient::Kind kind)
{
    using enum FreeCoefficient::Kind;
    return kind == oil_temperature || kind == ambient ? " K" : " times that of the reduced case";
}

}  // namespace

std::vector<std::string> outside_of(const reduce::Box& box, const SplitProblem& split, double start)
{
    constexpr double rounding = 1e-9;
    std::vector<std::string> result;
    for (const auto& coefficient : box) {
        const auto [least, most] = values_in(coefficient, split.problem, start);
        const double slack = rounding * std::max(1.0, coefficient.to);
        if (least < coefficient.from - slack || most > coefficient.to + slack)
            result.push_back(fmt::format("{}: {:.4g} to {:.4g}, trained {:.4g} to {:.4g}{}", coefficient.name, least,
                                         most, coefficient.from, coefficient.to, unit_of(coefficient.kind)));
    }
    return result;
}

}  // namespace deadpoint::study
