#include "deadpoint/press/translate/lookup.hpp"

#include "deadpoint/exchange/machine.hpp"

#include <algorithm>

namespace deadpoint::press {

int part_index(const Machine& machine, const std::string& name)
{
    const auto found = std::find_if(machine.parts.begin(), machine.parts.end(),
                                    [&](const MeshPart& part) { return part.name == name; });
    return found == machine.parts.end() ? -1 : static_cast<int>(found - machine.parts.begin());
}

int surface_index(const Machine& machine, const std::string& name)
{
    const auto found = std::find_if(machine.surfaces.begin(), machine.surfaces.end(),
                                    [&](const MeshSurface& s) { return s.name == name; });
    return found == machine.surfaces.end() ? -1 : static_cast<int>(found - machine.surfaces.begin());
}

}  // namespace deadpoint::press
