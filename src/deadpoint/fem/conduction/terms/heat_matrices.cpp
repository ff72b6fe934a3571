#include "deadpoint/fem/conduction/terms/heat_matrices.hpp"

#include "deadpoint/exchange/laws/material.hpp"
#include "deadpoint/fem/algebra/huge_pages.hpp"
#include "deadpoint/fem/space/cell_values.hpp"
#include "deadpoint/heat/films.hpp"

#include <algorithm>

namespace deadpoint::fem {
namespace {

void finish(Mat matrix)
{
    DEADPOINT_PETSC(MatAssemblyBegin(matrix, MAT_FINAL_ASSEMBLY));
    DEADPOINT_PETSC(MatAssemblyEnd(matrix, MAT_FINAL_ASSEMBLY));
}

const std::vector<InterfaceLaw>& laws_of(const HeatProblem& problem, const HeatSegment& segment)
{
    return segment.interfaces.empty() ? problem.interfaces : segment.interfaces;
}

std::vector<JointCoefficients> coefficients_of(const std::vector<InterfaceLaw>& laws)
{
    std::vector<JointCoefficients> result;
    for (const auto& law : laws)
        result.push_back(fem::coefficients_of(law));
    return result;
}

bool laws_change(const HeatProblem& problem)
{
    const auto differs = [&](const HeatSegment& segment) {
        return coefficients_of(laws_of(problem, segment)) !=
               coefficients_of(laws_of(problem, problem.segments.front()));
    };
    return std::ranges::any_of(problem.segments, differs);
}

std::vector<double> film_coefficients(const HeatProblem& problem)
{
    std::vector<double> result;
    for (const auto& condition : problem.surfaces)
        result.push_back(condition.coefficient);
    return result;
}

double largest_conductivity(const Material& material)
{
    const auto& table = material.conductivity_table;
    return table.empty() ? material.conductivity : *std::ranges::max_element(table.y());
}

}  // namespace

HeatMatrices::HeatMatrices(const Discretisation& space, const std::vector<Material>& materials,
                           const HeatProblem& problem)
    : space_(space), materials_(materials), joints_(space, problem), film_terms_(fem::film_terms(space, problem))
{
    create_matrices(std::ranges::any_of(problem.surfaces, heat::follows_temperature));
    DEADPOINT_PETSC(MatZeroEntries(stiffness_));
    integrate_solid(stiffness_, mass_, conduction_);
    if (laws_change(problem))
        keep_solid();
    adopt(problem);
}

bool HeatMatrices::serve(const HeatProblem& problem) const
{
    return std::ranges::all_of(problem.segments,
                               [&](const HeatSegment& segment) { return joints_.serve(laws_of(problem, segment)); });
}

void HeatMatrices::adopt(const HeatProblem& problem) { wanted_.films = film_coefficients(problem); }

bool HeatMatrices::set_laws(const std::vector<InterfaceLaw>& laws)
{
    wanted_.joints = coefficients_of(laws);
    if (!is_solid_ && wanted_ == present_)
        return false;
    if (solid_ || !is_solid_)
        DEADPOINT_PETSC(MatCopy(solid(), stiffness_, SAME_NONZERO_PATTERN));
    joints_.add_to(stiffness_, wanted_.joints);
    for (std::size_t s = 0; s < film_terms_.size(); ++s)
        film_terms_[s].add_to(stiffness_, wanted_.films[s]);
    finish(stiffness_);
    present_ = wanted_;
    is_solid_ = false;
    return true;
}

Mat HeatMatrices::solid()
{
    if (!solid_ && is_solid_)
        keep_solid();
    if (!solid_) {
        DEADPOINT_PETSC(MatDuplicate(stiffness_, MAT_SHARE_NONZERO_PATTERN, solid_.out()));
        DEADPOINT_PETSC(MatZeroEntries(solid_));
        integrate_solid(solid_, nullptr, nullptr);
    }
    return solid_;
}

void HeatMatrices::keep_solid()
{
    DEADPOINT_PETSC(MatDuplicate(stiffness_, MAT_SHARE_NONZERO_PATTERN, solid_.out()));
    DEADPOINT_PETSC(MatCopy(stiffness_, solid_, SAME_NONZERO_PATTERN));
}

void HeatMatrices::create_pattern()
{
    auto couplings = space_.cell_couplings();
    space_.add_bond_couplings(couplings);
    joints_.add_couplings(couplings);
    stiffness_ = create_matrix(couplings.rows());
}

void HeatMatrices::create_matrices(bool some_films_follow)
{
    create_pattern();
    give_back_freed_memory();
    const auto alike = [&](OwnedMat& matrix) {
        DEADPOINT_PETSC(MatDuplicate(stiffness_, MAT_SHARE_NONZERO_PATTERN, matrix.out()));
        DEADPOINT_PETSC(MatZeroEntries(matrix));
    };
    alike(mass_);
    if (some_films_follow)
        alike(films_);
    if (std::ranges::any_of(materials_, [](const auto& m) { return !m.conductivity_table.empty(); }))
        alike(conduction_);
}

// Adds K_solid to zeros, and mass and K_v if they are requested.
void HeatMatrices::integrate_solid(Mat stiffness, Mat mass, Mat variable)
{
    ++integrations_;
    assemble_cells(mass, stiffness, variable);
    assemble_bonds(stiffness, variable);
    for (const Mat matrix : {stiffness, mass, variable})
        if (matrix)
            finish(matrix);
}

// Where the conductivity follows the temperature, conduction goes into `variable` and zeros into the stiffness, so that
// the one's pattern lies within the other's.
void HeatMatrices::assemble_cells(Mat mass, Mat stiffness, Mat variable) const
{
    std::vector<double> capacity, conduction;
    for_each_cell(space_, [&](const CellValues& v, const std::vector<PetscInt>& rows, int part) {
        const unsigned n = v.dofs_per_cell();
        capacity.assign(n * n, 0.0);
        conduction.assign(n * n, 0.0);
        const auto& material = materials_[static_cast<std::size_t>(part)];
        for (const auto q : v.quadrature_point_indices()) {
            const double c = material.density * material.specific_heat * v.JxW(q);
            const double k = material.conductivity * v.JxW(q);
            for (unsigned i = 0; i < n; ++i)
                for (unsigned j = 0; j < n; ++j) {
                    capacity[i * n + j] += c * v.shape_value(i, q) * v.shape_value(j, q);
                    conduction[i * n + j] += k * dot(v.shape_grad(i, q), v.shape_grad(j, q));
                }
        }
        const auto count = static_cast<PetscInt>(n);
        if (mass)
            DEADPOINT_PETSC(MatSetValues(mass, count, rows.data(), count, rows.data(), capacity.data(), ADD_VALUES));
        if (!material.conductivity_table.empty()) {
            if (variable)
                DEADPOINT_PETSC(
                    MatSetValues(variable, count, rows.data(), count, rows.data(), conduction.data(), ADD_VALUES));
            conduction.assign(n * n, 0.0);
        }
        DEADPOINT_PETSC(MatSetValues(stiffness, count, rows.data(), count, rows.data(), conduction.data(), ADD_VALUES));
    });
}

// Nitsche: -{k dT/dn}[v] - {k dv/dn}[T] + penalty [T][v], with [T] = T_a - T_b and the flux weighted by the softer
// side. Where a conductivity k(T) follows the temperature, its flux acts on the transform of Kirchhoff and goes into
// `variable`; the second term, which vanishes with [T] whatever k, keeps k at the start, and the penalty takes the
// table's largest.
void HeatMatrices::assemble_bonds(Mat stiffness, Mat variable) const
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
        if (variable && (varies_a || varies_b))
            DEADPOINT_PETSC(MatSetValues(variable, n, dof.data(), n, dof.data(), variable_block.data(), ADD_VALUES));
        DEADPOINT_PETSC(MatSetValues(stiffness, n, dof.data(), n, dof.data(), block.data(), ADD_VALUES));
    });
}

}  // namespace deadpoint::fem
