#include "deadpoint/machine/parts/cell_limit.hpp"

#include "deadpoint/error.hpp"
#include "deadpoint/io/child_process.hpp"
#include "deadpoint/observer.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace deadpoint::machine {

namespace {

/// More than any numbers here count.
constexpr double most_cells = 2e8;
/// Memory of a cell while a part is meshed [byte]; cubes of a million and of two million cells took 140 to 250.
constexpr double memory_of_a_cell = 200;
/// From here on meshing takes minutes, and a run hours.
constexpr double many_cells = 3e6;

}  // namespace

void check_cell_count(const std::string& part, double cells, double size, Observer& observer)
{
    const double most = std::min(most_cells, 2 * static_cast<double>(half_of_memory()) / memory_of_a_cell);
    if (cells > most) {
        throw InputError(
            fmt::format("part '{}': a cell size of {:.3g} mm gives {:.1e} cells, but a part may have at most "
                        "{:.0e} on this machine\n  help: make its `size` larger, or numerics.size where it states "
                        "none, and check the unit",
                        part, 1e3 * size, cells, most));
    }
    if (cells > many_cells) {
        observer.warn(fmt::format("part '{}': a cell size of {:.3g} mm gives about {:.1e} cells, which take minutes to "
                                  "mesh and hours to compute; check its size",
                                  part, 1e3 * size, cells));
    }
}

}  // namespace deadpoint::machine
