#include "deadpoint/fem/conduction/heat_solver.hpp"

#include <algorithm>

// Where a run, a segment of it, or a run of another problem on the same matrices begins.

namespace deadpoint::fem {
namespace {

bool same_films(const InterfaceLaw& a, const InterfaceLaw& b)
{
    return a.film_a == b.film_a && a.film_b == b.film_b && a.oil == b.oil && a.turns_fully == b.turns_fully;
}

}  // namespace

double HeatSolver::longest_segment(const HeatProblem& problem)
{
    double longest = 0;
    for (const auto& segment : problem.segments)
        longest = std::max(longest, segment.duration);
    return longest;
}

void HeatSolver::choose_laws(const HeatSegment& segment)
{
    laws_ = segment.interfaces.empty() ? &problem_->interfaces : &segment.interfaces;
}

bool HeatSolver::adopt(const HeatProblem& problem)
{
    const auto same_condition = [](const SurfaceCondition& a, const SurfaceCondition& b) {
        return a.surface == b.surface && a.kind == b.kind && a.coefficient == b.coefficient &&
               a.emissivity == b.emissivity && a.laws.empty() == b.laws.empty() && a.enclosure == b.enclosure;
    };
    const auto same_place = [](const BodyHeat& a, const BodyHeat& b) {
        return a.parts == b.parts && a.surface == b.surface;
    };
    const auto& laws =
        problem.segments.front().interfaces.empty() ? problem.interfaces : problem.segments.front().interfaces;
    const bool same = problem.sources.size() == problem_->sources.size() &&
                      problem.oil.size() == problem_->oil.size() &&
                      problem.enclosures.size() == problem_->enclosures.size() &&
                      std::ranges::equal(problem.surfaces, problem_->surfaces, same_condition) &&
                      std::ranges::equal(problem.radiation, problem_->radiation, {}, &RadiantRoom::exchange,
                                         &RadiantRoom::exchange) &&
                      std::ranges::equal(problem.body_heat, problem_->body_heat, same_place) &&
                      std::ranges::equal(laws, *laws_, same_films);
    if (!same)
        return false;
    if (longest_segment(problem) > longest_segment(*problem_))
        aggregates_built_ = false;  // the multigrid's bounds hold up to that
    for (auto& film : films_)
        film.condition = &problem.surfaces[film.index];
    for (auto& [position, condition] : prescribed_at_)
        condition = &problem.surfaces[static_cast<std::size_t>(condition - problem_->surfaces.data())];
    for (std::size_t r = 0; r < rooms_.size(); ++r)
        rooms_[r].room = &problem.radiation[r];
    problem_ = &problem;
    air_->adopt(problem.enclosures);
    laws_ = &laws;
    return true;
}

void HeatSolver::enter_segment(const HeatSegment& segment)
{
    segment_ = &segment;
    const auto* before = laws_;
    choose_laws(segment);
    prepare_sources();
    if (!std::ranges::equal(*before, *laws_, same_films)) {
        assemble();
        system_factor_ = multigrid_factor_ = -1;
        aggregates_built_ = false;
    }
}

void HeatSolver::begin_segment(const HeatSegment& segment, double time)
{
    enter_segment(segment);
    if (time == 0)
        impose(time, now_);
    settle_oil(time);
    conduct(now_, work_);
    DEADPOINT_PETSC(VecAXPY(rate_now_.vector, -1, work_));
    store(now_, stored_now_);
}

// The slope of the fields is not known where a segment starts.
void HeatSolver::start_segment(RunPlace& place, ThermalHistory& history)
{
    begin_segment(problem_->segments[place.segment], place.time);
    if (!start_) {
        start_ = duplicate(now_);
        DEADPOINT_PETSC(VecCopy(now_, start_));
    }
    place.segment_start = place.time;
    place.segment_row = history.time.size();
    place.wanted = problem_->fixed_step > 0 ? problem_->fixed_step : problem_->initial_step;
    have_previous_ = false;
    previous_dt_ = 0;
    record(history, place.time, rate_now_);
}

void HeatSolver::start_from(const ThermalState& state)
{
    double* values = nullptr;
    DEADPOINT_PETSC(VecGetArray(now_, &values));
    std::copy(state.temperature.owned.begin(), state.temperature.owned.end(), values);
    DEADPOINT_PETSC(VecRestoreArray(now_, &values));
    sump_ = state.sumps;
    air_->start_from(state.enclosures);
}

ThermalState HeatSolver::state() const
{
    ThermalState result;
    const double* values = nullptr;
    DEADPOINT_PETSC(VecGetArrayRead(now_, &values));
    result.temperature.owned.assign(values, values + (space_.last - space_.first));
    DEADPOINT_PETSC(VecRestoreArrayRead(now_, &values));
    result.sumps = sump_;
    result.enclosures = air_->at_start();
    return result;
}

}  // namespace deadpoint::fem
