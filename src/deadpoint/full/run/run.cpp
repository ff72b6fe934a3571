#include "deadpoint/full/run/run.hpp"

#include "deadpoint/core/mistakes.hpp"
#include "deadpoint/core/stopwatch.hpp"
#include "deadpoint/crankshaft/shaft/system.hpp"
#include "deadpoint/drift/play.hpp"
#include "deadpoint/exchange/heat_causes.hpp"
#include "deadpoint/fem/algebra/session.hpp"
#include "deadpoint/fem/conduction/checkpoint.hpp"
#include "deadpoint/fem/model.hpp"
#include "deadpoint/full/fields/lift_fields.hpp"
#include "deadpoint/full/fields/run_fields.hpp"
#include "deadpoint/full/frame/chain_on_mesh.hpp"
#include "deadpoint/full/frame/frame_state.hpp"
#include "deadpoint/full/model/model_parts.hpp"
#include "deadpoint/full/run/reduce.hpp"
#include "deadpoint/full/run/run_mark.hpp"
#include "deadpoint/observer.hpp"
#include "deadpoint/press/drift/chain_model.hpp"
#include "deadpoint/press/drift/chain_series.hpp"
#include "deadpoint/press/drift/crank_play.hpp"
#include "deadpoint/press/drift/drift_causes.hpp"
#include "deadpoint/press/drift/frame_courses.hpp"
#include "deadpoint/press/drift/gap_model.hpp"
#include "deadpoint/press/laws/friction.hpp"
#include "deadpoint/press/problem/heat.hpp"
#include "deadpoint/press/result/histories.hpp"
#include "deadpoint/press/result/loads_result.hpp"
#include "deadpoint/press/result/run_result.hpp"
#include "deadpoint/press/run/run_warnings.hpp"
#include "deadpoint/press/translate/materials.hpp"
#include "deadpoint/tribology/friction/duty.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <numeric>
#include <optional>

namespace deadpoint::full {
namespace {

/// One run on a shared model: its computations in order, and its intermediate data.
class CaseRun {
public:
    CaseRun(ModelParts& parts, const casefile::Case& input, const RunOptions& options, Observer& observer)
        : parts_(parts), input_(input), options_(options), observer_(observer), watch_(observer),
          play_(input.chain ? press::crank_play(input) : drift::BearingPlay{}),
          problem_(parts.translate(input, watch_, result_, observer)), mark_(run_mark(input))
    {}

    press::RunResult run()
    {
        parts_.need_model(input_, watch_, observer_);
        note_sizes();
        choose_times();
        assemble();
        march();
        follow_gap();
        parts_.model->release_heat();
        make_view();
        if (options_.on_finish)
            options_.on_finish({parts_.machine, *parts_.model, problem_, parts_.chain_or_none(), play_, parts_.adjoints,
                                fields_->kept(), reference()});
        follow_clearances();
        finish();
        return std::move(result_);
    }

private:
    /// Temperature without deformation [K].
    [[nodiscard]] double reference() const { return input_.machine.initial_temperature; }

    void note_sizes()
    {
        parts_.note_sizes(result_);
        if (parts_.chain)
            result_.sensitivity = parts_.chain->sensitivity;
        result_.compliance = parts_.compliance;
        if (parts_.frame)
            result_.frame = parts_.frame->start();
    }

    void choose_times()
    {
        press::FieldTimes times(problem_, options_.view, options_.kept_times);
        if (!options_.resume_from.empty()) {
            const auto former = fem::checkpoint_head(options_.resume_from, mark_);
            times.continue_from(former.time, former.fields.written, former.fields.viewed);
        }
        problem_.field_times = times.all;
        planned_ = {times.written, times.viewed};
        fields_.emplace(input_, parts_, std::move(times),
                        press::FieldOptions{options_.field_folder, options_.comments, keeps()});
    }

    void assemble()
    {
        watch_.start("heat matrices");
        parts_.model->assemble_heat(problem_);
        if (!options_.start_from.empty())
            parts_.model->start_from(options_.start_from);
    }

    void march()
    {
        watch_.start("time steps");
        const double end = std::accumulate(problem_.segments.begin(), problem_.segments.end(), 0.0,
                                           [](double sum, const auto& segment) { return sum + segment.duration; });
        const fem::CheckpointPlan checkpoints{
            options_.checkpoint_file, mark_,    options_.checkpoint_interval,        options_.resume_from,
            options_.kept_checkpoint, planned_, [&] { return fields_->handed_on(); }};
        double field_seconds = 0;
        result_.thermal = parts_.model->heat(
            parts_.adjoints, reference(),
            parts_.chain ? fem::Attribution(drift::gap, 1 + parts_.chain->bearings()) : -1, observer_,
            [&](double time) { observer_.progress(time / end, fmt::format("t = {:.2f} h", time / 3600)); },
            [&](double time, const fem::Field& field) {
                const double before = watch_.seconds();
                fields_->take(time, field, result_);
                field_seconds += watch_.seconds() - before;
            },
            keeps() ? &checkpoints : nullptr);
        watch_.stop();
        if (!options_.state_file.empty())
            parts_.model->write_state(options_.state_file);
        watch_.split_last("fields", field_seconds);
    }

    [[nodiscard]] bool keeps() const
    {
        return !options_.checkpoint_file.empty() || !options_.resume_from.empty() || !options_.kept_checkpoint.empty();
    }

    /// Computes the dimension chain over time and its contributions.
    void follow_gap()
    {
        if (!parts_.chain)
            return;
        result_.drift = press::drift_series(parts_.chain->figures(), play_, result_.thermal);
        if (!options_.causes || !input_.output.causes || result_.thermal.interrupted)
            return;
        watch_.start("causes");
        result_.causes = press::drift_causes(input_, problem_, *result_.drift, [&](std::size_t row) {
            const auto weights = gap_adjoint(*parts_.chain, parts_.adjoints, shares_at(row));
            return press::causes_on_basis(input_.output, result_.heat_unknowns)
                       ? parts_.model->heat_causes_on_basis(weights, row)
                       : parts_.model->heat_causes(weights, row);
        });
        watch_.stop();
    }

    [[nodiscard]] std::vector<double> shares_at(std::size_t row) const
    {
        return press::play_shares(play_, play_growths(parts_.chain->figures(), result_.thermal, row));
    }

    void make_view()
    {
        if (!fields_->has_view())
            return;
        watch_.start("view");
        fields_->make_view(result_);
        watch_.stop();
    }

    /// Computes corners, clearances and the force at a fixed die height.
    void follow_clearances()
    {
        if (!parts_.chain)
            return;
        result_.gaps = press::gap_series(input_, *parts_.gaps, result_.thermal,
                                         static_cast<int>(parts_.chain->dimensions.size()), *result_.drift);
    }

    void finish()
    {
        if (result_.frame) {
            press::read_courses(result_.thermal, parts_.frame_adjoints, *result_.frame);
            press::warn_about_frame(input_, result_.thermal, *result_.frame, observer_);
        }
        static_cast<press::Histories&>(result_) =
            press::name_histories(input_, parts_.machine, problem_, result_.thermal, result_.symmetry_factor);
        parts_.note_work(result_);
        result_.timings = watch_.times();
        const auto chain = parts_.chain ? std::optional(parts_.chain->figures()) : std::nullopt;
        press::finish_run(input_, parts_.machine, problem_, chain ? &*chain : nullptr, result_, observer_);
    }

    ModelParts& parts_;
    const casefile::Case& input_;
    const RunOptions& options_;
    Observer& observer_;
    press::RunResult result_;
    Stopwatch watch_;
    drift::BearingPlay play_;
    HeatProblem problem_;
    fem::RunMark mark_;
    fem::PlannedFields planned_;
    std::optional<RunFields> fields_;
};

}  // namespace

struct SharedModel::Implementation : ModelParts {
    using ModelParts::ModelParts;
};

SharedModel::SharedModel(const Machine& machine, const Machine* deformation)
    : implementation_(std::make_unique<Implementation>(machine, deformation))
{}
SharedModel::~SharedModel() = default;
SharedModel::SharedModel(SharedModel&&) noexcept = default;

void SharedModel::check(const casefile::Case& input, Observer& observer)
{
    press::RunResult unused;
    Stopwatch watch(observer);
    implementation_->translate(input, watch, unused, observer);
}

void SharedModel::prepare(const casefile::Case& input, Observer& observer)
{
    auto& it = *implementation_;
    press::RunResult unused;
    Stopwatch watch(observer);
    it.assembled = it.translate(input, watch, unused, observer);
    it.need_model(input, watch, observer);
    watch.start("heat matrices");
    it.model->assemble_heat(*it.assembled);
    watch.stop();
}

press::RunResult SharedModel::run(const casefile::Case& input, const RunOptions& options, Observer& observer)
{
    return CaseRun(*implementation_, input, options, observer).run();
}

std::optional<twin::Reduction> SharedModel::reduce(const casefile::Case& input, const ReduceOptions& options,
                                                   Observer& observer)
{
    return reduce_case(*implementation_, input, options, observer);
}

void SharedModel::lift(const casefile::Case& input, const std::string& file, const twin::ReducedStates& run,
                       const press::FieldOptions& options, press::RunResult& result, Observer& observer)
{
    lift_fields(*implementation_, input, file, run, options, result, observer);
}

press::RunResult run_case(const casefile::Case& input, const Machine& machine, const RunOptions& options,
                          Observer& observer, const Machine* deformation)
{
    return SharedModel(machine, deformation).run(input, options, observer);
}

}  // namespace deadpoint::full
