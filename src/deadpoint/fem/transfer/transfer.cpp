#include "deadpoint/fem/transfer/transfer.hpp"

#include "deadpoint/error.hpp"
#include "deadpoint/exchange/machine.hpp"
#include "deadpoint/fem/algebra/petsc.hpp"
#include "deadpoint/fem/space/discretisation.hpp"

#include <algorithm>
#include <cmath>

namespace deadpoint::fem {
namespace {

constexpr double inside = 1e-10;              // relative to a cell's size
constexpr double largest_continuation = 0.5;  // relative to a cell's size
constexpr double margin = 0.1;                // relative to a cell's box, for places slightly outside

constexpr std::uint32_t nowhere = ~0U;

}  // namespace

CellFinder::CellFinder(const Discretisation& space, std::uint32_t part) : space_(space)
{
    const auto& range = space.machine.parts[part];
    const std::uint32_t end = range.first_cell + range.cell_count;
    box_ = box_of(range.first_cell);
    for (std::uint32_t c = range.first_cell; c < end; ++c) {
        const auto box = box_of(c);
        for (std::size_t i = 0; i < 3; ++i) {
            box_.min[i] = std::min(box_.min[i], box.min[i]);
            box_.max[i] = std::max(box_.max[i], box.max[i]);
        }
    }
    const Vec3 length = box_.max - box_.min;
    const double edge = std::cbrt(length[0] * length[1] * length[2] / range.cell_count);
    for (std::size_t i = 0; i < 3; ++i) {
        count_[i] = std::max(1, static_cast<int>(length[i] / edge));
        bin_size_[i] = length[i] / count_[i];
    }

    const std::size_t bins = index({count_[0] - 1, count_[1] - 1, count_[2] - 1}) + 1;
    begin_.assign(bins + 1, 0);
    for (std::uint32_t c = range.first_cell; c < end; ++c) {
        const auto box = box_of(c);
        for_each_bin(bin_of(box.min), bin_of(box.max), [&](std::size_t bin) { ++begin_[bin + 1]; });
    }
    for (std::size_t bin = 0; bin < bins; ++bin)
        begin_[bin + 1] += begin_[bin];
    cells_.resize(begin_.back());
    auto next = begin_;
    for (std::uint32_t c = range.first_cell; c < end; ++c) {
        const auto box = box_of(c);
        for_each_bin(bin_of(box.min), bin_of(box.max), [&](std::size_t bin) { cells_[next[bin]++] = c; });
    }
}

CellFinder::Box CellFinder::box_of(std::uint32_t cell) const
{
    const auto& machine = space_.machine;
    const auto& nodes = machine.cells[cell].nodes;
    Box box{machine.nodes[nodes[0]], machine.nodes[nodes[0]]};
    const std::size_t count = machine.cells[cell].kind == CellKind::hexahedron ? 8 : 4;
    for (std::size_t k = 1; k < count; ++k)
        for (std::size_t i = 0; i < 3; ++i) {
            box.min[i] = std::min(box.min[i], machine.nodes[nodes[k]][i]);
            box.max[i] = std::max(box.max[i], machine.nodes[nodes[k]][i]);
        }
    const Vec3 wider = margin * (box.max - box.min);
    return {box.min - wider, box.max + wider};
}

CellFinder::Bin CellFinder::bin_of(const Vec3& position) const
{
    Bin bin{};
    for (std::size_t i = 0; i < 3; ++i)
        bin[i] =
            static_cast<int>(std::clamp(std::floor((position[i] - box_.min[i]) / bin_size_[i]), 0.0, count_[i] - 1.0));
    return bin;
}

std::size_t CellFinder::index(const Bin& bin) const
{
    return (static_cast<std::size_t>(bin[2]) * static_cast<std::size_t>(count_[1]) + static_cast<std::size_t>(bin[1])) *
               static_cast<std::size_t>(count_[0]) +
           static_cast<std::size_t>(bin[0]);
}

template <class Visitor>
void CellFinder::for_each_bin(const Bin& from, const Bin& to, const Visitor& visit) const
{
    for (int k = std::max(0, from[2]); k <= std::min(count_[2] - 1, to[2]); ++k)
        for (int j = std::max(0, from[1]); j <= std::min(count_[1] - 1, to[1]); ++j)
            for (int i = std::max(0, from[0]); i <= std::min(count_[0] - 1, to[0]); ++i)
                visit(index({i, j, k}));
}

CellPlace CellFinder::place_in(std::uint32_t cell, const Vec3& position) const
{
    CellPlace place;
    place.cell = cell;
    if (space_.maps.unit_position(cell, position, place.unit))
        place.outside = space_.distance_outside(cell, place.unit);
    return place;
}

void CellFinder::try_bin(std::size_t bin, const Vec3& position, bool only_boxes, CellPlace& best) const
{
    for (std::uint32_t k = begin_[bin]; k < begin_[bin + 1] && best.outside > inside; ++k) {
        const std::uint32_t cell = cells_[k];
        if (only_boxes) {
            const auto box = box_of(cell);
            bool within = true;
            for (std::size_t i = 0; i < 3; ++i)
                within = within && position[i] >= box.min[i] && position[i] <= box.max[i];
            if (!within)
                continue;
        }
        const auto place = place_in(cell, position);
        if (place.outside < best.outside)
            best = place;
    }
}

CellPlace CellFinder::find(const Vec3& position) const
{
    CellPlace best;
    const Bin own = bin_of(position);
    try_bin(index(own), position, true, best);
    // The place is outside all cells: widen the search box until a cell is found, then once more.
    const int widest = std::max({count_[0], count_[1], count_[2]});
    for (int ring = 0; ring <= widest && best.outside > margin; ++ring) {
        const bool found = std::isfinite(best.outside);
        for_each_bin({own[0] - ring, own[1] - ring, own[2] - ring}, {own[0] + ring, own[1] + ring, own[2] + ring},
                     [&](std::size_t bin) { try_bin(bin, position, false, best); });
        if (found)
            break;
    }
    return best;
}

Transfer::Transfer(const Discretisation& from, const Discretisation& to) : from_(from), to_(to)
{
    const auto& parts = from.machine.parts;
    const auto same = [](const MeshPart& a, const MeshPart& b) { return a.name == b.name; };
    if (!std::ranges::equal(parts, to.machine.parts, same))
        throw InputError("two meshes of one machine have different parts; both must come from the same case");
    const auto owned = static_cast<std::size_t>(to.last - to.first);
    cell_.assign(owned, nowhere);
    unit_.resize(owned);
    for (std::uint32_t part = 0; part < parts.size(); ++part)
        find_places(part);
}

void Transfer::find_places(std::uint32_t part)
{
    const CellFinder finder(from_, part);
    const auto& range = to_.machine.parts[part];
    std::vector<PetscInt> unknowns;
    for (std::uint32_t c = range.first_cell; c < range.first_cell + range.cell_count; ++c) {
        to_.unknowns_of(c, unknowns);
        for (unsigned i = 0; i < unknowns.size(); ++i) {
            if (!to_.owns(unknowns[i]))
                continue;
            const auto local = static_cast<std::size_t>(unknowns[i] - to_.first);
            if (cell_[local] != nowhere)
                continue;
            const auto place = finder.find(to_.node_position(c, i));
            cell_[local] = place.cell;
            unit_[local] = place.unit;
            if (place.outside > largest_continuation) {
                const auto nearest = from_.maps.nearest_inside(place.cell, place.unit);
                unit_[local] = nearest + largest_continuation / place.outside * (place.unit - nearest);
            }
        }
    }
}

std::vector<double> Transfer::apply(const std::vector<double>& owned, int block) const
{
    const auto all = gather_all(from_, owned, block);
    const auto width = static_cast<std::size_t>(block);
    std::vector<double> result(width * cell_.size(), 0.0);
    PointShape at;
    for (std::size_t row = 0; row < cell_.size(); ++row) {
        shape(row, at);
        for (int i = 0; i < at.count; ++i)
            for (std::size_t b = 0; b < width; ++b)
                result[width * row + b] += at.value[i] * all[width * static_cast<std::size_t>(at.dof[i]) + b];
    }
    return result;
}

std::vector<double> Transfer::apply_transposed(const std::vector<double>& owned) const
{
    OwnedVec sum = create_vector(from_, 1);
    std::array<double, max_cell_dofs> weight{};
    PointShape at;
    for (std::size_t row = 0; row < cell_.size(); ++row) {
        shape(row, at);
        for (int i = 0; i < at.count; ++i)
            weight[static_cast<std::size_t>(i)] = at.value[i] * owned[row];
        DEADPOINT_PETSC(VecSetValues(sum, at.count, at.dof.data(), weight.data(), ADD_VALUES));
    }
    DEADPOINT_PETSC(VecAssemblyBegin(sum));
    DEADPOINT_PETSC(VecAssemblyEnd(sum));
    const double* values = nullptr;
    DEADPOINT_PETSC(VecGetArrayRead(sum, &values));
    std::vector<double> result(values, values + (from_.last - from_.first));
    DEADPOINT_PETSC(VecRestoreArrayRead(sum, &values));
    return result;
}

}  // namespace deadpoint::fem
