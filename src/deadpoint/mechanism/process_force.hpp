#pragma once

#include <functional>
#include <vector>

/// Laws of the process (piling, blanking, forming) force between slide and table.
namespace deadpoint::mechanism {

/// Process force on the slide [N], positive along the stroke direction (up, away from the table), from the angle of the
/// driver past bottom dead point [rad, -pi..pi], the slide's height above bottom dead point [m] and its speed along the
/// stroke [m/s] (negative on the way down).
using ProcessForceLaw = std::function<double(double past_bottom, double height, double slide_speed)>;

ProcessForceLaw no_force();

/// Elastic die contact: P = k max(delta - h, 0), pushed together by delta at bottom dead point.
/// @param stiffness     k of press and die in series [N/m], > 0
/// @param interference  delta, height at which contact begins [m], >= 0
/// @throws InputError outside these ranges
ProcessForceLaw elastic_contact(double stiffness, double interference);

/// Elastic die contact with a given force at bottom dead point: delta = F / k.
/// @param peak  F [N], >= 0
ProcessForceLaw elastic_contact_of_peak(double stiffness, double peak);

/// Angles of the driver past bottom dead point [rad]; the window runs from `start` to `end` in the sense of rotation
/// and may pass top dead point.
struct AngleWindow {
    double start = 0;
    double end = 0;  ///< start < end <= start + 2 pi
};

/// Half a sine wave over the window, zero outside: P = F sin(pi (theta - start) / (end - start)).
/// @throws InputError if the window is empty or longer than a turn, or a number is not finite
ProcessForceLaw half_sine(double peak, const AngleWindow& window);

/// Constant force inside the window, zero outside.
///
/// A position within 1e-9 rad of an edge gets the share `at_edges` of the force. The default is one half, the mean of
/// both sides: the sum over evenly spaced positions that include the edges is then the true impulse. One shows the
/// forces just inside the edges, where the joint forces of a wide window are largest, but adds one position's share to
/// the impulse. With edges between positions the impulse is that of the positions inside.
/// @throws InputError as half_sine, or if the share is not within 0..1
ProcessForceLaw rectangle(double force, const AngleWindow& window, double at_edges = 0.5);

/// Force over the driver's angle, linear between the points and closed over the turn: from the last point it runs
/// linearly to the first one of the next turn. A single point is a constant force.
/// @param past_bottom  [rad], strictly increasing, the last less than a turn after the first
/// @throws InputError if the sizes differ or are zero, the angles do not increase, or a number is not finite
ProcessForceLaw force_over_angle(std::vector<double> past_bottom, std::vector<double> force);

enum class Strokes { down, both };

/// Force over the slide's height above bottom dead point, linear between the points; the first value holds below the
/// first height, and above the last height there is no force.
///
/// With `Strokes::down` it acts only while the slide moves down, as in forming; at bottom dead point itself (within
/// 1e-9 rad) with half its value, the mean of both sides. A slide that rests elsewhere counts as moving down.
/// @param height  [m], strictly increasing
/// @throws InputError as force_over_angle
ProcessForceLaw force_over_height(std::vector<double> height, std::vector<double> force,
                                  Strokes strokes = Strokes::down);

}  // namespace deadpoint::mechanism
