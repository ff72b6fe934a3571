#include "deadpoint/study/pipeline/run.hpp"

#include "deadpoint/casefile/files/write.hpp"
#include "deadpoint/core/error.hpp"
#include "deadpoint/fem/conduction/checkpoint.hpp"
#include "deadpoint/fem/space/session.hpp"
#include "deadpoint/io/vtu.hpp"
#include "deadpoint/study/drift/chain_model.hpp"
#include "deadpoint/study/drift/crank_play.hpp"
#include "deadpoint/study/drift/drift_causes.hpp"
#include "deadpoint/study/drift/gap_model.hpp"
#include "deadpoint/study/pipeline/prepare.hpp"
#include "deadpoint/study/translate/heat.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <fmt/format.h>
#include <iterator>
#include <map>

namespace deadpoint::study {
namespace {

// Wall time of the stages, in the order in which they ran.
class Stopwatch {
public:
    explicit Stopwatch(Observer& observer) : observer_(observer) {}
    void start(const std::string& stage)
    {
        stop();
        observer_.stage(stage);
        stage_ = stage;
        since_ = std::chrono::steady_clock::now();
    }
    void stop()
    {
        if (!stage_.empty())
            times_.emplace_back(stage_, seconds());
        stage_.clear();
    }
    [[nodiscard]] double seconds() const
    {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - since_).count();
    }
    [[nodiscard]] const std::vector<std::pair<std::string, double>>& times() const { return times_; }

private:
    Observer& observer_;
    std::string stage_;
    std::chrono::steady_clock::time_point since_;
    std::vector<std::pair<std::string, double>> times_;
};

std::vector<int> bodies_by_part(const Machine& machine)
{
    std::vector<std::string> names;
    std::vector<int> result;
    for (const auto& part : machine.parts) {
        auto found = std::find(names.begin(), names.end(), part.body);
        if (found == names.end())
            found = names.insert(names.end(), part.body);
        result.push_back(static_cast<int>(found - names.begin()));
    }
    return result;
}

std::vector<JointHistory> joint_histories(const casefile::Case& input, const Machine& machine,
                                          const HeatProblem& problem, const ThermalHistory& history, double whole)
{
    std::vector<double> row_area(problem.sources.size(), 0.0);
    for (std::size_t i = 0; i < machine.interfaces.size(); ++i)
        if (const auto& law = problem.interfaces[i]; law.source >= 0)
            row_area[law.source] += law.heat_weight * machine.interfaces[i].area;
    std::vector<JointHistory> result;
    std::size_t contact = 0;
    for (const auto& [name, joint] : input.joints) {
        const std::vector<double> zeros(history.time.size(), 0.0);
        JointHistory entry{name, {zeros, zeros}, zeros};
        double area = 0;
        for (const auto& interface : joint.interfaces) {
            (void)interface;
            const auto& law = problem.interfaces[contact];
            const double here = machine.interfaces[contact].area;
            for (std::size_t i = 0; i < history.time.size(); ++i) {
                for (auto of : {&Series::value, &Series::rate})
                    (entry.temperature.*of)[i] +=
                        0.5 * here * ((history.interface_a[contact].*of)[i] + (history.interface_b[contact].*of)[i]);
                if (law.source >= 0)
                    entry.heat[i] +=
                        whole * history.source_heat[law.source][i] * law.heat_weight * here / row_area[law.source];
            }
            area += here;
            ++contact;
        }
        if (area == 0)
            continue;
        for (auto of : {&Series::value, &Series::rate})
            for (double& value : entry.temperature.*of)
                value /= area;
        result.push_back(std::move(entry));
    }
    return result;
}

// Deformation and field files at the wanted times.
class FieldWriter {
public:
    FieldWriter(const casefile::Case& input, const Machine& machine, fem::Model& model, const ChainModel* chain,
                const FrameState* frame, const std::vector<fem::Adjoint>& adjoints, const RunOptions& options)
        : input_(input), machine_(machine), model_(model), chain_(chain), frame_(frame), adjoints_(adjoints),
          folder_(options.field_folder), comments_(options.comments), reference_(input.machine.initial_temperature),
          bodies_(bodies_by_part(machine))
    {}

    void write(double time, const fem::Field& field, RunResult& result)
    {
        std::vector<RigidMotion> motions(machine_.parts.size());
        std::optional<fem::Displacement> displacement;
        std::vector<fem::PointData> data;
        if (chain_ || frame_)
            displacement = model_.displacement(field, reference_);
        if (frame_)
            data = frame_->add_time(input_, time, field, *displacement, *result.frame);
        if (const auto size = model_.size(); size.deformation_cells != size.cells)
            data.clear();  // they belong to the nodes of the deformation's mesh
        if (chain_) {
            const auto growths = play_growths(*chain_, model_, adjoints_, field, reference_);
            const auto shares = play_shares(crank_play(input_), growths);
            auto closed = close_joints(machine_, model_, *chain_, *displacement, shares);
            motions = std::move(closed.motions);
            const double gap =
                model_.apply(adjoints_[drift::gap], field, reference_) + chain_->play_travel(shares, growths);
            result.adjoint_check = AdjointCheck{time, gap, closed.gap, closed.opening};
        }
        if (folder_.empty())
            return;
        const auto name = fmt::format("fields_{:04d}", result.fields.size());
        result.fields.emplace_back(time,
                                   model_.write_fields(folder_, name, field, displacement ? &*displacement : nullptr,
                                                       motions, bodies_, comments_, data));
        std::vector<PvdEntry> entries;
        for (const auto& [at, file] : result.fields)
            entries.push_back({at, file});
        if (fem::rank() == 0)
            write_pvd(folder_ + "/fields.pvd", entries);
    }

private:
    const casefile::Case& input_;
    const Machine& machine_;
    fem::Model& model_;
    const ChainModel* chain_;
    const FrameState* frame_;
    const std::vector<fem::Adjoint>& adjoints_;
    std::string folder_;
    std::vector<std::string> comments_;
    double reference_;
    std::vector<int> bodies_;
};

using ExactFields = std::map<double, fem::Field>;

// For checkpoints: as the view rounds them, but where they were handed on for more than the view.
std::vector<fem::HandedField> handed_on(const ViewRecorder& view, const ExactFields& exact)
{
    auto result = view.kept();
    std::erase_if(result, [&](const fem::HandedField& field) { return exact.contains(field.time); });
    for (const auto& [time, field] : exact)
        result.push_back({time, std::span<const double>(field.owned)});
    std::ranges::sort(result, {}, &fem::HandedField::time);
    return result;
}

void warn_about(const ThermalHistory& history, const HeatProblem& problem, Observer& observer)
{
    if (history.law_out_of_range)
        observer.warn("a friction law was used outside the temperatures its lubricant is known for; see the joint "
                      "temperatures in history.csv and extend the viscosity table");
    for (std::size_t i = 0; i < problem.surfaces.size(); ++i)
        if (history.film_out_of_range[i])
            observer.warn(fmt::format("surfaces.{}: its film law was used outside its tested range; 'deadpoint heat' "
                                      "shows where it is",
                                      problem.surfaces[i].name));
    if (history.energy.mismatch() > 1e-6 && !nothing_happens(history, problem.time_tolerance))
        observer.warn(fmt::format("the energy balance closes to {:.1e} only; lower numerics.solver_tolerance",
                                  history.energy.mismatch()));
}

}  // namespace

struct SharedModel::Implementation {
    Implementation(const Machine& m, const Machine* own) : machine(m), own_deformation(own) {}

    /// What the laws of a case come to; names and sizes go into the result.
    HeatProblem translate(const casefile::Case& input, Stopwatch& watch, RunResult& result, Observer& observer) const;
    /// Unknowns, dimension chain and adjoints, where they are not there yet.
    void need_model(const casefile::Case& input, Stopwatch& watch, Observer& observer);
    RunResult run(const casefile::Case& input, const RunOptions& options, Observer& observer);

    /// The machine whose mesh the deformation lives on.
    [[nodiscard]] const Machine& deformed() const { return own_deformation ? *own_deformation : machine; }

    const Machine& machine;
    const Machine* own_deformation;
    std::optional<fem::Model> model;
    std::optional<ChainModel> chain;
    std::optional<GapModel> gaps;
    std::optional<FrameState> frame;
    std::vector<fem::Adjoint> adjoints;    ///< of the chain's dimensions and plays, of the gaps, of the frame
    std::size_t frame_adjoints = 0;        ///< where those of the frame begin
    std::optional<HeatProblem> assembled;  ///< that the prepared matrices are of
};

HeatProblem SharedModel::Implementation::translate(const casefile::Case& input, Stopwatch& watch, RunResult& result,
                                                   Observer& observer) const
{
    result.whole = machine.half_model ? 2 : 1;
    for (const auto& part : machine.parts)
        result.parts.push_back(part.name);
    if (const int segment = first_running_segment(input); segment >= 0 && has_loads(input)) {
        watch.start("loads");
        result.loads = compute_loads(input, &machine, segment);
        for (const auto& warning : result.loads->warnings)
            observer.warn(warning);
    }
    watch.start("laws");
    const auto* loads = result.loads ? &*result.loads : nullptr;
    FrictionLaws friction(input, &machine, loads);
    auto problem = describe_heat(input, machine, observer, loads, friction);
    if (!input.friction.empty())
        result.friction = friction.summaries();
    for (const auto& warning : friction.warnings(result.friction))
        observer.warn(warning);
    for (const auto& probe : problem.probes)
        result.probes.push_back(probe.name);
    for (const auto& source : problem.sources)
        result.sources.push_back(source.name);
    for (const auto& heat : problem.body_heat)
        result.body_heat.push_back(heat.name);
    for (const auto& circuit : problem.oil)
        result.oil.push_back(circuit.name);
    for (const auto& enclosure : problem.enclosures)
        result.enclosures.push_back(enclosure.name);
    watch.stop();
    return problem;
}

void SharedModel::Implementation::need_model(const casefile::Case& input, Stopwatch& watch, Observer& observer)
{
    if (model)
        return;
    watch.start("unknowns");
    model.emplace(machine, describe_materials(input, machine), describe_orders(input, machine), observer,
                  own_deformation, describe_orders(case_of_deformation(input), deformed()));
    model->support(describe_foundation(input, deformed()));
    if (input.chain) {
        watch.start("dimension chain");
        chain.emplace(input, deformed());
        gaps = describe_gaps(input, deformed(), *chain);
        auto functionals = chain->dimensions;
        functionals.insert(functionals.end(), gaps->functionals.begin(), gaps->functionals.end());
        adjoints = model->adjoints(functionals);
    }
    frame_adjoints = adjoints.size();
    if (has_frame_state(input)) {
        watch.start("frame");
        frame.emplace(input, deformed(), *model);
        std::ranges::copy(frame->adjoints(), std::back_inserter(adjoints));
    }
    watch.stop();
}

RunResult SharedModel::Implementation::run(const casefile::Case& input, const RunOptions& options, Observer& observer)
{
    RunResult result;
    Stopwatch watch(observer);
    const double reference = input.machine.initial_temperature;
    const auto play = input.chain ? crank_play(input) : drift::BearingPlay{};
    auto problem = translate(input, watch, result, observer);
    need_model(input, watch, observer);
    result.cells = model->size().cells;
    result.heat_unknowns = model->size().heat_unknowns;
    if (chain)
        result.sensitivity = chain->sensitivity;
    if (frame)
        result.frame = frame->start();
    if (chain || frame) {
        result.deformation_cells = model->size().deformation_cells;
        result.deformation_unknowns = model->size().deformation_unknowns;
    }

    const auto written_times = problem.field_times;
    const auto viewed_times = options.view ? view_times(problem.segments) : std::vector<double>{};
    std::vector<double> shown_times;
    std::ranges::set_union(written_times, viewed_times, std::back_inserter(shown_times));
    problem.field_times.clear();
    std::ranges::set_union(shown_times, options.kept_times, std::back_inserter(problem.field_times));

    watch.start("heat matrices");
    model->assemble_heat(problem);
    if (!options.start_from.empty())
        model->start_from(options.start_from);

    watch.start("time steps");
    double end = 0;
    for (const auto& segment : problem.segments)
        end += segment.duration;
    ExactFields exact;
    FieldWriter writer(input, machine, *model, chain ? &*chain : nullptr, frame ? &*frame : nullptr, adjoints, options);
    ViewRecorder view;
    std::vector<std::pair<double, fem::Field>> kept;
    double field_seconds = 0;
    const fem::CheckpointPlan checkpoints{options.checkpoint_file, casefile::case_hash(input),
                                          options.checkpoint_interval, options.resume,
                                          [&] { return handed_on(view, exact); }};
    const bool keeps = !checkpoints.file.empty();
    result.thermal = model->heat(
        adjoints, reference, chain ? fem::Attribution(drift::gap, 1 + chain->bearings()) : -1, observer,
        [&](double time) { observer.progress(time / end, fmt::format("t = {:.2f} h", time / 3600)); },
        [&](double time, const fem::Field& field) {
            const double before = watch.seconds();
            const bool viewed = std::ranges::binary_search(viewed_times, time);
            const bool written = std::ranges::binary_search(written_times, time);
            if (viewed)
                view.add(time, field);
            if (std::ranges::binary_search(options.kept_times, time))
                kept.emplace_back(time, field);
            if (written)
                writer.write(time, field, result);
            if (keeps && (written || !viewed))
                exact.emplace(time, field);
            field_seconds += watch.seconds() - before;
        },
        keeps ? &checkpoints : nullptr);
    watch.stop();
    if (!options.state_file.empty())
        model->write_state(options.state_file);

    result.timings = watch.times();
    result.timings.back().second -= field_seconds;
    if (field_seconds > 0)
        result.timings.emplace_back("fields", field_seconds);
    if (chain)
        result.drift = drift_series(*chain, play, result.thermal);
    if (chain && options.causes && input.output.causes && !result.thermal.interrupted) {
        watch.start("causes");
        result.causes = drift_causes(input, problem, *result.drift, *model, [&](std::size_t row) {
            return gap_adjoint(*chain, adjoints, play_shares(play, play_growths(*chain, result.thermal, row)));
        });
        watch.stop();
        result.timings.push_back(watch.times().back());
    }
    model->release_heat();
    if (!view.empty()) {
        watch.start("view");
        CloseJoints close;
        std::vector<double> shares_at_end;  // the view is linear in the temperature
        if (chain) {
            shares_at_end = play_shares(play, play_growths(*chain, result.thermal, result.thermal.time.size() - 1));
            close = [&](const fem::Displacement& u) {
                return close_joints(machine, *model, *chain, u, shares_at_end).motions;
            };
        }
        result.view = view.finish(machine, *model, reference, close);
        watch.stop();
        result.timings.push_back(watch.times().back());
    }
    if (options.at_end)
        options.at_end({machine, *model, problem, chain ? &*chain : nullptr, play, adjoints, kept, reference});
    result.elastic_iterations = model->elastic_iterations();
    result.joints = joint_histories(input, machine, problem, result.thermal, result.whole);
    if (chain) {
        result.gaps =
            gap_series(input, *gaps, result.thermal, static_cast<int>(chain->dimensions.size()), *result.drift);
        if (const auto warning = play_warning(input, *chain, result.thermal))
            observer.warn(*warning);
        for (const auto& warning : gap_warnings(result.gaps))
            observer.warn(warning);
    }
    if (result.frame) {
        read_courses(result.thermal, frame_adjoints, *result.frame);
        warn_about_frame(input, result.thermal, *result.frame, observer);
    }
    result.ranks = fem::ranks();
    result.peak_memory = fem::peak_memory();
    warn_about(result.thermal, problem, observer);
    for (const auto& warning : material_warnings(input, machine, result.thermal))
        observer.warn(warning);
    return result;
}

SharedModel::SharedModel(const Machine& machine, const Machine* deformation)
    : implementation_(std::make_unique<Implementation>(machine, deformation))
{}
SharedModel::~SharedModel() = default;
SharedModel::SharedModel(SharedModel&&) noexcept = default;

void SharedModel::prepare(const casefile::Case& input, Observer& observer)
{
    auto& it = *implementation_;
    RunResult unused;
    Stopwatch watch(observer);
    it.assembled = it.translate(input, watch, unused, observer);
    it.need_model(input, watch, observer);
    watch.start("heat matrices");
    it.model->assemble_heat(*it.assembled);
    watch.stop();
}

RunResult SharedModel::run(const casefile::Case& input, const RunOptions& options, Observer& observer)
{
    return implementation_->run(input, options, observer);
}

std::string shared_part(const casefile::Case& input)
{
    auto shared = input;
    casefile::Segment standing;
    for (const auto& segment : input.operation)
        standing.speed = segment.speed > 0 ? 1 : standing.speed;
    shared.operation = {standing};
    shared.machine.name.clear();
    shared.machine.description.clear();
    shared.machine.ambient = shared.machine.initial_temperature = casefile::MachineSection{}.ambient;
    for (auto& [name, joint] : shared.joints) {
        joint.friction.clear();
        joint.oil_temperature = casefile::Joint{}.oil_temperature;
        joint.clearance.reset();
    }
    if (shared.chain) {
        shared.chain->press_stiffness.reset();
        shared.chain->bearing_play.clear();
    }
    shared.friction.clear();
    shared.oil.clear();
    shared.oil_circuits.clear();
    shared.heat_sources.clear();
    shared.crankshaft.reset();
    shared.process_force.reset();
    const auto stress = shared.output.stress;
    shared.output = {};
    shared.output.stress = input.output.stress;  // by it the model watches the frame
    shared.output.stress = stress;
    shared.reference.reset();
    const auto order = shared.numerics.order;
    const auto size = shared.numerics.size;
    const auto seam_tolerance = shared.numerics.seam_tolerance;
    const auto deformation_size = shared.numerics.deformation_size;
    const auto deformation_order = shared.numerics.deformation_order;
    shared.numerics = {};
    shared.numerics.order = order;
    shared.numerics.size = size;
    shared.numerics.seam_tolerance = seam_tolerance;
    shared.numerics.deformation_size = deformation_size;
    shared.numerics.deformation_order = deformation_order;
    return casefile::write_case(shared);
}

RunResult run_case(const casefile::Case& input, const Machine& machine, const RunOptions& options, Observer& observer,
                   const Machine* deformation)
{
    return SharedModel(machine, deformation).run(input, options, observer);
}

}  // namespace deadpoint::study
