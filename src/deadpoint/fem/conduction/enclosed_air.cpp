#include "deadpoint/fem/conduction/enclosed_air.hpp"

#include "deadpoint/fem/conduction/tr_bdf2.hpp"

#include <algorithm>
#include <cmath>

namespace deadpoint::fem {

EnclosedAir::EnclosedAir(const std::vector<Enclosure>& enclosures, Vec pattern) : enclosures_(&enclosures)
{
    air_.resize(enclosures.size());
    for (auto& air : air_)
        DEADPOINT_PETSC(VecDuplicate(pattern, air.load.out()));
}

void EnclosedAir::start_from(const std::vector<double>& temperature)
{
    for (std::size_t k = 0; k < air_.size(); ++k)
        air_[k].start = air_[k].now = temperature.at(k);
}

std::vector<AirState> EnclosedAir::between_steps() const
{
    std::vector<AirState> result;
    for (const auto& air : air_)
        result.push_back({air.start, air.slope, air.now});
    return result;
}

void EnclosedAir::go_on_from(const std::vector<AirState>& states)
{
    for (std::size_t k = 0; k < air_.size(); ++k) {
        air_[k].start = states[k].start;
        air_[k].slope = states[k].slope;
        air_[k].now = states[k].now;
    }
}

std::vector<double> EnclosedAir::at_start() const
{
    std::vector<double> result;
    for (const auto& air : air_)
        result.push_back(air.start);
    return result;
}

void EnclosedAir::set_factor(double factor, const std::vector<PetscInt>& held)
{
    factor_ = factor;
    for (auto& air : air_) {
        DEADPOINT_PETSC(VecAssemblyBegin(air.load));
        DEADPOINT_PETSC(VecAssemblyEnd(air.load));
        DEADPOINT_PETSC(VecSum(air.load, &air.conductance));
        double* load = nullptr;
        DEADPOINT_PETSC(VecGetArray(air.load, &load));
        for (const PetscInt row : held)
            load[row] = 0;
        DEADPOINT_PETSC(VecRestoreArray(air.load, &load));
    }
}

double EnclosedAir::pivot(std::size_t k) const
{
    const auto& enclosure = (*enclosures_)[k];
    return enclosure.capacity + factor_ * (air_[k].conductance + enclosure.exchange);
}

void EnclosedAir::multiply(Vec in, Vec out) const
{
    for (std::size_t k = 0; k < air_.size(); ++k) {
        PetscScalar product = 0;
        DEADPOINT_PETSC(VecDot(air_[k].load, in, &product));
        DEADPOINT_PETSC(VecAXPY(out, -factor_ * factor_ * product / pivot(k), air_[k].load));
    }
}

void EnclosedAir::begin_first_stage(double dt, bool slope_known, const HeatRate& at_start)
{
    for (std::size_t k = 0; k < air_.size(); ++k) {
        auto& air = air_[k];
        air.now = air.start + (slope_known ? gamma_stage * dt * air.slope : 0);
        air.known = (*enclosures_)[k].capacity * air.start + diagonal * dt * at_start.air[k].kept();
    }
}

void EnclosedAir::begin_second_stage()
{
    for (std::size_t k = 0; k < air_.size(); ++k) {
        auto& air = air_[k];
        air.middle = air.now;
        air.known = (*enclosures_)[k].capacity * (bdf_middle * air.middle - bdf_now * air.start);
        air.now = air.start + (air.middle - air.start) / gamma_stage;
    }
}

std::vector<double> EnclosedAir::residual(const HeatRate& rate) const
{
    std::vector<double> result;
    for (std::size_t k = 0; k < air_.size(); ++k)
        result.push_back((*enclosures_)[k].capacity * air_[k].now - factor_ * rate.air[k].kept() - air_[k].known);
    return result;
}

void EnclosedAir::take_out(const std::vector<double>& residual, Vec field_residual) const
{
    for (std::size_t k = 0; k < air_.size(); ++k)
        DEADPOINT_PETSC(VecAXPY(field_residual, factor_ * residual[k] / pivot(k), air_[k].load));
}

std::vector<double> EnclosedAir::solution(const std::vector<double>& residual, Vec solution) const
{
    std::vector<double> result;
    for (std::size_t k = 0; k < air_.size(); ++k) {
        PetscScalar product = 0;
        DEADPOINT_PETSC(VecDot(air_[k].load, solution, &product));
        result.push_back((residual[k] + factor_ * product) / pivot(k));
    }
    return result;
}

double EnclosedAir::move(const std::vector<double>& residual, Vec field_solution)
{
    double largest = 0;
    const auto change = solution(residual, field_solution);
    for (std::size_t k = 0; k < air_.size(); ++k) {
        air_[k].now -= change[k];
        largest = std::max(largest, std::abs(change[k]));
    }
    return largest;
}

double EnclosedAir::slope_at_end(const Air& air, double dt) { return end_slope(air.start, air.middle, air.now, dt); }

double EnclosedAir::error(double dt) const
{
    double largest = 0;
    for (const auto& air : air_) {
        const double middle = (air.middle - air.start) / (diagonal * dt) - air.slope;
        largest = std::max(largest, std::abs(step_error(dt, air.slope, middle, slope_at_end(air, dt))));
    }
    return largest;
}

std::vector<double> EnclosedAir::first_error(double dt, const std::array<const HeatRate*, 3>& rates) const
{
    std::vector<double> result(air_.size(), 0.0);
    for (std::size_t k = 0; k < air_.size(); ++k)
        for (std::size_t i = 0; i < rates.size(); ++i)
            result[k] += dt * error_weights[i] * rates[i]->air[k].kept();
    return result;
}

double EnclosedAir::accept(double dt)
{
    double stored = 0;
    for (std::size_t k = 0; k < air_.size(); ++k) {
        auto& air = air_[k];
        stored += (*enclosures_)[k].capacity * (air.now - air.start);
        air.slope = slope_at_end(air, dt);
        air.start = air.now;
    }
    return stored;
}

}  // namespace deadpoint::fem
