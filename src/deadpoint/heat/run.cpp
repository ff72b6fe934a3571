#include "deadpoint/heat/run.hpp"

#include "deadpoint/observer.hpp"

#include <fmt/format.h>

namespace deadpoint::heat {

bool report_step(const HeatProblem& problem, std::size_t done, double time, double duration, Observer& observer)
{
    constexpr std::size_t judged_after = 1000;
    constexpr double many = 1e5;
    const bool cancelled = observer.cancelled();
    if (done != judged_after)
        return cancelled;
    double left = -time;
    for (const auto& segment : problem.segments)
        left += segment.duration;
    const double more = left / duration;
    if (more > many)
        observer.warn(
            fmt::format("after {} time steps the run is at t = {:.3g} s of {:.3g} s; at the present {:.2g} s a "
                        "step, {:.2g} more follow; loosen numerics.time_tolerance, or look for a law or a "
                        "course that changes fast",
                        judged_after, time, time + left, duration, more));
    return cancelled;
}

}  // namespace deadpoint::heat
