#pragma once

#include <optional>
#include <span>
#include <vector>

namespace deadpoint {
struct Series;
}

/// Figures of a test report after ISO 230-3 for a course over time, computed from a history.
///
/// With the drive running, the change over the first hour and over four hours corresponds to that standard's distortion
/// by a rotating spindle, here by the running crank; in a run at standstill under a changing ambient the range over the
/// whole run corresponds to its environmental temperature variation error (ETVE). The standard's tests have several
/// axes and tilts; a dimension chain has one axis.
namespace deadpoint::press {

inline constexpr double first_hour = 3600;
inline constexpr double four_hours = 4 * 3600;
inline constexpr double rate_window = 600;

/// A span from the start of the run.
struct StretchSummary {
    double span = 0;         ///< [s]; that of the run where it is shorter
    bool cut_short = false;  ///< the run is shorter than the stretch
    double change = 0;       ///< value at its end less that at its start
    double range = 0;        ///< largest less smallest value in it
};

/// Values in the unit of the course, rates per second.
struct CourseSummary {
    StretchSummary first_hour;
    StretchSummary four_hours;
    double largest_rate = 0;       ///< of largest magnitude: mean rate over any window, with its sign
    double largest_rate_from = 0;  ///< start of that window [s]
    double window = 0;             ///< rate_window, or the length of a shorter run [s]
    double range = 0;              ///< over the whole run
};

/// Sampled at the steps and every 10 s between, coarser in runs of more than two days; cubic between the steps.
/// @param time  of the steps, increasing, from the start of the run, at least one
/// @throws DomainError if there is no step, or not one value and rate per step
CourseSummary summarise_course(const std::vector<double>& time, const Series& series);

/// Time from which |rate| stays at or below a limit, between the steps too: by the derivative of the cubic that
/// `interpolate` evaluates, and history.csv shows. None if the rate at the end exceeds the limit.
std::optional<double> steady_from(const std::vector<double>& time, const Series& series, double rate_limit);

/// Time from which a sampled course stays within (1 - share) of its whole change, first to last value, of its last
/// value: the first of the given times after which it does.
/// @param time, value  of equal length, at least one
double time_to_share(std::span<const double> time, std::span<const double> value, double share);

}  // namespace deadpoint::press
