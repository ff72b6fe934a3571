#include "deadpoint/twin/map/reduced_sweep.hpp"

#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/observer.hpp"
#include "deadpoint/press/result/run_result.hpp"
#include "deadpoint/reduce/parallel/in_parallel.hpp"
#include "deadpoint/twin/map/point_observer.hpp"
#include "deadpoint/twin/model/reduced_press.hpp"
#include "deadpoint/twin/run/run_reduced.hpp"

#include <algorithm>
#include <chrono>
#include <fmt/format.h>
#include <set>
#include <string>
#include <string_view>
#include <utility>

namespace deadpoint::twin {
namespace {

constexpr std::size_t points_per_thread = 8;  // at a time: a study that is killed loses no more

/// A point on its way.
struct Work {
    EndedPoint ended;
    std::vector<std::string> warnings;
};

/// Runs points of a study, and tells of them.
class Points {
public:
    Points(const std::vector<SweepPoint>& points, const ReducedPress& press, const ReducedSweep& sweep,
           Observer& observer)
        : points_(points), press_(press), sweep_(sweep), observer_(observer)
    {}

    [[nodiscard]] Work run(std::size_t point)
    {
        const auto start = std::chrono::steady_clock::now();
        Work work;
        PointObserver observer(observer_);
        try {
            const auto input = sweep_.read(points_[point]);
            const auto result = run_reduced(input, press_, {}, ReducedDetail::figures, observer, nullptr, &shared_);
            if (result.thermal.interrupted)
                return work;
            work.ended.record = sweep_.record(point, input, result);
            work.ended.outcome.state = PointOutcome::State::done;
        } catch (const Error& error) {
            work.ended.outcome = {PointOutcome::State::failed, error.what(), 0};
        }
        work.ended.outcome.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        work.warnings = std::move(observer.warnings);
        return work;
    }

    void tell(std::size_t point, Work work)
    {
        const auto& outcome = work.ended.outcome;
        const auto& name = points_[point].name;
        if (outcome.state == PointOutcome::State::failed)
            observer_.warn(fmt::format("point {} failed: {}", name, outcome.reason));
        for (const auto& warning : work.warnings)
            if (told_.insert(warning).second)
                observer_.warn(fmt::format("point {}: {}", name, warning));
        if (outcome.state != PointOutcome::State::left)
            sweep_.take(point, std::move(work.ended));
    }

private:
    const std::vector<SweepPoint>& points_;
    const ReducedPress& press_;
    const ReducedSweep& sweep_;
    Observer& observer_;
    SharedParts shared_;
    std::set<std::string> told_;  // most points warn of the same
};

}  // namespace

void run_points_reduced(const std::vector<SweepPoint>& points, const std::vector<std::size_t>& pending,
                        const ReducedPress& press, const ReducedSweep& sweep, Observer& observer)
{
    const auto at_a_time = points_per_thread * static_cast<std::size_t>(std::max(sweep.threads, 1));
    Points runs(points, press, sweep, observer);
    observer.stage("points");
    for (std::size_t first = 0; first < pending.size() && !observer.cancelled(); first += at_a_time) {
        std::vector<Work> works(std::min(at_a_time, pending.size() - first));
        reduce::in_parallel(sweep.threads, works.size(), [&](std::size_t k) {
            if (!observer.cancelled())
                works[k] = runs.run(pending[first + k]);
        });
        for (std::size_t k = 0; k < works.size(); ++k)
            runs.tell(pending[first + k], std::move(works[k]));
        const auto done = first + works.size();
        observer.progress(static_cast<double>(done) / static_cast<double>(pending.size()),
                          fmt::format("{} of {} points", done, pending.size()));
    }
}

}  // namespace deadpoint::twin
