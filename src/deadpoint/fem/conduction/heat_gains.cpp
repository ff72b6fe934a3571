#include "deadpoint/fem/conduction/heat_solver.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

// What enters the heat balance at one time; the matrices are in heat_assembly.cpp.

namespace deadpoint::fem {

double value_at(const PointShape& shape, const double* values)
{
    double at = 0;
    for (int i = 0; i < shape.count; ++i)
        at += shape.value[i] * values[shape.dof[i]];
    return at;
}

double HeatSolver::ambient(const SurfaceCondition& condition, double time) const
{
    if (condition.enclosure >= 0)
        return air_->temperature(static_cast<std::size_t>(condition.enclosure));
    return condition.ambient ? condition.ambient(time) : segment_->ambient(time);
}

FilmLaw HeatSolver::film_at(const SurfaceCondition& c, double surroundings) const
{
    if (!c.laws.empty())
        return c.laws[static_cast<std::size_t>(segment_ - problem_->segments.data())](surroundings);
    return [value = c.coefficient](double) { return LawValue{value, 0, true}; };
}

double HeatSolver::film_flux(const LawValue& film, double emissivity, double surface, double surroundings)
{
    const double s = surface * surface, a = surroundings * surroundings;
    return (film.value + emissivity * stefan_boltzmann * (s + a) * (surface + surroundings)) * (surface - surroundings);
}

double HeatSolver::film_slope(const LawValue& film, double emissivity, double surface, double surroundings)
{
    // A slope of the wrong sign (a film that weakens as it warms) would cost the matrix its definiteness.
    const double convection = std::max(film.value + film.slope * (surface - surroundings), 0.25 * film.value);
    return convection + 4 * emissivity * stefan_boltzmann * surface * surface * surface;
}

namespace {

// What the heat of a surface's film goes to.
double& taker(HeatRate& rate, const SurfaceCondition& condition)
{
    return condition.enclosure < 0 ? rate.to_air
                                   : rate.air[static_cast<std::size_t>(condition.enclosure)].from_surfaces;
}

}  // namespace

void HeatSolver::add_variable_films(HeatRate& rate, double time, Vec temperature) const
{
    const double* values = everywhere_->gather(temperature);
    const auto received = irradiation(values);
    const std::size_t count = problem_->surfaces.size();
    std::vector<double> sums(3 * count,
                             0.0);  // untested area per condition, the heat lost, what went to other surfaces
    for (const auto& film : films_) {
        if (film.points.empty())
            continue;
        const double surroundings = ambient(*film.condition, time);
        const auto law = film_at(*film.condition, surroundings);
        const bool in_room = received[film.index] > 0;
        for (const auto& point : film.points) {
            const double at = value_at(point.shape, values), emissivity = film.condition->emissivity;
            const LawValue value = law(at);
            const double to_surfaces = in_room ? point.weight * film_flux({}, emissivity, at, received[film.index]) : 0;
            const double flow =
                to_surfaces + point.weight * film_flux(value, in_room ? 0 : emissivity, at, surroundings);
            sums[film.index] += value.in_range ? 0 : point.weight;
            sums[count + film.index] += flow;
            sums[2 * count + film.index] += to_surfaces;
            for (int i = 0; i < point.shape.count; ++i)
                DEADPOINT_PETSC(VecSetValue(rate.vector, point.shape.dof[i], -flow * point.shape.value[i], ADD_VALUES));
        }
    }
    DEADPOINT_PETSC(VecAssemblyBegin(rate.vector));
    DEADPOINT_PETSC(VecAssemblyEnd(rate.vector));
    sum_over_ranks(sums);
    rate.variable_to_air.assign(sums.begin() + static_cast<std::ptrdiff_t>(count),
                                sums.begin() + static_cast<std::ptrdiff_t>(2 * count));
    for (std::size_t i = 0; i < count; ++i)
        taker(rate, problem_->surfaces[i]) += sums[count + i] - sums[2 * count + i];
    sums.resize(count);
    rate.films_untested = std::move(sums);
}

double HeatSolver::ring_difference(const HeatSource& source, const std::vector<double>& mean) const
{
    const auto average = [&](const std::vector<InterfaceSide>& sides) {
        double sum = 0, area = 0;
        for (const auto& side : sides) {
            const auto i = static_cast<std::size_t>(side.interface);
            sum += interfaces_[i].area * mean[2 * i + (side.b ? 1 : 0)];
            area += interfaces_[i].area;
        }
        return sum / area;
    };
    return average(source.inner_rings) - average(source.outer_rings);
}

// Heat of each source at the film temperature it makes itself: H = law(tau + self H), tau from the solids and the oil.
// @param mean  of both sides of each interface, then the solids' part of each source's temperature [K]
void HeatSolver::add_sources(HeatRate& rate, const std::vector<double>& mean) const
{
    const std::size_t count = problem_->sources.size();
    rate.source_heat.assign(count, 0.0);
    rate.source_slope.assign(count, 0.0);
    rate.source_temperature.assign(count, 0.0);
    for (std::size_t r = 0; r < count; ++r) {
        const auto& source = problem_->sources[r];
        const double start = mean[2 * interfaces_.size() + r] + source_constant_[r];
        double film = start;
        if (const auto& law = segment_->heat[r]) {
            const bool by_rings = !segment_->ring_heat.empty() && segment_->ring_heat[r];
            const double ring_heat = by_rings ? segment_->ring_heat[r](ring_difference(source, mean)) : 0;
            double heat = 0, slope = 0;
            for (int i = 0; i < 50; ++i) {
                const LawValue value = law(film);
                heat = source.share * (value.value + ring_heat);
                slope = source.share * value.slope;
                rate.in_range = rate.in_range && value.in_range;
                const double residual = film - start - source_self_[r] * heat;
                film -= residual / (1 - source_self_[r] * slope);
                if (std::abs(residual) < 1e-11 * std::abs(film))
                    break;
            }
            rate.source_heat[r] = heat;
            rate.source_slope[r] = slope / (1 - source_self_[r] * slope);
            add_to(rate.vector, source_loads_[r], heat);
        }
        rate.source_temperature[r] = film;
        rate.generated += rate.source_heat[r];
    }
}

void HeatSolver::add_interfaces(HeatRate& rate, const std::vector<double>& mean) const
{
    rate.film.resize(interfaces_.size());
    for (std::size_t i = 0; i < interfaces_.size(); ++i) {
        const auto& law = (*laws_)[i];
        const auto& interface = interfaces_[i];
        const double density =
            law.source >= 0 ? rate.source_heat[law.source] * interface.film_heat / interface.area : 0;
        rate.film[i] =
            (density + law.film_a * mean[2 * i] + law.film_b * mean[2 * i + 1] + law.oil * oil_temperature_[i]) /
            interface.sum;
        rate.to_oil += law.oil * interface.area * (rate.film[i] - oil_temperature_[i]);
        const double from_oil = law.oil * oil_temperature_[i] * interface.area / interface.sum;
        add_to(rate.vector, interface.mean_a, from_oil * law.film_a);
        add_to(rate.vector, interface.mean_b, from_oil * law.film_b);
        if (law.source >= 0 && !interface.load_zone.local.empty())
            add_to(rate.vector, interface.load_zone,
                   problem_->sources[law.source].share * segment_->zoned_heat[law.source] * interface.heat_weight_area);
    }
}

void HeatSolver::add_body_heat(HeatRate& rate, double time) const
{
    rate.body_heat.assign(body_loads_.size(), 0.0);
    for (std::size_t k = 0; k < body_loads_.size(); ++k)
        if (const auto& power = segment_->body_heat[k]) {
            rate.body_heat[k] = power(time);
            add_to(rate.vector, body_loads_[k], rate.body_heat[k]);
            rate.generated += rate.body_heat[k];
        }
}

HeatRate HeatSolver::gains(double time, Vec temperature) const
{
    HeatRate result;
    result.time = time;
    result.oil_temperature = oil_temperature_;
    result.vector = duplicate(temperature);
    DEADPOINT_PETSC(VecZeroEntries(result.vector));
    result.air.resize(air_->count());

    std::vector<const SparseFunctional*> integrals;
    for (const auto& film : films_)
        integrals.push_back(&film.integral);
    const auto integral = evaluate(integrals, temperature);
    for (std::size_t i = 0; i < films_.size(); ++i) {
        const auto& film = films_[i];
        const auto& condition = *film.condition;
        result.film_mean.push_back(integral[i] / std::max(film.area, 1e-300));
        if (condition.kind == SurfaceCondition::Kind::flux) {
            const double flux = condition.flux(time);
            add_to(result.vector, film.integral, flux);
            result.flux += flux * film.area;
        } else if (film.points.empty() && film.area > 0 && condition.kind == SurfaceCondition::Kind::film &&
                   !depends_on_temperature(condition)) {
            const double surroundings = ambient(condition, time);
            add_to(result.vector, film.integral, condition.coefficient * surroundings);
            taker(result, condition) += condition.coefficient * (integral[i] - surroundings * film.area);
        }
    }
    std::vector<const SparseFunctional*> means;
    for (const auto& interface : interfaces_) {
        means.push_back(&interface.mean_a);
        means.push_back(&interface.mean_b);
    }
    for (const auto& load : source_loads_)
        means.push_back(&load);
    const auto mean = evaluate(means, temperature);
    add_sources(result, mean);
    add_interfaces(result, mean);
    add_body_heat(result, time);
    if (variable_films_)
        add_variable_films(result, time, temperature);
    add_enclosures(result, time);
    return result;
}

void HeatSolver::impose(double time, Vec temperature) const
{
    double* values = nullptr;
    DEADPOINT_PETSC(VecGetArray(temperature, &values));
    for (std::size_t i = 0; i < prescribed_.size(); ++i)
        values[prescribed_[i] - space_.first] = prescribed_at_[i].second->temperature(prescribed_at_[i].first, time);
    DEADPOINT_PETSC(VecRestoreArray(temperature, &values));
}

void HeatSolver::clear_prescribed(Vec residual) const
{
    double* values = nullptr;
    DEADPOINT_PETSC(VecGetArray(residual, &values));
    for (const PetscInt row : prescribed_)
        values[row - space_.first] = 0;
    DEADPOINT_PETSC(VecRestoreArray(residual, &values));
}

// What the tangent of the law, with which the solve was made, gives less the law itself, per source.
std::vector<double> HeatSolver::tangent_less_law(const HeatRate& before, const HeatRate& after) const
{
    std::vector<double> result;
    for (std::size_t r = 0; r < after.source_heat.size(); ++r)
        result.push_back(before.source_heat[r] + before.source_slope[r] * source_change(r, before, after) -
                         after.source_heat[r]);
    return result;
}

void HeatSolver::correct_heat(HeatRate& rate, const std::vector<double>& corrections) const
{
    for (std::size_t r = 0; r < corrections.size(); ++r) {
        add_to(rate.vector, source_loads_[r], corrections[r]);
        rate.source_heat[r] += corrections[r];
        rate.source_temperature[r] += source_self_[r] * corrections[r];
        rate.generated += corrections[r];
        rate.to_oil += source_to_oil_[r] * corrections[r];
    }
}

double HeatSolver::source_change(std::size_t r, const HeatRate& before, const HeatRate& after) const
{
    // The solid part of the film temperature, without the row's own heat.
    return (after.source_temperature[r] - source_self_[r] * after.source_heat[r]) -
           (before.source_temperature[r] - source_self_[r] * before.source_heat[r]);
}

}  // namespace deadpoint::fem
