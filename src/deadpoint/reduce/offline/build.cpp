#include "deadpoint/reduce/offline/build.hpp"

#include "deadpoint/exchange/heat.hpp"
#include "deadpoint/observer.hpp"
#include "deadpoint/reduce/offline/in_parallel.hpp"
#include "deadpoint/reduce/offline/pod.hpp"
#include "deadpoint/reduce/online/dense_system.hpp"
#include "deadpoint/reduce/online/reduced_run.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <fmt/format.h>
#include <functional>
#include <numbers>
#include <thread>

namespace deadpoint::reduce {
namespace {

constexpr double pause = 1800;   // [s]
constexpr int sets_at_base = 4;  // of the problem's own values
constexpr unsigned long long solve_seed = 1, training_seed = 2, test_seed = 3;

using Terms = std::shared_ptr<const PreparedTerms>;

Terms prepared(DenseTerms terms) { return std::make_shared<const PreparedTerms>(std::move(terms)); }

class Silent : public Observer {};

// Of the k-th set: evenly in its logarithm, and every eighth one slow enough for the steady state.
double shift_of(int k)
{
    constexpr double slowest = 1e-5, fastest = 0.5, steady = 1e-7;
    const double place = std::fmod((k + 1) * (std::numbers::phi - 1), 1.0);
    return k % 8 == 7 ? steady : slowest * std::pow(fastest / slowest, place);
}

std::vector<std::size_t> shuffled_loads(const FullModel& full, Draws& draws)
{
    std::vector<std::size_t> loads;
    for (std::size_t load = 0; load < full.load_count(); ++load)
        if (full.has_load(load))
            loads.push_back(load);
    for (std::size_t k = loads.size(); k > 1; --k)
        std::swap(loads[k - 1], loads[static_cast<std::size_t>(draws.next() * static_cast<double>(k))]);
    return loads;
}

void add_fields(FullModel& full, const HeatProblem& base, const Box& box, const BuildOptions& options,
                Observer& observer)
{
    Draws draws(solve_seed);
    const auto loads = shuffled_loads(full, draws);
    std::size_t next = 0;
    for (int set = 0; set < options.sets; ++set) {
        auto problem = base;
        const auto values = draws.values(box);
        if (set >= sets_at_base)
            set_values(problem, box, values);
        std::vector<std::size_t> chosen;
        for (int k = 0; k < options.loads_per_set; ++k)
            chosen.push_back(loads[next++ % loads.size()]);
        full.add_solutions(problem, shift_of(set), chosen);
        observer.progress((set + 1.0) / options.sets, fmt::format("{} fields", next));
    }
}

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

std::vector<HeatProblem> drawn_problems(const HeatProblem& base, const Box& box, unsigned long long seed, int count)
{
    Draws draws(seed);
    std::vector<HeatProblem> problems;
    for (int k = 0; k < count; ++k)
        problems.push_back(drawn_problem(base, box, draws));
    return problems;
}

// The states after each step, a column for each.
Eigen::MatrixXd states_of_run(const Terms& terms, const HeatProblem& problem, const BuildOptions& options)
{
    std::vector<States> states;
    Silent observer;
    ReducedRun(terms, problem, options.adjoints, options.reference)
        .go({[&](double, const States& at) { states.push_back(at); }, {}}, observer);
    Eigen::MatrixXd columns(terms->terms.uniform.size(), static_cast<Eigen::Index>(states.size()));
    for (std::size_t k = 0; k < states.size(); ++k)
        columns.col(static_cast<Eigen::Index>(k)) = states[k];
    return columns;
}

// States of the dual problem, dz/dt = -K z backward from E_SW's weights, by implicit Euler steps of two minutes to
// four hours that double; each counts alike.
Eigen::MatrixXd dual_states(const Terms& terms, const HeatProblem& problem, const BuildOptions& options)
{
    constexpr int steps = 8;
    DenseSystem system(terms, problem, options.reference);
    system.set_laws(
        problem.segments.front().interfaces.empty() ? problem.interfaces : problem.segments.front().interfaces, {});
    Eigen::MatrixXd columns(terms->terms.uniform.size(), steps);
    States state = terms->terms.observed.row(static_cast<Eigen::Index>(options.dual_row)).transpose(), next = state;
    double length = 120;
    for (int k = 0; k < steps; ++k, length *= 2) {
        system.build(length, state, {});
        system.solve(state, next, {}, {}, "the dual of E_SW");
        columns.col(k) = state = next;
    }
    columns.colwise().normalize();
    return columns;
}

Moments moments_of(Eigen::Index states, const std::vector<HeatProblem>& problems, int threads, Observer& observer,
                   const std::function<Eigen::MatrixXd(const HeatProblem&)>& columns)
{
    std::vector<Eigen::MatrixXd> found(problems.size());
    std::atomic<std::size_t> done{0};
    const auto caller = std::this_thread::get_id();
    in_parallel(threads, problems.size(), [&](std::size_t k) {
        found[k] = columns(problems[k]);
        ++done;
        if (std::this_thread::get_id() == caller)
            observer.progress(static_cast<double>(done) / static_cast<double>(problems.size()),
                              fmt::format("{} of {} runs", done.load(), problems.size()));
    });
    Moments moments(states);
    for (const auto& block : found)
        moments.add(block);
    return moments;
}

/// Runs of both models with the same problems.
class Comparison {
public:
    Comparison(const Terms& large, std::vector<HeatProblem> problems, const BuildOptions& options)
        : problems_(std::move(problems)), options_(options)
    {
        runs_ = run(large);
    }
    [[nodiscard]] std::vector<RunDifference> to(const Terms& small) const
    {
        const auto runs = run(small);
        std::vector<RunDifference> result;
        for (std::size_t k = 0; k < runs.size(); ++k)
            result.push_back(difference(runs[k], runs_[k], options_.has_dual ? options_.dual_row : SIZE_MAX));
        return result;
    }

private:
    [[nodiscard]] std::vector<ThermalHistory> run(const Terms& terms) const
    {
        std::vector<ThermalHistory> histories(problems_.size());
        in_parallel(options_.threads, problems_.size(), [&](std::size_t k) {
            Silent observer;
            histories[k] = ReducedRun(terms, problems_[k], options_.adjoints, options_.reference).go({}, observer);
        });
        return histories;
    }
    std::vector<HeatProblem> problems_;
    const BuildOptions& options_;
    std::vector<ThermalHistory> runs_;
};

std::vector<std::size_t> sizes_up_to(std::size_t largest)
{
    std::vector<std::size_t> sizes;
    for (const std::size_t size : {60U, 100U, 150U, 200U, 250U, 300U, 400U, 500U})
        if (size < largest)
            sizes.push_back(size);
    sizes.push_back(largest);
    return sizes;
}

// The smallest of the sizes that is accurate enough, else the largest.
void choose_small(BuiltModels& models, const Eigen::MatrixXd& combinations, const Comparison& comparison,
                  const BuildOptions& options)
{
    for (const auto size : sizes_up_to(static_cast<std::size_t>(combinations.cols()))) {
        models.small = prepared(
            combined(models.large->terms, combinations.leftCols(static_cast<Eigen::Index>(size)), options.small));
        const auto found = comparison.to(models.small);
        models.at_base = found.front();
        models.in_box = {};
        for (const auto& one : found)
            models.in_box.widen(one);
        models.by_size.emplace_back(size, models.in_box);
        if (models.in_box.temperature <= options.temperature && models.in_box.gap <= options.gap)
            return;
    }
}

}  // namespace

HeatProblem drawn_problem(const HeatProblem& base, const Box& box, Draws& draws)
{
    auto problem = base;
    set_values(problem, box, draws.values(box));
    add_swing(problem, draws.next());
    const double place = draws.next();
    if (draws.next() < 0.5)
        insert_pause(problem, 0.2 + 0.6 * place);
    return problem;
}

BuiltModels build(FullModel& full, const HeatProblem& base, const Box& box, const BuildOptions& options,
                  Observer& observer)
{
    observer.stage("basis");
    add_fields(full, base, box, options, observer);
    full.orthonormalise(options.least);
    observer.stage("projection");
    BuiltModels models;
    models.large = prepared(full.project(options.large));
    const auto& uniform = models.large->terms.uniform;
    const auto states = uniform.size();
    observer.stage("training runs");
    const auto problems = drawn_problems(base, box, training_seed, options.training_runs);
    const auto moments = moments_of(states, problems, options.threads, observer, [&](const HeatProblem& problem) {
        return states_of_run(models.large, problem, options);
    });
    Moments duals(states);
    if (options.has_dual)
        duals = moments_of(states, problems, options.threads, observer,
                           [&](const HeatProblem& problem) { return dual_states(models.large, problem, options); });
    observer.stage("small model");
    const auto combinations =
        most_frequent(moments, duals, options.dual_share, uniform, static_cast<Eigen::Index>(options.largest));
    auto tests = drawn_problems(base, box, test_seed, options.test_runs);
    tests.insert(tests.begin(), base);
    choose_small(models, combinations, Comparison(models.large, std::move(tests), options), options);
    full.combine(combinations.leftCols(models.small->terms.uniform.size()));
    return models;
}

}  // namespace deadpoint::reduce
