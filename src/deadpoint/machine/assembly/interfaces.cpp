#include "deadpoint/machine/assembly/interfaces.hpp"

#include "deadpoint/core/mistakes.hpp"
#include "deadpoint/machine/assembly/assembly.hpp"
#include "deadpoint/machine/assembly/contacts.hpp"
#include "deadpoint/machine/assembly/limits.hpp"
#include "deadpoint/machine/assembly/select.hpp"
#include "deadpoint/machine/geometry/chart.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <limits>
#include <set>

namespace deadpoint::machine {

namespace {

std::vector<std::uint32_t> faces_or_throw(const Assembly& assembly, const SurfaceSelector& selector,
                                          const std::string& owner)
{
    std::vector<std::uint32_t> faces = selected_faces(assembly, selector, owner);
    if (faces.empty()) {
        throw no_face(assembly, selector, owner);
    }
    return faces;
}

std::set<std::string> parts_of(const Machine& machine, const std::vector<std::uint32_t>& faces)
{
    std::set<std::string> names;
    for (const std::uint32_t face : faces) {
        names.insert(machine.parts[machine.faces[face].part].name);
    }
    return names;
}

/// An interface joins one part to one part; a selector of side b may match more, as long as they do not touch.
void check_parts(const Machine& machine, const Contact& contact, const Side& a, const std::string& owner)
{
    const std::set<std::string> of_a = parts_of(machine, a.faces);
    std::set<std::string> of_b;
    for (const auto* points : {&contact.points, &contact.drawn_points}) {
        for (const ContactPoint& point : *points) {
            of_b.insert(machine.parts[machine.faces[point.face_b].part].name);
        }
    }
    if (of_a.size() > 1 || of_b.size() > 1) {
        throw InputError(fmt::format(
            "{}: joins {} with {}{}, but an interface joins exactly one part to one part; narrow "
            "its selectors or make several interfaces",
            owner, fmt::join(of_a, ", "), of_b.empty() ? "nothing" : fmt::format("{}", fmt::join(of_b, ", ")),
            contact.stroke > 0 ? " over its stroke" : ""));
    }
}

/// Distance of the surface of side b from that of side a; infinite if they can never touch.
double separation(const FaceGeometry& a, const FaceGeometry& b)
{
    constexpr double infinity = std::numeric_limits<double>::infinity();
    if (!can_touch(a, b, 1e9)) {
        return infinity;
    }
    if (const auto* p = std::get_if<PlaneGeometry>(&a)) {
        return std::abs(p->offset + std::get<PlaneGeometry>(b).offset);
    }
    if (const auto* c = std::get_if<CylinderGeometry>(&a)) {
        const auto& d = std::get<CylinderGeometry>(b);
        const Vec3 between = d.point - c->point;
        return std::abs(c->radius - d.radius) + norm(between - dot(between, c->axis) * c->axis);
    }
    return infinity;
}

/// The surfaces of the parts of side b that come nearest to touching side a.
std::string nearest_partners(const Assembly& assembly, const Side& a, const std::vector<std::uint32_t>& parts_b)
{
    const Machine& machine = assembly.machine;
    std::set<std::uint32_t> own;
    for (const std::uint32_t face : a.faces) {
        own.insert(machine.faces[face].geometry);
    }
    std::vector<std::pair<double, std::string>> found;
    for (std::uint32_t g = 0; g < machine.geometries.size(); ++g) {
        const std::uint32_t part = assembly.part_of_geometry[g];
        if (!std::binary_search(parts_b.begin(), parts_b.end(), part)) {
            continue;
        }
        double away = std::numeric_limits<double>::infinity();
        for (const std::uint32_t h : own) {
            away = std::min(away, separation(machine.geometries[h], machine.geometries[g]));
        }
        if (std::isfinite(away)) {
            found.emplace_back(away, fmt::format("{} ({:.4g} mm away)", describe(machine.geometries[g]), 1e3 * away));
        }
    }
    std::sort(found.begin(), found.end());
    std::vector<std::string> texts;
    for (const auto& [away, text] : found) {
        if (std::find(texts.begin(), texts.end(), text) == texts.end() && texts.size() < 3) {
            texts.push_back(text);
        }
    }
    if (texts.empty()) {
        return "side b has no surface that could face side a";
    }
    return fmt::format("nearest surfaces of side b's parts: {}", fmt::join(texts, ", "));
}

void check_coverage(const Assembly& assembly, const Contact& contact, const InterfaceDescription& description,
                    const Side& a, const std::string& owner)
{
    if (contact.coverage() >= least_coverage || (description.partial && contact.drawn_area > 0)) {
        return;
    }
    throw InputError(fmt::format(
        "{}: only {:.6g} mm2 of the {:.6g} mm2 of side a ({}) find a partner on side b ({}, "
        "{:.6g} mm2), that is {:.1f} %, "
        "but {:.0f} % are needed; {}; move or narrow side a, widen side b or the gap, or state partial = true",
        owner, 1e6 * contact.drawn_area, 1e6 * contact.area_a, describe(description.a), describe(description.b),
        1e6 * contact.area_b, 100 * contact.coverage(), 100 * least_coverage,
        nearest_partners(assembly, a, selected_parts(assembly, description.b, owner))));
}

/// Travel of side a against side b; none if a body other than the two sliding ones takes part.
std::vector<TravelStop> travel_of_a(const Machine& machine, const Travel& travel, const Side& a, const Side& b)
{
    const auto body = [&](const Side& side) -> const std::string& {
        return machine.parts[machine.faces[side.faces.front()].part].body;
    };
    std::vector<TravelStop> stops = travel.stops;
    if (body(a) == travel.standing && body(b) == travel.moving) {
        for (TravelStop& stop : stops) {
            stop.offset = -1.0 * stop.offset;
        }
    } else if (body(a) != travel.moving || body(b) != travel.standing) {
        stops.clear();
    }
    return stops;
}

void check_travel(const Contact& contact, const std::vector<TravelStop>& travel, double gap, const std::string& owner)
{
    const bool lifts = !travel.empty() && std::any_of(travel.begin(), travel.end(), [&](const TravelStop& stop) {
        return !Chart(contact.geometry).shift(stop.offset, gap);
    });
    if (lifts) {
        throw InputError(
            fmt::format("{}: its {} does not lie along the travel of its joint, so the sides would separate during the "
                        "stroke; correct the direction of travel, or let this joint not be swept",
                        owner, describe(contact.geometry)));
    }
}

std::string owner_of(const InterfaceDescription& description)
{
    return fmt::format("interface '{}'", description.name);
}

Contact find_interface(const Assembly& assembly, const InterfaceDescription& description, const Side& a, const Side& b,
                       std::vector<double>& covered)
{
    const std::string owner = owner_of(description);
    const double gap = description.gap > 0 ? std::max(description.gap, 1e-9) : contact_tolerance;
    const std::vector<TravelStop> travel = travel_of_a(assembly.machine, description.travel, a, b);
    Contact contact = find_contact(assembly, a, b, gap, covered, travel);
    contact.name = description.name;
    check_parts(assembly.machine, contact, a, owner);
    check_coverage(assembly, contact, description, a, owner);
    check_travel(contact, travel, gap, owner);
    return contact;
}

}  // namespace

std::vector<Contact> find_interfaces(const Assembly& assembly, const std::vector<InterfaceDescription>& descriptions,
                                     std::vector<double>& covered, Mistakes& mistakes)
{
    std::vector<Contact> contacts;
    for (const InterfaceDescription& description : descriptions) {
        const std::string path = interface_path(description.name);
        Side a, b;
        const auto find = [&](const SurfaceSelector& selector, const std::string& name, Side& side) {
            return mistakes.attempt(path + "." + name, [&] {
                side = {faces_or_throw(assembly, selector, owner_of(description) + ", side " + name), selector.within};
            });
        };
        const bool has_a = find(description.a, "a", a);
        if (find(description.b, "b", b) && has_a) {
            mistakes.attempt(path, [&] { contacts.push_back(find_interface(assembly, description, a, b, covered)); });
        }
    }
    return contacts;
}

}  // namespace deadpoint::machine
