#include "deadpoint/reduce/offline/training.hpp"

#include "deadpoint/exchange/heat.hpp"
#include "deadpoint/observer.hpp"
#include "deadpoint/reduce/offline/build_options.hpp"
#include "deadpoint/reduce/offline/difference.hpp"
#include "deadpoint/reduce/online/dense_system.hpp"
#include "deadpoint/reduce/online/reduced_run.hpp"
#include "deadpoint/reduce/parallel/in_parallel.hpp"
#include "deadpoint/reduce/parallel/ranks.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <fmt/format.h>
#include <functional>
#include <numbers>
#include <thread>

namespace deadpoint::reduce {
namespace {

constexpr double pause = 1800;  // [s]
constexpr unsigned long long training_seed = 2;

using Terms = std::shared_ptr<const PreparedTerms>;

HeatSegment at_rest(HeatSegment segment)
{
    segment.duration = pause;
    std::ranges::fill(segment.heat, LawTable());
    segment.ring_heat.clear();
    segment.zoned_heat.assign(segment.zoned_heat.size(), 0.0);
    return segment;
}

void insert_pause(HeatProblem& problem, double place)
{
    auto longest = std::ranges::max_element(problem.segments, {}, &HeatSegment::duration);
    auto before = *longest, rest = at_rest(*longest);
    before.duration *= place;
    longest->duration -= before.duration;
    problem.segments.insert(longest, {std::move(before), std::move(rest)});
}

void add_swing(HeatProblem& problem, double phase)
{
    constexpr double kelvin = 3, period = 7200;
    for (auto& segment : problem.segments)
        segment.ambient = [course = segment.ambient, phase](double time) {
            return course(time) + kelvin * (std::sin(2 * std::numbers::pi * (time / period + phase)) -
                                            std::sin(2 * std::numbers::pi * phase));
        };
}

bool is_early(const HeatProblem& problem, double time)
{
    double begin = 0;
    for (const auto& segment : problem.segments) {
        if (time <= begin + segment.duration)
            return time < begin + settled_after;
        begin += segment.duration;
    }
    return false;
}

// The states after each step, a column for each, with roots of their weights.
Eigen::MatrixXd states_of_run(const Terms& terms, const HeatProblem& problem, const BuildOptions& options)
{
    std::vector<States> states;
    const double early = std::sqrt(options.early_share);
    Observer observer;
    ReducedRun(terms, problem, options.adjoints, options.reference)
        .go({[&](double time, const States& at) {
                 states.push_back(is_early(problem, time) ? States(early * at) : at);
             },
             {}},
            observer);
    Eigen::MatrixXd columns(terms->terms.uniform.size(), static_cast<Eigen::Index>(states.size()));
    for (std::size_t k = 0; k < states.size(); ++k)
        columns.col(static_cast<Eigen::Index>(k)) = states[k];
    return columns;
}

/// Where a dual problem begins.
struct DualStart {
    States weights;
    double weight = 1;  ///< of its states
};

std::vector<DualStart> dual_starts(const DenseTerms& terms, const BuildOptions& options)
{
    std::vector<DualStart> starts;
    if (options.has_dual)
        starts.push_back({terms.observed.row(static_cast<Eigen::Index>(options.dual_row)).transpose(), 1});
    const auto& layout = terms.geometry.layout;
    const double of_probe = options.probe_duals / std::max(1.0, static_cast<double>(layout.probes));
    for (std::size_t p = 0; p < layout.probes; ++p)
        starts.push_back({terms.functionals.row(static_cast<Eigen::Index>(layout.probe(p))).transpose(), of_probe});
    return starts;
}

// States of the dual problems, dz/dt = -K z backward from the weights of E_SW and of each probe, by implicit Euler
// steps of two minutes to four hours that double. The states of one dual problem count alike.
Eigen::MatrixXd dual_states(const Terms& terms, const HeatProblem& problem, const BuildOptions& options)
{
    constexpr int steps = 8;
    DenseSystem system(terms, problem, options.reference);
    system.set_laws(
        problem.segments.front().interfaces.empty() ? problem.interfaces : problem.segments.front().interfaces, {});
    const auto starts = dual_starts(terms->terms, options);
    const auto count = static_cast<Eigen::Index>(starts.size());
    Eigen::MatrixXd columns(terms->terms.uniform.size(), steps * count);
    for (Eigen::Index s = 0; s < count; ++s)
        columns.col(s) = starts[static_cast<std::size_t>(s)].weights;
    double length = 120;
    for (int k = 0; k < steps; ++k, length *= 2) {
        system.build(length, columns.col(0), {});
        for (Eigen::Index s = 0; s < count; ++s) {
            const States before = columns.col(k == 0 ? s : (k - 1) * count + s);
            States state = before;
            system.solve(before, state, {}, {}, "the dual of an output");
            columns.col(k * count + s) = state;
        }
    }
    columns.colwise().normalize();
    for (Eigen::Index k = 0; k < columns.cols(); ++k)
        columns.col(k) *= std::sqrt(starts[static_cast<std::size_t>(k % count)].weight);
    return columns;
}

/// Shows how many runs are done, and hears of a cancellation, on the thread that made it.
class Watch {
public:
    Watch(Observer& observer, std::size_t all, int ranks) : observer_(observer), all_(all), ranks_(ranks) {}
    void done_one()
    {
        ++done_;
        if (std::this_thread::get_id() != caller_)
            return;
        const auto done = std::min(done_ * static_cast<std::size_t>(ranks_), all_);
        observer_.progress(static_cast<double>(done) / static_cast<double>(all_),
                           fmt::format("{} of {} runs", done, all_));
        if (observer_.cancelled())
            cancelled_ = true;
    }
    [[nodiscard]] bool is_cancelled() const { return cancelled_; }

private:
    Observer& observer_;
    std::size_t all_;
    int ranks_;
    std::thread::id caller_ = std::this_thread::get_id();
    std::atomic<std::size_t> done_{0};
    std::atomic<bool> cancelled_{false};
};

std::optional<Moments> moments_of(Eigen::Index states, const std::vector<HeatProblem>& problems, const Ranks& ranks,
                                  int threads, Observer& observer,
                                  const std::function<Eigen::MatrixXd(const HeatProblem&)>& columns)
{
    std::vector<Eigen::MatrixXd> found(problems.size());
    Watch watch(observer, problems.size(), ranks.count());
    in_parallel(ranks, threads, problems.size(), [&](std::size_t k) {
        if (watch.is_cancelled())
            return;
        found[k] = columns(problems[k]);
        watch.done_one();
    });
    if (any(ranks, watch.is_cancelled()))
        return std::nullopt;
    Moments moments(states);
    for (const auto& block : found)
        if (block.size() > 0)
            moments.add(block);
    moments.sum_over(ranks);
    return moments;
}

}  // namespace

HeatProblem drawn_problem(const std::vector<HeatProblem>& points, const Box& box, Draws& draws)
{
    const auto count = static_cast<double>(points.size());
    auto problem = points[count > 1 ? static_cast<std::size_t>(draws.next() * count) : 0];
    set_values(problem, box, draws.values(box));
    add_swing(problem, draws.next());
    const double place = draws.next();
    if (draws.next() < 0.5)
        insert_pause(problem, 0.2 + 0.6 * place);
    return problem;
}

std::vector<HeatProblem> drawn_problems(const std::vector<HeatProblem>& points, const Box& box, unsigned long long seed,
                                        int count)
{
    Draws draws(seed);
    std::vector<HeatProblem> problems;
    for (int k = 0; k < count; ++k)
        problems.push_back(drawn_problem(points, box, draws));
    return problems;
}

std::optional<Training> train(const Terms& large, const std::vector<HeatProblem>& points, const Box& box,
                              const BuildOptions& options, const Ranks& ranks, Observer& observer)
{
    const auto states = large->terms.uniform.size();
    const auto problems = drawn_problems(points, box, training_seed, options.training_runs);
    const auto moments = [&](const std::vector<HeatProblem>& of, const auto& columns) {
        return moments_of(states, of, ranks, options.threads, observer,
                          [&](const HeatProblem& problem) { return columns(large, problem, options); });
    };
    const auto of_states = moments(problems, states_of_run);
    if (!of_states)
        return std::nullopt;
    std::vector<HeatProblem> some;
    for (std::size_t k = 0; k < problems.size(); k += static_cast<std::size_t>(options.runs_per_dual))
        some.push_back(problems[k]);
    const auto of_duals = moments(some, dual_states);
    return of_duals ? std::optional(Training{*of_states, *of_duals}) : std::nullopt;
}

}  // namespace deadpoint::reduce
