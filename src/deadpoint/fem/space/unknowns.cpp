#include "deadpoint/fem/space/unknowns.hpp"

#include "deadpoint/exchange/machine.hpp"

#include <algorithm>
#include <span>
#include <unordered_map>

namespace deadpoint::fem {
namespace {

constexpr PetscInt none = -1;

// Edges and faces between corners, in the library's order. A face is named by one of its diagonals after the other.
using Pair = std::array<unsigned, 2>;
constexpr std::array<Pair, 12> edges_of_hexahedron{
    {{0, 2}, {1, 3}, {0, 1}, {2, 3}, {4, 6}, {5, 7}, {4, 5}, {6, 7}, {0, 4}, {1, 5}, {2, 6}, {3, 7}}};
constexpr std::array<Pair, 6> edges_of_tetrahedron{{{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}}};
constexpr std::array<std::array<Pair, 2>, 6> faces_of_hexahedron{{{{{0, 6}, {2, 4}}},
                                                                  {{{1, 7}, {3, 5}}},
                                                                  {{{0, 5}, {1, 4}}},
                                                                  {{{2, 7}, {3, 6}}},
                                                                  {{{0, 3}, {1, 2}}},
                                                                  {{{4, 7}, {5, 6}}}}};

// Numbers of what lies between two nodes, an edge or a face's diagonal.
class Between {
public:
    /// @param next  number for what was not met before
    PetscInt number(std::uint32_t a, std::uint32_t b, PetscInt& next)
    {
        const auto key = static_cast<std::uint64_t>(std::min(a, b)) << 32 | std::max(a, b);
        const auto [found, added] = numbers_.try_emplace(key, next);
        next += added ? 1 : 0;
        return found->second;
    }

private:
    std::unordered_map<std::uint64_t, PetscInt> numbers_;
};

}  // namespace

unsigned corner_count(const Cell& cell) { return cell.kind == CellKind::hexahedron ? 8 : 4; }

std::uint32_t node_at(const Cell& cell, unsigned corner)
{
    return cell.nodes[cell.kind == CellKind::hexahedron ? corner_of_node[corner] : corner];  // its own inverse
}

Unknowns::Unknowns(const Machine& machine, const std::vector<int>& orders)
    : machine_(machine), at_node_(machine.nodes.size(), none), beyond_(machine.parts.size())
{
    for (std::uint32_t part = 0; part < machine.parts.size(); ++part)
        number_part(part, orders[part]);
}

void Unknowns::number_part(std::uint32_t p, int order)
{
    const auto& part = machine_.parts[p];
    const bool hexahedra = part.kind == CellKind::hexahedron;
    const auto edges = hexahedra ? std::span<const Pair>(edges_of_hexahedron) : edges_of_tetrahedron;
    auto& beyond = beyond_[p];
    beyond.count = order == 1 ? 0 : edges.size() + (hexahedra ? faces_of_hexahedron.size() + 1 : 0);
    beyond.of_cells.reserve(beyond.count * part.cell_count);
    Between on_edges, on_faces;
    for (std::uint32_t c = part.first_cell; c < part.first_cell + part.cell_count; ++c) {
        const auto& cell = machine_.cells[c];
        for (unsigned corner = 0; corner < corner_count(cell); ++corner)
            if (auto& number = at_node_[node_at(cell, corner)]; number == none)
                number = total_++;
        if (order == 1)
            continue;
        for (const auto& [a, b] : edges)
            beyond.of_cells.push_back(on_edges.number(node_at(cell, a), node_at(cell, b), total_));
        if (!hexahedra)
            continue;
        for (const auto& diagonals : faces_of_hexahedron) {
            std::array<std::array<std::uint32_t, 2>, 2> ends{};
            for (std::size_t d = 0; d < 2; ++d) {
                ends[d] = {node_at(cell, diagonals[d][0]), node_at(cell, diagonals[d][1])};
                std::ranges::sort(ends[d]);
            }
            const auto& [low, high] = std::min(ends[0], ends[1]);  // the one that has the lowest node
            beyond.of_cells.push_back(on_faces.number(low, high, total_));
        }
        beyond.of_cells.push_back(total_++);
    }
}

void Unknowns::of(std::uint32_t c, std::vector<PetscInt>& unknowns) const
{
    const auto& cell = machine_.cells[c];
    unknowns.clear();
    for (unsigned corner = 0; corner < corner_count(cell); ++corner)
        unknowns.push_back(at_node_[node_at(cell, corner)]);
    const auto& beyond = beyond_[cell.part];
    const auto* own = beyond.of_cells.data() + beyond.count * (c - machine_.parts[cell.part].first_cell);
    unknowns.insert(unknowns.end(), own, own + beyond.count);
}

PetscInt Unknowns::met_before(std::uint32_t end) const
{
    PetscInt last = none;
    std::vector<PetscInt> unknowns;
    for (std::uint32_t cell = 0; cell < end; ++cell) {
        of(cell, unknowns);
        last = std::max(last, *std::ranges::max_element(unknowns));
    }
    return last + 1;
}

void Unknowns::renumber(const std::vector<PetscInt>& number)
{
    for (PetscInt& unknown : at_node_)
        if (unknown != none)
            unknown = number[static_cast<std::size_t>(unknown)];
    for (auto& beyond : beyond_)
        for (PetscInt& unknown : beyond.of_cells)
            unknown = number[static_cast<std::size_t>(unknown)];
}

std::vector<std::uint32_t> stretches(const Machine& machine, int ranks)
{
    std::vector<std::uint16_t> cells_at(machine.nodes.size(), 0);
    for (const auto& cell : machine.cells)
        for (unsigned i = 0; i < corner_count(cell); ++i)
            ++cells_at[cell.nodes[i]];
    const auto work = [&](const Cell& cell) {
        double share = 0;
        for (unsigned i = 0; i < corner_count(cell); ++i)
            share += 1.0 / cells_at[cell.nodes[i]];
        return share * (cell.kind == CellKind::hexahedron ? 27 : 15);
    };
    double all = 0;
    for (const auto& cell : machine.cells)
        all += work(cell);
    std::vector<std::uint32_t> first(static_cast<std::size_t>(ranks) + 1, 0);
    double before = 0;
    std::size_t rank = 0;
    for (std::uint32_t c = 0; c < machine.cells.size(); ++c) {
        const double own = work(machine.cells[c]);
        const auto owner =
            std::min(static_cast<std::size_t>(ranks) - 1, static_cast<std::size_t>((before + 0.5 * own) / all * ranks));
        while (rank < owner)
            first[++rank] = c;
        before += own;
    }
    while (rank < static_cast<std::size_t>(ranks))
        first[++rank] = static_cast<std::uint32_t>(machine.cells.size());
    return first;
}

}  // namespace deadpoint::fem
