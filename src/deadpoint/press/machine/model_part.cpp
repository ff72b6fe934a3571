#include "deadpoint/press/machine/model_part.hpp"

#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/casefile/syntax/case_bytes.hpp"

#include <algorithm>

namespace deadpoint::press {
namespace {

bool has_table(const casefile::Material& material)
{
    return !material.conductivity_table.x.empty() || !material.specific_heat_table.x.empty() ||
           !material.expansion_table.x.empty();
}

casefile::MachineSection machine_of(const casefile::Case& input)
{
    casefile::MachineSection result;
    const auto& given = input.machine;
    result.half_model = given.half_model;
    result.gravity_direction = given.gravity_direction;
    result.unbonded = given.unbonded;
    result.front = given.front;
    result.left = given.left;
    result.up = given.up;
    if (std::ranges::any_of(input.materials, [](const auto& entry) { return has_table(entry.second); }))
        result.initial_temperature = given.initial_temperature;
    return result;
}

casefile::Body body_of(const casefile::Body& given)
{
    casefile::Body result;
    result.ground = given.ground;
    result.mirror = given.mirror;
    result.thermal_only = given.thermal_only;
    return result;
}

casefile::Part part_of(casefile::Part given)
{
    given.initial_temperature.reset();
    return given;
}

casefile::Interface interface_of(const casefile::Interface& given)
{
    casefile::Interface result;
    result.name = given.name;
    result.a = given.a;
    result.b = given.b;
    result.diameter = given.diameter;
    result.stands_still = given.stands_still;
    result.seat = given.seat;
    result.journal = given.journal;
    result.partial = given.partial;
    result.drawn_gap = given.drawn_gap;
    return result;
}

casefile::Joint joint_of(const casefile::Joint& given)
{
    casefile::Joint result;
    result.kind = given.kind;
    result.bodies = given.bodies;
    result.centre = given.centre;
    result.direction = given.direction;
    result.guides_rotation = given.guides_rotation;
    result.swept = given.swept;
    result.turns_fully = given.turns_fully;
    result.driver = given.driver;
    result.ball = given.ball;
    result.elements = given.elements;
    for (const auto& interface : given.interfaces)
        result.interfaces.push_back(interface_of(interface));
    return result;
}

casefile::Bond bond_of(const casefile::Bond& given)
{
    const bool open = casefile::is_open(given.conductance);
    return {given.between, casefile::WholeConductance{open ? 0.0 : 1.0}};
}

casefile::Surface surface_of(casefile::Surface given)
{
    if (given.film)
        given.film = casefile::Film{casefile::FilmCoefficient{1.0}, {}, 0, {}};
    if (given.temperature || !given.temperature_formula.empty())
        given.temperature = casefile::Course{};
    given.temperature_formula.clear();
    if (given.heat_flux)
        given.heat_flux = casefile::Course{};
    return given;
}

/// The crank turns at 1 rad/s, if it ever turns: the way of a guide follows from positions alone.
casefile::Segment segment_of(const casefile::Case& input)
{
    casefile::Segment result;
    result.duration = 1;
    result.speed = std::ranges::any_of(input.operation, [](const auto& segment) { return segment.speed > 0; }) ? 1 : 0;
    return result;
}

casefile::Chain chain_of(casefile::Chain given)
{
    const casefile::Chain bare;
    given.bearing_play = bare.bearing_play;
    given.drift_rate_limit = bare.drift_rate_limit;
    given.press_stiffness = bare.press_stiffness;
    return given;
}

casefile::Numerics numerics_of(const casefile::Numerics& given)
{
    casefile::Numerics result;
    result.size = given.size;
    result.seam_tolerance = given.seam_tolerance;
    result.deformation_size = given.deformation_size;
    result.deformation_order = given.deformation_order;
    result.order = given.order;
    return result;
}

}  // namespace

casefile::Case model_part(const casefile::Case& input)
{
    casefile::Case result;
    result.machine = machine_of(input);
    result.materials = input.materials;
    for (const auto& [name, body] : input.bodies)
        result.bodies.emplace(name, body_of(body));
    for (const auto& [name, part] : input.parts)
        result.parts.emplace(name, part_of(part));
    for (const auto& [name, joint] : input.joints)
        result.joints.emplace(name, joint_of(joint));
    for (const auto& [name, bond] : input.bonds)
        result.bonds.emplace(name, bond_of(bond));
    for (const auto& [name, surface] : input.surfaces)
        result.surfaces.emplace(name, surface_of(surface));
    result.mechanism = input.mechanism;
    result.operation = {segment_of(input)};
    if (input.chain)
        result.chain = chain_of(*input.chain);
    result.foundation = input.foundation;
    result.preload = input.preload;
    result.numerics = numerics_of(input.numerics);
    result.output.stress = input.output.stress;
    result.source = input.source;
    return result;
}

std::string model_key(const casefile::Case& input) { return casefile::case_bytes(model_part(input)); }

}  // namespace deadpoint::press
