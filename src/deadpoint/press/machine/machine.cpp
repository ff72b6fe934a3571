#include "deadpoint/press/machine/machine.hpp"

#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/casefile/describe/spelling.hpp"
#include "deadpoint/core/mistakes.hpp"
#include "deadpoint/exchange/named_axes.hpp"
#include "deadpoint/press/machine/travel.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <string>

namespace deadpoint::press {
namespace {

template <typename T>
T needed(const std::optional<T>& value, const char* key, const casefile::Surface& surface, const std::string& name)
{
    if (!value)
        throw mistake("surfaces." + name,
                      fmt::format("select = \"{}\" needs '{}'", casefile::name_of(surface.select), key));
    return *value;
}

StepSource step_source(const casefile::Part& part)
{
    StepSource source{part.step, part.solid, part.unit};
    source.axes = named_axes(part.axes).value_or(source.axes);
    source.rules = {part.circle_cells, part.smallest_cell.value_or(0), part.omit};
    return source;
}

PartDescription part_of(const casefile::Case& input, const std::string& name, const casefile::Part& part)
{
    const auto material = input.materials.find(part.material);
    if (material == input.materials.end())
        throw mistake(fmt::format("parts.{}.material", name), fmt::format("there is no material '{}'", part.material));
    if (!input.bodies.contains(part.body))
        throw mistake(fmt::format("parts.{}.body", name), fmt::format("there is no body '{}'", part.body));

    PartDescription result;
    result.name = name;
    result.body = part.body;
    result.size = part.size.value_or(0);
    result.density = material->second.density;
    result.translation = part.position;
    result.tetrahedra = part.tetrahedra;
    result.second_order = (part.order > 0 ? part.order : input.numerics.order) == 2;
    const int sources = (part.shapes.empty() ? 0 : 1) + (part.step.empty() ? 0 : 1) + (part.mesh.empty() ? 0 : 1);
    if (sources != 1)
        throw mistake("parts." + name, "give exactly one of 'shapes', 'step' and 'mesh'");
    if (!part.shapes.empty())
        result.source = part.shapes;
    else if (!part.step.empty())
        result.source = step_source(part);
    else
        result.source = MeshSource{part.mesh, part.unit.value_or(MeshSource{}.unit)};
    return result;
}

SurfaceSelector side_of(const casefile::Case& input, const casefile::Joint& joint, const casefile::Interface& interface,
                        const std::string& side)
{
    if (interface.diameter && input.parts.contains(side)) {
        SurfaceSelector selector;
        selector.kind = SurfaceSelector::Kind::cylinder;
        selector.parts = {side};
        selector.axis = Axis::z;
        selector.centre = joint.centre;
        selector.diameter = *interface.diameter;
        return selector;
    }
    const auto surface = input.surfaces.find(side);
    if (surface != input.surfaces.end())
        return selector_of(surface->second, side);
    if (input.parts.contains(side))
        throw InputError(fmt::format("'{}' is a part, and no diameter is given\n  help: add the diameter of its "
                                     "cylinder about the joint's centre, or name a surface",
                                     side));
    throw InputError(fmt::format("'{}' is neither a surface nor a part", side));
}

/// @return nothing where a side is at fault
std::optional<InterfaceDescription> interface_of(const casefile::Case& input, const std::string& joint,
                                                 const casefile::Interface& interface, const Travel& travel,
                                                 Mistakes& mistakes)
{
    const std::string path = fmt::format("joints.{}.interfaces.{}", joint, interface.name);
    InterfaceDescription result{joint + "." + interface.name,    {},     {},
                                interface.drawn_gap.value_or(0), travel, interface.partial};
    const auto& of = input.joints.at(joint);
    const bool a = mistakes.attempt(path + ".a", [&] { result.a = side_of(input, of, interface, interface.a); });
    const bool b = mistakes.attempt(path + ".b", [&] { result.b = side_of(input, of, interface, interface.b); });
    return a && b ? std::optional(result) : std::nullopt;
}

void set_plane(SurfaceSelector& selector, const casefile::Surface& surface, const std::string& name)
{
    if (surface.normal != Vec3{}) {
        selector.normal = normalised(surface.normal);
        selector.point = surface.point;
        return;
    }
    selector.axis = needed(surface.axis, "axis", surface, name);
    selector.position = needed(surface.position, "position", surface, name);
}

}  // namespace

SurfaceSelector selector_of(const casefile::Surface& surface, const std::string& name)
{
    using Kind = SurfaceSelector::Kind;
    using Select = casefile::Surface::Select;
    SurfaceSelector selector;
    selector.parts = surface.parts;
    selector.within = surface.within;
    switch (surface.select) {
    case Select::exposed:
        selector.kind = Kind::exposed;
        break;
    case Select::all:
        selector.kind = Kind::all;
        break;
    case Select::box:
        selector.kind = Kind::all;
        selector.within = needed(surface.within, "within", surface, name);
        break;
    case Select::plane:
        selector.kind = Kind::plane;
        set_plane(selector, surface, name);
        break;
    case Select::cylinder:
        selector.kind = Kind::cylinder;
        selector.axis = needed(surface.axis, "axis", surface, name);
        selector.centre = needed(surface.centre, "centre", surface, name);
        selector.diameter = needed(surface.diameter, "diameter", surface, name);
        break;
    case Select::group:
        selector.kind = Kind::group;
        selector.group = surface.group;
        break;
    }
    return selector;
}

MachineDescription describe_machine(const casefile::Case& input, double size_scale)
{
    Mistakes mistakes;
    auto result = describe_machine(input, size_scale, mistakes);
    mistakes.raise();
    return result;
}

MachineDescription describe_machine(const casefile::Case& input, double size_scale, Mistakes& mistakes)
{
    if (!(size_scale > 0))
        throw InputError(fmt::format("the scale of the cell sizes must be positive, not {}", size_scale));
    MachineDescription result;
    result.size = input.numerics.size;
    result.size_scale = size_scale;
    result.seam_tolerance = input.numerics.seam_tolerance;
    result.half_model = input.machine.half_model;
    result.unbonded = input.machine.unbonded;
    for (const auto& [name, bond] : input.bonds)
        result.bonds.push_back({name, bond.between, casefile::is_open(bond.conductance)});
    for (const auto& [name, part] : input.parts)
        mistakes.attempt("parts." + name,
                         [&, &name = name, &part = part] { result.parts.push_back(part_of(input, name, part)); });
    for (const auto& [name, surface] : input.surfaces)
        mistakes.attempt("surfaces." + name, [&, &name = name, &surface = surface] {
            result.surfaces.push_back({name, selector_of(surface, name)});
        });
    std::map<std::string, Travel> travels;
    mistakes.attempt("joints", [&] { travels = describe_travel(input); });
    for (const auto& [name, joint] : input.joints)
        for (const casefile::Interface& interface : joint.interfaces)
            if (auto described = interface_of(input, name, interface, travels[name], mistakes))
                result.interfaces.push_back(*std::move(described));
    return result;
}

}  // namespace deadpoint::press
