#include "deadpoint/full/model/sketch.hpp"

#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/core/mistakes.hpp"
#include "deadpoint/machine/assembly/decimated_surface.hpp"
#include "deadpoint/machine/assembly/sketch.hpp"
#include "deadpoint/press/machine/machine.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace deadpoint::full {
namespace {

std::vector<Diagnostic> found_in(const Mistakes& mistakes)
{
    try {
        mistakes.raise();
    } catch (const CaseError& error) {
        return error.diagnostics();
    } catch (const CaseDomainError& error) {
        return error.diagnostics();
    }
    return {};
}

std::vector<press::SoughtFace> sought_faces(const MachineDescription& description, const machine::Sketch& sketch)
{
    std::vector<press::SoughtFace> sought;
    for (const auto& surface : description.surfaces)
        if (std::ranges::find(sketch.machine.surfaces, surface.name, &MeshSurface::name) ==
            sketch.machine.surfaces.end())
            sought.push_back({"surfaces." + surface.name, surface.selector});
    for (std::size_t i = 0; i < description.interfaces.size(); ++i) {
        const auto& interface = description.interfaces[i];
        const auto path = interface_path(interface.name);
        if (sketch.interfaces[i].sides[0].empty())
            sought.push_back({path + ".a", interface.a});
        if (sketch.interfaces[i].sides[1].empty())
            sought.push_back({path + ".b", interface.b});
    }
    return sought;
}

DecimatedSurface surface_of(const Machine& machine)
{
    constexpr std::size_t triangles = 40000;  // a page of some 2 MB
    return machine.parts.empty() ? DecimatedSurface{} : machine::decimated_surface(machine, triangles);
}

}  // namespace

press::CaseSketch sketch_case(const casefile::Case& input, double size_scale, Observer& observer, MeshedParts& kept)
{
    press::CaseSketch result;
    if (input.parts.empty())
        return result;
    Mistakes mistakes;
    const auto description = press::describe_machine(input, size_scale, mistakes);
    auto sketch = machine::sketch_machine(description, observer, &kept);
    result.sought = sought_faces(description, sketch);
    result.interfaces = std::move(sketch.interfaces);
    result.missing = found_in(mistakes);
    std::ranges::move(sketch.missing, std::back_inserter(result.missing));
    result.machine = std::make_shared<const Machine>(std::move(sketch.machine));
    result.surface = surface_of(*result.machine);
    return result;
}

press::CaseSketch sketch_of(const Machine& machine)
{
    press::CaseSketch result;
    for (const auto& contact : machine.interfaces)
        result.interfaces.push_back(machine::faces_of(contact));
    result.machine = {std::shared_ptr<void>(), &machine};
    result.surface = surface_of(machine);
    return result;
}

}  // namespace deadpoint::full
