#include "deadpoint/study/draft/draft.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <map>
#include <numeric>
#include <set>

namespace deadpoint::study {
namespace {

using machine::CadContact;
using machine::CadModel;
constexpr double parallel = 1e-3;

/// Roles of all solids: by name, and for the others that of the neighbour with the largest contact.
class Roles {
public:
    Roles(const CadModel& model, const std::vector<CadContact>& contacts) : follows(model.solids.size())
    {
        std::iota(follows.begin(), follows.end(), std::size_t{0});
        for (const auto& solid : model.solids) {
            roles.push_back(role_of(solid.name));
        }
        by_name = roles;
        // A neighbour may itself take its role from another.
        for (std::size_t round = 0; round < roles.size(); ++round) {
            spread(contacts);
        }
    }
    std::vector<Role> roles;
    std::vector<Role> by_name;
    std::vector<std::size_t> follows;  ///< the solid that another one belongs to

private:
    void spread(const std::vector<CadContact>& contacts)
    {
        for (std::size_t i = 0; i < roles.size(); ++i) {
            if (roles[i] != Role::unknown) {
                continue;
            }
            const CadContact* largest = nullptr;
            for (const CadContact& contact : contacts) {
                if ((contact.a == i || contact.b == i) && (largest == nullptr || contact.area > largest->area)) {
                    largest = &contact;
                }
            }
            if (largest != nullptr) {
                follows[i] = largest->a == i ? largest->b : largest->a;
                roles[i] = roles[follows[i]];
            }
        }
    }
};

std::string name_of(Role role)
{
    switch (role) {
    case Role::frame:
        return "frame";
    case Role::crank:
        return "crank";
    case Role::rod:
        return "rod";
    case Role::slide:
        return "slide";
    case Role::unknown:
        break;
    }
    return "loose";
}

std::size_t root(std::vector<std::size_t>& parents, std::size_t i)
{
    while (parents[i] != i) {
        i = parents[i] = parents[parents[i]];
    }
    return i;
}

/// Numbers of groups: solids of one role that touch, and all of the frame.
std::vector<std::size_t> groups_of(const Roles& roles, const std::vector<CadContact>& contacts)
{
    std::vector<std::size_t> parents(roles.roles.size());
    std::iota(parents.begin(), parents.end(), std::size_t{0});
    for (const CadContact& contact : contacts) {
        const bool same = roles.roles[contact.a] == roles.roles[contact.b];
        const bool known = roles.roles[contact.a] != Role::unknown;
        if ((same && known) || roles.follows[contact.a] == contact.b || roles.follows[contact.b] == contact.a) {
            parents[root(parents, contact.a)] = root(parents, contact.b);
        }
    }
    std::size_t frame = parents.size();
    for (std::size_t i = 0; i < parents.size(); ++i) {
        if (roles.roles[i] == Role::frame) {
            frame = frame == parents.size() ? i : frame;
            parents[root(parents, i)] = root(parents, frame);
        }
    }
    for (std::size_t i = 0; i < parents.size(); ++i) {
        parents[i] = root(parents, i);
    }
    return parents;
}

/// Without a word for the frame, the largest group is the ground.
std::size_t ground_of(const Draft& draft, const Roles& roles, const std::vector<std::size_t>& groups)
{
    std::vector<double> volumes(groups.size(), 0.0);
    for (std::size_t i = 0; i < groups.size(); ++i) {
        if (roles.roles[i] == Role::frame) {
            return groups[i];
        }
        volumes[groups[i]] += draft.model.solids[i].volume;
    }
    return static_cast<std::size_t>(std::ranges::max_element(volumes) - volumes.begin());
}

void make_bodies(Draft& draft, const Roles& roles)
{
    const auto groups = groups_of(roles, draft.contacts);
    const std::size_t ground = ground_of(draft, roles, groups);
    std::vector<std::size_t> order{ground};
    for (std::size_t i = 0; i < groups.size(); ++i) {
        if (std::ranges::find(order, groups[i]) == order.end()) {
            order.push_back(groups[i]);
        }
    }
    std::set<std::string> names;
    draft.body_of.resize(groups.size());
    for (const std::size_t group : order) {
        DraftBody body;
        for (std::size_t i = 0; i < groups.size(); ++i) {
            if (groups[i] == group) {
                body.solids.push_back(i);
                body.role = body.role == Role::unknown ? roles.roles[i] : body.role;
                draft.body_of[i] = draft.bodies.size();
            }
        }
        body.role = group == ground ? Role::frame : body.role;
        body.by_name =
            std::ranges::any_of(body.solids, [&](std::size_t i) { return roles.by_name[i] != Role::unknown; });
        const std::string stem =
            body.role == Role::unknown ? draft.model.solids[body.solids.front()].name : name_of(body.role);
        body.name = stem;
        for (int n = 2; !names.insert(body.name).second; ++n) {
            body.name = fmt::format("{}_{}", stem, n);
        }
        draft.bodies.push_back(std::move(body));
    }
}

bool of_roles(const Draft& draft, const CadContact& contact, Role one, Role other)
{
    const Role a = draft.bodies[draft.body_of[contact.a]].role;
    const Role b = draft.bodies[draft.body_of[contact.b]].role;
    return (a == one && b == other) || (a == other && b == one);
}

/// The middle of the part of a cylinder that is in contact.
Vec3 middle_of(const CadContact& contact)
{
    return contact.point + 0.5 * (contact.range[0] + contact.range[1]) * contact.direction;
}

/// The nearest direction of the drawing's axes; zero where none is within 1 mrad.
Vec3 along_axis(const Vec3& direction)
{
    for (std::size_t i = 0; i < 3; ++i) {
        Vec3 axis{};
        axis[i] = direction[i] > 0 ? 1 : -1;
        if (norm(cross(direction, axis)) < parallel) {
            return axis;
        }
    }
    return {};
}

Vec3 centre_of(const Draft& draft, Role role)
{
    Vec3 sum{};
    double volume = 0;
    for (const DraftBody& body : draft.bodies) {
        for (const std::size_t i : body.solids) {
            if (body.role == role) {
                const auto& solid = draft.model.solids[i];
                sum = sum + 0.5 * solid.volume * (solid.bounds.min + solid.bounds.max);
                volume += solid.volume;
            }
        }
    }
    return volume > 0 ? (1 / volume) * sum : sum;
}

DraftAxes axes_of(const Draft& draft)
{
    DraftAxes axes;
    const CadContact* bearing = nullptr;
    for (const CadContact& contact : draft.contacts) {
        const bool turns =
            contact.kind == CadContact::Kind::cylinder && of_roles(draft, contact, Role::crank, Role::frame);
        if (turns && (bearing == nullptr || contact.area > bearing->area)) {
            bearing = &contact;
        }
    }
    if (bearing == nullptr) {
        return axes;
    }
    Vec3 z = along_axis(bearing->direction);
    // The slide hangs below the crankshaft.
    Vec3 way = middle_of(*bearing) - centre_of(draft, Role::slide);
    way = way - dot(way, z) * z;
    Vec3 up{};
    for (std::size_t i = 0; i < 3; ++i) {
        if (std::abs(way[i]) > 0.9 * norm(way)) {
            up[i] = way[i] > 0 ? 1 : -1;
        }
    }
    if (norm(z) == 0 || norm(up) == 0) {
        return axes;
    }
    // Of both ways along the crankshaft, the positive one of the drawing.
    z = (z[0] + z[1] + z[2] < 0 ? -1.0 : 1.0) * z;
    axes.rows = {cross(up, z), up, z};
    axes.found = true;
    return axes;
}

Vec3 turned(const DraftAxes& axes, const Vec3& v)
{
    return {dot(axes.rows[0], v), dot(axes.rows[1], v), dot(axes.rows[2], v)};
}

void turn(const DraftAxes& axes, BoxShape& box)
{
    const Vec3 a = turned(axes, box.min);
    const Vec3 b = turned(axes, box.max);
    for (std::size_t i = 0; i < 3; ++i) {
        box.min[i] = std::min(a[i], b[i]);
        box.max[i] = std::max(a[i], b[i]);
    }
}

void turn(const DraftAxes& axes, machine::CadFace& face)
{
    if (auto* plane = std::get_if<machine::CadPlane>(&face.form)) {
        plane->normal = turned(axes, plane->normal);
        for (auto& loop : plane->loops) {
            for (Vec3& point : loop) {
                point = turned(axes, point);
            }
        }
    } else if (auto* cylinder = std::get_if<machine::CadCylinder>(&face.form)) {
        cylinder->point = turned(axes, cylinder->point);
        cylinder->axis = turned(axes, cylinder->axis);
        cylinder->across = turned(axes, cylinder->across);
    }
}

void turn(Draft& draft)
{
    for (auto& solid : draft.model.solids) {
        turn(draft.axes, solid.bounds);
        for (auto& face : solid.faces) {
            turn(draft.axes, face);
        }
    }
    for (CadContact& contact : draft.contacts) {
        contact.point = turned(draft.axes, contact.point);
        contact.direction = turned(draft.axes, contact.direction);
    }
}

bool along(const CadContact& contact, std::size_t axis)
{
    return std::abs(contact.direction[axis]) > 1 - parallel * parallel;
}

/// Whether a contact can be one of a slide (1) or of a revolute joint (0); none otherwise.
std::optional<bool> kind_of_joint(const Draft& draft, const CadContact& contact)
{
    if (contact.kind == CadContact::Kind::cylinder) {
        return along(contact, 2) ? std::optional(false) : std::nullopt;
    }
    const bool guides = of_roles(draft, contact, Role::slide, Role::frame) && std::abs(contact.direction[1]) < parallel;
    return guides ? std::optional(true) : std::nullopt;
}

bool belongs(const Draft& draft, const DraftJoint& joint, const CadContact& contact, bool slide)
{
    const std::size_t a = draft.body_of[contact.a];
    const std::size_t b = draft.body_of[contact.b];
    const bool same_bodies = (joint.body_a == a && joint.body_b == b) || (joint.body_a == b && joint.body_b == a);
    if (!same_bodies || joint.slide != slide) {
        return false;
    }
    constexpr double near = 1e-4;
    const Vec3 way = draft.contacts[joint.contacts.front()].point - contact.point;
    return slide || std::hypot(way[0], way[1]) < near;
}

void make_joints(Draft& draft)
{
    std::set<std::string> names;
    for (std::size_t i = 0; i < draft.contacts.size(); ++i) {
        const CadContact& contact = draft.contacts[i];
        const auto slide = kind_of_joint(draft, contact);
        if (!slide || draft.body_of[contact.a] == draft.body_of[contact.b]) {
            continue;
        }
        const auto known = std::ranges::find_if(
            draft.joints, [&](const DraftJoint& joint) { return belongs(draft, joint, contact, *slide); });
        if (known != draft.joints.end()) {
            known->contacts.push_back(i);
            continue;
        }
        DraftJoint joint{"", *slide, false, draft.body_of[contact.a], draft.body_of[contact.b], {i}};
        // The body that moves first, the ground second.
        if (joint.body_a == 0) {
            std::swap(joint.body_a, joint.body_b);
        }
        const std::string stem = fmt::format("{}_{}", draft.bodies[joint.body_a].name, draft.bodies[joint.body_b].name);
        joint.name = stem;
        for (int n = 2; !names.insert(joint.name).second; ++n) {
            joint.name = fmt::format("{}_{}", stem, n);
        }
        draft.joints.push_back(std::move(joint));
    }
}

/// Adds the pairs of rings that carry each other through balls or rollers.
void add_rolling(Draft& draft)
{
    CadModel rings;
    std::vector<std::size_t> index;
    for (std::size_t i = 0; i < draft.model.solids.size(); ++i) {
        if (is_ring(draft.model.solids[i].name)) {
            rings.solids.push_back(draft.model.solids[i]);
            index.push_back(i);
        }
    }
    const machine::CadReach across_rollers{.plane = -1, .into = 0, .cylinder = 0.5};
    std::map<std::pair<std::size_t, std::size_t>, CadContact> found;
    for (CadContact contact : machine::find_contacts(rings, across_rollers)) {
        contact.a = index[contact.a];
        contact.b = index[contact.b];
        auto& widest = found[{contact.a, contact.b}];
        const bool touches = std::ranges::any_of(draft.contacts, [&](const CadContact& other) {
            return std::minmax(contact.a, contact.b) == std::minmax(other.a, other.b);
        });
        if (!touches && draft.body_of[contact.a] != draft.body_of[contact.b] && contact.area > widest.area) {
            widest = contact;
        }
    }
    for (const auto& [pair, contact] : found) {
        if (contact.area > 0) {
            draft.rolling.insert(draft.contacts.size());
            draft.contacts.push_back(contact);
        }
    }
}

}  // namespace

Draft draft_of(CadModel model)
{
    Draft draft;
    draft.model = std::move(model);
    draft.contacts = machine::find_contacts(draft.model);
    make_bodies(draft, Roles(draft.model, draft.contacts));
    add_rolling(draft);
    draft.axes = axes_of(draft);
    turn(draft);
    make_joints(draft);
    for (DraftJoint& joint : draft.joints) {
        joint.rolling = std::ranges::all_of(joint.contacts, [&](std::size_t c) { return draft.rolling.contains(c); });
    }
    return draft;
}

}  // namespace deadpoint::study
