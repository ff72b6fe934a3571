#include "deadpoint/exchange/step_tolerance.hpp"
#include "deadpoint/fem/conduction/heat_solver.hpp"
#include "deadpoint/fem/conduction/tr_bdf2.hpp"

#include <algorithm>
#include <cmath>

// Oil circuits. Where the oil is within a step is found together with the field: each Newton iteration of a stage takes
// the oil as the last one left it.

namespace deadpoint::fem {
namespace {

constexpr double settled = 1e-9;  // [K]

}  // namespace

// Temperature after the last joint. The films follow the oil that reaches them.
double HeatSolver::oil_outlet(std::size_t circuit, double inlet, const HeatRate& rate,
                              std::vector<double>& reaches) const
{
    const double flow = segment_->oil_flow[circuit];
    double oil = inlet;
    for (const auto& joint : problem_->oil[circuit].joints) {
        double heat = 0;
        for (const int i : joint) {
            const double g = (*laws_)[i].oil;
            const double film = rate.film[i] + g / interfaces_[i].sum * (oil - oil_temperature_[i]);
            heat += g * interfaces_[i].area * (film - oil);
            reaches[i] = oil;
        }
        if (flow > 0)
            oil += heat / flow;
    }
    return oil;
}

// The sump at the end of a stage:  C s = C known + factor (flow (outlet - s) - loss (s - ambient)),  where the outlet
// rises with s itself if no cooler stands between. A sump without capacity follows at once.
std::vector<double> HeatSolver::follow_oil(HeatRate& rate, double time, double factor,
                                           const std::vector<double>& known) const
{
    auto reaches = oil_temperature_;
    rate.oil.resize(problem_->oil.size());
    for (std::size_t k = 0; k < problem_->oil.size(); ++k) {
        const auto& circuit = problem_->oil[k];
        const double flow = segment_->oil_flow[k], loss = circuit.sump_loss, capacity = circuit.sump_capacity;
        const double step = capacity > 0 ? factor : 1;
        const double gains = capacity * known[k] + step * loss * segment_->ambient(time);
        double leaving = loss + flow;  // of the sump, per kelvin
        auto& state = rate.oil[k];
        if (circuit.cooled) {
            state.inlet = circuit.inlet_temperature;
            state.outlet = oil_outlet(k, state.inlet, rate, reaches);
            const double losses = capacity + step * leaving;
            state.sump = losses > 0 ? (gains + step * flow * state.outlet) / losses : known[k];
        } else {
            const double at_known = oil_outlet(k, known[k], rate, reaches);
            const double slope = oil_outlet(k, known[k] + 1, rate, reaches) - at_known;
            leaving -= flow * slope;
            const double losses = capacity + step * leaving;
            const double sources = gains + step * flow * (at_known - slope * known[k]);
            state.sump = losses > 0 ? sources / losses : known[k];
            state.inlet = state.sump;
            state.outlet = oil_outlet(k, state.inlet, rate, reaches);
        }
        state.heat = flow * (state.outlet - state.inlet);
        state.cooler = circuit.cooled ? flow * (state.sump - state.inlet) : 0;
        const double kept = flow * (state.outlet - state.sump) - loss * (state.sump - segment_->ambient(time));
        state.sump_rate = capacity > 0 ? kept / capacity : 0;
        state.sump_relaxation = capacity > 0 ? leaving / capacity : 0;
    }
    return reaches;
}

// Largest of the sumps' errors of the step [K], as estimate_error(). Their slopes are known from the start; in the
// first step of a segment the estimate is filtered by the stage's own equation, as that of the field is. A sump forgets
// an error with its own relaxation only: those of as many steps add up, and together they must keep to the time
// tolerance.
double HeatSolver::oil_error(double dt) const
{
    const double of_a_step = step_tolerance(problem_->time_tolerance) / problem_->time_tolerance;
    double largest = 0;
    for (std::size_t k = 0; k < rate_now_.oil.size(); ++k) {
        const double relaxation = rate_next_.oil[k].sump_relaxation;
        const double filter = have_previous_ ? 1 : 1 + diagonal * dt * relaxation;
        const double forgotten = std::max(-std::expm1(-dt * relaxation), dt / segment_->duration);
        const double error =
            step_error(dt, rate_now_.oil[k].sump_rate, rate_middle_.oil[k].sump_rate, rate_next_.oil[k].sump_rate);
        largest = std::max(largest, std::abs(error) / filter * std::max(1.0, of_a_step / forgotten));
    }
    return largest;
}

// Takes over where the oil reaches each interface; returns the largest change [K].
double HeatSolver::set_oil(const std::vector<double>& temperature)
{
    double change = 0;
    for (std::size_t i = 0; i < temperature.size(); ++i)
        change = std::max(change, std::abs(temperature[i] - oil_temperature_[i]));
    oil_temperature_ = temperature;
    for (std::size_t r = 0; r < source_constant_.size(); ++r)
        source_constant_[r] = 0;
    for (std::size_t i = 0; i < interfaces_.size(); ++i)
        if (const auto& law = (*laws_)[i]; law.source >= 0)
            source_constant_[law.source] +=
                interfaces_[i].film_heat * law.oil * oil_temperature_[i] / interfaces_[i].sum;
    return change;
}

// The oil at the start of a segment, for the field as it is, and the gains with it.
void HeatSolver::settle_oil(double time)
{
    rate_now_ = gains(time, now_);
    if (problem_->oil.empty())
        return;
    for (int i = 0; i < 100; ++i) {
        const auto reaches = follow_oil(rate_now_, time, 0, sump_);
        if (set_oil(reaches) < settled)
            return;
        auto flows = std::move(rate_now_.oil);
        rate_now_ = gains(time, now_);
        rate_now_.oil = std::move(flows);
    }
    throw ConvergenceError("oil and joints did not agree at t = " + std::to_string(time) +
                           " s; look at the flow and the coefficients of the oil circuits");
}

}  // namespace deadpoint::fem
