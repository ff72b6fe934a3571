#include "deadpoint/fem/conduction/heat_solver.hpp"
#include "deadpoint/fem/conduction/tr_bdf2.hpp"

#include <algorithm>

// What a run remembers of its steps.

namespace deadpoint::fem {

ThermalHistory HeatSolver::empty_history() const
{
    ThermalHistory history;
    history.probes.resize(probes_.size());
    history.interface_a.resize(interfaces_.size());
    history.interface_b.resize(interfaces_.size());
    history.part_means.resize(part_means_.size());
    history.functionals.resize(adjoints_->size());
    history.contributions.resize(static_cast<std::size_t>(attribution_.count) * part_means_.size());
    history.source_heat.resize(problem_->sources.size());
    history.source_temperature.resize(problem_->sources.size());
    history.body_heat.resize(problem_->body_heat.size());
    history.oil.resize(problem_->oil.size());
    history.enclosures.resize(problem_->enclosures.size());
    history.film_out_of_range.assign(problem_->surfaces.size(), false);
    return history;
}

void HeatSolver::write_fields_until(double from, double dt, const FieldCallback& on_field)
{
    const auto& times = problem_->field_times;
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

    const auto split = static_cast<std::size_t>(attribution_.count), parts = space_.machine.parts.size();
    std::vector<double> sums(adjoints_->size() + split * parts, 0.0);
    const double *data = nullptr, *temperature = nullptr;
    DEADPOINT_PETSC(VecGetArrayRead(vector, &data));
    DEADPOINT_PETSC(VecGetArrayRead(now_, &temperature));
    const auto rise = [&](std::size_t i) {
        return is_rate ? expansion_.slope(i, temperature[i]) * data[i] : expansion_.rise(i, data[i], reference_);
    };
    for (std::size_t k = 0; k < adjoints_->size(); ++k) {
        const auto& weights = (*adjoints_)[k].owned;
        for (std::size_t i = 0; i < weights.size(); ++i)
            sums[k] += weights[i] * rise(i);
    }
    for (std::size_t k = 0; k < split; ++k) {
        const auto& weights = (*adjoints_)[static_cast<std::size_t>(attribution_.first) + k].owned;
        for (std::size_t i = 0; i < weights.size(); ++i)
            sums[adjoints_->size() + k * parts + static_cast<std::size_t>(part_of_unknown_[i])] += weights[i] * rise(i);
    }
    DEADPOINT_PETSC(VecRestoreArrayRead(now_, &temperature));
    DEADPOINT_PETSC(VecRestoreArrayRead(vector, &data));
    sum_over_ranks(sums);
    values.insert(values.end(), sums.begin(), sums.end());
    return values;
}

namespace {

// Takes up the value of a scalar at the end of a step of length `dt`; without one its slope is left open.
void append(Series& series, double middle, double end, double dt)
{
    series.rate.push_back(dt > 0 ? end_slope(series.value.back(), middle, end, dt) : 0);
    series.value.push_back(end);
}

}  // namespace

void HeatSolver::record_media(ThermalHistory& history, const HeatRate& rate, double dt) const
{
    for (std::size_t c = 0; c < rate.oil.size(); ++c) {
        auto& circuit = history.oil[c];
        const auto& middle = dt > 0 ? rate_middle_.oil[c] : rate.oil[c];
        append(circuit.inlet, middle.inlet, rate.oil[c].inlet, dt);
        append(circuit.outlet, middle.outlet, rate.oil[c].outlet, dt);
        append(circuit.sump, middle.sump, rate.oil[c].sump, dt);
        circuit.heat.push_back(rate.oil[c].heat);
        circuit.cooler.push_back(rate.oil[c].cooler);
    }
    for (std::size_t e = 0; e < rate.air.size(); ++e) {
        auto& enclosure = history.enclosures[e];
        const auto& middle = dt > 0 ? rate_middle_.air[e] : rate.air[e];
        append(enclosure.temperature, middle.temperature, rate.air[e].temperature, dt);
        enclosure.from_surfaces.push_back(rate.air[e].from_surfaces);
        enclosure.power.push_back(rate.air[e].power);
        enclosure.to_room.push_back(rate.air[e].to_room);
    }
}

void HeatSolver::record(ThermalHistory& history, double time, const HeatRate& rate)
{
    note_extremes();
    record_media(history, rate, have_previous_ ? time - history.time.back() : 0);
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
    for (std::size_t b = 0; b < rate.body_heat.size(); ++b)
        history.body_heat[b].push_back(rate.body_heat[b]);
    history.to_air.push_back(rate.to_air);
    history.to_oil.push_back(rate.to_oil);
    history.law_out_of_range = history.law_out_of_range || !rate.in_range;
    for (std::size_t i = 0; i < rate.films_untested.size(); ++i)
        if (rate.films_untested[i] > 0)
            history.film_out_of_range[i] = true;
}

// The slope where a segment starts is not known from a step; the first step's secant stands for it.
void HeatSolver::fill_first_rates(ThermalHistory& history, std::size_t start)
{
    if (start + 1 >= history.time.size())
        return;
    const double dt = history.time[start + 1] - history.time[start];
    const auto fill = [&](Series& series) {
        series.rate[start] = (series.value[start + 1] - series.value[start]) / dt;
    };
    for (auto* group :
         {&history.probes, &history.interface_a, &history.interface_b, &history.part_means, &history.functionals})
        std::ranges::for_each(*group, fill);
    for (auto& circuit : history.oil)
        for (auto* series : {&circuit.inlet, &circuit.outlet, &circuit.sump})
            fill(*series);
    for (auto& enclosure : history.enclosures)
        fill(enclosure.temperature);
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
    heat_change(now_, next_, work2_);
    PetscScalar stored = 0;
    DEADPOINT_PETSC(VecDot(capacities_, work2_, &stored));
    energy.stored += stored;
}

}  // namespace deadpoint::fem
