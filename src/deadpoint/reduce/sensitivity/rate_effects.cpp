#include "deadpoint/reduce/sensitivity/rate_effects.hpp"

#include "deadpoint/exchange/heat.hpp"
#include "deadpoint/reduce/sensitivity/linearised_heat.hpp"

#include <array>

namespace deadpoint::reduce {
namespace {

/// A unit change of one scalar of an interface's law.
struct JointChange {
    JointChange(JointScalar scalar)
    {
        std::array<double, 4> x{};
        x[static_cast<std::size_t>(scalar)] = 1;
        film_a = x[0], film_b = x[1], oil = x[2], oil_temperature = x[3];
    }
    double film_a = 0, film_b = 0, oil = 0, oil_temperature = 0;
    [[nodiscard]] double sum() const { return film_a + film_b + oil; }
    [[nodiscard]] double side(bool side_b) const { return side_b ? film_b : film_a; }
};

double side_of(const InterfaceLaw& law, bool side_b) { return side_b ? law.film_b : law.film_a; }

// Adds the effect of more heat to the oil that reaches an interface [W].
void add_oil_heat(std::size_t interface, double heat, const LinearisedHeat& linearised, RateEffect& result)
{
    const auto place = linearised.inner().oil_of[interface];
    for (const auto& path : linearised.inner().oil) {
        if (!(path.flow > 0))
            continue;
        for (std::size_t k = 0; k < path.stops.size(); ++k)
            if (path.stops[k].place == place) {
                if (path.feed == OilPath::Feed::sump)
                    result.inner.emplace_back(path.stops.front().place, heat);
                if (k + 1 < path.stops.size())
                    result.inner.emplace_back(path.stops[k + 1].place, heat / path.flow);
            }
    }
}

/// The effects of a change of an interface's law.
class JointEffect {
public:
    JointEffect(std::size_t interface, JointScalar scalar, const LinearisedHeat& heat, const LinearisedState& at)
        : i_(interface), change_(scalar), heat_(heat), at_(at), law_(heat.joints().laws()[interface]),
          sum_(heat.joints().film_sum(interface)), area_(heat.joints().area(interface)),
          oil_temperature_(at.balance.oil_temperature[interface]),
          mean_a_(at.values[heat.geometry().layout.mean(interface, false)]),
          mean_b_(at.values[heat.geometry().layout.mean(interface, true)])
    {}
    RateEffect get()
    {
        add_sides();
        if (heat_.film_share(i_) > 0)
            add_heat();
        if (heat_.inner().oil_of[i_] >= 0)
            add_oil();
        return std::move(result_);
    }

private:
    [[nodiscard]] double share_change(double x, double dx) const { return (dx - x / sum_ * change_.sum()) / sum_; }

    void add_sides()
    {
        const auto& layout = heat_.geometry().layout;
        const double oil_change = change_.oil * oil_temperature_ + law_.oil * change_.oil_temperature;
        double heat = area_ * law_.oil * oil_temperature_, zoned = 0;
        if (const double share = heat_.film_share(i_); share > 0) {
            const auto r = static_cast<std::size_t>(law_.source);
            heat += share * at_.balance.source_heat[r];
            zoned = heat_.zoned_heat(i_) * heat_.problem().sources[r].share;
        }
        for (const bool side_b : {false, true}) {
            const double by_side = share_change(side_of(law_, side_b), change_.side(side_b));
            result_.watts.emplace_back(layout.mean(i_, side_b),
                                       heat * by_side + area_ * oil_change * side_of(law_, side_b) / sum_);
            if (zoned != 0)
                result_.watts.emplace_back(layout.zone(i_, side_b), zoned * by_side);
        }
    }

    // Adds the change of the source's heat at given temperatures of solids and oil.
    void add_heat()
    {
        const auto r = static_cast<std::size_t>(law_.source);
        const double share = heat_.film_share(i_);
        const double mean = (law_.film_a * mean_a_ + law_.film_b * mean_b_ + law_.oil * oil_temperature_) / sum_;
        const double mean_change = (change_.film_a * (mean_a_ - mean) + change_.film_b * (mean_b_ - mean) +
                                    change_.oil * (oil_temperature_ - mean) + law_.oil * change_.oil_temperature) /
                                   sum_;
        const double self_change = -share * share / (area_ * sum_ * sum_) * change_.sum();
        result_.inner.emplace_back(InnerLayout::heat(r),
                                   at_.balance.source_slope[r] *
                                       (share * mean_change + self_change * at_.balance.source_heat[r]));
    }

    void add_oil()
    {
        const double film = at_.balance.film[i_];
        const double film_change = (change_.film_a * (mean_a_ - film) + change_.film_b * (mean_b_ - film) +
                                    change_.oil * (oil_temperature_ - film)) /
                                   sum_;
        const double heat = area_ * (change_.oil * (film - oil_temperature_) + law_.oil * film_change);
        add_oil_heat(i_, heat, heat_, result_);
    }

    std::size_t i_;
    JointChange change_;
    const LinearisedHeat& heat_;
    const LinearisedState& at_;
    const InterfaceLaw& law_;
    double sum_, area_, oil_temperature_, mean_a_, mean_b_;
    RateEffect result_;
};

RateEffect effect_of_joint(std::size_t scalar, const LinearisedHeat& heat, const LinearisedState& at)
{
    const std::size_t interface = scalar / 4;
    const auto of = static_cast<JointScalar>(scalar % 4);
    if (of == JointScalar::oil_temperature && heat.inner().oil_of[interface] >= 0)
        return {};  // a circuit brings it
    return JointEffect(interface, of, heat, at).get();
}

const FilmState* following_film(std::size_t surface, const LinearisedHeat& heat, const LinearisedState& at,
                                const FollowingFilm*& places)
{
    const auto& films = heat.inner().films;
    for (std::size_t k = 0; k < films.size(); ++k)
        if (films[k].surface == surface) {
            places = &films[k];
            return &at.films[k];
        }
    return nullptr;
}

RateEffect effect_of_film(std::size_t surface, const LinearisedHeat& heat, const LinearisedState& at)
{
    const FollowingFilm* places = nullptr;
    if (const auto* film = following_film(surface, heat, at, places))
        return {{}, {{places->outside, film->outside}, {places->slope, film->own_slope}}};
    const auto& condition = heat.problem().surfaces[surface];
    if (condition.kind != SurfaceCondition::Kind::film || heat::follows_temperature(condition))
        return {};
    const std::size_t functional = heat.geometry().layout.surface(surface);
    RateEffect result{{{functional, at.faced[surface]}}, {}};
    if (condition.enclosure >= 0)
        result.inner.emplace_back(heat.inner().air(static_cast<std::size_t>(condition.enclosure)),
                                  at.values[functional] - at.faced[surface] * heat.geometry().surface_area[surface]);
    return result;
}

RateEffect effect_of_faced(std::size_t surface, const LinearisedHeat& heat, const LinearisedState& at)
{
    const auto& condition = heat.problem().surfaces[surface];
    if (condition.kind != SurfaceCondition::Kind::film || condition.enclosure >= 0)
        return {};
    const FollowingFilm* places = nullptr;
    if (const auto* film = following_film(surface, heat, at, places))
        return {{}, {{places->outside, film->by_faced}, {places->slope, film->slope_by_faced}}};
    return {{{heat.geometry().layout.surface(surface), condition.coefficient}}, {}};
}

RateEffect effect_on_film(std::size_t surface, bool is_slope, const LinearisedHeat& heat, const LinearisedState& at)
{
    const FollowingFilm* places = nullptr;
    if (!following_film(surface, heat, at, places))
        return {};
    return {{}, {{is_slope ? places->slope : places->outside, 1}}};
}

// Watts by load zone of a source per unit of `of_interface`.
template <class OfInterface>
void add_zones(std::size_t source, const LinearisedHeat& heat, const OfInterface& of_interface, RateEffect& result)
{
    const auto& layout = heat.geometry().layout;
    const auto& laws = heat.joints().laws();
    for (std::size_t i = 0; i < laws.size(); ++i) {
        if (laws[i].source != static_cast<int>(source) || !laws[i].load_zone)
            continue;
        const double watts = of_interface(i);
        if (laws[i].heat_part >= 0)
            result.watts.emplace_back(layout.zone(i, false), watts);
        else
            for (const bool side_b : {false, true})
                result.watts.emplace_back(layout.zone(i, side_b), watts * heat.joints().side_share(i, side_b));
    }
}

RateEffect effect_of_heat(std::size_t source, const LinearisedHeat& heat, const LinearisedState& at)
{
    if (!heat.laws().heat[source])
        return {};
    const double by_law = 1 + heat.self(source) * at.balance.source_slope[source];
    return {{}, {{InnerLayout::heat(source), heat.problem().sources[source].share * by_law}}};
}

RateEffect effect_of_share(std::size_t source, const LinearisedHeat& heat, const LinearisedState& at)
{
    RateEffect result;
    const double by_law = 1 + heat.self(source) * at.balance.source_slope[source];
    if (heat.laws().heat[source])
        result.inner.emplace_back(InnerLayout::heat(source), heat.heat_by_law(source, at) * by_law);
    add_zones(
        source, heat, [&](std::size_t i) { return heat.zoned_heat(i); }, result);
    return result;
}

RateEffect effect_of_zoned(std::size_t source, const LinearisedHeat& heat)
{
    RateEffect result;
    const double share = heat.problem().sources[source].share;
    add_zones(
        source, heat, [&](std::size_t i) { return share * heat.joints().heat_share(i); }, result);
    return result;
}

// Adds the effect of an interface's share of its source's heat alone, times a change of it.
void add_heat_share(std::size_t i, double change, const LinearisedHeat& heat, const LinearisedState& at,
                    RateEffect& result)
{
    const auto& law = heat.joints().laws()[i];
    const auto& layout = heat.geometry().layout;
    const auto r = static_cast<std::size_t>(law.source);
    const double source_heat = change * at.balance.source_heat[r];
    const double zoned = law.load_zone ? change * heat.problem().sources[r].share * heat.laws().zoned_heat[r] : 0;
    if (law.heat_part >= 0) {
        result.watts.emplace_back(layout.part(static_cast<std::size_t>(law.heat_part)), source_heat);
        result.watts.emplace_back(layout.zone(i, false), zoned);
        result.inner.emplace_back(InnerLayout::heat(r),
                                  at.balance.source_slope[r] * change *
                                      at.values[layout.part(static_cast<std::size_t>(law.heat_part))]);
        return;
    }
    const double sum = heat.joints().film_sum(i), area = heat.joints().area(i);
    double mean = law.oil / sum * at.balance.oil_temperature[i];
    for (const bool side_b : {false, true}) {
        const double share = heat.joints().side_share(i, side_b);
        mean += share * at.values[layout.mean(i, side_b)];
        result.watts.emplace_back(layout.mean(i, side_b), source_heat * share);
        result.watts.emplace_back(layout.zone(i, side_b), zoned * share);
    }
    const double self_change = 2 * heat.film_share(i) / (area * sum);
    result.inner.emplace_back(InnerLayout::heat(r),
                              at.balance.source_slope[r] * (change * mean + self_change * source_heat));
    if (heat.inner().oil_of[i] >= 0)
        add_oil_heat(i, law.oil / sum * source_heat, heat, result);
}

// The shares of all interfaces of a source, weight times area over their sum, change with one weight.
RateEffect effect_of_weight(std::size_t interface, const LinearisedHeat& heat, const LinearisedState& at)
{
    const auto& laws = heat.joints().laws();
    RateEffect result;
    if (laws[interface].source < 0)
        return result;
    double weighted_area = 0;
    for (std::size_t i = 0; i < laws.size(); ++i)
        if (laws[i].source == laws[interface].source)
            weighted_area += laws[i].heat_weight * heat.joints().area(i);
    const double change = heat.joints().area(interface) / weighted_area;
    for (std::size_t i = 0; i < laws.size(); ++i)
        if (laws[i].source == laws[interface].source)
            add_heat_share(i, change * ((i == interface ? 1 : 0) - heat.joints().heat_share(i)), heat, at, result);
    return result;
}

RateEffect effect_of_flow(std::size_t circuit, const LinearisedHeat& heat, const LinearisedState& at)
{
    RateEffect result;
    const auto& path = heat.inner().oil[circuit];
    for (std::size_t k = 1; k < path.stops.size() && path.flow > 0; ++k)
        result.inner.emplace_back(path.stops[k].place, -heat.oil_heat(path.stops[k - 1], at) / (path.flow * path.flow));
    return result;
}

RateEffect effect_of_inlet(std::size_t circuit, const LinearisedHeat& heat)
{
    const auto& path = heat.inner().oil[circuit];
    if (path.stops.empty() || path.feed != OilPath::Feed::cooler)
        return {};
    return {{}, {{path.stops.front().place, 1}}};
}

double sump_of(const OilPath& path, const LinearisedState& at)
{
    return at.balance.oil_temperature[path.stops.front().interfaces.front()];
}

RateEffect effect_of_sump_loss(std::size_t circuit, const LinearisedHeat& heat, const LinearisedState& at)
{
    const auto& path = heat.inner().oil[circuit];
    if (path.stops.empty() || path.feed != OilPath::Feed::sump)
        return {};
    return {{}, {{path.stops.front().place, at.ambient - sump_of(path, at)}}};
}

RateEffect effect_of_ambient(const LinearisedHeat& heat)
{
    RateEffect result;
    for (const auto& path : heat.inner().oil)
        if (!path.stops.empty() && path.feed == OilPath::Feed::sump)
            result.inner.emplace_back(path.stops.front().place, heat.problem().oil[path.circuit].sump_loss);
    for (std::size_t e = 0; e < heat.problem().enclosures.size(); ++e)
        result.inner.emplace_back(heat.inner().air(e), heat.problem().enclosures[e].exchange);
    return result;
}

}  // namespace

RateEffect effect_of(std::size_t scalar, const LinearisedHeat& heat, const LinearisedState& at)
{
    const ScalarLayout layout(heat.problem());
    const auto& functionals = heat.geometry().layout;
    if (scalar < layout.film(0))
        return effect_of_joint(scalar, heat, at);
    if (scalar < layout.faced(0))
        return effect_of_film(scalar - layout.film(0), heat, at);
    if (scalar < layout.flux(0))
        return effect_of_faced(scalar - layout.faced(0), heat, at);
    if (scalar < layout.lost(0))
        return {{{functionals.surface(scalar - layout.flux(0)), 1}}, {}};
    if (scalar < layout.slope(0))
        return effect_on_film(scalar - layout.lost(0), false, heat, at);
    if (scalar < layout.share(0))
        return effect_on_film(scalar - layout.slope(0), true, heat, at);
    if (scalar < layout.heat(0))
        return effect_of_share(scalar - layout.share(0), heat, at);
    if (scalar < layout.zoned(0))
        return effect_of_heat(scalar - layout.heat(0), heat, at);
    if (scalar < layout.body(0))
        return effect_of_zoned(scalar - layout.zoned(0), heat);
    if (scalar < layout.flow(0))
        return {{{functionals.body(scalar - layout.body(0)), 1}}, {}};
    if (scalar < layout.inlet(0))
        return effect_of_flow(scalar - layout.flow(0), heat, at);
    if (scalar < layout.sump_loss(0))
        return effect_of_inlet(scalar - layout.inlet(0), heat);
    if (scalar < layout.exchange(0))
        return effect_of_sump_loss(scalar - layout.sump_loss(0), heat, at);
    if (scalar < layout.power(0)) {
        const auto e = scalar - layout.exchange(0);
        return {{}, {{heat.inner().air(e), at.ambient - at.balance.air[e].temperature}}};
    }
    if (scalar < layout.ambient())
        return {{}, {{heat.inner().air(scalar - layout.power(0)), 1}}};
    if (scalar < layout.weight(0))
        return effect_of_ambient(heat);
    return effect_of_weight(scalar - layout.weight(0), heat, at);
}

std::vector<std::pair<std::size_t, double>> term_changes(std::size_t scalar, const LinearisedHeat& heat)
{
    const ScalarLayout layout(heat.problem());
    const auto& prepared = heat.prepared();
    std::vector<std::pair<std::size_t, double>> result;
    const auto add = [&](std::size_t term, double change) {
        if (change != 0 && !prepared.each[term].term().is_missing())
            result.emplace_back(term, change);
    };
    if (scalar < layout.film(0)) {
        const std::size_t i = scalar / 4;
        const auto& law = heat.joints().laws()[i];
        const JointChange change(static_cast<JointScalar>(scalar % 4));
        const double sum = heat.joints().film_sum(i);
        const auto share_change = [&](double x, double dx) { return (dx - x / sum * change.sum()) / sum; };
        for (const bool side_b : {false, true})
            add(4 * i + (side_b ? 1 : 0),
                change.side(side_b) * law.oil / sum + side_of(law, side_b) * share_change(law.oil, change.oil));
        add(4 * i + (law.turns_fully ? 3 : 2),
            change.film_a * law.film_b / sum + law.film_a * share_change(law.film_b, change.film_b));
    } else if (scalar < layout.faced(0)) {
        const std::size_t s = scalar - layout.film(0);
        if (heat.problem().surfaces[s].kind == SurfaceCondition::Kind::film &&
            !heat::follows_temperature(heat.problem().surfaces[s]))
            add(4 * prepared.terms.joints.size() + s, 1);
    }
    return result;
}

}  // namespace deadpoint::reduce
