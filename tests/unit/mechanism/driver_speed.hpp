#pragma once

#include <functional>
#include <vector>

namespace deadpoint::mechanism {

/// Speed of the driver over its angle after bottom dead point, for CycleRequest.
struct DriverSpeed {
    std::function<double(double past_bottom)> speed;  ///< [rad/s]
    std::function<double(double past_bottom)> slope;  ///< its derivative by the angle [1/s]; empty: steady
    std::vector<double> breaks;                       ///< where a higher derivative jumps [rad]
};

/// @throws InputError if the speed is not positive and finite
DriverSpeed steady_speed(double speed);

/// Speed from a table over the turn: a periodic cubic that passes all points with a continuous derivative and stays
/// between neighbouring points (Fritsch and Butland, SIAM J. Sci. Stat. Comput. 5, 1984), so that the driver's
/// acceleration has no jumps. One point, or equal speeds, is a steady speed.
///
/// @param past_bottom  angles past bottom dead point [rad], strictly increasing, the last less than a turn after the
///                     first; the table is closed over the turn
/// @param speed        [rad/s], > 0, as many
/// @throws InputError if the table is empty or of unequal lengths, the angles do not increase or span a turn or more,
///         or a speed is not positive and finite
DriverSpeed tabulated_speed(std::vector<double> past_bottom, std::vector<double> speed);

}  // namespace deadpoint::mechanism
