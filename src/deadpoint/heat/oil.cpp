#include "deadpoint/heat/oil.hpp"

#include "deadpoint/exchange/heat.hpp"
#include "deadpoint/heat/balance.hpp"
#include "deadpoint/heat/joints.hpp"
#include "deadpoint/heat/tr_bdf2.hpp"

#include <algorithm>
#include <cmath>

namespace deadpoint::heat {

// Temperature after the last joint. The films follow the oil that reaches them.
double OilMarch::outlet(std::size_t circuit, double inlet, const JointBalance& joints, const HeatBalance& balance,
                        std::vector<double>& reaches) const
{
    const double flow = segment_->oil_flow[circuit];
    double oil = inlet;
    for (const auto& joint : problem_->oil[circuit].joints) {
        double heat = 0;
        for (const int index : joint) {
            const auto i = static_cast<std::size_t>(index);
            const double film = joints.film_with_oil(i, balance.film[i], oil);
            heat += joints.laws()[i].oil * joints.area(i) * (film - oil);
            reaches[i] = oil;
        }
        if (flow > 0)
            oil += heat / flow;
    }
    return oil;
}

// The sump at the end of a stage:  C s = C known + factor (flow (outlet - s) - loss (s - ambient)),  where the outlet
// rises with s itself if no cooler stands between.
void OilMarch::march_circuit(std::size_t k, const JointBalance& joints, HeatBalance& balance, double time,
                             double factor, double known, std::vector<double>& reaches) const
{
    const auto& circuit = problem_->oil[k];
    const double flow = segment_->oil_flow[k], loss = circuit.sump_loss, capacity = circuit.sump_capacity;
    const double step = capacity > 0 ? factor : 1;
    const double ambient = step_.value(segment_->ambient, time);
    const double gains = capacity * known + step * loss * ambient;
    const auto out = [&](double inlet) { return outlet(k, inlet, joints, balance, reaches); };
    double leaving = loss + flow;  // heat leaving the sump per kelvin
    OilFlow state;
    if (circuit.cooled) {
        state.inlet = circuit.inlet_temperature;
        state.outlet = out(state.inlet);
        const double losses = capacity + step * leaving;
        state.sump = losses > 0 ? (gains + step * flow * state.outlet) / losses : known;
    } else {
        const double at_known = out(known);
        const double slope = out(known + 1) - at_known;
        leaving -= flow * slope;
        const double losses = capacity + step * leaving;
        const double sources = gains + step * flow * (at_known - slope * known);
        state.sump = losses > 0 ? sources / losses : known;
        state.inlet = state.sump;
        state.outlet = out(state.inlet);
    }
    state.heat = flow * (state.outlet - state.inlet);
    state.cooler = circuit.cooled ? flow * (state.sump - state.inlet) : 0;
    const double kept = flow * (state.outlet - state.sump) - loss * (state.sump - ambient);
    state.sump_rate = capacity > 0 ? kept / capacity : 0;
    state.sump_relaxation = capacity > 0 ? leaving / capacity : 0;
    balance.oil[k] = state;
}

std::vector<double> OilMarch::march(const JointBalance& joints, HeatBalance& balance, double time, double factor,
                                    const std::vector<double>& known) const
{
    auto reaches = joints.oil_temperature();
    balance.oil.resize(problem_->oil.size());
    for (std::size_t k = 0; k < problem_->oil.size(); ++k)
        march_circuit(k, joints, balance, time, factor, known[k], reaches);
    return reaches;
}

std::vector<double> OilMarch::known_in_first_stage(double factor, const HeatBalance& start) const
{
    auto known = sump_;
    for (std::size_t k = 0; k < known.size(); ++k)
        known[k] += factor * start.oil[k].sump_rate;
    return known;
}

std::vector<double> OilMarch::known_in_second_stage(const HeatBalance& middle) const
{
    auto known = sump_;
    for (std::size_t k = 0; k < known.size(); ++k)
        known[k] = bdf_middle * middle.oil[k].sump - bdf_now * known[k];
    return known;
}

double OilMarch::step_error(double dt, bool slope_known, const HeatBalance& start, const HeatBalance& middle,
                            const HeatBalance& end) const
{
    const double of_a_step = step_tolerance(problem_->time_tolerance) / problem_->time_tolerance;
    double largest = 0;
    for (std::size_t k = 0; k < start.oil.size(); ++k) {
        const double relaxation = end.oil[k].sump_relaxation;
        const double filter = slope_known ? 1 : 1 + diagonal * dt * relaxation;
        const double forgotten = std::max(-std::expm1(-dt * relaxation), dt / segment_->duration);
        const double error =
            heat::step_error(dt, start.oil[k].sump_rate, middle.oil[k].sump_rate, end.oil[k].sump_rate);
        largest = std::max(largest, std::abs(error) / filter * std::max(1.0, of_a_step / forgotten));
    }
    return largest;
}

void OilMarch::accept(const HeatBalance& end)
{
    for (std::size_t k = 0; k < sump_.size(); ++k)
        sump_[k] = end.oil[k].sump;
}

}  // namespace deadpoint::heat
