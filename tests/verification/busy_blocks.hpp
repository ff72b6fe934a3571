#pragma once

#include "solved_case.hpp"

namespace verification {

/// Three blocks with two joints on one friction row, a motor, a held end, a heated end, and a rest with other
/// conductances.
inline Case busy_blocks()
{
    auto input = read("three-blocks", {"surfaces.held.parts=[\"left_block\"]", "surfaces.held.select=plane",
                                       "surfaces.held.axis=x", "surfaces.held.position=-120 mm",
                                       "surfaces.held.temperature=30 degC", "surfaces.heated.parts=[\"right_block\"]",
                                       "surfaces.heated.select=plane", "surfaces.heated.axis=x",
                                       "surfaces.heated.position=70 mm", "surfaces.heated.heat_flux=900 W/m^2"});
    input.joints.at("second").friction = "one";
    input.joints.at("second").interfaces[0].heat_share = 1.7;
    deadpoint::casefile::HeatInput motor;
    motor.parts = {"middle*"};
    motor.power = deadpoint::casefile::Course{25, {}, {}};
    input.heat_sources["motor"] = motor;
    input.operation[0].duration = 900;
    input.operation.resize(3, input.operation[0]);
    input.operation[1].speed = 0;
    return input;
}

inline Case on_an_oil_circuit(Case input)
{
    input.lubricants["oil"].density = 1000;
    deadpoint::casefile::OilCircuit circuit;
    for (auto& [name, joint] : input.joints) {
        circuit.joints.push_back(name);
        joint.interfaces[0].oil = 4000;
    }
    circuit.flow = 1e-5;
    circuit.lubricant = "oil";
    circuit.sump_volume = 2e-3;
    circuit.sump_loss = 2;
    input.oil_circuits["main"] = circuit;
    return input;
}

}  // namespace verification
