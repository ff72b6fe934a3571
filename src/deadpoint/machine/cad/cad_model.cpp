#include "deadpoint/machine/cad/cad_model.hpp"

#include <algorithm>

namespace deadpoint::machine {

std::string name_in_case(const CadSolid& solid) { return solid.called.empty() ? "solid" : solid.called; }

double extent(const CadModel& model)
{
    if (model.solids.empty()) {
        return 0;
    }
    BoxShape box = model.solids.front().bounds;
    for (const CadSolid& solid : model.solids) {
        for (std::size_t i = 0; i < 3; ++i) {
            box.min[i] = std::min(box.min[i], solid.bounds.min[i]);
            box.max[i] = std::max(box.max[i], solid.bounds.max[i]);
        }
    }
    const Vec3 edges = box.max - box.min;
    return *std::ranges::max_element(edges);
}

}  // namespace deadpoint::machine
