#include "deadpoint/exchange/heat.hpp"
#include "deadpoint/heat/balance.hpp"
#include "deadpoint/heat/tr_bdf2.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace deadpoint::heat {
namespace {

using Kind = SurfaceCondition::Kind;

// Rounding of sums of step lengths [s].
double same_time(double time) { return 1e-7 + 1e-12 * std::abs(time); }

double integral_of(const TimeCourse& course, double from, double to)
{
    const auto [integral, value] = course ? course.unseen(from, to) : Unseen{};
    if (!(integral > 0))
        return 0;
    return integral * std::sqrt(std::max(1.0, diagonal * (to - from) * value / integral));
}

void add_share(double here, double longer, double& largest)
{
    if (here > 0)
        largest = std::max(largest, longer > 0 ? here / longer : std::numeric_limits<double>::infinity());
}

void add_shares(const std::vector<double>& here, const std::vector<double>& longer, double& largest)
{
    for (std::size_t k = 0; k < here.size(); ++k)
        add_share(here[k], longer[k], largest);
}

}  // namespace

double StepTimes::value(const TimeCourse& course, double time) const
{
    if (time != middle || !(end > start) || course.is_linear(start, end))
        return course(time);
    return (course.mean(start, end) - outer_weight * course(start) - diagonal * course(end)) / outer_weight;
}

bool UnseenCourses::some_heat() const
{
    const auto some = [](const std::vector<double>& list) {
        return std::ranges::any_of(list, [](double heat) { return heat > 0; });
    };
    return ambient > 0 || some(surfaces) || some(bodies) || some(powers);
}

double UnseenCourses::share_of(const UnseenCourses& longer) const
{
    double largest = 0;
    add_share(ambient, longer.ambient, largest);
    add_shares(surfaces, longer.surfaces, largest);
    add_shares(bodies, longer.bodies, largest);
    add_shares(powers, longer.powers, largest);
    return largest;
}

void StepEnds::enter(const HeatSegment& segment)
{
    segment_ = &segment;
    courses_.clear();
    const auto add = [&](const TimeCourse& course) {
        if (course && !course.is_constant())
            courses_.push_back(&course);
    };
    add(segment.ambient);
    std::ranges::for_each(segment.body_heat, add);
    std::ranges::for_each(segment.enclosure_power, add);
    for (const auto& condition : problem_->surfaces) {
        add(condition.ambient);
        add(condition.flux);
        std::ranges::for_each(condition.temperature_courses, add);
    }
}

std::vector<double> StepEnds::points(double from, double to) const { return merged(from, to, &TimeCourse::points); }

std::vector<double> StepEnds::looked_at(double from, double to) const
{
    return merged(from, to, &TimeCourse::looked_at);
}

std::vector<double> StepEnds::merged(double from, double to,
                                     std::vector<double> (TimeCourse::*of)(double, double) const) const
{
    std::vector<double> result;
    for (const auto* course : courses_) {
        const auto points = (course->*of)(from + same_time(from), to - same_time(to));
        result.insert(result.end(), points.begin(), points.end());
    }
    std::ranges::sort(result);
    const auto same = [](double a, double b) { return b - a < same_time(b); };
    const auto tail = std::ranges::unique(result, same);
    result.erase(tail.begin(), tail.end());
    return result;
}

bool StepEnds::bends_prescribed(double time) const
{
    const double near = same_time(time);
    return std::ranges::any_of(problem_->surfaces, [&](const SurfaceCondition& condition) {
        return std::ranges::any_of(condition.temperature_courses, [&](const TimeCourse& course) {
            return !course.is_constant() && !course.points(time - near, time + near).empty();
        });
    });
}

UnseenCourses StepEnds::unseen(double from, double to) const
{
    UnseenCourses result;
    result.ambient = integral_of(segment_->ambient, from, to);
    for (const auto& condition : problem_->surfaces) {
        result.surfaces.push_back(
            integral_of(condition.kind == Kind::flux ? condition.flux : condition.ambient, from, to));
        for (const auto& course : condition.temperature_courses)
            result.prescribed = std::max(result.prescribed, course.unseen(from, to).value);
    }
    for (const auto& power : segment_->body_heat)
        result.bodies.push_back(integral_of(power, from, to));
    for (const auto& power : segment_->enclosure_power)
        result.powers.push_back(integral_of(power, from, to));
    return result;
}

}  // namespace deadpoint::heat
