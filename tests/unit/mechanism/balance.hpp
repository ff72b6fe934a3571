#pragma once

#include "deadpoint/mechanism/cycle.hpp"
#include "deadpoint/mechanism/planar_system.hpp"

#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>
#include <vector>

/// Newton's and Euler's equations of every body and the balance of power, from the values in a history alone.
namespace balance {

using namespace deadpoint;

inline double cross(const Vec2& a, const Vec2& b) { return a[0] * b[1] - a[1] * b[0]; }

/// Largest violation over the turn, each relative to the largest term of its kind on that body.
struct Residuals {
    double force = 0;
    double moment = 0;
    double power = 0;
};

struct Sums {
    Vec2 force{};
    double moment = 0;
    double force_scale = 0;
    double moment_scale = 0;

    void add(const Vec2& f, const Vec2& arm, double m)
    {
        force = force + f;
        moment += cross(arm, f) + m;
        force_scale = std::max(force_scale, norm(f));
        moment_scale = std::max({moment_scale, norm(arm) * norm(f), std::abs(m)});
    }
};

class Check {
public:
    Check(const Linkage& linkage, const mechanism::CycleRequest& request, const CycleHistory& history)
        : linkage_(linkage), request_(request), history_(history)
    {
        const Vec2 stroke = (1.0 / norm(linkage.stroke_direction)) * linkage.stroke_direction;
        stroke_ = stroke;
        point_ = mechanism::PlanarSystem(linkage).slide_point();
    }

    [[nodiscard]] Residuals residuals() const
    {
        Residuals worst;
        for (int body = 0; body < static_cast<int>(linkage_.bodies.size()); ++body) {
            if (body == linkage_.ground)
                continue;
            double force = 0;
            double moment = 0;
            Sums scale;
            for (int i = 0; i < samples(); ++i) {
                const Sums sums = of_body(body, i);
                force = std::max(force, norm(sums.force));
                moment = std::max(moment, std::abs(sums.moment));
                scale.force_scale = std::max(scale.force_scale, sums.force_scale);
                scale.moment_scale = std::max(scale.moment_scale, sums.moment_scale);
            }
            worst.force = std::max(worst.force, force / std::max(scale.force_scale, 1e-300));
            // Where everything meets in one point only rounding is left: arms below a millimetre count as one.
            const double moment_scale = std::max({scale.moment_scale, 1e-3 * scale.force_scale, 1e-300});
            worst.moment = std::max(worst.moment, moment / moment_scale);
        }
        double power = 0;
        double power_scale = 1e-300;
        for (int i = 0; i < samples(); ++i)
            power = std::max(power, std::abs(power_at(i, power_scale)));
        worst.power = power / power_scale;
        return worst;
    }

private:
    [[nodiscard]] int samples() const { return static_cast<int>(history_.angle.size()); }

    [[nodiscard]] Vec2 process_point(int i) const
    {
        const Vec2 right{stroke_[1], -stroke_[0]};
        return mechanism::place(history_.bodies[linkage_.slide_body].pose[i], point_) +
               request_.process_force_offset * right;
    }

    [[nodiscard]] Sums of_body(int body, int i) const
    {
        const BodyMass& mass = request_.masses[body];
        const BodyCycle& cycle = history_.bodies[body];
        const Vec2 centre = mechanism::place(cycle.pose[i], mass.centre);
        const Vec2 acceleration =
            mechanism::acceleration_of(cycle.pose[i], cycle.velocity[i], cycle.acceleration[i], mass.centre);
        Sums sums;
        sums.add(mass.mass * request_.gravity, {}, 0);
        sums.add(-mass.mass * acceleration, {}, -mass.inertia * cycle.acceleration[i].angle);
        for (std::size_t j = 0; j < linkage_.joints.size(); ++j) {
            const LinkageJoint& joint = linkage_.joints[j];
            const JointCycle& reaction = history_.joints[j];
            const Vec2 arm = reaction.centre[i] - centre;
            if (joint.body_a == body)
                sums.add(reaction.force[i], arm, reaction.moment[i]);
            if (joint.body_b == body)
                sums.add(-1.0 * reaction.force[i], arm, -reaction.moment[i]);
        }
        if (body == linkage_.slide_body)
            sums.add(history_.process_force[i] * stroke_, process_point(i) - centre, 0);
        const LinkageJoint& driver = linkage_.joints[linkage_.driver];
        if (body == (driver.body_a == linkage_.ground ? driver.body_b : driver.body_a))
            sums.add({}, {}, history_.drive_torque[i]);
        return sums;
    }

    /// Power of drive, weight and process less the rate of the kinetic energy.
    double power_at(int i, double& scale) const
    {
        double sum = 0;
        const auto add = [&](double value) {
            sum += value;
            scale = std::max(scale, std::abs(value));
        };
        add(history_.drive_torque[i] * history_.speed[i]);
        for (int body = 0; body < static_cast<int>(linkage_.bodies.size()); ++body) {
            if (body == linkage_.ground)
                continue;
            const BodyMass& mass = request_.masses[body];
            const BodyCycle& cycle = history_.bodies[body];
            const Vec2 velocity = mechanism::velocity_of(cycle.pose[i], cycle.velocity[i], mass.centre);
            const Vec2 acceleration =
                mechanism::acceleration_of(cycle.pose[i], cycle.velocity[i], cycle.acceleration[i], mass.centre);
            add(mass.mass * dot(request_.gravity, velocity));
            add(-mass.mass * dot(velocity, acceleration));
            add(-mass.inertia * cycle.velocity[i].angle * cycle.acceleration[i].angle);
        }
        const PlanarPose& velocity = history_.bodies[linkage_.slide_body].velocity[i];
        const PlanarPose& pose = history_.bodies[linkage_.slide_body].pose[i];
        const Vec2 arm = process_point(i) - pose.translation;
        const Vec2 force = history_.process_force[i] * stroke_;
        add(dot(force, velocity.translation) + velocity.angle * cross(arm, force));
        return sum;
    }

    const Linkage& linkage_;
    const mechanism::CycleRequest& request_;
    const CycleHistory& history_;
    Vec2 stroke_{};
    Vec2 point_{};
};

/// Largest distance between a revolute joint's centre as carried by its two bodies, over the turn [m].
inline double opening(const Linkage& linkage, const CycleHistory& history)
{
    double worst = 0;
    for (const LinkageJoint& joint : linkage.joints)
        for (std::size_t i = 0; i < history.angle.size() && joint.kind == LinkageJoint::Kind::revolute; ++i)
            worst = std::max(worst, norm(mechanism::place(history.bodies[joint.body_a].pose[i], joint.centre) -
                                         mechanism::place(history.bodies[joint.body_b].pose[i], joint.centre)));
    return worst;
}

/// Asserts the balances: rounding of a system of some tens of equations stays well below 1e-9 of the largest terms.
inline void require_balanced(const Linkage& linkage, const mechanism::CycleRequest& request,
                             const CycleHistory& history)
{
    const Residuals worst = Check(linkage, request, history).residuals();
    CHECK(worst.force < 1e-9);
    CHECK(worst.moment < 1e-9);
    CHECK(worst.power < 1e-9);
    CHECK(opening(linkage, history) < 1e-12);
}

}  // namespace balance
