#include "deadpoint/mechanism/bottom_dead_point.hpp"

#include "deadpoint/core/error.hpp"
#include "deadpoint/mechanism/planar_system.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>
#include <vector>

namespace deadpoint::mechanism {
namespace {

constexpr int steps = 180;
constexpr double turn = 2 * std::numbers::pi;

struct Position {
    double angle = 0;  ///< of the driver [rad]
    std::vector<PlanarPose> poses;
    double height = 0;  ///< of the slide along the stroke [m]
    double slope = 0;   ///< of the height by the angle [m/rad]
};

class Slide {
public:
    explicit Slide(const Linkage& linkage)
        : system_(linkage), point_(system_.slide_point()),
          stroke_((1.0 / norm(linkage.stroke_direction)) * linkage.stroke_direction)
    {}

    [[nodiscard]] const PlanarSystem& system() const { return system_; }
    [[nodiscard]] Position start() const { return measured(0, system_.assembled()); }
    [[nodiscard]] Position moved(const Position& from, double angle) const
    {
        return measured(angle, system_.follow(from.poses, from.angle, angle));
    }

private:
    [[nodiscard]] Position measured(double angle, std::vector<PlanarPose> poses) const
    {
        const PlanarMotion motion = system_.motion(poses, 1.0);
        const int body = system_.linkage().slide_body;
        Position result;
        result.angle = angle;
        result.height = dot(stroke_, place(poses[body], point_));
        result.slope = dot(stroke_, velocity_of(poses[body], motion.velocities[body], point_));
        result.poses = std::move(poses);
        return result;
    }

    PlanarSystem system_;
    Vec2 point_;
    Vec2 stroke_;
};

std::vector<Position> scan(const Slide& slide)
{
    std::vector<Position> positions{slide.start()};
    for (int i = 1; i <= steps; ++i)
        positions.push_back(slide.moved(positions.back(), i * turn / steps));

    const Linkage& linkage = slide.system().linkage();
    for (std::size_t body = 0; body < linkage.bodies.size(); ++body) {
        const PlanarPose& end = positions.back().poses[body];
        if (norm(end.translation) > 1e-6 || std::abs(std::remainder(end.angle, turn)) > 1e-6)
            throw InputError(
                fmt::format("after one turn of the driver '{}' is not where it was: the linkage changed its way "
                            "of closing; check its lengths",
                            linkage.bodies[body]));
    }
    return positions;
}

/// Zero of the slope between two positions of opposite sign (false position, Illinois variant: an end that stays twice
/// counts half).
Position refined(const Slide& slide, Position last, Position other)
{
    double other_slope = other.slope;
    for (int iteration = 0; iteration < 60 && last.slope != 0; ++iteration) {
        const double angle = last.angle - last.slope * (other.angle - last.angle) / (other_slope - last.slope);
        Position next = slide.moved(last, angle);
        const bool converged = std::abs(next.angle - last.angle) < 1e-12;
        if (next.slope * last.slope > 0) {
            other_slope /= 2;
        } else {
            other = std::move(last);
            other_slope = other.slope;
        }
        last = std::move(next);
        if (converged)
            break;
    }
    return last;
}

Position lowest(const Slide& slide, const std::vector<Position>& positions)
{
    const auto by_height = [](const Position& a, const Position& b) { return a.height < b.height; };
    const auto [bottom, top] = std::minmax_element(positions.begin(), positions.end(), by_height);
    const Linkage& linkage = slide.system().linkage();
    if (!(top->height - bottom->height > 1e-9))
        throw InputError(fmt::format("the slide '{}' does not move along the stroke when '{}' turns",
                                     linkage.bodies[linkage.slide_body], linkage.joints[linkage.driver].name));
    // At an end of the scan the neighbour lies beyond it; one step further is the same as one step back.
    const Position& middle = bottom == positions.end() - 1 ? positions.front() : *bottom;
    const Position before = slide.moved(middle, middle.angle - turn / steps);
    const Position after = slide.moved(middle, middle.angle + turn / steps);
    if (middle.slope == 0)
        return middle;
    return middle.slope > 0 ? refined(slide, before, middle) : refined(slide, middle, after);
}

}  // namespace

BottomDeadPointSensitivity bottom_dead_point(const Linkage& linkage)
{
    const Slide slide(linkage);
    const Position bottom = lowest(slide, scan(slide));
    const PlanarSystem& system = slide.system();

    BottomDeadPointSensitivity result;
    result.crank_angle = std::remainder(bottom.angle, turn);
    result.poses = bottom.poses;
    for (int joint = 0; joint < static_cast<int>(linkage.joints.size()); ++joint)
        result.joint_centres.push_back(system.joint_centre(joint, bottom.poses));
    result.weight = system.slide_weights(bottom.poses);
    return result;
}

}  // namespace deadpoint::mechanism
