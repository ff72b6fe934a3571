#include "deadpoint/press/run/field_times.hpp"

#include "deadpoint/core/mistakes.hpp"
#include "deadpoint/exchange/heat.hpp"

#include <algorithm>
#include <cstddef>
#include <fmt/format.h>
#include <iterator>

namespace deadpoint::press {
namespace {

std::vector<double> united(const std::vector<double>& these, const std::vector<double>& those)
{
    std::vector<double> result;
    std::ranges::set_union(these, those, std::back_inserter(result));
    return result;
}

}  // namespace

FieldTimes::FieldTimes(const HeatProblem& problem, bool view, const std::vector<double>& kept_times)
    : written(problem.field_times), viewed(view ? view_times(problem.segments) : std::vector<double>{}),
      kept(kept_times), all(united(united(written, viewed), kept))
{}

void FieldTimes::continue_from(double reached, const std::vector<double>& former_written,
                               std::vector<double> former_viewed)
{
    const auto later = [&](std::vector<double> times) {
        std::erase_if(times, [&](double time) { return time <= reached; });
        return times;
    };
    for (const double time : written)
        if (time <= reached && !std::ranges::binary_search(former_written, time))
            throw mistake("output.field_times",
                          fmt::format("{:.2f} h have passed, and the field of {:.2f} h was not kept", reached / 3600,
                                      time / 3600),
                          "add times after that, or compute the run anew without --resume");
    std::erase_if(former_viewed, [&](double time) { return time > reached; });
    written = united(former_written, later(written));
    viewed = united(former_viewed, later(viewed));
    all = united(united(written, viewed), kept);
}

std::vector<double> view_times(const std::vector<HeatSegment>& segments)
{
    constexpr std::size_t wanted = 36;
    constexpr std::size_t fewest = 3;
    double end = 0;
    for (const auto& segment : segments)
        end += segment.duration;
    std::vector<double> times{0.0};
    if (segments.size() * fewest > wanted) {
        for (std::size_t i = 1; i <= wanted; ++i)
            times.push_back(end * static_cast<double>(i) / static_cast<double>(wanted));
        return times;
    }
    const std::size_t each = wanted / std::max<std::size_t>(1, segments.size());
    double start = 0;
    for (const auto& segment : segments) {
        for (std::size_t i = 1; i <= each; ++i) {
            const double s = static_cast<double>(i) / static_cast<double>(each);
            times.push_back(std::min(end, start + segment.duration * s * s));
        }
        start += segment.duration;
    }
    return times;
}

}  // namespace deadpoint::press
