#include "deadpoint/fem/conduction/heat_solver.hpp"

#include <algorithm>
#include <limits>

// Materials that follow the temperature, by interpolated coefficients (product approximation; Christie et al. 1981,
// Larsson, Thomee and Zhang 1989): heat content and flux potential are known exactly at the unknowns and interpolated
// between them as the temperature is. The matrices of the constant materials then act on them,
//   E = M h(T),   r = -K T - K_v theta(T),   tangent  M diag(h') + d (K + K_v diag(theta')),
// so that nothing is integrated anew within a run.

namespace deadpoint::fem {
namespace {

using Map = double (*)(const Material&, double);

void apply(Map map, const std::vector<Material>& materials, const std::vector<std::uint32_t>& parts, Vec from, Vec to)
{
    const double* in = nullptr;
    double* out = nullptr;
    DEADPOINT_PETSC(VecGetArrayRead(from, &in));
    DEADPOINT_PETSC(VecGetArray(to, &out));
    for (std::size_t i = 0; i < parts.size(); ++i)
        out[i] = map(materials[parts[i]], in[i]);
    DEADPOINT_PETSC(VecRestoreArray(to, &out));
    DEADPOINT_PETSC(VecRestoreArrayRead(from, &in));
}

}  // namespace

void HeatSolver::prepare_materials()
{
    capacity_varies_ = std::ranges::any_of(materials_, [](const auto& m) { return !m.specific_heat_table.empty(); });
    conduction_varies_ = std::ranges::any_of(materials_, [](const auto& m) { return !m.conductivity_table.empty(); });
    lowest_.assign(space_.machine.parts.size(), std::numeric_limits<double>::infinity());
    highest_.assign(space_.machine.parts.size(), -std::numeric_limits<double>::infinity());
}

Vec HeatSolver::heat_of(Vec temperature) const
{
    if (!capacity_varies_)
        return temperature;
    apply(heat_temperature, materials_, part_of_unknown_, temperature, mapped_);
    return mapped_;
}

void HeatSolver::heat_change(Vec from, Vec to, Vec change) const
{
    DEADPOINT_PETSC(VecCopy(heat_of(to), change));
    DEADPOINT_PETSC(VecAXPY(change, -1, heat_of(from)));
}

void HeatSolver::store(Vec temperature, Vec stored) const
{
    DEADPOINT_PETSC(MatMult(mass_, heat_of(temperature), stored));
}

void HeatSolver::conduct(Vec temperature, Vec conducted) const
{
    DEADPOINT_PETSC(MatMult(stiffness_, temperature, conducted));
    if (!conduction_varies_)
        return;
    apply(flux_temperature, materials_, part_of_unknown_, temperature, mapped_);
    DEADPOINT_PETSC(MatMultAdd(conduction_, mapped_, conducted, conducted));
}

// matrix += of, its columns scaled by a slope of the materials where a temperature is given.
void HeatSolver::add_tangent(Mat matrix, Mat of, Mat scaled, MaterialMap slope, Vec temperature) const
{
    if (scaled && temperature) {
        apply(slope, materials_, part_of_unknown_, temperature, mapped_);
        DEADPOINT_PETSC(MatCopy(of, scaled, SAME_NONZERO_PATTERN));
        DEADPOINT_PETSC(MatDiagonalScale(scaled, nullptr, mapped_));
        of = scaled;
    }
    DEADPOINT_PETSC(MatAXPY(matrix, 1, of, SAME_NONZERO_PATTERN));
}

void HeatSolver::add_conduction_tangent(Mat matrix, Vec temperature) const
{
    if (conduction_varies_)
        add_tangent(matrix, conduction_, scaled_conduction_, flux_temperature_slope, temperature);
}

void HeatSolver::add_capacity(Mat matrix, Vec temperature) const
{
    add_tangent(matrix, mass_, scaled_mass_, heat_temperature_slope, temperature);
}

// Matrices that hold the tangents. The tangent is not symmetric, which conjugate gradients could not solve.
void HeatSolver::prepare_tangents()
{
    if (!materials_vary())
        return;
    mapped_ = duplicate(now_);
    if (capacity_varies_)
        DEADPOINT_PETSC(MatDuplicate(mass_, MAT_COPY_VALUES, scaled_mass_.out()));
    if (conduction_varies_)
        DEADPOINT_PETSC(MatDuplicate(conduction_, MAT_COPY_VALUES, scaled_conduction_.out()));
    for (Mat matrix : {Mat(system_), Mat(*shell_), Mat(conduction_), Mat(scaled_mass_), Mat(scaled_conduction_)})
        if (matrix)
            DEADPOINT_PETSC(MatSetOption(matrix, MAT_SYMMETRIC, PETSC_FALSE));
    DEADPOINT_PETSC(KSPSetType(solver_, KSPBCGS));
}

void HeatSolver::note_extremes()
{
    const double* values = nullptr;
    DEADPOINT_PETSC(VecGetArrayRead(now_, &values));
    for (std::size_t i = 0; i < part_of_unknown_.size(); ++i) {
        auto& lowest = lowest_[part_of_unknown_[i]];
        auto& highest = highest_[part_of_unknown_[i]];
        lowest = std::min(lowest, values[i]);
        highest = std::max(highest, values[i]);
    }
    DEADPOINT_PETSC(VecRestoreArrayRead(now_, &values));
}

void HeatSolver::extremes_of_ranks(ThermalHistory& history) const
{
    history.part_lowest = lowest_;
    history.part_highest = highest_;
    const auto count = static_cast<int>(lowest_.size());
    MPI_Allreduce(MPI_IN_PLACE, history.part_lowest.data(), count, MPI_DOUBLE, MPI_MIN, MPI_COMM_WORLD);
    MPI_Allreduce(MPI_IN_PLACE, history.part_highest.data(), count, MPI_DOUBLE, MPI_MAX, MPI_COMM_WORLD);
}

}  // namespace deadpoint::fem
