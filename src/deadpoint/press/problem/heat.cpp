#include "deadpoint/press/problem/heat.hpp"

#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/casefile/describe/case_friction.hpp"
#include "deadpoint/core/formula.hpp"
#include "deadpoint/core/mistakes.hpp"
#include "deadpoint/core/names/pattern.hpp"
#include "deadpoint/exchange/machine.hpp"
#include "deadpoint/observer.hpp"
#include "deadpoint/press/laws/conductance.hpp"
#include "deadpoint/press/laws/film.hpp"
#include "deadpoint/press/laws/friction.hpp"
#include "deadpoint/press/laws/guide_sides.hpp"
#include "deadpoint/press/laws/load_zone.hpp"
#include "deadpoint/press/loads/loads.hpp"
#include "deadpoint/press/result/friction_summary.hpp"
#include "deadpoint/press/result/loads_result.hpp"
#include "deadpoint/press/translate/courses.hpp"
#include "deadpoint/press/translate/enclosures.hpp"
#include "deadpoint/press/translate/lookup.hpp"
#include "deadpoint/press/translate/oil.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <memory>
#include <optional>
#include <set>

namespace deadpoint::press {

namespace {

int index_of(const std::map<std::string, casefile::Friction>& friction, const std::string& name)
{
    const auto found = friction.find(name);
    return found == friction.end() ? -1 : static_cast<int>(std::distance(friction.begin(), found));
}

InterfaceLaw interface_law(const casefile::Case& input, const Machine& machine, const LoadsResult* loads,
                           const std::string& name, const casefile::Interface& interface,
                           const InterfaceConductance& conductance)
{
    const auto& joint = input.joints.at(name);
    InterfaceLaw law;
    law.film_a = conductance.film_a;
    law.film_b = conductance.film_b;
    const auto by_row = input.oil.find(joint.friction);
    law.oil = interface.oil > 0 ? interface.oil : by_row != input.oil.end() ? by_row->second : 0;
    law.oil *= conductance.seat_over_drawn;
    law.oil_temperature = joint.oil_temperature;
    law.turns_fully = joint.turns_fully && !interface.stands_still;
    law.source = index_of(input.friction, joint.friction);
    law.heat_weight = interface.heat_share;
    law.heat_part = interface.heat_into.empty() ? -1 : part_index(machine, interface.heat_into);
    if (!interface.heat_into.empty() && law.heat_part < 0)
        throw mistake(fmt::format("joints.{}.interfaces.{}.heat_into", name, interface.name),
                      fmt::format("part '{}' is not in the modelled half", interface.heat_into));
    if (interface.load_zone && loads)
        law.load_zone = load_zone(input, name, *loads);
    return law;
}

std::vector<InterfaceLaw> interface_laws(const casefile::Case& input, const Machine& machine, const LoadsResult* loads,
                                         const std::vector<InterfaceConductance>& conductances)
{
    std::vector<InterfaceLaw> laws;
    Mistakes mistakes;
    for (const auto& [name, joint] : input.joints)
        for (const auto& interface : joint.interfaces) {
            const auto& conductance = conductances[laws.size()];
            auto& law = laws.emplace_back();
            mistakes.attempt(fmt::format("joints.{}.interfaces.{}", name, interface.name), [&, &name = name] {
                law = interface_law(input, machine, loads, name, interface, conductance);
            });
        }
    mistakes.raise();
    for (std::size_t bond = laws.size(); bond < conductances.size(); ++bond) {
        auto& law = laws.emplace_back();
        law.film_a = conductances[bond].film_a;
        law.film_b = conductances[bond].film_b;
        law.oil_temperature = input.machine.initial_temperature;
    }
    return laws;
}

void require_conductances(const Machine& machine, const std::vector<InterfaceLaw>& laws)
{
    Mistakes mistakes;
    for (std::size_t i = 0; i < laws.size(); ++i)
        if (!(laws[i].film_a + laws[i].film_b + laws[i].oil > 0))
            mistakes.add(interface_path(machine.interfaces[i].name),
                         DomainError(fmt::format("interface '{}' conducts nothing to either side nor to the oil\n  "
                                                 "help: give it a conductance",
                                                 machine.interfaces[i].name)));
    mistakes.raise();
}

/// The part of a case that gives each segment its laws.
class Segments {
public:
    Segments(const casefile::Case& input, const Machine& machine, FrictionLaws& friction, const LoadsResult* loads,
             Observer& observer)
        : input_(input), machine_(machine), friction_(friction), loads_(loads), observer_(observer)
    {}

    void describe(HeatProblem& problem)
    {
        double start = 0;
        Mistakes mistakes;
        for (std::size_t s = 0; s < input_.operation.size(); ++s) {
            mistakes.attempt(fmt::format("operation.{}", s),
                             [&] { problem.segments.push_back(segment(s, start, problem)); });
            start += input_.operation[s].duration;
        }
        mistakes.raise();
    }

    /// Interface laws at the operating point of a segment, before the oil warms. While the press stands still, its
    /// joints conduct as in the last segment in which it ran.
    std::vector<InterfaceLaw> interfaces(std::size_t s)
    {
        auto laws = laws_of(running_segment(s));
        grow_with_speed(laws, input_, input_.operation[s].speed);
        return laws;
    }

private:
    std::vector<InterfaceLaw> laws_of(const casefile::Segment* running)
    {
        if (!running)
            return interface_laws(input_, machine_, nullptr, checked(nullptr, 0));
        const LoadsResult* loads = loads_ ? &friction_.loads(*running) : nullptr;
        if (!loads)
            refuse_zones("", "the case does not describe the linkage and its loads");
        auto laws = interface_laws(input_, machine_, loads, checked(loads, running->speed));
        if (loads)
            share_by_side(laws, *loads, *running);
        return laws;
    }

    /// Gives the pressed side of a guide more of the heat, where friction follows the law "guide".
    void share_by_side(std::vector<InterfaceLaw>& laws, const LoadsResult& loads, const casefile::Segment& running)
    {
        std::size_t first = 0;
        for (const auto& [name, joint] : input_.joints) {
            const auto law = input_.friction.find(joint.friction);
            const bool by_forces =
                law != input_.friction.end() && std::holds_alternative<casefile::GuideFriction>(law->second.law);
            if (const auto sides = by_forces ? guide_sides(input_, machine_, loads, name, first) : std::nullopt) {
                const auto factors =
                    side_factors(input_, machine_, *sides, name, first, load_share(joint.friction, running));
                for (std::size_t i = 0; i < factors.size(); ++i)
                    laws[first + i].heat_weight *= factors[i];
            }
            first += joint.interfaces.size();
        }
    }

    /// Share of the load part in the friction heat at the initial temperature.
    double load_share(const std::string& row, const casefile::Segment& running)
    {
        const auto& friction = friction_.heat(row, running);
        const double whole = friction.heat(input_.machine.initial_temperature).value;
        return whole > 0 ? std::clamp(friction.load_part.value_or(0) / whole, 0.0, 1.0) : 0;
    }

    HeatSegment segment(std::size_t s, double start, const HeatProblem& problem)
    {
        const auto& operation = input_.operation[s];
        HeatSegment result;
        result.duration = operation.duration;
        result.ambient = segment_ambient(input_, operation, start);
        Mistakes mistakes;
        for (const auto& [name, row] : input_.friction)
            mistakes.attempt("friction." + name, [&, &name = name] { add_friction(result, name, operation); });
        mistakes.attempt("joints", [&] { result.interfaces = interfaces(s); });
        mistakes.raise();
        for (const auto& [name, source] : input_.heat_sources)
            result.body_heat.push_back(operation.speed > 0 || source.at_rest
                                           ? scaled_power(*source.power, modelled_share(machine_))
                                           : TimeCourse{});
        result.enclosure_power = enclosure_power(input_, machine_, operation);
        result.oil_flow = oil_flows(input_, machine_, operation);
        warm_within_joints(result.interfaces, machine_, problem.oil, result.oil_flow);
        require_conductances(machine_, result.interfaces);
        return result;
    }

    void add_friction(HeatSegment& segment, const std::string& row, const casefile::Segment& operation)
    {
        const auto& friction = friction_.heat(row, operation);
        segment.heat.push_back(friction_.table(row, operation));
        segment.ring_heat.push_back(friction.ring_heat);
        segment.zoned_heat.push_back(friction.load_part.value_or(0));
        if (!friction.load_part)
            refuse_zones(row, fmt::format("friction.{} has no load part of its own by its law", row));
    }

    /// The segment itself if the press runs in it, else the last running one before, else the first running one.
    [[nodiscard]] const casefile::Segment* running_segment(std::size_t s) const
    {
        for (std::size_t i = s + 1; i-- > 0;)
            if (input_.operation[i].speed > 0)
                return &input_.operation[i];
        const int first = first_running_segment(input_);
        return first < 0 ? nullptr : &input_.operation[static_cast<std::size_t>(first)];
    }

    std::vector<InterfaceConductance> checked(const LoadsResult* loads, double speed)
    {
        auto conductances = interface_conductances(input_, machine_, loads, speed);
        for (const auto& conductance : conductances)
            if (!conductance.in_range && warned_.insert(out_of_range_text(conductance)).second)
                observer_.warn(out_of_range_text(conductance));
        return conductances;
    }

    void refuse_zones(const std::string& row, const std::string& reason) const
    {
        Mistakes mistakes;
        for (const auto& [name, joint] : input_.joints)
            for (const auto& interface : joint.interfaces)
                if (interface.load_zone && (row.empty() || joint.friction == row))
                    mistakes.add(fmt::format("joints.{}.interfaces.{}.load_zone", name, interface.name),
                                 fmt::format("there is no load zone, since {}", reason), "remove `load_zone`");
        mistakes.raise();
    }

    const casefile::Case& input_;
    const Machine& machine_;
    FrictionLaws& friction_;
    const LoadsResult* loads_;
    Observer& observer_;
    std::set<std::string> warned_;
};

bool follows_rings(const casefile::Friction& friction)
{
    const auto* law = std::get_if<casefile::PalmgrenFriction>(&friction.law);
    return law && law->ring_expansion;
}

// Inner rings turn with the journals, outer rings stand in the seats.
void name_rings(const casefile::Case& input, const Machine& machine, HeatProblem& problem)
{
    int contact = 0;
    for (const auto& [name, joint] : input.joints)
        for (const auto& interface : joint.interfaces) {
            const int index = contact++;
            const int row = index_of(input.friction, joint.friction);
            if (row < 0 || !follows_rings(input.friction.at(joint.friction)))
                continue;
            const auto on_ground = [&](std::uint32_t part) {
                const auto& body = input.bodies.at(machine.parts[part].body);
                return body.ground;
            };
            const auto& touching = machine.interfaces[static_cast<std::size_t>(index)];
            auto& source = problem.sources[static_cast<std::size_t>(row)];
            const auto moves = [&](std::uint32_t part) {
                return !on_ground(part) && !input.bodies.at(machine.parts[part].body).thermal_only;
            };
            if (interface.journal)
                source.inner_rings.push_back({index, moves(touching.part_b)});
            if (interface.seat)
                source.outer_rings.push_back({index, on_ground(touching.part_b)});
        }
    Mistakes mistakes;
    for (const auto& [name, row] : input.friction)
        if (follows_rings(row)) {
            const auto& source = problem.sources[static_cast<std::size_t>(index_of(input.friction, name))];
            if (source.inner_rings.empty() || source.outer_rings.empty())
                mistakes.add("friction." + name, "the ring temperature difference needs the joint's journals and seats",
                             "mark its interfaces with journal = true and seat = true");
        }
    mistakes.raise();
}

std::vector<BodyHeat> body_heats(const casefile::Case& input, const Machine& machine)
{
    std::vector<BodyHeat> result;
    Mistakes mistakes;
    for (const auto& [name, source] : input.heat_sources) {
        BodyHeat heat;
        heat.name = name;
        for (std::size_t p = 0; p < machine.parts.size(); ++p)
            if (std::ranges::any_of(
                    source.parts, [&](const std::string& pattern) { return matches(pattern, machine.parts[p].name); }))
                heat.parts.push_back(static_cast<int>(p));
        heat.surface = source.surface.empty() ? -1 : surface_index(machine, source.surface);
        if (heat.parts.empty() && heat.surface < 0)
            mistakes.add("heat_sources." + name, "none of its parts is in the modelled half");
        result.push_back(std::move(heat));
    }
    mistakes.raise();
    return result;
}

SurfaceCondition film_condition(const casefile::Case& input, const Machine& machine, const std::string& name,
                                const LoadsResult* loads)
{
    SurfaceCondition condition;
    condition.kind = SurfaceCondition::Kind::film;
    const auto& given = *input.surfaces.at(name).film;
    const auto film = surface_film(given, machine, name, loads);
    condition.coefficient = film.constant.value_or(0);
    if (!film.constant || given.with_speed)
        for (const auto& operation : input.operation)
            condition.laws.push_back(film.law_at(operation.speed));
    condition.emissivity = given.emissivity;
    if (given.ambient)
        condition.ambient = time_course(*given.ambient, 0);
    return condition;
}

/// @throws DomainError, when it is called, where the formula is not above absolute zero
std::function<double(const Vec3&, double)> formula_course(const std::string& surface, const std::string& text)
{
    const auto path = fmt::format("surfaces.{}.temperature_formula", surface);
    return [path, formula = std::make_shared<Formula>(text)](const Vec3& position, double time) {
        return about(path, [&] {
            const double value = (*formula)(position, time);
            if (!(value > 0))
                throw DomainError(fmt::format("it gives {:.6g} K at ({:.4g}, {:.4g}, {:.4g}) m, t = {:.6g} s, which is "
                                              "not above absolute zero\n  help: its result is in kelvin: 20 degC are "
                                              "293.15",
                                              value, position[0], position[1], position[2], time));
            return value;
        });
    };
}

/// Corners of some faces of a surface, spread over it, or one of them; none of a machine without its mesh.
std::vector<Vec3> some_places(const Machine& machine, const std::string& surface, bool everywhere)
{
    const std::size_t most = everywhere ? 12 : 1;
    std::vector<Vec3> result;
    const int index = surface_index(machine, surface);
    if (index < 0)
        return result;
    const auto& faces = machine.surfaces[static_cast<std::size_t>(index)].faces;
    for (std::size_t k = 0; k < std::min(most, faces.size()); ++k) {
        const auto& face = machine.faces[faces[k * faces.size() / std::min(most, faces.size())].face];
        result.push_back(machine.nodes[face.nodes[k % 3]]);
    }
    return result;
}

/// @return nothing if the surface has no condition
std::optional<SurfaceCondition> surface_condition(const casefile::Case& input, const Machine& machine,
                                                  const std::string& name, const LoadsResult* loads)
{
    const auto& surface = input.surfaces.at(name);
    SurfaceCondition condition;
    if (surface.film) {
        condition = film_condition(input, machine, name, loads);
    } else if (surface.temperature) {
        condition.kind = SurfaceCondition::Kind::temperature;
        const auto course = time_course(*surface.temperature, 0);
        condition.temperature = [course](const Vec3&, double time) { return course(time); };
        condition.temperature_courses = {course};
    } else if (!surface.temperature_formula.empty()) {
        condition.kind = SurfaceCondition::Kind::temperature;
        condition.temperature = formula_course(name, surface.temperature_formula);
        for (const auto& place : some_places(machine, name, Formula(surface.temperature_formula).depends_on_place()))
            condition.temperature_courses.push_back(
                [formula = condition.temperature, place](double time) { return formula(place, time); });
    } else if (surface.heat_flux) {
        condition.kind = SurfaceCondition::Kind::flux;
        condition.flux = time_course(*surface.heat_flux, 0);
    } else {
        return std::nullopt;
    }
    condition.name = name;
    condition.enclosure = enclosure_of(input, name);
    condition.surface = surface_index(machine, name);
    return condition;
}

std::vector<SurfaceCondition> surface_conditions(const casefile::Case& input, const Machine& machine,
                                                 const LoadsResult* loads)
{
    std::vector<SurfaceCondition> conditions;
    Mistakes mistakes;
    for (const auto& [name, surface] : input.surfaces)
        mistakes.attempt("surfaces." + name, [&, &name = name] {
            if (auto condition = surface_condition(input, machine, name, loads))
                conditions.push_back(*std::move(condition));
        });
    mistakes.raise();
    return conditions;
}

std::vector<HeatProbe> heat_probes(const casefile::Case& input, const Machine& machine)
{
    std::vector<HeatProbe> probes;
    Mistakes mistakes;
    for (const auto& [name, probe] : input.probes) {
        HeatProbe result{name, part_index(machine, probe.part), probe.position};
        if (result.part < 0)
            mistakes.add(fmt::format("probes.{}.part", name),
                         fmt::format("part '{}' is not in the modelled half", probe.part));
        if (machine.half_model && result.position[0] > 0)
            result.position[0] = -result.position[0];
        probes.push_back(std::move(result));
    }
    mistakes.raise();
    return probes;
}

std::vector<double> initial_temperatures(const casefile::Case& input, const Machine& machine)
{
    std::vector<double> result;
    for (const auto& mesh : machine.parts) {
        const auto part = input.parts.find(mesh.name);
        const auto of_body = input.bodies.at(mesh.body).initial_temperature;
        const auto own = part == input.parts.end() ? std::nullopt : part->second.initial_temperature;
        result.push_back(own ? *own : of_body.value_or(input.machine.initial_temperature));
    }
    return result;
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
    const int running = first_running_segment(input);
    const bool forces_differ = std::any_of(operation.begin(), operation.end(), [&](const casefile::Segment& s) {
        return s.speed > 0 && s.force != operation[static_cast<std::size_t>(running)].force;
    });
    const bool some_ignore_it = std::any_of(input.friction.begin(), input.friction.end(), [](const auto& row) {
        const auto* law = std::get_if<casefile::CalibratedFriction>(&row.second.law);
        return law && !law->reference_force;
    });
    if (forces_differ && some_ignore_it)
        observer.warn("the process force changes between segments, but calibrated friction heat without "
                      "`reference_force` depends on the speed only: its load part stays as stated");
}

}  // namespace

std::vector<int> describe_orders(const casefile::Case& input, const Machine& machine)
{
    std::vector<int> orders;
    for (const auto& part : machine.parts) {
        const auto own = input.parts.find(part.name);
        orders.push_back(own != input.parts.end() && own->second.order > 0 ? own->second.order : input.numerics.order);
    }
    return orders;
}

CornerCount count_corners(const casefile::Case& input, const Machine& machine)
{
    const auto orders = describe_orders(input, machine);
    std::vector<bool> second(machine.nodes.size(), false);
    for (const auto& cell : machine.cells)
        for (int i = 0; orders[cell.part] == 2 && i < (cell.kind == CellKind::hexahedron ? 8 : 4); ++i)
            second[cell.nodes[i]] = true;
    const auto of_second = static_cast<long long>(std::ranges::count(second, true));
    return {static_cast<long long>(machine.nodes.size()) - of_second, of_second};
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
    for (const auto& [name, row] : input.friction)
        problem.sources.push_back({name, machine.half_model ? 0.5 : 1.0, {}, {}});
    Mistakes mistakes;
    mistakes.attempt("friction", [&] { name_rings(input, machine, problem); });
    mistakes.attempt("oil_circuits", [&] { problem.oil = oil_circuits(input, machine); });
    mistakes.attempt("enclosures", [&] { problem.enclosures = enclosures(input, machine); });
    mistakes.attempt("heat_sources", [&] { problem.body_heat = body_heats(input, machine); });
    mistakes.attempt("surfaces", [&] {
        problem.surfaces = surface_conditions(input, machine, loads);
        problem.radiation = radiation_inside(problem.surfaces, machine);
    });
    Segments segments(input, machine, friction, loads, observer);
    mistakes.attempt("joints", [&] { problem.interfaces = segments.interfaces(0); });
    mistakes.attempt("operation", [&] { segments.describe(problem); });
    mistakes.attempt("probes", [&] { problem.probes = heat_probes(input, machine); });
    mistakes.raise();
    problem.initial_temperature = [start = initial_temperatures(input, machine)](int part, const Vec3&) {
        return start[static_cast<std::size_t>(part)];
    };
    problem.time_tolerance = input.numerics.time_tolerance;
    problem.initial_step = input.numerics.initial_step;
    problem.max_step = input.numerics.max_step;
    problem.solver_tolerance = input.numerics.solver_tolerance;

    double end = 0;
    for (const auto& operation : input.operation)
        end += operation.duration;
    if (input.output.fields || !input.output.stress.empty() || !input.preload.empty()) {
        for (const double time : input.output.field_times)
            if (time < end * (1 - 1e-9))
                problem.field_times.push_back(time);
        problem.field_times.push_back(end);
        std::sort(problem.field_times.begin(), problem.field_times.end());
    }
    return problem;
}

}  // namespace deadpoint::press
