#include "deadpoint/fem/heat_solver.hpp"
#include "deadpoint/fem/tr_bdf2.hpp"

#include <algorithm>
#include <cmath>

// Enclosed air: one unknown T_e per enclosure beside the field,
//   C dT_e/dt = q_e,    q_e = sum over its surfaces of the film heat + G (T_room - T_e) + P,
// in the stages of the field. With the slopes b_i = integral of h phi_i over its surfaces and f = d dt a stage solves
//   [ A     -f b                 ] [ change of T   ]     [ R   ]
//   [ -f b^T  C + f (sum b + G)  ] [ change of T_e ] = - [ R_e ]
// T_e is taken out: A - f^2 b b^T / c_e stays positive definite, c_e = C + f (sum b + G).

namespace deadpoint::fem {

void HeatSolver::prepare_enclosures()
{
    for (std::size_t k = 0; k < problem_->enclosures.size(); ++k) {
        air_.emplace_back();
        air_.back().load = duplicate(now_);
    }
}

// At the field's present temperature; `values` of all ranks, where a film follows the temperature.
void HeatSolver::build_air_loads(const double* values)
{
    for (std::size_t k = 0; k < air_.size(); ++k) {
        auto& air = air_[k];
        DEADPOINT_PETSC(VecSet(air.load, 0));
        for (const auto& film : films_) {
            const auto& condition = *film.condition;
            if (condition.enclosure != static_cast<int>(k))
                continue;
            if (!depends_on_temperature(condition)) {
                add_to(air.load, film.integral, condition.coefficient);
                continue;
            }
            const auto law = film_at(condition, air.now);
            for (const auto& point : film.points) {
                const double at = value_at(point.shape, values);
                const double slope = film_slope(law(at), 0, at, air.now);
                for (int i = 0; i < point.shape.count; ++i)
                    DEADPOINT_PETSC(VecSetValue(air.load, point.shape.dof[i],
                                                slope * point.weight * point.shape.value[i], ADD_VALUES));
            }
        }
        DEADPOINT_PETSC(VecAssemblyBegin(air.load));
        DEADPOINT_PETSC(VecAssemblyEnd(air.load));
        DEADPOINT_PETSC(VecSum(air.load, &air.conductance));
        double* load = nullptr;
        DEADPOINT_PETSC(VecGetArray(air.load, &load));
        for (const PetscInt row : prescribed_)
            load[row - space_.first] = 0;
        DEADPOINT_PETSC(VecRestoreArray(air.load, &load));
    }
}

double HeatSolver::air_pivot(std::size_t k) const
{
    const auto& enclosure = problem_->enclosures[k];
    return enclosure.capacity + system_factor_ * (air_[k].conductance + enclosure.exchange);
}

PetscErrorCode HeatSolver::add_air(Vec in, Vec out) const
{
    for (std::size_t k = 0; k < air_.size(); ++k) {
        PetscScalar product = 0;
        VecDot(air_[k].load, in, &product);
        VecAXPY(out, -system_factor_ * system_factor_ * product / air_pivot(k), air_[k].load);
    }
    return 0;
}

// Of a stage, with the temperatures as last iterated.
std::vector<double> HeatSolver::air_residual(const HeatRate& rate, double factor) const
{
    std::vector<double> residual;
    for (std::size_t k = 0; k < air_.size(); ++k)
        residual.push_back(problem_->enclosures[k].capacity * air_[k].now - factor * rate.air[k].kept() -
                           air_[k].known);
    return residual;
}

void HeatSolver::take_air_out(const std::vector<double>& residual, Vec field_residual) const
{
    for (std::size_t k = 0; k < air_.size(); ++k)
        DEADPOINT_PETSC(VecAXPY(field_residual, system_factor_ * residual[k] / air_pivot(k), air_[k].load));
}

// The air's part of the solution whose field part is `solution`.
std::vector<double> HeatSolver::air_solution(const std::vector<double>& residual, Vec solution) const
{
    std::vector<double> result;
    for (std::size_t k = 0; k < air_.size(); ++k) {
        PetscScalar product = 0;
        DEADPOINT_PETSC(VecDot(air_[k].load, solution, &product));
        result.push_back((residual[k] + system_factor_ * product) / air_pivot(k));
    }
    return result;
}

double HeatSolver::move_air(const std::vector<double>& residual, Vec solution)
{
    double largest = 0;
    const auto change = air_solution(residual, solution);
    for (std::size_t k = 0; k < air_.size(); ++k) {
        air_[k].now -= change[k];
        largest = std::max(largest, std::abs(change[k]));
    }
    return largest;
}

void HeatSolver::add_enclosures(HeatRate& rate, double time) const
{
    for (std::size_t k = 0; k < air_.size(); ++k) {
        auto& flow = rate.air[k];
        flow.temperature = air_[k].now;
        flow.to_room = problem_->enclosures[k].exchange * (flow.temperature - segment_->ambient(time));
        if (!segment_->enclosure_power.empty() && segment_->enclosure_power[k])
            flow.power = segment_->enclosure_power[k](time);
        rate.generated += flow.power;
        rate.to_air += flow.to_room;
    }
}

void HeatSolver::begin_first_air_stage(double dt)
{
    for (std::size_t k = 0; k < air_.size(); ++k) {
        auto& air = air_[k];
        air.now = air.start + (have_previous_ ? gamma_stage * dt * air.slope : 0);
        air.known = problem_->enclosures[k].capacity * air.start + diagonal * dt * rate_now_.air[k].kept();
    }
}

void HeatSolver::begin_second_air_stage()
{
    for (std::size_t k = 0; k < air_.size(); ++k) {
        auto& air = air_[k];
        air.middle = air.now;
        air.known = problem_->enclosures[k].capacity * (bdf_middle * air.middle - bdf_now * air.start);
        air.now = air.start + (air.middle - air.start) / gamma_stage;
    }
}

// As estimate_error, whose solution stands in error_.
double HeatSolver::air_error(double dt) const
{
    double largest = 0;
    for (const auto& air : air_) {
        const double factor = diagonal * dt;
        const double middle = (air.middle - air.start) / factor - air.slope;
        const double end = (air.now - bdf_middle * air.middle + bdf_now * air.start) / factor;
        largest = std::max(largest, std::abs(dt * (error_weights[0] * air.slope + error_weights[1] * middle +
                                                   error_weights[2] * end)));
    }
    return largest;
}

std::vector<double> HeatSolver::first_air_error(double dt) const
{
    std::vector<double> residual;
    for (std::size_t k = 0; k < air_.size(); ++k)
        residual.push_back(dt *
                           (error_weights[0] * rate_now_.air[k].kept() + error_weights[1] * rate_middle_.air[k].kept() +
                            error_weights[2] * rate_next_.air[k].kept()));
    return residual;
}

double HeatSolver::accept_air(double dt)
{
    double stored = 0;
    for (std::size_t k = 0; k < air_.size(); ++k) {
        auto& air = air_[k];
        stored += problem_->enclosures[k].capacity * (air.now - air.start);
        air.slope = (air.now - bdf_middle * air.middle + bdf_now * air.start) / (diagonal * dt);
        air.start = air.now;
    }
    return stored;
}

}  // namespace deadpoint::fem
