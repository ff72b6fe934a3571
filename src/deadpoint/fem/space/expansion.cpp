#include "deadpoint/fem/space/expansion.hpp"

#include "deadpoint/fem/space/discretisation.hpp"

#include <algorithm>

namespace deadpoint::fem {

Expansion::Expansion(const Discretisation& space, const std::vector<Material>& materials) : materials_(materials)
{
    if (std::ranges::any_of(materials, [](const Material& m) { return !m.expansion_table.empty(); }))
        parts_ = space.part_of_unknown();
}

}  // namespace deadpoint::fem
