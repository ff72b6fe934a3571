#include "deadpoint/mechanism/mirror.hpp"

#include "deadpoint/error.hpp"
#include "deadpoint/exchange/cycle.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace deadpoint::mechanism {
namespace {

Vec2 reflected(const Vec2& v) { return {-v[0], v[1]}; }

bool is_slide(const LinkageJoint& joint) { return joint.kind == LinkageJoint::Kind::slide; }

void check(const Linkage& half, const std::vector<bool>& twice)
{
    if (twice.size() != half.bodies.size())
        throw InputError(
            fmt::format("mirror: {} bodies, but {} marks whether they exist twice", half.bodies.size(), twice.size()));
    const auto refuse = [&](int body, const char* role) {
        if (twice.at(body))
            throw InputError(fmt::format("mirror: '{}' is {} and cannot exist twice\n  help: give both halves in full",
                                         half.bodies[body], role));
    };
    refuse(half.ground, "the ground");
    refuse(half.slide_body, "the slide that carries the tool");
    const LinkageJoint& driver = half.joints.at(half.driver);
    refuse(driver.body_a, "the driven body");
    refuse(driver.body_b, "the driven body");
}

/// The single body of a pair of pins off the plane, else -1: it is then held in rotation by both halves.
int held_body(const LinkageJoint& joint, const std::vector<bool>& twice)
{
    const bool pair = twice[joint.body_a] != twice[joint.body_b];
    if (!pair || is_slide(joint) || !(std::abs(joint.centre[0]) > 1e-9))
        return -1;
    return twice[joint.body_a] ? joint.body_b : joint.body_a;
}

void free_held_slides(MirroredLinkage& full, const Linkage& half, const std::vector<bool>& twice)
{
    std::vector<bool> held(half.bodies.size(), false);
    for (const LinkageJoint& joint : half.joints) {
        const int body = held_body(joint, twice);
        if (body >= 0 && body != half.ground)
            held[body] = true;
    }
    for (std::size_t j = 0; j < half.joints.size(); ++j) {
        LinkageJoint& joint = full.linkage.joints[j];
        if (is_slide(joint) && joint.guides_rotation && (held[joint.body_a] || held[joint.body_b]) &&
            !twice[joint.body_a] && !twice[joint.body_b]) {
            joint.guides_rotation = false;
            full.freed.push_back(static_cast<int>(j));
        }
    }
}

}  // namespace

MirroredLinkage mirrored(const Linkage& half, const std::vector<bool>& exists_twice)
{
    check(half, exists_twice);
    MirroredLinkage full;
    full.linkage = half;
    std::vector<int> image(half.bodies.size());
    for (int body = 0; body < static_cast<int>(half.bodies.size()); ++body) {
        full.bodies.push_back({body, false});
        image[body] = body;
    }
    for (int body = 0; body < static_cast<int>(half.bodies.size()); ++body) {
        if (!exists_twice[body])
            continue;
        const std::string name = half.bodies[body] + "'";
        if (std::find(half.bodies.begin(), half.bodies.end(), name) != half.bodies.end())
            throw InputError(
                fmt::format("mirror: the name \"{}\" of the image of '{}' is taken\n  help: rename that body", name,
                            half.bodies[body]));
        image[body] = static_cast<int>(full.linkage.bodies.size());
        full.linkage.bodies.push_back(name);
        full.bodies.push_back({body, true});
    }
    for (int j = 0; j < static_cast<int>(half.joints.size()); ++j)
        full.joints.push_back({j, false});
    for (int j = 0; j < static_cast<int>(half.joints.size()); ++j) {
        LinkageJoint joint = half.joints[j];
        if (!exists_twice[joint.body_a] && !exists_twice[joint.body_b])
            continue;
        joint.name += "'";
        joint.body_a = image[joint.body_a];
        joint.body_b = image[joint.body_b];
        joint.centre = reflected(joint.centre);
        joint.direction = reflected(joint.direction);
        full.linkage.joints.push_back(joint);
        full.joints.push_back({j, true});
    }
    free_held_slides(full, half, exists_twice);
    return full;
}

std::vector<BodyMass> mirrored(const std::vector<BodyMass>& masses, const MirroredLinkage& full)
{
    std::vector<BodyMass> result;
    for (const MirrorOrigin& origin : full.bodies) {
        BodyMass mass = masses.at(origin.original);
        if (origin.image)
            mass.centre = reflected(mass.centre);
        result.push_back(mass);
    }
    return result;
}

}  // namespace deadpoint::mechanism
