#pragma once

#include "deadpoint/exchange/laws/friction.hpp"

#include <optional>
#include <string>
#include <vector>

namespace deadpoint {
struct BearingCycle;
struct CycleHistory;
struct JointCycle;
}  // namespace deadpoint

/// Duty of a joint with friction over one turn of the crank, for friction laws.
///
/// Friction is not linear in load and speed, so a law is averaged over the turn, never evaluated at averages: mean(F
/// |w|) is not mean(F) mean(|w|).
namespace deadpoint::tribology {

using deadpoint::LoadMeasure;
using deadpoint::rolling_load_exponent;

/// Load and speed at the samples of a turn, with the share of time of each sample.
struct Duty {
    std::vector<double> weight;  ///< share of the turn, adds up to 1
    std::vector<double> force;   ///< magnitude [N]
    std::vector<double> speed;   ///< magnitude [rad/s] or, of a slide, [m/s]
};

/// Share of the turn of each sample: trapezoidal rule over a closed turn, (t[i+1] - t[i-1]) / (2 period).
///
/// @param time    strictly increasing, all within one period [s]
/// @param period  [s]
/// @throws InputError if there are no times, they do not increase, or they span the period or more
std::vector<double> turn_weights(const std::vector<double>& time, double period);

/// Constant load and speed, signs dropped [N], [rad/s] or [m/s].
Duty steady_duty(double force, double speed);

/// Duty of a joint of the linkage: magnitude of its force and of its sliding.
/// @throws InputError if the series differ in length or hold values that are not finite
Duty duty_of(const CycleHistory& turn, const JointCycle& joint);

/// A guide of a slide: two ends, each with two faces that the gib presses together.
struct GuideFaces {
    double preload = 0;            ///< P by which the gib presses on each of the two faces, all along the guide [N]
    std::optional<double> length;  ///< distance of the two ends along the travel [m]; without it no moment
};

/// Sum of the normal forces on all faces of a guide under a side force F and a moment M [N]: each end carries F/2 +- M
/// / length, and its faces are pressed together by P, half of the gib's 2 P, so that they carry max(P, |F/2 +- M /
/// length|). Without a moment, or without a length, that is max(2 P, |F|).
double guide_normal_force(const GuideFaces& guide, double force, double moment);

/// Normal forces on the two sides of a guide [N]: on the faces that push the body along +t, and on those that push it
/// along -t.
struct SideForces {
    double plus = 0;
    double minus = 0;
};

/// The same force by side. At each end f = force / 2 +- moment / length, along +t. Two faces of equal stiffness that
/// the gib presses together carry (P + f) / 2 and (P - f) / 2 until one of them lifts off at |f| = P; then the other
/// carries |f| alone. Hence (max(P, |f|) +- f) / 2 at each end; both sides together are guide_normal_force.
SideForces guide_side_forces(const GuideFaces& guide, double force, double moment);

/// Duty of a slide in its guide: guide_normal_force over the turn.
/// @throws InputError as above, if the preload is negative or the length not positive
Duty guide_duty(const CycleHistory& turn, const JointCycle& joint, const GuideFaces& guide);

/// Duty of a crankshaft bearing at constant speed of the crank, any sign [rad/s]; its samples are even in time.
/// @throws InputError if there is no sample or one is not finite
Duty duty_of(const BearingCycle& bearing, double speed);

/// The duty for a load measure: unchanged, or with the largest force at every sample.
Duty measured(Duty duty, LoadMeasure measure);

/// The duty of one of several bearings that share a joint's force.
/// @param share  factor on the force, not negative
/// @throws InputError if the share is negative or not finite
Duty shared(Duty duty, double share);

/// Time mean of F^load_exponent |w|^speed_exponent; a zero exponent leaves its factor out (also at zero).
/// @throws InputError if the duty is empty, its series differ in length, or an exponent is negative
double duty_mean(const Duty& duty, double load_exponent, double speed_exponent);

double peak_force(const Duty& duty);                 ///< [N]
constexpr double rolling_drag_exponent = 5.0 / 3.0;  ///< of the speed in the power of Palmgren's viscous torque

/// @throws InputError unless there are samples, as many of each series, all finite, and the weights add up to 1
void check(const Duty& duty);

}  // namespace deadpoint::tribology
