#include "deadpoint/press/check/plausibility.hpp"

#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/casefile/describe/findings.hpp"
#include "deadpoint/exchange/machine.hpp"
#include "deadpoint/press/check/whole_mass.hpp"
#include "deadpoint/press/result/loads_result.hpp"
#include "deadpoint/press/result/run_result.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <limits>
#include <numbers>
#include <optional>
#include <set>
#include <string>
#include <utility>

namespace deadpoint::press {
namespace {

using casefile::Case;
using casefile::Finding;

constexpr std::size_t most_named = 5;

Finding question(std::string path, std::string message, std::string help)
{
    return {"implausible", std::move(path), std::move(message), std::move(help), true};
}

std::string list(const std::vector<std::string>& names)
{
    const std::vector<std::string> shown(
        names.begin(), names.begin() + static_cast<std::ptrdiff_t>(std::min(names.size(), most_named)));
    return fmt::format("{}{}", fmt::join(shown, ", "),
                       names.size() > most_named ? fmt::format(" and {} more", names.size() - most_named) : "");
}

/// Lengths of a part along the axes, ascending [m].
std::array<double, 3> extents(const Machine& machine, const MeshPart& part)
{
    constexpr double infinite = std::numeric_limits<double>::infinity();
    Vec3 low{infinite, infinite, infinite}, high{-infinite, -infinite, -infinite};
    for (std::uint32_t c = part.first_cell; c < part.first_cell + part.cell_count; ++c) {
        const Cell& cell = machine.cells[c];
        for (int i = 0; i < (cell.kind == CellKind::hexahedron ? 8 : 4); ++i)
            for (int k = 0; k < 3; ++k) {
                low[k] = std::min(low[k], machine.nodes[cell.nodes[i]][k]);
                high[k] = std::max(high[k], machine.nodes[cell.nodes[i]][k]);
            }
    }
    std::array<double, 3> lengths{high[0] - low[0], high[1] - low[1], high[2] - low[2]};
    std::ranges::sort(lengths);
    return lengths;
}

/// A mass with four digits: 12340 kg.
std::string kilograms(double mass) { return fmt::format("{} kg", std::stod(fmt::format("{:.4g}", mass))); }

void question_masses(const Case& input, const Machine& machine, std::vector<Finding>& found)
{
    constexpr double tolerance = 0.02;
    for (const auto& mass : whole_masses(input, machine)) {
        const auto deviation = mass.deviation();
        if (deviation && std::abs(*deviation) > tolerance)
            found.push_back({"mass", fmt::format("bodies.{}.mass", mass.body),
                             fmt::format("body '{}' has {} by its parts, but {} are stated ({:+.1f} %)", mass.body,
                                         kilograms(mass.computed), kilograms(*mass.stated), 100 * *deviation),
                             "correct the mass, or the shapes and materials of its parts", true});
    }
}

void question_neighbours(const Machine& machine, std::vector<Finding>& found)
{
    for (const auto& overlap : machine.overlaps)
        found.push_back({"overlap", "parts." + overlap.part_b,
                         fmt::format("parts '{}' and '{}' overlap by {:.3g} mm near ({:.1f}, {:.1f}, {:.1f}) mm",
                                     overlap.part_a, overlap.part_b, 1e3 * overlap.depth, 1e3 * overlap.where[0],
                                     1e3 * overlap.where[1], 1e3 * overlap.where[2]),
                         "let their faces lie on each other there: move one of them, or change its size or bore",
                         true});
    for (const auto& part : machine.floating_parts)
        found.push_back(
            {"floating", "parts." + part,
             fmt::format("part '{}' is not connected: no bond and no interface joins it to another part", part),
             "let it touch a part of its body, or name it in an interface of a joint", true});
}

// A cell may be as thick as a plate, but not wider than the part is in its second direction.
std::optional<Finding> coarse_parts(const Case& input, const Machine& machine, double size_scale)
{
    std::vector<std::string> texts;
    for (const auto& part : machine.parts) {
        const auto found = input.parts.find(part.name);
        if (found == input.parts.end() || !found->second.mesh.empty())
            continue;
        const double size = size_scale * found->second.size.value_or(input.numerics.size);
        const auto lengths = extents(machine, part);
        if (size > lengths[1])
            texts.push_back(fmt::format("{} (cells of {:.4g} mm in {:.4g} x {:.4g} x {:.4g} mm)", part.name, 1e3 * size,
                                        1e3 * lengths[2], 1e3 * lengths[1], 1e3 * lengths[0]));
    }
    if (texts.empty())
        return std::nullopt;
    return question("numerics.size",
                    fmt::format("the cells are larger than the parts they divide, which are then too stiff and warm "
                                "evenly: {}",
                                list(texts)),
                    "lower numerics.size, the `size` of these parts, or --size");
}

std::optional<Finding> bare_parts(const Case& input, const Machine& machine)
{
    constexpr double least_share = 0.01;
    const bool any = std::ranges::any_of(input.surfaces, [](const auto& s) { return s.second.film.has_value(); });
    if (!any)
        return std::nullopt;
    std::set<std::uint32_t> claimed;
    double whole = 0, bare = 0;
    for (const auto& surface : machine.surfaces)
        if (const auto found = input.surfaces.find(surface.name);
            found != input.surfaces.end() && has_condition(found->second))
            for (const auto& share : surface.figures.parts)
                claimed.insert(share.part);
    std::vector<std::string> names;
    for (std::uint32_t p = 0; p < machine.parts.size(); ++p) {
        whole += machine.parts[p].exposed_area;
        if (!claimed.contains(p) && machine.parts[p].exposed_area > 0) {
            names.push_back(machine.parts[p].name);
            bare += machine.parts[p].exposed_area;
        }
    }
    if (!(bare > least_share * whole))
        return std::nullopt;
    return question("surfaces",
                    fmt::format("no surface claims the faces of {}: {:.3g} m2, {:.2g} % of all faces in air, pass no "
                                "heat",
                                list(names), bare, 100 * bare / whole),
                    "name these parts in a surface with a film, or in one with insulated = true");
}

/// The facet of side a that is farthest off its cylinder, as a share of the radius.
struct FarFacet {
    double off = 0;     ///< [m]
    double radius = 0;  ///< [m]; 0: the contact has no cylinder
};

double off_cylinder(const CylinderGeometry& cylinder, const Vec3& position)
{
    const Vec3 arm = position - cylinder.point;
    return std::abs(norm(arm - dot(arm, cylinder.axis) * cylinder.axis) - cylinder.radius);
}

/// A bond may lie on planes beside its cylinders: a pin in a blind hole.
FarFacet farthest_facet(const Machine& machine, const Contact& contact)
{
    FarFacet worst;
    for (const auto& point : contact.points_as_drawn()) {
        const auto& geometry = machine.geometries[machine.faces[point.face_a].geometry];
        const auto* cylinder = std::get_if<CylinderGeometry>(&geometry);
        if (cylinder == nullptr)
            continue;
        const FarFacet own{off_cylinder(*cylinder, point.position_a), cylinder->radius};
        if (worst.radius == 0 || own.off * worst.radius > worst.off * own.radius)
            worst = own;
    }
    return worst;
}

// Contact areas are those of the cylinders, and points meet by their angle; what lies between facets is not there.
std::optional<Finding> faceted_contacts(const Machine& machine)
{
    constexpr double most = 0.05;  // of the radius: ten cells around
    std::vector<std::string> texts;
    for (const auto* contacts : {&machine.interfaces, &machine.bonds})
        for (const Contact& contact : *contacts)
            if (const auto [off, radius] = farthest_facet(machine, contact); off > most * radius)
                texts.push_back(fmt::format("{} (facets {:.3g} mm off its cylinder of {:.4g} mm)", contact.name,
                                            1e3 * off, 2e3 * radius));
    if (texts.empty())
        return std::nullopt;
    return question("numerics.size",
                    fmt::format("so few cells lie around these contacts that bores are too wide or pins too thin: {}. "
                                "Areas in contact are corrected, volumes and ways of the heat are not",
                                list(texts)),
                    "lower the `size` of these parts, or `smallest_cell` of parts from a STEP file, or --size");
}

/// Whether body a turns all around body b in the turn.
bool turns(const LoadsResult& loads, const LinkageJoint& joint)
{
    const auto& a = loads.history.bodies[static_cast<std::size_t>(joint.body_a)].pose;
    const auto& b = loads.history.bodies[static_cast<std::size_t>(joint.body_b)].pose;
    return std::abs((a.back().angle - b.back().angle) - (a.front().angle - b.front().angle)) > std::numbers::pi;
}

void question_turns(const Case& input, const LoadsResult& loads, std::vector<Finding>& found)
{
    for (std::size_t j = 0; j < loads.linkage.joints.size(); ++j) {
        const auto& joint = loads.linkage.joints[j];
        const auto stated = input.joints.find(joint.name);
        if (loads.images[j] || stated == input.joints.end() || stated->second.interfaces.empty() ||
            joint.kind != LinkageJoint::Kind::revolute)
            continue;
        const auto path = "joints." + joint.name;
        if (turns(loads, joint) && !stated->second.turns_fully)
            found.push_back(question(path,
                                     "the joint makes full turns, but its sides touch as drawn: heat passes where they "
                                     "meet at bottom dead point only",
                                     "add turns_fully = true"));
        if (!turns(loads, joint) && stated->second.turns_fully)
            found.push_back(question(path + ".turns_fully", "the joint only swings, it makes no full turn",
                                     "remove turns_fully = true"));
    }
}

double peak(const JointCycle& cycle)
{
    double largest = 0;
    for (const auto& force : cycle.force)
        largest = std::max(largest, norm(force));
    return largest;
}

/// @return whether the force is questioned
bool question_force(const LoadsResult& loads, std::vector<Finding>& found)
{
    constexpr double gravity = 9.81;
    const double weight = gravity * loads.masses[static_cast<std::size_t>(loads.linkage.slide_body)].mass;
    if (loads.force == 0 || loads.force >= weight)
        return false;
    found.push_back(question(fmt::format("operation.{}.force", loads.segment),
                             fmt::format("the process force of {:.4g} kN is less than the weight of the slide, "
                                         "{:.4g} kN",
                                         loads.force / 1e3, weight / 1e3),
                             "check the unit: N, kN or MN"));
    return true;
}

/// Sum of the areas of a joint's contacts around its axis over pi, that is of diameters times lengths [m2].
double projected_area(const Case& input, const Machine& machine, const std::string& joint)
{
    double area = 0;
    const auto& interfaces = input.joints.at(joint).interfaces;
    std::set<double> widest;
    for (const auto& interface : interfaces)
        if (interface.diameter)
            widest.insert(*interface.diameter);
    for (const auto& contact : machine.interfaces)
        if (contact.name.starts_with(joint + ".") && std::holds_alternative<CylinderGeometry>(contact.geometry))
            area += contact.drawn_area / std::numbers::pi;
    // Rings lie around each other: each carries the whole force.
    return (machine.half_model ? 2 : 1) * area / static_cast<double>(std::max<std::size_t>(1, widest.size()));
}

// Bushes carry up to 100 MPa on diameter times length, rolling bearings less; hardened steel yields at 2000 MPa.
void question_pressure(const Case& input, const Machine& machine, const LoadsResult& loads, std::vector<Finding>& found)
{
    constexpr double limit = 5e8;
    for (std::size_t j = 0; j < loads.linkage.joints.size(); ++j) {
        const auto& name = loads.linkage.joints[j].name;
        if (loads.images[j] || !input.joints.contains(name) ||
            loads.linkage.joints[j].kind != LinkageJoint::Kind::revolute)
            continue;
        const double area = projected_area(input, machine, name);
        const double force = peak(loads.history.joints[j]);
        if (area > 0 && force > limit * area) {
            found.push_back(question(
                fmt::format("operation.{}.force", loads.segment),
                fmt::format("joint '{}' carries {:.4g} kN on {:.4g} cm2 (diameter times length), {:.3g} MPa: no "
                            "bearing bears more than some hundred",
                            name, force / 1e3, 1e4 * area, force / area / 1e6),
                "check the unit of the force, N or kN, the speed, and the size of the joint"));
            return;  // one wrong force presses all joints
        }
    }
}

/// Force of the crank on its bearings where the process force is largest.
Vec2 crank_force(const LoadsResult& loads)
{
    const auto& joint = loads.linkage.joints[static_cast<std::size_t>(loads.linkage.driver)];
    const auto& forces = loads.history.joints[static_cast<std::size_t>(loads.linkage.driver)].force;
    const auto& process = loads.history.process_force;
    const auto at = static_cast<std::size_t>(std::ranges::max_element(process) - process.begin());
    return joint.body_a == loads.linkage.ground ? forces[at] : -1.0 * forces[at];
}

void question_reaction(const Case& input, const LoadsResult& loads, std::vector<Finding>& found)
{
    constexpr double degree = std::numbers::pi / 180;
    constexpr double far = 45 * degree;
    if (!input.chain || !input.chain->reaction_angle || loads.force == 0)
        return;
    const Vec2 force = crank_force(loads);
    if (norm(force) == 0)
        return;
    const double along = std::atan2(force[1], force[0]);
    const double stated = *input.chain->reaction_angle;
    const double off = std::abs(std::remainder(stated - along, 2 * std::numbers::pi));
    if (off > far || std::abs(stated) > 4 * std::numbers::pi)
        found.push_back(question("chain.reaction_angle",
                                 fmt::format("{:.4g} deg, but at its largest the process force presses the crank into "
                                             "its bearings at {:.4g} deg",
                                             stated / degree, along / degree),
                                 "check the unit, deg or rad, and that the angle counts from x towards y"));
}

// A bearing bears some W/cm2 of friction: beyond 20 W/cm2 it is hundreds of kelvins hotter than what holds it.
void question_heat(const Case& input, const Machine& machine, const RunResult& result, std::vector<Finding>& found)
{
    constexpr double limit = 2e5;
    std::set<std::string> questioned;
    for (const auto& summary : result.friction)
        for (const auto& row : summary.rows) {
            double area = 0;
            for (const auto& contact : machine.interfaces)
                for (const auto& joint : row.joints)
                    if (contact.name.starts_with(joint + "."))
                        area += result.symmetry_factor * contact.area;
            const double heat = row.heat(input.machine.initial_temperature).value;
            if (area > 0 && heat > limit * area && questioned.insert(row.row).second)
                found.push_back(question("friction." + row.row,
                                         fmt::format("{:.4g} kW of friction on {:.4g} cm2 of contact, {:.3g} W/cm2: no "
                                                     "bearing or guide bears more than some W/cm2",
                                                     heat / 1e3, 1e4 * area, heat / area / 1e4),
                                         "check decade and unit of its heat, W or kW; it is that of all its joints "
                                         "together"));
        }
}

}  // namespace

bool has_condition(const casefile::Surface& surface)
{
    return surface.film || surface.temperature || !surface.temperature_formula.empty() || surface.heat_flux ||
           surface.insulated;
}

std::vector<Finding> question_machine(const Case& input, const Machine& machine, double size_scale)
{
    std::vector<Finding> found;
    for (auto finding :
         {coarse_parts(input, machine, size_scale), bare_parts(input, machine), faceted_contacts(machine)})
        if (finding)
            found.push_back(std::move(*finding));
    question_masses(input, machine, found);
    question_neighbours(machine, found);
    return found;
}

std::vector<Finding> question_loads(const Case& input, const Machine& machine, const RunResult& result)
{
    std::vector<Finding> found;
    if (result.loads) {
        question_turns(input, *result.loads, found);
        if (!question_force(*result.loads, found))
            question_reaction(input, *result.loads, found);
        question_pressure(input, machine, *result.loads, found);
    }
    question_heat(input, machine, result, found);
    return found;
}

}  // namespace deadpoint::press
