#pragma once

#include "deadpoint/exchange/laws/laws.hpp"

#include <functional>

/// A film that follows the temperature, and its derivatives.
namespace deadpoint::reduce {

/// A film at the mean and the variance of its surface's temperature, as reduce/online/dense_system has it:
///   outside = q(mean) + q''(mean) / 2 variance    (convection: (q(mean + s) + q(mean - s)) / 2, s^2 = variance)
/// and the slope of the matrix, which is that of heat::film_slope().
struct FilmState {
    double mean = 0, variance = 0, faced = 0;  ///< [K], [K2], [K]
    double outside = 0;                        ///< to its air, and by radiation to its ambient [W/m2]
    double by_mean = 0, by_variance = 0, by_faced = 0;
    double slope = 0;      ///< [W/m2/K]
    double own_slope = 0;  ///< that part of it which comes from `outside`
    double slope_by_mean = 0, slope_by_faced = 0;
};

/// @param law  of convection, by the temperature that the film faces
/// @param in_room  radiates to the surfaces of a radiant room, which is not part of `outside`
FilmState film_state(const std::function<FilmLaw(double faced)>& law, double emissivity, bool in_room, double mean,
                     double variance, double faced);

/// FilmState::outside alone.
double outside_flux(const FilmLaw& law, double emissivity, bool in_room, double mean, double variance, double faced);

/// sigma times the mean of T^4, to second order, and its derivatives [W/m2].
struct Emission {
    double value = 0, by_mean = 0, by_variance = 0;
};
Emission emission(double mean, double variance);

}  // namespace deadpoint::reduce
