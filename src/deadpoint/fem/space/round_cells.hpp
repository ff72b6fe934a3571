#pragma once

#include "deadpoint/core/vec.hpp"
#include "deadpoint/exchange/round_edges.hpp"
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_simplex_p.h>
#include <deal.II/fe/mapping_fe.h>
#include <deal.II/fe/mapping_q.h>

#include <memory>
#include <vector>

namespace deadpoint {
struct Machine;
}

/// Internal to fem/: maps of second degree, for cells whose edges are round. A straight cell has its map of first
/// degree by them too.
namespace deadpoint::fem {

using CellIterator = dealii::Triangulation<3>::cell_iterator;

/// Where points of the reference cell lie, by exchange/round_edges.
inline std::vector<dealii::Point<3>> places_in(const Machine& machine, const CellIterator& cell,
                                               const std::vector<dealii::Point<3>>& units)
{
    std::vector<dealii::Point<3>> places;
    places.reserve(units.size());
    for (const auto& unit : units) {
        const Vec3 x = place_in(machine, machine.cells[cell->active_cell_index()], {unit[0], unit[1], unit[2]});
        places.emplace_back(x[0], x[1], x[2]);
    }
    return places;
}

class RoundHexahedra : public dealii::MappingQ<3> {
public:
    explicit RoundHexahedra(const Machine& machine)
        : dealii::MappingQ<3>(2), machine_(machine), units_(dealii::FE_Q<3>(2).get_unit_support_points())
    {}
    [[nodiscard]] std::unique_ptr<dealii::Mapping<3>> clone() const override
    {
        return std::make_unique<RoundHexahedra>(machine_);
    }

protected:
    [[nodiscard]] std::vector<dealii::Point<3>> compute_mapping_support_points(const CellIterator& cell) const override
    {
        return places_in(machine_, cell, units_);
    }

private:
    const Machine& machine_;
    std::vector<dealii::Point<3>> units_;
};

class RoundTetrahedra : public dealii::MappingFE<3> {
public:
    explicit RoundTetrahedra(const Machine& machine)
        : dealii::MappingFE<3>(dealii::FE_SimplexP<3>(2)), machine_(machine)
    {}
    [[nodiscard]] std::unique_ptr<dealii::Mapping<3>> clone() const override
    {
        return std::make_unique<RoundTetrahedra>(machine_);
    }

protected:
    [[nodiscard]] std::vector<dealii::Point<3>> compute_mapping_support_points(const CellIterator& cell) const override
    {
        return places_in(machine_, cell, fe->get_unit_support_points());
    }

private:
    const Machine& machine_;
};

}  // namespace deadpoint::fem
