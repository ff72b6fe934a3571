#include "deadpoint/fem/space/file_order.hpp"

#include "deadpoint/exchange/machine.hpp"
#include "deadpoint/fem/space/discretisation.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fmt/format.h>

namespace deadpoint::fem {
namespace {

// A number that is almost unique to the mesh and the same on any number of ranks.
std::uint64_t mesh_mark(const Machine& machine)
{
    std::uint64_t mark = 1469598103934665603ULL;
    const auto mix = [&](std::uint64_t value) { mark = (mark ^ value) * 1099511628211ULL; };
    for (const auto& node : machine.nodes)
        for (const double x : node)
            mix(static_cast<std::uint64_t>(std::llround(x * 1e9)));
    for (const auto& cell : machine.cells) {
        mix(cell.part);
        for (const auto node : cell.nodes)
            mix(node);
    }
    return mark;
}

// One digit where all parts agree, else one per part.
std::string orders_text(const std::vector<int>& orders)
{
    const bool equal = std::ranges::count(orders, orders.front()) == std::ssize(orders);
    return equal ? std::to_string(orders.front()) : fmt::format("{}", fmt::join(orders, ""));
}

}  // namespace

std::string mesh_text(const Discretisation& space)
{
    return fmt::format("mesh {:016x} order {} unknowns {}", mesh_mark(space.machine), orders_text(space.orders),
                       space.total);
}

std::vector<std::size_t> order_of_file(const Discretisation& space)
{
    std::vector<std::size_t> order;
    std::vector<bool> seen(static_cast<std::size_t>(space.total), false);
    std::vector<PetscInt> unknowns;
    for (std::uint32_t c = 0; c < space.machine.cells.size(); ++c) {
        space.unknowns_of(c, unknowns);
        for (const auto unknown : unknowns)
            if (!seen[static_cast<std::size_t>(unknown)]) {
                seen[static_cast<std::size_t>(unknown)] = true;
                order.push_back(static_cast<std::size_t>(unknown));
            }
    }
    return order;
}

}  // namespace deadpoint::fem
