#pragma once

#include "deadpoint/exchange/time_course.hpp"
#include "deadpoint/heat/balance.hpp"
#include "deadpoint/heat/tr_bdf2.hpp"

namespace deadpoint::heat {

/// The three times of a step [s].
struct StepTimes {
    double start = 0, middle = 0, end = 0;

    /// Value of a course at one of the times, or at any other one. In the middle it is the one with which the step's
    /// quadrature, weights outer_weight, outer_weight, diagonal, gives the integral of the course: no energy is lost or
    /// won. Where the course is linear over the step that is its value.
    [[nodiscard]] double value(const TimeCourse& course, double time) const
    {
        if (time != middle || !(end > start) || course.is_linear(start, end))
            return course(time);
        return (course.mean(start, end) - outer_weight * course(start) - diagonal * course(end)) / outer_weight;
    }
};

inline StepTimes times_of(const StepRecord& step) { return {step.start.time, step.middle.time, step.end.time}; }

}  // namespace deadpoint::heat
