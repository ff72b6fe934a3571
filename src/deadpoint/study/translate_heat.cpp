#include "deadpoint/study/translate_heat.hpp"

#include "deadpoint/core/error.hpp"
#include "deadpoint/core/formula.hpp"
#include "deadpoint/core/table.hpp"
#include "deadpoint/tribology/calibrated.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <memory>
#include <set>

namespace deadpoint::study {
namespace {

TimeCourse time_course(const casefile::Course& course, double start)
{
    if (!course.table)
        return [value = course.constant](double) { return value; };
    return [table = *course.table, start](double time) {
        return interpolate_linear(table.x, table.y, time - start).value;
    };
}

int index_of(const std::map<std::string, casefile::Friction>& friction, const std::string& name)
{
    const auto found = friction.find(name);
    return found == friction.end() ? -1 : static_cast<int>(std::distance(friction.begin(), found));
}

InterfaceLaw interface_law(const casefile::Case& input, const casefile::Joint& joint,
                           const casefile::Interface& interface)
{
    InterfaceLaw law;
    const auto& conductance = interface.conductance;
    law.film_a = conductance.resistance > 0 ? 2 / conductance.resistance : conductance.side_a;
    law.film_b = conductance.resistance > 0 ? 2 / conductance.resistance : conductance.side_b;
    const auto by_row = input.oil.find(joint.friction);
    law.oil = interface.oil > 0 ? interface.oil : by_row != input.oil.end() ? by_row->second : 0;
    law.oil_temperature = joint.oil_temperature;
    law.turns_fully = joint.turns_fully && !interface.stands_still;
    law.source = index_of(input.friction, joint.friction);
    law.heat_weight = interface.heat_share;
    return law;
}

std::vector<InterfaceLaw> interface_laws(const casefile::Case& input)
{
    std::vector<InterfaceLaw> laws;
    for (const auto& [name, joint] : input.joints)
        for (const auto& interface : joint.interfaces)
            laws.push_back(interface_law(input, joint, interface));
    return laws;
}

HeatLaw heat_law(const casefile::Case& input, const casefile::Friction& friction, double speed)
{
    tribology::CalibratedFriction law;
    law.kind = tribology::friction_kind(friction.kind);
    law.load_part = friction.load_part;
    law.viscous_part = friction.viscous_part;
    law.exponent = friction.exponent;
    law.reference_speed = friction.reference_speed;
    law.scale = friction.scale;
    if (friction.lubricant.empty())
        return tribology::calibrated_heat(law, nullptr, speed);
    const auto& viscosity = input.lubricants.at(friction.lubricant).viscosity;
    const tribology::ViscosityCurve curve(viscosity.x, viscosity.y);
    return tribology::calibrated_heat(law, &curve, speed);
}

std::vector<HeatSegment> heat_segments(const casefile::Case& input)
{
    std::vector<HeatSegment> segments;
    double start = 0;
    for (const auto& operation : input.operation) {
        HeatSegment segment;
        segment.duration = operation.duration;
        segment.ambient = time_course(operation.ambient.value_or(casefile::Course{input.machine.ambient, {}}), start);
        for (const auto& [name, friction] : input.friction)
            segment.heat.push_back(heat_law(input, friction, operation.speed));
        segments.push_back(std::move(segment));
        start += operation.duration;
    }
    return segments;
}

std::vector<SurfaceCondition> surface_conditions(const casefile::Case& input, const Machine& machine)
{
    std::vector<SurfaceCondition> conditions;
    for (const auto& [name, surface] : input.surfaces) {
        SurfaceCondition condition;
        condition.name = name;
        condition.surface = surface_index(machine, name);
        if (surface.film) {
            condition.kind = SurfaceCondition::Kind::film;
            condition.coefficient = surface.film->coefficient;
            condition.emissivity = surface.film->emissivity;
            if (surface.film->ambient)
                condition.ambient = time_course(*surface.film->ambient, 0);
        } else if (surface.temperature) {
            condition.kind = SurfaceCondition::Kind::temperature;
            condition.temperature = [course = time_course(*surface.temperature, 0)](const Vec3&, double time) {
                return course(time);
            };
        } else if (!surface.temperature_formula.empty()) {
            condition.kind = SurfaceCondition::Kind::temperature;
            condition.temperature = [formula = std::make_shared<Formula>(surface.temperature_formula)](
                                        const Vec3& position, double time) { return (*formula)(position, time); };
        } else if (surface.heat_flux) {
            condition.kind = SurfaceCondition::Kind::flux;
            condition.flux = time_course(*surface.heat_flux, 0);
        } else {
            continue;
        }
        conditions.push_back(std::move(condition));
    }
    return conditions;
}

std::vector<HeatProbe> heat_probes(const casefile::Case& input, const Machine& machine)
{
    std::vector<HeatProbe> probes;
    for (const auto& [name, probe] : input.probes) {
        HeatProbe result{name, part_index(machine, probe.part), probe.position};
        if (result.part < 0)
            throw InputError(fmt::format("probes.{}: part '{}' is not in the modelled half", name, probe.part));
        if (machine.half_model && result.position[0] > 0)
            result.position[0] = -result.position[0];
        probes.push_back(std::move(result));
    }
    return probes;
}

void warn_about(const casefile::Case& input, Observer& observer)
{
    std::set<std::string> used;
    for (const auto& [name, joint] : input.joints)
        if (!joint.interfaces.empty())
            used.insert(joint.friction);
    for (const auto& [name, friction] : input.friction)
        if (!used.contains(name))
            observer.warn(fmt::format("friction.{} heats nothing: no joint with interfaces names it", name));
    const auto& operation = input.operation;
    const bool forces_differ = std::any_of(operation.begin(), operation.end(), [&](const casefile::Segment& s) {
        return s.force != operation.front().force;
    });
    if (forces_differ && !input.friction.empty())
        observer.warn(
            "the process force changes between segments, but calibrated friction heat follows the speed only: its "
            "load part stays as given");
}

}  // namespace

int part_index(const Machine& machine, const std::string& name)
{
    const auto found = std::find_if(machine.parts.begin(), machine.parts.end(),
                                    [&](const MeshPart& part) { return part.name == name; });
    return found == machine.parts.end() ? -1 : static_cast<int>(found - machine.parts.begin());
}

int surface_index(const Machine& machine, const std::string& name)
{
    const auto found = std::find_if(machine.surfaces.begin(), machine.surfaces.end(),
                                    [&](const MeshSurface& s) { return s.name == name; });
    return found == machine.surfaces.end() ? -1 : static_cast<int>(found - machine.surfaces.begin());
}

std::vector<Material> describe_materials(const casefile::Case& input, const Machine& machine)
{
    std::vector<Material> materials;
    for (const auto& part : machine.parts) {
        const auto& m = input.materials.at(input.parts.at(part.name).material);
        materials.push_back(
            {m.density, m.conductivity, m.specific_heat, m.expansion, m.youngs_modulus, m.poissons_ratio});
    }
    return materials;
}

HeatProblem describe_heat(const casefile::Case& input, const Machine& machine, Observer& observer)
{
    warn_about(input, observer);
    HeatProblem problem;
    problem.interfaces = interface_laws(input);
    for (const auto& [name, friction] : input.friction)
        problem.sources.push_back({name, machine.half_model ? 0.5 : 1.0});
    problem.surfaces = surface_conditions(input, machine);
    problem.segments = heat_segments(input);
    problem.probes = heat_probes(input, machine);
    problem.initial_temperature = [value = input.machine.initial_temperature](const Vec3&) { return value; };
    problem.time_tolerance = input.numerics.time_tolerance;
    problem.initial_step = input.numerics.initial_step;
    problem.max_step = input.numerics.max_step;
    problem.solver_tolerance = input.numerics.solver_tolerance;

    double end = 0;
    for (const auto& operation : input.operation)
        end += operation.duration;
    if (input.output.fields) {
        for (const double time : input.output.field_times)
            if (time < end * (1 - 1e-9))
                problem.field_times.push_back(time);
        problem.field_times.push_back(end);
        std::sort(problem.field_times.begin(), problem.field_times.end());
    }
    return problem;
}

}  // namespace deadpoint::study
