#include "deadpoint/press/translate/courses.hpp"

#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/surroundings/ambient.hpp"

#include <utility>

namespace deadpoint::press {
namespace {

constexpr double pieces_of_a_period = 16;  ///< mean by Gauss' method to 1e-9 of the amplitude

}  // namespace

TimeCourse time_course(const casefile::Course& course, double start)
{
    if (course.daily) {
        const surroundings::DailyCourse daily{course.daily->mean, course.daily->amplitude,
                                              course.daily->time_of_maximum, course.daily->period};
        return {[daily](double time) { return surroundings::daily_temperature(daily, time); },
                daily.period / pieces_of_a_period};
    }
    if (!course.table)
        return TimeCourse::constant(course.constant);
    auto times = course.table->x;
    for (double& time : times)
        time += start;
    return {std::move(times), course.table->y};
}

TimeCourse scaled_power(const casefile::Course& power, double share) { return time_course(power, 0).times(share); }

TimeCourse segment_ambient(const casefile::Case& input, const casefile::Segment& segment, double start)
{
    return time_course(segment.ambient.value_or(casefile::Course{input.machine.ambient, {}, {}}), start);
}

}  // namespace deadpoint::press
