#include "deadpoint/fem/conduction/heat_solver.hpp"

// What surfaces and the room give to enclosed air; its equation is in enclosed_air.cpp.

namespace deadpoint::fem {

// Slopes of the films by the temperature of the air they face, at the field's present temperature.
// @param values  of all ranks, where a film follows the temperature
void HeatSolver::build_air_loads(double factor, const double* values)
{
    for (std::size_t k = 0; k < air_->count(); ++k) {
        Vec load = air_->load(k);
        DEADPOINT_PETSC(VecSet(load, 0));
        for (const auto& film : films_) {
            const auto& condition = *film.condition;
            if (condition.enclosure != static_cast<int>(k))
                continue;
            if (!depends_on_temperature(condition)) {
                add_to(load, film.integral, condition.coefficient);
                continue;
            }
            const double air = air_->temperature(k);
            const auto law = film_at(condition, air);
            for (const auto& point : film.points) {
                const double at = value_at(point.shape, values);
                const double slope = film_slope(law(at), 0, at, air);
                for (int i = 0; i < point.shape.count; ++i)
                    DEADPOINT_PETSC(
                        VecSetValue(load, point.shape.dof[i], slope * point.weight * point.shape.value[i], ADD_VALUES));
            }
        }
    }
    std::vector<PetscInt> held;
    for (const PetscInt row : prescribed_)
        held.push_back(row - space_.first);
    air_->set_factor(factor, held);
}

void HeatSolver::add_enclosures(HeatRate& rate, double time) const
{
    for (std::size_t k = 0; k < air_->count(); ++k) {
        auto& flow = rate.air[k];
        flow.temperature = air_->temperature(k);
        flow.to_room = problem_->enclosures[k].exchange * (flow.temperature - segment_->ambient(time));
        if (!segment_->enclosure_power.empty() && segment_->enclosure_power[k])
            flow.power = segment_->enclosure_power[k](time);
        rate.generated += flow.power;
        rate.to_air += flow.to_room;
    }
}

}  // namespace deadpoint::fem
