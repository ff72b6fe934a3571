#include "deadpoint/press/translate/oil.hpp"

#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/exchange/heat.hpp"
#include "deadpoint/exchange/machine.hpp"
#include "deadpoint/press/translate/lookup.hpp"
#include "deadpoint/surroundings/oil_circuit.hpp"

#include <algorithm>

namespace deadpoint::press {
namespace {

// Indices of a joint's interfaces in the order of the machine's.
std::vector<int> interfaces_of(const casefile::Case& input, const std::string& joint)
{
    int first = 0;
    for (const auto& [name, other] : input.joints) {
        if (name == joint)
            break;
        first += static_cast<int>(other.interfaces.size());
    }
    std::vector<int> result(input.joints.at(joint).interfaces.size());
    for (std::size_t i = 0; i < result.size(); ++i)
        result[i] = first + static_cast<int>(i);
    return result;
}

}  // namespace

std::vector<OilCourse> oil_circuits(const casefile::Case& input, const Machine& machine)
{
    std::vector<OilCourse> circuits;
    for (const auto& [name, given] : input.oil_circuits) {
        OilCourse circuit;
        circuit.name = name;
        for (const auto& joint : given.joints)
            circuit.joints.push_back(interfaces_of(input, joint));
        circuit.cooled = given.inlet_temperature.has_value();
        circuit.inlet_temperature = given.inlet_temperature.value_or(0);
        circuit.sump_capacity = modelled_share(machine) * given.sump_volume *
                                input.lubricants.at(given.lubricant).density * given.heat_capacity;
        circuit.sump_loss = modelled_share(machine) * given.sump_loss;
        circuit.sump_start = given.sump_temperature.value_or(input.machine.initial_temperature);
        circuits.push_back(std::move(circuit));
    }
    return circuits;
}

std::vector<double> oil_flows(const casefile::Case& input, const Machine& machine, const casefile::Segment& segment)
{
    std::vector<double> flows;
    for (const auto& [name, given] : input.oil_circuits) {
        const bool flowing = segment.speed > 0 || given.at_rest;
        const double mass_flow = surroundings::mass_flow_of(given.flow, input.lubricants.at(given.lubricant).density);
        flows.push_back(flowing ? modelled_share(machine) * mass_flow * given.heat_capacity : 0);
    }
    return flows;
}

void grow_with_speed(std::vector<InterfaceLaw>& laws, const casefile::Case& input, double speed)
{
    for (const auto& [row, growth] : input.oil_with_speed) {
        const auto source = std::distance(input.friction.begin(), input.friction.find(row));
        for (auto& law : laws)
            if (law.source == source)
                law.oil *= growth.factor(speed);
    }
}

void warm_within_joints(std::vector<InterfaceLaw>& laws, const Machine& machine, const std::vector<OilCourse>& circuits,
                        const std::vector<double>& flows)
{
    for (std::size_t k = 0; k < circuits.size(); ++k)
        for (const auto& joint : circuits[k].joints) {
            double conductance = 0;
            for (const int i : joint)
                conductance += laws[i].oil * machine.interfaces[i].area;
            const double reduction =
                flows[k] > 0 && conductance > 0 ? surroundings::mean_approach(conductance / flows[k]) : 0;
            for (const int i : joint)
                laws[i].oil *= reduction;
        }
}

}  // namespace deadpoint::press
