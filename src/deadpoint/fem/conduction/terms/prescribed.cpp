#include "deadpoint/fem/conduction/terms/prescribed.hpp"

#include "deadpoint/exchange/face_points.hpp"
#include "deadpoint/exchange/heat.hpp"
#include "deadpoint/exchange/machine.hpp"
#include "deadpoint/fem/algebra/vectors.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace deadpoint::fem {
namespace {

bool is_prescribed(const SurfaceCondition& condition) { return condition.kind == SurfaceCondition::Kind::temperature; }

}  // namespace

PrescribedTemperatures::PrescribedTemperatures(const Discretisation& space, const HeatProblem& problem)
    : space_(space), problem_(&problem), some_(std::ranges::any_of(problem.surfaces, is_prescribed))
{
    if (some_)
        find();
}

void PrescribedTemperatures::find()
{
    std::map<PetscInt, Place> found;
    PointShape shape;
    for (std::size_t s = 0; s < problem_->surfaces.size(); ++s) {
        if (!is_prescribed(problem_->surfaces[s]))
            continue;
        for (const auto& [index, fraction, central] : faces_of(space_.machine, problem_->surfaces[s])) {
            if (!central)
                continue;
            const auto cell = space_.machine.faces[index].cell;
            for (const auto& point : face_points(space_.machine, space_.machine.faces[index])) {
                space_.evaluate(index, point.position, false, shape);
                for (int i = 0; i < shape.count; ++i)
                    if (space_.owns(shape.dof[i]) && std::abs(shape.value[i]) > 1e-9)
                        found[shape.dof[i]] = {space_.node_position(cell, static_cast<unsigned>(i)), s};
            }
        }
    }
    for (const auto& [dof, place] : found) {
        unknowns_.push_back(dof);
        places_.push_back(place);
    }
}

void PrescribedTemperatures::impose(double time, Vec temperature) const
{
    if (!some_)
        return;
    Entries values(temperature);
    for (std::size_t i = 0; i < unknowns_.size(); ++i)
        values[unknowns_[i] - space_.first] =
            problem_->surfaces[places_[i].surface].temperature(places_[i].position, time);
}

void PrescribedTemperatures::clear(Vec vector) const
{
    if (!some_)
        return;
    Entries values(vector);
    for (const PetscInt row : unknowns_)
        values[row - space_.first] = 0;
}

SparseFunctional PrescribedTemperatures::without(SparseFunctional functional) const
{
    for (std::size_t i = 0; i < functional.local.size(); ++i)
        if (std::ranges::binary_search(unknowns_, space_.first + functional.local[i]))
            functional.weight[i] = 0;
    return functional;
}

double PrescribedTemperatures::total(Vec vector) const
{
    std::vector<double> sum(1, 0.0);
    {
        const ConstEntries values(vector);
        for (const PetscInt row : unknowns_)
            sum[0] += values[row - space_.first];
    }
    sum_over_ranks(sum);
    return sum[0];
}

std::vector<double> PrescribedTemperatures::shares(Vec right, Vec left, double time, double reference) const
{
    std::vector<double> sums(problem_->surfaces.size(), 0.0);
    {
        const ConstEntries of_right(right), of_left(left);
        for (std::size_t i = 0; i < unknowns_.size(); ++i) {
            const auto at = unknowns_[i] - space_.first;
            const auto& [position, surface] = places_[i];
            sums[surface] +=
                (of_right[at] - of_left[at]) * (problem_->surfaces[surface].temperature(position, time) - reference);
        }
    }
    sum_over_ranks(sums);
    return sums;
}

std::vector<double> PrescribedTemperatures::start_shares(Vec weights, Vec start, double reference) const
{
    const std::size_t surfaces = problem_->surfaces.size();
    std::vector<double> sums(surfaces + 1, 0.0);
    {
        const ConstEntries weight(weights), temperature(start);
        for (PetscInt i = 0; i < space_.last - space_.first; ++i) {
            const auto found = std::ranges::lower_bound(unknowns_, space_.first + i);
            const bool given = found != unknowns_.end() && *found == space_.first + i;
            const auto at = given ? places_[static_cast<std::size_t>(found - unknowns_.begin())].surface : surfaces;
            sums[at] += weight[i] * (temperature[i] - reference);
        }
    }
    sum_over_ranks(sums);
    return sums;
}

}  // namespace deadpoint::fem
