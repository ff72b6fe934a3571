#include "deadpoint/press/drift/crank_play.hpp"

#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/casefile/describe/case_friction.hpp"
#include "deadpoint/core/units.hpp"
#include "deadpoint/drift/chain.hpp"
#include "deadpoint/drift/play.hpp"
#include "deadpoint/exchange/heat.hpp"
#include "deadpoint/exchange/laws/friction.hpp"
#include "deadpoint/press/drift/chain_figures.hpp"
#include "deadpoint/press/drift/chain_series.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace deadpoint::press {
namespace {

const casefile::Joint& crank_joint(const casefile::Case& input) { return input.joints.at(input.chain->crank_joint); }

bool is_stated(const casefile::Case& input) { return input.chain->bearing_play || crank_joint(input).clearance; }

bool is_rolling(const casefile::FrictionLaw& law)
{
    const auto* calibrated = std::get_if<casefile::CalibratedFriction>(&law);
    return std::holds_alternative<casefile::PalmgrenFriction>(law) ||
           std::holds_alternative<casefile::SkfFriction>(law) ||
           (calibrated && calibrated->kind == FrictionKind::rolling);
}

// By its elements; a joint without any by the law of its friction.
bool is_rolling(const casefile::Case& input)
{
    const auto& joint = crank_joint(input);
    if (!joint.elements.empty())
        return std::ranges::any_of(
            joint.elements, [](const auto& element) { return element.type == casefile::JointElement::Type::rolling; });
    const auto row = input.friction.find(joint.friction);
    return row != input.friction.end() && is_rolling(row->second.law);
}

double mean_of(const std::vector<double>& values)
{
    double sum = 0;
    for (const double value : values)
        sum += value / static_cast<double>(values.size());
    return sum;
}

// Mean growth of the bearings' play at the time of its largest magnitude [m].
double largest_growth(const ChainFigures& chain, const ThermalHistory& history)
{
    double largest = 0;
    for (std::size_t row = 0; row < history.time.size(); ++row) {
        const double growth = mean_of(play_growths(chain, history, row));
        largest = std::abs(growth) > std::abs(largest) ? growth : largest;
    }
    return largest;
}

}  // namespace

drift::BearingPlay crank_play(const casefile::Case& input)
{
    using enum drift::BearingPlay::Kind;
    using Play = casefile::Chain::Play;
    const auto& stated = input.chain->bearing_play;
    const auto& clearance = crank_joint(input).clearance;
    if (stated == Play::none)
        return {none, 0};
    if (stated == Play::paper)
        return {whole, 0};
    if (clearance)
        return {limited, 0.5 * *clearance};
    return {is_rolling(input) ? none : whole, 0};
}

std::optional<std::string> play_warning(const casefile::Case& input, const ChainFigures& chain,
                                        const ThermalHistory& history)
{
    constexpr double shown = 1e-9;  // [m]
    const double growth = largest_growth(chain, history);
    const double effect = chain.travel_by_play * growth;
    if (is_stated(input) || std::abs(effect) < shown)
        return std::nullopt;
    const bool taken = crank_play(input).kind != drift::BearingPlay::Kind::none;
    return fmt::format(
        "the play of the bearings of '{}' is not stated, and heat changes it by up to {:+.1f} um on the radius: {} "
        "{:+.2f} um\n  help: state joints.{}.clearance, their play on the diameter at the start, or chain.bearing_play "
        "= \"none\" (preloaded) or \"paper\" (all of the change counts)",
        input.chain->crank_joint, micrometre * growth,
        taken ? "all of it counts, although a bearing can close no further than its play; the effect on E_SW is up to"
              : "rolling bearings are assumed to have no play, so none of it counts; with enough play E_SW would "
                "change by up to",
        micrometre * effect, input.chain->crank_joint);
}

}  // namespace deadpoint::press
