#include "deadpoint/report/probe/node_temperatures.hpp"

#include "deadpoint/error.hpp"
#include "deadpoint/exchange/machine.hpp"
#include "deadpoint/report/folder/result_files.hpp"
#include "deadpoint/report/probe/field_files.hpp"

#include <array>
#include <cmath>
#include <fmt/format.h>
#include <map>

namespace deadpoint::report {
namespace {

/// A part and a place to the tenth of a micrometre: several parts may have a node at one place.
using Key = std::array<long long, 4>;

Key key_of(std::int32_t part, const Vec3& place)
{
    constexpr double step = 1e-7;  // [m]
    return {part, std::llround(place[0] / step), std::llround(place[1] / step), std::llround(place[2] / step)};
}

void add(const VtuContents& piece, std::map<Key, double>& at)
{
    const auto* array = piece.find("temperature [degC]");
    const auto* values = array ? std::get_if<std::vector<float>>(&array->values) : nullptr;
    if (values == nullptr) {
        throw InputError("a field file has no temperature\n  help: compute the case again");
    }
    const auto& parts = parts_of(piece);
    const auto& grid = piece.grid;
    std::size_t begin = 0;
    for (std::size_t cell = 0; cell < grid.offsets.size(); ++cell) {
        for (std::size_t i = begin; i < grid.offsets[cell]; ++i) {
            const auto node = grid.connectivity[i];
            at[key_of(parts[cell], grid.points[node])] = static_cast<double>((*values)[node]);
        }
        begin = grid.offsets[cell];
    }
}

}  // namespace

std::vector<double> node_temperatures(const ResultFiles& results, const Machine& machine)
{
    std::map<Key, double> at;
    for (const auto& piece : field_pieces(results, field_times(results).back().file)) {
        add(piece, at);
    }
    std::vector<double> temperatures(machine.nodes.size(), 0.0);
    for (const Cell& cell : machine.cells) {
        for (int i = 0; i < (cell.kind == CellKind::hexahedron ? 8 : 4); ++i) {
            const auto found = at.find(key_of(static_cast<std::int32_t>(cell.part), machine.nodes[cell.nodes[i]]));
            if (found == at.end()) {
                throw InputError(fmt::format("'{}' holds the fields of another mesh\n  help: give the case, --set and "
                                             "--size of that run",
                                             results.folder().string()));
            }
            temperatures[cell.nodes[i]] = found->second;
        }
    }
    return temperatures;
}

}  // namespace deadpoint::report
