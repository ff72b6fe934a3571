#include "deadpoint/fem/model.hpp"

#include "deadpoint/core/vtu.hpp"
#include "deadpoint/fem/elastic_solver.hpp"
#include "deadpoint/fem/error_estimate.hpp"
#include "deadpoint/fem/heat_solver.hpp"
#include "deadpoint/fem/thermal_state.hpp"

#include <cmath>
#include <numbers>

namespace deadpoint::fem {

struct Model::Implementation {
    Implementation(const Machine& machine_, std::vector<Material> materials_, int order)
        : machine(machine_), materials(std::move(materials_)), space(machine, order)
    {}
    ElasticSolver& deformation()
    {
        if (!elastic)
            elastic = std::make_unique<ElasticSolver>(space, materials, feet);
        return *elastic;
    }
    const Machine& machine;
    std::vector<Material> materials;
    Discretisation space;
    std::unique_ptr<ElasticSolver> elastic;
    std::unique_ptr<HeatSolver> heat;
    ThermalState last;
    int feet = -1;
    int elastic_iterations = 0;
};

namespace {

// Ranks mesh the machine each for themselves; a difference must not pass as a result.
void require_same_mesh(const Machine& machine)
{
    double sum = static_cast<double>(machine.cells.size());
    for (std::size_t i = 0; i < machine.nodes.size(); ++i)
        sum += dot(machine.nodes[i], {1.0, std::numbers::pi, std::numbers::e}) * static_cast<double>(1 + i % 1021);
    std::array<double, 2> range{sum, -sum};
    MPI_Allreduce(MPI_IN_PLACE, range.data(), 2, MPI_DOUBLE, MPI_MIN, MPI_COMM_WORLD);
    if (range[0] != -range[1])
        throw InputError("the ranks built different meshes; run with one rank, and please report the case");
}

void require_sound(const Machine& machine, const std::vector<Material>& materials)
{
    if (machine.cells.empty())
        throw InputError("the machine has no cells");
    if (materials.size() != machine.parts.size())
        throw InputError("one material is needed per part");
    for (std::size_t p = 0; p < materials.size(); ++p)
        for (const double value :
             {materials[p].density, materials[p].conductivity, materials[p].specific_heat, materials[p].youngs_modulus})
            if (!(value > 0) || !std::isfinite(value))
                throw InputError(
                    "the material of part '" + machine.parts[p].name +
                    "' has a density, conductivity, specific heat or Young's modulus that is not positive");
}

// Entries of a divided vector of `block` values per unknown at nodes of the mesh, on all ranks.
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

Model::Model(const Machine& machine, std::vector<Material> materials, int order, Observer&)
{
    require_sound(machine, materials);
    require_same_mesh(machine);
    implementation_ = std::make_unique<Implementation>(machine, std::move(materials), order);
}
Model::~Model() = default;
Model::Model(Model&&) noexcept = default;

ModelSize Model::size() const
{
    return {static_cast<long long>(implementation_->machine.cells.size()), implementation_->space.total};
}

void Model::assemble_heat(const HeatProblem& problem)
{
    auto& heat = implementation_->heat;
    if (!heat || !heat->adopt(problem))
        heat = std::make_unique<HeatSolver>(implementation_->space, implementation_->materials, problem);
    ThermalState start{interpolate_field(problem.initial_temperature), {}};
    for (const auto& circuit : problem.oil)
        start.sumps.push_back(circuit.sump_start);
    heat->start_from(start);
}

ThermalHistory Model::heat(const std::vector<Adjoint>& adjoints, double reference_temperature, int attribution,
                           Observer& observer, const StepCallback& on_step, const FieldCallback& on_field)
{
    const auto solver = std::move(implementation_->heat);
    if (!solver)
        throw std::logic_error("Model::heat() needs assemble_heat() before it");
    auto history = solver->run(adjoints, reference_temperature, attribution, observer, on_step, on_field);
    implementation_->last = solver->state();
    return history;
}

void Model::start_from(const std::string& file)
{
    if (!implementation_->heat)
        throw std::logic_error("Model::start_from() needs assemble_heat() before it");
    implementation_->heat->start_from(
        read_thermal_state(file, implementation_->space, implementation_->heat->state().sumps.size()));
}

void Model::write_state(const std::string& file) const
{
    write_thermal_state(file, implementation_->space, implementation_->last);
}

void Model::support(int feet_surface)
{
    implementation_->feet = feet_surface;
    release_elasticity();
}

std::vector<Adjoint> Model::adjoints(const std::vector<Functional>& functionals)
{
    return implementation_->deformation().adjoints(functionals);
}

Displacement Model::displacement(const Field& temperature, double reference_temperature)
{
    return implementation_->deformation().displacement(temperature, reference_temperature);
}

std::vector<double> Model::evaluate(const std::vector<Functional>& functionals, const Displacement& displacement)
{
    return implementation_->deformation().evaluate(functionals, displacement);
}

double Model::apply(const Adjoint& adjoint, const Field& temperature, double reference_temperature)
{
    std::vector<double> sum{0};
    for (std::size_t i = 0; i < adjoint.owned.size(); ++i)
        sum[0] += adjoint.owned[i] * (temperature.owned[i] - reference_temperature);
    sum_over_ranks(sum);
    return sum[0];
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

std::vector<Field> Model::heat_duals(const HeatProblem& problem, double time, const Field& temperature,
                                     const std::vector<Adjoint>& weights)
{
    HeatSolver solver(implementation_->space, implementation_->materials, problem);
    ThermalState start{temperature, {}};
    for (const auto& circuit : problem.oil)
        start.sumps.push_back(circuit.sump_start);
    solver.start_from(start);
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

Displacement Model::deformation_dual(const Functional& functional)
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
    return fem::deformation_errors(implementation_->space, implementation_->materials, displacement, duals);
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
    const auto values = gathered(implementation_->space, corners, displacement.owned, 3);
    std::vector<Vec3> result(corners.size());
    for (std::size_t k = 0; k < corners.size(); ++k)
        result[k] = {values[3 * k], values[3 * k + 1], values[3 * k + 2]};
    return result;
}

std::string Model::write_fields(const std::string& folder, const std::string& name, const Field& temperature,
                                const Displacement* displacement, const std::vector<RigidMotion>& motion_of_part,
                                const std::vector<int>& body_of_part, const std::vector<std::string>& comments)
{
    const auto& space = implementation_->space;
    const auto& machine = implementation_->machine;
    int rank = 0, ranks = 1;
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    MPI_Comm_size(MPI_COMM_WORLD, &ranks);

    const auto rise = gather_all(space, temperature.owned, 1);
    const auto moved = displacement ? gather_all(space, displacement->owned, 3) : std::vector<double>();

    VtuGrid grid;
    std::vector<std::int64_t> local(machine.nodes.size(), -1);
    std::vector<float> celsius, millimetre;
    std::vector<std::int32_t> part, body;
    for (std::uint32_t c = 0; c < machine.cells.size(); ++c) {
        const auto cell = space.cell(c);
        if (!cell->is_locally_owned())
            continue;
        std::vector<std::uint32_t> nodes;
        const unsigned count = machine.cells[c].kind == CellKind::hexahedron ? 8 : 4;
        for (unsigned i = 0; i < count; ++i) {
            const auto node = machine.cells[c].nodes[i];
            if (local[node] < 0) {
                local[node] = static_cast<std::int64_t>(grid.points.size());
                grid.points.push_back(machine.nodes[node]);
                const auto dof = space.vertex_unknown(c, i);
                celsius.push_back(static_cast<float>(rise[dof] - 273.15));
                if (displacement) {
                    const Vec3 u = Vec3{moved[3 * dof], moved[3 * dof + 1], moved[3 * dof + 2]} +
                                   rigid_displacement(motion_of_part[machine.cells[c].part], machine.nodes[node]);
                    for (const double value : u)
                        millimetre.push_back(static_cast<float>(1000 * value));
                }
            }
            nodes.push_back(static_cast<std::uint32_t>(local[node]));
        }
        grid.add_cell(count == 8 ? VtuCell::hexahedron : VtuCell::tetrahedron, nodes);
        part.push_back(static_cast<std::int32_t>(machine.cells[c].part));
        body.push_back(body_of_part[machine.cells[c].part]);
    }
    std::vector<VtuArray> arrays{{"temperature [degC]", VtuArray::Place::point, 1, celsius},
                                 {"part", VtuArray::Place::cell, 1, part},
                                 {"body", VtuArray::Place::cell, 1, body}};
    if (displacement)
        arrays.push_back({"displacement [mm]", VtuArray::Place::point, 3, millimetre});
    if (ranks == 1) {
        write_vtu(folder + "/" + name + ".vtu", grid, arrays, {std::nullopt, comments});
        return name + ".vtu";
    }
    write_vtu(folder + "/" + name + "_" + std::to_string(rank) + ".vtu", grid, arrays, {std::nullopt, comments});
    if (rank == 0) {
        std::vector<std::string> pieces;
        for (int r = 0; r < ranks; ++r)
            pieces.push_back(name + "_" + std::to_string(r) + ".vtu");
        std::vector<VtuDeclaration> declarations;
        for (const auto& array : arrays)
            declarations.push_back(declaration(array));
        write_pvtu(folder + "/" + name + ".pvtu", pieces, declarations, {std::nullopt, comments});
    }
    return name + ".pvtu";
}

}  // namespace deadpoint::fem
