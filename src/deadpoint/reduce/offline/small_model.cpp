#include "deadpoint/reduce/offline/small_model.hpp"

#include "deadpoint/exchange/heat.hpp"
#include "deadpoint/observer.hpp"
#include "deadpoint/reduce/offline/build_options.hpp"
#include "deadpoint/reduce/offline/pod.hpp"
#include "deadpoint/reduce/offline/training.hpp"
#include "deadpoint/reduce/offline/typical_heat.hpp"
#include "deadpoint/reduce/online/reduced_run.hpp"
#include "deadpoint/reduce/parallel/in_parallel.hpp"
#include "deadpoint/reduce/parallel/ranks.hpp"

#include <cstdint>
#include <utility>

namespace deadpoint::reduce {
namespace {

constexpr unsigned long long test_seed = 3;

using Terms = std::shared_ptr<const PreparedTerms>;

/// Runs of both models with the same problems.
class Comparison {
public:
    Comparison(const Terms& large, std::vector<HeatProblem> problems, const BuildOptions& options, const Ranks& ranks)
        : problems_(std::move(problems)), options_(options), ranks_(ranks)
    {
        runs_ = run(large);
    }
    [[nodiscard]] std::vector<RunDifference> to(const Terms& small) const
    {
        const auto runs = run(small);
        Eigen::MatrixXd found = Eigen::MatrixXd::Zero(2, static_cast<Eigen::Index>(runs.size()));
        for (std::size_t k = 0; k < runs.size(); ++k) {
            const auto one = difference(runs[k], runs_[k], options_.has_dual ? options_.dual_row : SIZE_MAX);
            found.col(static_cast<Eigen::Index>(k)) << one.temperature, one.gap;
        }
        ranks_.sum(found);
        std::vector<RunDifference> result;
        for (const auto& one : found.colwise())
            result.push_back({one[0], one[1]});
        return result;
    }

private:
    // This rank's share of the runs; the others are empty.
    [[nodiscard]] std::vector<ThermalHistory> run(const Terms& terms) const
    {
        std::vector<ThermalHistory> histories(problems_.size());
        in_parallel(ranks_, options_.threads, problems_.size(), [&](std::size_t k) {
            Observer observer;
            histories[k] = ReducedRun(terms, problems_[k], options_.adjoints, options_.reference).go({}, observer);
        });
        return histories;
    }
    std::vector<HeatProblem> problems_;
    const BuildOptions& options_;
    const Ranks& ranks_;
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

Terms small_of(const DenseTerms& large, const Eigen::MatrixXd& combinations, const TypicalHeat& typical, double least,
               const Ranks& ranks)
{
    DenseTerms terms;
    terms.geometry = large.geometry;
    if (ranks.rank() == 0) {
        const Eigen::MatrixXd moments = combinations.transpose() * typical.moments * combinations;
        terms = combined(large, combinations);
        cut_terms(terms, {moments, typical.highest}, least);
    }
    share(ranks, terms);
    return std::make_shared<const PreparedTerms>(std::move(terms));
}

}  // namespace

std::optional<SmallModel> choose_small(const Terms& large, const Eigen::MatrixXd& combinations,
                                       const TypicalHeat& typical, const std::vector<HeatProblem>& points,
                                       const Box& box, const BuildOptions& options, const Ranks& ranks,
                                       Observer& observer)
{
    auto tests = drawn_problems(points, box, test_seed, options.test_runs);
    tests.insert(tests.begin(), points.front());
    const Comparison comparison(large, std::move(tests), options, ranks);
    SmallModel model;
    for (const auto size : sizes_up_to(static_cast<std::size_t>(combinations.cols()))) {
        if (any(ranks, observer.cancelled()))
            return std::nullopt;
        model.combinations = on_first(
            ranks, [&] { return by_conduction(large->terms, combinations.leftCols(static_cast<Eigen::Index>(size))); });
        model.terms = small_of(large->terms, model.combinations, typical, options.least_heat.of_small, ranks);
        const auto found = comparison.to(model.terms);
        model.at_base = found.front();
        model.in_box = {};
        for (const auto& one : found)
            model.in_box.widen(one);
        model.by_size.emplace_back(size, model.in_box);
        if (model.in_box.temperature <= options.temperature && model.in_box.gap <= options.gap)
            break;
    }
    return model;
}

}  // namespace deadpoint::reduce
