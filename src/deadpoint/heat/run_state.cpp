#include "deadpoint/heat/run_state.hpp"

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace deadpoint::heat {
namespace {

template <class Value>
bool fits(const std::vector<Value>& read, const std::vector<Value>& like, std::size_t rows);

// Whether what was read has the lengths that belong to a problem. @param rows  of a column that has one in `like`
template <class Value>
bool fits(const Value& read, const Value& like, std::size_t rows)
{
    if constexpr (std::is_arithmetic_v<Value>)
        return true;
    else
        return std::apply([&](auto... member) { return (fits(read.*member, like.*member, rows) && ...); },
                          members(&read));
}

template <class Value>
bool fits(const std::vector<Value>& read, const std::vector<Value>& like, std::size_t rows)
{
    if constexpr (std::is_same_v<Value, bool>)
        return read.size() == like.size();
    else if constexpr (std::is_arithmetic_v<Value>)
        return read.size() == like.size() * rows;
    else
        return std::ranges::equal(read, like, [&](const Value& a, const Value& b) { return fits(a, b, rows); });
}

bool same_lists(const RunState& read, const RunState& like, const HeatProblem& problem)
{
    const auto& segments = problem.segments;
    return read.place.segment < segments.size() && read.origin.segment < segments.size() &&
           read.sumps.size() == like.sumps.size() && read.oil_temperature.size() == like.oil_temperature.size() &&
           read.air.size() == like.air.size() && read.origin.air.size() == like.air.size() &&
           read.place.next_field <= problem.field_times.size();
}

bool sound_times(const RunState& read, const HeatProblem& problem)
{
    const auto& place = read.place;
    double start = 0;
    for (std::size_t i = 0; i < place.segment; ++i)
        start += problem.segments[i].duration;
    const bool in_segment = place.segment_start == start && place.time > start &&
                            place.time <= start + problem.segments[place.segment].duration;
    return in_segment && place.wanted > 0 && std::isfinite(place.wanted) && read.previous_step >= 0 &&
           std::isfinite(read.previous_step) && std::isfinite(read.origin.factor);
}

// Extremes have an entry a part at any time.
bool same_history(ThermalHistory read, const ThermalHistory& like, std::size_t rows)
{
    const bool parts =
        read.part_lowest.size() == like.part_lowest.size() && read.part_highest.size() == like.part_highest.size();
    read.part_lowest = read.part_highest = {};
    auto without = like;
    without.part_lowest = without.part_highest = {};
    return parts && fits(read, without, rows);
}

bool sound_past(const RunState& read, const RunState& like, const HeatProblem& problem)
{
    const auto rows = read.history.time.size();
    const StageRecord& stage = like.balance;
    const auto sound_step = [&](const StepRecord& step) {
        return step.segment < problem.segments.size() && step.row < rows && step.duration > 0 &&
               fits(step.start, stage, 1) && fits(step.middle, stage, 1) && fits(step.end, stage, 1);
    };
    return same_history(read.history, like.history, rows) && rows >= 2 && read.place.segment_row <= rows - 2 &&
           std::ranges::is_sorted(read.history.time) && read.history.time.back() == read.place.time &&
           fits(read.balance, like.balance, 1) && std::ranges::all_of(read.steps, sound_step);
}

}  // namespace

std::string misfit(const RunState& read, const RunState& like, const HeatProblem& problem)
{
    if (!same_lists(read, like, problem))
        return "its lists are not those of this case";
    if (!sound_times(read, problem))
        return "its times are not those of this case";
    if (!sound_past(read, like, problem))
        return "its history is not one of this case";
    return {};
}

}  // namespace deadpoint::heat
