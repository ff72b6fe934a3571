#include "deadpoint/press/laws/load_zone.hpp"

#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/core/mistakes.hpp"
#include "deadpoint/core/units.hpp"
#include "deadpoint/exchange/linkage.hpp"
#include "deadpoint/press/result/loads_result.hpp"
#include "deadpoint/tribology/friction/duty.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace deadpoint::press {
namespace {

constexpr std::size_t directions = 360;

using Spectrum = std::array<double, directions>;  ///< share of the load heat per direction, in whole degrees

void add(Spectrum& spectrum, const std::vector<Vec2>& force, const tribology::Duty& duty, double sign)
{
    for (std::size_t i = 0; i < force.size(); ++i) {
        const double heat = duty.weight[i] * std::pow(duty.force[i], tribology::rolling_load_exponent) * duty.speed[i];
        const double angle = std::atan2(sign * force[i][1], sign * force[i][0]);
        const auto place =
            static_cast<std::size_t>(std::lround((angle < 0 ? angle + full_turn : angle) / full_turn * directions));
        spectrum[place % directions] += heat;
    }
}

Spectrum direction_spectrum(const casefile::Case& input, const std::string& name, const LoadsResult& loads)
{
    Spectrum spectrum{};
    const auto found = std::ranges::find(loads.linkage.joints, name, &LinkageJoint::name);
    if (found == loads.linkage.joints.end())
        throw mistake("joints." + name, "a load zone needs the joint in the linkage");
    const auto j = static_cast<std::size_t>(found - loads.linkage.joints.begin());
    if (input.joints.at(name).driver && loads.crankshaft) {
        for (const auto& bearing : loads.crankshaft->cycle().bearings)
            add(spectrum, bearing.force, tribology::duty_of(bearing, loads.speed), 1);
        return spectrum;
    }
    const auto& cycle = loads.history.joints[j];
    const bool ground_is_a = found->body_a == loads.linkage.ground;
    add(spectrum, cycle.force, tribology::duty_of(loads.history, cycle), ground_is_a ? 1 : -1);
    return spectrum;
}

double pressed(double angle)
{
    const double c = std::cos(angle);
    return c > 0 ? c * c : 0;
}

}  // namespace

std::function<double(const Vec3&)> load_zone(const casefile::Case& input, const std::string& joint,
                                             const LoadsResult& loads)
{
    const auto spectrum = direction_spectrum(input, joint, loads);
    double whole = 0;
    for (const double share : spectrum)
        whole += share;
    if (!(whole > 0))
        throw mistake("joints." + joint, "it carries no load, so its heat has no load zone",
                      "remove `load_zone`, or state the loads");
    // The mean of the squared cosine over its half ring is a quarter of the circumference.
    std::array<double, directions> density{};
    for (std::size_t at = 0; at < directions; ++at)
        for (std::size_t from = 0; from < directions; ++from)
            density[at] += 4 * spectrum[from] / whole *
                           pressed(full_turn * (static_cast<double>(at) - static_cast<double>(from)) / directions);
    const Vec2 centre = input.joints.at(joint).centre;
    return [density, centre](const Vec3& position) {
        const double angle = std::atan2(position[1] - centre[1], position[0] - centre[0]);
        const double place = (angle < 0 ? angle + full_turn : angle) / full_turn * directions;
        const auto below = static_cast<std::size_t>(place);
        const double part = place - static_cast<double>(below);
        return (1 - part) * density[below % directions] + part * density[(below + 1) % directions];
    };
}

}  // namespace deadpoint::press
