#include "deadpoint/mechanism/bottom_dead_point.hpp"

#include "deadpoint/core/units.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/mechanism/planar_system.hpp"
#include "deadpoint/mechanism/slide_motion.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <optional>
#include <vector>

namespace deadpoint::mechanism {
namespace {

constexpr int steps = 180;
constexpr double same_height = 1e-12;  // [m]

std::vector<PlanarPosition> scan(const PlanarSystem& system)
{
    std::vector<PlanarPosition> positions{system.position(system.assembled())};
    for (int i = 1; i <= steps; ++i)
        positions.push_back(system.moved(positions.back(), i * full_turn / steps));

    const Linkage& linkage = system.linkage();
    for (std::size_t body = 0; body < linkage.bodies.size(); ++body) {
        const PlanarPose& end = positions.back().poses[body];
        if (norm(end.translation) > 1e-6 || std::abs(std::remainder(end.angle, full_turn)) > 1e-6)
            throw InputError(
                fmt::format("after one turn of the driver '{}' is not where it was: the linkage changed its way "
                            "of closing\n  help: check its lengths",
                            linkage.bodies[body]));
    }
    return positions;
}

double from_assembled(const PlanarPosition& position) { return std::abs(std::remainder(position.angle, full_turn)); }

PlanarPosition lowest(const SlideMotion& slide, const std::vector<PlanarPosition>& positions)
{
    std::vector<double> heights;
    for (const PlanarPosition& position : positions)
        heights.push_back(slide.height(position));
    heights.back() = heights.front();  // the same position, so rounding must make no difference
    const auto [bottom, top] = std::minmax_element(heights.begin(), heights.end());
    const Linkage& linkage = slide.system().linkage();
    if (!(*top - *bottom > 1e-9))
        throw InputError(fmt::format("the slide '{}' does not move along the stroke when '{}' turns\n  help: check "
                                     "mechanism.slide_body and mechanism.stroke_direction",
                                     linkage.bodies[linkage.slide_body], linkage.joints[linkage.driver].name));
    std::optional<PlanarPosition> best;
    for (int i = 0; i < steps; ++i) {
        if (heights[i] > heights[i == 0 ? steps - 1 : i - 1] || heights[i] >= heights[i + 1])
            continue;
        PlanarPosition low = slide.extremum(SlideMotion::Extremum::lowest, positions[i], full_turn / steps);
        const double above = best ? slide.height(low) - slide.height(*best) : -1.0;
        const bool same = std::abs(above) < same_height;
        if (same ? from_assembled(low) < from_assembled(*best) : above < 0)
            best = std::move(low);
    }
    return *best;  // the slide moves, so a lowest position exists
}

/// The same position, reached by turning the driver the shorter way.
void turn_back(PlanarPosition& position, const PlanarPosition& whole_turn)
{
    if (position.angle <= full_turn / 2)
        return;
    position.angle -= full_turn;
    for (std::size_t body = 0; body < position.poses.size(); ++body)
        position.poses[body].angle -= full_turn * std::round(whole_turn.poses[body].angle / full_turn);
}

}  // namespace

BottomDeadPointSensitivity bottom_dead_point(const Linkage& linkage)
{
    const PlanarSystem system(linkage);
    const std::vector<PlanarPosition> positions = scan(system);
    PlanarPosition bottom = lowest(SlideMotion(system), positions);
    turn_back(bottom, positions.back());

    BottomDeadPointSensitivity result;
    result.crank_angle = bottom.angle;
    for (int joint = 0; joint < static_cast<int>(linkage.joints.size()); ++joint)
        result.joint_centres.push_back(system.joint_centre(joint, bottom.poses));
    result.weight = system.slide_weights(bottom.poses);
    result.poses = std::move(bottom.poses);
    return result;
}

std::vector<LengthSensitivity> length_sensitivities(const Linkage& linkage, const BottomDeadPointSensitivity& bottom)
{
    const int joints = static_cast<int>(linkage.joints.size());
    std::vector<LengthSensitivity> result;
    for (int body = 0; body < static_cast<int>(linkage.bodies.size()); ++body) {
        std::vector<int> touching;
        for (int j = 0; j < joints; ++j)
            if (linkage.joints[j].body_a == body || linkage.joints[j].body_b == body)
                touching.push_back(j);
        const bool order_matters = body == linkage.ground || touching.size() > 2;
        for (const int from : touching) {
            for (const int to : touching) {
                const Vec2 line = bottom.joint_centres[to] - bottom.joint_centres[from];
                const double length = norm(line);
                if (from == to || (to < from && !order_matters) || !(length > 1e-9))
                    continue;
                const double along = dot(bottom.weight[to], (1 / length) * line);
                result.push_back({linkage.bodies[body], linkage.joints[from].name, linkage.joints[to].name, length,
                                  linkage.joints[to].body_b == body ? along : -along});
            }
        }
    }
    return result;
}

}  // namespace deadpoint::mechanism
