#include "deadpoint/fem/conduction/terms/heat_functionals.hpp"

#include "deadpoint/error.hpp"
#include "deadpoint/exchange/face_points.hpp"
#include "deadpoint/exchange/heat.hpp"
#include "deadpoint/exchange/machine.hpp"
#include "deadpoint/fem/space/cell_values.hpp"

#include <algorithm>
#include <cmath>

namespace deadpoint::fem {
namespace {

using PointFunctional = std::vector<std::pair<PetscInt, double>>;

void append(PointFunctional& entries, const PointShape& shape, double factor)
{
    for (int i = 0; i < shape.count; ++i)
        entries.emplace_back(shape.dof[i], factor * shape.value[i]);
}

void add(SparseFunctional& sum, const SparseFunctional& term, double factor)
{
    sum.local.insert(sum.local.end(), term.local.begin(), term.local.end());
    for (const double weight : term.weight)
        sum.weight.push_back(factor * weight);
}

}  // namespace

double value_at(const PointShape& shape, const double* values)
{
    double at = 0;
    for (int i = 0; i < shape.count; ++i)
        at += shape.value[i] * values[shape.dof[i]];
    return at;
}

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

HeatFunctionals::HeatFunctionals(const Discretisation& space, const HeatProblem& problem) : space_(space)
{
    auto& layout = geometry_.layout;
    layout.interfaces = space.machine.interfaces.size();
    layout.parts = space.machine.parts.size();
    layout.surfaces = problem.surfaces.size();
    layout.bodies = problem.body_heat.size();
    all_.resize(layout.count());
    prepare_parts();
    prepare_interfaces();
    prepare_surfaces(problem);
    prepare_bodies(problem);
    prepare_probes(problem);
}

void HeatFunctionals::adopt(const HeatProblem& problem) { prepare_probes(problem); }

// Mean temperature and volume of each part.
void HeatFunctionals::prepare_parts()
{
    const std::size_t count = geometry_.layout.parts;
    std::vector<PointFunctional> means(count);
    std::vector<PetscInt> unknowns;
    CellValues v(space_);
    const auto is_owned = [&](PetscInt unknown) { return space_.owns(unknown); };
    for (std::uint32_t cell = space_.first_cell; cell < space_.machine.cells.size(); ++cell) {
        space_.unknowns_of(cell, unknowns);
        if (std::ranges::none_of(unknowns, is_owned))
            continue;
        v.reinit(cell);
        for (const auto q : v.quadrature_point_indices())
            for (const auto i : v.dof_indices())
                means[static_cast<std::size_t>(space_.part_of(cell))].emplace_back(unknowns[i],
                                                                                   v.shape_value(i, q) * v.JxW(q));
    }
    part_volume_.assign(count, 0.0);
    for (std::size_t p = 0; p < count; ++p) {
        auto& mean = all_[geometry_.layout.part(p)];
        mean = space_.functional(means[p]);
        for (const double w : mean.weight)
            part_volume_[p] += w;
    }
    sum_over_ranks(part_volume_);
    for (std::size_t p = 0; p < count; ++p)
        for (double& w : all_[geometry_.layout.part(p)].weight)
            w /= part_volume_[p];
}

void HeatFunctionals::prepare_interfaces()
{
    for (std::size_t i = 0; i < geometry_.layout.interfaces; ++i) {
        const auto& contact = space_.machine.interfaces[i];
        geometry_.interface_names.push_back(contact.name);
        geometry_.interface_area.push_back(contact.area);
        PointFunctional a, b;
        PointShape shape_a, shape_b;
        for (const auto& point : contact.points) {
            space_.evaluate(point.face_a, point.position_a, false, shape_a);
            space_.evaluate(point.face_b, point.position_b, false, shape_b);
            append(a, shape_a, point.weight / contact.area);
            append(b, shape_b, point.weight / contact.area);
        }
        all_[geometry_.layout.mean(i, false)] = space_.functional(a);
        all_[geometry_.layout.mean(i, true)] = space_.functional(b);
    }
}

void HeatFunctionals::prepare_surfaces(const HeatProblem& problem)
{
    const auto& machine = space_.machine;
    geometry_.surface_area.assign(problem.surfaces.size(), 0.0);
    PointShape shape;
    for (std::size_t s = 0; s < problem.surfaces.size(); ++s) {
        const auto& condition = problem.surfaces[s];
        if (condition.kind == SurfaceCondition::Kind::temperature)
            continue;
        PointFunctional entries;
        for (const auto& [index, fraction, central] : faces_of(machine, condition))
            for (const auto& point : face_points(machine, machine.faces[index])) {
                space_.evaluate(index, point.position, false, shape);
                append(entries, shape, fraction * point.weight);
                geometry_.surface_area[s] += fraction * point.weight;
            }
        all_[geometry_.layout.surface(s)] = space_.functional(entries);
    }
}

void HeatFunctionals::prepare_bodies(const HeatProblem& problem)
{
    const auto& machine = space_.machine;
    for (std::size_t k = 0; k < problem.body_heat.size(); ++k) {
        const auto& heat = problem.body_heat[k];
        auto& load = all_[geometry_.layout.body(k)];
        double whole = 0;
        for (const int part : heat.parts)
            whole += part_volume_[part];
        for (const int part : heat.parts)
            add(load, all_[geometry_.layout.part(static_cast<std::size_t>(part))], part_volume_[part] / whole);
        if (heat.surface >= 0) {
            PointFunctional entries;
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
    }
}

void HeatFunctionals::prepare_probes(const HeatProblem& problem)
{
    auto& layout = geometry_.layout;
    layout.probes = problem.probes.size();
    all_.resize(layout.count());
    PointShape shape;
    for (std::size_t k = 0; k < problem.probes.size(); ++k) {
        space_.evaluate_in_part(problem.probes[k].part, problem.probes[k].position, shape);
        PointFunctional entries;
        append(entries, shape, 1);
        all_[layout.probe(k)] = space_.functional(entries);
    }
}

void HeatFunctionals::for_each_point(int part,
                                     const std::function<void(const Vec3&, double, const PointShape&)>& visit) const
{
    const auto& range = space_.machine.parts[static_cast<std::size_t>(part)];
    std::vector<PetscInt> unknowns;
    CellValues v(space_);
    PointShape shape;
    for (std::uint32_t cell = range.first_cell; cell < range.first_cell + range.cell_count; ++cell) {
        space_.unknowns_of(cell, unknowns);
        v.reinit(cell);
        shape.count = static_cast<int>(unknowns.size());
        std::ranges::copy(unknowns, shape.dof.begin());
        for (const auto q : v.quadrature_point_indices()) {
            for (const auto i : v.dof_indices())
                shape.value[i] = v.shape_value(i, q);
            visit(v.quadrature_point(q), v.JxW(q), shape);
        }
    }
}

void HeatFunctionals::set_zones(const std::vector<InterfaceLaw>& laws)
{
    for (std::size_t i = 0; i < laws.size(); ++i)
        prepare_zone(i, laws[i]);
}

// One watt with the density of the load zone minus one watt spread evenly, over the interface or the part's volume.
void HeatFunctionals::prepare_zone(std::size_t i, const InterfaceLaw& law)
{
    for (const bool side_b : {false, true})
        all_[geometry_.layout.zone(i, side_b)] = {};
    if (law.source < 0 || !law.load_zone)
        return;
    if (law.heat_part >= 0)
        prepare_volume_zone(i, law);
    else
        prepare_film_zone(i, law);
}

void HeatFunctionals::require_zone(std::size_t i, double whole) const
{
    if (!(whole > 0) || !std::isfinite(whole))
        throw DomainError("the load zone of interface '" + geometry_.interface_names[i] +
                          "' covers nothing of it; look at the joint's loads");
}

void HeatFunctionals::prepare_volume_zone(std::size_t i, const InterfaceLaw& law)
{
    PointFunctional entries;
    double whole = 0;
    for_each_point(law.heat_part, [&](const Vec3& position, double weight, const PointShape& shape) {
        const double density = weight * law.load_zone(position);
        whole += density;
        append(entries, shape, density);
    });
    require_zone(i, whole);
    auto& zone = all_[geometry_.layout.zone(i, false)];
    add(zone, all_[geometry_.layout.part(static_cast<std::size_t>(law.heat_part))], -1);
    add(zone, space_.functional(entries), 1 / whole);
}

void HeatFunctionals::prepare_film_zone(std::size_t i, const InterfaceLaw& law)
{
    PointFunctional of_a, of_b;
    double whole = 0;
    PointShape shape;
    for (const auto& point : space_.machine.interfaces[i].points) {
        const double density = point.weight * law.load_zone(point.position_a);
        whole += density;
        space_.evaluate(point.face_a, point.position_a, false, shape);
        append(of_a, shape, density);
        space_.evaluate(point.face_b, point.position_b, false, shape);
        append(of_b, shape, density);
    }
    require_zone(i, whole);
    for (const bool side_b : {false, true}) {
        auto& zone = all_[geometry_.layout.zone(i, side_b)];
        add(zone, all_[geometry_.layout.mean(i, side_b)], -1);
        add(zone, space_.functional(side_b ? of_b : of_a), 1 / whole);
    }
}

std::vector<double> HeatFunctionals::evaluate(std::span<const std::size_t> which, Vec vector) const
{
    std::vector<const SparseFunctional*> functionals;
    for (const std::size_t index : which)
        functionals.push_back(&all_[index]);
    return fem::evaluate(functionals, vector);
}

void HeatFunctionals::add_loads(const std::vector<double>& watts, Vec vector) const
{
    for (std::size_t k = 0; k < watts.size(); ++k)
        if (watts[k] != 0)
            add_to(vector, all_[k], watts[k]);
}

}  // namespace deadpoint::fem
