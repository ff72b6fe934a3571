#include "deadpoint/study/pipeline/body_masses.hpp"

#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/core/mistakes.hpp"
#include "deadpoint/exchange/machine.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>

namespace deadpoint::study {
namespace {

// Integrals of density times {1, x, y, x^2 + y^2}.
struct Moments {
    double mass = 0;
    Vec2 first{};
    double second = 0;
    void add(double mass_here, const Vec3& at)
    {
        mass += mass_here;
        first = first + mass_here * Vec2{at[0], at[1]};
        second += mass_here * (at[0] * at[0] + at[1] * at[1]);
    }
};

Vec3 combine(const Machine& machine, const Cell& cell, const std::array<double, 8>& weights, int count)
{
    Vec3 sum{};
    for (int i = 0; i < count; ++i)
        sum = sum + weights[static_cast<std::size_t>(i)] * machine.nodes[cell.nodes[static_cast<std::size_t>(i)]];
    return sum;
}

// Four points that integrate polynomials of second degree over a tetrahedron exactly (Keast, 1986).
void add_tetrahedron(const Machine& machine, const Cell& cell, double density, Moments& moments)
{
    const auto& x = machine.nodes;
    const Vec3 &o = x[cell.nodes[0]], a = x[cell.nodes[1]] - o, b = x[cell.nodes[2]] - o, c = x[cell.nodes[3]] - o;
    const double volume = std::abs(dot(a, cross(b, c))) / 6;
    constexpr double near = 0.5854101966249685, far = 0.1381966011250105;
    for (std::size_t i = 0; i < 4; ++i) {
        std::array<double, 8> weights{far, far, far, far};
        weights[i] = near;
        moments.add(density * volume / 4, combine(machine, cell, weights, 4));
    }
}

// Gauss's rule with three points each way: the integrand is of fourth degree at most in each local coordinate.
void add_hexahedron(const Machine& machine, const Cell& cell, double density, Moments& moments)
{
    constexpr std::array<double, 3> places{-0.7745966692414834, 0, 0.7745966692414834};
    constexpr std::array<double, 3> weights{5.0 / 9, 8.0 / 9, 5.0 / 9};
    constexpr std::array<std::array<double, 3>, 8> corners{
        {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1}, {-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}}};
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
            for (std::size_t k = 0; k < 3; ++k) {
                const std::array<double, 3> r{places[i], places[j], places[k]};
                std::array<double, 8> shape{};
                std::array<std::array<double, 8>, 3> slope{};
                for (std::size_t n = 0; n < 8; ++n) {
                    std::array<double, 3> factor{};
                    for (std::size_t d = 0; d < 3; ++d)
                        factor[d] = 0.5 * (1 + corners[n][d] * r[d]);
                    shape[n] = factor[0] * factor[1] * factor[2];
                    for (std::size_t d = 0; d < 3; ++d)
                        slope[d][n] = 0.5 * corners[n][d] * factor[(d + 1) % 3] * factor[(d + 2) % 3];
                }
                const Vec3 a = combine(machine, cell, slope[0], 8), b = combine(machine, cell, slope[1], 8),
                           c = combine(machine, cell, slope[2], 8);
                moments.add(density * weights[i] * weights[j] * weights[k] * dot(a, cross(b, c)),
                            combine(machine, cell, shape, 8));
            }
}

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
    Moments moments;
    for (const auto& part : machine.parts) {
        if (part.body != body)
            continue;
        const double density = input.materials.at(input.parts.at(part.name).material).density;
        for (std::uint32_t c = part.first_cell; c < part.first_cell + part.cell_count; ++c) {
            const auto& cell = machine.cells[c];
            if (cell.kind == CellKind::tetrahedron)
                add_tetrahedron(machine, cell, density, moments);
            else
                add_hexahedron(machine, cell, density, moments);
        }
    }
    if (!(moments.mass > 0))
        return {};
    if (machine.half_model && !input.bodies.at(body).mirror) {
        moments.mass *= 2;
        moments.first = {0, 2 * moments.first[1]};
        moments.second *= 2;
    }
    const Vec2 centre = (1 / moments.mass) * moments.first;
    return {moments.mass, centre, moments.second - moments.mass * dot(centre, centre)};
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

}  // namespace deadpoint::study
