#include "deadpoint/press/check/whole_mass.hpp"

#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/exchange/machine.hpp"

#include <algorithm>

namespace deadpoint::press {
namespace {

bool straddles_plane(const casefile::Case& input, const Machine& machine, const std::string& body)
{
    const auto is_cut = [&](const MeshPart& part) { return part.body == body && part.cut; };
    const auto is_dropped = [&](const std::string& name) {
        const auto part = input.parts.find(name);
        return part != input.parts.end() && part->second.body == body;
    };
    return machine.half_model &&
           (std::ranges::any_of(machine.parts, is_cut) || std::ranges::any_of(machine.dropped_parts, is_dropped));
}

}  // namespace

std::optional<double> WholeMass::deviation() const
{
    return stated && *stated > 0 && !partial ? std::optional(computed / *stated - 1) : std::nullopt;
}

std::vector<WholeMass> whole_masses(const casefile::Case& input, const Machine& machine)
{
    std::vector<WholeMass> result;
    for (const auto& part : machine.parts) {
        auto found = std::ranges::find(result, part.body, &WholeMass::body);
        if (found == result.end()) {
            found = result.insert(found, WholeMass{part.body, 0, 0, {}, false});
        }
        ++found->parts;
        found->computed += part.mass;
    }
    for (auto& mass : result) {
        const bool straddles = straddles_plane(input, machine, mass.body);
        const auto body = input.bodies.find(mass.body);
        const bool twice = body != input.bodies.end() && body->second.mirror;
        mass.computed *= straddles && !twice ? 2 : 1;
        mass.partial = straddles && twice;
        if (body != input.bodies.end()) {
            mass.stated = body->second.mass;
        }
    }
    return result;
}

}  // namespace deadpoint::press
