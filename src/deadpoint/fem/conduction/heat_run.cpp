#include "deadpoint/fem/conduction/heat_checkpoint.hpp"

#include <optional>

// The loop over segments and steps.

namespace deadpoint::fem {
namespace {

bool any_rank(bool flag)
{
    int value = flag ? 1 : 0;
    MPI_Allreduce(MPI_IN_PLACE, &value, 1, MPI_INT, MPI_MAX, MPI_COMM_WORLD);
    return value != 0;
}

}  // namespace

ThermalHistory HeatSolver::run(const std::vector<Adjoint>& adjoints, double reference_temperature,
                               Attribution attribution, Observer& observer, const StepCallback& on_step,
                               const FieldCallback& on_field, const CheckpointPlan* checkpoints)
{
    prepare_observers(adjoints, reference_temperature, attribution);
    std::optional<HeatCheckpoint> checkpoint;
    if (checkpoints)
        checkpoint.emplace(*this, *checkpoints, observer);
    ThermalHistory history = empty_history();
    RunPlace place;
    start_segment(place, history);
    if (checkpoints && checkpoints->resume)
        checkpoint->restore(history, place, on_field);
    while (!history.interrupted) {
        const double end = place.segment_start + problem_->segments[place.segment].duration;
        while (!history.interrupted && place.time < end * (1 - 1e-14)) {
            if (!try_step(place, end, history, on_field))
                continue;
            warn_of_many_steps(place, observer);
            if (on_step)
                on_step(place.time);
            history.interrupted = any_rank(observer.cancelled());
            if (checkpoint)
                checkpoint->offer(history, place, history.interrupted);
        }
        if (history.interrupted || place.segment + 1 == problem_->segments.size())
            break;
        ++place.segment;
        start_segment(place, history);
    }
    history.linear_iterations = iterations_;
    history.linear_solves = solves_;
    extremes_of_ranks(history);
    return history;
}

}  // namespace deadpoint::fem
