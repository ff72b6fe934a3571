#include "deadpoint/machine/assembly/select.hpp"

#include "deadpoint/core/names/pattern.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/machine/assembly/assembly.hpp"
#include "deadpoint/machine/assembly/round.hpp"
#include "deadpoint/machine/geometry/chart.hpp"
#include "deadpoint/machine/geometry/part_mesh.hpp"
#include "deadpoint/machine/geometry/shapes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <limits>
#include <optional>
#include <set>

namespace deadpoint::machine {

namespace {

using Kind = SurfaceSelector::Kind;

constexpr double position_tolerance = 1e-5;
constexpr double normal_tolerance = 1e-3;
constexpr double least_fraction = 1e-6;
constexpr std::array<const char*, 3> axis_names{"x", "y", "z"};

bool along(const Vec3& direction, Axis axis) { return std::abs(std::abs(direction[index_of(axis)]) - 1) < 1e-9; }

/// Whether a plane has the requested direction; a user states a normal with about four digits.
bool along(const PlaneGeometry& plane, const SurfaceSelector& selector)
{
    return selector.normal ? norm(cross(plane.normal, *selector.normal)) < normal_tolerance
                           : along(plane.normal, selector.axis);
}

/// Distance between the requested and the existing surface [m]; infinite for another kind or direction.
double distance(const FaceGeometry& geometry, const SurfaceSelector& selector)
{
    constexpr double infinity = std::numeric_limits<double>::infinity();
    if (selector.kind == Kind::plane) {
        const auto* plane = std::get_if<PlaneGeometry>(&geometry);
        if (plane == nullptr || !along(*plane, selector)) {
            return infinity;
        }
        if (selector.normal) {
            return std::abs(dot(plane->normal, selector.point) - plane->offset);
        }
        return std::abs(plane->offset * plane->normal[index_of(selector.axis)] - selector.position);
    }
    if (selector.kind == Kind::cylinder) {
        const auto* cylinder = std::get_if<CylinderGeometry>(&geometry);
        if (cylinder == nullptr || !along(cylinder->axis, selector.axis)) {
            return infinity;
        }
        return norm(project(selector.axis, cylinder->point) - selector.centre) +
               std::abs(cylinder->radius - selector.diameter / 2);
    }
    return 0;
}

bool contains_nearly(const BoxShape& box, const Vec3& point)
{
    constexpr double slack = 1e-9;
    for (std::size_t i = 0; i < 3; ++i) {
        if (point[i] < box.min[i] - slack || point[i] > box.max[i] + slack) {
            return false;
        }
    }
    return true;
}

std::string part_list(const Machine& machine)
{
    std::vector<std::string> names;
    for (const MeshPart& part : machine.parts) {
        names.push_back(part.name);
    }
    return fmt::format("{}", fmt::join(names, ", "));
}

[[noreturn]] void unknown_part(const Assembly& assembly, const std::string& pattern, const std::string& owner)
{
    const auto& dropped = assembly.machine.dropped_parts;
    const auto fits = [&](const std::string& name) { return matches(pattern, name); };
    if (std::any_of(dropped.begin(), dropped.end(), fits)) {
        throw InputError(
            fmt::format("{}: part '{}' lies wholly at x > 0 and is not in the half model\n  help: select its "
                        "twin at x < 0, or remove half_model from [machine]",
                        owner, pattern));
    }
    throw InputError(
        fmt::format("{}: there is no part '{}'; the parts are: {}", owner, pattern, part_list(assembly.machine)));
}

}  // namespace

std::vector<std::uint32_t> selected_parts(const Assembly& assembly, const SurfaceSelector& selector,
                                          const std::string& owner)
{
    const auto& parts = assembly.machine.parts;
    std::set<std::uint32_t> chosen;
    for (const std::string& pattern : selector.parts) {
        bool any = false;
        for (std::uint32_t i = 0; i < parts.size(); ++i) {
            if (!matches(pattern, parts[i].name)) {
                continue;
            }
            chosen.insert(i);
            any = true;
        }
        const bool dropped_too =
            pattern.find('*') != std::string::npos &&
            std::any_of(assembly.machine.dropped_parts.begin(), assembly.machine.dropped_parts.end(),
                        [&](const std::string& name) { return matches(pattern, name); });
        // one of several names can be the mirror image on the other side
        const bool forgiven =
            dropped_too || (selector.parts.size() > 1 && std::count(assembly.machine.dropped_parts.begin(),
                                                                    assembly.machine.dropped_parts.end(), pattern) > 0);
        if (!any && !forgiven) {
            unknown_part(assembly, pattern, owner);
        }
    }
    if (selector.parts.empty()) {
        for (std::uint32_t i = 0; i < parts.size(); ++i) {
            chosen.insert(i);
        }
    }
    if (chosen.empty()) {
        unknown_part(assembly, selector.parts.front(), owner);
    }
    return {chosen.begin(), chosen.end()};
}

std::vector<std::uint32_t> selected_faces(const Assembly& assembly, const SurfaceSelector& selector,
                                          const std::string& owner)
{
    const std::vector<std::uint32_t> parts = selected_parts(assembly, selector, owner);
    const auto chosen = [&](std::uint32_t part) { return std::binary_search(parts.begin(), parts.end(), part); };
    std::vector<std::uint32_t> faces;
    if (selector.kind == Kind::group) {
        for (const PartGroup& entry : assembly.groups) {
            if (!chosen(entry.part) || entry.group.name != selector.group) {
                continue;
            }
            for (const std::uint32_t face : entry.group.faces) {
                if (!assembly.machine.faces[face].symmetry) {
                    faces.push_back(face);
                }
            }
        }
    } else {
        for (std::uint32_t g = 0; g < assembly.machine.geometries.size(); ++g) {
            if (!chosen(assembly.part_of_geometry[g])) {
                continue;
            }
            if (distance(assembly.machine.geometries[g], selector) > position_tolerance) {
                continue;
            }
            faces.insert(faces.end(), assembly.faces_of_geometry[g].begin(), assembly.faces_of_geometry[g].end());
        }
    }
    std::sort(faces.begin(), faces.end());
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
    return faces;
}

namespace {

/// A chart of a face: that of its surface, or of its own plane where the surface has no form.
Chart chart_of(const Machine& machine, const Face& face)
{
    const FaceGeometry& geometry = machine.geometries[face.geometry];
    if (!std::holds_alternative<FreeformGeometry>(geometry)) {
        return Chart(geometry);
    }
    const Vec3 normal = normalised(area_vector(face, machine.nodes));
    return Chart(PlaneGeometry{normal, dot(normal, centre(face, machine.nodes))});
}

double share_within(const Machine& machine, std::uint32_t index, const BoxShape& box)
{
    const Face& face = machine.faces[index];
    const Chart chart = chart_of(machine, face);
    return chart.share_within(chart.flatten(face, index, machine.nodes), box);
}

/// The share of a face that a selector's kind and box take.
SurfaceFace selected_share(const Machine& machine, const SurfaceSelector& selector, std::uint32_t index)
{
    SurfaceFace result{index, selector.kind == Kind::exposed ? machine.exposed_fraction[index] : 1.0, true};
    if (selector.within) {
        result.fraction *= share_within(machine, index, *selector.within);
        result.central = contains_nearly(*selector.within, centre(machine.faces[index], machine.nodes));
    }
    return result;
}

}  // namespace

MeshSurface select_surface(const Assembly& assembly, const SurfaceDescription& description)
{
    const Machine& machine = assembly.machine;
    const SurfaceSelector& selector = description.selector;
    const std::string owner = fmt::format("surface '{}'", description.name);
    MeshSurface surface;
    surface.name = description.name;
    const std::vector<std::uint32_t> faces = selected_faces(assembly, selector, owner);
    for (const std::uint32_t index : faces) {
        const SurfaceFace face = selected_share(machine, selector, index);
        if (face.fraction < least_fraction) {
            continue;
        }
        surface.faces.push_back(face);
        surface.area += face.fraction * area(machine, machine.faces[index]);
    }
    if (faces.empty()) {
        throw no_face(assembly, selector, owner);
    }
    if (surface.faces.empty()) {
        throw InputError(fmt::format("{}: {} has no area in its box; correct the box", owner, describe(selector)));
    }
    return surface;
}

namespace {

/// "of normal (0.6, 0.8, 0) through (10, 20, 0) mm", or "along x".
std::string direction_text(const SurfaceSelector& selector)
{
    if (selector.kind != Kind::plane || !selector.normal) {
        return fmt::format("along {}", axis_names[index_of(selector.axis)]);
    }
    const auto& n = *selector.normal;
    const auto& p = selector.point;
    return fmt::format("of normal ({:.4g}, {:.4g}, {:.4g}) through ({}, {}, {}) mm", n[0], n[1], n[2],
                       millimetres(p[0]), millimetres(p[1]), millimetres(p[2]));
}

}  // namespace

std::string describe(const SurfaceSelector& selector)
{
    const std::string parts =
        selector.parts.empty() ? "any part" : fmt::format("part '{}'", fmt::join(selector.parts, "', '"));
    const char* axis = axis_names[index_of(selector.axis)];
    switch (selector.kind) {
    case Kind::plane:
        if (selector.normal) {
            return fmt::format("plane {} of {}", direction_text(selector), parts);
        }
        return fmt::format("plane {} = {} mm of {}", axis, millimetres(selector.position), parts);
    case Kind::cylinder:
        return fmt::format("cylinder of diameter {} mm along {} about ({}, {}) mm of {}",
                           millimetres(selector.diameter), axis, millimetres(selector.centre[0]),
                           millimetres(selector.centre[1]), parts);
    case Kind::group:
        return fmt::format("group '{}' of {}", selector.group, parts);
    case Kind::exposed:
        return fmt::format("exposed surface of {}", parts);
    case Kind::all:
        break;
    }
    return fmt::format("surface of {}", parts);
}

namespace {

/// Existing faces of the requested kind on these parts, nearest first.
std::string alternatives(const Assembly& assembly, const SurfaceSelector& selector,
                         const std::vector<std::uint32_t>& parts)
{
    const auto chosen = [&](std::uint32_t part) { return std::binary_search(parts.begin(), parts.end(), part); };
    if (selector.kind == Kind::group) {
        std::set<std::string> names;
        for (const PartGroup& entry : assembly.groups) {
            if (chosen(entry.part)) {
                names.insert(entry.group.name);
            }
        }
        return names.empty() ? std::string("these parts have no named groups")
                             : fmt::format("named groups there are: {}", fmt::join(names, ", "));
    }
    if (selector.kind != Kind::plane && selector.kind != Kind::cylinder) {
        return "check the box it must lie within";
    }
    std::vector<std::pair<double, std::string>> found;
    for (std::uint32_t g = 0; g < assembly.machine.geometries.size(); ++g) {
        if (!chosen(assembly.part_of_geometry[g]) || assembly.faces_of_geometry[g].empty()) {
            continue;
        }
        const double away = distance(assembly.machine.geometries[g], selector);
        if (!std::isfinite(away)) {
            continue;
        }
        found.emplace_back(away, fmt::format("{} of '{}'", describe(assembly.machine.geometries[g]),
                                             assembly.machine.parts[assembly.part_of_geometry[g]].name));
    }
    std::sort(found.begin(), found.end());
    std::vector<std::string> texts;
    for (const auto& [away, text] : found) {
        if (std::find(texts.begin(), texts.end(), text) == texts.end() && texts.size() < 4) {
            texts.push_back(text);
        }
    }
    const char* kind = selector.kind == Kind::plane ? "planes" : "cylinders";
    if (texts.empty()) {
        return fmt::format("there are no {} {} there", kind, direction_text(selector));
    }
    return fmt::format("the nearest there: {}", fmt::join(texts, ", "));
}

/// A position as the case file has it.
std::string written(double length) { return fmt::format("\"{} mm\"", millimetres(length)); }

/// The key of a selector that one of the existing cylinders differs in, and its value there.
std::string cylinder_remedy(const std::vector<const CylinderGeometry*>& cylinders, const SurfaceSelector& selector)
{
    const auto same_size = [&](const CylinderGeometry& c) {
        return std::abs(c.radius - selector.diameter / 2) < position_tolerance;
    };
    const auto off = [&](const CylinderGeometry& c) { return norm(project(selector.axis, c.point) - selector.centre); };
    const CylinderGeometry* nearest = nullptr;
    for (const auto* c : cylinders) {
        if (along(c->axis, selector.axis) && same_size(*c) && (nearest == nullptr || off(*c) < off(*nearest))) {
            nearest = c;
        }
    }
    if (nearest != nullptr) {
        const Vec2 centre = project(selector.axis, nearest->point);
        return fmt::format("change the centre to [{}, {}], or move the part by {:.4g} mm", written(centre[0]),
                           written(centre[1]), 1e3 * off(*nearest));
    }
    const auto other_size = [&](const CylinderGeometry& c) { return std::abs(c.radius - selector.diameter / 2); };
    for (const auto* c : cylinders) {
        if (along(c->axis, selector.axis) && off(*c) < position_tolerance &&
            (nearest == nullptr || other_size(*c) < other_size(*nearest))) {
            nearest = c;
        }
    }
    if (nearest != nullptr) {
        return fmt::format("change the diameter to {}, that of the nearest cylinder there",
                           written(2 * nearest->radius));
    }
    for (const Axis axis : {Axis::x, Axis::y, Axis::z}) {
        for (const auto* c : cylinders) {
            if (axis != selector.axis && along(c->axis, axis)) {
                return fmt::format("the part has a cylinder of diameter {} mm along {}: if it is the one, change the "
                                   "axis of its shape to \"{}\"",
                                   millimetres(2 * c->radius), axis_names[index_of(axis)],
                                   axis_names[index_of(selector.axis)]);
            }
        }
    }
    return "give a part that has such a bore or pin";
}

std::string plane_remedy(const std::vector<const PlaneGeometry*>& planes, const SurfaceSelector& selector)
{
    if (selector.normal) {
        return "correct `normal` and `point`";
    }
    constexpr double same = 1e-6;
    for (const auto* plane : planes) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const bool across = std::abs(std::abs(plane->normal[axis]) - 1) < same;
            if (across && static_cast<int>(axis) != static_cast<int>(index_of(selector.axis)) &&
                std::abs(plane->offset * plane->normal[axis] - selector.position) < same) {
                return fmt::format("change the axis to \"{}\": the part has a plane there at {}", "xyz"[axis],
                                   written(selector.position));
            }
        }
    }
    std::optional<double> nearest;
    for (const auto* plane : planes) {
        const double position = plane->offset * plane->normal[index_of(selector.axis)];
        const auto away = [&](double value) { return std::abs(value - selector.position); };
        if (along(*plane, selector) && (!nearest || away(position) < away(*nearest))) {
            nearest = position;
        }
    }
    return nearest ? fmt::format("change the position to {}, or move the part by {:.4g} mm", written(*nearest),
                                 1e3 * std::abs(*nearest - selector.position))
                   : "correct `axis`: planes lie across it";
}

/// What to change so that a selector finds one of the faces of some parts.
std::string remedy(const Assembly& assembly, const SurfaceSelector& selector, const std::vector<std::uint32_t>& parts)
{
    std::vector<const CylinderGeometry*> cylinders;
    std::vector<const PlaneGeometry*> planes;
    for (std::uint32_t g = 0; g < assembly.machine.geometries.size(); ++g) {
        if (!std::ranges::binary_search(parts, assembly.part_of_geometry[g]) || assembly.faces_of_geometry[g].empty()) {
            continue;
        }
        if (const auto* cylinder = std::get_if<CylinderGeometry>(&assembly.machine.geometries[g])) {
            cylinders.push_back(cylinder);
        }
        if (const auto* plane = std::get_if<PlaneGeometry>(&assembly.machine.geometries[g])) {
            planes.push_back(plane);
        }
    }
    const bool across_x = selector.kind == Kind::plane && !selector.normal && index_of(selector.axis) == 0;
    if (assembly.machine.half_model && across_x && selector.position > 0) {
        return "a half model keeps x <= 0: leave this face out, or remove half_model from [machine]";
    }
    switch (selector.kind) {
    case Kind::cylinder:
        return cylinder_remedy(cylinders, selector);
    case Kind::plane:
        return plane_remedy(planes, selector);
    default:
        return "select a face that is there";
    }
}

}  // namespace

InputError no_face(const Assembly& assembly, const SurfaceSelector& selector, const std::string& owner)
{
    const auto parts = selected_parts(assembly, selector, owner);
    return InputError(fmt::format("{}: {} matches no face; {}\n  help: {}", owner, describe(selector),
                                  alternatives(assembly, selector, parts), remedy(assembly, selector, parts)));
}

}  // namespace deadpoint::machine
