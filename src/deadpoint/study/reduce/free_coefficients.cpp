#include "deadpoint/study/reduce/free_coefficients.hpp"

#include "deadpoint/exchange/machine.hpp"
#include "deadpoint/heat/films.hpp"
#include "deadpoint/study/reduce/split.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <limits>
#include <map>

namespace deadpoint::study {
namespace {

using Kind = reduce::FreeCoefficient::Kind;

constexpr double nominal_rise = 20;  // [K]

const std::vector<InterfaceLaw>& laws_in(const HeatProblem& problem, const HeatSegment& segment)
{
    return segment.interfaces.empty() ? problem.interfaces : segment.interfaces;
}

double side_of(const std::vector<InterfaceLaw>& laws, std::size_t member)
{
    return member % 2 == 0 ? laws[member / 2].film_a : laws[member / 2].film_b;
}

// Of the first segment in which a source heats [W].
double heat_at(const HeatProblem& problem, std::size_t source, double temperature)
{
    for (const auto& segment : problem.segments)
        if (const auto& law = segment.heat[source])
            return problem.sources[source].share * law(temperature).value;
    return 0;
}

double oil_temperature_of(const HeatProblem& problem) { return problem.interfaces.front().oil_temperature; }

bool is_free(const Span& span) { return span.from < span.to; }

// Segments may have other coefficients than the first one; a draw multiplies each segment's own.
void widen_by_segments(reduce::FreeCoefficient& coefficient, const HeatProblem& problem)
{
    if (coefficient.kind != Kind::side && coefficient.kind != Kind::oil)
        return;
    double least = 1, most = 1;
    for (const auto& segment : problem.segments)
        for (std::size_t k = 0; k < coefficient.members.size(); ++k)
            if (const auto value = value_of(coefficient, k, problem, segment); value && coefficient.base[k] > 0) {
                least = std::min(least, *value);
                most = std::max(most, *value);
            }
    coefficient.from *= least;
    coefficient.to *= most;
}

/// Collects coefficients; members of the same name change together.
class Collector {
public:
    void add(const std::string& name, Kind kind, const Span& span, std::size_t member, double base)
    {
        const auto [place, is_new] = index_.try_emplace(name, box_.size());
        if (is_new)
            box_.push_back({name, kind, {}, {}, span.from, span.to});
        box_[place->second].members.push_back(member);
        box_[place->second].base.push_back(base);
    }
    [[nodiscard]] reduce::Box take() { return std::move(box_); }

private:
    std::map<std::string, std::size_t> index_;
    reduce::Box box_;
};

void add_films(Collector& box, const SplitProblem& split, const Machine& machine, const FreeRanges& ranges)
{
    const auto& surfaces = split.problem.surfaces;
    for (std::size_t s = 0; s < surfaces.size(); ++s) {
        if (surfaces[s].kind != SurfaceCondition::Kind::film)
            continue;
        auto name = "surfaces." + surfaces[s].name + ".film";
        if (ranges.by_piece)
            name += " on " + machine.parts[static_cast<std::size_t>(surfaces[s].part)].name;
        box.add(name, Kind::film, ranges.film, s, surfaces[s].coefficient);
    }
}

void add_joints(Collector& box, const SplitProblem& split, const Machine& machine, const FreeRanges& ranges)
{
    const auto& laws = laws_in(split.problem, split.problem.segments.front());
    for (std::size_t i = 0; i < laws.size(); ++i) {
        const auto& name = machine.interfaces[i].name;
        for (const std::size_t side : {0U, 1U})
            box.add(ranges.by_piece ? fmt::format("joints.{}.{}", name, side == 0 ? "a" : "b") : "joints." + name,
                    Kind::side, ranges.side, 2 * i + side, side_of(laws, 2 * i + side));
        const auto source = laws[i].source;
        const bool by_row = !ranges.by_piece && source >= 0;
        const double missing = is_free(ranges.oil) ? assumed_oil : 0;
        box.add(by_row ? "oil." + split.problem.sources[static_cast<std::size_t>(source)].name
                       : fmt::format("joints.{}.oil", name),
                Kind::oil, ranges.oil, i, laws[i].oil > 0 ? laws[i].oil : missing);
    }
}

}  // namespace

reduce::Box free_coefficients(const SplitProblem& split, const Machine& machine, const FreeRanges& ranges, double start)
{
    Collector box;
    add_films(box, split, machine, ranges);
    add_joints(box, split, machine, ranges);
    for (std::size_t r = 0; r < split.problem.sources.size(); ++r)
        box.add("friction." + split.problem.sources[r].name, Kind::heat, ranges.heat, r,
                heat_at(split.problem, r, start));
    if (!split.problem.interfaces.empty())
        box.add("oil temperature", Kind::oil_temperature, ranges.oil_temperature, 0, oil_temperature_of(split.problem));
    box.add("ambient", Kind::ambient, ranges.ambient, 0, split.problem.segments.front().ambient(0));
    auto result = box.take();
    for (auto& coefficient : result)
        widen_by_segments(coefficient, split.problem);
    return result;
}

std::optional<double> value_of(const reduce::FreeCoefficient& coefficient, std::size_t member,
                               const HeatProblem& problem, const HeatSegment& segment)
{
    const auto place = coefficient.members[member];
    const double base = coefficient.base[member];
    const auto factor = [&](double value) -> std::optional<double> {
        if (base > 0)
            return value / base;
        return value > 0 ? std::optional(std::numeric_limits<double>::infinity()) : std::nullopt;
    };
    switch (coefficient.kind) {
    case Kind::film:
        return factor(problem.surfaces[place].coefficient);
    case Kind::side:
        return factor(side_of(laws_in(problem, segment), place));
    case Kind::oil:
        return factor(laws_in(problem, segment)[place].oil);
    case Kind::oil_temperature:
        return oil_temperature_of(problem) - base;
    case Kind::heat:     // by name (outside.cpp)
    case Kind::ambient:  // a course (outside.cpp)
        break;
    }
    return std::nullopt;
}

HeatProblem with_nominal_films(const HeatProblem& problem, double start)
{
    auto result = problem;
    result.radiation.clear();
    const double warm = start + nominal_rise;
    for (auto& condition : result.surfaces) {
        if (!heat::follows_temperature(condition))
            continue;
        const LawValue film =
            condition.laws.empty() ? LawValue{condition.coefficient, 0, true} : condition.laws.front()(start)(warm);
        condition.coefficient = heat::film_flux(film, condition.emissivity, warm, start) / nominal_rise;
        condition.laws.clear();
        condition.emissivity = 0;
    }
    return result;
}

}  // namespace deadpoint::study
