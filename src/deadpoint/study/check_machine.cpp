#include "deadpoint/study/check_machine.hpp"

#include "deadpoint/core/error.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <limits>
#include <map>
#include <numeric>

namespace deadpoint::study {
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
    double diameter = 0;                                   ///< of that cell [m]
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

}  // namespace

void require_probes_on_parts(const casefile::Case& input, const Machine& machine)
{
    std::string faults;
    for (const auto& [name, probe] : input.probes) {
        const auto part = std::find_if(machine.parts.begin(), machine.parts.end(),
                                       [&wanted = probe.part](const MeshPart& p) { return p.name == wanted; });
        if (part == machine.parts.end())
            continue;  // named where the heat problem is described
        Vec3 point = probe.position;
        if (machine.half_model)
            point[0] = -std::abs(point[0]);
        const Miss miss = nearest_cell(machine, *part, point);
        if (miss.distance > 0.5 * miss.diameter)
            faults += fmt::format("{}probes.{}: ({:.4g}, {:.4g}, {:.4g}) mm lies {:.3g} mm off its part '{}'",
                                  faults.empty() ? "" : "\n", name, 1e3 * point[0], 1e3 * point[1], 1e3 * point[2],
                                  1e3 * miss.distance, probe.part);
    }
    if (!faults.empty())
        throw InputError(faults + "\n  help: move the probe onto the part, or name the part it lies on");
}

std::vector<std::string> loose_bodies(const Machine& machine)
{
    std::vector<std::size_t> piece(machine.parts.size());
    std::iota(piece.begin(), piece.end(), 0);
    for (const auto& bond : machine.bonds)
        std::replace(piece.begin(), piece.end(), std::size_t{piece[bond.part_b]}, std::size_t{piece[bond.part_a]});

    std::map<std::string, std::map<std::size_t, std::vector<std::string>>> pieces;
    for (std::size_t p = 0; p < piece.size(); ++p)
        pieces[machine.parts[p].body][piece[p]].push_back(machine.parts[p].name);
    std::vector<std::string> warnings;
    for (const auto& [body, groups] : pieces) {
        if (groups.size() < 2)
            continue;
        std::vector<std::string> texts;
        for (const auto& [number, parts] : groups)
            texts.push_back(fmt::format("{}", fmt::join(parts, ", ")));
        warnings.push_back(fmt::format("body '{}' falls into {} pieces that no bond holds together, each of which "
                                       "expands by itself: {}; let its parts touch, or make them bodies of their own",
                                       body, groups.size(), fmt::join(texts, " | ")));
    }
    return warnings;
}

}  // namespace deadpoint::study
