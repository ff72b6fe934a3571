#include "deadpoint/machine/cell_limit.hpp"

#include "deadpoint/core/error.hpp"

#include <fmt/format.h>

namespace deadpoint::machine {

void require_few_cells(const std::string& part, double volume, double size)
{
    const double cells = about_cells(volume, size);
    if (cells > most_cells) {
        throw InputError(
            fmt::format("part '{}': cells of {:.3g} mm would be {:.1e} of them, but a part may have at most "
                        "{:.0e}; make its size larger",
                        part, 1e3 * size, cells, most_cells));
    }
}

}  // namespace deadpoint::machine
