#include "deadpoint/full/draft/draft.hpp"

#include "deadpoint/core/names/pattern.hpp"
#include "deadpoint/error.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <map>
#include <numeric>
#include <set>

namespace deadpoint::full {
namespace {

using machine::CadContact;
using machine::CadModel;
constexpr double parallel = 1e-3;

/// The names of the wanted bodies by solid; empty where none wants it.
std::vector<std::string> wanted_names(const CadModel& model, const std::vector<WantedBody>& wanted)
{
    std::vector<std::string> names(model.solids.size());
    for (const WantedBody& body : wanted) {
        for (const std::string& pattern : body.solids) {
            bool found = false;
            for (std::size_t i = 0; i < names.size(); ++i) {
                if (!matches(pattern, model.solids[i].name) && !matches(pattern, model.solids[i].called)) {
                    continue;
                }
                found = true;
                if (!names[i].empty() && names[i] != body.name) {
                    throw InputError(fmt::format("--body: solid '{}' is in '{}' and in '{}'\n  help: name it once",
                                                 name_in_case(model.solids[i]), names[i], body.name));
                }
                names[i] = body.name;
            }
            if (!found) {
                std::vector<std::string> all;
                for (const auto& solid : model.solids) {
                    all.push_back(name_in_case(solid));
                }
                throw InputError(fmt::format("--body: no solid of the drawing is named '{}'\n  help: its solids are {}",
                                             pattern, fmt::join(all, ", ")));
            }
        }
    }
    return names;
}

/// Roles of all solids: by name, and for the others that of the neighbour with the largest contact.
class Roles {
public:
    Roles(const CadModel& model, const std::vector<CadContact>& contacts, const std::vector<WantedBody>& bodies)
        : wanted(wanted_names(model, bodies)), follows(model.solids.size())
    {
        std::iota(follows.begin(), follows.end(), std::size_t{0});
        for (std::size_t i = 0; i < follows.size(); ++i) {
            const auto& solid = model.solids[i];
            roles.push_back(role_of(wanted[i].empty() ? fmt::format("{} {}", solid.name, solid.called) : wanted[i]));
        }
        by_name = roles;
        // A neighbour may itself take its role from another.
        for (std::size_t round = 0; round < roles.size(); ++round) {
            spread(contacts);
        }
    }
    std::vector<std::string> wanted;  ///< names of the bodies that the user wants; empty: none
    std::vector<Role> roles;
    std::vector<Role> by_name;
    std::vector<std::size_t> follows;  ///< the solid that another one belongs to

private:
    void spread(const std::vector<CadContact>& contacts)
    {
        for (std::size_t i = 0; i < roles.size(); ++i) {
            if (roles[i] != Role::unknown || !wanted[i].empty()) {
                continue;
            }
            const CadContact* largest = nullptr;
            for (const CadContact& contact : contacts) {
                const bool holds = contact.kind != CadContact::Kind::sphere && (contact.a == i || contact.b == i);
                if (holds && (largest == nullptr || contact.area > largest->area)) {
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

/// Solids that belong together, by one of them each; a group has the name of one wanted body at most.
class SolidGroups {
public:
    explicit SolidGroups(std::vector<std::string> wanted) : parents_(wanted.size()), wanted_(std::move(wanted))
    {
        std::iota(parents_.begin(), parents_.end(), std::size_t{0});
    }
    /// Does nothing where two wanted bodies would become one.
    void unite(std::size_t i, std::size_t k)
    {
        const std::size_t one = root(parents_, i);
        const std::size_t other = root(parents_, k);
        if (one == other || (!wanted_[one].empty() && !wanted_[other].empty() && wanted_[one] != wanted_[other])) {
            return;
        }
        parents_[one] = other;
        wanted_[other] = wanted_[other].empty() ? wanted_[one] : wanted_[other];
    }
    std::vector<std::size_t> of_all()
    {
        std::vector<std::size_t> roots;
        for (std::size_t i = 0; i < parents_.size(); ++i) {
            roots.push_back(root(parents_, i));
        }
        return roots;
    }
    [[nodiscard]] const std::string& wanted_name(std::size_t group) const { return wanted_[group]; }

private:
    std::vector<std::size_t> parents_;
    std::vector<std::string> wanted_;
};

/// Wanted bodies; solids of one role that touch; and all of the frame.
SolidGroups groups_of(const Roles& roles, const std::vector<CadContact>& contacts)
{
    SolidGroups groups(roles.wanted);
    const std::size_t count = roles.roles.size();
    for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t k = 0; k < i; ++k) {
            if (!roles.wanted[i].empty() && roles.wanted[i] == roles.wanted[k]) {
                groups.unite(i, k);
            }
        }
    }
    for (const CadContact& contact : contacts) {
        const bool same = roles.roles[contact.a] == roles.roles[contact.b];
        const bool known = roles.roles[contact.a] != Role::unknown;
        const bool held = contact.kind != CadContact::Kind::sphere && same && known;
        if (held || roles.follows[contact.a] == contact.b || roles.follows[contact.b] == contact.a) {
            groups.unite(contact.a, contact.b);
        }
    }
    std::size_t frame = count;
    for (std::size_t i = 0; i < count; ++i) {
        if (roles.roles[i] == Role::frame) {
            frame = frame == count ? i : frame;
            groups.unite(i, frame);
        }
    }
    return groups;
}

/// The largest group of the frame; without a word for it, the largest of all.
std::size_t ground_of(const Draft& draft, const Roles& roles, const std::vector<std::size_t>& groups)
{
    const bool named = std::ranges::count(roles.roles, Role::frame) > 0;
    std::vector<double> volumes(groups.size(), 0.0);
    for (std::size_t i = 0; i < groups.size(); ++i) {
        volumes[groups[i]] += !named || roles.roles[i] == Role::frame ? draft.model.solids[i].volume : 0;
    }
    return static_cast<std::size_t>(std::ranges::max_element(volumes) - volumes.begin());
}

void make_bodies(Draft& draft, const Roles& roles)
{
    auto grouped = groups_of(roles, draft.contacts);
    const auto groups = grouped.of_all();
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
            std::ranges::any_of(body.solids, [&](std::size_t i) { return roles.by_name[i] != Role::unknown; }) ||
            !grouped.wanted_name(group).empty();
        const std::string stem = !grouped.wanted_name(group).empty() ? grouped.wanted_name(group)
                                 : body.role == Role::unknown        ? draft.model.solids[body.solids.front()].name
                                                                     : name_of(body.role);
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
    // The axis z runs along the crankshaft in the positive direction of the drawing.
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
    } else if (auto* sphere = std::get_if<machine::CadSphere>(&face.form)) {
        sphere->centre = turned(axes, sphere->centre);
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

using JointKind = DraftJoint::Kind;

/// The kind of joint that a contact can be, if any.
std::optional<JointKind> kind_of_joint(const Draft& draft, const CadContact& contact)
{
    switch (contact.kind) {
    case CadContact::Kind::cylinder:
        return along(contact, 2) ? std::optional(JointKind::revolute) : std::nullopt;
    case CadContact::Kind::sphere:
        return JointKind::ball;
    case CadContact::Kind::plane:
        break;
    }
    const bool guides = of_roles(draft, contact, Role::slide, Role::frame) && std::abs(contact.direction[1]) < parallel;
    return guides ? std::optional(JointKind::slide) : std::nullopt;
}

bool belongs(const Draft& draft, const DraftJoint& joint, const CadContact& contact, JointKind kind)
{
    const std::size_t a = draft.body_of[contact.a];
    const std::size_t b = draft.body_of[contact.b];
    const bool same_bodies = (joint.body_a == a && joint.body_b == b) || (joint.body_a == b && joint.body_b == a);
    if (!same_bodies || joint.kind != kind) {
        return false;
    }
    constexpr double near = 1e-4;
    const Vec3 way = draft.contacts[joint.contacts.front()].point - contact.point;
    return kind == JointKind::slide || std::hypot(way[0], way[1]) < near;
}

void make_joints(Draft& draft)
{
    std::set<std::string> names;
    for (std::size_t i = 0; i < draft.contacts.size(); ++i) {
        const CadContact& contact = draft.contacts[i];
        const auto kind = kind_of_joint(draft, contact);
        if (!kind || draft.body_of[contact.a] == draft.body_of[contact.b]) {
            continue;
        }
        const auto known = std::ranges::find_if(
            draft.joints, [&](const DraftJoint& joint) { return belongs(draft, joint, contact, *kind); });
        if (known != draft.joints.end()) {
            known->contacts.push_back(i);
            continue;
        }
        DraftJoint joint{"", *kind, false, draft.body_of[contact.a], draft.body_of[contact.b], {i}};
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

/// What would be of a joint if it were drawn a little nearer, or thinner.
std::vector<CadContact> near_misses(const Draft& draft)
{
    const machine::CadReach farther{.plane = 3e-3, .into = 1e-3, .cylinder = 0.03, .axes = 2e-3};
    std::vector<CadContact> misses = machine::find_contacts(draft.model, farther);
    std::erase_if(misses, [&](const CadContact& miss) {
        return draft.body_of[miss.a] == draft.body_of[miss.b] || !kind_of_joint(draft, miss) ||
               std::ranges::any_of(draft.contacts, [&](const CadContact& known) {
                   return std::minmax(known.a, known.b) == std::minmax(miss.a, miss.b);
               });
    });
    return misses;
}

}  // namespace

Draft draft_of(CadModel model, const std::vector<WantedBody>& wanted)
{
    Draft draft;
    draft.model = std::move(model);
    draft.contacts = machine::find_contacts(draft.model);
    make_bodies(draft, Roles(draft.model, draft.contacts, wanted));
    add_rolling(draft);
    draft.axes = axes_of(draft);
    turn(draft);
    make_joints(draft);
    for (DraftJoint& joint : draft.joints) {
        joint.rolling = std::ranges::all_of(joint.contacts, [&](std::size_t c) { return draft.rolling.contains(c); });
    }
    draft.near_misses = near_misses(draft);
    return draft;
}

}  // namespace deadpoint::full
