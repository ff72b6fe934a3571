#include "deadpoint/reduce/sensitivity/passing_changes.hpp"

#include "deadpoint/reduce/sensitivity/direction.hpp"
#include "deadpoint/reduce/sensitivity/linearised_heat.hpp"

namespace deadpoint::reduce {
namespace {

/// What passes in a problem at one time, at the temperatures of a run.
class Passing {
public:
    Passing(const HeatProblem& problem, const LinearisedHeat& heat, const LinearisedState& at)
        : problem_(problem), segment_(problem.segments[heat.segment()]), heat_(heat), at_(at)
    {}
    [[nodiscard]] double ambient() const { return now(segment_.ambient); }
    [[nodiscard]] double faced(std::size_t s) const
    {
        const auto& condition = problem_.surfaces[s];
        if (condition.kind != SurfaceCondition::Kind::film || condition.enclosure >= 0)
            return 0;
        return condition.ambient ? now(condition.ambient) : ambient();
    }
    [[nodiscard]] double flux(std::size_t s) const
    {
        const auto& condition = problem_.surfaces[s];
        return condition.kind == SurfaceCondition::Kind::flux ? now(condition.flux) : 0;
    }
    [[nodiscard]] FilmLaw film_law(std::size_t s) const
    {
        const auto& condition = problem_.surfaces[s];
        if (!condition.laws.empty())
            return condition.laws[heat_.segment()](at_.faced[s]);
        return [value = condition.coefficient](double) { return LawValue{value, 0, true}; };
    }
    [[nodiscard]] double heat_of(std::size_t r) const
    {
        const auto& law = segment_.heat[r];
        if (!law)
            return 0;
        const bool by_rings = !segment_.ring_heat.empty() && segment_.ring_heat[r];
        return law(at_.balance.source_temperature[r]).value +
               (by_rings ? segment_.ring_heat[r](heat_.ring_difference(r, at_.values)) : 0);
    }
    [[nodiscard]] double body(std::size_t k) const { return segment_.body_heat[k] ? now(segment_.body_heat[k]) : 0; }
    [[nodiscard]] double power(std::size_t e) const
    {
        const auto& powers = segment_.enclosure_power;
        return !powers.empty() && powers[e] ? now(powers[e]) : 0;
    }
    [[nodiscard]] double emissivity(std::size_t s) const { return problem_.surfaces[s].emissivity; }

private:
    [[nodiscard]] double now(const TimeCourse& course) const { return at_.step.value(course, at_.time); }

    const HeatProblem& problem_;
    const HeatSegment& segment_;
    const LinearisedHeat& heat_;
    const LinearisedState& at_;
};

}  // namespace

ScalarChanges passing_changes(const Direction& direction, const LinearisedHeat& heat, const LinearisedState& at)
{
    if (!direction.passing)
        return {};
    const auto& [problem_less, problem_more, by] = *direction.passing;
    const ScalarLayout layout(heat.problem());
    const Passing less(problem_less, heat, at), more(problem_more, heat, at);
    ScalarChanges result;
    const auto add = [&, divisor = by](std::size_t scalar, double of_less, double of_more) {
        if (of_less != of_more)
            result.emplace_back(scalar, (of_more - of_less) / divisor);
    };
    add(layout.ambient(), less.ambient(), more.ambient());
    for (std::size_t s = 0; s < layout.surfaces; ++s) {
        add(layout.faced(s), less.faced(s), more.faced(s));
        add(layout.flux(s), less.flux(s), more.flux(s));
    }
    for (std::size_t k = 0; k < heat.inner().films.size(); ++k) {
        const auto& [surface, outside, slope, inside] = heat.inner().films[k];
        const auto& film = at.films[k];
        const auto lost = [&, s = surface, in_room = inside >= 0](const Passing& of) {
            return outside_flux(of.film_law(s), of.emissivity(s), in_room, film.mean, film.variance, film.faced);
        };
        const auto slope_of = [&, s = surface](const Passing& of) {
            return heat::film_slope(of.film_law(s)(film.mean), of.emissivity(s), film.mean, film.faced);
        };
        add(layout.lost(surface), lost(less), lost(more));
        add(layout.slope(surface), slope_of(less), slope_of(more));
    }
    for (std::size_t r = 0; r < layout.sources; ++r)
        add(layout.heat(r), less.heat_of(r), more.heat_of(r));
    for (std::size_t k = 0; k < layout.bodies; ++k)
        add(layout.body(k), less.body(k), more.body(k));
    for (std::size_t e = 0; e < layout.enclosures; ++e)
        add(layout.power(e), less.power(e), more.power(e));
    return result;
}

}  // namespace deadpoint::reduce
