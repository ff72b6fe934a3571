#include "deadpoint/reduce/sensitivity/direction.hpp"

#include "deadpoint/reduce/offline/box.hpp"

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

}  // namespace deadpoint::reduce
