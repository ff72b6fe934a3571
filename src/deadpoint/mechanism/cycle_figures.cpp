#include "deadpoint/core/units.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/mechanism/cycle.hpp"
#include "deadpoint/mechanism/planar_system.hpp"
#include "deadpoint/mechanism/slide_motion.hpp"

#include <algorithm>
#include <cmath>

namespace deadpoint::mechanism {
namespace {

/// Positions of the linkage at and between the samples of its history.
class TurnFigures {
public:
    TurnFigures(const SlideMotion& slide, const CycleHistory& history) : slide_(slide), history_(history) {}

    [[nodiscard]] int samples() const { return static_cast<int>(history_.angle.size()); }
    [[nodiscard]] PlanarPosition at(int sample) const
    {
        std::vector<PlanarPose> poses;
        for (const BodyCycle& body : history_.bodies)
            poses.push_back(body.pose[sample]);
        return slide_.system().position(std::move(poses));
    }

    /// Share of the turn with the slide less than `height` above bottom dead point.
    [[nodiscard]] double dwell(double height) const
    {
        const double level = slide_.height(at(0)) + height;
        const auto over = [&](const PlanarPosition& p) { return slide_.height(p) - level; };
        const double step = full_turn / samples();
        double sum = 0;
        for (int i = 0; i < samples(); ++i) {
            const double here = history_.height[i] - height;
            const double next = history_.height[(i + 1) % samples()] - height;
            if (here < 0 && next < 0)
                sum += step;
            if ((here < 0) == (next < 0))
                continue;
            const PlanarPosition first = at(i);
            const PlanarPosition second = slide_.system().moved(first, first.angle + step);
            const double crossing = slide_.zero(over, first, second).angle - first.angle;
            sum += here < 0 ? crossing : step - crossing;
        }
        return sum / full_turn;
    }

    /// Maximum of a function of the position near its largest sample (golden section).
    template <class Of>
    [[nodiscard]] double largest(int sample, Of of) const
    {
        const double section = 0.5 * (std::sqrt(5.0) - 1);
        const PlanarPosition start = at(sample);
        const auto value = [&](double angle) { return of(slide_.system().moved(start, angle)); };
        double low = start.angle - full_turn / samples();
        double high = start.angle + full_turn / samples();
        double left = high - section * (high - low);
        double right = low + section * (high - low);
        double at_left = value(left);
        double at_right = value(right);
        while (high - low > 1e-9) {  // the value is then accurate to rounding
            if (at_left > at_right) {
                high = right;
                right = left;
                at_right = at_left;
                left = high - section * (high - low);
                at_left = value(left);
            } else {
                low = left;
                left = right;
                at_left = at_right;
                right = low + section * (high - low);
                at_right = value(right);
            }
        }
        return std::max({of(start), at_left, at_right});
    }

private:
    const SlideMotion& slide_;
    const CycleHistory& history_;
};

int index_of_largest(const std::vector<double>& values, bool magnitude)
{
    const auto less = [magnitude](double a, double b) { return magnitude ? std::abs(a) < std::abs(b) : a < b; };
    return static_cast<int>(std::max_element(values.begin(), values.end(), less) - values.begin());
}

/// Distance of the crank pin from the driver's axis: the furthest joint of the driven body.
double throw_of(const Linkage& linkage)
{
    const LinkageJoint& driver = linkage.joints[linkage.driver];
    const int driven = driver.body_a == linkage.ground ? driver.body_b : driver.body_a;
    double largest = 0;
    for (const LinkageJoint& joint : linkage.joints)
        if (joint.body_a == driven || joint.body_b == driven)
            largest = std::max(largest, norm(joint.centre - driver.centre));
    return largest;
}

}  // namespace

StrokeFigures stroke_figures(const Linkage& linkage, const CycleRequest& request, const CycleHistory& history)
{
    const PlanarSystem system(linkage);
    const SlideMotion slide(system);
    const TurnFigures cycle(slide, history);
    const double bottom = history.angle.at(0);
    const auto past = [bottom](const PlanarPosition& p) { return std::remainder(p.angle - bottom, full_turn); };
    const auto speed = [&](const PlanarPosition& p) { return std::abs(slide.slope(p)) * request.speed(past(p)); };
    const auto acceleration = [&](const PlanarPosition& p) {
        const double w = request.speed(past(p));
        const double slope = request.speed_slope ? request.speed_slope(past(p)) : 0.0;
        return std::abs(w * w * slide.curvature(p) + w * slope * slide.slope(p));
    };

    StrokeFigures result;
    const PlanarPosition top = slide.extremum(
        SlideMotion::Extremum::highest, cycle.at(index_of_largest(history.height, false)), full_turn / cycle.samples());
    result.stroke = slide.height(top) - slide.height(cycle.at(0));
    result.bottom_dead_point = bottom;
    result.top_dead_point = top.angle;
    result.dwell_10um = cycle.dwell(10e-6);
    result.dwell_100um = cycle.dwell(100e-6);
    result.largest_speed = cycle.largest(index_of_largest(history.slide_speed, true), speed);
    result.largest_acceleration = cycle.largest(index_of_largest(history.slide_acceleration, true), acceleration);
    return result;
}

DriveFigures drive_figures(const CycleHistory& history)
{
    // Integrals over the turn: d theta for work, dt = d theta / w for means over time.
    const double step = full_turn / static_cast<double>(history.angle.size());
    DriveFigures result;
    double square = 0;
    for (std::size_t i = 0; i < history.angle.size(); ++i) {
        const double torque = history.drive_torque[i];
        const double duration = step / history.speed[i];
        result.mean_power += torque * step;
        result.mean_torque += torque * duration;
        square += torque * torque * duration;
        result.peak_torque = std::max(result.peak_torque, std::abs(torque));
    }
    result.mean_power /= history.period;
    result.mean_torque /= history.period;
    result.rms_torque = std::sqrt(square / history.period);
    return result;
}

std::vector<ForceRatio> force_ratios(const Linkage& linkage, const CycleHistory& history)
{
    const double radius = throw_of(linkage);
    if (!(radius > 0))
        throw InputError(
            "the crank has no pin away from its axis, so that there is no force ratio\n  help: connect the "
            "driven body to the linkage at a distance from its bearing");
    std::vector<ForceRatio> result;
    for (std::size_t i = 0; i < history.angle.size(); ++i) {
        const double by_angle = std::abs(history.slide_speed[i]) / history.speed[i];
        if (by_angle < 1e-9 * radius)
            continue;
        const double past = std::remainder(history.angle[i] - history.angle[0], full_turn);
        result.push_back({past, history.height[i], 1 / by_angle, radius / by_angle});
    }
    return result;
}

}  // namespace deadpoint::mechanism
