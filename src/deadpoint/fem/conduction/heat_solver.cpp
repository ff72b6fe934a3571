#include "deadpoint/fem/conduction/heat_solver.hpp"

#include "deadpoint/exchange/laws/material.hpp"
#include "deadpoint/exchange/machine.hpp"
#include "deadpoint/fem/algebra/vectors.hpp"
#include "deadpoint/fem/conduction/checkpoint.hpp"
#include "deadpoint/fem/conduction/heat_checkpoint.hpp"
#include "deadpoint/fem/conduction/stage_matrix.hpp"
#include "deadpoint/heat/adjoint.hpp"
#include "deadpoint/heat/run.hpp"
#include "deadpoint/observer.hpp"
#include "deadpoint/reduce/causes/reduced_adjoint.hpp"

#include <algorithm>
#include <optional>

namespace deadpoint::fem {
namespace {

static_assert(heat::AdjointSystem<HeatSystem>);

constexpr double dual_tolerance = 1e-8;

Field field_of(const OwnedVec& vector)
{
    PetscInt count = 0;
    DEADPOINT_PETSC(VecGetLocalSize(vector, &count));
    const ConstEntries values(vector);
    return {{values.data(), values.data() + count}};
}

void set(OwnedVec& vector, const std::vector<double>& values) { std::ranges::copy(values, Entries(vector).data()); }

// The active segment at a time.
const HeatSegment& segment_at(const HeatProblem& problem, double time)
{
    double end = 0;
    const auto running = std::ranges::find_if(problem.segments, [&](const HeatSegment& segment) {
        end += segment.duration;
        return time <= end * (1 + 1e-9);
    });
    return running == problem.segments.end() ? problem.segments.back() : *running;
}

}  // namespace

HeatSolver::HeatSolver(const Discretisation& space, const std::vector<Material>& materials, const HeatProblem& problem)
    : system_(space, materials, problem), problem_(&problem)
{
    heat::HeatSources<HeatSystem>(system_, problem).enter(problem.segments.front());
    system_.stage().prepare();
}

HeatSolver::~HeatSolver() = default;

bool HeatSolver::adopt(const HeatProblem& problem)
{
    if (!system_.adopt(problem))
        return false;
    run_.reset();
    problem_ = &problem;
    return true;
}

ThermalState HeatSolver::state() const
{
    if (!run_ || run_->history().time.empty())
        return state_;
    return {field_of(run_->temperature()), run_->sumps(), run_->enclosures()};
}

void HeatSolver::make_run(std::size_t functionals, std::size_t contributions)
{
    run_.reset();
    run_ = std::make_unique<Run>(system_, *problem_, functionals, contributions);
    if (state_.temperature.owned.empty())
        return;
    set(run_->temperature(), state_.temperature.owned);
    run_->set_media(state_.sumps, state_.enclosures);
}

ThermalHistory HeatSolver::run(const std::vector<Adjoint>& adjoints, double reference_temperature,
                               Attribution attribution, Observer& observer, const StepCallback& on_step,
                               const FieldCallback& on_field, const CheckpointPlan* checkpoints)
{
    reference_ = reference_temperature;
    system_.observe_with({&adjoints, reference_temperature, attribution});
    make_run(adjoints.size(), static_cast<std::size_t>(attribution.count) * system_.space().machine.parts.size());
    heat::RunHooks<OwnedVec> hooks;
    hooks.on_step = on_step;
    if (on_field)
        hooks.on_field = [&](double time, const OwnedVec& temperature) { on_field(time, field_of(temperature)); };
    std::optional<HeatCheckpoint> checkpoint;
    if (checkpoints)
        checkpoint.emplace(*run_, *checkpoints, state_, observer);
    run_->begin();
    if (checkpoints && !checkpoints->from.empty())
        checkpoint->restore(on_field);
    if (checkpoint) {
        hooks.on_between_steps = [&](bool interrupted) { checkpoint->offer(interrupted); };
        hooks.on_end_in_sight = [&] { checkpoint->keep(); };
    }
    auto history = run_->go(hooks, observer);
    system_.observe_with({});
    return history;
}

HeatCauses HeatSolver::causes(const std::vector<double>& weights, std::size_t row)
{
    if (!adjoint_)
        adjoint_ = std::make_unique<heat::HeatAdjoint<HeatSystem>>(*run_, reference_);
    set(adjoint_->weights(), weights);
    return adjoint_->causes(row);
}

HeatCauses HeatSolver::causes_on_basis(const std::vector<double>& weights, std::size_t row)
{
    if (system_.some_prescribed())
        return causes(weights, row);
    if (!reduced_adjoint_)
        reduced_adjoint_ = std::make_unique<reduce::ReducedAdjoint<HeatSystem>>(
            system_, heat::FinishedRun<HeatSystem>{run_->sources(), run_->steps(), run_->start()}, reference_);
    auto load = system_.make_vector();
    set(load, weights);
    return reduced_adjoint_->causes(load, row);
}

std::vector<Field> HeatSolver::duals(double time, const Field& temperature, const std::vector<Adjoint>& weights)
{
    make_run(0, 0);
    set(run_->temperature(), temperature.owned);
    auto& stages = run_->stages();
    run_->stepper().begin_segment(segment_at(*problem_, time), time);
    const auto& now = run_->stepper().now();
    stages.build(time, time, now.temperature);
    stages.set_source_slopes(now.rate.balance.source_slope);
    auto load = system_.make_vector(), solution = system_.make_vector();
    std::vector<Field> result;
    for (const auto& weight : weights) {
        set(load, weight.owned);
        DEADPOINT_PETSC(VecScale(load, time));
        system_.clear_prescribed(load);
        stages.solve_linear(load, solution, {dual_tolerance, 0}, "the dual of the temperature field");
        result.push_back(field_of(solution));
    }
    return result;
}

}  // namespace deadpoint::fem
