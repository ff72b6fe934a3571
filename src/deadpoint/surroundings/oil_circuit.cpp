#include "deadpoint/surroundings/oil_circuit.hpp"

#include "deadpoint/core/error.hpp"

#include <cmath>
#include <fmt/format.h>
#include <numeric>

namespace deadpoint::surroundings {
namespace {

void require(bool holds, const char* what, double value, const char* help)
{
    if (!holds || !std::isfinite(value))
        throw InputError(fmt::format("oil circuit: {} is {}\n  help: {}", what, value, help));
}

void check(const OilCircuit& circuit)
{
    require(circuit.mass_flow >= 0, "the mass flow [kg/s]", circuit.mass_flow, "give a flow of zero or more");
    require(circuit.heat_capacity > 0, "the heat capacity [J/kg/K]", circuit.heat_capacity,
            "mineral oil has about 1900 J/kg/K");
    require(circuit.sump.loss >= 0, "the loss of the sump [W/K]", circuit.sump.loss, "give zero or more");
    require(circuit.sump.ambient > 0, "the ambient of the sump [K]", circuit.sump.ambient,
            "give an absolute temperature");
    if (circuit.sump.cooler)
        require(circuit.inlet_temperature > 0, "the inlet temperature [K]", circuit.inlet_temperature,
                "give an absolute temperature");
    for (std::size_t i = 0; i < circuit.conductance.size(); ++i)
        require(circuit.conductance[i] >= 0, fmt::format("the conductance to joint {} [W/K]", i + 1).c_str(),
                circuit.conductance[i], "give zero or more");
}

}  // namespace

double mean_approach(double transfer_units)
{
    if (transfer_units == 0)
        return 1;
    return -std::expm1(-transfer_units) / transfer_units;
}

double mass_flow_of(double volume_flow, double density)
{
    require(volume_flow >= 0, "the volume flow [m3/s]", volume_flow, "give a flow of zero or more");
    require(density > 0, "the density [kg/m3]", density, "mineral oil has about 870 kg/m3");
    return volume_flow * density;
}

std::vector<double> JointMap::operator()(const std::vector<double>& temperatures) const
{
    const std::size_t n = offset.size();
    if (temperatures.size() != n)
        throw InputError(fmt::format("oil circuit: {} temperatures for {} joints\n  help: give one for each",
                                     temperatures.size(), n));
    std::vector<double> result(n);
    for (std::size_t i = 0; i < n; ++i)
        result[i] = std::inner_product(temperatures.begin(), temperatures.end(),
                                       matrix.begin() + static_cast<std::ptrdiff_t>(i * n), offset[i]);
    return result;
}

OilLine::OilLine(const OilCircuit& circuit) : circuit_(circuit)
{
    check(circuit);
    capacity_flow_ = circuit.mass_flow * circuit.heat_capacity;
    for (const double conductance : circuit.conductance) {
        // A joint that exchanges nothing stays out even where the oil stands still.
        const double units = conductance == 0 ? 0 : conductance / capacity_flow_;
        effectiveness_.push_back(-std::expm1(-units));
        approach_.push_back(mean_approach(units));
    }
    const double total = std::accumulate(circuit.conductance.begin(), circuit.conductance.end(), 0.0);
    if (!circuit.sump.cooler && circuit.sump.loss == 0 && !(capacity_flow_ > 0 && total > 0))
        throw InputError(
            "oil circuit: nothing fixes the temperature of the oil\n  help: give it a cooler with an inlet "
            "temperature, or a sump that loses heat");
    build_maps();
}

std::vector<double> OilLine::walk(double inlet, const std::vector<double>& film_temperatures) const
{
    std::vector<double> oil{inlet};
    for (std::size_t i = 0; i < joints(); ++i)
        oil.push_back(oil.back() + effectiveness_[i] * (film_temperatures[i] - oil.back()));
    return oil;
}

double OilLine::relative_inlet(const std::vector<double>& relative_films) const
{
    // m c (return - inlet) = loss inlet, with return = walk(0) + inlet exp(-sum N), all above the ambient.
    const double total = std::accumulate(circuit_.conductance.begin(), circuit_.conductance.end(), 0.0);
    const double warmed = capacity_flow_ * walk(0, relative_films).back();
    const double taken = capacity_flow_ == 0 ? 0 : -capacity_flow_ * std::expm1(-total / capacity_flow_);
    return warmed / (taken + circuit_.sump.loss);
}

void OilLine::build_maps()
{
    const std::size_t n = joints();
    heat_ = {std::vector<double>(n), std::vector<double>(n * n)};
    mean_ = heat_;
    for (std::size_t j = 0; j < n; ++j) {
        std::vector<double> unit(n);
        unit[j] = 1;
        const std::vector<double> oil = walk(circuit_.sump.cooler ? 0 : relative_inlet(unit), unit);
        for (std::size_t i = 0; i < n; ++i) {
            const double drop = approach_[i] * (unit[i] - oil[i]);
            heat_.matrix[i * n + j] = circuit_.conductance[i] * drop;
            mean_.matrix[i * n + j] = unit[i] - drop;
        }
    }
    // With every film at zero kelvin; the maps are affine, so this needs no physical meaning.
    const std::vector<double> zero(n);
    const std::vector<double> relative(n, -circuit_.sump.ambient);
    const double inlet =
        circuit_.sump.cooler ? circuit_.inlet_temperature : circuit_.sump.ambient + relative_inlet(relative);
    const std::vector<double> oil = walk(inlet, zero);
    for (std::size_t i = 0; i < n; ++i) {
        heat_.offset[i] = -circuit_.conductance[i] * approach_[i] * oil[i];
        mean_.offset[i] = approach_[i] * oil[i];
    }
}

OilState OilLine::at(const std::vector<double>& film_temperatures) const
{
    const std::size_t n = joints();
    if (film_temperatures.size() != n)
        throw InputError(fmt::format("oil circuit: {} temperatures for {} joints\n  help: give one for each",
                                     film_temperatures.size(), n));
    std::vector<double> relative(n);
    for (std::size_t i = 0; i < n; ++i) {
        if (!std::isfinite(film_temperatures[i]))
            throw DomainError(fmt::format("oil circuit: the film temperature of joint {} is {} K\n  help: the solution "
                                          "has failed before the oil; check the heat of that joint",
                                          i + 1, film_temperatures[i]));
        relative[i] = film_temperatures[i] - circuit_.sump.ambient;
    }
    const Sump& sump = circuit_.sump;
    OilState state;
    state.inlet_temperature = sump.cooler ? circuit_.inlet_temperature : sump.ambient + relative_inlet(relative);
    const std::vector<double> oil = walk(state.inlet_temperature, film_temperatures);
    state.inlet.assign(oil.begin(), oil.end() - 1);
    state.outlet.assign(oil.begin() + 1, oil.end());
    state.return_temperature = oil.back();
    for (std::size_t i = 0; i < n; ++i) {
        const double drop = approach_[i] * (film_temperatures[i] - oil[i]);
        state.mean.push_back(film_temperatures[i] - drop);
        state.heat.push_back(circuit_.conductance[i] * drop);
        state.total_heat += state.heat.back();
    }
    const double above = state.return_temperature - sump.ambient;
    if (!sump.cooler) {
        state.sump_loss = sump.loss * (state.inlet_temperature - sump.ambient);
    } else if (capacity_flow_ > 0) {
        state.sump_loss = sump.loss * above * capacity_flow_ / (capacity_flow_ + sump.loss);
        state.cooler_power = state.total_heat - state.sump_loss;
    }
    return state;
}

}  // namespace deadpoint::surroundings
