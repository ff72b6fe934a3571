#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <petscsystypes.h>
#include <vector>

namespace deadpoint {
struct Cell;
struct Machine;
}  // namespace deadpoint

/// Internal to fem/: the unknowns of each cell, and the cells of each rank. No MPI.
namespace deadpoint::fem {

/// Corner of the reference cell (x runs first, then y, then z) at which a hexahedron has its node (Cell::nodes).
inline constexpr std::array<unsigned, 8> corner_of_node{0, 1, 3, 2, 4, 5, 7, 6};

unsigned corner_count(const Cell& cell);
/// The machine's node at a corner of the reference cell.
std::uint32_t node_at(const Cell& cell, unsigned corner);

/// One unknown at each node, and in parts of second order one more in the middle of each edge, of each face of a
/// hexahedron, and of the hexahedron. Nodes keep a number each; only cells of second order keep more.
class Unknowns {
public:
    /// Numbered as the cells meet them.
    /// @param orders  of the elements, 1 or 2, per part
    Unknowns(const Machine& machine, const std::vector<int>& orders);

    [[nodiscard]] PetscInt total() const { return total_; }
    [[nodiscard]] PetscInt at_node(std::uint32_t node) const { return at_node_[node]; }
    /// Those of a cell, in the order of its element's shape functions: corners, edges, faces, middle.
    void of(std::uint32_t cell, std::vector<PetscInt>& unknowns) const;
    /// How many unknowns the cells before this one have, as long as they are numbered as the cells meet them.
    [[nodiscard]] PetscInt met_before(std::uint32_t cell) const;
    /// Gives unknown i the number `number[i]`.
    void renumber(const std::vector<PetscInt>& number);

private:
    /// Beyond the corners of a part's cells.
    struct Beyond {
        std::size_t count = 0;  ///< per cell
        std::vector<PetscInt> of_cells;
    };
    void number_part(std::uint32_t part, int order);

    const Machine& machine_;
    std::vector<PetscInt> at_node_;
    std::vector<Beyond> beyond_;  ///< per part
    PetscInt total_ = 0;
};

/// First cell of each rank, and the number of all cells behind them. Ranks own consecutive stretches of cells: parts
/// follow each other, layers of a part too, so stretches are compact. They are of equal work, counted in entries of the
/// matrices: a node has about 27 in its row among hexahedra and 15 among tetrahedra, which its cells share.
std::vector<std::uint32_t> stretches(const Machine& machine, int ranks);

}  // namespace deadpoint::fem
