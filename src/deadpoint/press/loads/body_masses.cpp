#include "deadpoint/press/loads/body_masses.hpp"

#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/core/mistakes.hpp"
#include "deadpoint/exchange/machine.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace deadpoint::press {
namespace {

bool is_cut_or_dropped(const casefile::Case& input, const Machine& machine, const std::string& body)
{
    const auto dropped = [&](const std::string& part) {
        const auto found = input.parts.find(part);
        return found != input.parts.end() && found->second.body == body;
    };
    return std::ranges::any_of(machine.parts, [&](const MeshPart& part) { return part.body == body && part.cut; }) ||
           std::ranges::any_of(machine.dropped_parts, dropped);
}

bool has_parts(const casefile::Case& input, const std::string& body)
{
    return std::ranges::any_of(input.parts, [&](const auto& part) { return part.second.body == body; });
}

// Whether a slide on the ground keeps the body from turning, so that its inertia does not matter.
bool is_kept_upright(const Linkage& linkage, int body)
{
    return std::ranges::any_of(linkage.joints, [&](const LinkageJoint& joint) {
        return joint.kind == LinkageJoint::Kind::slide && joint.guides_rotation &&
               ((joint.body_a == body && joint.body_b == linkage.ground) ||
                (joint.body_b == body && joint.body_a == linkage.ground));
    });
}

double largest_distance(const Linkage& linkage, int body)
{
    std::vector<Vec2> centres;
    for (const auto& joint : linkage.joints)
        if (joint.body_a == body || joint.body_b == body)
            centres.push_back(joint.centre);
    double largest = 0;
    for (const auto& a : centres)
        for (const auto& b : centres)
            largest = std::max(largest, norm(a - b));
    return largest;
}

}  // namespace

BodyMass mass_of_parts(const casefile::Case& input, const Machine& machine, const std::string& body)
{
    double mass = 0, second = 0;
    Vec2 first{};
    for (const auto& part : machine.parts) {
        if (part.body != body)
            continue;
        const double density = input.materials.at(input.parts.at(part.name).material).density;
        mass += density * part.moments.volume;
        first = first + density * part.moments.first;
        second += density * part.moments.second;
    }
    if (!(mass > 0))
        return {};
    if (machine.half_model && !input.bodies.at(body).mirror) {
        mass *= 2;
        first = {0, 2 * first[1]};
        second *= 2;
    }
    const Vec2 centre = (1 / mass) * first;
    return {mass, centre, second - mass * dot(centre, centre)};
}

bool masses_need_parts(const casefile::Case& input, const Linkage& linkage)
{
    for (int b = 0; b < static_cast<int>(linkage.bodies.size()); ++b) {
        const auto& name = linkage.bodies[static_cast<std::size_t>(b)];
        const auto& body = input.bodies.at(name);
        if (b == linkage.ground || !has_parts(input, name))
            continue;
        if (!body.mass || !body.centre_of_mass || (!body.inertia && !is_kept_upright(linkage, b)))
            return true;
    }
    return false;
}

BodyMasses describe_masses(const casefile::Case& input, const Linkage& linkage, const Machine* machine)
{
    BodyMasses result;
    Mistakes mistakes;
    for (int b = 0; b < static_cast<int>(linkage.bodies.size()); ++b) {
        const auto& name = linkage.bodies[static_cast<std::size_t>(b)];
        if (b == linkage.ground) {
            result.values.emplace_back();
            result.origins.emplace_back();
            continue;
        }
        const auto& body = input.bodies.at(name);
        const BodyMass parts = machine ? mass_of_parts(input, *machine, name) : BodyMass{};
        const bool solid = parts.mass > 0;
        if (!solid && !(body.mass && body.centre_of_mass))
            mistakes.add(
                "bodies." + name,
                fmt::format("the loads need its {}, which no part gives", body.mass ? "centre of mass" : "mass"),
                body.mass ? "add centre_of_mass = [\"0 mm\", \"0 mm\"], at bottom dead point"
                          : "add mass = \"10 kg\" and centre_of_mass, or parts of this body");
        BodyMass mass{body.mass.value_or(parts.mass), body.centre_of_mass.value_or(parts.centre), 0};
        std::string origin = body.mass && body.centre_of_mass ? "stated" : "parts";
        if (solid && (body.mass || body.centre_of_mass) && origin == "parts")
            origin = "stated and parts";
        if (body.inertia) {
            mass.inertia = *body.inertia;
        } else if (solid) {
            mass.inertia = parts.inertia * mass.mass / parts.mass;
            origin = origin == "parts" ? origin : "stated and parts";
        } else {
            const double length = largest_distance(linkage, b);
            mass.inertia = mass.mass * length * length / 12;
            origin += is_kept_upright(linkage, b) ? "" : ", inertia of a slender rod";
        }
        if (solid && machine->half_model && !body.mirror && !body.thermal_only &&
            !is_cut_or_dropped(input, *machine, name))
            result.warnings.push_back(
                {"symmetry of body " + name,
                 fmt::format(
                     "body '{}' lies on one side of the plane of symmetry, but is not marked as existing twice: its "
                     "loads are those of body and image together; add mirror = true",
                     name)});
        result.values.push_back(mass);
        result.origins.push_back(origin);
    }
    mistakes.raise();
    return result;
}

}  // namespace deadpoint::press
