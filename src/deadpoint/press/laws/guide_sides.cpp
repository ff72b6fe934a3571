#include "deadpoint/press/laws/guide_sides.hpp"

#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/exchange/cycle.hpp"
#include "deadpoint/exchange/linkage.hpp"
#include "deadpoint/exchange/machine.hpp"
#include "deadpoint/press/result/loads_result.hpp"
#include "deadpoint/press/translate/loads.hpp"
#include "deadpoint/tribology/friction/duty.hpp"

#include <algorithm>
#include <cmath>

namespace deadpoint::press {
namespace {

constexpr double least_push = 0.1;  // of a face's normal across the travel; below it the face holds along z or x

Vec2 across(const Vec2& travel, double angle)
{
    const Vec2 d = (1 / norm(travel)) * travel;
    const double c = std::cos(angle), s = std::sin(angle);
    return {s * d[0] + c * d[1], -(c * d[0] - s * d[1])};
}

/// Side of an interface: the sign of its push on body_a across the travel.
int side_of(const Machine& machine, const Contact& contact, const std::string& body_a, const Vec2& t)
{
    const auto* plane = std::get_if<PlaneGeometry>(&contact.geometry);
    if (plane == nullptr)
        return 0;
    // The normal points out of side a, which is on either body.
    const double out = plane->normal[0] * t[0] + plane->normal[1] * t[1];
    const double push = machine.parts[contact.part_a].body == body_a ? -out : out;
    return push > least_push ? 1 : push < -least_push ? -1 : 0;
}

bool has_image(const casefile::Case& input, const casefile::Joint& joint)
{
    return input.machine.half_model ||
           std::ranges::any_of(joint.bodies, [&](const std::string& body) { return input.bodies.at(body).mirror; });
}

void add_loads(GuideSides& sides, const LoadsResult& loads, std::size_t index, const tribology::GuideFaces& faces)
{
    const auto& joint = loads.linkage.joints[index];
    const auto& cycle = loads.history.joints[index];
    const auto duty = tribology::duty_of(loads.history, cycle);
    const auto& pose_b = loads.history.bodies[static_cast<std::size_t>(joint.body_b)].pose;
    double plus = 0, both = 0;
    for (std::size_t i = 0; i < duty.weight.size(); ++i) {
        const double force = dot(cycle.force[i], across(joint.direction, pose_b[i].angle));
        const auto at = tribology::guide_side_forces(faces, force, cycle.moment[i]);
        sides.load_plus += duty.weight[i] * at.plus;
        sides.load_minus += duty.weight[i] * at.minus;
        plus += duty.weight[i] * at.plus * duty.speed[i];
        both += duty.weight[i] * (at.plus + at.minus) * duty.speed[i];
    }
    sides.heat_plus = both > 0 ? plus / both : 0.5;
}

}  // namespace

std::optional<GuideSides> guide_sides(const casefile::Case& input, const Machine& machine, const LoadsResult& loads,
                                      const std::string& joint, std::size_t first)
{
    const auto& stated = input.joints.at(joint);
    const auto found = std::ranges::find(loads.linkage.joints, joint, &LinkageJoint::name);
    if (stated.kind != casefile::Joint::Kind::slide || found == loads.linkage.joints.end() || has_image(input, stated))
        return {};
    const Vec2 t = across(found->direction, 0);
    GuideSides sides;
    for (std::size_t i = 0; i < stated.interfaces.size(); ++i)
        sides.of_interface.push_back(side_of(machine, machine.interfaces[first + i],
                                             loads.linkage.bodies[static_cast<std::size_t>(found->body_a)], t));
    if (std::ranges::count(sides.of_interface, 1) == 0 || std::ranges::count(sides.of_interface, -1) == 0)
        return {};
    add_loads(sides, loads, static_cast<std::size_t>(found - loads.linkage.joints.begin()), describe_guide(stated));
    return sides;
}

std::vector<double> side_factors(const casefile::Case& input, const Machine& machine, const GuideSides& sides,
                                 const std::string& joint, std::size_t first, double part)
{
    const auto& interfaces = input.joints.at(joint).interfaces;
    double plus = 0, minus = 0;
    for (std::size_t i = 0; i < interfaces.size(); ++i) {
        const double area = interfaces[i].heat_share * machine.interfaces[first + i].area;
        plus += sides.of_interface[i] > 0 ? area : 0;
        minus += sides.of_interface[i] < 0 ? area : 0;
    }
    std::vector<double> factors(interfaces.size(), 1.0);
    if (!(plus > 0 && minus > 0))
        return factors;
    for (std::size_t i = 0; i < interfaces.size(); ++i)
        if (const int side = sides.of_interface[i]; side != 0)
            factors[i] += part * (sides.heat(side) * (plus + minus) / (side > 0 ? plus : minus) - 1);
    return factors;
}

}  // namespace deadpoint::press
