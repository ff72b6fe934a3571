#include "deadpoint/exchange/face_points.hpp"
#include "deadpoint/fem/conduction/heat_solver.hpp"
#include <deal.II/hp/fe_values.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

// Functionals and load vectors of the heat problem; its matrices are in heat_assembly.cpp.

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

void add(SparseFunctional& sum, const SparseFunctional& term, double factor)
{
    sum.local.insert(sum.local.end(), term.local.begin(), term.local.end());
    for (const double weight : term.weight)
        sum.weight.push_back(factor * weight);
}

// On a face, the shape functions of the nodes off it vanish.
PointShape without_zeros(const PointShape& shape)
{
    PointShape result;
    for (int i = 0; i < shape.count; ++i)
        if (std::abs(shape.value[i]) > 1e-12) {
            result.dof[result.count] = shape.dof[i];
            result.value[result.count++] = shape.value[i];
        }
    return result;
}

void append(std::vector<std::pair<PetscInt, double>>& entries, const PointShape& shape, double factor)
{
    for (int i = 0; i < shape.count; ++i)
        entries.emplace_back(shape.dof[i], factor * shape.value[i]);
}

}  // namespace

// Mean temperature and volume of each part.
void HeatSolver::prepare_parts()
{
    const auto& parts = space_.machine.parts;
    std::vector<std::vector<std::pair<PetscInt, double>>> means(parts.size());
    part_of_unknown_ = space_.part_of_unknown();
    std::vector<dealii::types::global_dof_index> indices;
    dealii::hp::FEValues<3> values(space_.mappings, space_.elements, space_.quadratures,
                                   dealii::update_values | dealii::update_JxW_values);
    for (const auto& cell : space_.dofs.active_cell_iterators()) {
        indices.resize(cell->get_fe().n_dofs_per_cell());
        cell->get_dof_indices(indices);
        const auto part = cell->material_id();
        bool mine = false;
        for (const auto dof : indices)
            mine = mine || space_.owns(static_cast<PetscInt>(dof));
        if (!mine)
            continue;
        values.reinit(cell);
        const auto& v = values.get_present_fe_values();
        for (const auto q : v.quadrature_point_indices())
            for (const auto i : v.dof_indices())
                means[part].emplace_back(static_cast<PetscInt>(indices[i]), v.shape_value(i, q) * v.JxW(q));
    }
    part_volume_.assign(parts.size(), 0.0);
    for (std::size_t p = 0; p < parts.size(); ++p) {
        part_means_.push_back(space_.functional(means[p]));
        for (const double w : part_means_.back().weight)
            part_volume_[p] += w;
    }
    sum_over_ranks(part_volume_);
    for (std::size_t p = 0; p < parts.size(); ++p)
        for (double& w : part_means_[p].weight)
            w /= part_volume_[p];
}

void HeatSolver::prepare_interfaces()
{
    const auto& machine = space_.machine;
    for (std::size_t i = 0; i < machine.interfaces.size(); ++i) {
        const auto& contact = machine.interfaces[i];
        const bool turns = (*laws_)[i].turns_fully;
        Interface interface;
        interface.area = contact.area;
        std::vector<std::pair<PetscInt, double>> a, b;
        const AxialStrips strips(machine, contact);
        std::vector<std::map<PetscInt, std::array<double, 2>>> moments_a(strips.count()), moments_b(strips.count());
        if (turns)
            interface.strips.resize(strips.count());
        PointShape shape_a, shape_b;
        for (const auto& point : contact.points) {
            space_.evaluate(point.face_a, point.position_a, false, shape_a);
            space_.evaluate(point.face_b, point.position_b, false, shape_b);
            append(a, shape_a, point.weight / contact.area);
            append(b, shape_b, point.weight / contact.area);
            if (!turns)
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
        interface.mean_a = space_.functional(a);
        interface.mean_b = space_.functional(b);
        interfaces_.push_back(std::move(interface));
    }
}

// Where the heat of each source goes, by the laws of the present segment. What falls into a film leaves it by both
// sides and the oil; what falls into a part's volume stays there.
void HeatSolver::prepare_sources()
{
    const std::size_t count = problem_->sources.size();
    std::vector<double> weighted_area(count, 0.0);
    for (std::size_t i = 0; i < interfaces_.size(); ++i)
        if (const auto& law = (*laws_)[i]; law.source >= 0)
            weighted_area[law.source] += law.heat_weight * interfaces_[i].area;

    source_loads_.assign(count, {});
    source_self_.assign(count, 0.0);
    source_to_oil_.assign(count, 0.0);
    source_constant_.assign(count, 0.0);
    oil_temperature_.clear();
    for (std::size_t i = 0; i < interfaces_.size(); ++i) {
        const auto& law = (*laws_)[i];
        auto& interface = interfaces_[i];
        interface.sum = law.film_a + law.film_b + law.oil;
        if (!(interface.sum > 0) || !std::isfinite(interface.sum))
            throw DomainError("interface '" + space_.machine.interfaces[i].name +
                              "' conducts nothing to either side nor to the oil; give it a conductance");
        oil_temperature_.push_back(law.oil_temperature);
        interface.heat_weight_area = interface.film_heat = 0;
        interface.load_zone = {};
        if (law.source < 0)
            continue;
        const double share = law.heat_weight * interface.area / weighted_area[law.source];
        interface.heat_weight_area = share;
        auto& load = source_loads_[law.source];
        if (law.heat_part >= 0) {
            add(load, part_means_[law.heat_part], share);
        } else {
            interface.film_heat = share;
            add(load, interface.mean_a, share * law.film_a / interface.sum);
            add(load, interface.mean_b, share * law.film_b / interface.sum);
            source_to_oil_[law.source] += share * law.oil / interface.sum;
            source_self_[law.source] += share * share / (interface.area * interface.sum);
        }
        if (law.load_zone)
            prepare_load_zone(i);
    }
    set_oil(std::vector<double>(oil_temperature_));
    leave_prescribed_alone();
}

void HeatSolver::for_each_point(int part,
                                const std::function<void(const Vec3&, double, const PointShape&)>& visit) const
{
    std::vector<dealii::types::global_dof_index> indices;
    dealii::hp::FEValues<3> values(space_.mappings, space_.elements, space_.quadratures,
                                   dealii::update_values | dealii::update_JxW_values |
                                       dealii::update_quadrature_points);
    PointShape shape;
    for (const auto& cell : space_.dofs.active_cell_iterators()) {
        if (static_cast<int>(cell->material_id()) != part)
            continue;
        indices.resize(cell->get_fe().n_dofs_per_cell());
        cell->get_dof_indices(indices);
        values.reinit(cell);
        const auto& v = values.get_present_fe_values();
        shape.count = static_cast<int>(indices.size());
        for (const auto q : v.quadrature_point_indices()) {
            for (std::size_t i = 0; i < indices.size(); ++i) {
                shape.dof[i] = static_cast<PetscInt>(indices[i]);
                shape.value[i] = v.shape_value(static_cast<unsigned>(i), q);
            }
            const auto& x = v.quadrature_point(q);
            visit({x[0], x[1], x[2]}, v.JxW(q), shape);
        }
    }
}

// One watt with the density of the load zone less one watt spread evenly, over the interface or the part's volume.
void HeatSolver::prepare_load_zone(std::size_t i)
{
    const auto& law = (*laws_)[i];
    auto& interface = interfaces_[i];
    std::vector<std::pair<PetscInt, double>> zone;
    double whole = 0;
    if (law.heat_part >= 0) {
        for_each_point(law.heat_part, [&](const Vec3& position, double weight, const PointShape& shape) {
            const double density = weight * law.load_zone(position);
            whole += density;
            append(zone, shape, density);
        });
        add(interface.load_zone, part_means_[law.heat_part], -1);
    } else {
        PointShape a, b;
        for (const auto& point : space_.machine.interfaces[i].points) {
            const double density = point.weight * law.load_zone(point.position_a);
            whole += density;
            space_.evaluate(point.face_a, point.position_a, false, a);
            space_.evaluate(point.face_b, point.position_b, false, b);
            append(zone, a, density * law.film_a / interface.sum);
            append(zone, b, density * law.film_b / interface.sum);
        }
        add(interface.load_zone, interface.mean_a, -law.film_a / interface.sum);
        add(interface.load_zone, interface.mean_b, -law.film_b / interface.sum);
    }
    if (!(whole > 0) || !std::isfinite(whole))
        throw DomainError("the load zone of interface '" + space_.machine.interfaces[i].name +
                          "' covers nothing of it; look at the joint's loads");
    add(interface.load_zone, space_.functional(zone), 1 / whole);
}

void HeatSolver::prepare_body_heat()
{
    const auto& machine = space_.machine;
    for (const auto& heat : problem_->body_heat) {
        SparseFunctional load;
        double whole = 0;
        for (const int part : heat.parts)
            whole += part_volume_[part];
        for (const int part : heat.parts)
            add(load, part_means_[part], part_volume_[part] / whole);
        if (heat.surface >= 0) {
            std::vector<std::pair<PetscInt, double>> entries;
            PointShape shape;
            for (const auto& [index, fraction, central] : machine.surfaces[heat.surface].faces)
                for (const auto& point : face_points(machine, machine.faces[index])) {
                    space_.evaluate(index, point.position, false, shape);
                    append(entries, shape, fraction * point.weight);
                    whole += fraction * point.weight;
                }
            add(load, space_.functional(entries), 1 / whole);
        }
        if (!(whole > 0))
            throw InputError("heat_sources." + heat.name + " has no volume and no surface to heat");
        body_loads_.push_back(std::move(load));
    }
}

void HeatSolver::prepare_films()
{
    const auto& machine = space_.machine;
    for (const auto& condition : problem_->surfaces) {
        if (condition.kind == SurfaceCondition::Kind::temperature)
            continue;
        Film film;
        film.condition = &condition;
        film.index = static_cast<std::size_t>(&condition - problem_->surfaces.data());
        std::vector<std::pair<PetscInt, double>> entries;
        const bool variable = condition.kind == SurfaceCondition::Kind::film && depends_on_temperature(condition);
        variable_films_ = variable_films_ || variable;
        PointShape shape;
        for (const auto& [index, fraction, central] : machine.surfaces[condition.surface].faces) {
            const bool mine = space_.cell(machine.faces[index].cell)->is_locally_owned();
            for (const auto& point : face_points(machine, machine.faces[index])) {
                space_.evaluate(index, point.position, false, shape);
                append(entries, shape, fraction * point.weight);
                film.area += fraction * point.weight;
                if (variable && mine)
                    film.points.push_back({without_zeros(shape), fraction * point.weight});
            }
        }
        film.integral = space_.functional(entries);
        films_.push_back(std::move(film));
    }
}

void HeatSolver::prepare_prescribed()
{
    some_prescribed_ = std::ranges::any_of(problem_->surfaces, [](const SurfaceCondition& condition) {
        return condition.kind == SurfaceCondition::Kind::temperature;
    });
    std::map<PetscInt, std::pair<Vec3, const SurfaceCondition*>> found;
    PointShape shape;
    for (const auto& condition : problem_->surfaces) {
        if (condition.kind != SurfaceCondition::Kind::temperature)
            continue;
        for (const auto& [index, fraction, central] : space_.machine.surfaces[condition.surface].faces) {
            if (!central)
                continue;
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
}

// The rank-one terms of the sources must not touch unknowns of prescribed temperature.
void HeatSolver::leave_prescribed_alone()
{
    shell_loads_ = source_loads_;
    for (auto& load : shell_loads_)
        for (std::size_t i = 0; i < load.local.size(); ++i)
            if (std::binary_search(prescribed_.begin(), prescribed_.end(), space_.first + load.local[i]))
                load.weight[i] = 0;
}

void HeatSolver::prepare_observers(const std::vector<Adjoint>& adjoints, double reference, Attribution attribution)
{
    adjoints_ = &adjoints;
    reference_ = reference;
    attribution_ = attribution;
    PointShape shape;
    for (const auto& probe : problem_->probes) {
        space_.evaluate_in_part(probe.part, probe.position, shape);
        std::vector<std::pair<PetscInt, double>> entries;
        append(entries, shape, 1);
        probes_.push_back(space_.functional(entries));
    }

    for (const auto& probe : probes_)
        watched_.push_back(&probe);
    for (const auto& interface : interfaces_) {
        watched_.push_back(&interface.mean_a);
        watched_.push_back(&interface.mean_b);
    }
    for (const auto& mean : part_means_)
        watched_.push_back(&mean);
}

}  // namespace deadpoint::fem
