#include "deadpoint/reduce/sensitivity/direction.hpp"

#include "deadpoint/heat/films.hpp"
#include "deadpoint/reduce/online/box.hpp"

#include <utility>

namespace deadpoint::reduce {
namespace {

std::vector<ScalarChanges> all_lasting(const HeatProblem& less, const HeatProblem& more, double by)
{
    std::vector<ScalarChanges> result;
    for (std::size_t k = 0; k < less.segments.size(); ++k)
        result.push_back(lasting_changes(less, more, by, k));
    return result;
}

// All that is not read by lasting_changes() left out, for cheap copies.
HeatProblem lasting_part(HeatProblem problem)
{
    for (auto& segment : problem.segments) {
        segment.heat.clear();
        segment.ring_heat.clear();
    }
    return problem;
}

const std::vector<InterfaceLaw>& laws_in(const HeatProblem& problem, std::size_t segment)
{
    const auto& own = problem.segments[segment].interfaces;
    return own.empty() ? problem.interfaces : own;
}

// Scalar of one member of a coefficient, and its change per relative change of the coefficient.
std::pair<std::size_t, double> relative_change(const HeatProblem& problem, std::size_t segment,
                                               FreeCoefficient::Kind kind, std::size_t member)
{
    const ScalarLayout layout(problem);
    const auto& laws = laws_in(problem, segment);
    switch (kind) {
    case FreeCoefficient::Kind::film: {
        const auto& surface = problem.surfaces[member];
        return {layout.film(member), heat::follows_temperature(surface) ? 1 : surface.coefficient};
    }
    case FreeCoefficient::Kind::side: {
        const bool side_b = member % 2 == 1;
        const auto& law = laws[member / 2];
        return {layout.joint(member / 2, side_b ? JointScalar::film_b : JointScalar::film_a),
                side_b ? law.film_b : law.film_a};
    }
    case FreeCoefficient::Kind::oil:
        return {layout.joint(member, JointScalar::oil), laws[member].oil > 0 ? laws[member].oil : 1};
    default:
        return {layout.share(member), problem.sources[member].share};
    }
}

ScalarChanges relative_changes(const HeatProblem& problem, std::size_t segment, const FreeCoefficient& coefficient)
{
    const ScalarLayout layout(problem);
    ScalarChanges result;
    if (coefficient.kind == FreeCoefficient::Kind::ambient) {
        result.emplace_back(layout.ambient(), 1);
        for (std::size_t s = 0; s < layout.surfaces; ++s)
            result.emplace_back(layout.faced(s), 1);
    } else if (coefficient.kind == FreeCoefficient::Kind::oil_temperature) {
        for (std::size_t i = 0; i < layout.interfaces; ++i)
            result.emplace_back(layout.joint(i, JointScalar::oil_temperature), 1);
        for (std::size_t k = 0; k < layout.circuits; ++k)
            result.emplace_back(layout.inlet(k), 1);
    } else {
        for (const auto member : coefficient.members)
            result.push_back(relative_change(problem, segment, coefficient.kind, member));
    }
    return result;
}

}  // namespace

Direction direction_between(HeatProblem less, HeatProblem more, double by)
{
    auto lasting = all_lasting(less, more, by);
    return {std::move(lasting), std::make_shared<const ProblemPair>(ProblemPair{std::move(less), std::move(more), by})};
}

std::vector<Direction> directions(const HeatProblem& problem, const Box& box, const std::vector<double>& values)
{
    std::vector<Direction> result;
    auto less = problem;
    set_values(less, box, values);
    const auto cheap = lasting_part(problem);
    auto cheap_less = cheap;
    set_values(cheap_less, box, values);
    for (std::size_t k = 0; k < box.size(); ++k) {
        auto shifted = values;
        shifted[k] += 1;
        const bool passes = box[k].kind == FreeCoefficient::Kind::ambient;
        auto more = passes ? problem : cheap;
        set_values(more, box, shifted);
        if (passes)
            result.push_back(direction_between(less, std::move(more), 1));
        else
            result.push_back({all_lasting(cheap_less, more, 1), nullptr});
    }
    return result;
}

Direction relative_direction(const HeatProblem& problem, const FreeCoefficient& coefficient)
{
    Direction result;
    for (std::size_t segment = 0; segment < problem.segments.size(); ++segment)
        result.lasting.push_back(relative_changes(problem, segment, coefficient));
    return result;
}

}  // namespace deadpoint::reduce
