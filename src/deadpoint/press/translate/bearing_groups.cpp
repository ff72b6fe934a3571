#include "deadpoint/press/translate/bearing_groups.hpp"

#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/exchange/machine.hpp"

#include <algorithm>
#include <cstdint>
#include <set>

namespace deadpoint::press {

std::vector<std::vector<int>> bearings_of(const casefile::Case& input, const Machine& machine,
                                          const std::vector<int>& contacts)
{
    std::vector<std::vector<int>> bearings;
    std::vector<std::set<std::uint32_t>> rings;
    for (const int index : contacts) {
        std::vector<int> together{index};
        std::set<std::uint32_t> shared;
        const auto& contact = machine.interfaces[index];
        for (const auto part : {contact.part_a, contact.part_b})
            if (input.bodies.at(machine.parts[part].body).thermal_only)
                shared.insert(part);
        for (std::size_t b = bearings.size(); b-- > 0;) {
            if (std::ranges::none_of(shared, [&](auto part) { return rings[b].contains(part); }))
                continue;
            together.insert(together.begin(), bearings[b].begin(), bearings[b].end());
            shared.insert(rings[b].begin(), rings[b].end());
            bearings.erase(bearings.begin() + static_cast<std::ptrdiff_t>(b));
            rings.erase(rings.begin() + static_cast<std::ptrdiff_t>(b));
        }
        bearings.push_back(std::move(together));
        rings.push_back(std::move(shared));
    }
    return bearings;
}

}  // namespace deadpoint::press
