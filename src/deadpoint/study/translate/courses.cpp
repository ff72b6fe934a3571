#include "deadpoint/study/translate/courses.hpp"

#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/core/table.hpp"
#include "deadpoint/surroundings/ambient.hpp"

namespace deadpoint::study {

TimeCourse time_course(const casefile::Course& course, double start)
{
    if (course.daily) {
        const surroundings::DailyCourse daily{course.daily->mean, course.daily->amplitude,
                                              course.daily->time_of_maximum, course.daily->period};
        return [daily](double time) { return surroundings::daily_temperature(daily, time); };
    }
    if (!course.table)
        return [value = course.constant](double) { return value; };
    return [table = *course.table, start](double time) {
        return interpolate_linear(table.x, table.y, time - start).value;
    };
}

TimeCourse scaled_power(const casefile::Course& power, double share)
{
    return [course = time_course(power, 0), share](double time) { return share * course(time); };
}

TimeCourse segment_ambient(const casefile::Case& input, const casefile::Segment& segment, double start)
{
    return time_course(segment.ambient.value_or(casefile::Course{input.machine.ambient, {}, {}}), start);
}

}  // namespace deadpoint::study
