#pragma once

/// Ball joints that turn about an axis across their line of force, as those of a plane linkage do.
namespace deadpoint::tribology {

/// The zone of the ball that touches its socket, between two circles about the line of force.
struct BallSeat {
    double radius = 0;  ///< of the ball R [m]
    double from = 0;    ///< half angle of the relief in the middle, theta_0 [rad]
    double to = 0;      ///< half angle to the rim, theta_1, up to pi / 2 [rad]
};

/// 2 pi R^2 (cos theta_0 - cos theta_1) [m2].
/// @throws InputError if the radius is not positive or not 0 <= from < to <= pi / 2; so do the others
double seat_area(const BallSeat& seat);

/// r with the moment of friction M = mu r F [m]. A seat that has run in is pressed by p ~ cos(theta) (Reye: wear, and
/// with it p v, follows the sinking of the ball along the force; Stolarski, Tribology in Machine Design, ch. 4). With
/// the lever arm R sqrt(1 - sin^2(theta) cos^2(phi)) about the axis,
///
///   r / R = integral of p sqrt(1 - sin^2 theta cos^2 phi) dA  /  integral of p cos(theta) dA
///         = 2 / pi  [(1 + s^2) E(s) - (1 - s^2) K(s)] from s_0 to s_1  /  (cos^3 theta_0 - cos^3 theta_1),   s =
///         sin(theta)
///
/// E, K the complete elliptic integrals. 1 for a small seat, 4 / pi for a half ball, as for a run-in pin in a half
/// shell.
double friction_radius(const BallSeat& seat);

/// The same moment of shear in a film of even thickness as a pin of the radius friction_radius() and this length has in
/// its bush [m]: 2 pi r^3 L = integral of R^2 (1 - sin^2 theta cos^2 phi) dA.
double film_length(const BallSeat& seat);

}  // namespace deadpoint::tribology
