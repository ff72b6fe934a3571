#include "deadpoint/full/refine/estimate.hpp"

#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/drift/play.hpp"
#include "deadpoint/exchange/heat.hpp"
#include "deadpoint/fem/model.hpp"
#include "deadpoint/full/frame/chain_on_mesh.hpp"
#include "deadpoint/full/run/run.hpp"
#include "deadpoint/press/drift/chain_model.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

namespace deadpoint::full {
namespace {

constexpr std::size_t most_times = 6;

void take(const std::vector<double>& errors, ErrorEstimate& estimate)
{
    double total = 0;
    for (std::size_t p = 0; p < errors.size(); ++p) {
        total += std::abs(errors[p]);
        estimate.by_part[p] = std::max(estimate.by_part[p], std::abs(errors[p]));
    }
    estimate.total = std::max(estimate.total, total);
}

// By which the gap follows the growth of each crank bearing's play at a time.
std::vector<double> play_slopes(const RunContext& run, const fem::Field& field)
{
    std::vector<double> slopes;
    for (const double growth : play_growths(*run.chain, run.model, run.adjoints, field, run.reference))
        slopes.push_back(run.play.slope(growth));
    return slopes;
}

}  // namespace

std::vector<double> estimate_times(const casefile::Case& input)
{
    const double end = std::accumulate(input.operation.begin(), input.operation.end(), 0.0,
                                       [](double sum, const auto& segment) { return sum + segment.duration; });
    std::set<double> times{end / 8, end / 2, end};
    double time = 0;
    for (const auto& segment : input.operation)
        if (times.size() < most_times && (time += segment.duration) < end * (1 - 1e-9))
            times.insert(time);
    return {times.begin(), times.end()};
}

ErrorEstimate estimate_error(const RunContext& run, casefile::Accuracy::Of of)
{
    ErrorEstimate estimate;
    estimate.by_part.assign(run.machine.parts.size(), 0.0);
    const bool gap = of == casefile::Accuracy::Of::gap;
    std::vector<fem::Adjoint> weights;
    std::vector<fem::Displacement> shape;
    if (!gap)
        for (const auto& probe : run.problem.probes)
            weights.push_back(run.model.probe_weights(probe));
    std::vector<double> slopes;
    for (const auto& [time, field] : run.fields) {
        if (gap)
            if (auto now = play_slopes(run, field); shape.empty() || now != slopes) {
                slopes = std::move(now);
                weights = {gap_adjoint(*run.chain, run.adjoints, slopes)};
                shape = {run.model.deformation_adjoint(press::gap_functional(*run.chain, slopes))};
            }
        auto errors = run.model.conduction_errors(field, run.model.heat_adjoints(run.problem, time, field, weights));
        if (gap) {
            const auto bent = run.model.deformation_errors(run.model.displacement(field, run.reference), shape);
            std::ranges::transform(errors[0], bent[0], errors[0].begin(), std::plus<>());
        } else {
            const auto within = run.model.interpolation_errors(field, run.problem.probes);
            for (std::size_t k = 0; k < within.size(); ++k)
                errors[k][static_cast<std::size_t>(run.problem.probes[k].part)] += within[k];
        }
        for (const auto& of_one : errors)
            take(of_one, estimate);
    }
    return estimate;
}

}  // namespace deadpoint::full
