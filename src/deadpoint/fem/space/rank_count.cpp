#include "deadpoint/fem/space/rank_count.hpp"

#include <algorithm>

namespace deadpoint::fem {

namespace {

constexpr std::size_t least_cells = 5000;  // of a rank
// Memory of a run on one rank, and what each further rank adds: the libraries, and what the factor and the levels of
// the multigrid take more on several ranks. Beyond some size the deformation has a coarser mesh of its own, whose
// factor grows no more.
constexpr double shared_mesh = 0.4e6;              // [cells]
constexpr double of_program = 0.15e9;              // [byte]
constexpr double of_cell = 29e3;                   // [byte]
constexpr double of_deformation = 6.15e9;          // [byte], with the program, where it has its own mesh
constexpr double of_cell_beyond = 4e3;             // [byte], of the heat alone
constexpr double of_rank = 0.1e9;                  // [byte]
constexpr double of_cell_and_rank = 2.5e3;         // [byte]
constexpr double of_cell_beyond_and_rank = 0.5e3;  // [byte]

}  // namespace

int rank_count(std::size_t cells, int cores, double memory)
{
    const auto size = static_cast<double>(cells);
    const double shared = std::min(size, shared_mesh), beyond = size - shared;
    const double one = beyond > 0 ? of_deformation + of_cell_beyond * size : of_program + of_cell * size;
    const double more = of_rank + of_cell_and_rank * shared + of_cell_beyond_and_rank * beyond;
    const double by_memory = 1 + std::clamp((memory - one) / more, 0.0, static_cast<double>(cores));
    const auto by_cells = std::max<std::size_t>(1, cells / least_cells);
    return std::max(1,
                    static_cast<int>(std::min({static_cast<double>(cores), by_memory, static_cast<double>(by_cells)})));
}

}  // namespace deadpoint::fem
