#include "deadpoint/drift/chain.hpp"

#include "deadpoint/core/mistakes.hpp"
#include "deadpoint/drift/contact_side.hpp"
#include "deadpoint/exchange/face_points.hpp"
#include "deadpoint/exchange/linkage.hpp"

#include <Eigen/Dense>
#include <cmath>

namespace deadpoint::drift {
namespace {

CentreFunctionals mean_centre(const Machine& machine, const std::vector<ContactSide>& sides, const Vec2& centre)
{
    CentreFunctionals result;
    for (const auto& side : sides) {
        const auto fit = fit_circle(machine, side, centre);
        add(result[0], 1.0 / static_cast<double>(sides.size()), fit.x);
        add(result[1], 1.0 / static_cast<double>(sides.size()), fit.y);
    }
    return result;
}

CentreFunctionals mean_across(const Machine& machine, const std::vector<ContactSide>& sides, const Vec2& across)
{
    CentreFunctionals result;
    double area = 0;
    for (const auto& side : sides) {
        if (machine.half_model && machine.parts[machine.interfaces[side.contact].part_a].cut)
            return {};
        if (machine.half_model && machine.parts[machine.interfaces[side.contact].part_b].cut)
            return {};
        for (const auto& p : points_of(machine, side)) {
            if (std::abs(p.normal[0] * across[0] + p.normal[1] * across[1]) < 0.5)
                continue;
            area += p.weight;
            for (int c = 0; c < 2; ++c)
                result[c].points.push_back({p.face, p.position, across[c] * p.weight * Vec3{across[0], across[1], 0}});
        }
    }
    for (auto& component : result)
        for (auto& point : component.points)
            point.weight = (1 / area) * point.weight;
    return result;
}

}  // namespace

std::vector<SurfacePoint> points_of(const Machine& machine, const ContactSide& side)
{
    std::vector<SurfacePoint> points;
    for (const auto& p : machine.interfaces[side.contact].points_as_drawn())
        points.push_back(
            {side.side_b ? p.face_b : p.face_a, side.side_b ? p.position_b : p.position_a, p.weight, p.normal});
    return points;
}

const MeshPart& part_of(const Machine& machine, const ContactSide& side)
{
    const auto& contact = machine.interfaces[side.contact];
    return machine.parts[side.side_b ? contact.part_b : contact.part_a];
}

bool on_symmetry_plane(const Machine& machine, const ContactSide& side, const Vec2& centre)
{
    return machine.half_model && part_of(machine, side).cut && std::abs(centre[0]) < 1e-9;
}

Vec3 stroke_of(const Linkage& linkage)
{
    const Vec2 stroke = (1 / norm(linkage.stroke_direction)) * linkage.stroke_direction;
    return {stroke[0], stroke[1], 0};
}

Vec3 right_of(const Linkage& linkage)
{
    const Vec3 stroke = stroke_of(linkage);
    return {stroke[1], -stroke[0], 0};
}

Functional mean_along(const Machine& machine, int surface, const Vec3& direction)
{
    Functional result;
    double area = 0;
    for (const auto& entry : machine.surfaces[surface].faces)
        for (const auto& point : face_points(machine, machine.faces[entry.face])) {
            const double weight = point.weight * entry.fraction;
            result.points.push_back({entry.face, point.position, weight * direction});
            area += weight;
        }
    for (auto& point : result.points)
        point.weight = (1 / area) * point.weight;
    return result;
}

Functional contact_growth(const Machine& machine, int contact, const Vec2& centre)
{
    const auto fit_a = fit_circle(machine, {contact, false}, centre);
    const auto fit_b = fit_circle(machine, {contact, true}, centre);
    const auto* cylinder = std::get_if<CylinderGeometry>(&machine.interfaces[contact].geometry);
    if (!cylinder)
        throw mistake(
            interface_path(machine.interfaces[contact].name),
            "interface '" + machine.interfaces[contact].name +
                "' is not cylindrical, so it has no clearance; if it is marked as seat or journal, unmark it");
    Functional result;
    add(result, cylinder->bore ? 1 : -1, fit_a.growth);
    add(result, cylinder->bore ? -1 : 1, fit_b.growth);
    return result;
}

void add(Functional& a, double factor, const Functional& b)
{
    for (const auto& point : b.points)
        a.points.push_back({point.face, point.position, factor * point.weight});
}

CircleFit fit_circle(const Machine& machine, const ContactSide& side, const Vec2& centre)
{
    const bool symmetric = on_symmetry_plane(machine, side, centre);
    const auto* cylinder = std::get_if<CylinderGeometry>(&machine.interfaces[side.contact].geometry);
    if (!cylinder)
        throw mistake(interface_path(machine.interfaces[side.contact].name),
                      "interface '" + machine.interfaces[side.contact].name +
                          "' of a revolute joint is not cylindrical, so its centre cannot be fitted");
    const double radius = cylinder->radius;
    Eigen::Matrix3d normal_matrix = Eigen::Matrix3d::Zero();
    const auto points = points_of(machine, side);
    const auto shape = [&](const SurfacePoint& p) {
        const double x = p.position[0] - centre[0], y = p.position[1] - centre[1];
        const double r = std::hypot(x, y);
        return Eigen::Vector3d(symmetric ? 0 : x / r, y / r, r / radius);
    };
    for (const auto& p : points)
        normal_matrix += p.weight * shape(p) * shape(p).transpose();
    if (symmetric)
        normal_matrix(0, 0) = 1;
    const Eigen::LDLT<Eigen::Matrix3d> solver(normal_matrix);
    if (solver.rcond() < 1e-8)
        throw mistake(interface_path(machine.interfaces[side.contact].name),
                      "the centre of interface '" + machine.interfaces[side.contact].name +
                          "' cannot be fitted: too little of the circle is in contact");
    CircleFit fit;
    for (const auto& p : points) {
        const Eigen::Vector3d coefficient = p.weight * solver.solve(shape(p));
        const double x = p.position[0] - centre[0], y = p.position[1] - centre[1];
        const double r = std::hypot(x, y);
        const Vec3 radial{x / r, y / r, 0};
        if (!symmetric)
            fit.x.points.push_back({p.face, p.position, coefficient[0] * radial});
        fit.y.points.push_back({p.face, p.position, coefficient[1] * radial});
        fit.growth.points.push_back({p.face, p.position, coefficient[2] * radial});
    }
    return fit;
}

JointCentres joint_centres(const Machine& machine, const Linkage& linkage,
                           const BottomDeadPointSensitivity& sensitivity, int joint, const JointSurfaces& surfaces)
{
    const auto& description = linkage.joints[joint];
    if (description.kind == LinkageJoint::Kind::slide) {
        const Vec2 across{-description.direction[1], description.direction[0]};
        return {mean_across(machine, surfaces.in_a, across), mean_across(machine, surfaces.in_b, across)};
    }
    const Vec2 centre = sensitivity.joint_centres[joint];
    return {mean_centre(machine, surfaces.in_a, centre), mean_centre(machine, surfaces.in_b, centre)};
}

double travel_by_play(const Linkage& linkage, const BottomDeadPointSensitivity& sensitivity,
                      const ChainDescription& chain)
{
    // On the ground's side, the crank's centre is offset from the seat's centre by the clearance.
    const bool ground_is_b = linkage.joints[chain.crank_joint].body_b == linkage.ground;
    return (ground_is_b ? 1 : -1) * dot(sensitivity.weight[chain.crank_joint], chain.pressed);
}

std::vector<Functional> chain_functionals(const Machine& machine, const Linkage& linkage,
                                          const BottomDeadPointSensitivity& sensitivity, const ChainDescription& chain)
{
    std::vector<Functional> result(dimension_count);
    const Vec2 crank_centre = sensitivity.joint_centres[chain.crank_joint];
    const Vec3 stroke = stroke_of(linkage);
    const auto seats = mean_centre(machine, chain.seats, crank_centre);
    for (std::size_t c = 0; c < 2; ++c)
        if (stroke[c] != 0)
            add(result[bearing_to_ground], stroke[c], seats[c]);
    result[table_to_ground] = mean_along(machine, chain.table_surface, stroke);

    auto& height = result[slide_height];
    add(height, 1, mean_along(machine, chain.slide_surface, stroke));
    for (int j = 0; j < static_cast<int>(linkage.joints.size()); ++j) {
        const auto centres = joint_centres(machine, linkage, sensitivity, j, chain.joints[j]);
        for (int c = 0; c < 2; ++c) {
            add(height, sensitivity.weight[j][c], centres.in_b[c]);
            add(height, -sensitivity.weight[j][c], centres.in_a[c]);
        }
    }
    add(result[gap], 1, height);
    add(result[gap], -1, result[table_to_ground]);
    const std::array<const char*, dimension_count> names{"E_BG", "E_WG", "slide height", "gap"};
    for (int d = 0; d < dimension_count; ++d)
        result[d].name = names[d];
    for (const auto& bearing : chain.bearings) {
        Functional growth{"growth of a crank bearing's play", {}};
        for (const int contact : bearing)
            add(growth, 1, contact_growth(machine, contact, crank_centre));
        result.push_back(std::move(growth));
    }
    return result;
}

}  // namespace deadpoint::drift
