#include "deadpoint/reduce/sensitivity/sensitivity.hpp"

#include "deadpoint/error.hpp"
#include "deadpoint/heat/tr_bdf2.hpp"
#include "deadpoint/reduce/online/reduced_run.hpp"
#include "deadpoint/reduce/sensitivity/changed_rates.hpp"
#include "deadpoint/reduce/sensitivity/linearised_heat.hpp"
#include "deadpoint/reduce/sensitivity/stage_equations.hpp"

#include <string>
#include <utility>

namespace deadpoint::reduce {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using heat::bdf_middle;
using heat::bdf_now;

Eigen::Index size_of(std::size_t count) { return static_cast<Eigen::Index>(count); }

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

// A column for each output.
MatrixXd weights_of(const DenseTerms& terms, const std::vector<Output>& outputs)
{
    MatrixXd result(terms.uniform.size(), size_of(outputs.size()));
    for (std::size_t o = 0; o < outputs.size(); ++o)
        result.col(size_of(o)) = weights_of(terms, outputs[o]);
    return result;
}

/// Temperatures of parts, sumps and enclosed air at the start, per unit of a direction.
struct StartChange {
    VectorXd states, sumps, air;
};

StartChange start_of(const RecordedRun& run, const Direction& direction)
{
    const auto& parts = run.terms->terms.parts;
    StartChange result{VectorXd::Zero(run.terms->terms.uniform.size()), VectorXd::Zero(size_of(run.problem.oil.size())),
                       VectorXd::Zero(size_of(run.problem.enclosures.size()))};
    if (!direction.passing)
        return result;
    const auto& [less, more, by] = *direction.passing;
    for (Eigen::Index p = 0; p < parts.cols(); ++p) {
        const auto part = static_cast<int>(p);
        const double change = more.initial_temperature(part, {}) - less.initial_temperature(part, {});
        result.states += change / by * parts.col(p);
    }
    for (std::size_t k = 0; k < run.problem.oil.size(); ++k)
        result.sumps[size_of(k)] = (more.oil[k].sump_start - less.oil[k].sump_start) / by;
    for (std::size_t e = 0; e < run.problem.enclosures.size(); ++e)
        result.air[size_of(e)] = (more.enclosures[e].start - less.enclosures[e].start) / by;
    return result;
}

/// Derivatives of what one segment hands on to the next, or weights on it: states, sumps that feed joints, air.
struct Carried {
    MatrixXd states, sumps, air;
};

Carried nothing_carried(const RecordedRun& run, std::size_t columns)
{
    const auto zeros = [&](std::size_t rows) { return MatrixXd::Zero(size_of(rows), size_of(columns)); };
    return {zeros(static_cast<std::size_t>(run.terms->terms.uniform.size())), zeros(run.problem.oil.size()),
            zeros(run.problem.enclosures.size())};
}

Derivatives enter(const LinearisedHeat& heat, const Carried& from)
{
    Derivatives now{heat.into_basis(from.states), MatrixXd::Zero(heat.inner().count(), from.states.cols())};
    for (const auto& path : heat.inner().oil)
        if (!path.stops.empty() && path.feed != OilPath::Feed::cooler)
            now.inner.row(path.stops.front().place) = from.sumps.row(size_of(path.circuit));
    for (Eigen::Index e = 0; e < from.air.rows(); ++e)
        now.inner.row(heat.inner().air(static_cast<std::size_t>(e))) = from.air.row(e);
    return now;
}

// The transpose of each other: leave() of derivatives at a segment's end, enter() at the next one's start.
void leave(const LinearisedHeat& heat, const Derivatives& now, Carried& to)
{
    to.states = heat.from_basis(now.states);
    for (const auto& path : heat.inner().oil)
        if (!path.stops.empty() && path.feed != OilPath::Feed::cooler)
            to.sumps.row(size_of(path.circuit)) = now.inner.row(path.stops.front().place);
    for (Eigen::Index e = 0; e < to.air.rows(); ++e)
        to.air.row(e) = now.inner.row(heat.inner().air(static_cast<std::size_t>(e)));
}

/// A segment of a recorded run, linearised.
class Segment {
public:
    /// @param some_step  of the segment
    Segment(const RecordedRun& run, const std::vector<Direction>& directions, const RecordedStep& some_step,
            const LinearisedHeat* like)
        : heat(*run.terms, run.problem, some_step.record.segment, some_step.form, like), stages(heat),
          rates(heat, directions)
    {
        for (std::size_t k = 0; k < run.steps.size(); ++k)
            if (run.steps[k].record.segment == some_step.record.segment) {
                if (count++ == 0)
                    first = k;
            }
    }
    [[nodiscard]] LinearisedState at_start(const RecordedStep& step) { return at(step, step.record.start, step.start); }
    [[nodiscard]] LinearisedState at_middle(const RecordedStep& step)
    {
        return at(step, step.record.middle, step.middle);
    }
    [[nodiscard]] LinearisedState at_end(const RecordedStep& step) { return at(step, step.record.end, step.end); }

    LinearisedHeat heat;
    StageEquations stages;
    ChangedRates rates;
    std::size_t first = 0, count = 0;  ///< of its steps

private:
    [[nodiscard]] LinearisedState at(const RecordedStep& step, const heat::StageRecord& record, const VectorXd& states)
    {
        return heat.at(record, heat.into_basis(states), heat::times_of(step.record));
    }
};

// Rates of states and inner values along derivatives, but for what coefficients change.
Derivatives rates_along(const LinearisedHeat& heat, const LinearisedState& at, const Derivatives& now)
{
    return {heat.loads(at) * now.inner - heat.conduct(at, now.states),
            at.rows.transpose() * now.states + at.inner * now.inner};
}

/// Runs derivatives forward.
class Forward {
public:
    Forward(const RecordedRun& run, const std::vector<Direction>& directions, const std::vector<Output>& outputs)
        : run_(run), directions_(directions), weights_(weights_of(run.terms->terms, outputs)),
          now_(nothing_carried(run, directions.size()))
    {
        const std::vector<double> zeros(run.history.time.size(), 0.0);
        result_.assign(directions.size(), std::vector<std::vector<double>>(outputs.size(), zeros));
        for (std::size_t k = 0; k < directions.size(); ++k) {
            const auto start = start_of(run, directions[k]);
            now_.states.col(size_of(k)) = start.states;
            now_.sumps.col(size_of(k)) = start.sumps;
            now_.air.col(size_of(k)) = start.air;
        }
    }

    std::vector<std::vector<std::vector<double>>> get()
    {
        if (!run_.steps.empty())
            write(now_.states, weights_, 0, run_.steps.front().record.row);
        std::unique_ptr<Segment> before;
        for (std::size_t k = 0; k < run_.steps.size();) {
            auto segment =
                std::make_unique<Segment>(run_, directions_, run_.steps[k], before ? &before->heat : nullptr);
            go(*segment);
            k += segment->count;
            before = std::move(segment);
        }
        return std::move(result_);
    }

private:
    // A segment's first row has the values of the last row before it.
    void write(const MatrixXd& states, const MatrixXd& weights, std::size_t begin, std::size_t end)
    {
        const MatrixXd values = weights.transpose() * states;
        for (std::size_t row = begin; row < end; ++row)
            for (std::size_t k = 0; k < result_.size(); ++k)
                for (std::size_t o = 0; o < result_[k].size(); ++o)
                    result_[k][o][row] = values(size_of(o), size_of(k));
    }

    void go(Segment& segment)
    {
        const auto& first = run_.steps[segment.first];
        const MatrixXd weights = segment.heat.into_basis(weights_);
        auto start = segment.at_start(first);
        auto changes = segment.rates.at(start);
        auto now = enter(segment.heat, now_);
        segment.stages.start(start, changes.inner, now);
        for (std::size_t k = segment.first; k < segment.first + segment.count; ++k) {
            const auto& step = run_.steps[k];
            auto end = segment.at_end(step);
            auto end_changes = segment.rates.at(end);
            now = stepped(segment, step, start, changes, end, end_changes, now);
            const bool is_last = k + 1 == run_.steps.size();
            write(now.states, weights, step.record.row,
                  is_last ? run_.history.time.size() : run_.steps[k + 1].record.row);
            start = std::move(end);
            changes = std::move(end_changes);
        }
        leave(segment.heat, now, now_);
    }

    [[nodiscard]] Derivatives stepped(Segment& segment, const RecordedStep& step, const LinearisedState& start,
                                      const Derivatives& start_changes, const LinearisedState& end,
                                      const Derivatives& end_changes, const Derivatives& now) const
    {
        const double d = heat::diagonal * step.record.duration;
        auto& stages = segment.stages;
        const VectorXd scales = stages.scales(d), of_rates = stages.scales_of_rates(d);
        const auto& capacity = stages.capacity();
        const auto at_middle = segment.at_middle(step);
        const auto middle_changes = segment.rates.at(at_middle);
        const auto rates = rates_along(segment.heat, start, now);
        Derivatives middle{now.states + d * (rates.states + start_changes.states + middle_changes.states),
                           capacity.asDiagonal() * now.inner +
                               of_rates.asDiagonal() * (rates.inner + start_changes.inner) +
                               scales.asDiagonal() * middle_changes.inner};
        stages.set(d, at_middle);
        stages.solve(middle);
        Derivatives next{bdf_middle * middle.states - bdf_now * now.states + d * end_changes.states,
                         capacity.asDiagonal() * (bdf_middle * middle.inner - bdf_now * now.inner) +
                             scales.asDiagonal() * end_changes.inner};
        stages.set(d, end);
        stages.solve(next);
        return next;
    }

    const RecordedRun& run_;
    const std::vector<Direction>& directions_;
    MatrixXd weights_;
    Carried now_;
    std::vector<std::vector<std::vector<double>>> result_;
};

/// Runs weights backward.
class Backward {
public:
    Backward(const RecordedRun& run, const std::vector<Direction>& directions, const MatrixXd& on_states)
        : run_(run), directions_(directions), on_states_(on_states), now_(nothing_carried(run, 1)),
          sums_(directions.size(), 0.0)
    {}

    std::vector<double> get()
    {
        std::unique_ptr<Segment> after;
        for (std::size_t k = run_.steps.size(); k > 0;) {
            auto segment =
                std::make_unique<Segment>(run_, directions_, run_.steps[k - 1], after ? &after->heat : nullptr);
            go(*segment);
            k -= segment->count;
            after = std::move(segment);
        }
        if (!run_.steps.empty())
            now_.states += rows(0, run_.steps.front().record.row);
        for (std::size_t k = 0; k < sums_.size(); ++k) {
            const auto start = start_of(run_, directions_[k]);
            sums_[k] += start.states.dot(now_.states.col(0)) + start.sumps.dot(now_.sumps.col(0)) +
                        start.air.dot(now_.air.col(0));
        }
        return sums_;
    }

private:
    // Weights on the states at rows of the history, which all have the same states.
    [[nodiscard]] MatrixXd rows(std::size_t begin, std::size_t end) const
    {
        return on_states_.middleCols(size_of(begin), size_of(end - begin)).rowwise().sum();
    }

    void go(Segment& segment)
    {
        auto now = enter(segment.heat, now_);
        const auto last = segment.first + segment.count - 1;
        auto end = segment.at_end(run_.steps[last]);
        Derivatives at_end{MatrixXd::Zero(now.states.rows(), 1), MatrixXd::Zero(now.inner.rows(), 1)};
        for (std::size_t k = last + 1; k-- > segment.first;) {
            const auto& step = run_.steps[k];
            const bool is_last = k + 1 == run_.steps.size();
            now.states += segment.heat.into_basis(
                rows(step.record.row, is_last ? run_.history.time.size() : run_.steps[k + 1].record.row));
            auto start = segment.at_start(step);
            step_back(segment, step, start, end, at_end, now);
            end = std::move(start);
        }
        at_end.inner += segment.stages.start_transposed(end, now);
        segment.rates.add_weighted(end, at_end, sums_);
        segment.rates.finish(sums_);
        leave(segment.heat, now, now_);
    }

    // @param at_end  weights of the following step on the changes of rates at the end; becomes that at the start
    void step_back(Segment& segment, const RecordedStep& step, const LinearisedState& start, const LinearisedState& end,
                   Derivatives& at_end, Derivatives& now)
    {
        const double d = heat::diagonal * step.record.duration;
        auto& stages = segment.stages;
        const VectorXd scales = stages.scales(d), of_rates = stages.scales_of_rates(d);
        const auto& capacity = stages.capacity();
        auto second = now;
        stages.set(d, end);
        stages.solve_transposed(second);
        at_end.states += d * second.states;
        at_end.inner += scales.asDiagonal() * second.inner;
        segment.rates.add_weighted(end, at_end, sums_);

        const auto at_middle = segment.at_middle(step);
        Derivatives first{bdf_middle * second.states, bdf_middle * (capacity.asDiagonal() * second.inner)};
        stages.set(d, at_middle);
        stages.solve_transposed(first);
        segment.rates.add_weighted(at_middle, {d * first.states, scales.asDiagonal() * first.inner}, sums_);

        const MatrixXd on_rates = of_rates.asDiagonal() * first.inner;
        at_end = {d * first.states, on_rates};
        now.states = first.states - d * segment.heat.conduct(start, first.states) + start.rows * on_rates -
                     bdf_now * second.states;
        now.inner = d * (segment.heat.loads(start).transpose() * first.states) + start.inner.transpose() * on_rates +
                    capacity.asDiagonal() * (first.inner - bdf_now * second.inner);
    }

    const RecordedRun& run_;
    const std::vector<Direction>& directions_;
    const MatrixXd& on_states_;
    Carried now_;
    std::vector<double> sums_;
};

}  // namespace

RecordedRun record_run(std::shared_ptr<const PreparedTerms> terms, const HeatProblem& problem, double reference,
                       Observer& observer)
{
    RecordedRun result{std::move(terms), problem, {}, {}};
    const auto observed = static_cast<std::size_t>(result.terms->terms.observed.rows());
    ReducedRun reduced(result.terms, problem, observed, reference);
    ReducedHooks hooks;
    hooks.on_stages = [&](const heat::StepRecord& record, const States& start, const States& middle,
                          const States& end) {
        result.steps.push_back({record, start, middle, end, reduced.tridiagonal()});
    };
    result.history = reduced.go(hooks, observer);
    return result;
}

std::vector<std::vector<std::vector<double>>> forward(const RecordedRun& run, const std::vector<Direction>& directions,
                                                      const std::vector<Output>& outputs)
{
    return Forward(run, directions, outputs).get();
}

std::vector<double> gradient(const RecordedRun& run, const std::vector<Direction>& directions,
                             const std::vector<Output>& outputs, const MatrixXd& weights)
{
    if (weights.rows() != size_of(outputs.size()) || weights.cols() != size_of(run.history.time.size()))
        throw InputError("weights of a gradient need a row for each output and a column for each row of the history");
    const MatrixXd on_states = weights_of(run.terms->terms, outputs) * weights;
    return Backward(run, directions, on_states).get();
}

std::vector<double> gradient(const RecordedRun& run, const std::vector<Direction>& directions, Output output,
                             std::size_t row)
{
    if (row >= run.history.time.size())
        throw InputError("a run has no row " + std::to_string(row));
    MatrixXd weights = MatrixXd::Zero(1, size_of(run.history.time.size()));
    weights(0, size_of(row)) = 1;
    return gradient(run, directions, {output}, weights);
}

}  // namespace deadpoint::reduce
