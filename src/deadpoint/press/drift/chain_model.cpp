#include "deadpoint/press/drift/chain_model.hpp"

#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/core/mistakes.hpp"
#include "deadpoint/mechanism/bottom_dead_point.hpp"
#include "deadpoint/press/drift/chain_series.hpp"
#include "deadpoint/press/translate/linkage.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace deadpoint::press {
namespace {

void require_bottom(const Linkage& linkage, const BottomDeadPointSensitivity& sensitivity, Mistakes& mistakes)
{
    constexpr double largest = 1e-3;  // [rad]
    if (std::abs(sensitivity.crank_angle) > largest)
        mistakes.add("joints." + linkage.joints[static_cast<std::size_t>(linkage.driver)].name,
                     fmt::format("the case's joints are not placed at bottom dead point: the crank would have to turn "
                                 "by {:.3f} degrees to get there",
                                 sensitivity.crank_angle * 180 / std::numbers::pi),
                     "give all coordinates at bottom dead point; if they are, correct machine.gravity_direction or "
                     "mechanism.stroke_direction, which tell on which side the table is");
}

}  // namespace

ChainModel::ChainModel(const casefile::Case& input, const Machine& machine)
    : linkage(describe_linkage(input)), system(linkage),
      sensitivity(about("joints", [&] { return mechanism::bottom_dead_point(linkage); }))
{
    Mistakes mistakes;
    require_bottom(linkage, sensitivity, mistakes);
    mistakes.attempt("chain", [&] { description = describe_chain(input, machine, linkage); });
    mistakes.raise();
    dimensions = drift::chain_functionals(machine, linkage, sensitivity, description);
    for (int j = 0; j < static_cast<int>(linkage.joints.size()); ++j)
        mistakes.attempt("joints." + linkage.joints[static_cast<std::size_t>(j)].name, [&] {
            const auto fitted = drift::joint_centres(machine, linkage, sensitivity, j, description.joints[j]);
            for (const auto& centre : {fitted.in_a, fitted.in_b})
                for (const auto& component : centre)
                    centres.push_back(component);
        });
    mistakes.raise();
    travel_by_play = drift::travel_by_play(linkage, sensitivity, description);
}

ChainFigures ChainModel::figures() const
{
    return {bearings(), travel_by_play, dot(description.pressed, linkage.stroke_direction)};
}

double ChainModel::play_travel(const std::vector<double>& shares, const std::vector<double>& growths) const
{
    return travel_by_play * mean_play(shares, growths);
}

double mean_play(const std::vector<double>& shares, const std::vector<double>& growths)
{
    double sum = 0;
    for (std::size_t b = 0; b < shares.size(); ++b)
        sum += shares[b] * growths[b];
    return shares.empty() ? 0 : sum / static_cast<double>(shares.size());
}

Functional gap_functional(const ChainModel& chain, const std::vector<double>& shares)
{
    Functional result = chain.dimensions[drift::gap];
    const auto factors = play_factors(chain.figures(), shares);
    for (std::size_t b = 0; b < factors.size(); ++b)
        drift::add(result, factors[b], chain.dimensions[drift::dimension_count + b]);
    result.name = "E_SW";
    return result;
}

}  // namespace deadpoint::press
