#include "deadpoint/mechanism/slide_motion.hpp"

#include "deadpoint/mechanism/planar_system.hpp"

#include <cmath>

namespace deadpoint::mechanism {

SlideMotion::SlideMotion(const PlanarSystem& system)
    : system_(system), point_(system.slide_point()),
      stroke_((1.0 / norm(system.linkage().stroke_direction)) * system.linkage().stroke_direction)
{}

Vec2 SlideMotion::point(const PlanarPosition& position) const
{
    return place(position.poses[system_.linkage().slide_body], point_);
}

double SlideMotion::height(const PlanarPosition& position) const { return dot(stroke_, point(position)); }

double SlideMotion::slope(const PlanarPosition& position) const
{
    const int body = system_.linkage().slide_body;
    return dot(stroke_, velocity_of(position.poses[body], position.slopes[body], point_));
}

double SlideMotion::curvature(const PlanarPosition& position) const
{
    const int body = system_.linkage().slide_body;
    return dot(stroke_,
               acceleration_of(position.poses[body], position.slopes[body], position.curvatures[body], point_));
}

PlanarPosition SlideMotion::zero(const std::function<double(const PlanarPosition&)>& of, const PlanarPosition& first,
                                 const PlanarPosition& second) const
{
    // False position, Illinois variant: the value at an end that stays twice is halved.
    PlanarPosition last = first;
    double last_value = of(last);
    double other = second.angle;
    double other_value = of(second);
    if (other_value == 0)
        return second;
    for (int iteration = 0; iteration < 100 && last_value != 0; ++iteration) {
        const double angle = last.angle - last_value * (other - last.angle) / (other_value - last_value);
        PlanarPosition next = system_.moved(last, angle);
        const double value = of(next);
        const bool converged = std::abs(next.angle - last.angle) < 1e-12;
        if (value * last_value > 0) {
            other_value /= 2;
        } else {
            other = last.angle;
            other_value = last_value;
        }
        last = std::move(next);
        last_value = value;
        if (converged)
            break;
    }
    return last;
}

PlanarPosition SlideMotion::extremum(Extremum kind, const PlanarPosition& near, double reach) const
{
    const double here = slope(near);
    const double side = (here > 0) == (kind == Extremum::highest) ? 1 : -1;
    if (here == 0)
        return near;
    const PlanarPosition other = system_.moved(near, near.angle + side * reach);
    if (slope(other) * here > 0)
        return near;  // no change of sign: the height only has a flat point there
    return zero([this](const PlanarPosition& p) { return slope(p); }, near, other);
}

}  // namespace deadpoint::mechanism
