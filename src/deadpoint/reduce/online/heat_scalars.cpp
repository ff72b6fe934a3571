#include "deadpoint/reduce/online/heat_scalars.hpp"

#include "deadpoint/exchange/heat.hpp"

#include <numeric>

namespace deadpoint::reduce {
namespace {

const std::vector<InterfaceLaw>& laws_of(const HeatProblem& problem, std::size_t segment)
{
    const auto& own = problem.segments[segment].interfaces;
    return own.empty() ? problem.interfaces : own;
}

double surroundings_of(const HeatProblem& problem, std::size_t surface, std::size_t segment, double time)
{
    const auto& condition = problem.surfaces[surface];
    if (condition.kind != SurfaceCondition::Kind::film)
        return 0;
    return condition.ambient ? condition.ambient(time) : problem.segments[segment].ambient(time);
}

double dot(const std::vector<double>& a, const std::vector<double>& b)
{
    return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

double dot(const JointScalars& a, const JointScalars& b)
{
    return a.film_a * b.film_a + a.film_b * b.film_b + a.oil * b.oil + a.oil_temperature * b.oil_temperature;
}

}  // namespace

double dot(const HeatScalars& a, const HeatScalars& b)
{
    double sum = dot(a.films, b.films) + dot(a.surroundings, b.surroundings) + dot(a.shares, b.shares);
    for (std::size_t i = 0; i < a.joints.size(); ++i)
        sum += dot(a.joints[i], b.joints[i]);
    return sum;
}

HeatScalars change_per(double by, const HeatProblem& problem, const HeatProblem& changed, std::size_t segment,
                       double time)
{
    HeatScalars result;
    const auto &from = laws_of(problem, segment), &to = laws_of(changed, segment);
    for (std::size_t i = 0; i < from.size(); ++i)
        result.joints.push_back({(to[i].film_a - from[i].film_a) / by, (to[i].film_b - from[i].film_b) / by,
                                 (to[i].oil - from[i].oil) / by,
                                 (to[i].oil_temperature - from[i].oil_temperature) / by});
    for (std::size_t s = 0; s < problem.surfaces.size(); ++s) {
        result.films.push_back((changed.surfaces[s].coefficient - problem.surfaces[s].coefficient) / by);
        result.surroundings.push_back(
            (surroundings_of(changed, s, segment, time) - surroundings_of(problem, s, segment, time)) / by);
    }
    for (std::size_t r = 0; r < problem.sources.size(); ++r)
        result.shares.push_back((changed.sources[r].share - problem.sources[r].share) / by);
    return result;
}

}  // namespace deadpoint::reduce
