#include "deadpoint/fem/heat_solver.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

// Time integration; the matrices are in heat_assembly.cpp.

namespace deadpoint::fem {
namespace {

// TR-BDF2 with gamma = 2 - sqrt(2): both stages solve with the same matrix M + diagonal dt J. The companion of
// third order gives the error estimate (Hosea and Shampine, Applied Numerical Mathematics 20, 1996).
const double gamma_stage = 2 - std::sqrt(2.0);
const double diagonal = 1 - 1 / std::sqrt(2.0);
const double outer_weight = std::sqrt(2.0) / 4;
const double bdf_middle = 1 / (gamma_stage * (2 - gamma_stage));
const double bdf_now = (1 - gamma_stage) * (1 - gamma_stage) / (gamma_stage * (2 - gamma_stage));
const std::array<double, 3> error_weights{(1 - outer_weight) / 3 - outer_weight,
                                          (3 * outer_weight + 1) / 3 - outer_weight, diagonal / 3 - diagonal};

constexpr int max_newton = 20;
const double ladder = 2;  // between two step sizes
constexpr double largest_reuse = 2.5;
// Joint heat may differ from its tangent within a stage by this share; the stage is computed with the tangent's, so
// that its heat balance is exact.
constexpr double largest_curvature = 1e-5;

OwnedVec duplicate(Vec vector)
{
    OwnedVec copy;
    DEADPOINT_PETSC(VecDuplicate(vector, copy.out()));
    return copy;
}

// Options that the user gave to PETSC win.
void default_option(const char* name, const char* value)
{
    PetscBool given = PETSC_FALSE;
    DEADPOINT_PETSC(PetscOptionsHasName(nullptr, nullptr, name, &given));
    if (!given)
        DEADPOINT_PETSC(PetscOptionsSetValue(nullptr, name, value));
}

void require_finite(Vec vector, double time)
{
    PetscReal norm = 0;
    DEADPOINT_PETSC(VecNorm(vector, NORM_1, &norm));
    if (!std::isfinite(norm))
        throw DomainError("a temperature became non-finite at t = " + std::to_string(time) +
                          " s; look for a heat law or film that is not finite at the temperatures reached");
}

}  // namespace

HeatSolver::HeatSolver(const Discretisation& space, const std::vector<Material>& materials, const HeatProblem& problem)
    : space_(space), materials_(materials), problem_(problem)
{
    prepare_interfaces();
    prepare_films();
    prepare_prescribed();

    const auto cells = space_.cell_pattern();
    mass_ = create_matrix(space_, cells, 1);
    auto coupled = space_.cell_pattern();  // patterns with entries cannot be copied
    space_.add_bond_pattern(coupled);
    add_interface_pattern(coupled);
    stiffness_ = create_matrix(space_, coupled, 1);
    assemble_cells(mass_, stiffness_);
    assemble_bonds(stiffness_);
    assemble_interfaces(stiffness_);
    assemble_films(stiffness_);
    for (Mat matrix : {Mat(mass_), Mat(stiffness_)}) {
        DEADPOINT_PETSC(MatAssemblyBegin(matrix, MAT_FINAL_ASSEMBLY));
        DEADPOINT_PETSC(MatAssemblyEnd(matrix, MAT_FINAL_ASSEMBLY));
    }
    DEADPOINT_PETSC(MatDuplicate(stiffness_, MAT_COPY_VALUES, system_.out()));
    DEADPOINT_PETSC(MatSetOption(system_, MAT_SYMMETRIC, PETSC_TRUE));
    if (variable_films_)
        variable_ = create_matrix(space_, cells, 1);

    now_ = create_vector(space_, 1);
    for (OwnedVec* v : {&before_, &middle_, &next_, &slope_middle_, &slope_now_, &slope_before_, &slope_next_, &work_,
                        &work2_, &error_})
        *v = duplicate(now_);
    if (variable_films_)
        everywhere_ = std::make_unique<Everywhere>(now_);

    const PetscInt rows = space_.last - space_.first;
    DEADPOINT_PETSC(MatCreateShell(PETSC_COMM_WORLD, rows, rows, space_.total, space_.total, this, shell_.out()));
    DEADPOINT_PETSC(MatShellSetOperation(shell_, MATOP_MULT, reinterpret_cast<void (*)(void)>(&HeatSolver::multiply)));
    DEADPOINT_PETSC(MatSetOption(shell_, MAT_SYMMETRIC, PETSC_TRUE));

    DEADPOINT_PETSC(KSPCreate(PETSC_COMM_WORLD, solver_.out()));
    DEADPOINT_PETSC(KSPSetType(solver_, KSPCG));
    DEADPOINT_PETSC(KSPSetInitialGuessNonzero(solver_, PETSC_FALSE));
    PC preconditioner = nullptr;
    DEADPOINT_PETSC(KSPGetPC(solver_, &preconditioner));
    DEADPOINT_PETSC(PCSetType(preconditioner, PCML));
    // Weak couplings across films only blur the aggregates.
    default_option("-heat_pc_ml_Threshold", "0.01");
    // Runs at the memory's speed, which Gauss-Seidel sweeps do not, and alike on any number of ranks.
    default_option("-heat_mg_levels_ksp_type", "chebyshev");
    default_option("-heat_mg_levels_ksp_max_it", "2");
    default_option("-heat_mg_levels_pc_type", "jacobi");
    DEADPOINT_PETSC(KSPSetOptionsPrefix(solver_, "heat_"));
    DEADPOINT_PETSC(KSPSetFromOptions(solver_));
    DEADPOINT_PETSC(KSPSetOperators(solver_, shell_, system_));
}

// y = (M + factor (K + K_films)) x - factor sum of dH/dT b (b . x): heat that falls with temperature adds to the
// matrix, as a few rank-one terms that the preconditioner need not know.
PetscErrorCode HeatSolver::multiply(Mat shell, Vec in, Vec out)
{
    HeatSolver* self = nullptr;
    MatShellGetContext(shell, &self);
    MatMult(self->system_, in, out);
    if (self->shell_slopes_.empty())
        return 0;
    std::vector<const SparseFunctional*> loads;
    for (const auto& load : self->shell_loads_)
        loads.push_back(&load);
    const auto products = evaluate(loads, in);
    for (std::size_t r = 0; r < products.size(); ++r)
        add_to(out, self->shell_loads_[r], -self->system_factor_ * self->shell_slopes_[r] * products[r]);
    return 0;
}

void HeatSolver::set_tolerance(double relative, double absolute)
{
    const double scale = std::sqrt(static_cast<double>(space_.total));
    DEADPOINT_PETSC(KSPSetTolerances(solver_, relative, absolute * scale, 1e10, 2000));
}

void HeatSolver::build_system(double factor, Vec temperature)
{
    if (factor == system_factor_ && !variable_films_)
        return;
    // The old multigrid still serves a matrix that changed little: with films that follow the temperature, or the next
    // step size.
    const bool reuse = factor < largest_reuse * multigrid_factor_ && multigrid_factor_ < largest_reuse * factor;
    DEADPOINT_PETSC(KSPSetReusePreconditioner(solver_, reuse ? PETSC_TRUE : PETSC_FALSE));
    if (!reuse)
        multigrid_factor_ = factor;
    DEADPOINT_PETSC(MatCopy(stiffness_, system_, SAME_NONZERO_PATTERN));
    if (variable_films_) {
        const double* values = everywhere_->gather(temperature);
        DEADPOINT_PETSC(MatZeroEntries(variable_));
        for (const auto& film : films_) {
            if (film.points.empty())
                continue;
            const double surroundings = ambient(*film.condition, time_);
            const auto law = film_at(*film.condition, surroundings);
            for (const auto& point : film.points) {
                double at = 0;
                for (int i = 0; i < point.shape.count; ++i)
                    at += point.shape.value[i] * values[point.shape.dof[i]];
                const double slope = film_slope(law(at), film.condition->emissivity, at, surroundings);
                for (int i = 0; i < point.shape.count; ++i)
                    for (int j = 0; j < point.shape.count; ++j)
                        DEADPOINT_PETSC(MatSetValue(variable_, point.shape.dof[i], point.shape.dof[j],
                                                    slope * point.weight * point.shape.value[i] * point.shape.value[j],
                                                    ADD_VALUES));
            }
        }
        DEADPOINT_PETSC(MatAssemblyBegin(variable_, MAT_FINAL_ASSEMBLY));
        DEADPOINT_PETSC(MatAssemblyEnd(variable_, MAT_FINAL_ASSEMBLY));
        DEADPOINT_PETSC(MatAXPY(system_, 1, variable_, SUBSET_NONZERO_PATTERN));
    }
    DEADPOINT_PETSC(MatScale(system_, factor));
    DEADPOINT_PETSC(MatAXPY(system_, 1, mass_, SUBSET_NONZERO_PATTERN));
    DEADPOINT_PETSC(MatZeroRowsColumns(system_, static_cast<PetscInt>(prescribed_.size()), prescribed_.data(), 1,
                                       nullptr, nullptr));
    system_factor_ = factor;
}

double HeatSolver::ambient(const SurfaceCondition& condition, double time) const
{
    return condition.ambient ? condition.ambient(time) : segment_->ambient(time);
}

FilmLaw HeatSolver::film_at(const SurfaceCondition& c, double surroundings) const
{
    if (!c.laws.empty())
        return c.laws[static_cast<std::size_t>(segment_ - problem_.segments.data())](surroundings);
    return [value = c.coefficient](double) { return LawValue{value, 0, true}; };
}

double HeatSolver::film_flux(const LawValue& film, double emissivity, double surface, double surroundings)
{
    const double s = surface * surface, a = surroundings * surroundings;
    return (film.value + emissivity * stefan_boltzmann * (s + a) * (surface + surroundings)) * (surface - surroundings);
}

double HeatSolver::film_slope(const LawValue& film, double emissivity, double surface, double surroundings)
{
    // A slope of the wrong sign (a film that weakens as it warms) would cost the matrix its definiteness.
    const double convection = std::max(film.value + film.slope * (surface - surroundings), 0.25 * film.value);
    return convection + 4 * emissivity * stefan_boltzmann * surface * surface * surface;
}

void HeatSolver::add_variable_films(HeatRate& rate, double time, Vec temperature) const
{
    const double* values = everywhere_->gather(temperature);
    std::vector<double> sums(problem_.surfaces.size() + 1, 0.0);  // untested area per condition, then the heat lost
    for (const auto& film : films_) {
        if (film.points.empty())
            continue;
        const double surroundings = ambient(*film.condition, time);
        const auto law = film_at(*film.condition, surroundings);
        for (const auto& point : film.points) {
            double at = 0;
            for (int i = 0; i < point.shape.count; ++i)
                at += point.shape.value[i] * values[point.shape.dof[i]];
            const LawValue value = law(at);
            const double flow = point.weight * film_flux(value, film.condition->emissivity, at, surroundings);
            sums[film.index] += value.in_range ? 0 : point.weight;
            sums.back() += flow;
            for (int i = 0; i < point.shape.count; ++i)
                DEADPOINT_PETSC(VecSetValue(rate.vector, point.shape.dof[i], -flow * point.shape.value[i], ADD_VALUES));
        }
    }
    DEADPOINT_PETSC(VecAssemblyBegin(rate.vector));
    DEADPOINT_PETSC(VecAssemblyEnd(rate.vector));
    sum_over_ranks(sums);
    rate.to_air += sums.back();
    sums.pop_back();
    rate.films_untested = std::move(sums);
}

// Heat of each source at the film temperature it makes itself: H = law(tau + self H), tau from the solids and the oil.
void HeatSolver::add_sources(HeatRate& rate, Vec temperature) const
{
    std::vector<const SparseFunctional*> means;
    for (const auto& interface : interfaces_) {
        means.push_back(&interface.mean_a);
        means.push_back(&interface.mean_b);
    }
    const auto mean = evaluate(means, temperature);

    const std::size_t count = problem_.sources.size();
    std::vector<double> solid(count, 0.0);
    for (std::size_t i = 0; i < interfaces_.size(); ++i) {
        const auto& law = problem_.interfaces[i];
        if (law.source >= 0)
            solid[law.source] += interfaces_[i].heat_weight_area *
                                 (law.film_a * mean[2 * i] + law.film_b * mean[2 * i + 1]) / interfaces_[i].sum;
    }
    rate.source_heat.assign(count, 0.0);
    rate.source_slope.assign(count, 0.0);
    rate.source_temperature.assign(count, 0.0);
    for (std::size_t r = 0; r < count; ++r) {
        const double start = solid[r] + source_constant_[r];
        double film = start;
        if (const auto& law = segment_->heat[r]) {
            const double share = problem_.sources[r].share;
            double heat = 0, slope = 0;
            for (int i = 0; i < 50; ++i) {
                const LawValue value = law(film);
                heat = share * value.value;
                slope = share * value.slope;
                rate.in_range = rate.in_range && value.in_range;
                const double residual = film - start - source_self_[r] * heat;
                film -= residual / (1 - source_self_[r] * slope);
                if (std::abs(residual) < 1e-11 * std::abs(film))
                    break;
            }
            rate.source_heat[r] = heat;
            rate.source_slope[r] = slope / (1 - source_self_[r] * slope);
            add_to(rate.vector, source_loads_[r], heat);
        }
        rate.source_temperature[r] = film;
        rate.generated += rate.source_heat[r];
    }
    for (std::size_t i = 0; i < interfaces_.size(); ++i) {
        const auto& law = problem_.interfaces[i];
        const auto& interface = interfaces_[i];
        const double density =
            law.source >= 0 ? rate.source_heat[law.source] * interface.heat_weight_area / interface.area : 0;
        const double film =
            (density + law.film_a * mean[2 * i] + law.film_b * mean[2 * i + 1] + law.oil * law.oil_temperature) /
            interface.sum;
        rate.to_oil += law.oil * interface.area * (film - law.oil_temperature);
        const double from_oil = law.oil * law.oil_temperature * interface.area / interface.sum;
        add_to(rate.vector, interface.mean_a, from_oil * law.film_a);
        add_to(rate.vector, interface.mean_b, from_oil * law.film_b);
    }
}

HeatRate HeatSolver::rate(double time, Vec temperature) const
{
    HeatRate result;
    result.vector = duplicate(temperature);
    DEADPOINT_PETSC(MatMult(stiffness_, temperature, result.vector));
    DEADPOINT_PETSC(VecScale(result.vector, -1));

    std::vector<const SparseFunctional*> integrals;
    for (const auto& film : films_)
        integrals.push_back(&film.integral);
    const auto integral = evaluate(integrals, temperature);
    for (std::size_t i = 0; i < films_.size(); ++i) {
        const auto& film = films_[i];
        const auto& condition = *film.condition;
        if (condition.kind == SurfaceCondition::Kind::flux) {
            const double flux = condition.flux(time);
            add_to(result.vector, film.integral, flux);
            result.flux += flux * film.area;
        } else if (film.points.empty() && film.area > 0 && condition.kind == SurfaceCondition::Kind::film &&
                   !depends_on_temperature(condition)) {
            const double surroundings = ambient(condition, time);
            add_to(result.vector, film.integral, condition.coefficient * surroundings);
            result.to_air += condition.coefficient * (integral[i] - surroundings * film.area);
        }
    }
    add_sources(result, temperature);
    if (variable_films_)
        add_variable_films(result, time, temperature);
    return result;
}

void HeatSolver::impose(double time, Vec temperature) const
{
    double* values = nullptr;
    DEADPOINT_PETSC(VecGetArray(temperature, &values));
    for (std::size_t i = 0; i < prescribed_.size(); ++i)
        values[prescribed_[i] - space_.first] = prescribed_at_[i].second->temperature(prescribed_at_[i].first, time);
    DEADPOINT_PETSC(VecRestoreArray(temperature, &values));
}

// Newton for  M T - factor rate(T) = known,  starting from the guess in `temperature`.
HeatRate HeatSolver::solve_stage(double time, double factor, Vec known, Vec temperature)
{
    time_ = time;
    impose(time, temperature);
    HeatRate current = rate(time, temperature);
    for (int iteration = 0; iteration < max_newton; ++iteration) {
        build_system(factor, temperature);
        shell_slopes_ = current.source_slope;
        DEADPOINT_PETSC(MatMult(mass_, temperature, work_));
        DEADPOINT_PETSC(VecAXPY(work_, -factor, current.vector));
        DEADPOINT_PETSC(VecAXPY(work_, -1, known));
        double* residual = nullptr;
        DEADPOINT_PETSC(VecGetArray(work_, &residual));
        for (const PetscInt row : prescribed_)
            residual[row - space_.first] = 0;
        DEADPOINT_PETSC(VecRestoreArray(work_, &residual));
        set_tolerance(1e-13, problem_.solver_tolerance);
        iterations_ += solve(solver_, work_, work2_, "the temperature field");
        ++solves_;
        DEADPOINT_PETSC(VecAXPY(temperature, -1, work2_));
        require_finite(temperature, time);

        HeatRate updated = rate(time, temperature);
        const auto corrections = tangent_less_law(current, updated);
        double curvature = 0, total = 1e-300;
        for (std::size_t r = 0; r < corrections.size(); ++r) {
            curvature += std::abs(corrections[r]);
            total += std::abs(updated.source_heat[r]);
        }
        PetscReal change = 0;
        if (variable_films_)
            DEADPOINT_PETSC(VecNorm(work2_, NORM_INFINITY, &change));
        current = std::move(updated);
        if (curvature <= largest_curvature * total && change < 1e-7) {
            correct_heat(current, corrections);
            return current;
        }
    }
    throw ConvergenceError("joint heat and temperatures did not agree within " + std::to_string(max_newton) +
                           " iterations at t = " + std::to_string(time) +
                           " s; a heat law or film coefficient probably jumps, smooth it or shorten max_step");
}

// What the tangent of the law, with which the solve was made, gives less the law itself, per source.
std::vector<double> HeatSolver::tangent_less_law(const HeatRate& before, const HeatRate& after) const
{
    std::vector<double> result;
    for (std::size_t r = 0; r < after.source_heat.size(); ++r)
        result.push_back(before.source_heat[r] + before.source_slope[r] * source_change(r, before, after) -
                         after.source_heat[r]);
    return result;
}

void HeatSolver::correct_heat(HeatRate& rate, const std::vector<double>& corrections) const
{
    for (std::size_t r = 0; r < corrections.size(); ++r) {
        add_to(rate.vector, source_loads_[r], corrections[r]);
        rate.source_heat[r] += corrections[r];
        rate.source_temperature[r] += source_self_[r] * corrections[r];
        rate.generated += corrections[r];
        rate.to_oil += source_to_oil_[r] * corrections[r];
    }
}

double HeatSolver::source_change(std::size_t r, const HeatRate& before, const HeatRate& after) const
{
    // The solid part of the film temperature, without the row's own heat.
    return (after.source_temperature[r] - source_self_[r] * after.source_heat[r]) -
           (before.source_temperature[r] - source_self_[r] * before.source_heat[r]);
}

// The cubic through values and slopes at both ends of an interval of length h, at the place s (0 and 1 are its ends).
void HeatSolver::hermite(Vec start, Vec start_slope, Vec end, Vec end_slope, double h, double s, Vec result)
{
    const std::array<double, 4> weights{(1 + 2 * s) * (1 - s) * (1 - s), h * s * (1 - s) * (1 - s), s * s * (3 - 2 * s),
                                        h * s * s * (s - 1)};
    std::array<Vec, 4> vectors{start, start_slope, end, end_slope};
    DEADPOINT_PETSC(VecSet(result, 0));
    DEADPOINT_PETSC(VecMAXPY(result, 4, weights.data(), vectors.data()));
}

HeatSolver::Step HeatSolver::step(double time, double dt)
{
    const double factor = diagonal * dt;

    // Predict the first stage from the last step, the second through the first stage.
    const double to_middle = gamma_stage * dt;
    if (previous_dt_ > 0)
        hermite(before_, slope_before_, now_, slope_now_, previous_dt_, 1 + to_middle / previous_dt_, middle_);
    else {
        DEADPOINT_PETSC(VecCopy(now_, middle_));
        if (have_previous_)
            DEADPOINT_PETSC(VecAXPY(middle_, to_middle, slope_now_));
    }
    OwnedVec known = duplicate(now_);
    DEADPOINT_PETSC(MatMult(mass_, now_, known));
    DEADPOINT_PETSC(VecAXPY(known, factor, rate_now_.vector));
    rate_middle_ = solve_stage(time + gamma_stage * dt, factor, known, middle_);

    DEADPOINT_PETSC(VecCopy(middle_, error_));
    DEADPOINT_PETSC(VecAXPBY(error_, -bdf_now, bdf_middle, now_));
    DEADPOINT_PETSC(MatMult(mass_, error_, known));
    DEADPOINT_PETSC(VecWAXPY(slope_middle_, -1, now_, middle_));
    DEADPOINT_PETSC(VecScale(slope_middle_, 1 / factor));
    if (have_previous_) {
        DEADPOINT_PETSC(VecAXPY(slope_middle_, -1, slope_now_));
        hermite(now_, slope_now_, middle_, slope_middle_, to_middle, 1 / gamma_stage, next_);
    } else {
        DEADPOINT_PETSC(VecCopy(now_, next_));
        DEADPOINT_PETSC(VecAXPY(next_, 1 / gamma_stage, middle_));
        DEADPOINT_PETSC(VecAXPY(next_, -1 / gamma_stage, now_));
    }
    rate_next_ = solve_stage(time + dt, factor, known, next_);

    // slope at the end, from the second stage's own formula
    DEADPOINT_PETSC(VecCopy(next_, slope_next_));
    DEADPOINT_PETSC(VecAXPY(slope_next_, -1, error_));
    DEADPOINT_PETSC(VecScale(slope_next_, 1 / factor));

    Step result;
    result.from_prescribed = prescribed_heat(dt);

    if (problem_.fixed_step > 0)
        return result;
    estimate_error(dt);
    for (const double e : evaluate(watched_, error_))
        result.error = std::max(result.error, std::abs(e));
    return result;
}

// Of the step, into error_: the difference to the companion method. The slopes of both stages come from their own
// formulas. Where the first slope is not known, as at the start of a segment, the difference of the rates is filtered
// by the step's matrix, which takes out stiff transients; the second stage damps them in every later step.
void HeatSolver::estimate_error(double dt)
{
    if (have_previous_) {
        DEADPOINT_PETSC(VecSet(error_, 0));
        DEADPOINT_PETSC(VecAXPY(error_, dt * error_weights[0], slope_now_));
        DEADPOINT_PETSC(VecAXPY(error_, dt * error_weights[1], slope_middle_));
        DEADPOINT_PETSC(VecAXPY(error_, dt * error_weights[2], slope_next_));
        return;
    }
    DEADPOINT_PETSC(VecCopy(rate_now_.vector, work_));
    DEADPOINT_PETSC(VecScale(work_, dt * error_weights[0]));
    DEADPOINT_PETSC(VecAXPY(work_, dt * error_weights[1], rate_middle_.vector));
    DEADPOINT_PETSC(VecAXPY(work_, dt * error_weights[2], rate_next_.vector));
    double* residual = nullptr;
    DEADPOINT_PETSC(VecGetArray(work_, &residual));
    for (const PetscInt row : prescribed_)
        residual[row - space_.first] = 0;
    DEADPOINT_PETSC(VecRestoreArray(work_, &residual));
    // sharp enough that all numbers of ranks take the same steps
    set_tolerance(1e-4, 1e-4 * problem_.time_tolerance);
    iterations_ += solve(solver_, work_, error_, "the error of a time step");
}

// What entered through nodes of prescribed temperature during the step: their stored heat less their other gains.
double HeatSolver::prescribed_heat(double dt)
{
    std::vector<double> sum{0};
    if (!problem_.surfaces.empty()) {
        DEADPOINT_PETSC(VecWAXPY(work2_, -1, now_, next_));
        DEADPOINT_PETSC(MatMult(mass_, work2_, work_));
        DEADPOINT_PETSC(VecAXPY(work_, -dt * outer_weight, rate_now_.vector));
        DEADPOINT_PETSC(VecAXPY(work_, -dt * outer_weight, rate_middle_.vector));
        DEADPOINT_PETSC(VecAXPY(work_, -dt * diagonal, rate_next_.vector));
        const double* values = nullptr;
        DEADPOINT_PETSC(VecGetArrayRead(work_, &values));
        for (const PetscInt row : prescribed_)
            sum[0] += values[row - space_.first];
        DEADPOINT_PETSC(VecRestoreArrayRead(work_, &values));
    }
    sum_over_ranks(sum);
    return sum[0];
}

void HeatSolver::write_fields_until(double from, double dt, const FieldCallback& on_field)
{
    const auto& times = problem_.field_times;
    while (next_field_ < times.size() && times[next_field_] <= from + dt * (1 + 1e-12)) {
        const double s = std::clamp((times[next_field_] - from) / dt, 0.0, 1.0);
        hermite(now_, slope_now_, next_, slope_next_, dt, s, work_);
        Field field;
        const double* values = nullptr;
        DEADPOINT_PETSC(VecGetArrayRead(work_, &values));
        field.owned.assign(values, values + (space_.last - space_.first));
        DEADPOINT_PETSC(VecRestoreArrayRead(work_, &values));
        if (on_field)
            on_field(times[next_field_], field);
        ++next_field_;
    }
}

std::vector<double> HeatSolver::observed(Vec vector, bool is_rate) const
{
    std::vector<const SparseFunctional*> scalars;
    for (const auto& probe : probes_)
        scalars.push_back(&probe);
    for (const auto& interface : interfaces_)
        scalars.push_back(&interface.mean_a);
    for (const auto& interface : interfaces_)
        scalars.push_back(&interface.mean_b);
    for (const auto& part : part_means_)
        scalars.push_back(&part);
    auto values = evaluate(scalars, vector);

    std::vector<double> sums(adjoints_->size() + space_.machine.parts.size(), 0.0);
    const double* data = nullptr;
    DEADPOINT_PETSC(VecGetArrayRead(vector, &data));
    const double reference = is_rate ? 0 : reference_;
    for (std::size_t k = 0; k < adjoints_->size(); ++k) {
        const auto& weights = (*adjoints_)[k].owned;
        for (std::size_t i = 0; i < weights.size(); ++i)
            sums[k] += weights[i] * (data[i] - reference);
    }
    if (attribution_ >= 0) {
        const auto& weights = (*adjoints_)[attribution_].owned;
        for (std::size_t i = 0; i < weights.size(); ++i)
            sums[adjoints_->size() + part_of_unknown_[i]] += weights[i] * (data[i] - reference);
    }
    DEADPOINT_PETSC(VecRestoreArrayRead(vector, &data));
    sum_over_ranks(sums);
    values.insert(values.end(), sums.begin(), sums.end());
    return values;
}

void HeatSolver::record(ThermalHistory& history, double time, const HeatRate& rate)
{
    const auto values = observed(now_, false);
    const auto rates = have_previous_ ? observed(slope_now_, true) : std::vector<double>(values.size(), 0.0);
    history.time.push_back(time);
    std::size_t k = 0;
    for (auto* group :
         {&history.probes, &history.interface_a, &history.interface_b, &history.part_means, &history.functionals})
        for (auto& series : *group) {
            series.value.push_back(values[k]);
            series.rate.push_back(rates[k]);
            ++k;
        }
    for (auto& series : history.contributions)
        series.push_back(values[k++]);
    for (std::size_t r = 0; r < rate.source_heat.size(); ++r) {
        history.source_heat[r].push_back(rate.source_heat[r]);
        history.source_temperature[r].push_back(rate.source_temperature[r]);
    }
    history.to_air.push_back(rate.to_air);
    history.to_oil.push_back(rate.to_oil);
    history.law_out_of_range = history.law_out_of_range || !rate.in_range;
    for (std::size_t i = 0; i < rate.films_untested.size(); ++i)
        if (rate.films_untested[i] > 0)
            history.film_out_of_range[i] = true;
}

namespace {

// The slope where a segment starts is not known from a step; the first step's secant stands for it.
void fill_first_rates(ThermalHistory& history, std::size_t start)
{
    if (start + 1 >= history.time.size())
        return;
    const double dt = history.time[start + 1] - history.time[start];
    for (auto* group :
         {&history.probes, &history.interface_a, &history.interface_b, &history.part_means, &history.functionals})
        for (auto& series : *group)
            series.rate[start] = (series.value[start + 1] - series.value[start]) / dt;
}

// The largest step of the geometric ladder that ends well: no sliver is left for a last step.
double fit_step(double wanted, double remaining)
{
    if (remaining <= wanted * (1 + 1e-9))
        return remaining;
    return remaining < 2 * wanted ? remaining / 2 : wanted;
}

bool any_rank(bool flag)
{
    int value = flag ? 1 : 0;
    MPI_Allreduce(MPI_IN_PLACE, &value, 1, MPI_INT, MPI_MAX, MPI_COMM_WORLD);
    return value != 0;
}

}  // namespace

ThermalHistory HeatSolver::run(const std::vector<Adjoint>& adjoints, double reference_temperature, int attribution,
                               Observer& observer, const StepCallback& on_step, const FieldCallback& on_field)
{
    prepare_observers(adjoints, reference_temperature, attribution);
    ThermalHistory history;
    history.probes.resize(probes_.size());
    history.interface_a.resize(interfaces_.size());
    history.interface_b.resize(interfaces_.size());
    history.part_means.resize(part_means_.size());
    history.functionals.resize(adjoints.size());
    history.contributions.resize(attribution >= 0 ? part_means_.size() : 0);
    history.source_heat.resize(problem_.sources.size());
    history.source_temperature.resize(problem_.sources.size());
    history.film_out_of_range.assign(problem_.surfaces.size(), false);

    double time = 0;
    for (const auto& segment : problem_.segments) {
        segment_ = &segment;
        const double end = time + segment.duration;
        const std::size_t start = history.time.size();
        have_previous_ = false;
        previous_dt_ = 0;
        if (history.time.empty())
            impose(time, now_);
        rate_now_ = rate(time, now_);
        record(history, time, rate_now_);
        double wanted = problem_.fixed_step > 0 ? problem_.fixed_step : problem_.initial_step;
        while (time < end * (1 - 1e-14)) {
            const double dt = fit_step(wanted, end - time);
            const Step outcome = step(time, dt);
            if (problem_.fixed_step <= 0 && outcome.error > problem_.time_tolerance) {
                ++history.rejected_steps;
                wanted = dt * rungs(outcome.error, -20, -1);
                if (dt < 1e-6)
                    throw ConvergenceError("the time step collapsed below 1 us at t = " + std::to_string(time) +
                                           " s; loosen numerics.time_tolerance or look for a law that jumps");
                continue;
            }
            if (!have_previous_) {
                DEADPOINT_PETSC(VecWAXPY(slope_now_, -1, now_, next_));
                DEADPOINT_PETSC(VecScale(slope_now_, 1 / dt));
            }
            write_fields_until(time, dt, on_field);
            add_energy(history.energy, dt, outcome.from_prescribed);
            std::swap(before_, now_);
            std::swap(now_, next_);
            previous_dt_ = have_previous_ ? dt : 0;
            DEADPOINT_PETSC(VecCopy(slope_now_, slope_before_));
            std::swap(slope_now_, slope_next_);
            rate_now_ = std::move(rate_next_);
            have_previous_ = true;
            time = end - time <= dt * (1 + 1e-12) ? end : time + dt;
            record(history, time, rate_now_);
            if (history.time.size() == start + 2)
                fill_first_rates(history, start);
            if (on_step)
                on_step(time);
            if (problem_.fixed_step <= 0 && dt >= 0.99 * wanted)
                wanted = std::min(wanted * rungs(outcome.error, 0, 1), problem_.max_step);
            if (any_rank(observer.cancelled())) {
                history.interrupted = true;
                break;
            }
        }
        if (history.interrupted)
            break;
    }
    history.linear_iterations = iterations_;
    history.linear_solves = solves_;
    return history;
}

// The factor by which a step may grow or must shrink, in whole rungs of the ladder of step sizes.
double HeatSolver::rungs(double error, int least, int most) const
{
    const double allowed = 0.9 * std::cbrt(problem_.time_tolerance / std::max(error, 1e-30));
    return std::pow(ladder, std::clamp(std::floor(std::log(allowed) / std::log(ladder)), 1.0 * least, 1.0 * most));
}

void HeatSolver::add_energy(EnergyBalance& energy, double dt, double from_prescribed)
{
    const auto over_step = [&](double HeatRate::*part) {
        return dt * (outer_weight * (rate_now_.*part + rate_middle_.*part) + diagonal * rate_next_.*part);
    };
    energy.generated += over_step(&HeatRate::generated);
    energy.to_air += over_step(&HeatRate::to_air);
    energy.to_oil += over_step(&HeatRate::to_oil);
    energy.from_surfaces += over_step(&HeatRate::flux) + from_prescribed;
    DEADPOINT_PETSC(VecWAXPY(work2_, -1, now_, next_));
    DEADPOINT_PETSC(MatMult(mass_, work2_, work_));
    PetscScalar stored = 0;
    DEADPOINT_PETSC(VecSum(work_, &stored));
    energy.stored += stored;
}

void HeatSolver::start_from(const Field& field)
{
    double* values = nullptr;
    DEADPOINT_PETSC(VecGetArray(now_, &values));
    std::copy(field.owned.begin(), field.owned.end(), values);
    DEADPOINT_PETSC(VecRestoreArray(now_, &values));
}

}  // namespace deadpoint::fem
