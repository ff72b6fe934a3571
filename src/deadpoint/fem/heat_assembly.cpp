#include "deadpoint/exchange/face_points.hpp"
#include "deadpoint/fem/heat_solver.hpp"
#include <deal.II/hp/fe_values.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

// Matrices and load vectors of the heat problem; time integration is in heat_solver.cpp.

namespace deadpoint::fem {
namespace {

double axial(const FaceGeometry& geometry, const Vec3& position)
{
    const auto* cylinder = std::get_if<CylinderGeometry>(&geometry);
    return cylinder ? dot(cylinder->axis, position - cylinder->point) : 0.0;
}

// The integrated side's layers along the axis: one strip each.
class AxialStrips {
public:
    AxialStrips(const Machine& machine, const Contact& contact) : geometry_(contact.geometry)
    {
        std::set<std::uint32_t> nodes;
        for (const auto& point : contact.points) {
            const auto& face = machine.faces[point.face_a];
            nodes.insert(face.nodes.begin(), face.nodes.begin() + face.node_count);
        }
        for (const auto node : nodes)
            edges_.push_back(axial(geometry_, machine.nodes[node]));
        std::sort(edges_.begin(), edges_.end());
        edges_.erase(std::unique(edges_.begin(), edges_.end(), [](double a, double b) { return b - a < 1e-7; }),
                     edges_.end());
        std::vector<double> weight(count(), 0.0);
        middle_.assign(count(), 0.0);
        for (const auto& point : contact.points) {
            const auto strip = find(point);
            weight[strip] += point.weight;
            middle_[strip] += point.weight * axial(geometry_, point.position_a);
        }
        for (std::size_t s = 0; s < count(); ++s)
            middle_[s] /= std::max(weight[s], 1e-300);
    }

    [[nodiscard]] std::size_t count() const { return edges_.size() > 1 ? edges_.size() - 1 : 1; }
    [[nodiscard]] std::size_t find(const ContactPoint& point) const
    {
        const double z = axial(geometry_, point.position_a);
        const auto above = std::upper_bound(edges_.begin(), edges_.end(), z) - edges_.begin();
        return static_cast<std::size_t>(
            std::clamp<std::ptrdiff_t>(above - 1, 0, static_cast<std::ptrdiff_t>(count()) - 1));
    }
    // From the centroid of what is in contact in the strip, so that the modes 1 and z are orthogonal there even where
    // the other side covers a strip in part.
    [[nodiscard]] double from_middle(std::size_t strip, const ContactPoint& point) const
    {
        return axial(geometry_, point.position_a) - middle_[strip];
    }

private:
    const FaceGeometry& geometry_;
    std::vector<double> edges_;
    std::vector<double> middle_;
};

void insert_block(Mat matrix, const PointShape& rows, const PointShape& columns, double factor)
{
    std::array<double, max_cell_dofs * max_cell_dofs> block{};
    for (int i = 0; i < rows.count; ++i)
        for (int j = 0; j < columns.count; ++j)
            block[static_cast<std::size_t>(i * columns.count + j)] = factor * rows.value[i] * columns.value[j];
    DEADPOINT_PETSC(
        MatSetValues(matrix, rows.count, rows.dof.data(), columns.count, columns.dof.data(), block.data(), ADD_VALUES));
}

void append(std::vector<std::pair<PetscInt, double>>& entries, const PointShape& shape, double factor)
{
    for (int i = 0; i < shape.count; ++i)
        entries.emplace_back(shape.dof[i], factor * shape.value[i]);
}

}  // namespace

void HeatSolver::prepare_interfaces()
{
    const auto& machine = space_.machine;
    std::vector<double> weighted_area(problem_.sources.size(), 0.0);
    for (std::size_t i = 0; i < machine.interfaces.size(); ++i)
        if (const auto& law = problem_.interfaces[i]; law.source >= 0)
            weighted_area[law.source] += law.heat_weight * machine.interfaces[i].area;

    std::vector<std::vector<std::pair<PetscInt, double>>> loads(problem_.sources.size());
    source_constant_.assign(problem_.sources.size(), 0.0);
    source_self_.assign(problem_.sources.size(), 0.0);
    source_to_oil_.assign(problem_.sources.size(), 0.0);
    for (std::size_t i = 0; i < machine.interfaces.size(); ++i) {
        const auto& contact = machine.interfaces[i];
        const auto& law = problem_.interfaces[i];
        Interface interface;
        interface.area = contact.area;
        interface.sum = law.film_a + law.film_b + law.oil;
        if (!(interface.sum > 0) || !std::isfinite(interface.sum))
            throw DomainError("interface '" + contact.name +
                              "' conducts nothing to either side nor to the oil; give it a conductance");
        std::vector<std::pair<PetscInt, double>> a, b;
        const AxialStrips strips(machine, contact);
        std::vector<std::map<PetscInt, std::array<double, 2>>> moments_a(strips.count()), moments_b(strips.count());
        if (law.turns_fully)
            interface.strips.resize(strips.count());
        PointShape shape_a, shape_b;
        for (const auto& point : contact.points) {
            space_.evaluate(point.face_a, point.position_a, false, shape_a);
            space_.evaluate(point.face_b, point.position_b, false, shape_b);
            append(a, shape_a, point.weight / contact.area);
            append(b, shape_b, point.weight / contact.area);
            if (!law.turns_fully)
                continue;
            const auto strip = strips.find(point);
            const std::array<double, 2> mode{1, strips.from_middle(strip, point)};
            for (int m = 0; m < 2; ++m) {
                interface.strips[strip].norm[m] += point.weight * mode[m] * mode[m];
                for (int k = 0; k < shape_a.count; ++k)
                    moments_a[strip][shape_a.dof[k]][m] += point.weight * mode[m] * shape_a.value[k];
                for (int k = 0; k < shape_b.count; ++k)
                    moments_b[strip][shape_b.dof[k]][m] += point.weight * mode[m] * shape_b.value[k];
            }
        }
        for (std::size_t s = 0; s < interface.strips.size(); ++s) {
            interface.strips[s].a.assign(moments_a[s].begin(), moments_a[s].end());
            interface.strips[s].b.assign(moments_b[s].begin(), moments_b[s].end());
        }
        if (law.source >= 0) {
            interface.heat_weight_area = law.heat_weight * contact.area / weighted_area[law.source];
            const double share = interface.heat_weight_area;
            for (const auto& [dof, weight] : a)
                loads[law.source].emplace_back(dof, share * law.film_a / interface.sum * weight);
            for (const auto& [dof, weight] : b)
                loads[law.source].emplace_back(dof, share * law.film_b / interface.sum * weight);
            source_constant_[law.source] += share * law.oil * law.oil_temperature / interface.sum;
            source_to_oil_[law.source] += share * law.oil / interface.sum;
            source_self_[law.source] += share * share / (contact.area * interface.sum);
        }
        interface.mean_a = space_.functional(a);
        interface.mean_b = space_.functional(b);
        interfaces_.push_back(std::move(interface));
    }
    for (const auto& load : loads)
        source_loads_.push_back(space_.functional(load));
}

void HeatSolver::prepare_films()
{
    const auto& machine = space_.machine;
    for (const auto& condition : problem_.surfaces) {
        if (condition.kind == SurfaceCondition::Kind::temperature)
            continue;
        Film film;
        film.condition = &condition;
        film.index = static_cast<std::size_t>(&condition - problem_.surfaces.data());
        std::vector<std::pair<PetscInt, double>> entries;
        const bool variable = condition.kind == SurfaceCondition::Kind::film && depends_on_temperature(condition);
        variable_films_ = variable_films_ || variable;
        PointShape shape;
        for (const auto& [index, fraction] : machine.surfaces[condition.surface].faces) {
            const bool mine = space_.cell(machine.faces[index].cell)->is_locally_owned();
            for (const auto& point : face_points(machine, machine.faces[index])) {
                space_.evaluate(index, point.position, false, shape);
                append(entries, shape, fraction * point.weight);
                film.area += fraction * point.weight;
                if (variable && mine)
                    film.points.push_back({shape, fraction * point.weight});
            }
        }
        film.integral = space_.functional(entries);
        films_.push_back(std::move(film));
    }
}

void HeatSolver::prepare_prescribed()
{
    std::map<PetscInt, std::pair<Vec3, const SurfaceCondition*>> found;
    PointShape shape;
    for (const auto& condition : problem_.surfaces) {
        if (condition.kind != SurfaceCondition::Kind::temperature)
            continue;
        for (const auto& [index, fraction] : space_.machine.surfaces[condition.surface].faces) {
            const auto cell = space_.cell(space_.machine.faces[index].cell);
            const auto& element = cell->get_fe();
            const auto& mapping = space_.mappings[cell->active_fe_index()];
            for (const auto& point : face_points(space_.machine, space_.machine.faces[index])) {
                space_.evaluate(index, point.position, false, shape);
                for (int i = 0; i < shape.count; ++i)
                    if (space_.owns(shape.dof[i]) && std::abs(shape.value[i]) > 1e-9) {
                        const auto x = mapping.transform_unit_to_real_cell(
                            cell, element.unit_support_point(static_cast<unsigned>(i)));
                        found[shape.dof[i]] = {{x[0], x[1], x[2]}, &condition};
                    }
            }
        }
    }
    for (const auto& [dof, at] : found) {
        prescribed_.push_back(dof);
        prescribed_at_.push_back(at);
    }
    // The rank-one terms of the sources leave prescribed unknowns alone.
    shell_loads_ = source_loads_;
    for (auto& load : shell_loads_)
        for (std::size_t i = 0; i < load.local.size(); ++i)
            if (found.count(space_.first + load.local[i]))
                load.weight[i] = 0;
}

void HeatSolver::prepare_observers(const std::vector<Adjoint>& adjoints, double reference, int attribution)
{
    adjoints_ = &adjoints;
    reference_ = reference;
    attribution_ = attribution;
    PointShape shape;
    for (const auto& probe : problem_.probes) {
        space_.evaluate_in_part(probe.part, probe.position, shape);
        std::vector<std::pair<PetscInt, double>> entries;
        append(entries, shape, 1);
        probes_.push_back(space_.functional(entries));
    }

    const auto& parts = space_.machine.parts;
    std::vector<std::vector<std::pair<PetscInt, double>>> means(parts.size());
    part_of_unknown_.assign(static_cast<std::size_t>(space_.last - space_.first), 0);
    std::vector<dealii::types::global_dof_index> indices;
    dealii::hp::FEValues<3> values(space_.mappings, space_.elements, space_.quadratures,
                                   dealii::update_values | dealii::update_JxW_values);
    std::vector<double> volume(parts.size(), 0.0);
    for (const auto& cell : space_.dofs.active_cell_iterators()) {
        indices.resize(cell->get_fe().n_dofs_per_cell());
        cell->get_dof_indices(indices);
        const auto part = cell->material_id();
        bool mine = false;
        for (const auto dof : indices)
            if (space_.owns(static_cast<PetscInt>(dof))) {
                part_of_unknown_[dof - static_cast<std::size_t>(space_.first)] = part;
                mine = true;
            }
        if (!mine)
            continue;
        values.reinit(cell);
        const auto& v = values.get_present_fe_values();
        for (const auto q : v.quadrature_point_indices())
            for (const auto i : v.dof_indices())
                means[part].emplace_back(static_cast<PetscInt>(indices[i]), v.shape_value(i, q) * v.JxW(q));
    }
    for (std::size_t p = 0; p < parts.size(); ++p) {
        part_means_.push_back(space_.functional(means[p]));
        for (const double w : part_means_.back().weight)
            volume[p] += w;
    }
    sum_over_ranks(volume);
    for (std::size_t p = 0; p < parts.size(); ++p)
        for (double& w : part_means_[p].weight)
            w /= volume[p];

    for (const auto& probe : probes_)
        watched_.push_back(&probe);
    for (const auto& interface : interfaces_) {
        watched_.push_back(&interface.mean_a);
        watched_.push_back(&interface.mean_b);
    }
    for (const auto& mean : part_means_)
        watched_.push_back(&mean);
}

void HeatSolver::add_interface_pattern(dealii::DynamicSparsityPattern& pattern) const
{
    using Index = dealii::types::global_dof_index;
    const auto couple = [&](const std::vector<Index>& rows, const std::vector<Index>& columns) {
        for (const auto row : rows)
            if (space_.owns(static_cast<PetscInt>(row)))
                pattern.add_entries(row, columns.begin(), columns.end());
    };
    const auto dofs_of = [&](std::uint32_t face) {
        const auto cell = space_.cell(space_.machine.faces[face].cell);
        std::vector<Index> indices(cell->get_fe().n_dofs_per_cell());
        cell->get_dof_indices(indices);
        return indices;
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
        if (!interfaces_[i].strips.empty())
            continue;
        std::set<std::pair<std::uint32_t, std::uint32_t>> pairs;
        for (const auto& point : space_.machine.interfaces[i].points)
            pairs.emplace(point.face_a, point.face_b);
        for (const auto& [face_a, face_b] : pairs) {
            const auto a = dofs_of(face_a), b = dofs_of(face_b);
            couple(a, b);
            couple(b, a);
        }
    }
}

void HeatSolver::assemble_cells(Mat mass, Mat stiffness) const
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
        DEADPOINT_PETSC(MatSetValues(stiffness, count, rows.data(), count, rows.data(), conduction.data(), ADD_VALUES));
    }
}

// Nitsche: -{k dT/dn}[v] - {k dv/dn}[T] + penalty [T][v], with [T] = T_a - T_b and the flux weighted by the softer
// side.
void HeatSolver::assemble_bonds(Mat stiffness) const
{
    const double penalty_factor = 10.0 * space_.order * space_.order;
    std::array<PetscInt, 2 * max_cell_dofs> dof{};
    std::array<double, 2 * max_cell_dofs> jump{}, flux{};
    std::vector<double> block;
    for_each_bond_pair(space_, [&](const BondPair& pair) {
        const double k_a = materials_[pair.part_a].conductivity, k_b = materials_[pair.part_b].conductivity;
        const double stiff_a = k_a / pair.depth_a, stiff_b = k_b / pair.depth_b;
        const double weight_a = stiff_b / (stiff_a + stiff_b), weight_b = stiff_a / (stiff_a + stiff_b);
        const double penalty = penalty_factor * stiff_a * stiff_b / (stiff_a + stiff_b);
        const int n = pair.points.front().a.count + pair.points.front().b.count;
        block.assign(static_cast<std::size_t>(n * n), 0.0);
        for (const auto& p : pair.points) {
            for (int i = 0; i < n; ++i) {
                const bool on_a = i < p.a.count;
                const auto& shape = on_a ? p.a : p.b;
                const int k = on_a ? i : i - p.a.count;
                dof[i] = shape.dof[k];
                jump[i] = on_a ? shape.value[k] : -shape.value[k];
                flux[i] = (on_a ? weight_a * k_a : weight_b * k_b) * dot(p.normal, shape.gradient[k]);
            }
            for (int i = 0; i < n; ++i)
                for (int j = 0; j < n; ++j)
                    block[static_cast<std::size_t>(i * n + j)] +=
                        p.weight * (penalty * jump[i] * jump[j] - flux[j] * jump[i] - flux[i] * jump[j]);
        }
        DEADPOINT_PETSC(MatSetValues(stiffness, n, dof.data(), n, dof.data(), block.data(), ADD_VALUES));
    });
}

void HeatSolver::assemble_interfaces(Mat stiffness) const
{
    PointShape a, b;
    for (std::size_t i = 0; i < interfaces_.size(); ++i) {
        const auto& law = problem_.interfaces[i];
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
        for (const auto& [index, fraction] : space_.machine.surfaces[condition.surface].faces) {
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
