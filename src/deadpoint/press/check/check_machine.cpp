#include "deadpoint/press/check/check_machine.hpp"

#include "deadpoint/casefile/check/check.hpp"
#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/casefile/describe/findings.hpp"
#include "deadpoint/core/formula.hpp"
#include "deadpoint/core/mistakes.hpp"
#include "deadpoint/exchange/machine.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <limits>
#include <map>
#include <numeric>
#include <set>

namespace deadpoint::press {
namespace {

struct Bounds {
    Vec3 low, high;
};

Bounds bounds_of(const Machine& machine, const Cell& cell)
{
    Bounds bounds{machine.nodes[cell.nodes[0]], machine.nodes[cell.nodes[0]]};
    for (int i = 1; i < (cell.kind == CellKind::hexahedron ? 8 : 4); ++i)
        for (int k = 0; k < 3; ++k) {
            bounds.low[k] = std::min(bounds.low[k], machine.nodes[cell.nodes[i]][k]);
            bounds.high[k] = std::max(bounds.high[k], machine.nodes[cell.nodes[i]][k]);
        }
    return bounds;
}

struct Miss {
    double distance = std::numeric_limits<double>::max();  ///< to the nearest cell's bounds [m]
    double diameter = 0;                                   ///< diameter of that cell [m]
};

Miss nearest_cell(const Machine& machine, const MeshPart& part, const Vec3& point)
{
    Miss nearest;
    for (std::uint32_t c = part.first_cell; c < part.first_cell + part.cell_count; ++c) {
        const Bounds bounds = bounds_of(machine, machine.cells[c]);
        Vec3 off{};
        for (int k = 0; k < 3; ++k)
            off[k] = std::max({bounds.low[k] - point[k], 0.0, point[k] - bounds.high[k]});
        if (norm(off) < nearest.distance)
            nearest = {norm(off), norm(bounds.high - bounds.low)};
    }
    return nearest;
}

/// Where the pieces of each part begin among those of all parts, and behind the last.
std::vector<std::size_t> ends_of_parts(const Machine& machine)
{
    std::vector<std::size_t> ends{0};
    for (const MeshPart& part : machine.parts)
        ends.push_back(ends.back() + part.pieces);
    return ends;
}

std::string piece_name(const MeshPart& part, std::size_t piece)
{
    return part.pieces == 1 ? part.name : fmt::format("{} (piece {} of {})", part.name, piece + 1, part.pieces);
}

/// Where and when a formula is coldest.
struct Coldest {
    double value = std::numeric_limits<double>::infinity();  ///< [K]
    Vec3 place{};
    double time = 0;  ///< [s]
};

double end_of(const casefile::Case& input)
{
    double end = 0;
    for (const auto& segment : input.operation)
        end += segment.duration;
    return end;
}

Coldest coldest_of(const Formula& formula, const Machine& machine, const MeshSurface& surface, double end)
{
    constexpr int times = 20;
    std::set<std::uint32_t> nodes;
    for (const auto& entry : surface.faces) {
        const auto& face = machine.faces[entry.face];
        nodes.insert(face.nodes.begin(), face.nodes.begin() + face.node_count);
    }
    Coldest coldest;
    for (const auto node : nodes)
        for (int i = 0; i <= times; ++i)
            if (const double value = formula(machine.nodes[node], end * i / times); value < coldest.value)
                coldest = {value, machine.nodes[node], end * i / times};
    return coldest;
}

std::string cold_text(const Coldest& coldest)
{
    return fmt::format("gives {:.4g} K at ({:.4g}, {:.4g}, {:.4g}) m, t = {:.4g} s", coldest.value, coldest.place[0],
                       coldest.place[1], coldest.place[2], coldest.time);
}

/// For each piece of all parts a number that it shares with the pieces it is held to: by a bond, or, within a part, by
/// an interface of a joint, as the two plates of a link that turn on one pin.
std::vector<std::size_t> pieces_held_together(const Machine& machine, const std::vector<std::size_t>& ends)
{
    std::vector<std::size_t> group(ends.back());
    std::iota(group.begin(), group.end(), 0);
    const auto hold = [&](std::uint32_t face_a, std::uint32_t face_b) {
        const auto piece = [&](std::uint32_t f) {
            const Face& face = machine.faces[f];
            return ends[face.part] + (machine.piece_of_cell.empty() ? 0 : machine.piece_of_cell[face.cell]);
        };
        const std::size_t kept = group[piece(face_a)];
        const std::size_t joined = group[piece(face_b)];
        if (kept != joined)
            std::replace(group.begin(), group.end(), joined, kept);
    };
    for (const auto& bond : machine.bonds)
        for (const auto& point : bond.points)
            hold(point.face_a, point.face_b);
    for (const auto& interface : machine.interfaces)
        for (const auto& point : interface.points) {
            hold(interface.points.front().face_a, point.face_a);
            hold(interface.points.front().face_b, point.face_b);
        }
    return group;
}

Bounds bounds_of(const Machine& machine, const MeshPart& part)
{
    Bounds bounds = bounds_of(machine, machine.cells[part.first_cell]);
    for (std::uint32_t c = part.first_cell; c < part.first_cell + part.cell_count; ++c) {
        const Bounds cell = bounds_of(machine, machine.cells[c]);
        for (int k = 0; k < 3; ++k) {
            bounds.low[k] = std::min(bounds.low[k], cell.low[k]);
            bounds.high[k] = std::max(bounds.high[k], cell.high[k]);
        }
    }
    return bounds;
}

/// Gap between two boxes along each axis; 0 where they overlap.
Vec3 gap_between(const Bounds& a, const Bounds& b)
{
    Vec3 gap{};
    for (int k = 0; k < 3; ++k)
        gap[k] = std::max({0.0, a.low[k] - b.high[k], b.low[k] - a.high[k]});
    return gap;
}

std::string axes_of(const Vec3& gap)
{
    std::vector<std::string_view> axes;
    for (int k = 0; k < 3; ++k)
        if (gap[k] > 0)
            axes.push_back(std::array{"x", "y", "z"}[static_cast<std::size_t>(k)]);
    return fmt::format("{}", fmt::join(axes, " and "));
}

/// ": 5 mm along x from 'upright'", the part of other groups whose box is nearest.
std::string neighbour_text(const Machine& machine, const MeshPart& loose, const std::set<std::size_t>& others)
{
    const Bounds own = bounds_of(machine, loose);
    const MeshPart* nearest = nullptr;
    Vec3 least{};
    for (const auto p : others) {
        const Vec3 gap = gap_between(own, bounds_of(machine, machine.parts[p]));
        if (nearest == nullptr || norm(gap) < norm(least)) {
            nearest = &machine.parts[p];
            least = gap;
        }
    }
    if (nearest == nullptr)
        return {};
    return norm(least) > 0 ? fmt::format("; '{}' lies {:.4g} mm along {} from '{}'", loose.name, 1e3 * norm(least),
                                         axes_of(least), nearest->name)
                           : fmt::format("; '{}' is next to '{}', but no faces of the two lie on each other",
                                         loose.name, nearest->name);
}

/// @param groups  pieces of the body that are held together
casefile::Finding loose_body(const Machine& machine, const std::vector<std::size_t>& ends, const std::string& body,
                             const std::map<std::size_t, std::vector<std::size_t>>& groups)
{
    const auto part_of = [&](std::size_t piece) {
        return static_cast<std::size_t>(std::ranges::upper_bound(ends, piece) - ends.begin()) - 1;
    };
    std::vector<std::string> texts;
    const std::vector<std::size_t>* smallest = nullptr;
    for (const auto& [number, pieces] : groups) {
        std::vector<std::string> names;
        for (const auto piece : pieces)
            names.push_back(piece_name(machine.parts[part_of(piece)], piece - ends[part_of(piece)]));
        texts.push_back(fmt::format("{}", fmt::join(names, ", ")));
        if (smallest == nullptr || pieces.size() < smallest->size())
            smallest = &pieces;
    }
    const std::size_t loose = part_of(smallest->front());
    std::set<std::size_t> others;
    for (const auto& [number, pieces] : groups)
        for (const auto piece : pieces)
            if (&pieces != smallest && part_of(piece) != loose)
                others.insert(part_of(piece));
    return {"loose", "parts." + machine.parts[loose].name,
            fmt::format("body '{}' consists of {} pieces without a bond between them, and each expands separately: "
                        "{}{}",
                        body, groups.size(), fmt::join(texts, " | "),
                        neighbour_text(machine, machine.parts[loose], others)),
            "let its parts touch, or make separate bodies", true};
}

}  // namespace

void require_probes_on_parts(const casefile::Case& input, const Machine& machine)
{
    Mistakes mistakes;
    for (const auto& [name, probe] : input.probes) {
        const auto part = std::find_if(machine.parts.begin(), machine.parts.end(),
                                       [&wanted = probe.part](const MeshPart& p) { return p.name == wanted; });
        if (part == machine.parts.end())
            continue;  // reported when the heat problem is described
        Vec3 point = probe.position;
        if (machine.half_model)
            point[0] = -std::abs(point[0]);
        const Miss miss = nearest_cell(machine, *part, point);
        if (miss.distance > 0.5 * miss.diameter)
            mistakes.add("probes." + name,
                         fmt::format("({:.4g}, {:.4g}, {:.4g}) mm lies {:.3g} mm off its part '{}'", 1e3 * point[0],
                                     1e3 * point[1], 1e3 * point[2], 1e3 * miss.distance, probe.part),
                         "move the probe onto the part, or name the part it lies on");
    }
    mistakes.raise();
}

std::vector<std::string> cold_formulas(const casefile::Case& input, const Machine& machine)
{
    std::vector<std::string> warnings;
    Mistakes mistakes;
    for (const auto& surface : machine.surfaces) {
        const auto found = input.surfaces.find(surface.name);
        if (found == input.surfaces.end() || found->second.temperature_formula.empty())
            continue;
        const auto path = fmt::format("surfaces.{}.temperature_formula", surface.name);
        Coldest coldest;
        const bool finite = mistakes.attempt(path, [&] {
            coldest = coldest_of(Formula(found->second.temperature_formula), machine, surface, end_of(input));
        });
        if (!finite)
            continue;
        if (coldest.value <= 0)
            mistakes.add(path, cold_text(coldest) + ", which is not above absolute zero",
                         "the result of a formula is in kelvin: 20 degC are 293.15");
        else if (coldest.value < casefile::coldest_meant)
            warnings.push_back(fmt::format("{} {}; if degC are meant, add 273.15", path, cold_text(coldest)));
    }
    mistakes.raise();
    return warnings;
}

std::vector<casefile::Finding> loose_bodies(const Machine& machine)
{
    const auto ends = ends_of_parts(machine);
    const auto group = pieces_held_together(machine, ends);
    std::map<std::string, std::map<std::size_t, std::vector<std::size_t>>> bodies;
    for (std::size_t p = 0; p < machine.parts.size(); ++p)
        for (std::size_t i = ends[p]; i < ends[p + 1]; ++i)
            bodies[machine.parts[p].body][group[i]].push_back(i);
    std::vector<casefile::Finding> warnings;
    for (const auto& [body, groups] : bodies)
        if (groups.size() > 1)
            warnings.push_back(loose_body(machine, ends, body, groups));
    return warnings;
}

}  // namespace deadpoint::press
