#include "deadpoint/twin/run/free_coefficients.hpp"

#include "deadpoint/exchange/machine.hpp"
#include "deadpoint/heat/films.hpp"
#include "deadpoint/twin/run/films_by_part.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <limits>
#include <map>

namespace deadpoint::twin {
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

// Heat of a source in a segment, in which a press at rest has no law [W].
std::optional<double> heat_in(const HeatProblem& problem, std::size_t segment, std::size_t source, double temperature)
{
    const auto& law = problem.segments[segment].heat[source];
    return law ? std::optional(problem.sources[source].share * law(temperature).value) : std::nullopt;
}

// Heat of a source in the first segment in which it heats [W].
double heat_at(const HeatProblem& problem, std::size_t source, double temperature)
{
    for (std::size_t segment = 0; segment < problem.segments.size(); ++segment)
        if (const auto heat = heat_in(problem, segment, source, temperature))
            return *heat;
    return 0;
}

// Oil coefficient of a joint in the first segment in which its oil flows: while the press stands still it may not.
std::optional<double> oil_at(const HeatProblem& problem, std::size_t interface)
{
    for (const auto& segment : problem.segments)
        if (const double oil = laws_in(problem, segment)[interface].oil; oil > 0)
            return oil;
    return std::nullopt;
}

// The oil of its joint comes from a circuit.
bool in_circuit(const HeatProblem& problem, std::size_t interface)
{
    return std::ranges::any_of(problem.oil, [&](const OilCourse& circuit) {
        return std::ranges::any_of(circuit.joints, [&](const std::vector<int>& joint) {
            return std::ranges::find(joint, static_cast<int>(interface)) != joint.end();
        });
    });
}

// Temperature of a joint's own oil, or of that of a circuit that is cooled.
std::optional<double> oil_temperature_of(const HeatProblem& problem, std::size_t segment, std::size_t member)
{
    const auto& laws = laws_in(problem, problem.segments[segment]);
    if (member < laws.size())
        return laws[member].oil > 0 && !in_circuit(problem, member) ? std::optional(laws[member].oil_temperature)
                                                                    : std::nullopt;
    const auto circuit = member - laws.size();
    return circuit < problem.oil.size() && problem.oil[circuit].cooled
               ? std::optional(problem.oil[circuit].inlet_temperature)
               : std::nullopt;
}

/// One of the bonds after the interfaces of joints: it never sees oil.
bool is_bond(const Contact& contact) { return contact.name.find('|') != std::string::npos; }

bool is_free(const Span& span) { return span.from < span.to; }

// Segments may have other coefficients than the first one, and so may other points of operation; a draw multiplies each
// segment's own.
void widen_by_segments(reduce::FreeCoefficient& coefficient, const HeatProblem& problem,
                       const std::vector<SplitProblem>& others, double start)
{
    double least = 1, most = 1;
    const auto widen = [&](const HeatProblem& by) {
        for (std::size_t segment = 0; segment < by.segments.size(); ++segment)
            for (std::size_t k = 0; k < coefficient.members.size(); ++k)
                if (const auto value = value_of(coefficient, k, by, segment, start); value && coefficient.base[k] > 0) {
                    least = std::min(least, *value);
                    most = std::max(most, *value);
                }
    };
    widen(problem);
    for (const auto& other : others)
        widen(other.problem);
    coefficient.from *= least;
    coefficient.to *= most;
}

/// Collects coefficients; members of the same name change together.
class CoefficientCollector {
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

void add_films(CoefficientCollector& box, const SplitProblem& split, const Machine& machine, const FreeRanges& ranges,
               double start)
{
    const auto& surfaces = split.problem.surfaces;
    for (std::size_t s = 0; s < surfaces.size(); ++s) {
        if (surfaces[s].kind != SurfaceCondition::Kind::film)
            continue;
        auto name = "surfaces." + surfaces[s].name + ".film";
        if (ranges.by_piece)
            name += " on " + machine.parts[static_cast<std::size_t>(surfaces[s].part)].name;
        box.add(name, Kind::film, ranges.film, s, nominal_film(surfaces[s], 0, start));
    }
}

void add_joints(CoefficientCollector& box, const SplitProblem& split, const Machine& machine, const FreeRanges& ranges)
{
    const auto& laws = laws_in(split.problem, split.problem.segments.front());
    for (std::size_t i = 0; i < laws.size(); ++i) {
        const auto& name = machine.interfaces[i].name;
        const bool bond = is_bond(machine.interfaces[i]);
        for (const std::size_t side : {0U, 1U})
            box.add(bond              ? "bonds." + name
                    : ranges.by_piece ? fmt::format("joints.{}.{}", name, side == 0 ? "a" : "b")
                                      : "joints." + name,
                    Kind::side, ranges.side, 2 * i + side, side_of(laws, 2 * i + side));
        if (bond)
            continue;
        const auto source = laws[i].source;
        const bool by_row = !ranges.by_piece && source >= 0;
        const double missing = is_free(ranges.oil) ? assumed_oil : 0;
        box.add(by_row ? "oil." + split.problem.sources[static_cast<std::size_t>(source)].name
                       : fmt::format("joints.{}.oil", name),
                Kind::oil, ranges.oil, i, oil_at(split.problem, i).value_or(missing));
    }
}

void add_oil_temperatures(CoefficientCollector& box, const HeatProblem& problem, const Machine& machine,
                          const FreeRanges& ranges)
{
    for (std::size_t member = 0; member < problem.interfaces.size() + problem.oil.size(); ++member)
        if (const bool is_joint = member < problem.interfaces.size();
            !is_joint || !(is_bond(machine.interfaces[member]) || in_circuit(problem, member))) {
            const double base = is_joint ? laws_in(problem, problem.segments.front())[member].oil_temperature
                                         : problem.oil[member - problem.interfaces.size()].inlet_temperature;
            box.add("oil temperature", Kind::oil_temperature, ranges.oil_temperature, member, base);
        }
}

// The room's, then those that films state for themselves.
void add_ambients(CoefficientCollector& box, const HeatProblem& problem, const FreeRanges& ranges)
{
    box.add("ambient", Kind::ambient, ranges.ambient, 0, problem.segments.front().ambient(0));
    for (std::size_t s = 0; s < problem.surfaces.size(); ++s)
        if (problem.surfaces[s].ambient)
            box.add("ambient", Kind::ambient, ranges.ambient, 1 + s, problem.surfaces[s].ambient(0));
}

}  // namespace

reduce::Box free_coefficients(const SplitProblem& split, const Machine& machine, const FreeRanges& ranges, double start,
                              const std::vector<SplitProblem>& others)
{
    CoefficientCollector box;
    add_films(box, split, machine, ranges, start);
    add_joints(box, split, machine, ranges);
    for (std::size_t r = 0; r < split.problem.sources.size(); ++r)
        box.add(heat_name(split.problem.sources[r]), Kind::heat, ranges.heat, r, heat_at(split.problem, r, start));
    add_oil_temperatures(box, split.problem, machine, ranges);
    add_ambients(box, split.problem, ranges);
    auto result = box.take();
    for (auto& coefficient : result)
        if (coefficient.kind == Kind::film || coefficient.kind == Kind::side || coefficient.kind == Kind::oil)
            widen_by_segments(coefficient, split.problem, others, start);
    return result;
}

reduce::Box with_heat_of(reduce::Box box, const SplitProblem& split, const std::vector<SplitProblem>& others,
                         double start)
{
    for (auto& coefficient : box)
        if (coefficient.kind == Kind::heat)
            widen_by_segments(coefficient, split.problem, others, start);
    return box;
}

std::string heat_name(const HeatSource& source) { return "friction." + source.name; }

reduce::FreeCoefficient in_problem(reduce::FreeCoefficient coefficient, const HeatProblem& problem)
{
    if (coefficient.kind != Kind::heat)
        return coefficient;
    const double base = coefficient.base.front();
    coefficient.members.clear();
    for (std::size_t r = 0; r < problem.sources.size(); ++r)
        if (heat_name(problem.sources[r]) == coefficient.name)
            coefficient.members.push_back(r);
    coefficient.base.assign(coefficient.members.size(), base);
    return coefficient;
}

std::optional<double> value_of(const reduce::FreeCoefficient& coefficient, std::size_t member,
                               const HeatProblem& problem, std::size_t segment, double start)
{
    const auto place = coefficient.members[member];
    const double base = coefficient.base[member];
    const auto factor = [&](double value) -> std::optional<double> {
        if (base > 0)
            return value / base;
        return value > 0 ? std::optional(std::numeric_limits<double>::infinity()) : std::nullopt;
    };
    const auto& laws = laws_in(problem, problem.segments[segment]);
    switch (coefficient.kind) {
    case Kind::film:
        return factor(nominal_film(problem.surfaces[place], segment, start));
    case Kind::side:
        return factor(side_of(laws, place));
    case Kind::oil:
        return factor(laws[place].oil);
    case Kind::oil_temperature:
        if (const auto temperature = oil_temperature_of(problem, segment, place))
            return *temperature - base;
        break;
    case Kind::heat:
        if (const auto heat = heat_in(problem, segment, place, start))
            return factor(*heat);
        break;
    case Kind::ambient:  // a course (outside.cpp)
        break;
    }
    return std::nullopt;
}

double nominal_film(const SurfaceCondition& film, std::size_t segment, double start)
{
    if (!heat::follows_temperature(film))
        return film.coefficient;
    const double warm = start + nominal_rise;
    const LawValue convection =
        film.laws.empty() ? LawValue{film.coefficient, 0, true} : film.laws.at(segment)(start)(warm);
    return heat::film_flux(convection, film.emissivity, warm, start) / nominal_rise;
}

HeatProblem with_nominal_films(const HeatProblem& problem, double start)
{
    auto result = problem;
    result.radiation.clear();
    for (auto& condition : result.surfaces) {
        condition.coefficient = nominal_film(condition, 0, start);
        condition.laws.clear();
        condition.emissivity = 0;
    }
    return result;
}

}  // namespace deadpoint::twin
