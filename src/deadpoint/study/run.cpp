#include "deadpoint/study/run.hpp"

#include "deadpoint/core/error.hpp"
#include "deadpoint/core/vtu.hpp"
#include "deadpoint/drift/chain.hpp"
#include "deadpoint/fem/model.hpp"
#include "deadpoint/fem/session.hpp"
#include "deadpoint/mechanism/bottom_dead_point.hpp"
#include "deadpoint/mechanism/planar_system.hpp"
#include "deadpoint/study/translate_heat.hpp"
#include "deadpoint/study/translate_linkage.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <fmt/format.h>
#include <iterator>

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

// The linkage at bottom dead point and what the deformation moves in it.
struct Chain {
    Linkage linkage;
    mechanism::PlanarSystem system;
    BottomDeadPointSensitivity sensitivity;
    drift::ChainDescription description;
    std::vector<Functional> dimensions;
    std::vector<Functional> centres;  ///< per joint: in body a (x, y), in body b (x, y)
    Functional growth;                ///< of the clearance, out of E_BC

    Chain(const casefile::Case& input, const Machine& machine)
        : linkage(describe_linkage(input)), system(linkage), sensitivity(mechanism::bottom_dead_point(linkage)),
          description(describe_chain(input, machine, linkage)),
          dimensions(drift::chain_functionals(machine, linkage, sensitivity, description))
    {
        require_assembled_there();
        for (int j = 0; j < static_cast<int>(linkage.joints.size()); ++j) {
            auto fitted = drift::joint_centres(machine, linkage, sensitivity, j, description.joints[j]);
            for (auto& centre : {fitted.in_a, fitted.in_b})
                for (const auto& component : centre)
                    centres.push_back(component);
        }
        growth = drift::clearance_growth(machine, sensitivity, description);
    }

    void require_assembled_there() const
    {
        if (std::abs(sensitivity.crank_angle) > 1e-3)
            throw InputError(fmt::format(
                "the case's joints are not placed at bottom dead point: the crank would have to turn by {:.3f} "
                "degrees to get there; give all coordinates at bottom dead point",
                sensitivity.crank_angle * 57.29577951308232));
    }

    [[nodiscard]] std::vector<mechanism::CentreShift> shifts(const std::vector<double>& centre_values,
                                                             double growth_value) const
    {
        std::vector<mechanism::CentreShift> result;
        for (std::size_t j = 0; j < linkage.joints.size(); ++j)
            result.push_back({{centre_values[4 * j], centre_values[4 * j + 1]},
                              {centre_values[4 * j + 2], centre_values[4 * j + 3]}});
        auto& crank = result[description.crank_joint];
        auto& ground = linkage.joints[description.crank_joint].body_b == linkage.ground ? crank.in_b : crank.in_a;
        ground = ground + growth_value * description.pressed;
        return result;
    }
};

// Rigid motions of the mechanism's bodies, by part of the machine.
std::vector<RigidMotion> motions_by_part(const Machine& machine, const Linkage& linkage,
                                         const std::vector<PlanarPose>& motion)
{
    std::vector<RigidMotion> result(machine.parts.size());
    for (std::size_t p = 0; p < machine.parts.size(); ++p) {
        const auto body = std::find(linkage.bodies.begin(), linkage.bodies.end(), machine.parts[p].body);
        if (body == linkage.bodies.end() || body - linkage.bodies.begin() == linkage.ground)
            continue;
        const auto& pose = motion[static_cast<std::size_t>(body - linkage.bodies.begin())];
        result[p] = {pose.translation, pose.angle, {0, 0}};
    }
    return result;
}

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

// Largest distance between the two centres of a joint once the bodies have moved.
double largest_opening(const Chain& chain, const std::vector<mechanism::CentreShift>& shifts,
                       const std::vector<PlanarPose>& motion)
{
    double largest = 0;
    for (std::size_t j = 0; j < chain.linkage.joints.size(); ++j) {
        const auto& joint = chain.linkage.joints[j];
        const auto moved = [&](int body, const Vec2& shift) {
            const auto& m = motion[body];
            const Vec2& c = joint.centre;
            return shift + m.translation + m.angle * Vec2{-c[1], c[0]};
        };
        const Vec2 opening = moved(joint.body_a, shifts[j].in_a) - moved(joint.body_b, shifts[j].in_b);
        if (joint.kind == LinkageJoint::Kind::revolute)
            largest = std::max(largest, norm(opening));
        else
            largest = std::max(largest, std::abs(dot(opening, Vec2{-joint.direction[1], joint.direction[0]})));
    }
    return largest;
}

DriftSeries drift_series(const ThermalHistory& history)
{
    DriftSeries drift;
    drift.time = history.time;
    const auto& f = history.functionals;
    drift.bearing_to_ground = f[drift::bearing_to_ground];
    drift.table_to_ground = f[drift::table_to_ground];
    drift.clearance = f[drift::clearance];
    drift.gap = f[drift::gap];
    drift.crank_to_slide = f[drift::bearing_to_ground];
    for (auto values : {&Series::value, &Series::rate})
        for (std::size_t i = 0; i < history.time.size(); ++i)
            (drift.crank_to_slide.*values)[i] -= (f[drift::clearance].*values)[i] + (f[drift::slide_height].*values)[i];
    drift.by_part = history.contributions;
    return drift;
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
        JointHistory entry{name, std::vector<double>(history.time.size(), 0.0), {}};
        entry.heat = entry.temperature;
        double area = 0;
        for (const auto& interface : joint.interfaces) {
            (void)interface;
            const auto& law = problem.interfaces[contact];
            const double here = machine.interfaces[contact].area;
            for (std::size_t i = 0; i < history.time.size(); ++i) {
                entry.temperature[i] +=
                    0.5 * here * (history.interface_a[contact].value[i] + history.interface_b[contact].value[i]);
                if (law.source >= 0)
                    entry.heat[i] +=
                        whole * history.source_heat[law.source][i] * law.heat_weight * here / row_area[law.source];
            }
            area += here;
            ++contact;
        }
        if (area == 0)
            continue;
        for (double& value : entry.temperature)
            value /= area;
        result.push_back(std::move(entry));
    }
    return result;
}

// What closes the joints again after a deformation.
struct Closing {
    std::vector<RigidMotion> motions;  ///< per part
    double gap = 0;                    ///< E_SW, straight from the deformation [m]
    double opening = 0;                ///< largest distance of two centres of a joint that is left [m]
};

Closing close_joints(const Machine& machine, fem::Model& model, const Chain& chain,
                     const fem::Displacement& displacement)
{
    auto wanted = chain.centres;
    wanted.push_back(chain.growth);
    wanted.push_back(chain.dimensions[drift::gap]);
    auto values = model.evaluate(wanted, displacement);
    const double gap = values.back();
    values.pop_back();
    const double growth = values.back();
    values.pop_back();
    const auto shifts = chain.shifts(values, growth);
    const auto motion = chain.system.closing_motion(chain.system.assembled(), shifts);
    return {motions_by_part(machine, chain.linkage, motion), gap, largest_opening(chain, shifts, motion)};
}

// Deformation and field files at the wanted times.
class FieldWriter {
public:
    FieldWriter(const casefile::Case& input, const Machine& machine, fem::Model& model, const Chain* chain,
                const std::vector<fem::Adjoint>& adjoints, const RunOptions& options)
        : machine_(machine), model_(model), chain_(chain), adjoints_(adjoints), folder_(options.field_folder),
          comments_(options.comments), reference_(input.machine.initial_temperature), bodies_(bodies_by_part(machine))
    {}

    void write(double time, const fem::Field& field, RunResult& result)
    {
        std::vector<RigidMotion> motions(machine_.parts.size());
        std::optional<fem::Displacement> displacement;
        if (chain_) {
            displacement = model_.displacement(field, reference_);
            auto closed = close_joints(machine_, model_, *chain_, *displacement);
            motions = std::move(closed.motions);
            result.adjoint_check =
                AdjointCheck{time, model_.apply(adjoints_[drift::gap], field, reference_), closed.gap, closed.opening};
        }
        if (folder_.empty())
            return;
        const auto name = fmt::format("fields_{:04d}", result.fields.size());
        result.fields.emplace_back(time,
                                   model_.write_fields(folder_, name, field, displacement ? &*displacement : nullptr,
                                                       motions, bodies_, comments_));
        std::vector<PvdEntry> entries;
        for (const auto& [at, file] : result.fields)
            entries.push_back({at, file});
        if (fem::rank() == 0)
            write_pvd(folder_ + "/fields.pvd", entries);
    }

private:
    const Machine& machine_;
    fem::Model& model_;
    const Chain* chain_;
    const std::vector<fem::Adjoint>& adjoints_;
    std::string folder_;
    std::vector<std::string> comments_;
    double reference_;
    std::vector<int> bodies_;
};

}  // namespace

RunResult run_case(const casefile::Case& input, const Machine& machine, const RunOptions& options, Observer& observer)
{
    RunResult result;
    result.whole = machine.half_model ? 2 : 1;
    for (const auto& part : machine.parts)
        result.parts.push_back(part.name);
    Stopwatch watch(observer);
    const double reference = input.machine.initial_temperature;

    if (const int segment = first_running_segment(input); segment >= 0 && has_loads(input)) {
        watch.start("loads");
        result.loads = compute_loads(input, &machine, segment);
        for (const auto& warning : result.loads->warnings)
            observer.warn(warning);
    }

    watch.start("unknowns");
    fem::Model model(machine, describe_materials(input, machine), input.numerics.order, observer);
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
    result.cells = model.size().cells;
    result.heat_unknowns = model.size().heat_unknowns;

    std::optional<Chain> chain;
    std::vector<fem::Adjoint> adjoints;
    if (input.chain) {
        watch.start("dimension chain");
        chain.emplace(input, machine);
        result.sensitivity = chain->sensitivity;
        model.support(surface_index(machine, input.chain->ground_surface));
        adjoints = model.adjoints(chain->dimensions);
    }

    const auto written_times = problem.field_times;
    const auto viewed_times = options.view ? view_times(problem.segments) : std::vector<double>{};
    problem.field_times.clear();
    std::ranges::set_union(written_times, viewed_times, std::back_inserter(problem.field_times));

    watch.start("heat matrices");
    model.assemble_heat(problem);
    if (!options.start_from.empty())
        model.start_from(options.start_from);

    watch.start("time steps");
    double end = 0;
    for (const auto& segment : problem.segments)
        end += segment.duration;
    FieldWriter writer(input, machine, model, chain ? &*chain : nullptr, adjoints, options);
    ViewRecorder view;
    double field_seconds = 0;
    result.thermal = model.heat(
        adjoints, reference, chain ? static_cast<int>(drift::gap) : -1, observer,
        [&](double time) { observer.progress(time / end, fmt::format("t = {:.2f} h", time / 3600)); },
        [&](double time, const fem::Field& field) {
            const double before = watch.seconds();
            if (std::ranges::binary_search(viewed_times, time))
                view.add(time, field);
            if (std::ranges::binary_search(written_times, time))
                writer.write(time, field, result);
            field_seconds += watch.seconds() - before;
        });
    watch.stop();
    if (!options.state_file.empty())
        model.write_state(options.state_file);

    result.timings = watch.times();
    result.timings.back().second -= field_seconds;
    if (field_seconds > 0)
        result.timings.emplace_back("fields", field_seconds);
    if (!view.empty()) {
        watch.start("view");
        CloseJoints close;
        if (chain)
            close = [&](const fem::Displacement& u) { return close_joints(machine, model, *chain, u).motions; };
        result.view = view.finish(machine, model, reference, close);
        watch.stop();
        result.timings.push_back(watch.times().back());
    }
    result.elastic_iterations = model.elastic_iterations();
    result.joints = joint_histories(input, machine, problem, result.thermal, result.whole);
    if (chain)
        result.drift = drift_series(result.thermal);
    result.ranks = fem::ranks();
    result.peak_memory = fem::peak_memory();
    if (result.thermal.law_out_of_range)
        observer.warn("a friction law was used outside the temperatures its lubricant is known for; see the joint "
                      "temperatures in "
                      "history.csv and extend the viscosity table");
    for (std::size_t i = 0; i < problem.surfaces.size(); ++i)
        if (result.thermal.film_out_of_range[i])
            observer.warn(fmt::format("surfaces.{}: its film law was used outside its tested range; 'deadpoint heat' "
                                      "shows where it is",
                                      problem.surfaces[i].name));
    if (result.thermal.energy.mismatch() > 1e-6)
        observer.warn(fmt::format("the energy balance closes to {:.1e} only; lower numerics.solver_tolerance",
                                  result.thermal.energy.mismatch()));
    return result;
}

}  // namespace deadpoint::study
