#include "deadpoint/exchange/face_points.hpp"
#include "deadpoint/fem/elastic/elastic_cells.hpp"
#include "deadpoint/fem/elastic/elastic_solver.hpp"
#include "deadpoint/fem/elastic/rigid_pieces.hpp"
#include "deadpoint/fem/space/discretisation.hpp"
#include "deadpoint/fem/space/fields.hpp"

#include <algorithm>
#include <limits>

namespace deadpoint::fem {
namespace {

// The longest range along the axis without a bond, minus a quarter at either end.
std::pair<double, double> free_length(const Machine& machine, int part, std::size_t axis)
{
    std::vector<double> places;
    for (const auto& bond : machine.bonds)
        for (const auto& point : bond.points) {
            if (static_cast<int>(machine.faces[point.face_a].part) == part)
                places.push_back(point.position_a[axis]);
            else if (static_cast<int>(machine.faces[point.face_b].part) == part)
                places.push_back(point.position_b[axis]);
        }
    std::ranges::sort(places);
    double from = 0, length = 0;
    for (std::size_t i = 0; i + 1 < places.size(); ++i)
        if (places[i + 1] - places[i] > length) {
            from = places[i];
            length = places[i + 1] - places[i];
        }
    double lowest = std::numeric_limits<double>::max(), highest = std::numeric_limits<double>::lowest();
    const auto& mesh = machine.parts[static_cast<std::size_t>(part)];
    for (std::uint32_t c = mesh.first_cell; c < mesh.first_cell + mesh.cell_count; ++c)
        for (unsigned i = 0; i < (machine.cells[c].kind == CellKind::hexahedron ? 8U : 4U); ++i) {
            lowest = std::min(lowest, machine.nodes[machine.cells[c].nodes[i]][axis]);
            highest = std::max(highest, machine.nodes[machine.cells[c].nodes[i]][axis]);
        }
    if (length < 0.25 * (highest - lowest))
        throw InputError("rod '" + mesh.name + "' is not bonded at two ends along the " + "xyz"[axis] +
                         " axis, so it cannot be preloaded; let it touch the machine at its nuts only, and see the "
                         "bonded pairs of `deadpoint check`");
    return {from + 0.25 * length, from + 0.75 * length};
}

}  // namespace

// Virtual displacement along the axis: 0 below the free length, 1 above it, linear between.
ElasticSolver::Gauge ElasticSolver::describe_rod(const ForceGauge& gauge) const
{
    const auto& machine = space_.machine;
    const auto axis = static_cast<std::size_t>(gauge.axis);
    const auto [from, to] = free_length(machine, gauge.index, axis);
    const auto& part = machine.parts[static_cast<std::size_t>(gauge.index)];
    Gauge result{std::vector<double>(static_cast<std::size_t>(3 * space_.total)), false, part.cut ? 2.0 : 1.0};
    std::vector<std::size_t> unknowns;
    std::vector<Vec3> positions(static_cast<std::size_t>(space_.total));
    for (std::uint32_t c = part.first_cell; c < part.first_cell + part.cell_count; ++c) {
        space_.cell_nodes(c, unknowns, positions);
        for (const auto node : unknowns)
            result.shape[3 * node + axis] = std::clamp((positions[node][axis] - from) / (to - from), 0.0, 1.0);
    }
    return result;
}

// A finer part's node that follows a node of `shape` brings its forces along. Followers come after their masters.
void ElasticSolver::pass_on(std::vector<double>& shape) const
{
    for (const auto& tie : ties_.ties())
        for (const auto& [master, weight] : tie.masters)
            for (PetscInt c = 0; c < 3; ++c)
                if (ties_.follows(tie.node, c))
                    shape[3 * static_cast<std::size_t>(tie.node) + c] +=
                        weight * shape[3 * static_cast<std::size_t>(master) + c];
}

// The bond opens by 1 along its normal: the work is that of the ties' forces.
ElasticSolver::Gauge ElasticSolver::describe_bond(int bond) const
{
    const auto& machine = space_.machine;
    const auto& contact = machine.bonds[static_cast<std::size_t>(bond)];
    const bool whole = machine.parts[contact.part_a].cut && machine.parts[contact.part_b].cut;
    Gauge result{std::vector<double>(static_cast<std::size_t>(3 * space_.total)), true, whole ? 2.0 : 1.0};
    for (const auto& tie : ties_.ties())
        for (const auto& opening : tie.openings)
            for (PetscInt c = 0; c < 3; ++c)
                if (opening.bond == bond && ties_.follows(tie.node, c))
                    result.shape[3 * static_cast<std::size_t>(tie.node) + c] = opening.normal[c];
    pass_on(result.shape);
    return result;
}

ElasticSolver::Gauge ElasticSolver::describe_feet() const
{
    Gauge result{std::vector<double>(static_cast<std::size_t>(3 * space_.total)), true,
                 space_.machine.half_model ? 2.0 : 1.0};
    if (foundation_.kind == Foundation::Kind::elastic)
        return result;
    for (const PetscInt unknown : feet_)
        if (const double normal = foot_normal_[static_cast<std::size_t>(unknown % 3)];
            normal != 0 && !ties_.follows(unknown / 3, unknown % 3))
            result.shape[static_cast<std::size_t>(unknown)] = -normal;
    pass_on(result.shape);
    return result;
}

ElasticSolver::Gauge ElasticSolver::describe(const ForceGauge& gauge) const
{
    if (gauge.kind == ForceGauge::Kind::rod)
        return describe_rod(gauge);
    return gauge.kind == ForceGauge::Kind::bond ? describe_bond(gauge.index) : describe_feet();
}

Functional ElasticSolver::pad_force() const
{
    Functional result{"feet", {}};
    if (foundation_.surface < 0 || foundation_.kind != Foundation::Kind::elastic)
        return result;
    for (const auto& foot : space_.machine.surfaces[foundation_.surface].faces)
        for (const auto& point : face_points(space_.machine, space_.machine.faces[foot.face]))
            result.points.push_back(
                {foot.face, point.position, (foundation_.vertical * foot.fraction * point.weight) * foot_normal_});
    return result;
}

void ElasticSolver::stiffness_times(const std::vector<double>& shape, Vec target) const
{
    std::vector<double> block, cell_load, local;
    DEADPOINT_PETSC(VecSet(target, 0));
    for_each_cell(space_, [&](const CellValues& v, const auto& dofs, int part) {
        const std::size_t n = 3 * dofs.size();
        local.resize(n);
        for (std::size_t i = 0; i < n; ++i)
            local[i] = shape[3 * dofs[i / 3] + i % 3];
        if (std::ranges::all_of(local, [](double value) { return value == 0; }))
            return;
        cell_stiffness(v, materials_[part], block);
        cell_load.assign(n, 0.0);
        for (std::size_t i = 0; i < n; ++i)
            for (std::size_t j = 0; j < n; ++j)
                cell_load[i] += block[i * n + j] * local[j];
        add_to_cell(target, dofs, cell_load);
    });
    finish(target);
}

// The force is  c . (K u - f(T))  with u = K^-1 f(T) on what is free, so its weights on f are K^-1 K c - c.
std::vector<Adjoint> ElasticSolver::adjoints(const std::vector<ForceGauge>& gauges)
{
    std::vector<Adjoint> result;
    Pending pending;
    Gathered gathered(solution_);
    const auto load_gauge = [&](std::size_t k) {
        if (gauges[k].kind == ForceGauge::Kind::feet && foundation_.kind == Foundation::Kind::elastic)
            load(pad_force(), rhs_);
        else
            stiffness_times(describe(gauges[k]).shape, rhs_);
        pieces_->equilibrate(rhs_);
    };
    solve_all(gauges.size(), "the adjoint of a force", load_gauge, [&](std::size_t k) {
        const auto described = describe(gauges[k]);
        const double* solved = gathered.gather(solution_);
        std::vector<double> weights(described.shape.size());
        for (std::size_t i = 0; i < weights.size(); ++i)
            weights[i] = described.factor * (solved[i] - described.shape[i]);
        add_adjoint(pending, gauges[k].name, std::move(weights), result);
    });
    finish_adjoints(pending, result);
    return result;
}

std::vector<double> ElasticSolver::forces(const std::vector<ForceGauge>& gauges, const RestLoads& loads,
                                          const Displacement& displacement)
{
    OwnedVec strained = create_vector(space_, 3), weight = create_vector(space_, 3);
    load_initial_strain(loads.initial_strain, strained);
    load_weight(loads.gravity, weight);
    const double *strained_at = nullptr, *weight_at = nullptr, *stiff = nullptr;
    DEADPOINT_PETSC(VecGetArrayRead(strained, &strained_at));
    DEADPOINT_PETSC(VecGetArrayRead(weight, &weight_at));
    std::vector<double> sums;
    for (const auto& gauge : gauges) {
        const auto described = describe(gauge);
        stiffness_times(described.shape, rhs_);
        DEADPOINT_PETSC(VecGetArrayRead(rhs_, &stiff));
        double sum = 0;
        for (std::size_t i = 0; i < displacement.owned.size(); ++i) {
            const double shape = described.shape[i + static_cast<std::size_t>(3 * space_.first)];
            sum += stiff[i] * displacement.owned[i] -
                   shape * (strained_at[i] + (described.with_weight ? weight_at[i] : 0));
        }
        DEADPOINT_PETSC(VecRestoreArrayRead(rhs_, &stiff));
        sums.push_back(described.factor * sum);
    }
    DEADPOINT_PETSC(VecRestoreArrayRead(strained, &strained_at));
    DEADPOINT_PETSC(VecRestoreArrayRead(weight, &weight_at));
    sum_over_ranks(sums);
    const double on_pads = evaluate({pad_force()}, displacement)[0];
    for (std::size_t k = 0; k < gauges.size(); ++k)
        if (gauges[k].kind == ForceGauge::Kind::feet && foundation_.kind == Foundation::Kind::elastic)
            sums[k] = (space_.machine.half_model ? 2 : 1) * on_pads;
    return sums;
}

}  // namespace deadpoint::fem
