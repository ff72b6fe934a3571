#include "deadpoint/fem/conduction/heat_solver.hpp"

#include "deadpoint/exchange/step_tolerance.hpp"
#include "deadpoint/fem/conduction/tr_bdf2.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numeric>

// Time integration; the matrices are in heat_assembly.cpp, the system of a stage in heat_system.cpp.

namespace deadpoint::fem {
namespace {

constexpr int max_newton = 20;
const double ladder = 2;  // between two step sizes
// Joint heat may differ from its tangent within a stage by this share; the stage is computed with the tangent's, so
// that its heat balance is exact.
constexpr double largest_curvature = 1e-5;
// The oil's temperatures within a stage agree with the films' to this share of the step's tolerance.
constexpr double oil_share_of_tolerance = 1e-3;

void require_finite(Vec vector, double time)
{
    PetscReal norm = 0;
    DEADPOINT_PETSC(VecNorm(vector, NORM_1, &norm));
    if (!std::isfinite(norm))
        throw DomainError("a temperature became non-finite at t = " + std::to_string(time) +
                          " s; look for a heat law or film that is not finite at the temperatures reached");
}

// Sum of weights times vectors; the result is none of them.
template <std::size_t count>
void combine(const std::array<double, count>& weights, std::array<Vec, count> vectors, Vec result)
{
    DEADPOINT_PETSC(VecZeroEntries(result));
    DEADPOINT_PETSC(VecMAXPY(result, count, weights.data(), vectors.data()));
}

}  // namespace

OwnedVec duplicate(Vec vector)
{
    OwnedVec copy;
    DEADPOINT_PETSC(VecDuplicate(vector, copy.out()));
    return copy;
}

HeatSolver::HeatSolver(const Discretisation& space, const std::vector<Material>& materials, const HeatProblem& problem)
    : space_(space), materials_(materials), expansion_(space, materials), problem_(&problem)
{
    laws_ = &problem_->interfaces;
    if (!problem_->segments.empty())
        choose_laws(problem_->segments.front());
    prepare_parts();
    prepare_materials();
    prepare_prescribed();
    prepare_interfaces();
    prepare_sources();
    prepare_body_heat();
    prepare_films();

    create_matrices();
    assemble();
    now_ = create_vector(space_, 1);
    for (OwnedVec* v : {&before_, &middle_, &next_, &slope_middle_, &slope_now_, &slope_before_, &slope_next_,
                        &stored_now_, &stored_middle_, &stored_next_, &capacities_, &known_, &work_, &work2_, &error_})
        *v = duplicate(now_);
    DEADPOINT_PETSC(VecSet(work_, 1));
    DEADPOINT_PETSC(MatMult(mass_, work_, capacities_));
    if (variable_films_)
        everywhere_ = std::make_unique<Everywhere>(now_);
    air_ = std::make_unique<EnclosedAir>(problem_->enclosures, now_);
    prepare_rooms();

    prepare_solver();
}

// M T - factor (gains - K T) - known  into work_. Where the system is M + factor K, it takes one product.
void HeatSolver::stage_residual(double factor, Vec temperature, const HeatRate& gained)
{
    if (system_is_linear()) {
        DEADPOINT_PETSC(MatMult(system_, temperature, work_));
    } else {
        conduct(temperature, work2_);
        store(temperature, work_);
        DEADPOINT_PETSC(VecAXPY(work_, factor, work2_));
    }
    DEADPOINT_PETSC(VecAXPY(work_, -factor, gained.vector));
    DEADPOINT_PETSC(VecAXPY(work_, -1, known_));
    clear_prescribed(work_);
}

// The heat stored at the end of a stage, and its gains made the rate: by the stage's own formula (stored - known) /
// factor where it holds for every unknown.
void HeatSolver::finish_stage(double factor, Vec temperature, HeatRate& gained, Vec stored)
{
    store(temperature, stored);
    if (system_is_linear()) {
        DEADPOINT_PETSC(VecWAXPY(gained.vector, -1, known_, stored));
        DEADPOINT_PETSC(VecScale(gained.vector, 1 / factor));
    } else {
        conduct(temperature, work_);
        DEADPOINT_PETSC(VecAXPY(gained.vector, -1, work_));
    }
}

// Newton for  M T - factor rate(T) = known_,  starting from the guess in `temperature`.
HeatRate HeatSolver::solve_stage(double time, double factor, const std::vector<double>& known_sump, Vec temperature,
                                 Vec stored)
{
    time_ = time;
    impose(time, temperature);
    HeatRate current = gains(time, temperature);
    if (!problem_->oil.empty()) {
        set_oil(follow_oil(current, time, factor, known_sump));
        current = gains(time, temperature);
    }
    for (int iteration = 0; iteration < max_newton; ++iteration) {
        shell_slopes_ = current.source_slope;
        build_system(factor, temperature);
        stage_residual(factor, temperature, current);
        const auto of_air = air_->residual(current);
        air_->take_out(of_air, work_);
        set_tolerance(1e-13, problem_->solver_tolerance);
        solve_system(work_, work2_, "the temperature field");
        ++solves_;
        DEADPOINT_PETSC(VecAXPY(temperature, -1, work2_));
        require_finite(temperature, time);
        const double air_change = air_->move(of_air, work2_);

        HeatRate updated = gains(time, temperature);
        const auto corrections = tangent_less_law(current, updated);
        double curvature = 0, total = 1e-300;
        for (std::size_t r = 0; r < corrections.size(); ++r) {
            curvature += std::abs(corrections[r]);
            total += std::abs(updated.source_heat[r]);
        }
        PetscReal change = 0;
        if (variable_films_ || materials_vary()) {
            DEADPOINT_PETSC(VecNorm(work2_, NORM_INFINITY, &change));
            change = std::max(change, air_change);
        }
        // The oil as the solve took it is kept where it is good enough, so that the balance stays exact.
        const auto reaches = follow_oil(updated, time, factor, known_sump);
        double oil_change = 0;
        for (std::size_t i = 0; i < reaches.size(); ++i)
            oil_change = std::max(oil_change, std::abs(reaches[i] - oil_temperature_[i]));
        current = std::move(updated);
        if (curvature <= largest_curvature * total && change < 1e-7 &&
            oil_change <= oil_share_of_tolerance * step_tolerance(problem_->time_tolerance)) {
            correct_heat(current, corrections);
            finish_stage(factor, temperature, current, stored);
            return current;
        }
        if (oil_change > 0) {
            set_oil(reaches);
            current = gains(time, temperature);
        }
    }
    throw ConvergenceError("joint heat and temperatures did not agree within " + std::to_string(max_newton) +
                           " iterations at t = " + std::to_string(time) +
                           " s; a heat law or film coefficient probably jumps, smooth it or shorten max_step");
}

// The cubic through values and slopes at both ends of an interval of length h, at the place s (0 and 1 are its ends).
void HeatSolver::hermite(Vec start, Vec start_slope, Vec end, Vec end_slope, double h, double s, Vec result)
{
    combine<4>({(1 + 2 * s) * (1 - s) * (1 - s), h * s * (1 - s) * (1 - s), s * s * (3 - 2 * s), h * s * s * (s - 1)},
               {start, start_slope, end, end_slope}, result);
}

// What the sumps' temperatures are known to be before a stage, as the field's.
std::vector<double> HeatSolver::first_known_sump(double factor) const
{
    auto known = sump_;
    for (std::size_t k = 0; k < known.size(); ++k)
        known[k] += factor * rate_now_.oil[k].sump_rate;
    return known;
}

std::vector<double> HeatSolver::second_known_sump() const
{
    auto known = sump_;
    for (std::size_t k = 0; k < known.size(); ++k)
        known[k] = bdf_middle * rate_middle_.oil[k].sump - bdf_now * known[k];
    return known;
}

HeatSolver::Step HeatSolver::step(double time, double dt)
{
    const double factor = diagonal * dt;

    // Predict the first stage from the last step, the second through the first stage.
    const double to_middle = gamma_stage * dt;
    if (previous_dt_ > 0)
        hermite(before_, slope_before_, now_, slope_now_, previous_dt_, 1 + to_middle / previous_dt_, middle_);
    else if (have_previous_)
        DEADPOINT_PETSC(VecWAXPY(middle_, to_middle, slope_now_, now_));
    else
        DEADPOINT_PETSC(VecCopy(now_, middle_));
    DEADPOINT_PETSC(VecWAXPY(known_, factor, rate_now_.vector, stored_now_));
    air_->begin_first_stage(dt, have_previous_, rate_now_);
    rate_middle_ = solve_stage(time + gamma_stage * dt, factor, first_known_sump(factor), middle_, stored_middle_);

    combine<2>({bdf_middle, -bdf_now}, {stored_middle_, stored_now_}, known_);
    if (have_previous_) {
        combine<3>({1 / factor, -1 / factor, -1}, {middle_, now_, slope_now_}, slope_middle_);
        hermite(now_, slope_now_, middle_, slope_middle_, to_middle, 1 / gamma_stage, next_);
    } else {
        combine<2>({1 / factor, -1 / factor}, {middle_, now_}, slope_middle_);
        combine<2>({1 / gamma_stage, 1 - 1 / gamma_stage}, {middle_, now_}, next_);
    }
    air_->begin_second_stage();
    rate_next_ = solve_stage(time + dt, factor, second_known_sump(), next_, stored_next_);

    // slope at the end, from the second stage's own formula
    combine<3>({1 / factor, -bdf_middle / factor, bdf_now / factor}, {next_, middle_, now_}, slope_next_);

    Step result;
    result.from_prescribed = prescribed_heat(dt);

    if (problem_->fixed_step > 0)
        return result;
    result.error = std::max(estimate_error(dt), oil_error(dt));
    for (const double e : evaluate(watched_, error_))
        result.error = std::max(result.error, std::abs(e));
    return result;
}

// Of the step, into error_, and the enclosures' largest returned [K]: the difference to the companion method. The
// slopes of both stages come from their own formulas. Where the first slope is not known, as at the start of a segment,
// the difference of the rates is filtered by the step's matrix, which takes out stiff transients; the second stage
// damps them in every later step.
double HeatSolver::estimate_error(double dt)
{
    if (have_previous_) {
        combine<3>({dt * error_weights[0], dt * error_weights[1], dt * error_weights[2]},
                   {slope_now_, slope_middle_, slope_next_}, error_);
        return air_->error(dt);
    }
    combine<3>({dt * error_weights[0], dt * error_weights[1], dt * error_weights[2]},
               {rate_now_.vector, rate_middle_.vector, rate_next_.vector}, work_);
    clear_prescribed(work_);
    const auto of_air = air_->first_error(dt, {&rate_now_, &rate_middle_, &rate_next_});
    air_->take_out(of_air, work_);
    // sharp enough that all numbers of ranks take the same steps
    set_tolerance(1e-4, 1e-4 * step_tolerance(problem_->time_tolerance));
    solve_system(work_, error_, "the error of a time step");
    double largest = 0;
    for (const double e : air_->solution(of_air, error_))
        largest = std::max(largest, std::abs(e));
    return largest;
}

// What entered through nodes of prescribed temperature during the step: their stored heat less their other gains.
double HeatSolver::prescribed_heat(double dt)
{
    if (!some_prescribed_)
        return 0;
    heat_change(now_, next_, work2_);
    DEADPOINT_PETSC(MatMult(mass_, work2_, work_));
    DEADPOINT_PETSC(VecAXPY(work_, -dt * outer_weight, rate_now_.vector));
    DEADPOINT_PETSC(VecAXPY(work_, -dt * outer_weight, rate_middle_.vector));
    DEADPOINT_PETSC(VecAXPY(work_, -dt * diagonal, rate_next_.vector));
    std::vector<double> sum(1, 0.0);
    const double* values = nullptr;
    DEADPOINT_PETSC(VecGetArrayRead(work_, &values));
    for (const PetscInt row : prescribed_)
        sum[0] += values[row - space_.first];
    DEADPOINT_PETSC(VecRestoreArrayRead(work_, &values));
    sum_over_ranks(sum);
    return sum[0];
}

namespace {

// The largest step of the geometric ladder that ends well: no sliver is left for a last step.
double fit_step(double wanted, double remaining)
{
    if (remaining <= wanted * (1 + 1e-9))
        return remaining;
    return remaining < 2 * wanted ? remaining / 2 : wanted;
}

}  // namespace

// Steps may stay short for a reason that no check of the case sees.
void HeatSolver::warn_of_many_steps(const RunPlace& place, Observer& observer) const
{
    constexpr std::size_t judged_after = 1000;
    constexpr double many = 1e5;
    if (steps_.size() != judged_after)
        return;
    double left = -place.time;
    for (const auto& segment : problem_->segments)
        left += segment.duration;
    const double more = left / steps_.back().duration;
    if (more > many)
        observer.warn(
            fmt::format("after {} time steps the run is at t = {:.3g} s of {:.3g} s; at the present {:.2g} s a "
                        "step, {:.2g} more follow; loosen numerics.time_tolerance, or look for a law or a "
                        "course that changes fast",
                        judged_after, place.time, place.time + left, steps_.back().duration, more));
}

// One step towards the end of the segment; false where it was too long and a shorter one is wanted.
bool HeatSolver::try_step(RunPlace& place, double end, ThermalHistory& history, const FieldCallback& on_field)
{
    const double dt = fit_step(place.wanted, end - place.time);
    const Step outcome = step(place.time, dt);
    const bool controlled = problem_->fixed_step <= 0;
    if (controlled && outcome.error > step_tolerance(problem_->time_tolerance)) {
        ++history.rejected_steps;
        place.wanted = dt * rungs(outcome.error, -20, -1);
        if (dt < 1e-6)
            throw ConvergenceError("the time step collapsed below 1 us at t = " + std::to_string(place.time) +
                                   " s; loosen numerics.time_tolerance or look for a law that jumps");
        return false;
    }
    if (!have_previous_) {
        DEADPOINT_PETSC(VecWAXPY(slope_now_, -1, now_, next_));
        DEADPOINT_PETSC(VecScale(slope_now_, 1 / dt));
    }
    write_fields_until(place.time, dt, on_field);
    accept_step(dt, outcome, history);
    place.time = end - place.time <= dt * (1 + 1e-12) ? end : place.time + dt;
    record(history, place.time, rate_now_);
    if (history.time.size() == place.segment_row + 2)
        fill_first_rates(history, place.segment_row);
    if (controlled && dt >= 0.99 * place.wanted)
        place.wanted = std::min(place.wanted * rungs(outcome.error, 0, 1), problem_->max_step);
    return true;
}

// Books a step and makes its end the present.
void HeatSolver::accept_step(double dt, const Step& outcome, ThermalHistory& history)
{
    add_energy(history.energy, dt, outcome.from_prescribed);
    steps_.push_back({static_cast<std::size_t>(segment_ - problem_->segments.data()), history.time.size(), dt,
                      rate_now_, rate_middle_, rate_next_});
    history.energy.stored += air_->accept(dt);
    std::swap(before_, now_);
    std::swap(now_, next_);
    std::swap(stored_now_, stored_next_);
    previous_dt_ = have_previous_ ? dt : 0;
    std::swap(slope_before_, slope_now_);
    std::swap(slope_now_, slope_next_);
    rate_now_ = std::move(rate_next_);
    for (std::size_t k = 0; k < sump_.size(); ++k)
        sump_[k] = rate_now_.oil[k].sump;
    have_previous_ = true;
}

// The factor by which a step may grow or must shrink, in whole rungs of the ladder of step sizes.
double HeatSolver::rungs(double error, int least, int most) const
{
    const double allowed = 0.9 * std::cbrt(step_tolerance(problem_->time_tolerance) / std::max(error, 1e-30));
    return std::pow(ladder, std::clamp(std::floor(std::log(allowed) / std::log(ladder)), 1.0 * least, 1.0 * most));
}

}  // namespace deadpoint::fem
