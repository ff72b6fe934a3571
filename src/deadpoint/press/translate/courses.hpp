#pragma once

#include "deadpoint/exchange/heat.hpp"

namespace deadpoint::casefile {

struct Course;
struct Case;
struct Segment;
}  // namespace deadpoint::casefile

/// Courses of a case over the time of the run.
namespace deadpoint::press {

/// A course over the time since the run began; a table counts from `start` [s], a daily course from the run's begin.
TimeCourse time_course(const casefile::Course& course, double start);
/// A share of a power over the time since the run began.
TimeCourse scaled_power(const casefile::Course& power, double share);
/// Ambient temperature during a segment that begins at `start` [s].
TimeCourse segment_ambient(const casefile::Case& input, const casefile::Segment& segment, double start);

}  // namespace deadpoint::press
