#include "deadpoint/heat/films.hpp"

#include "deadpoint/heat/balance.hpp"
#include "deadpoint/heat/functionals.hpp"

#include <algorithm>

namespace deadpoint::heat {

double film_flux(const LawValue& film, double emissivity, double surface, double surroundings)
{
    const double s = surface * surface, a = surroundings * surroundings;
    return (film.value + emissivity * stefan_boltzmann * (s + a) * (surface + surroundings)) * (surface - surroundings);
}

double film_slope(const LawValue& film, double emissivity, double surface, double surroundings)
{
    const double convection = std::max(film.value + film.slope * (surface - surroundings), 0.25 * film.value);
    return convection + 4 * emissivity * stefan_boltzmann * surface * surface * surface;
}

FilmBalance::FilmBalance(const HeatProblem& problem, const HeatGeometry& geometry)
    : problem_(&problem), geometry_(&geometry)
{
    for (std::size_t i = 0; i < problem.surfaces.size(); ++i) {
        if (problem.surfaces[i].kind != SurfaceCondition::Kind::temperature)
            needed_.push_back(geometry.layout.surface(i));
        some_follow_ = some_follow_ || follows_temperature(problem.surfaces[i]);
    }
}

double FilmBalance::surroundings(std::size_t surface, double time, const std::vector<double>& air) const
{
    const auto& condition = problem_->surfaces[surface];
    if (condition.enclosure >= 0)
        return air[static_cast<std::size_t>(condition.enclosure)];
    return step_.value(condition.ambient ? condition.ambient : segment_->ambient, time);
}

double FilmBalance::flux(std::size_t surface, double time) const
{
    return step_.value(problem_->surfaces[surface].flux, time);
}

FilmLaw FilmBalance::law(std::size_t surface, double surroundings) const
{
    const auto& condition = problem_->surfaces[surface];
    if (!condition.laws.empty())
        return condition.laws[static_cast<std::size_t>(segment_ - problem_->segments.data())](surroundings);
    return [value = condition.coefficient](double) { return LawValue{value, 0, true}; };
}

std::vector<FilmAt> FilmBalance::following(double time, const std::vector<double>& air, int enclosure) const
{
    std::vector<FilmAt> result;
    for (std::size_t i = 0; i < problem_->surfaces.size(); ++i) {
        const auto& condition = problem_->surfaces[i];
        if (!follows_temperature(condition) || (enclosure >= 0 && condition.enclosure != enclosure))
            continue;
        const double faced = surroundings(i, time, air);
        result.push_back({i, law(i, faced), condition.emissivity, faced});
    }
    return result;
}

// The sum that receives the heat of a surface's convection: the air of the room or of an enclosure.
double& FilmBalance::taker(HeatBalance& balance, std::size_t surface) const
{
    const int enclosure = problem_->surfaces[surface].enclosure;
    return enclosure < 0 ? balance.to_air : balance.air[static_cast<std::size_t>(enclosure)].from_surfaces;
}

void FilmBalance::evaluate(const std::vector<double>& values, double time, const std::vector<double>& air,
                           HeatBalance& balance, std::vector<double>& watts) const
{
    balance.film_mean.assign(problem_->surfaces.size(), 0.0);
    for (std::size_t i = 0; i < problem_->surfaces.size(); ++i) {
        const auto& condition = problem_->surfaces[i];
        const double area = geometry_->surface_area[i];
        if (condition.kind == SurfaceCondition::Kind::temperature || !(area > 0))
            continue;
        const std::size_t at = geometry_->layout.surface(i);
        balance.film_mean[i] = values[at] / area;
        if (condition.kind == SurfaceCondition::Kind::flux) {
            const double into_part = flux(i, time);
            watts[at] += into_part;
            balance.flux += into_part * area;
        } else if (!follows_temperature(condition)) {
            const double faced = surroundings(i, time, air);
            watts[at] += condition.coefficient * faced;
            taker(balance, i) += condition.coefficient * (values[at] - faced * area);
        }
    }
}

void FilmBalance::book(const FilmHeat& heat, HeatBalance& balance) const
{
    balance.variable_to_air = heat.lost;
    balance.films_untested = heat.untested;
    for (std::size_t i = 0; i < heat.lost.size(); ++i)
        taker(balance, i) += heat.lost[i] - heat.to_surfaces[i];
}

}  // namespace deadpoint::heat
