#include "deadpoint/exchange/face_points.hpp"
#include "deadpoint/fem/conduction/heat_solver.hpp"
#include "deadpoint/fem/space/large_pages.hpp"
#include <deal.II/hp/fe_values.h>

#include <algorithm>

// Matrices of the heat problem; time integration is in heat_solver.cpp.

namespace deadpoint::fem {

void insert_block(Mat matrix, const PointShape& rows, const PointShape& columns, double factor)
{
    std::array<double, max_cell_dofs * max_cell_dofs> block{};
    for (int i = 0; i < rows.count; ++i)
        for (int j = 0; j < columns.count; ++j)
            block[static_cast<std::size_t>(i) * columns.count + j] = factor * rows.value[i] * columns.value[j];
    DEADPOINT_PETSC(
        MatSetValues(matrix, rows.count, rows.dof.data(), columns.count, columns.dof.data(), block.data(), ADD_VALUES));
}

void HeatSolver::add_interface_pattern(dealii::DynamicSparsityPattern& pattern) const
{
    using Index = dealii::types::global_dof_index;
    const auto couple = [&](const std::vector<Index>& rows, const std::vector<Index>& columns) {
        for (const auto row : rows)
            if (space_.owns(static_cast<PetscInt>(row)))
                pattern.add_entries(row, columns.begin(), columns.end());
    };
    for (std::size_t i = 0; i < interfaces_.size(); ++i) {
        for (const auto& strip : interfaces_[i].strips) {
            std::vector<Index> a, b;
            for (const auto& entry : strip.a)
                a.push_back(static_cast<Index>(entry.first));
            for (const auto& entry : strip.b)
                b.push_back(static_cast<Index>(entry.first));
            couple(a, b);
            couple(b, a);
        }
        if (interfaces_[i].strips.empty())
            space_.add_pattern_across(space_.machine.interfaces[i].points, pattern);
    }
}

void HeatSolver::create_pattern()
{
    auto pattern = space_.cell_pattern();
    space_.add_bond_pattern(pattern);
    add_interface_pattern(pattern);
    stiffness_ = create_matrix(space_, pattern, 1);
    std::vector<PetscInt> columns;
    std::vector<double> zeros;
    for (PetscInt row = space_.first; row < space_.last; ++row) {
        const auto entries = static_cast<dealii::types::global_dof_index>(row);
        columns.clear();
        for (auto entry = pattern.begin(entries); entry != pattern.end(entries); ++entry)
            columns.push_back(static_cast<PetscInt>(entry->column()));
        zeros.assign(columns.size(), 0.0);
        DEADPOINT_PETSC(MatSetValues(stiffness_, 1, &row, static_cast<PetscInt>(columns.size()), columns.data(),
                                     zeros.data(), INSERT_VALUES));
    }
    DEADPOINT_PETSC(MatAssemblyBegin(stiffness_, MAT_FINAL_ASSEMBLY));
    DEADPOINT_PETSC(MatAssemblyEnd(stiffness_, MAT_FINAL_ASSEMBLY));
}

// All of one pattern, with zeros where a matrix has nothing, so that they are added as they lie in memory.
void HeatSolver::create_matrices()
{
    create_pattern();
    give_back_freed_memory();
    const auto alike = [&](OwnedMat& matrix) {
        DEADPOINT_PETSC(MatDuplicate(stiffness_, MAT_COPY_VALUES, matrix.out()));
    };
    alike(mass_);
    if (variable_films_)
        alike(variable_);
    if (conduction_varies_)
        alike(conduction_);
}

void HeatSolver::assemble()
{
    DEADPOINT_PETSC(MatZeroEntries(mass_));
    DEADPOINT_PETSC(MatZeroEntries(stiffness_));
    if (conduction_varies_)
        DEADPOINT_PETSC(MatZeroEntries(conduction_));
    assemble_cells(mass_, stiffness_, conduction_);
    assemble_bonds(stiffness_, conduction_);
    assemble_interfaces(stiffness_);
    assemble_films(stiffness_);
    for (Mat matrix : {Mat(mass_), Mat(stiffness_), Mat(conduction_)}) {
        if (!matrix)
            continue;
        DEADPOINT_PETSC(MatAssemblyBegin(matrix, MAT_FINAL_ASSEMBLY));
        DEADPOINT_PETSC(MatAssemblyEnd(matrix, MAT_FINAL_ASSEMBLY));
    }
}

// Where the conductivity follows the temperature, conduction goes into `variable` and zeros into the stiffness, so that
// the one's pattern lies within the other's.
void HeatSolver::assemble_cells(Mat mass, Mat stiffness, Mat variable) const
{
    dealii::hp::FEValues<3> values(space_.mappings, space_.elements, space_.quadratures,
                                   dealii::update_values | dealii::update_gradients | dealii::update_JxW_values);
    std::vector<dealii::types::global_dof_index> indices;
    std::vector<PetscInt> rows;
    std::vector<double> capacity, conduction;
    for (const auto& cell : space_.dofs.active_cell_iterators()) {
        if (!cell->is_locally_owned())
            continue;
        values.reinit(cell);
        const auto& v = values.get_present_fe_values();
        const unsigned n = v.dofs_per_cell;
        indices.resize(n);
        cell->get_dof_indices(indices);
        rows.assign(indices.begin(), indices.end());
        capacity.assign(n * n, 0.0);
        conduction.assign(n * n, 0.0);
        const auto& material = materials_[cell->material_id()];
        for (const auto q : v.quadrature_point_indices()) {
            const double c = material.density * material.specific_heat * v.JxW(q);
            const double k = material.conductivity * v.JxW(q);
            for (unsigned i = 0; i < n; ++i)
                for (unsigned j = 0; j < n; ++j) {
                    capacity[i * n + j] += c * v.shape_value(i, q) * v.shape_value(j, q);
                    conduction[i * n + j] += k * (v.shape_grad(i, q) * v.shape_grad(j, q));
                }
        }
        const auto count = static_cast<PetscInt>(n);
        DEADPOINT_PETSC(MatSetValues(mass, count, rows.data(), count, rows.data(), capacity.data(), ADD_VALUES));
        if (!material.conductivity_table.empty()) {
            DEADPOINT_PETSC(
                MatSetValues(variable, count, rows.data(), count, rows.data(), conduction.data(), ADD_VALUES));
            conduction.assign(n * n, 0.0);
        }
        DEADPOINT_PETSC(MatSetValues(stiffness, count, rows.data(), count, rows.data(), conduction.data(), ADD_VALUES));
    }
}

namespace {

double largest_conductivity(const Material& material)
{
    const auto& table = material.conductivity_table;
    return table.empty() ? material.conductivity : *std::ranges::max_element(table.y());
}

}  // namespace

// Nitsche: -{k dT/dn}[v] - {k dv/dn}[T] + penalty [T][v], with [T] = T_a - T_b and the flux weighted by the softer
// side. Where a conductivity k(T) follows the temperature, its flux acts on the transform of Kirchhoff and goes into
// `variable`; the second term, which vanishes with [T] whatever k, keeps k at the start, and the penalty takes the
// table's largest.
void HeatSolver::assemble_bonds(Mat stiffness, Mat variable) const
{
    std::array<PetscInt, 2 * max_cell_dofs> dof{};
    std::array<double, 2 * max_cell_dofs> jump{}, flux{}, variable_flux{};
    std::vector<double> block, variable_block;
    for_each_bond_pair(space_, [&](const BondPair& pair) {
        const auto& material_a = materials_[pair.part_a];
        const auto& material_b = materials_[pair.part_b];
        const bool varies_a = !material_a.conductivity_table.empty(), varies_b = !material_b.conductivity_table.empty();
        const double k_a = material_a.conductivity, k_b = material_b.conductivity;
        const int order_a = space_.orders[pair.part_a], order_b = space_.orders[pair.part_b];
        const double per_a = order_a * order_a / pair.depth_a, per_b = order_b * order_b / pair.depth_b;
        const double weight_a = per_b * k_b / (per_a * k_a + per_b * k_b), weight_b = 1 - weight_a;
        const double most_a = per_a * largest_conductivity(material_a);
        const double most_b = per_b * largest_conductivity(material_b);
        const double penalty = 10 * most_a * most_b / (most_a + most_b);
        const int n = pair.points.front().a.count + pair.points.front().b.count;
        block.assign(static_cast<std::size_t>(n) * n, 0.0);
        variable_block = block;
        for (const auto& p : pair.points) {
            for (int i = 0; i < n; ++i) {
                const bool on_a = i < p.a.count;
                const auto& shape = on_a ? p.a : p.b;
                const int k = on_a ? i : i - p.a.count;
                dof[i] = shape.dof[k];
                jump[i] = on_a ? shape.value[k] : -shape.value[k];
                flux[i] = (on_a ? weight_a * k_a : weight_b * k_b) * dot(p.normal, shape.gradient[k]);
                variable_flux[i] = (on_a ? varies_a : varies_b) ? flux[i] : 0;
            }
            for (int i = 0; i < n; ++i)
                for (int j = 0; j < n; ++j) {
                    const auto at = static_cast<std::size_t>(i) * n + j;
                    block[at] += p.weight * (penalty * jump[i] * jump[j] - (flux[j] - variable_flux[j]) * jump[i] -
                                             flux[i] * jump[j]);
                    variable_block[at] -= p.weight * variable_flux[j] * jump[i];
                }
        }
        if (varies_a || varies_b)
            DEADPOINT_PETSC(MatSetValues(variable, n, dof.data(), n, dof.data(), variable_block.data(), ADD_VALUES));
        DEADPOINT_PETSC(MatSetValues(stiffness, n, dof.data(), n, dof.data(), block.data(), ADD_VALUES));
    });
}

void HeatSolver::assemble_interfaces(Mat stiffness) const
{
    PointShape a, b;
    for (std::size_t i = 0; i < interfaces_.size(); ++i) {
        const auto& law = (*laws_)[i];
        const double sum = interfaces_[i].sum;
        const double cross = -law.film_a * law.film_b / sum;
        for (const auto& point : space_.machine.interfaces[i].points) {
            if (!space_.cell(space_.machine.faces[point.face_a].cell)->is_locally_owned())
                continue;
            space_.evaluate(point.face_a, point.position_a, false, a);
            space_.evaluate(point.face_b, point.position_b, false, b);
            insert_block(stiffness, a, a, point.weight * law.film_a * (sum - law.film_a) / sum);
            insert_block(stiffness, b, b, point.weight * law.film_b * (sum - law.film_b) / sum);
            if (!law.turns_fully) {
                insert_block(stiffness, a, b, point.weight * cross);
                insert_block(stiffness, b, a, point.weight * cross);
            }
        }
        // Turning: both sides meet only through their means around the circumference, strip by strip along the axis.
        for (const auto& strip : interfaces_[i].strips)
            for (const auto& [dof_a, moment_a] : strip.a)
                for (const auto& [dof_b, moment_b] : strip.b) {
                    double value = 0;
                    for (int m = 0; m < 2; ++m)
                        if (strip.norm[m] > 1e-14 * strip.norm[0])
                            value += cross * moment_a[m] * moment_b[m] / strip.norm[m];
                    if (space_.owns(dof_a))
                        DEADPOINT_PETSC(MatSetValue(stiffness, dof_a, dof_b, value, ADD_VALUES));
                    if (space_.owns(dof_b))
                        DEADPOINT_PETSC(MatSetValue(stiffness, dof_b, dof_a, value, ADD_VALUES));
                }
    }
}

void HeatSolver::assemble_films(Mat stiffness) const
{
    PointShape shape;
    for (const auto& film : films_) {
        const auto& condition = *film.condition;
        if (condition.kind != SurfaceCondition::Kind::film || depends_on_temperature(condition))
            continue;
        for (const auto& [index, fraction, central] : space_.machine.surfaces[condition.surface].faces) {
            if (!space_.cell(space_.machine.faces[index].cell)->is_locally_owned())
                continue;
            for (const auto& point : face_points(space_.machine, space_.machine.faces[index])) {
                space_.evaluate(index, point.position, false, shape);
                insert_block(stiffness, shape, shape, condition.coefficient * fraction * point.weight);
            }
        }
    }
}

}  // namespace deadpoint::fem
