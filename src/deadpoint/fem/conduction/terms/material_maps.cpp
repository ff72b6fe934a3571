#include "deadpoint/fem/conduction/terms/material_maps.hpp"

#include "deadpoint/exchange/laws/material.hpp"
#include "deadpoint/fem/algebra/vectors.hpp"
#include "deadpoint/fem/conduction/terms/heat_matrices.hpp"
#include "deadpoint/fem/space/discretisation.hpp"

#include <algorithm>

namespace deadpoint::fem {

MaterialMaps::MaterialMaps(const Discretisation& space, const std::vector<Material>& materials,
                           const HeatMatrices& matrices, Vec pattern)
    : materials_(materials), matrices_(matrices), parts_(space.part_of_unknown()), change_(duplicate(pattern)),
      capacities_(duplicate(pattern))
{
    capacity_varies_ = std::ranges::any_of(materials_, [](const auto& m) { return !m.specific_heat_table.empty(); });
    conduction_varies_ = matrices_.conduction() != nullptr;
    DEADPOINT_PETSC(VecSet(change_, 1));
    DEADPOINT_PETSC(MatMult(matrices_.mass(), change_, capacities_));
    if (!vary())
        return;
    mapped_ = duplicate(pattern);
    if (capacity_varies_)
        DEADPOINT_PETSC(MatDuplicate(matrices_.mass(), MAT_SHARE_NONZERO_PATTERN, scaled_mass_.out()));
    if (conduction_varies_)
        DEADPOINT_PETSC(MatDuplicate(matrices_.conduction(), MAT_SHARE_NONZERO_PATTERN, scaled_conduction_.out()));
}

void MaterialMaps::map(Map of, Vec from, Vec to) const
{
    const ConstEntries in(from);
    Entries out(to);
    for (std::size_t i = 0; i < parts_.size(); ++i)
        out[i] = of(materials_[parts_[i]], in[i]);
}

// Argument of the mass matrix: the temperature, or the temperature of equal heat content.
Vec MaterialMaps::heat_of(Vec temperature) const
{
    if (!capacity_varies_)
        return temperature;
    map(heat_temperature, temperature, mapped_);
    return mapped_;
}

void MaterialMaps::store(Vec temperature, Vec stored) const
{
    DEADPOINT_PETSC(MatMult(matrices_.mass(), heat_of(temperature), stored));
}

void MaterialMaps::conduct(Vec temperature, Vec conducted) const
{
    DEADPOINT_PETSC(MatMult(matrices_.stiffness(), temperature, conducted));
    if (!conduction_varies_)
        return;
    map(flux_temperature, temperature, mapped_);
    DEADPOINT_PETSC(MatMultAdd(matrices_.conduction(), mapped_, conducted, conducted));
}

double MaterialMaps::stored_between(Vec from, Vec to) const
{
    DEADPOINT_PETSC(VecCopy(heat_of(to), change_));
    DEADPOINT_PETSC(VecAXPY(change_, -1, heat_of(from)));
    PetscScalar stored = 0;
    DEADPOINT_PETSC(VecDot(capacities_, change_, &stored));
    return stored;
}

// matrix += of, its columns scaled by a slope of the materials where a temperature is given.
void MaterialMaps::add_tangent(Mat matrix, Mat of, Mat scaled, Map slope, Vec temperature) const
{
    if (scaled && temperature) {
        map(slope, temperature, mapped_);
        DEADPOINT_PETSC(MatCopy(of, scaled, SAME_NONZERO_PATTERN));
        DEADPOINT_PETSC(MatDiagonalScale(scaled, nullptr, mapped_));
        of = scaled;
    }
    DEADPOINT_PETSC(MatAXPY(matrix, 1, of, SAME_NONZERO_PATTERN));
}

void MaterialMaps::add_conduction_tangent(Mat matrix, Vec temperature) const
{
    if (conduction_varies_)
        add_tangent(matrix, matrices_.conduction(), scaled_conduction_, flux_temperature_slope, temperature);
}

void MaterialMaps::add_capacity(Mat matrix, Vec temperature) const
{
    add_tangent(matrix, matrices_.mass(), scaled_mass_, heat_temperature_slope, temperature);
}

void MaterialMaps::mark_tangents() const
{
    for (const Mat matrix : {matrices_.conduction(), Mat(scaled_mass_), Mat(scaled_conduction_)})
        if (matrix)
            DEADPOINT_PETSC(MatSetOption(matrix, MAT_SYMMETRIC, PETSC_FALSE));
}

}  // namespace deadpoint::fem
