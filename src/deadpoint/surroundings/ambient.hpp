#pragma once

/// The course of a workshop's temperature.
namespace deadpoint::surroundings {

inline constexpr double day = 86400;  ///< [s]

/// Daily course of the ambient: mean + amplitude cos(2 pi (t - time_of_maximum) / period).
struct DailyCourse {
    double mean = 293.15;        ///< [K]
    double amplitude = 0;        ///< half the difference between highest and lowest [K]
    double time_of_maximum = 0;  ///< [s] on the clock of the run, any multiple of the period apart
    double period = day;         ///< [s]
};

/// Ambient temperature at a time [K].
/// @throws DomainError if a number is not finite, the amplitude is negative, the period is not positive, or the lowest
///         temperature is not above zero kelvin
double daily_temperature(const DailyCourse& course, double time);

}  // namespace deadpoint::surroundings
