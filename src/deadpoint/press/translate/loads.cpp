#include "deadpoint/press/translate/loads.hpp"

#include "deadpoint/casefile/check/directions.hpp"
#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/core/mistakes.hpp"
#include "deadpoint/crankshaft/shaft/shaft.hpp"
#include "deadpoint/crankshaft/shaft/shaft_loads.hpp"
#include "deadpoint/exchange/cycle.hpp"
#include "deadpoint/mechanism/cycle.hpp"
#include "deadpoint/mechanism/force_tip.hpp"
#include "deadpoint/tribology/friction/duty.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace deadpoint::press {
namespace {

// The angle within half a turn.
double wrapped(double angle) { return std::remainder(angle, 2 * std::numbers::pi); }

std::vector<double> scaled(const std::vector<double>& values, double factor)
{
    std::vector<double> result;
    for (const double value : values)
        result.push_back(factor * value);
    return result;
}

std::vector<double> shifted(const std::vector<double>& values, double by)
{
    std::vector<double> result;
    for (const double value : values)
        result.push_back(value - by);
    return result;
}

// A table over the angle, linear between its points and closed over the turn.
class PeriodicTable {
public:
    PeriodicTable(const casefile::Table& table, double factor) : x_(table.x), y_(scaled(table.y, factor))
    {
        x_.push_back(x_.front() + 2 * std::numbers::pi);
        y_.push_back(y_.front());
    }
    [[nodiscard]] double value(double angle) const
    {
        const auto [i, s] = find(angle);
        return y_[i] + s * (y_[i + 1] - y_[i]);
    }
    [[nodiscard]] double slope(double angle) const
    {
        const auto i = find(angle).first;
        return (y_[i + 1] - y_[i]) / (x_[i + 1] - x_[i]);
    }

private:
    [[nodiscard]] std::pair<std::size_t, double> find(double angle) const
    {
        angle -= 2 * std::numbers::pi * std::floor((angle - x_.front()) / (2 * std::numbers::pi));
        auto i = static_cast<std::size_t>(std::upper_bound(x_.begin(), x_.end(), angle) - x_.begin());
        i = std::clamp<std::size_t>(i, 1, x_.size() - 1) - 1;
        const double width = x_[i + 1] - x_[i];
        return {i, width > 0 ? (angle - x_[i]) / width : 0.0};
    }
    std::vector<double> x_;
    std::vector<double> y_;
};

const casefile::ProcessForce& process_of(const casefile::Case& input)
{
    static const casefile::ProcessForce defaults;
    return input.process_force ? *input.process_force : defaults;
}

Vec2 pose_point(const PlanarPose& pose, const Vec2& p)
{
    const double c = std::cos(pose.angle), s = std::sin(pose.angle);
    return {pose.translation[0] + c * p[0] - s * p[1], pose.translation[1] + s * p[0] + c * p[1]};
}

// Window of the crank's angle past bottom dead point; 15 deg to either side if the case does not state it.
mechanism::AngleWindow force_window(const casefile::Case& input, double throw_at_bottom)
{
    const auto& process = process_of(input);
    const double start = process.from ? wrapped(*process.from - throw_at_bottom) : -std::numbers::pi / 12;
    if (process.from && process.to)
        return {start, start + *process.to - *process.from};
    const double end = process.to ? wrapped(*process.to - throw_at_bottom) : std::numbers::pi / 12;
    return {start, end > start ? end : end + 2 * std::numbers::pi};
}

// A multiple of the positions near to a number of samples: at steady speed the samples meet all positions.
int samples_of(std::size_t positions, int wanted)
{
    const int count = static_cast<int>(positions);
    return count * std::max(1, (wanted + count / 2) / count);
}

// The pin's load must lie on the shaft; where it does not, its keys are named, not what follows from them.
void require_pin_on_shaft(const casefile::Crankshaft& given)
{
    double end = given.start;
    for (const auto& section : given.sections)
        end += section.length;
    const double half = 0.5 * given.pin_width;
    if (given.pin_position - half < given.start - 1e-9 || given.pin_position + half > end + 1e-9)
        throw mistake("crankshaft.pin_position",
                      fmt::format("the crank pin, {:.6g} mm wide (pin_width) at {:.6g} mm, is not on the shaft, which "
                                  "runs from {:.6g} to {:.6g} mm",
                                  1e3 * given.pin_width, 1e3 * given.pin_position, 1e3 * given.start, 1e3 * end),
                      "state pin_position (0 mm without it) on the axis of crankshaft.start");
}

}  // namespace

casefile::ProcessForce::Kind process_force_kind(const casefile::Case& input)
{
    using Kind = casefile::ProcessForce::Kind;
    const bool rigid = input.crankshaft && input.crankshaft->model == casefile::Crankshaft::Model::rigid;
    return process_of(input).kind.value_or(rigid ? Kind::rectangular : Kind::elastic);
}

mechanism::ProcessForceLaw describe_process_force(const casefile::Case& input, double peak, double throw_at_bottom)
{
    using Kind = casefile::ProcessForce::Kind;
    const auto& process = process_of(input);
    if (peak == 0)
        return mechanism::no_force();
    const mechanism::AngleWindow window = force_window(input, throw_at_bottom);
    switch (process_force_kind(input)) {
    case Kind::elastic:
        return mechanism::elastic_contact_of_peak(process.stiffness, peak);
    case Kind::half_sine:
        return mechanism::half_sine(peak, window);
    case Kind::rectangular:
        return mechanism::rectangle(peak, window);
    case Kind::angle_table:
        return mechanism::force_over_angle(shifted(process.over_angle.x, throw_at_bottom),
                                           scaled(process.over_angle.y, peak));
    case Kind::travel_table:
        return mechanism::force_over_height(process.over_height.x, scaled(process.over_height.y, peak),
                                            process.both_ways ? mechanism::Strokes::both : mechanism::Strokes::down);
    default:
        return mechanism::no_force();
    }
}

mechanism::ForceCorners describe_corners(const casefile::Case& input, double throw_at_bottom)
{
    using Kind = casefile::ProcessForce::Kind;
    const auto& process = process_of(input);
    const auto window = force_window(input, throw_at_bottom);
    switch (process_force_kind(input)) {
    case Kind::half_sine:
        return {{0.5 * (window.start + window.end)}, {}};
    case Kind::angle_table:
        return {shifted(process.over_angle.x, throw_at_bottom), {}};
    case Kind::travel_table:
        return {{}, process.over_height.x};
    default:
        return {};
    }
}

std::optional<std::string> misplaced_force(const casefile::Case& input, double throw_at_bottom)
{
    using Kind = casefile::ProcessForce::Kind;
    const auto kind = process_force_kind(input);
    if (kind != Kind::half_sine && kind != Kind::rectangular)
        return std::nullopt;
    const auto window = force_window(input, throw_at_bottom);
    if ((window.start <= 0 && window.end >= 0) || window.end >= 2 * std::numbers::pi)
        return std::nullopt;
    constexpr double degrees = 180 / std::numbers::pi;
    return fmt::format(
        "the process force acts at {:.1f} to {:.1f} deg after bottom dead point and so does not include it; choose "
        "process_force.from and process_force.to around {:.1f} deg",
        degrees * window.start, degrees * window.end, degrees * throw_at_bottom + (throw_at_bottom < 0 ? 360 : 0));
}

std::vector<crankshaft::Section> slender_pieces(const std::vector<crankshaft::Section>& sections)
{
    std::vector<crankshaft::Section> pieces;
    for (const auto& section : sections) {
        const double count = std::ceil(2 * section.length / section.diameter - 1e-9);
        auto piece = section;
        piece.length /= count;
        pieces.insert(pieces.end(), static_cast<std::size_t>(count), piece);
    }
    return pieces;
}

mechanism::CycleRequest describe_cycle(const casefile::Case& input, const casefile::Segment& segment,
                                       double throw_at_bottom)
{
    mechanism::CycleRequest request;
    const double speed = segment.speed;
    if (input.mechanism.speed.x.empty()) {
        request.speed = [speed](double) { return speed; };
    } else {
        const PeriodicTable table(input.mechanism.speed, speed);
        request.speed = [table](double angle) { return table.value(angle); };
        request.speed_slope = [table](double angle) { return table.slope(angle); };
        for (const double angle : input.mechanism.speed.x)
            request.speed_breaks.push_back(wrapped(angle));
        std::ranges::sort(request.speed_breaks);
    }
    request.process_force = describe_process_force(input, segment.force, throw_at_bottom);
    request.process_force_offset = process_of(input).offset;
    request.gravity = casefile::plane_gravity(input);
    request.positions = input.mechanism.positions;
    return request;
}

int driven_body(const Linkage& linkage)
{
    const auto& driver = linkage.joints[static_cast<std::size_t>(linkage.driver)];
    return driver.body_a == linkage.ground ? driver.body_b : driver.body_a;
}

int crank_pin_joint(const Linkage& linkage)
{
    const int crank = driven_body(linkage);
    const Vec2 axis = linkage.joints[static_cast<std::size_t>(linkage.driver)].centre;
    int pin = -1;
    double furthest = 0;
    for (int j = 0; j < static_cast<int>(linkage.joints.size()); ++j) {
        const auto& joint = linkage.joints[static_cast<std::size_t>(j)];
        const double distance = norm(joint.centre - axis);
        if (j != linkage.driver && (joint.body_a == crank || joint.body_b == crank) && distance > furthest) {
            furthest = distance;
            pin = j;
        }
    }
    if (pin < 0)
        throw mistake("joints", fmt::format("the crank '{}' has no joint away from its axis; add the joint of its pin",
                                            linkage.bodies[static_cast<std::size_t>(crank)]));
    return pin;
}

crankshaft::Shaft describe_shaft(const casefile::Case& input, const Linkage& linkage, const BodyMass& crank)
{
    const auto& given = *input.crankshaft;
    require_pin_on_shaft(given);
    const auto& material = input.materials.at(given.material);
    crankshaft::Shaft shaft;
    shaft.youngs_modulus = material.youngs_modulus;
    shaft.poissons_ratio = material.poissons_ratio;
    shaft.start = given.start;
    shaft.axial_load = given.axial_load;
    shaft.modal_damping = given.modal_damping;
    for (const auto& s : given.sections)
        shaft.sections.push_back({s.length, s.diameter, s.bore, s.density.value_or(material.density),
                                  s.shear_factor.value_or(given.shear_factor)});
    for (const auto& d : given.disks)
        shaft.disks.push_back(
            {d.position, d.mass, d.polar_inertia, d.diametral_inertia, d.mass * d.eccentricity, d.eccentricity_angle});
    for (std::size_t i = 0; i < given.bearings.size(); ++i) {
        const auto& b = given.bearings[i];
        crankshaft::Bearing bearing;
        bearing.name = b.name.empty() ? fmt::format("bearing_{}", i + 1) : b.name;
        bearing.position = b.position;
        bearing.stiffness = b.stiffness;
        bearing.damping = b.damping;
        bearing.housing_mass = b.housing_mass;
        bearing.support_stiffness = b.support_stiffness;
        bearing.support_damping = b.support_damping;
        bearing.hertz_exponent = b.hertz_exponent;
        bearing.reference_load = b.reference_load;
        shaft.bearings.push_back(bearing);
    }
    const Vec2 axis = linkage.joints[static_cast<std::size_t>(linkage.driver)].centre;
    const Vec2 pin = linkage.joints[static_cast<std::size_t>(crank_pin_joint(linkage))].centre - axis;
    const Vec2 centre = crank.centre - axis;
    if (given.throw_unbalance && norm(centre) > 0)
        shaft.unbalances.push_back({given.pin_position, crank.mass * norm(centre),
                                    wrapped(std::atan2(centre[1], centre[0]) - std::atan2(pin[1], pin[0]))});
    return shaft;
}

tribology::GuideFaces describe_guide(const casefile::Joint& joint) { return {joint.preload, joint.guide_length}; }

double belt_force(const casefile::Case& input, double speed)
{
    if (!input.crankshaft || !input.crankshaft->belt)
        return 0;
    const auto& belt = *input.crankshaft->belt;
    return belt.force ? *belt.force : belt.power / (speed * belt.pulley_diameter / 2);
}

crankshaft::ShaftLoads describe_shaft_loads(const casefile::Case& input, const Linkage& linkage,
                                            const CycleHistory& history, double speed)
{
    const auto& given = *input.crankshaft;
    const int crank = driven_body(linkage);
    crankshaft::ShaftLoads loads;
    loads.time = history.time;
    loads.period = history.period;
    loads.pin_position = given.pin_position;
    loads.pin_width = given.pin_width;
    loads.gravity = casefile::plane_gravity(input);
    loads.samples = samples_of(history.time.size(), loads.samples);
    loads.pin_force.assign(history.time.size(), Vec2{});
    for (std::size_t j = 0; j < linkage.joints.size(); ++j) {
        const auto& joint = linkage.joints[j];
        if (static_cast<int>(j) == linkage.driver || (joint.body_a != crank && joint.body_b != crank))
            continue;
        const double sign = joint.body_a == crank ? 1 : -1;
        for (std::size_t i = 0; i < history.time.size(); ++i)
            loads.pin_force[i] = loads.pin_force[i] + sign * history.joints[j].force[i];
    }
    const Vec2 axis = linkage.joints[static_cast<std::size_t>(linkage.driver)].centre;
    const Vec2 pin = linkage.joints[static_cast<std::size_t>(crank_pin_joint(linkage))].centre;
    const auto& first = history.bodies[static_cast<std::size_t>(crank)].pose.front();
    const Vec2 arm = pose_point(first, pin) - pose_point(first, axis);
    for (const double angle : history.angle)
        loads.throw_angle.push_back(std::atan2(arm[1], arm[0]) + angle - history.angle.front());
    if (given.belt)
        loads.steady.push_back({given.belt->position, belt_force(input, speed) * Vec2{std::cos(given.belt->angle),
                                                                                      std::sin(given.belt->angle)}});
    return loads;
}

}  // namespace deadpoint::press
