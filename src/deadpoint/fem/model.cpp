#include "deadpoint/fem/model.hpp"

#include "deadpoint/core/units.hpp"
#include "deadpoint/exchange/decimated_surface.hpp"
#include "deadpoint/exchange/heat_causes.hpp"
#include "deadpoint/fem/algebra/session.hpp"
#include "deadpoint/fem/conduction/checkpoint.hpp"
#include "deadpoint/fem/conduction/heat_solver.hpp"
#include "deadpoint/fem/conduction/thermal_state.hpp"
#include "deadpoint/fem/elastic/elastic_solver.hpp"
#include "deadpoint/fem/elastic/rigid_pieces.hpp"
#include "deadpoint/fem/elastic/stress_recovery.hpp"
#include "deadpoint/fem/estimate/error_estimate.hpp"
#include "deadpoint/fem/reduction/field_file.hpp"
#include "deadpoint/fem/reduction/heat_projector.hpp"
#include "deadpoint/fem/space/discretisation.hpp"
#include "deadpoint/fem/space/expansion.hpp"
#include "deadpoint/fem/transfer/fitted_transfer.hpp"
#include "deadpoint/fem/transfer/transfer.hpp"
#include "deadpoint/io/vtu.hpp"
#include "deadpoint/observer.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace deadpoint::fem {

/// A separate mesh of the deformation, and the transfers to it and back.
struct OwnMesh {
    OwnMesh(const Machine& machine, std::vector<int> orders, const Discretisation& heat)
        : space(machine, std::move(orders)), values(heat, space), back(space, heat), to(heat, space, values, back)
    {}
    Discretisation space;
    Transfer values;
    Transfer back;
    FittedTransfer to;
};

struct Model::Implementation {
    Implementation(const Machine& machine_, std::vector<Material> materials_, std::vector<int> orders,
                   const Machine* deformation_, std::vector<int> deformation_orders)
        : machine(machine_), materials(std::move(materials_)), space(machine, std::move(orders)),
          expansion(space, materials)
    {
        if (deformation_)
            own = std::make_unique<OwnMesh>(
                *deformation_, deformation_orders.empty() ? space.orders : std::move(deformation_orders), space);
    }
    [[nodiscard]] const Discretisation& deformed() const { return own ? own->space : space; }
    ElasticSolver& deformation()
    {
        if (!elastic)
            elastic = std::make_unique<ElasticSolver>(deformed(), materials, foundation);
        return *elastic;
    }
    /// Transfers a field of the heat mesh to the unknowns of the deformation.
    [[nodiscard]] Field where_deformed(const Field& field) const
    {
        return own ? Field{own->to.apply(field.owned)} : field;
    }
    /// Transfers a displacement to the unknowns of the heat mesh.
    [[nodiscard]] std::vector<double> on_heat_mesh(const Displacement& u) const
    {
        return own ? own->back.apply(u.owned, 3) : u.owned;
    }
    /// Converts weights to weights on the temperatures of the heat mesh.
    [[nodiscard]] std::vector<Adjoint> on_heat_mesh(std::vector<Adjoint> adjoints) const
    {
        if (own)
            for (auto& adjoint : adjoints)
                adjoint.owned = own->to.apply_transposed(adjoint.owned);
        return adjoints;
    }
    const Machine& machine;
    std::vector<Material> materials;
    Discretisation space;
    std::unique_ptr<OwnMesh> own;  ///< mesh of the deformation, if it differs
    Expansion expansion;
    std::unique_ptr<ElasticSolver> elastic;
    std::unique_ptr<HeatSolver> heat;
    std::unique_ptr<HeatSolver> finished;
    ThermalState last;
    Foundation foundation;
    int elastic_iterations = 0;
};

namespace {

// Each rank meshes the machine itself; a difference between ranks must be an error.
void require_same_mesh(const Machine& machine)
{
    double sum = static_cast<double>(machine.cells.size());
    for (std::size_t i = 0; i < machine.nodes.size(); ++i)
        sum += dot(machine.nodes[i], {1.0, std::numbers::pi, std::numbers::e}) * static_cast<double>(1 + i % 1021);
    std::array<double, 2> range{sum, -sum};
    MPI_Allreduce(MPI_IN_PLACE, range.data(), 2, MPI_DOUBLE, MPI_MIN, PETSC_COMM_WORLD);
    if (range[0] != -range[1])
        throw InputError("the ranks built different meshes; run with one rank, and please report the case");
}

// Also of a table.
bool is_positive(const Material& material, double Material::*constant, const LinearCurve& table)
{
    const auto sound = [](double value) { return value > 0 && std::isfinite(value); };
    return sound(material.*constant) && std::ranges::all_of(table.y(), sound);
}

void require_sound(const Machine& machine, const std::vector<Material>& materials, const std::vector<int>& orders)
{
    if (machine.cells.empty())
        throw InputError("the machine has no cells");
    if (materials.size() != machine.parts.size())
        throw InputError("one material is needed per part");
    if (orders.size() != machine.parts.size() || std::ranges::any_of(orders, [](int o) { return o < 1 || o > 2; }))
        throw InputError("one order of elements, 1 or 2, is needed per part");
    for (std::size_t p = 0; p < materials.size(); ++p) {
        const auto& m = materials[p];
        if (!is_positive(m, &Material::density, {}) || !is_positive(m, &Material::youngs_modulus, {}) ||
            !is_positive(m, &Material::conductivity, m.conductivity_table) ||
            !is_positive(m, &Material::specific_heat, m.specific_heat_table))
            throw InputError("the material of part '" + machine.parts[p].name +
                             "' has a density, conductivity, specific heat or Young's modulus that is not positive");
    }
}

// Data for the stress recovery, on every rank.
class GatheredState {
public:
    GatheredState(const Discretisation& space, const Displacement& displacement, const Field& rise)
        : displacement_(gather_all(space, displacement.owned, 3)), rise_(gather_all(space, rise.owned, 1))
    {
        state_.displacement = displacement_.data();
        state_.rise = rise_.data();
    }
    GatheredState(const Discretisation& space, const Displacement& displacement, const RestLoads& loads)
        : displacement_(gather_all(space, displacement.owned, 3))
    {
        state_.displacement = displacement_.data();
        state_.initial = loads.initial_strain;
    }
    GatheredState(const GatheredState&) = delete;
    [[nodiscard]] const StrainedState& state() const { return state_; }

private:
    std::vector<double> displacement_, rise_;
    StrainedState state_;
};

std::vector<PartStress> stress_of(const Discretisation& space, const std::vector<Material>& materials,
                                  const std::vector<int>& parts, const StrainedState& state)
{
    std::vector<PartStress> result;
    for (const int part : parts) {
        const StressRecovery recovery(space, materials[part], part, state);
        auto& entry = result.emplace_back(PartStress{part, recovery.nodes(), {}});
        for (std::size_t i = 0; i < entry.nodes.size(); ++i)
            entry.stress.push_back(recovery.at_node(i));
    }
    return result;
}

ThermalState start_of(const HeatProblem& problem, Field temperature)
{
    ThermalState start{std::move(temperature), {}, {}};
    for (const auto& circuit : problem.oil)
        start.sumps.push_back(circuit.sump_start);
    for (const auto& enclosure : problem.enclosures)
        start.enclosures.push_back(enclosure.start);
    return start;
}

// Entries of a distributed vector of `block` values per unknown at nodes of the mesh, on all ranks.
std::vector<double> gathered(const Discretisation& space, const std::vector<CellCorner>& corners,
                             const std::vector<double>& owned, std::size_t block)
{
    std::vector<double> values(block * corners.size(), 0.0);
    for (std::size_t k = 0; k < corners.size(); ++k) {
        const auto unknown = static_cast<PetscInt>(space.vertex_unknown(corners[k].cell, corners[k].corner));
        if (space.owns(unknown))
            for (std::size_t i = 0; i < block; ++i)
                values[block * k + i] = owned[block * static_cast<std::size_t>(unknown - space.first) + i];
    }
    sum_over_ranks(values);
    return values;
}

}  // namespace

Model::Model(const Machine& machine, std::vector<Material> materials, std::vector<int> orders, Observer&,
             const Machine* deformation, std::vector<int> deformation_orders)
{
    require_sound(machine, materials, orders);
    require_same_mesh(machine);
    if (deformation)
        require_same_mesh(*deformation);
    implementation_ = std::make_unique<Implementation>(machine, std::move(materials), std::move(orders), deformation,
                                                       std::move(deformation_orders));
}
Model::Model(const Machine& machine, std::vector<Material> materials, int order, Observer& observer,
             const Machine* deformation)
    : Model(machine, std::move(materials), std::vector<int>(machine.parts.size(), order), observer, deformation)
{}
Model::~Model() = default;
Model::Model(Model&&) noexcept = default;

ModelSize Model::size() const
{
    const auto& deformed = implementation_->deformed();
    return {static_cast<long long>(implementation_->machine.cells.size()), implementation_->space.total,
            static_cast<long long>(deformed.machine.cells.size()), 3LL * deformed.total};
}

void Model::assemble_heat(const HeatProblem& problem)
{
    auto& heat = implementation_->heat;
    if (!heat || !heat->adopt(problem))
        heat = std::make_unique<HeatSolver>(implementation_->space, implementation_->materials, problem);
    Field start;
    const auto points = implementation_->space.support_points();
    const auto parts = implementation_->space.part_of_unknown();
    for (std::size_t i = 0; i < points.size(); ++i)
        start.owned.push_back(problem.initial_temperature(static_cast<int>(parts[i]), points[i]));
    heat->start_from(start_of(problem, std::move(start)));
}

ThermalHistory Model::heat(const std::vector<Adjoint>& adjoints, double reference_temperature, Attribution attribution,
                           Observer& observer, const StepCallback& on_step, const FieldCallback& on_field,
                           const CheckpointPlan* checkpoints)
{
    release_heat();
    auto solver = std::move(implementation_->heat);
    if (!solver)
        throw std::logic_error("Model::heat() needs assemble_heat() before it");
    auto history = solver->run(adjoints, reference_temperature, attribution, observer, on_step, on_field, checkpoints);
    implementation_->last = solver->state();
    implementation_->finished = std::move(solver);
    return history;
}

HeatCauses Model::heat_causes(const Adjoint& weights, std::size_t row)
{
    if (!implementation_->finished)
        throw std::logic_error("Model::heat_causes() needs heat() before it");
    return implementation_->finished->causes(weights.owned, row);
}

HeatCauses Model::heat_causes_on_basis(const Adjoint& weights, std::size_t row)
{
    if (!implementation_->finished)
        throw std::logic_error("Model::heat_causes_on_basis() needs heat() before it");
    return implementation_->finished->causes_on_basis(weights.owned, row);
}

void Model::release_heat() { implementation_->finished.reset(); }

std::unique_ptr<HeatProjector> Model::projector(const HeatProblem& problem, const std::vector<Adjoint>& observed,
                                                Attribution attribution, long long largest_factor)
{
    return std::make_unique<HeatProjector>(implementation_->space, implementation_->materials, problem,
                                           ObservedAdjoints{observed, attribution}, largest_factor);
}

StateFields Model::read_fields(const std::string& file, const std::string& model, std::size_t states) const
{
    return fem::read_fields(file, implementation_->space, model, states);
}

void Model::start_from(const std::string& file)
{
    if (!implementation_->heat)
        throw std::logic_error("Model::start_from() needs assemble_heat() before it");
    implementation_->heat->start_from(read_thermal_state(file, implementation_->space, implementation_->heat->state()));
}

void Model::write_state(const std::string& file) const
{
    write_thermal_state(file, implementation_->space, implementation_->last);
}

void Model::support(const Foundation& foundation)
{
    implementation_->foundation = foundation;
    release_elasticity();
}

std::vector<Adjoint> Model::adjoints(const std::vector<Functional>& functionals)
{
    return implementation_->on_heat_mesh(implementation_->deformation().adjoints(functionals));
}

std::vector<Adjoint> Model::adjoints(const std::vector<ForceGauge>& gauges)
{
    return implementation_->on_heat_mesh(implementation_->deformation().adjoints(gauges));
}

Displacement Model::displacement(const RestLoads& loads) { return implementation_->deformation().displacement(loads); }

std::vector<double> Model::forces(const std::vector<ForceGauge>& gauges, const RestLoads& loads,
                                  const Displacement& displacement)
{
    return implementation_->deformation().forces(gauges, loads, displacement);
}

Displacement Model::displacement(const Field& temperature, double reference_temperature)
{
    return displacement_of_rise(expansion_rise(temperature, reference_temperature));
}

std::vector<double> Model::evaluate(const std::vector<Functional>& functionals, const Displacement& displacement)
{
    return implementation_->deformation().evaluate(functionals, displacement);
}

double Model::apply(const Adjoint& adjoint, const Field& temperature, double reference_temperature)
{
    std::vector<double> sum{0};
    for (std::size_t i = 0; i < adjoint.owned.size(); ++i)
        sum[0] += adjoint.owned[i] * implementation_->expansion.rise(i, temperature.owned[i], reference_temperature);
    sum_over_ranks(sum);
    return sum[0];
}

bool Model::expands_linearly() const { return implementation_->expansion.linear(); }

Field Model::expansion_rise(const Field& temperature, double reference_temperature) const
{
    Field rise;
    for (std::size_t i = 0; i < temperature.owned.size(); ++i)
        rise.owned.push_back(implementation_->expansion.rise(i, temperature.owned[i], reference_temperature));
    return rise;
}

Displacement Model::displacement_of_rise(const Field& rise)
{
    return implementation_->deformation().displacement(implementation_->where_deformed(rise));
}

std::vector<Displacement> Model::displacements_of_rises(const std::vector<Field>& rises)
{
    std::vector<Field> deformed;
    for (const auto& rise : rises)
        deformed.push_back(implementation_->where_deformed(rise));
    return implementation_->deformation().displacements(deformed);
}

Adjoint Model::secant(const Adjoint& adjoint, const Field& temperature, double reference_temperature)
{
    auto result = adjoint;
    for (std::size_t i = 0; i < result.owned.size(); ++i)
        result.owned[i] *= implementation_->expansion.secant(i, temperature.owned[i], reference_temperature);
    return result;
}

std::vector<PartStress> Model::stress(const std::vector<int>& parts, const Displacement& displacement,
                                      const Field& temperature, double reference_temperature) const
{
    const auto& space = implementation_->deformed();
    const GatheredState fields(space, displacement,
                               implementation_->where_deformed(expansion_rise(temperature, reference_temperature)));
    return stress_of(space, implementation_->materials, parts, fields.state());
}

std::vector<PartStress> Model::stress(const std::vector<int>& parts, const Displacement& displacement,
                                      const RestLoads& loads) const
{
    const auto& space = implementation_->deformed();
    const GatheredState fields(space, displacement, loads);
    return stress_of(space, implementation_->materials, parts, fields.state());
}

std::vector<Tensor6> Model::stress_at(const std::vector<HeatProbe>& points, const Displacement& displacement,
                                      const Field& temperature, double reference_temperature) const
{
    const auto& space = implementation_->deformed();
    const GatheredState fields(space, displacement,
                               implementation_->where_deformed(expansion_rise(temperature, reference_temperature)));
    std::vector<Tensor6> result;
    for (const auto& point : points)
        result.push_back(StressRecovery(space, implementation_->materials[point.part], point.part, fields.state())
                             .at(point.position));
    return result;
}

void Model::release_elasticity()
{
    implementation_->elastic_iterations = elastic_iterations();
    implementation_->elastic.reset();
}

int Model::elastic_iterations() const
{
    return implementation_->elastic_iterations +
           (implementation_->elastic ? implementation_->elastic->iterations() : 0);
}

Field Model::constant_field(double temperature) const
{
    const auto& space = implementation_->space;
    return {std::vector<double>(static_cast<std::size_t>(space.last - space.first), temperature)};
}

Field Model::interpolate_field(const std::function<double(const Vec3&)>& temperature) const
{
    Field field;
    for (const auto& point : implementation_->space.support_points())
        field.owned.push_back(temperature(point));
    return field;
}

std::vector<Field> Model::heat_adjoints(const HeatProblem& problem, double time, const Field& temperature,
                                        const std::vector<Adjoint>& weights)
{
    HeatSolver solver(implementation_->space, implementation_->materials, problem);
    solver.start_from(start_of(problem, temperature));
    return solver.duals(time, temperature, weights);
}

Adjoint Model::probe_weights(const HeatProbe& probe)
{
    const auto& space = implementation_->space;
    PointShape shape;
    space.evaluate_in_part(probe.part, probe.position, shape);
    Adjoint result{probe.name, std::vector<double>(static_cast<std::size_t>(space.last - space.first), 0.0)};
    for (int i = 0; i < shape.count; ++i)
        if (space.owns(shape.dof[i]))
            result.owned[static_cast<std::size_t>(shape.dof[i] - space.first)] += shape.value[i];
    return result;
}

Displacement Model::deformation_adjoint(const Functional& functional)
{
    return implementation_->deformation().dual(functional);
}

std::vector<std::vector<double>> Model::conduction_errors(const Field& temperature, const std::vector<Field>& duals)
{
    return fem::conduction_errors(implementation_->space, implementation_->materials, temperature, duals);
}

std::vector<std::vector<double>> Model::deformation_errors(const Displacement& displacement,
                                                           const std::vector<Displacement>& duals)
{
    return fem::deformation_errors(implementation_->deformed(), implementation_->materials, displacement, duals);
}

std::vector<double> Model::interpolation_errors(const Field& temperature, const std::vector<HeatProbe>& probes)
{
    return fem::interpolation_errors(implementation_->space, temperature, probes);
}

std::vector<double> Model::sample(const std::vector<HeatProbe>& probes, const Field& field)
{
    const auto& space = implementation_->space;
    std::vector<double> values(probes.size(), 0.0);
    PointShape shape;
    for (std::size_t k = 0; k < probes.size(); ++k) {
        space.evaluate_in_part(probes[k].part, probes[k].position, shape);
        for (int i = 0; i < shape.count; ++i)
            if (space.owns(shape.dof[i]))
                values[k] += shape.value[i] * field.owned[static_cast<std::size_t>(shape.dof[i] - space.first)];
    }
    sum_over_ranks(values);
    return values;
}

std::vector<double> Model::at_corners(const std::vector<CellCorner>& corners, const Field& field) const
{
    return gathered(implementation_->space, corners, field.owned, 1);
}

std::vector<Vec3> Model::at_corners(const std::vector<CellCorner>& corners, const Displacement& displacement) const
{
    const auto values = gathered(implementation_->space, corners, implementation_->on_heat_mesh(displacement), 3);
    std::vector<Vec3> result(corners.size());
    for (std::size_t k = 0; k < corners.size(); ++k)
        result[k] = {values[3 * k], values[3 * k + 1], values[3 * k + 2]};
    return result;
}

namespace {

/// Content of a field file: values at all unknowns, and data of each part.
struct ShownFields {
    std::vector<double> temperature;   ///< [K]
    std::vector<double> displacement;  ///< three per unknown [m]; empty if there is none
    const std::vector<RigidMotion>& motion_of_part;
    const std::vector<int>& body_of_part;
    const std::vector<PointData>& point_data;
};

/// This rank's cells with their values, node by node as cells name them.
class FieldPiece {
public:
    FieldPiece(const Discretisation& space, const Machine& machine, const ShownFields& shown)
        : space_(space), machine_(machine), shown_(shown), local_(machine.nodes.size(), -1),
          more_(shown.point_data.size())
    {
        std::vector<std::uint32_t> owned;
        for (std::uint32_t c = 0; c < machine.cells.size(); ++c)
            if (space.owns_cell(c))
                owned.push_back(c);
        add_nodes(owned);
        for (const auto c : owned)
            add_cell(c);
    }

    [[nodiscard]] const VtuGrid& grid() const { return grid_; }
    [[nodiscard]] std::vector<VtuArray> arrays()
    {
        std::vector<VtuArray> arrays{{"temperature [degC]", VtuArray::Place::point, 1, celsius_},
                                     {node_array_name, VtuArray::Place::point, 1, node_},
                                     {"part", VtuArray::Place::cell, 1, part_},
                                     {"body", VtuArray::Place::cell, 1, body_}};
        if (!shown_.displacement.empty())
            arrays.push_back({"displacement [mm]", VtuArray::Place::point, 3, millimetre_});
        for (std::size_t k = 0; k < more_.size(); ++k)
            arrays.push_back({shown_.point_data[k].name, VtuArray::Place::point, shown_.point_data[k].components,
                              std::move(more_[k])});
        return arrays;
    }

private:
    [[nodiscard]] static unsigned corners(const Cell& cell) { return cell.kind == CellKind::hexahedron ? 8 : 4; }

    /// In the order of the machine, so that a node has one number in all files.
    void add_nodes(const std::vector<std::uint32_t>& cells)
    {
        struct Seen {
            std::size_t unknown = 0;
            std::uint32_t part = 0;
        };
        std::map<std::uint32_t, Seen> seen;
        for (const auto c : cells) {
            const auto& cell = machine_.cells[c];
            for (unsigned i = 0; i < corners(cell); ++i)
                seen.try_emplace(cell.nodes[i], Seen{space_.vertex_unknown(c, i), cell.part});
        }
        for (const auto& [node, at] : seen) {
            local_[node] = static_cast<std::int64_t>(grid_.points.size());
            add_node(node, at.unknown, at.part);
        }
    }

    void add_cell(std::uint32_t c)
    {
        const auto& cell = machine_.cells[c];
        std::vector<std::uint32_t> nodes;
        for (unsigned i = 0; i < corners(cell); ++i)
            nodes.push_back(static_cast<std::uint32_t>(local_[cell.nodes[i]]));
        grid_.add_cell(nodes.size() == 8 ? VtuCell::hexahedron : VtuCell::tetrahedron, nodes);
        part_.push_back(static_cast<std::int32_t>(cell.part));
        body_.push_back(shown_.body_of_part[cell.part]);
    }

    void add_node(std::uint32_t node, std::size_t unknown, std::uint32_t part)
    {
        grid_.points.push_back(machine_.nodes[node]);
        node_.push_back(static_cast<std::int32_t>(node) + 1);
        celsius_.push_back(static_cast<float>(shown_.temperature[unknown] - zero_celsius));
        for (std::size_t k = 0; k < more_.size(); ++k) {
            const int count = shown_.point_data[k].components;
            const auto* from = shown_.point_data[k].values.data() + static_cast<std::size_t>(count) * node;
            more_[k].insert(more_[k].end(), from, from + count);
        }
        if (shown_.displacement.empty())
            return;
        const double* u = shown_.displacement.data() + 3 * unknown;
        const Vec3 moved =
            Vec3{u[0], u[1], u[2]} + rigid_displacement(shown_.motion_of_part[part], machine_.nodes[node]);
        for (const double value : moved)
            millimetre_.push_back(static_cast<float>(1000 * value));
    }

    const Discretisation& space_;
    const Machine& machine_;
    const ShownFields& shown_;
    VtuGrid grid_;
    std::vector<std::int64_t> local_;  ///< per node: number in the file, or -1
    std::vector<float> celsius_, millimetre_;
    std::vector<std::int32_t> node_, part_, body_;
    std::vector<std::vector<float>> more_;
};

/// Writes one file, or a file for each rank and one that names them.
std::string write_pieces(const std::string& folder, const std::string& name, FieldPiece& piece,
                         const std::vector<std::string>& comments)
{
    const auto arrays = piece.arrays();
    if (ranks() == 1) {
        write_vtu(folder + "/" + name + ".vtu", piece.grid(), arrays, {std::nullopt, comments});
        return name + ".vtu";
    }
    write_vtu(folder + "/" + name + "_" + std::to_string(rank()) + ".vtu", piece.grid(), arrays,
              {std::nullopt, comments});
    if (rank() == 0) {
        std::vector<std::string> pieces;
        for (int r = 0; r < ranks(); ++r)
            pieces.push_back(name + "_" + std::to_string(r) + ".vtu");
        std::vector<VtuDeclaration> declarations;
        for (const auto& array : arrays)
            declarations.push_back(declaration(array));
        write_pvtu(folder + "/" + name + ".pvtu", pieces, declarations, {std::nullopt, comments});
    }
    return name + ".pvtu";
}

}  // namespace

std::string Model::write_fields(const std::string& folder, const std::string& name, const Field& temperature,
                                const Displacement* displacement, const std::vector<RigidMotion>& motion_of_part,
                                const std::vector<int>& body_of_part, const std::vector<std::string>& comments,
                                const std::vector<PointData>& point_data)
{
    const auto& space = implementation_->space;
    auto moved =
        displacement ? gather_all(space, implementation_->on_heat_mesh(*displacement), 3) : std::vector<double>();
    const ShownFields shown{gather_all(space, temperature.owned, 1), std::move(moved), motion_of_part, body_of_part,
                            point_data};
    FieldPiece piece(space, implementation_->machine, shown);
    return write_pieces(folder, name, piece, comments);
}

}  // namespace deadpoint::fem
