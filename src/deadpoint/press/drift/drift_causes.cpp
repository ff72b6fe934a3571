#include "deadpoint/press/drift/drift_causes.hpp"

#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/exchange/drift.hpp"
#include "deadpoint/exchange/heat_causes.hpp"

#include <algorithm>
#include <cmath>

namespace deadpoint::press {
namespace {

// Below, the backward run takes some seconds.
constexpr long long many_temperatures = 100'000;

using NamedHeat = std::vector<std::pair<std::string, double>>;

NamedHeat by_joint(const casefile::Case& input, const HeatProblem& problem, const std::vector<double>& friction)
{
    NamedHeat result;
    std::size_t contact = 0;
    for (const auto& [name, joint] : input.joints) {
        double sum = 0;
        bool rubs = false;
        for (std::size_t i = 0; i < joint.interfaces.size(); ++i, ++contact) {
            sum += friction[contact];
            rubs = rubs || problem.interfaces[contact].source >= 0;
        }
        if (rubs)
            result.emplace_back(name, sum);
    }
    return result;
}

double sum_of(const NamedHeat& values)
{
    double sum = 0;
    for (const auto& [name, value] : values)
        sum += value;
    return sum;
}

DriftCauses at_row(const casefile::Case& input, const HeatProblem& problem, const DriftSeries& drift, std::size_t row,
                   const HeatCauses& found)
{
    DriftCauses causes;
    causes.time = drift.time[row];
    causes.gap = drift.gap.value[row];
    causes.joints = by_joint(input, problem, found.friction);
    for (std::size_t k = 0; k < problem.body_heat.size(); ++k)
        causes.heat_sources.emplace_back(problem.body_heat[k].name, found.body_heat[k]);
    for (std::size_t i = 0; i < problem.surfaces.size(); ++i) {
        const auto& condition = problem.surfaces[i];
        if (condition.kind == SurfaceCondition::Kind::film)
            causes.air += found.surfaces[i];
        else
            causes.surfaces.emplace_back(condition.name, found.surfaces[i]);
    }
    for (const double value : found.oil)
        causes.oil += value;
    causes.start = found.start;
    causes.fields = found.fields;
    causes.change = found.change;
    causes.remainder = causes.gap - sum_of(causes.joints) - sum_of(causes.heat_sources) - sum_of(causes.surfaces) -
                       causes.oil - causes.air - causes.start;
    return causes;
}

}  // namespace

std::vector<DriftCauses> drift_causes(const casefile::Case& input, const HeatProblem& problem, const DriftSeries& drift,
                                      const std::function<HeatCauses(std::size_t row)>& causes_at)
{
    const auto& values = drift.gap.value;
    const auto largest = std::ranges::max_element(values, {}, [](double value) { return std::abs(value); });
    std::vector<std::size_t> rows{values.size() - 1};
    if (drift.time[static_cast<std::size_t>(largest - values.begin())] < drift.time.back())
        rows.insert(rows.begin(), static_cast<std::size_t>(largest - values.begin()));
    std::vector<DriftCauses> result;
    for (const auto row : rows)
        result.push_back(at_row(input, problem, drift, row, causes_at(row)));
    return result;
}

bool causes_on_basis(const casefile::Output& output, long long temperatures)
{
    using By = casefile::Output::CausesBy;
    return output.causes_by == By::basis || (output.causes_by == By::size && temperatures >= many_temperatures);
}

}  // namespace deadpoint::press
