#include "deadpoint/study/translate_heat.hpp"

#include "deadpoint/core/error.hpp"
#include "deadpoint/core/formula.hpp"
#include "deadpoint/core/table.hpp"
#include "deadpoint/study/translate_conductance.hpp"
#include "deadpoint/study/translate_film.hpp"
#include "deadpoint/surroundings/ambient.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <memory>
#include <set>

namespace deadpoint::study {

TimeCourse time_course(const casefile::Course& course, double start)
{
    if (course.daily) {
        const surroundings::DailyCourse daily{course.daily->mean, course.daily->amplitude,
                                              course.daily->time_of_maximum, course.daily->period};
        return [daily](double time) { return surroundings::daily_temperature(daily, time); };
    }
    if (!course.table)
        return [value = course.constant](double) { return value; };
    return [table = *course.table, start](double time) {
        return interpolate_linear(table.x, table.y, time - start).value;
    };
}

TimeCourse segment_ambient(const casefile::Case& input, const casefile::Segment& segment, double start)
{
    return time_course(segment.ambient.value_or(casefile::Course{input.machine.ambient, {}, {}}), start);
}

namespace {

int index_of(const std::map<std::string, casefile::Friction>& friction, const std::string& name)
{
    const auto found = friction.find(name);
    return found == friction.end() ? -1 : static_cast<int>(std::distance(friction.begin(), found));
}

InterfaceLaw interface_law(const casefile::Case& input, const casefile::Joint& joint,
                           const casefile::Interface& interface, const InterfaceConductance& conductance)
{
    InterfaceLaw law;
    law.film_a = conductance.film_a;
    law.film_b = conductance.film_b;
    const auto by_row = input.oil.find(joint.friction);
    law.oil = interface.oil > 0 ? interface.oil : by_row != input.oil.end() ? by_row->second : 0;
    law.oil_temperature = joint.oil_temperature;
    law.turns_fully = joint.turns_fully && !interface.stands_still;
    law.source = index_of(input.friction, joint.friction);
    law.heat_weight = interface.heat_share;
    return law;
}

std::vector<InterfaceLaw> interface_laws(const casefile::Case& input, const Machine& machine, const LoadsResult* loads,
                                         Observer& observer)
{
    const auto conductances = interface_conductances(input, machine, loads, conductance_speed(input));
    std::vector<InterfaceLaw> laws;
    for (const auto& [name, joint] : input.joints)
        for (const auto& interface : joint.interfaces) {
            const auto& conductance = conductances[laws.size()];
            laws.push_back(interface_law(input, joint, interface, conductance));
            if (!conductance.in_range)
                observer.warn(out_of_range_text(conductance));
        }
    return laws;
}

}  // namespace

namespace {

std::vector<HeatSegment> heat_segments(const casefile::Case& input, FrictionLaws& laws)
{
    std::vector<HeatSegment> segments;
    double start = 0;
    for (const auto& operation : input.operation) {
        HeatSegment segment;
        segment.duration = operation.duration;
        segment.ambient = segment_ambient(input, operation, start);
        for (const auto& [name, friction] : input.friction)
            segment.heat.push_back(laws.heat(name, operation).heat);
        segments.push_back(std::move(segment));
        start += operation.duration;
    }
    return segments;
}

SurfaceCondition film_condition(const casefile::Case& input, const Machine& machine, const std::string& name,
                                const LoadsResult* loads)
{
    SurfaceCondition condition;
    condition.kind = SurfaceCondition::Kind::film;
    const auto& given = *input.surfaces.at(name).film;
    const auto film = surface_film(given, machine, name, loads);
    condition.coefficient = film.constant.value_or(0);
    if (!film.constant)
        for (const auto& operation : input.operation)
            condition.laws.push_back(film.law_at(operation.speed));
    condition.emissivity = given.emissivity;
    if (given.ambient)
        condition.ambient = time_course(*given.ambient, 0);
    return condition;
}

std::vector<SurfaceCondition> surface_conditions(const casefile::Case& input, const Machine& machine,
                                                 const LoadsResult* loads)
{
    std::vector<SurfaceCondition> conditions;
    for (const auto& [name, surface] : input.surfaces) {
        SurfaceCondition condition;
        if (surface.film) {
            condition = film_condition(input, machine, name, loads);
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
        condition.name = name;
        condition.surface = surface_index(machine, name);
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
    const bool some_ignore_it = std::any_of(input.friction.begin(), input.friction.end(), [](const auto& row) {
        return row.second.law == "calibrated" && !row.second.reference_force;
    });
    if (forces_differ && some_ignore_it)
        observer.warn(
            "the process force changes between segments, but calibrated friction heat without `reference_force` "
            "follows the speed only: its load part stays as given");
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

HeatProblem describe_heat(const casefile::Case& input, const Machine& machine, Observer& observer,
                          const LoadsResult* loads)
{
    FrictionLaws friction(input, &machine, loads);
    return describe_heat(input, machine, observer, loads, friction);
}

HeatProblem describe_heat(const casefile::Case& input, const Machine& machine, Observer& observer,
                          const LoadsResult* loads, FrictionLaws& friction)
{
    warn_about(input, observer);
    HeatProblem problem;
    problem.interfaces = interface_laws(input, machine, loads, observer);
    for (const auto& [name, row] : input.friction)
        problem.sources.push_back({name, machine.half_model ? 0.5 : 1.0});
    problem.surfaces = surface_conditions(input, machine, loads);
    problem.segments = heat_segments(input, friction);
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
