#include "deadpoint/fem/space/rank_count.hpp"

#include <algorithm>

namespace deadpoint::fem {

namespace {

constexpr std::size_t least_cells = 5000;  // of a rank
// Memory of a run on one rank, and what each further rank adds: the libraries, and mostly what the factor of the
// deformation takes more on several ranks.
constexpr double of_program = 0.6e9;        // [byte]
constexpr double of_cell = 14e3;            // [byte]
constexpr double of_rank = 0.15e9;          // [byte]
constexpr double of_cell_and_rank = 2.5e3;  // [byte]

}  // namespace

int rank_count(std::size_t cells, int cores, double memory)
{
    const auto size = static_cast<double>(cells);
    const double room = memory - of_program - of_cell * size, more = of_rank + of_cell_and_rank * size;
    const double by_memory = 1 + std::clamp(room / more, 0.0, static_cast<double>(cores));
    const auto by_cells = std::max<std::size_t>(1, cells / least_cells);
    return std::max(1,
                    static_cast<int>(std::min({static_cast<double>(cores), by_memory, static_cast<double>(by_cells)})));
}

}  // namespace deadpoint::fem
