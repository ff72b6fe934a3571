#include "deadpoint/reduce/online/sensitivity.hpp"

#include "deadpoint/error.hpp"
#include "deadpoint/heat/films.hpp"
#include "deadpoint/heat/tr_bdf2.hpp"
#include "deadpoint/reduce/offline/box.hpp"
#include "deadpoint/reduce/online/linearised_heat.hpp"
#include "deadpoint/reduce/online/reduced_run.hpp"

#include <memory>

namespace deadpoint::reduce {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using heat::bdf_middle;
using heat::bdf_now;

void require_supported(const HeatProblem& problem)
{
    const auto refuse = [](const std::string& what, const std::string& remedy) {
        throw InputError("sensitivities do not take " + what + "; " + remedy);
    };
    if (!problem.oil.empty())
        refuse("the oil circuit '" + problem.oil[0].name + "'", "state the oil's temperature at its interfaces");
    if (!problem.enclosures.empty())
        refuse("the enclosed air '" + problem.enclosures[0].name + "'", "state an ambient for its surfaces");
    for (const auto& surface : problem.surfaces)
        if (heat::follows_temperature(surface))
            refuse("surface '" + surface.name + "', whose film follows the temperature",
                   "state a constant coefficient");
    for (const auto& source : problem.sources)
        if (source.share == 0)
            refuse("the source '" + source.name + "' with a share of zero", "state a small one");
}

VectorXd weights_of(const DenseTerms& terms, Output output)
{
    const auto& layout = terms.geometry.layout;
    const auto of = [](const RowMatrix& rows, std::size_t count, std::size_t row) -> VectorXd {
        if (row >= count)
            throw InputError("a run has no output " + std::to_string(row) + " of that kind");
        return rows.row(static_cast<Eigen::Index>(row)).transpose();
    };
    const auto side = [&](bool side_b) {
        return of(terms.functionals, 2 * layout.interfaces, layout.mean(output.index, side_b));
    };
    switch (output.kind) {
    case Output::Kind::probe:
        return of(terms.functionals, layout.count(), layout.probe(output.index));
    case Output::Kind::side_a:
        return side(false);
    case Output::Kind::side_b:
        return side(true);
    default:
        return of(terms.observed, static_cast<std::size_t>(terms.observed.rows()), output.index);
    }
}

/// The linearised rates of a run's segments, one at a time.
class Segments {
public:
    explicit Segments(const RecordedRun& run) : run_(run) {}
    LinearisedHeat& of(const RecordedStep& step)
    {
        if (!heat_ || heat_->segment() != step.record.segment)
            heat_ = std::make_unique<LinearisedHeat>(run_.terms->terms, run_.problem, step.record.segment);
        return *heat_;
    }

private:
    const RecordedRun& run_;
    std::unique_ptr<LinearisedHeat> heat_;
};

/// The three times of a step, linearised.
struct LinearisedStep {
    double factor = 0;
    LinearisedState start, middle, end;
};

LinearisedStep linearise(const LinearisedHeat& heat, const RecordedStep& step)
{
    const auto& record = step.record;
    return {heat::diagonal * record.duration, heat.at(record.start.time, step.start),
            heat.at(record.middle.time, step.middle), heat.at(record.end.time, step.end)};
}

/// Changes of a run's scalars along directions.
class Changes {
public:
    Changes(const RecordedRun& run, const std::vector<Direction>& directions) : run_(run), directions_(directions) {}

    [[nodiscard]] HeatScalars along(std::size_t direction, std::size_t segment, double time) const
    {
        const auto& [changed, by] = directions_[direction];
        return change_per(by, run_.problem, changed, segment, time);
    }
    /// A column per direction.
    [[nodiscard]] MatrixXd rates(const LinearisedHeat& heat, const LinearisedState& at, double time) const
    {
        MatrixXd result(run_.terms->terms.uniform.size(), static_cast<Eigen::Index>(directions_.size()));
        for (std::size_t k = 0; k < directions_.size(); ++k)
            result.col(static_cast<Eigen::Index>(k)) = heat.rate_change(at, along(k, heat.segment(), time));
        return result;
    }
    void add_weighted(const LinearisedHeat& heat, const LinearisedState& at, double time, const VectorXd& weights,
                      std::vector<double>& sums) const
    {
        const auto by_scalar = heat.scalar_weights(at, weights);
        for (std::size_t k = 0; k < directions_.size(); ++k)
            sums[k] += dot(along(k, heat.segment(), time), by_scalar);
    }

private:
    const RecordedRun& run_;
    const std::vector<Direction>& directions_;
};

MatrixXd step_forward(LinearisedHeat& heat, const RecordedStep& step, const Changes& changes, const MatrixXd& start)
{
    const auto [d, at_start, at_middle, at_end] = linearise(heat, step);
    const auto& record = step.record;
    const MatrixXd rates = changes.rates(heat, at_start, record.start.time) +
                           changes.rates(heat, at_middle, record.middle.time) + heat.apply(at_start, start);
    const MatrixXd middle = heat.solve(d, at_middle, start + d * rates);
    return heat.solve(d, at_end,
                      bdf_middle * middle - bdf_now * start + d * changes.rates(heat, at_end, record.end.time));
}

VectorXd step_back(LinearisedHeat& heat, const RecordedStep& step, const Changes& changes, const VectorXd& weights,
                   std::vector<double>& sums)
{
    const auto [d, at_start, at_middle, at_end] = linearise(heat, step);
    const auto& record = step.record;
    const VectorXd second = heat.solve_transposed(d, at_end, weights);
    const VectorXd first = heat.solve_transposed(d, at_middle, bdf_middle * second);
    changes.add_weighted(heat, at_end, record.end.time, d * second, sums);
    changes.add_weighted(heat, at_middle, record.middle.time, d * first, sums);
    changes.add_weighted(heat, at_start, record.start.time, d * first, sums);
    return first + d * heat.apply_transposed(at_start, first) - bdf_now * second;
}

}  // namespace

RecordedRun record_run(std::shared_ptr<const PreparedTerms> terms, const HeatProblem& problem, double reference,
                       Observer& observer)
{
    require_supported(problem);
    RecordedRun result{std::move(terms), problem, {}, {}};
    ReducedHooks hooks;
    hooks.on_stages = [&](const heat::StepRecord& record, const States& start, const States& middle,
                          const States& end) {
        result.steps.push_back({record, start, middle, end});
    };
    const auto observed = static_cast<std::size_t>(result.terms->terms.observed.rows());
    result.history = ReducedRun(result.terms, problem, observed, reference).go(hooks, observer);
    return result;
}

std::vector<Direction> directions(const HeatProblem& problem, const Box& box, const std::vector<double>& values)
{
    std::vector<Direction> result;
    for (std::size_t k = 0; k < box.size(); ++k) {
        auto shifted = values;
        shifted[k] += 1;
        result.push_back({problem, 1});
        set_values(result.back().changed, box, shifted);
    }
    return result;
}

std::vector<std::vector<std::vector<double>>> forward(const RecordedRun& run, const std::vector<Direction>& directions,
                                                      const std::vector<Output>& outputs)
{
    const std::size_t rows = run.history.time.size();
    const std::vector<double> zeros(rows, 0.0);
    std::vector<std::vector<std::vector<double>>> result(directions.size(),
                                                         std::vector<std::vector<double>>(outputs.size(), zeros));
    MatrixXd weights(run.terms->terms.uniform.size(), static_cast<Eigen::Index>(outputs.size()));
    for (std::size_t o = 0; o < outputs.size(); ++o)
        weights.col(static_cast<Eigen::Index>(o)) = weights_of(run.terms->terms, outputs[o]);
    const Changes changes(run, directions);
    Segments segments(run);
    MatrixXd states = MatrixXd::Zero(run.terms->terms.uniform.size(), static_cast<Eigen::Index>(directions.size()));
    for (std::size_t k = 0; k < run.steps.size(); ++k) {
        states = step_forward(segments.of(run.steps[k]), run.steps[k], changes, states);
        const MatrixXd values = weights.transpose() * states;
        // A segment's first row has the values of the last row before it.
        const std::size_t end = k + 1 < run.steps.size() ? run.steps[k + 1].record.row : rows;
        for (std::size_t row = run.steps[k].record.row; row < end; ++row)
            for (std::size_t j = 0; j < directions.size(); ++j)
                for (std::size_t o = 0; o < outputs.size(); ++o)
                    result[j][o][row] = values(static_cast<Eigen::Index>(o), static_cast<Eigen::Index>(j));
    }
    return result;
}

std::vector<double> gradient(const RecordedRun& run, const std::vector<Direction>& directions, Output output,
                             std::size_t row)
{
    if (row >= run.history.time.size())
        throw InputError("a run has no row " + std::to_string(row));
    const Changes changes(run, directions);
    Segments segments(run);
    std::vector<double> result(directions.size(), 0.0);
    VectorXd weights = weights_of(run.terms->terms, output);
    for (auto step = run.steps.rbegin(); step != run.steps.rend(); ++step)
        if (step->record.row <= row)
            weights = step_back(segments.of(*step), *step, changes, weights, result);
    return result;
}

}  // namespace deadpoint::reduce
