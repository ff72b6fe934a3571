#pragma once

#include "deadpoint/twin/calibrate/forward.hpp"

#include <vector>

/// What a design is judged by: numbers of the course of E_SW, with exact derivatives.
namespace deadpoint::twin {

/// E_SW at rows of increasing time.
struct GapCourse {
    std::vector<double> time;                     ///< [s]
    std::vector<double> value;                    ///< [m]
    std::vector<std::vector<double>> derivative;  ///< [parameter][row]; empty if not computed
};

/// @throws InputError if the case has no dimension chain
GapCourse gap_course(const ForwardModel& model, const Forecast& forecast);

/// A number with its derivatives by theta, which are empty if the course has none.
struct Judged {
    double value = 0;
    std::vector<double> slope;
};

/// sqrt(mean((E(t) - E(from))^2)) over from..end, E linear between rows [m].
Judged drift_of(const GapCourse& course, double from);

/// sqrt(mean(((E+(t) - E-(t)) / 2d)^2)) over from..end: change of E_SW per kelvin of the ambient [m/K].
/// @param more, less  courses with the ambient d [K] above and below
Judged ambient_effect(const GapCourse& more, const GapCourse& less, double d, double from);

/// Time from which |dE/dt| stays below a limit. Rates are those between rows, linear between the middles of
/// neighbouring rows. If the limit is exceeded at the end T of the run by a factor f, the value is T (1 + ln f).
/// @param rate  [m/s]
Judged warm_time(const GapCourse& course, double rate);

/// (mean of |dE/dt / rate|^8)^(1/8) over all pairs of rows after a time: the largest rate, smoothly.
Judged largest_rate(const GapCourse& course, double rate, double from);

}  // namespace deadpoint::twin
