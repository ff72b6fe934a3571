#include "deadpoint/press/translate/linkage.hpp"

#include "deadpoint/casefile/check/directions.hpp"
#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/core/mistakes.hpp"
#include "deadpoint/drift/chain.hpp"
#include "deadpoint/drift/joint_surfaces.hpp"
#include "deadpoint/exchange/linkage.hpp"
#include "deadpoint/exchange/machine.hpp"
#include "deadpoint/press/translate/bearing_groups.hpp"
#include "deadpoint/press/translate/lookup.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace deadpoint::press {
namespace {

int body_index(const Linkage& linkage, const std::string& name)
{
    const auto found = std::find(linkage.bodies.begin(), linkage.bodies.end(), name);
    return found == linkage.bodies.end() ? -1 : static_cast<int>(found - linkage.bodies.begin());
}

// First contact of each joint in Machine::interfaces.
std::map<std::string, int> first_contacts(const casefile::Case& input)
{
    std::map<std::string, int> first;
    int next = 0;
    for (const auto& [name, joint] : input.joints) {
        first[name] = next;
        next += static_cast<int>(joint.interfaces.size());
    }
    return first;
}

bool is_ground(const casefile::Case& input, const std::string& body) { return input.bodies.at(body).ground; }

// The interface is marked as one that carries the joint in this body: `seat` in the ground, `journal` in the body that
// moves in it. Between two moving bodies either mark counts.
bool is_marked(const casefile::Case& input, const casefile::Joint& joint, const casefile::Interface& interface,
               const std::string& body)
{
    if (is_ground(input, body))
        return interface.seat;
    const bool in_ground =
        std::ranges::any_of(joint.bodies, [&](const std::string& other) { return is_ground(input, other); });
    return interface.journal || (!in_ground && interface.seat);
}

// The sides of a joint's contacts that carry it in a body: the marked ones; all where none is marked.
std::vector<drift::ContactSide> carrying_sides(const casefile::Case& input, const Machine& machine,
                                               const casefile::Joint& joint, int first, const std::string& body)
{
    std::vector<drift::ContactSide> all, marked;
    for (int i = 0; i < static_cast<int>(joint.interfaces.size()); ++i)
        for (const bool side_b : {false, true}) {
            const auto& contact = machine.interfaces[first + i];
            if (machine.parts[side_b ? contact.part_b : contact.part_a].body != body)
                continue;
            all.push_back({first + i, side_b});
            if (is_marked(input, joint, joint.interfaces[i], body))
                marked.push_back(all.back());
        }
    return marked.empty() ? all : marked;
}

// The contacts of each bearing of the crank that carries: it has a seat and a journal.
std::vector<std::vector<int>> carrying_bearings(const casefile::Case& input, const Machine& machine,
                                                const casefile::Joint& joint, int first)
{
    std::vector<int> contacts;
    for (int i = 0; i < static_cast<int>(joint.interfaces.size()); ++i)
        if (joint.interfaces[i].seat || joint.interfaces[i].journal)
            contacts.push_back(first + i);
    auto bearings = bearings_of(input, machine, contacts);
    const auto has = [&](const std::vector<int>& bearing, bool casefile::Interface::*mark) {
        return std::ranges::any_of(bearing, [&](int contact) { return joint.interfaces[contact - first].*mark; });
    };
    std::erase_if(bearings, [&](const auto& bearing) {
        return !has(bearing, &casefile::Interface::seat) || !has(bearing, &casefile::Interface::journal);
    });
    return bearings;
}

void require_sides(const std::vector<drift::ContactSide>& sides, const std::string& joint, const std::string& body,
                   Mistakes& mistakes)
{
    if (sides.empty())
        mistakes.add("joints." + joint,
                     fmt::format("no interface of this joint lies on a part of body '{}', so its centre there cannot "
                                 "follow the deformation",
                                 body),
                     "add the interface");
}

}  // namespace

Linkage describe_linkage(const casefile::Case& input)
{
    const auto& stated = input.mechanism.slide_body;
    if (stated.empty() && !input.chain)
        throw mistake("mechanism", "the case does not say which body carries the tool",
                      "add slide_body to [mechanism], or a [chain]");
    Linkage linkage;
    linkage.stroke_direction = casefile::stroke_direction(input);
    for (const auto& [name, body] : input.bodies) {
        const bool used =
            std::any_of(input.joints.begin(), input.joints.end(), [&, &body_name = name](const auto& joint) {
                const auto& bodies = joint.second.bodies;
                return std::find(bodies.begin(), bodies.end(), body_name) != bodies.end();
            });
        if (!used && !body.ground)
            continue;
        if (body.ground)
            linkage.ground = static_cast<int>(linkage.bodies.size());
        linkage.bodies.push_back(name);
    }
    linkage.driver = -1;
    for (const auto& [name, joint] : input.joints) {
        LinkageJoint result;
        result.name = name;
        result.kind =
            joint.kind == casefile::Joint::Kind::slide ? LinkageJoint::Kind::slide : LinkageJoint::Kind::revolute;
        result.body_a = body_index(linkage, joint.bodies.at(0));
        result.body_b = body_index(linkage, joint.bodies.at(1));
        result.centre = joint.centre;
        result.direction = (1 / norm(joint.direction)) * joint.direction;
        result.guides_rotation = joint.guides_rotation;
        if (joint.driver)
            linkage.driver = static_cast<int>(linkage.joints.size());
        linkage.joints.push_back(result);
    }
    if (linkage.driver < 0)
        throw mistake("joints", "no joint has driver = true; mark the joint of the crank in the frame");
    const auto& slide = stated.empty() ? input.chain->slide_body : stated;
    linkage.slide_body = body_index(linkage, slide);
    if (linkage.slide_body < 0)
        throw mistake(stated.empty() ? "chain.slide_body" : "mechanism.slide_body",
                      fmt::format("body '{}' carries the tool, but no joint holds it; add its guide", slide));
    return linkage;
}

drift::ChainDescription describe_chain(const casefile::Case& input, const Machine& machine, const Linkage& linkage)
{
    const auto& chain = *input.chain;
    const auto first = first_contacts(input);
    drift::ChainDescription result;
    result.slide_surface = surface_index(machine, chain.slide_surface);
    result.table_surface = surface_index(machine, chain.table_surface);
    result.pressed = chain.reaction_angle ? Vec2{std::cos(*chain.reaction_angle), std::sin(*chain.reaction_angle)}
                                          : linkage.stroke_direction;
    int index = 0;
    Mistakes mistakes;
    for (const auto& [name, joint] : input.joints) {
        drift::JointSurfaces surfaces{carrying_sides(input, machine, joint, first.at(name), joint.bodies.at(0)),
                                      carrying_sides(input, machine, joint, first.at(name), joint.bodies.at(1)),
                                      joint.kind != casefile::Joint::Kind::ball};
        if (joint.kind != casefile::Joint::Kind::slide) {
            require_sides(surfaces.in_a, name, joint.bodies[0], mistakes);
            require_sides(surfaces.in_b, name, joint.bodies[1], mistakes);
        }
        if (name == chain.crank_joint) {
            result.crank_joint = index;
            const bool ground_is_b = linkage.joints[index].body_b == linkage.ground;
            result.seats = ground_is_b ? surfaces.in_b : surfaces.in_a;
            result.bearings = carrying_bearings(input, machine, joint, first.at(name));
        }
        result.joints.push_back(std::move(surfaces));
        ++index;
    }
    if (result.seats.empty() || result.bearings.empty())
        mistakes.add(
            "joints." + chain.crank_joint,
            "no bearing of the crank carries it: one that does has an interface on the frame marked 'seat' (ring or "
            "bush in the frame) and one marked 'journal' (ring or bush on the shaft), or one interface with both",
            "if this is not the joint of crankshaft and frame, name that in chain.crank_joint; else add seat = "
            "true and journal = true to its interfaces");
    mistakes.raise();
    return result;
}

}  // namespace deadpoint::press
