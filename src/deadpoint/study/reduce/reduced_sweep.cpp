#include "deadpoint/study/reduce/reduced_sweep.hpp"

#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/observer.hpp"
#include "deadpoint/reduce/parallel/in_parallel.hpp"
#include "deadpoint/study/reduce/reduced_press.hpp"
#include "deadpoint/study/reduce/run_reduced.hpp"
#include "deadpoint/study/result/run_result.hpp"
#include "deadpoint/study/sweep/sweep_plan.hpp"

#include <algorithm>
#include <chrono>
#include <fmt/format.h>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>

namespace deadpoint::study {
namespace {

constexpr std::size_t points_at_a_time = 64;

/// Keeps the warnings of a point.
class PointObserver : public Observer {
public:
    explicit PointObserver(const Observer& study) : study_(study) {}
    void warn(std::string_view text) override { warnings.emplace_back(text); }
    [[nodiscard]] bool cancelled() const override { return study_.cancelled(); }
    std::vector<std::string> warnings;

private:
    const Observer& study_;
};

/// A point on its way.
struct Work {
    std::optional<casefile::Case> input;
    std::optional<RunResult> result;
    PointOutcome outcome;
    std::vector<std::string> warnings;
};

void fail(Work& work, const Error& error) { work.outcome = {PointOutcome::State::failed, error.what(), 0}; }

void run(Work& work, const ReducedPress& press, const Observer& study)
{
    const auto start = std::chrono::steady_clock::now();
    PointObserver observer(study);
    try {
        work.result = run_reduced(*work.input, press, {}, ReducedDetail::figures, observer);
        if (work.result->thermal.interrupted) {
            work.result.reset();
            return;
        }
        const auto taken = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        work.outcome = {PointOutcome::State::done, {}, taken};
    } catch (const Error& error) {
        fail(work, error);
    }
    work.warnings = std::move(observer.warnings);
}

}  // namespace

std::vector<PointOutcome> run_points_reduced(const std::vector<SweepPoint>& points, const ReducedPress& press,
                                             const ReducedSweep& sweep, Observer& observer)
{
    std::vector<PointOutcome> outcomes(points.size());
    std::set<std::string> told;  // most points warn of the same
    observer.stage("points");
    for (std::size_t first = 0; first < points.size() && !observer.cancelled(); first += points_at_a_time) {
        std::vector<Work> works(std::min(points_at_a_time, points.size() - first));
        for (std::size_t k = 0; k < works.size(); ++k)
            try {
                works[k].input = sweep.read(points[first + k]);
            } catch (const Error& error) {
                fail(works[k], error);
            }
        reduce::in_parallel(sweep.threads, works.size(), [&](std::size_t k) {
            if (works[k].input && !observer.cancelled())
                run(works[k], press, observer);
        });
        for (std::size_t k = 0; k < works.size(); ++k) {
            outcomes[first + k] = works[k].outcome;
            if (works[k].outcome.state == PointOutcome::State::failed)
                observer.warn(fmt::format("point {} failed: {}", points[first + k].name, works[k].outcome.reason));
            for (const auto& warning : works[k].warnings)
                if (told.insert(warning).second)
                    observer.warn(fmt::format("point {}: {}", points[first + k].name, warning));
            if (works[k].result)
                sweep.take(first + k, *works[k].input, *works[k].result);
        }
        const auto done = first + works.size();
        observer.progress(static_cast<double>(done) / static_cast<double>(points.size()),
                          fmt::format("{} of {} points", done, points.size()));
    }
    return outcomes;
}

}  // namespace deadpoint::study
