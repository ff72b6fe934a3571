#include "deadpoint/heat/joints.hpp"

#include "deadpoint/error.hpp"
#include "deadpoint/heat/balance.hpp"

#include <algorithm>
#include <cmath>

namespace deadpoint::heat {
namespace {

constexpr int most_law_steps = 50;

struct SourceHeat {
    double heat = 0;
    double slope = 0;  ///< derivative by the film temperature
    double film = 0;   ///< temperature of the film [K]
    bool in_range = true;
};

// H = share (law(tau) + extra) at tau = start + self H.
SourceHeat solve_source(const LawTable& law, double share, double extra, double start, double self)
{
    SourceHeat result;
    result.film = start;
    for (int i = 0; i < most_law_steps; ++i) {
        const LawValue value = law(result.film);
        result.heat = share * (value.value + extra);
        result.slope = share * value.slope;
        result.in_range = result.in_range && value.in_range;
        const double residual = result.film - start - self * result.heat;
        result.film -= residual / (1 - self * result.slope);
        if (std::abs(residual) < 1e-11 * std::abs(result.film))
            break;
    }
    return result;
}

}  // namespace

JointBalance::JointBalance(const HeatProblem& problem, const HeatGeometry& geometry)
    : problem_(&problem), geometry_(&geometry), laws_(&problem.interfaces)
{}

void JointBalance::enter(const HeatSegment& segment)
{
    segment_ = &segment;
    laws_ = segment.interfaces.empty() ? &problem_->interfaces : &segment.interfaces;
    std::vector<double> weighted_area(problem_->sources.size(), 0.0);
    for (std::size_t i = 0; i < laws_->size(); ++i)
        if (const auto& law = (*laws_)[i]; law.source >= 0)
            weighted_area[static_cast<std::size_t>(law.source)] += law.heat_weight * area(i);
    sources_.assign(problem_->sources.size(), {});
    films_.assign(laws_->size(), {});
    std::vector<double> oil;
    for (std::size_t i = 0; i < laws_->size(); ++i) {
        const auto& law = (*laws_)[i];
        oil.push_back(law.oil_temperature);
        enter_interface(i, law.source >= 0 ? weighted_area[static_cast<std::size_t>(law.source)] : 0);
    }
    set_oil(oil);
}

// Heat into a film leaves it through both sides and the oil; heat into a part's volume stays there.
void JointBalance::enter_interface(std::size_t i, double weighted_area)
{
    const auto& law = (*laws_)[i];
    const auto& layout = geometry_->layout;
    auto& film = films_[i];
    film.sum = law.film_a + law.film_b + law.oil;
    if (!(film.sum > 0) || !std::isfinite(film.sum))
        throw DomainError("interface '" + geometry_->interface_names[i] +
                          "' conducts nothing to either side nor to the oil; give it a conductance");
    if (law.source < 0)
        return;
    film.heat_share = law.heat_weight * area(i) / weighted_area;
    auto& source = sources_[static_cast<std::size_t>(law.source)];
    if (law.heat_part >= 0) {
        source.load.push_back({layout.part(static_cast<std::size_t>(law.heat_part)), film.heat_share});
        return;
    }
    film.film_share = film.heat_share;
    for (const bool side_b : {false, true})
        source.load.push_back({layout.mean(i, side_b), film.heat_share * side_share(i, side_b)});
    source.to_oil += film.heat_share * law.oil / film.sum;
    source.self += film.heat_share * film.heat_share / (area(i) * film.sum);
}

std::vector<std::size_t> JointBalance::needed() const
{
    std::vector<std::size_t> result;
    for (std::size_t i = 0; i < laws_->size(); ++i)
        for (const bool side_b : {false, true})
            result.push_back(geometry_->layout.mean(i, side_b));
    for (const auto& law : *laws_)
        if (law.source >= 0 && law.heat_part >= 0)
            result.push_back(geometry_->layout.part(static_cast<std::size_t>(law.heat_part)));
    return result;
}

double JointBalance::side_share(std::size_t i, bool side_b) const
{
    const auto& law = (*laws_)[i];
    return (side_b ? law.film_b : law.film_a) / films_[i].sum;
}

void JointBalance::evaluate(const std::vector<double>& values, HeatBalance& balance, std::vector<double>& watts) const
{
    const std::size_t count = sources_.size();
    balance.oil_temperature = oil_temperature_;
    balance.source_heat.assign(count, 0.0);
    balance.source_slope.assign(count, 0.0);
    balance.source_temperature.assign(count, 0.0);
    for (std::size_t r = 0; r < count; ++r) {
        evaluate_source(r, values, balance);
        add_watts(watts, sources_[r].load, balance.source_heat[r]);
    }
    balance.film.resize(laws_->size());
    for (std::size_t i = 0; i < laws_->size(); ++i)
        evaluate_interface(i, values, balance, watts);
}

double JointBalance::ring_difference(const HeatSource& source, const std::vector<double>& values) const
{
    const auto average = [&](const std::vector<InterfaceSide>& sides) {
        double sum = 0, whole = 0;
        for (const auto& side : sides) {
            const auto i = static_cast<std::size_t>(side.interface);
            sum += area(i) * values[geometry_->layout.mean(i, side.b)];
            whole += area(i);
        }
        return sum / whole;
    };
    return average(source.inner_rings) - average(source.outer_rings);
}

void JointBalance::evaluate_source(std::size_t r, const std::vector<double>& values, HeatBalance& balance) const
{
    const auto& terms = sources_[r];
    const double start = value_of(terms.load, values) + terms.constant;
    balance.source_temperature[r] = start;
    const auto& law = segment_->heat[r];
    if (!law)
        return;
    const auto& source = problem_->sources[r];
    const bool by_rings = !segment_->ring_heat.empty() && segment_->ring_heat[r];
    const double ring_heat = by_rings ? segment_->ring_heat[r](ring_difference(source, values)) : 0;
    const auto solved = solve_source(law, source.share, ring_heat, start, terms.self);
    balance.source_heat[r] = solved.heat;
    balance.source_slope[r] = solved.slope / (1 - terms.self * solved.slope);
    balance.source_temperature[r] = solved.film;
    balance.in_range = balance.in_range && solved.in_range;
    balance.generated += solved.heat;
}

void JointBalance::evaluate_interface(std::size_t i, const std::vector<double>& values, HeatBalance& balance,
                                      std::vector<double>& watts) const
{
    const auto& law = (*laws_)[i];
    const auto& film = films_[i];
    const auto& layout = geometry_->layout;
    const double heat =
        law.source >= 0 ? balance.source_heat[static_cast<std::size_t>(law.source)] * film.film_share / area(i) : 0;
    balance.film[i] = (heat + law.film_a * values[layout.mean(i, false)] + law.film_b * values[layout.mean(i, true)] +
                       law.oil * oil_temperature_[i]) /
                      film.sum;
    balance.to_oil += law.oil * area(i) * (balance.film[i] - oil_temperature_[i]);
    const double from_oil = law.oil * oil_temperature_[i] * area(i) / film.sum;
    watts[layout.mean(i, false)] += from_oil * law.film_a;
    watts[layout.mean(i, true)] += from_oil * law.film_b;
    if (law.source >= 0 && law.load_zone)
        add_zone(i, watts);
}

void JointBalance::add_zone(std::size_t i, std::vector<double>& watts) const
{
    const auto& law = (*laws_)[i];
    const auto source = static_cast<std::size_t>(law.source);
    const double heat = problem_->sources[source].share * segment_->zoned_heat[source] * films_[i].heat_share;
    if (law.heat_part >= 0) {
        watts[geometry_->layout.zone(i, false)] += heat;
        return;
    }
    for (const bool side_b : {false, true})
        watts[geometry_->layout.zone(i, side_b)] += heat * side_share(i, side_b);
}

// Derivative by the solids' part of the film temperature, which excludes the source's own heat.
std::vector<double> JointBalance::tangent_less_law(const HeatBalance& before, const HeatBalance& after) const
{
    std::vector<double> result;
    for (std::size_t r = 0; r < after.source_heat.size(); ++r) {
        const auto solids = [&](const HeatBalance& at) {
            return at.source_temperature[r] - sources_[r].self * at.source_heat[r];
        };
        result.push_back(before.source_heat[r] + before.source_slope[r] * (solids(after) - solids(before)) -
                         after.source_heat[r]);
    }
    return result;
}

void JointBalance::correct(HeatBalance& balance, const std::vector<double>& corrections,
                           std::vector<double>& watts) const
{
    for (std::size_t r = 0; r < corrections.size(); ++r) {
        add_watts(watts, sources_[r].load, corrections[r]);
        balance.source_heat[r] += corrections[r];
        balance.source_temperature[r] += sources_[r].self * corrections[r];
        balance.generated += corrections[r];
        balance.to_oil += sources_[r].to_oil * corrections[r];
    }
}

void JointBalance::set_oil(const std::vector<double>& temperature)
{
    oil_temperature_ = temperature;
    for (auto& source : sources_)
        source.constant = 0;
    for (std::size_t i = 0; i < laws_->size(); ++i)
        if (const auto& law = (*laws_)[i]; law.source >= 0)
            sources_[static_cast<std::size_t>(law.source)].constant +=
                films_[i].film_share * law.oil * oil_temperature_[i] / films_[i].sum;
}

double JointBalance::film_with_oil(std::size_t i, double film, double oil) const
{
    return film + (*laws_)[i].oil / films_[i].sum * (oil - oil_temperature_[i]);
}

}  // namespace deadpoint::heat
