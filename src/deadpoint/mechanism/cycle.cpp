#include "deadpoint/mechanism/cycle.hpp"

#include "deadpoint/core/mistakes.hpp"
#include "deadpoint/core/units.hpp"
#include "deadpoint/core/vec.hpp"
#include "deadpoint/mechanism/bottom_dead_point.hpp"
#include "deadpoint/mechanism/planar_system.hpp"
#include "deadpoint/mechanism/slide_motion.hpp"
#include "deadpoint/mechanism/turn.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace deadpoint::mechanism {
namespace {

/// An angle since bottom dead point, 0..2 pi, as an angle past it, -pi..pi.
double past_bottom(double since) { return since > 0.5 * full_turn * (1 + 1e-15) ? since - full_turn : since; }

void check_mass(const std::string& name, const BodyMass& mass)
{
    if (!(mass.mass >= 0) || !std::isfinite(mass.mass) || !is_finite(mass.centre))
        throw InputError(fmt::format("body '{}': mass {} kg at ({}, {}) m\n  help: give a finite mass above zero, or "
                                     "mass and inertia zero for a massless link",
                                     name, mass.mass, mass.centre[0], mass.centre[1]));
    if (!(mass.inertia >= 0) || !std::isfinite(mass.inertia))
        throw InputError(fmt::format("body '{}': inertia {} kg m2\n  help: give a finite inertia above zero about "
                                     "the centre of mass",
                                     name, mass.inertia));
    if (mass.mass == 0 && mass.inertia > 0)
        throw InputError(fmt::format("body '{}' has an inertia of {} kg m2 but no mass\n  help: give its mass, or "
                                     "make both zero for a massless link",
                                     name, mass.inertia));
}

void check_masses(const Linkage& linkage, const std::vector<BodyMass>& masses)
{
    if (masses.size() != linkage.bodies.size())
        throw InputError(
            fmt::format("the linkage has {} bodies, but {} masses are given", linkage.bodies.size(), masses.size()));
    Mistakes mistakes;
    for (std::size_t body = 0; body < masses.size(); ++body)
        if (static_cast<int>(body) != linkage.ground)
            mistakes.attempt("bodies." + linkage.bodies[body], [&] { check_mass(linkage.bodies[body], masses[body]); });
    mistakes.raise();
}

void check_positions(int positions)
{
    if (positions < 4)
        throw InputError(
            fmt::format("a cycle of {} positions\n  help: ask for four positions or more (default 720)", positions));
}

void check_request(const Linkage& linkage, const CycleRequest& request)
{
    check_masses(linkage, request.masses);
    check_positions(request.positions);
    if (!request.speed)
        throw InputError("the driver has no speed\n  help: give a steady speed or a table");
    if (!std::isfinite(request.process_force_offset) || !is_finite(request.gravity))
        throw InputError("the offset of the process force or the gravity is not finite");
    if (!std::all_of(request.speed_breaks.begin(), request.speed_breaks.end(),
                     [](double x) { return std::isfinite(x); }))
        throw InputError("a break of the driver's speed is not finite");
}

/// Refuses a point mass for a body whose rotation accelerates.
void check_inertias(const Linkage& linkage, const std::vector<BodyMass>& masses, const CycleHistory& history)
{
    const double speed = *std::max_element(history.speed.begin(), history.speed.end());
    Mistakes mistakes;
    for (std::size_t body = 0; body < masses.size(); ++body) {
        if (static_cast<int>(body) == linkage.ground || masses[body].mass == 0 || masses[body].inertia > 0)
            continue;
        double largest = 0;
        for (const PlanarPose& acceleration : history.bodies[body].acceleration)
            largest = std::max(largest, std::abs(acceleration.angle));
        if (largest > 1e-9 * speed * speed)
            mistakes.add("bodies." + linkage.bodies[body],
                         fmt::format("body '{}' has mass but no inertia, and its rotation speeds up by up to {:.4g} "
                                     "rad/s2",
                                     linkage.bodies[body], largest),
                         "give its inertia about the centre of mass");
    }
    mistakes.raise();
}

class Cycle {
public:
    Cycle(const Linkage& linkage, const CycleRequest& request)
        : linkage_(linkage), request_(request), system_(linkage), slide_(system_)
    {}

    CycleHistory run(const Turn& along);

private:
    [[nodiscard]] double speed_at(double past) const;
    [[nodiscard]] double duration(double from, double to) const;
    void record(const PlanarPosition& position, double past);
    void record_joints(const PlanarMotion& motion, const PlanarReactions& reactions);
    [[nodiscard]] double process_force(double past, double height, double speed) const;
    [[nodiscard]] std::vector<PlanarLoad> body_loads(const PlanarMotion& motion) const;

    const Linkage& linkage_;
    const CycleRequest& request_;
    PlanarSystem system_;
    SlideMotion slide_;
    double bottom_height_ = 0;
    CycleHistory history_;
};

double Cycle::speed_at(double past) const
{
    const double speed = request_.speed(past);
    if (!(speed > 0) || !std::isfinite(speed))
        throw InputError(fmt::format("the driver's speed is {} rad/s at {:.3f} degrees past bottom dead point\n  help: "
                                     "give a speed above zero; for the other sense of rotation mirror the linkage",
                                     speed, past * degrees));
    return speed;
}

/// Integral of d theta / w between two angles since bottom dead point.
double Cycle::duration(double from, double to) const
{
    static constexpr double nodes[] = {0.1834346424956498, 0.5255324099163290, 0.7966664774136267, 0.9602898564975363};
    static constexpr double weights[] = {0.3626837833783620, 0.3137066458778873, 0.2223810344533745,
                                         0.1012285362903763};
    std::vector<double> ends{from, to};
    for (const double place : request_.speed_breaks) {
        const double since = std::fmod(std::fmod(place, full_turn) + full_turn, full_turn);
        if (since > from && since < to)
            ends.push_back(since);
    }
    const double longest = full_turn / 180;
    const int pieces = static_cast<int>(std::ceil((to - from) / longest));
    for (int i = 1; i < pieces; ++i)
        ends.push_back(from + i * longest);
    std::sort(ends.begin(), ends.end());

    double sum = 0;
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
        const double middle = 0.5 * (ends[i] + ends[i + 1]);
        const double half = 0.5 * (ends[i + 1] - ends[i]);
        for (int k = 0; k < 4; ++k)
            for (const double side : {-1.0, 1.0})
                sum += half * weights[k] / speed_at(past_bottom(middle + side * half * nodes[k]));
    }
    return sum;
}

double Cycle::process_force(double past, double height, double speed) const
{
    const double force = request_.process_force ? request_.process_force(past, height, speed) : 0.0;
    if (!std::isfinite(force))
        throw DomainError(
            fmt::format("the process force is {} N at {:.3f} degrees past bottom dead point\n  help: check "
                        "its law",
                        force, past * degrees));
    return force;
}

/// Weight and inertia of every body.
std::vector<PlanarLoad> Cycle::body_loads(const PlanarMotion& motion) const
{
    std::vector<PlanarLoad> loads(linkage_.bodies.size());
    for (std::size_t body = 0; body < loads.size(); ++body) {
        if (static_cast<int>(body) == linkage_.ground)
            continue;
        const BodyMass& mass = request_.masses[body];
        const PlanarPose& pose = motion.poses[body];
        const Vec2 acceleration =
            acceleration_of(pose, motion.velocities[body], motion.accelerations[body], mass.centre);
        loads[body] = load_of(pose, mass.mass * (request_.gravity - acceleration), place(pose, mass.centre));
        loads[body].moment -= mass.inertia * motion.accelerations[body].angle;
    }
    return loads;
}

void Cycle::record_joints(const PlanarMotion& motion, const PlanarReactions& reactions)
{
    for (std::size_t j = 0; j < linkage_.joints.size(); ++j) {
        const LinkageJoint& joint = linkage_.joints[j];
        const PlanarPose& va = motion.velocities[joint.body_a];
        const PlanarPose& vb = motion.velocities[joint.body_b];
        const Vec2 centre = system_.joint_centre(static_cast<int>(j), motion.poses);
        double sliding = va.angle - vb.angle;
        if (joint.kind == LinkageJoint::Kind::slide) {
            const PlanarPose still{};
            const PlanarPose only_angle{{0, 0}, motion.poses[joint.body_b].angle};
            const Vec2 direction = place(only_angle, (1.0 / norm(joint.direction)) * joint.direction);
            const Vec2 of_a = velocity_of(still, va, centre - motion.poses[joint.body_a].translation);
            const Vec2 of_b = velocity_of(still, vb, centre - motion.poses[joint.body_b].translation);
            sliding = dot(direction, of_a - of_b);
        }
        JointCycle& cycle = history_.joints[j];
        cycle.centre.push_back(centre);
        cycle.force.push_back(reactions.force[j]);
        cycle.moment.push_back(reactions.moment[j]);
        cycle.sliding.push_back(sliding);
    }
}

void Cycle::record(const PlanarPosition& position, double past)
{
    const double speed = speed_at(past);
    const double slope = request_.speed_slope ? request_.speed_slope(past) : 0.0;
    if (!std::isfinite(slope))
        throw DomainError(fmt::format("the derivative of the driver's speed is {} at {:.3f} degrees past bottom dead "
                                      "point\n  help: check its law",
                                      slope, past * degrees));
    if (!request_.speed_slope && !history_.speed.empty() && std::abs(speed - history_.speed[0]) > 1e-12 * speed)
        throw InputError(
            "the driver's speed varies, but its derivative is not given\n  help: give the derivative by the "
            "angle, without which the accelerations would be wrong");
    const double acceleration = speed * slope;
    const PlanarMotion motion = motion_at(position, speed, acceleration);
    const double height = slide_.height(position) - bottom_height_;
    const double slide_speed = speed * slide_.slope(position);
    const double force = process_force(past, height, slide_speed);

    std::vector<PlanarLoad> loads = body_loads(motion);
    const Vec2 stroke = slide_.stroke();
    const Vec2 right{stroke[1], -stroke[0]};
    const Vec2 through = slide_.point(position) + request_.process_force_offset * right;
    loads[linkage_.slide_body] += load_of(motion.poses[linkage_.slide_body], force * stroke, through);
    const PlanarReactions reactions = system_.reactions(position, loads);

    for (std::size_t body = 0; body < linkage_.bodies.size(); ++body) {
        history_.bodies[body].pose.push_back(motion.poses[body]);
        history_.bodies[body].velocity.push_back(motion.velocities[body]);
        history_.bodies[body].acceleration.push_back(motion.accelerations[body]);
    }
    record_joints(motion, reactions);
    history_.angle.push_back(position.angle);
    history_.speed.push_back(speed);
    history_.height.push_back(height);
    history_.slide_speed.push_back(slide_speed);
    history_.slide_acceleration.push_back(speed * speed * slide_.curvature(position) +
                                          acceleration * slide_.slope(position));
    history_.process_force.push_back(force);
    history_.drive_torque.push_back(reactions.drive_torque);
}

CycleHistory Cycle::run(const Turn& along)
{
    bottom_height_ = slide_.height(along.positions.front());
    history_.bodies.resize(linkage_.bodies.size());
    history_.joints.resize(linkage_.joints.size());
    double time = 0;
    for (int i = 0; i < request_.positions; ++i) {
        const double since = full_turn * i / request_.positions;
        record(along.positions[static_cast<std::size_t>(i)], past_bottom(since));
        history_.time.push_back(time);
        time += duration(since, full_turn * (i + 1) / request_.positions);
    }
    history_.period = time;
    check_inertias(linkage_, request_.masses, history_);
    return std::move(history_);
}

}  // namespace

Turn turn_of(const Linkage& linkage, int positions)
{
    check_positions(positions);
    const PlanarSystem system(linkage);
    const BottomDeadPointSensitivity bottom = bottom_dead_point(linkage);
    Turn result;
    PlanarPosition position = system.position(bottom.poses);
    position.angle = bottom.crank_angle;
    for (int i = 0; i < positions; ++i) {
        if (i > 0)
            position = system.moved(position, bottom.crank_angle + full_turn * i / positions);
        result.positions.push_back(position);
    }
    return result;
}

CycleHistory analyse_cycle(const Linkage& linkage, const CycleRequest& request, const Turn& along)
{
    check_request(linkage, request);
    if (along.positions.size() != static_cast<std::size_t>(request.positions))
        throw InputError(
            fmt::format("a cycle of {} positions on a turn of {}", request.positions, along.positions.size()));
    return Cycle(linkage, request).run(along);
}

CycleHistory analyse_cycle(const Linkage& linkage, const CycleRequest& request)
{
    check_request(linkage, request);
    return Cycle(linkage, request).run(turn_of(linkage, request.positions));
}

}  // namespace deadpoint::mechanism
