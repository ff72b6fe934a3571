#include "deadpoint/machine/assembly/inspect.hpp"

#include "deadpoint/core/mistakes.hpp"
#include "deadpoint/core/units.hpp"
#include "deadpoint/machine/assembly/assembly.hpp"
#include "deadpoint/machine/assembly/cell_finder.hpp"
#include "deadpoint/machine/geometry/part_mesh.hpp"
#include "deadpoint/observer.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <limits>
#include <numeric>
#include <optional>
#include <tuple>

namespace deadpoint::machine {

namespace {

/// Share of a face's width; free faces that are nearer lie on each other.
constexpr double near_share = 0.01;
/// Flat cells are thinner than this share of their longest edge, and than this many seam tolerances.
constexpr double flat_share = 0.01;
constexpr double flat_seams = 10;

std::string exact_place(const Vec3& p)
{
    return fmt::format("({:.4f}, {:.4f}, {:.4f}) mm", 1e3 * p[0], 1e3 * p[1], 1e3 * p[2]);
}

std::string micrometres(double length) { return fmt::format("{:.3g} um", micrometre * length); }

/// Disjoint sets that can be merged (union-find).
class Sets {
public:
    explicit Sets(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0U); }
    std::uint32_t root(std::uint32_t i)
    {
        while (parent_[i] != i) {
            parent_[i] = parent_[parent_[i]];
            i = parent_[i];
        }
        return i;
    }
    void join(std::uint32_t a, std::uint32_t b)
    {
        const std::uint32_t first = root(a);
        const std::uint32_t second = root(b);
        parent_[std::max(first, second)] = std::min(first, second);
    }

private:
    std::vector<std::uint32_t> parent_;
};

/// A face seen from a cell: equal keys and unequal turns where two cells meet in it.
struct Sight {
    FaceKey key{};
    bool turn = false;  ///< orientation of the nodes as seen from the cell
    std::uint32_t cell = 0;
};

/// One of the two ways round: whether the node after the smallest is smaller than the one before it.
bool turn_of(const Face& face)
{
    const auto begin = face.nodes.begin();
    const auto count = static_cast<std::size_t>(face.node_count);
    const auto least = static_cast<std::size_t>(std::min_element(begin, begin + face.node_count) - begin);
    return face.nodes[(least + 1) % count] < face.nodes[(least + count - 1) % count];
}

std::vector<Sight> sights_of(const Machine& machine, const MeshPart& part)
{
    std::vector<Sight> sights;
    sights.reserve(static_cast<std::size_t>(part.cell_count) * face_count(part.kind));
    for (std::uint32_t c = part.first_cell; c < part.first_cell + part.cell_count; ++c) {
        for (int i = 0; i < face_count(machine.cells[c].kind); ++i) {
            const Face face = face_of(machine.cells[c], i);
            sights.push_back({face_key(face), turn_of(face), c});
        }
    }
    std::sort(sights.begin(), sights.end(), [](const Sight& a, const Sight& b) {
        return std::tie(a.key, a.turn, a.cell) < std::tie(b.key, b.turn, b.cell);
    });
    return sights;
}

/// Findings in one part.
struct Findings {
    std::vector<std::string> errors;
    std::vector<std::string> warnings;
};

class Inspector {
public:
    Inspector(Assembly& assembly, std::uint32_t part, double seam_tolerance)
        : assembly_(assembly), machine_(assembly.machine), number_(part), part_(assembly.machine.parts[part]),
          tolerance_(seam_tolerance)
    {}

    Findings run()
    {
        connect();
        if (findings_.errors.empty()) {
            look_at_free_faces();
        }
        look_for_flat_cells();
        return std::move(findings_);
    }

private:
    /// Free faces of one kind: their number, their distance and the place of the first one.
    struct Slit {
        int faces = 0;
        double area = 0;
        double gap = 0;
        Vec3 where{};
    };

    void error(const std::string& text) { findings_.errors.push_back(fmt::format("part '{}': {}", part_.name, text)); }
    void warn(const std::string& text) { findings_.warnings.push_back(fmt::format("part '{}': {}", part_.name, text)); }

    void connect()
    {
        Sets sets(part_.cell_count);
        std::optional<std::uint32_t> doubled;
        const std::vector<Sight> sights = sights_of(machine_, part_);
        for (std::size_t i = 1; i < sights.size(); ++i) {
            if (sights[i].key != sights[i - 1].key) {
                continue;
            }
            sets.join(sights[i].cell - part_.first_cell, sights[i - 1].cell - part_.first_cell);
            if (sights[i].turn == sights[i - 1].turn) {
                doubled = std::min(doubled.value_or(sights[i].cell), sights[i].cell);
            }
        }
        if (doubled) {
            error(fmt::format(
                "cells overlap at {}: two of them are on the same side of one face; mesh it again without overlaps",
                exact_place(centre(machine_.cells[*doubled], machine_.nodes))));
        }
        number_pieces(sets);
    }

    void number_pieces(Sets& sets)
    {
        std::vector<std::uint32_t> number(part_.cell_count, 0);
        std::uint32_t pieces = 0;
        for (std::uint32_t i = 0; i < part_.cell_count; ++i) {
            const std::uint32_t root = sets.root(i);
            number[i] = root == i ? pieces++ : number[root];
            machine_.piece_of_cell[part_.first_cell + i] = number[i];
        }
        part_.pieces = pieces;
        if (pieces > 1) {
            look_for_hinges();
        }
    }

    /// Nodes that belong to cells of two pieces.
    void look_for_hinges()
    {
        constexpr auto none = std::numeric_limits<std::uint32_t>::max();
        std::vector<std::uint32_t> piece_at(machine_.nodes.size(), none);
        for (std::uint32_t c = part_.first_cell; c < part_.first_cell + part_.cell_count; ++c) {
            const Cell& cell = machine_.cells[c];
            for (int i = 0; i < node_count(cell.kind); ++i) {
                std::uint32_t& piece = piece_at[cell.nodes[i]];
                if (piece != none && piece != machine_.piece_of_cell[c]) {
                    warn(fmt::format("two of its pieces touch only along an edge or in a point, at {}, where almost no "
                                     "heat passes; let them overlap or keep them apart",
                                     exact_place(machine_.nodes[cell.nodes[i]])));
                    return;
                }
                piece = machine_.piece_of_cell[c];
            }
        }
    }

    void look_at_free_faces()
    {
        const CellFinder finder(assembly_, number_);
        std::optional<Vec3> inner;
        Slit closed;
        Slit open;
        for (const Face& face : machine_.faces) {
            if (face.part != number_ || face.symmetry) {
                continue;
            }
            const Vec3 middle = centre(face, machine_.nodes);
            const Vec3 step = (2 * near_share * width(face)) * normalised(area_vector(face, machine_.nodes));
            if (!inner && lies_in_others(finder, behind(face, middle, step), face.cell)) {
                inner = middle;
            }
            if (const auto gap = gap_before(finder, face, middle, step)) {
                Slit& slit = *gap <= tolerance_ * (1 + 1e-6) ? closed : open;
                slit.where = slit.faces++ == 0 ? middle : slit.where;
                slit.gap = std::abs(*gap) > std::abs(slit.gap) ? *gap : slit.gap;
                slit.area += area(face, machine_.nodes);
            }
        }
        if (inner) {
            error(fmt::format("cells overlap at {}; mesh it again without overlaps", exact_place(*inner)));
        } else {
            report(closed, open);
        }
    }

    void report(const Slit& closed, const Slit& open)
    {
        if (closed.faces > 0) {
            error(fmt::format("free faces coincide at {} ({} of them, {:.4g} cm2, up to {} apart), and no heat "
                              "would cross there; make one solid, or one mesh with common nodes",
                              exact_place(closed.where), closed.faces, 1e4 * closed.area, micrometres(closed.gap)));
        }
        if (open.faces > 0) {
            warn(fmt::format("it has a slit of {} at {} ({} faces, {:.4g} cm2), far thinner than its cells; no heat "
                             "crosses it, and its sides count as exposed; if no slit is intended, raise "
                             "numerics.seam_tolerance or join the shapes",
                             micrometres(open.gap), exact_place(open.where), open.faces, 1e4 * open.area));
        }
    }

    /// Smallest extent of a face [m].
    [[nodiscard]] double width(const Face& face) const
    {
        double longest = 0;
        for (int i = 0; i < face.node_count; ++i) {
            const auto next = static_cast<std::size_t>((i + 1) % face.node_count);
            longest = std::max(longest, norm(machine_.nodes[face.nodes[next]] - machine_.nodes[face.nodes[i]]));
        }
        return (face.node_count == 3 ? 2 : 1) * norm(area_vector(face, machine_.nodes)) / longest;
    }

    /// A place in the face's own cell: a short distance behind its centre, or half way through a thin cell.
    [[nodiscard]] Vec3 behind(const Face& face, const Vec3& middle, const Vec3& step) const
    {
        const double thickness = -entry(machine_.cells[face.cell], middle, normalised(step));
        return middle - std::min(1.0, thickness / 2 / norm(step)) * step;
    }

    [[nodiscard]] static bool lies_in_others(const CellFinder& finder, const Vec3& point, std::uint32_t own)
    {
        const auto cells = finder.cells_at(point);
        return std::any_of(cells.begin(), cells.end(), [own](std::uint32_t cell) { return cell != own; });
    }

    /// Distance from a face to the next cell in front of it, if one is near; negative if that cell begins behind.
    [[nodiscard]] std::optional<double> gap_before(const CellFinder& finder, const Face& face, const Vec3& middle,
                                                   const Vec3& step) const
    {
        for (const std::uint32_t cell : finder.cells_at(middle + step)) {
            if (share_nodes(machine_.cells[cell], face)) {
                continue;
            }
            const double gap = entry(machine_.cells[cell], middle, normalised(step));
            if (gap <= norm(step) / 2) {
                return gap;
            }
        }
        return std::nullopt;
    }

    [[nodiscard]] static bool share_nodes(const Cell& cell, const Face& face)
    {
        const auto end = cell.nodes.begin() + node_count(cell.kind);
        return std::any_of(face.nodes.begin(), face.nodes.begin() + face.node_count,
                           [&](std::uint32_t node) { return std::find(cell.nodes.begin(), end, node) != end; });
    }

    /// Distance along a line from its start to the point where it enters a cell [m].
    [[nodiscard]] double entry(const Cell& cell, const Vec3& start, const Vec3& direction) const
    {
        double result = -std::numeric_limits<double>::infinity();
        for (int i = 0; i < face_count(cell.kind); ++i) {
            const Face face = face_of(cell, i);
            const Vec3 normal = area_vector(face, machine_.nodes);
            const double against = dot(direction, normal);
            if (against < 0) {
                result = std::max(result, dot(centre(face, machine_.nodes) - start, normal) / against);
            }
        }
        return result;
    }

    void look_for_flat_cells()
    {
        double flattest = flat_share;
        std::uint32_t where = 0;
        for (std::uint32_t c = part_.first_cell; c < part_.first_cell + part_.cell_count; ++c) {
            const auto [least, longest] = edges(machine_.cells[c]);
            if (least < flat_seams * tolerance_ && least < flattest * longest) {
                flattest = least / longest;
                where = c;
            }
        }
        if (flattest == flat_share) {
            return;
        }
        const auto [least, longest] = edges(machine_.cells[where]);
        warn(fmt::format("it has flat cells: one at {} is {} thin and {:.3g} mm long; align shapes that nearly end in "
                         "one plane there, or raise numerics.seam_tolerance",
                         exact_place(centre(machine_.cells[where], machine_.nodes)), micrometres(least),
                         1e3 * longest));
    }

    /// Shortest and longest distance between two nodes of a cell [m].
    [[nodiscard]] std::array<double, 2> edges(const Cell& cell) const
    {
        std::array<double, 2> found{std::numeric_limits<double>::infinity(), 0};
        for (int i = 0; i < node_count(cell.kind); ++i) {
            for (int k = 0; k < i; ++k) {
                const double length = norm(machine_.nodes[cell.nodes[i]] - machine_.nodes[cell.nodes[k]]);
                found = {std::min(found[0], length), std::max(found[1], length)};
            }
        }
        return found;
    }

    Assembly& assembly_;
    Machine& machine_;
    std::uint32_t number_;
    MeshPart& part_;
    double tolerance_;
    Findings findings_;
};

}  // namespace

void inspect(Assembly& assembly, double seam_tolerance, Observer& observer)
{
    Machine& machine = assembly.machine;
    machine.piece_of_cell.assign(machine.cells.size(), 0);
    Mistakes mistakes("geometry");
    for (std::uint32_t part = 0; part < machine.parts.size(); ++part) {
        const Findings found = Inspector(assembly, part, seam_tolerance).run();
        for (const std::string& error : found.errors) {
            mistakes.add("parts." + machine.parts[part].name, InputError(error));
        }
        for (const std::string& warning : found.warnings) {
            observer.warn(warning);
        }
    }
    mistakes.raise();
}

}  // namespace deadpoint::machine
