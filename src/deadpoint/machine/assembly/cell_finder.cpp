#include "deadpoint/machine/assembly/cell_finder.hpp"

#include "deadpoint/machine/assembly/assembly.hpp"
#include "deadpoint/machine/geometry/part_mesh.hpp"
#include "deadpoint/machine/geometry/shapes.hpp"

#include <algorithm>
#include <cmath>

namespace deadpoint::machine {

Bins::Bins(const BoxShape& box, double per_axis)
    : box_(box), count_(static_cast<std::size_t>(std::clamp(std::ceil(per_axis), 1.0, 100.0)))
{}

std::size_t Bins::place(double value, std::size_t axis) const
{
    const double width = box_.max[axis] - box_.min[axis];
    const auto count = static_cast<double>(count_);
    return static_cast<std::size_t>(std::clamp(std::floor((value - box_.min[axis]) / width * count), 0.0, count - 1.0));
}

CellFinder::CellFinder(const Assembly& assembly, std::uint32_t part)
    : machine_(assembly.machine),
      bins_(assembly.bounds[part], std::cbrt(static_cast<double>(machine_.parts[part].cell_count))),
      cells_(bins_.size())
{
    const MeshPart& own = machine_.parts[part];
    for (std::uint32_t c = own.first_cell; c < own.first_cell + own.cell_count; ++c) {
        BoxShape around = empty_box();
        for (int k = 0; k < node_count(machine_.cells[c].kind); ++k) {
            include(around, machine_.nodes[machine_.cells[c].nodes[k]]);
        }
        bins_.visit(around, [&](std::size_t bin) { cells_[bin].push_back(c); });
    }
}

bool CellFinder::holds(const Vec3& point) const
{
    const auto& near = cells_[bins_.at(point)];
    return std::any_of(near.begin(), near.end(),
                       [&](std::uint32_t cell) { return inside(machine_.cells[cell], machine_.nodes, point); });
}

std::vector<std::uint32_t> CellFinder::cells_at(const Vec3& point) const
{
    std::vector<std::uint32_t> found;
    for (const std::uint32_t cell : cells_[bins_.at(point)]) {
        if (inside(machine_.cells[cell], machine_.nodes, point)) {
            found.push_back(cell);
        }
    }
    return found;
}

}  // namespace deadpoint::machine
