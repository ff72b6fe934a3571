#include "deadpoint/fem/space/discretisation.hpp"

#include "deadpoint/exchange/machine.hpp"
#include "deadpoint/fem/space/round_cells.hpp"
#include "deadpoint/heat/system.hpp"
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_simplex_p.h>
#include <deal.II/fe/mapping_fe.h>
#include <deal.II/fe/mapping_q.h>

#include <algorithm>
#include <fmt/format.h>
#include <limits>

namespace deadpoint::fem {
namespace {

// VTK's hexahedron order to deal.II's lexicographic one.
constexpr std::array<int, 8> lexicographic{0, 1, 3, 2, 4, 5, 7, 6};

dealii::Point<3> to_point(const Vec3& x) { return {x[0], x[1], x[2]}; }

// Ranks own consecutive stretches of cells: parts follow each other, layers of a part too, so stretches are compact.
// They are of equal work, counted in entries of the matrices: a node has about 27 in its row among hexahedra and 15
// among tetrahedra, which its cells share.
void partition(dealii::parallel::shared::Triangulation<3>& triangulation, const Machine& machine)
{
    const auto corners = [](const Cell& cell) { return cell.kind == CellKind::hexahedron ? 8U : 4U; };
    std::vector<std::uint16_t> cells_at(machine.nodes.size(), 0);
    for (const auto& cell : machine.cells)
        for (unsigned i = 0; i < corners(cell); ++i)
            ++cells_at[cell.nodes[i]];
    const auto work = [&](const Cell& cell) {
        double share = 0;
        for (unsigned i = 0; i < corners(cell); ++i)
            share += 1.0 / cells_at[cell.nodes[i]];
        return share * (cell.kind == CellKind::hexahedron ? 27 : 15);
    };
    double all = 0;
    for (const auto& cell : machine.cells)
        all += work(cell);
    const auto ranks = dealii::Utilities::MPI::n_mpi_processes(PETSC_COMM_WORLD);
    double before = 0;
    for (const auto& cell : triangulation.active_cell_iterators()) {
        const double own = work(machine.cells[cell->active_cell_index()]);
        cell->set_subdomain_id(
            std::min(ranks - 1, static_cast<dealii::types::subdomain_id>((before + 0.5 * own) / all * ranks)));
        before += own;
    }
}

// The point itself if it lies in the reference cell, else a point of the cell near it.
template <class CellAccessor>
dealii::Point<3> inside_reference_cell(const CellAccessor& cell, dealii::Point<3> unit)
{
    if (cell.reference_cell() == dealii::ReferenceCells::Hexahedron)
        return dealii::GeometryInfo<3>::project_to_unit_cell(unit);
    for (unsigned i = 0; i < 3; ++i)
        unit[i] = std::max(unit[i], 0.0);
    const double sum = unit[0] + unit[1] + unit[2];
    return sum > 1 ? dealii::Point<3>(unit / sum) : unit;
}

// Index of an element in the collections.
unsigned element_index(bool hexahedron, int order)
{
    return 2 * static_cast<unsigned>(order - 1) + (hexahedron ? 0 : 1);
}

double cell_volume(const Machine& machine, const Cell& cell)
{
    const auto tetrahedron = [&](int a, int b, int c, int d) {
        const auto& x = machine.nodes;
        const Vec3 &o = x[cell.nodes[a]], &p = x[cell.nodes[b]], &q = x[cell.nodes[c]], &r = x[cell.nodes[d]];
        return std::abs(dot(cross(p - o, q - o), r - o)) / 6;
    };
    if (cell.kind == CellKind::tetrahedron)
        return tetrahedron(0, 1, 2, 3);
    return tetrahedron(0, 1, 2, 5) + tetrahedron(0, 2, 7, 5) + tetrahedron(0, 2, 3, 7) + tetrahedron(0, 5, 7, 4) +
           tetrahedron(2, 7, 5, 6);
}

double face_area(const Machine& machine, const Face& face)
{
    const auto& x = machine.nodes;
    const Vec3 first = cross(x[face.nodes[1]] - x[face.nodes[0]], x[face.nodes[2]] - x[face.nodes[0]]);
    if (face.node_count == 3)
        return 0.5 * norm(first);
    return 0.5 * (norm(first) + norm(cross(x[face.nodes[2]] - x[face.nodes[0]], x[face.nodes[3]] - x[face.nodes[0]])));
}

}  // namespace

namespace {

std::string reason_text(KSPConvergedReason reason)
{
    switch (reason) {
    case KSP_DIVERGED_ITS:
        return "it is not there yet";
    case KSP_DIVERGED_DTOL:
        return "its residual grew";
    case KSP_DIVERGED_INDEFINITE_MAT:
        return "its matrix is not positive definite";
    case KSP_DIVERGED_INDEFINITE_PC:
        return "its preconditioner is not positive definite";
    case KSP_DIVERGED_NANORINF:
        return "a value became infinite or not a number";
    case KSP_DIVERGED_PC_FAILED:
        return "its preconditioner could not be built";
    default:
        return KSPConvergedReasons[reason];
    }
}

}  // namespace

int solve(KSP solver, Vec rhs, Vec solution, const char* what)
{
    DEADPOINT_PETSC(KSPSolve(solver, rhs, solution));
    KSPConvergedReason reason = KSP_CONVERGED_ITERATING;
    PetscInt iterations = 0;
    DEADPOINT_PETSC(KSPGetConvergedReason(solver, &reason));
    DEADPOINT_PETSC(KSPGetIterationNumber(solver, &iterations));
    const auto failure = fmt::format("the linear solver did not converge for {}: {} after {} iterations", what,
                                     reason_text(reason), iterations);
    if (reason == KSP_DIVERGED_NANORINF || reason == KSP_DIVERGED_PC_FAILED)
        throw heat::NotFinite(failure);
    if (reason < 0)
        throw ConvergenceError(failure +
                               "\n  help: look for badly shaped cells with 'deadpoint check', or for material "
                               "values far apart");
    return static_cast<int>(iterations);
}

Discretisation::Discretisation(const Machine& machine_, std::vector<int> orders_)
    : machine(machine_), orders(std::move(orders_)),
      triangulation(PETSC_COMM_WORLD, dealii::Triangulation<3>::none, false,
                    dealii::parallel::shared::Triangulation<3>::partition_custom_signal),
      dofs(triangulation)
{
    using namespace dealii;
    for (unsigned order = 1; order <= 2; ++order) {  // see element_index()
        elements.push_back(FE_Q<3>(order));
        elements.push_back(FE_SimplexP<3>(order));
        if (order == 2 && !machine.round_edges.empty()) {
            mappings.push_back(RoundHexahedra(machine));
            mappings.push_back(RoundTetrahedra(machine));
        } else {
            mappings.push_back(MappingQ<3>(1));
            mappings.push_back(MappingFE<3>(FE_SimplexP<3>(1)));
        }
        quadratures.push_back(QGauss<3>(order + 1));
        quadratures.push_back(QGaussSimplex<3>(order + 1));
    }

    triangulation.signals.create.connect([this]() { partition(triangulation, machine); });
    triangulation.signals.post_refinement.connect([this]() { partition(triangulation, machine); });
    create_triangulation();

    for (const auto& cell : dofs.active_cell_iterators())
        if (cell->is_locally_owned())
            cell->set_active_fe_index(
                element_index(cell->reference_cell() == ReferenceCells::Hexahedron, orders[cell->material_id()]));
    dofs.distribute_dofs(elements);
    const auto& owned = dofs.locally_owned_dofs();
    if (owned.n_elements() == 0 || !owned.is_contiguous())
        throw InputError(
            "a rank got no share of the mesh; use fewer ranks or a finer mesh (`--size`), the mesh has only " +
            std::to_string(machine.cells.size()) + " cells");
    first = static_cast<PetscInt>(owned.nth_index_in_set(0));
    last = first + static_cast<PetscInt>(owned.n_elements());
    total = static_cast<PetscInt>(dofs.n_dofs());

    cells_.reserve(machine.cells.size());
    for (const auto& cell : dofs.active_cell_iterators())
        cells_.push_back(cell);
    for (const auto& cell : machine.cells)
        round_.push_back(orders[cell.part] == 2 && is_round(machine, cell));
    number_neighbours_alike();
    depth_.reserve(machine.faces.size());
    for (const auto& face : machine.faces)
        depth_.push_back(cell_volume(machine, machine.cells[face.cell]) / face_area(machine, face));
}

namespace {

// Without the columns of other ranks, counted from the first.
SparseRows among_themselves(SparseRows rows, PetscInt first, PetscInt last)
{
    std::size_t kept = 0, next = 0;
    for (std::size_t row = 0; row + 1 < rows.starts.size(); ++row) {
        for (; next < static_cast<std::size_t>(rows.starts[row + 1]); ++next)
            if (const PetscInt column = rows.columns[next]; column >= first && column < last)
                rows.columns[kept++] = column - first;
        rows.starts[row + 1] = static_cast<PetscInt>(kept);
    }
    rows.columns.resize(kept);
    return rows;
}

}  // namespace

// Reverse Cuthill and McKee over each rank's unknowns, with all that couples them: parts that touch are neighbours too.
// Products with the matrices then read nearby memory. PETSc's version begins at the end of the longest path through
// the graph; deal.II's does not and gives wider bands.
void Discretisation::number_neighbours_alike()
{
    auto couplings = cell_couplings();
    add_bond_couplings(couplings);
    for (const auto& interface : machine.interfaces)
        add_couplings_across(interface.points, couplings);
    auto graph_rows = among_themselves(couplings.rows(), first, last);
    const PetscInt count = last - first;
    OwnedMat graph;
    DEADPOINT_PETSC(MatCreateSeqAIJWithArrays(PETSC_COMM_SELF, count, count, graph_rows.starts.data(),
                                              graph_rows.columns.data(), nullptr, graph.out()));
    DEADPOINT_PETSC(MatSetOption(graph, MAT_STRUCTURALLY_SYMMETRIC, PETSC_TRUE));
    IS rows = nullptr, same = nullptr;
    DEADPOINT_PETSC(MatGetOrdering(graph, MATORDERINGRCM, &rows, &same));
    const PetscInt* ordered = nullptr;
    DEADPOINT_PETSC(ISGetIndices(rows, &ordered));
    std::vector<dealii::types::global_dof_index> number(static_cast<std::size_t>(count));
    for (PetscInt place = 0; place < count; ++place)
        number[static_cast<std::size_t>(ordered[place])] = static_cast<dealii::types::global_dof_index>(first + place);
    DEADPOINT_PETSC(ISRestoreIndices(rows, &ordered));
    DEADPOINT_PETSC(ISDestroy(&rows));
    DEADPOINT_PETSC(ISDestroy(&same));
    dofs.renumber_dofs(number);
}

void Discretisation::create_triangulation()
{
    std::vector<dealii::Point<3>> vertices;
    vertices.reserve(machine.nodes.size());
    for (const auto& node : machine.nodes)
        vertices.push_back(to_point(node));
    std::vector<dealii::CellData<3>> cells;
    cells.reserve(machine.cells.size());
    for (const auto& cell : machine.cells) {
        const unsigned count = cell.kind == CellKind::hexahedron ? 8 : 4;
        dealii::CellData<3> data(count);
        for (unsigned i = 0; i < count; ++i)
            data.vertices[count == 8 ? static_cast<unsigned>(lexicographic[i]) : i] = cell.nodes[i];
        data.material_id = cell.part;
        cells.push_back(data);
    }
    triangulation.create_triangulation(vertices, cells, dealii::SubCellData());
}

// By the vertices, and where the cell is round by all nodes of its element of second order, which is isoparametric.
dealii::Tensor<2, 3> Discretisation::jacobian_at(std::uint32_t index, const dealii::Point<3>& unit) const
{
    const auto& cell = cells_[index];
    dealii::Tensor<2, 3> jacobian;
    const auto add = [&](const dealii::Point<3>& x, const dealii::Tensor<1, 3>& slope) {
        for (unsigned i = 0; i < 3; ++i)
            for (unsigned j = 0; j < 3; ++j)
                jacobian[i][j] += x[i] * slope[j];
    };
    if (round_[index]) {
        const auto& element = cell->get_fe();
        const auto places = places_in(machine, cell, element.get_unit_support_points());
        for (unsigned v = 0; v < places.size(); ++v)
            add(places[v], element.shape_grad(v, unit));
    } else if (cell->reference_cell() == dealii::ReferenceCells::Hexahedron) {
        for (const auto v : cell->vertex_indices())
            add(cell->vertex(v), dealii::GeometryInfo<3>::d_linear_shape_function_gradient(unit, v));
    } else {
        for (unsigned i = 0; i < 3; ++i)
            for (unsigned j = 0; j < 3; ++j)
                jacobian[i][j] = cell->vertex(j + 1)[i] - cell->vertex(0)[i];
    }
    return jacobian;
}

// Newton's method from the straight cell's place. The library stops its own early on tetrahedra.
dealii::Point<3> Discretisation::unit_in_round(std::uint32_t index, const dealii::Point<3>& position) const
{
    constexpr int most_steps = 20;
    constexpr double tolerance = 1e-14, largest_miss = 1e-9;  // relative to the cell's size
    const auto& cell = cells_[index];
    const auto& machine_cell = machine.cells[index];
    const unsigned straight = element_index(machine_cell.kind == CellKind::hexahedron, 1);
    auto unit = mappings[straight].transform_real_to_unit_cell(cell, position);
    dealii::Tensor<1, 3> miss;
    for (int step = 0; step < most_steps; ++step) {
        miss = position - to_point(place_in(machine, machine_cell, {unit[0], unit[1], unit[2]}));
        if (miss.norm() < tolerance * cell->diameter())
            return unit;
        unit += dealii::invert(jacobian_at(index, unit)) * miss;
    }
    if (!(miss.norm() < largest_miss * cell->diameter()))
        throw dealii::Mapping<3>::ExcTransformationFailed();
    return unit;
}

dealii::Point<3> Discretisation::unit_of(std::uint32_t index, const Vec3& position) const
{
    const auto& cell = cells_[index];
    return round_[index] ? unit_in_round(index, to_point(position))
                         : mappings[cell->active_fe_index()].transform_real_to_unit_cell(cell, to_point(position));
}

void Discretisation::evaluate_at(std::uint32_t index, const dealii::Point<3>& unit, bool gradients,
                                 PointShape& shape) const
{
    const auto& cell = cells_[index];
    const auto& element = elements[cell->active_fe_index()];
    shape.count = static_cast<int>(element.n_dofs_per_cell());
    std::vector<dealii::types::global_dof_index> indices(element.n_dofs_per_cell());
    cell->get_dof_indices(indices);
    dealii::Tensor<2, 3> inverse;
    if (gradients) {
        inverse = dealii::transpose(dealii::invert(jacobian_at(index, unit)));
    }
    for (int i = 0; i < shape.count; ++i) {
        shape.dof[i] = static_cast<PetscInt>(indices[i]);
        shape.value[i] = element.shape_value(static_cast<unsigned>(i), unit);
        if (gradients) {
            const dealii::Tensor<1, 3> g = inverse * element.shape_grad(static_cast<unsigned>(i), unit);
            shape.gradient[i] = {g[0], g[1], g[2]};
        }
    }
}

void Discretisation::evaluate(std::uint32_t face, const Vec3& position, bool gradients, PointShape& shape) const
{
    const auto index = machine.faces[face].cell;
    evaluate_at(index, nearest_inside(index, unit_of(index, position)), gradients, shape);
}

void Discretisation::evaluate_in_part(int part, const Vec3& position, PointShape& shape) const
{
    const auto& range = machine.parts[part];
    double nearest = std::numeric_limits<double>::max();
    std::uint32_t found = range.first_cell;
    dealii::Point<3> found_unit;
    for (std::uint32_t c = range.first_cell; c < range.first_cell + range.cell_count; ++c) {
        const auto& cell = cells_[c];
        if (cell->center().distance(to_point(position)) > 2 * cell->diameter())
            continue;
        dealii::Point<3> unit;
        if (!unit_position(c, position, unit))
            continue;
        const auto inside = inside_reference_cell(*cell, unit);
        const double distance = inside.distance(unit) * cell->diameter();
        if (distance < nearest) {
            nearest = distance;
            found = c;
            found_unit = inside;
        }
    }
    if (nearest == std::numeric_limits<double>::max())
        throw InputError("no cell of part '" + range.name + "' is near a probe; move the probe onto the part");
    if (nearest > 0.5 * cells_[found]->diameter())
        throw InputError("a probe lies " + std::to_string(1000 * nearest) + " mm outside its part '" + range.name +
                         "'; move it onto the part");
    evaluate_at(found, found_unit, false, shape);
}

double Discretisation::continue_cell(std::uint32_t index, const Vec3& position, PointShape& shape) const
{
    dealii::Point<3> unit;
    if (!unit_position(index, position, unit))
        return std::numeric_limits<double>::max();
    evaluate_at(index, unit, false, shape);
    return distance_outside(index, unit);
}

bool Discretisation::unit_position(std::uint32_t index, const Vec3& position, dealii::Point<3>& unit) const
{
    try {
        unit = unit_of(index, position);
        return true;
    } catch (const dealii::Mapping<3>::ExcTransformationFailed&) {
        return false;
    }
}

dealii::Point<3> Discretisation::nearest_inside(std::uint32_t index, const dealii::Point<3>& unit) const
{
    return inside_reference_cell(*cells_[index], unit);
}

Couplings Discretisation::cell_couplings() const
{
    Couplings couplings(first, last);
    for (std::uint32_t cell = 0; cell < cells_.size(); ++cell)
        couplings.add(unknowns_of(cell));
    return couplings;
}

std::vector<PetscInt> Discretisation::unknowns_of(std::uint32_t cell) const
{
    std::vector<dealii::types::global_dof_index> indices(cells_[cell]->get_fe().n_dofs_per_cell());
    cells_[cell]->get_dof_indices(indices);
    return {indices.begin(), indices.end()};
}

void Discretisation::add_couplings_across(const std::vector<ContactPoint>& points, Couplings& couplings) const
{
    std::pair<std::uint32_t, std::uint32_t> previous{~0U, ~0U};
    for (const auto& point : points) {
        const std::pair<std::uint32_t, std::uint32_t> faces{point.face_a, point.face_b};
        if (faces == previous)
            continue;
        previous = faces;
        const auto a = unknowns_of(machine.faces[point.face_a].cell);
        const auto b = unknowns_of(machine.faces[point.face_b].cell);
        couplings.add(a, b);
        couplings.add(b, a);
    }
}

void Discretisation::add_bond_couplings(Couplings& couplings) const
{
    for (const auto& bond : machine.bonds)
        if (bond.perfect)
            add_couplings_across(bond.points, couplings);
}

void Discretisation::cell_nodes(std::uint32_t index, std::vector<std::size_t>& unknowns,
                                std::vector<Vec3>& position) const
{
    const auto& cell = cells_[index];
    const auto& element = cell->get_fe();
    std::vector<dealii::types::global_dof_index> indices(element.n_dofs_per_cell());
    cell->get_dof_indices(indices);
    unknowns.assign(indices.begin(), indices.end());
    for (unsigned i = 0; i < indices.size(); ++i) {
        const auto x =
            mappings[cell->active_fe_index()].transform_unit_to_real_cell(cell, element.unit_support_point(i));
        position[indices[i]] = {x[0], x[1], x[2]};
    }
}

std::vector<std::uint32_t> Discretisation::part_of_unknown() const
{
    std::vector<std::uint32_t> parts(static_cast<std::size_t>(last - first), 0);
    std::vector<dealii::types::global_dof_index> indices;
    for (const auto& cell : dofs.active_cell_iterators()) {
        indices.resize(cell->get_fe().n_dofs_per_cell());
        cell->get_dof_indices(indices);
        for (const auto dof : indices)
            if (owns(static_cast<PetscInt>(dof)))
                parts[dof - static_cast<std::size_t>(first)] = cell->material_id();
    }
    return parts;
}

std::vector<Vec3> Discretisation::support_points() const
{
    std::vector<Vec3> all(static_cast<std::size_t>(total));
    std::vector<std::size_t> unknowns;
    for (std::uint32_t c = 0; c < cells_.size(); ++c)
        cell_nodes(c, unknowns, all);
    return {all.begin() + first, all.begin() + last};
}

std::size_t Discretisation::vertex_unknown(std::uint32_t index, unsigned node) const
{
    const auto& cell = cells_[index];
    const bool hexahedron = machine.cells[index].kind == CellKind::hexahedron;
    return cell->vertex_dof_index(hexahedron ? static_cast<unsigned>(lexicographic[node]) : node, 0,
                                  cell->active_fe_index());
}

SparseFunctional Discretisation::functional(const std::vector<std::pair<PetscInt, double>>& entries) const
{
    PetscInt lowest = last, end = first;
    for (const auto& [dof, weight] : entries)
        if (owns(dof)) {
            lowest = std::min(lowest, dof);
            end = std::max(end, dof + 1);
        }
    if (lowest >= end)
        return {};
    std::vector<double> sums(static_cast<std::size_t>(end - lowest), 0.0);
    std::vector<bool> met(sums.size(), false);
    for (const auto& [dof, weight] : entries)
        if (owns(dof)) {
            const auto place = static_cast<std::size_t>(dof - lowest);
            sums[place] += weight;
            met[place] = true;
        }
    SparseFunctional result;
    for (std::size_t place = 0; place < sums.size(); ++place)
        if (met[place]) {
            result.local.push_back(lowest - first + static_cast<PetscInt>(place));
            result.weight.push_back(sums[place]);
        }
    return result;
}

void sum_over_ranks(std::vector<double>& values)
{
    MPI_Allreduce(MPI_IN_PLACE, values.data(), static_cast<int>(values.size()), MPI_DOUBLE, MPI_SUM, PETSC_COMM_WORLD);
}

std::vector<double> evaluate(const std::vector<const SparseFunctional*>& functionals, Vec vector)
{
    const double* data = nullptr;
    DEADPOINT_PETSC(VecGetArrayRead(vector, &data));
    std::vector<double> sums;
    sums.reserve(functionals.size());
    for (const auto* f : functionals) {
        double sum = 0;
        for (std::size_t i = 0; i < f->local.size(); ++i)
            sum += f->weight[i] * data[f->local[i]];
        sums.push_back(sum);
    }
    DEADPOINT_PETSC(VecRestoreArrayRead(vector, &data));
    sum_over_ranks(sums);
    return sums;
}

void add_to(Vec vector, const SparseFunctional& functional, double factor)
{
    double* data = nullptr;
    DEADPOINT_PETSC(VecGetArray(vector, &data));
    for (std::size_t i = 0; i < functional.local.size(); ++i)
        data[functional.local[i]] += factor * functional.weight[i];
    DEADPOINT_PETSC(VecRestoreArray(vector, &data));
}

OwnedMat create_matrix(const SparseRows& rows)
{
    const auto count = static_cast<PetscInt>(rows.starts.size()) - 1;
    OwnedMat matrix;
    DEADPOINT_PETSC(MatCreate(PETSC_COMM_WORLD, matrix.out()));
    DEADPOINT_PETSC(MatSetSizes(matrix, count, count, PETSC_DETERMINE, PETSC_DETERMINE));
    DEADPOINT_PETSC(MatSetType(matrix, MATAIJ));
    DEADPOINT_PETSC(MatSeqAIJSetPreallocationCSR(matrix, rows.starts.data(), rows.columns.data(), nullptr));
    DEADPOINT_PETSC(MatMPIAIJSetPreallocationCSR(matrix, rows.starts.data(), rows.columns.data(), nullptr));
    DEADPOINT_PETSC(MatSetOption(matrix, MAT_NEW_NONZERO_ALLOCATION_ERR, PETSC_TRUE));
    DEADPOINT_PETSC(MatSetOption(matrix, MAT_SYMMETRIC, PETSC_TRUE));
    DEADPOINT_PETSC(MatSetOption(matrix, MAT_USE_INODES, PETSC_FALSE));
    return matrix;
}

OwnedVec create_vector(const Discretisation& space, int block)
{
    OwnedVec vector;
    DEADPOINT_PETSC(VecCreate(PETSC_COMM_WORLD, vector.out()));
    DEADPOINT_PETSC(VecSetSizes(vector, block * (space.last - space.first), block * space.total));
    DEADPOINT_PETSC(VecSetType(vector, VECSTANDARD));
    DEADPOINT_PETSC(VecSetBlockSize(vector, block));
    return vector;
}

void for_each_bond_pair(const Discretisation& space, const std::function<void(const BondPair&)>& visit)
{
    const auto& faces = space.machine.faces;
    BondPair pair;
    for (const auto& bond : space.machine.bonds)
        for (auto point = bond.points.begin(); bond.perfect && point != bond.points.end();) {
            const auto face_a = point->face_a, face_b = point->face_b;
            const auto end = std::find_if(point, bond.points.end(),
                                          [&](const auto& p) { return p.face_a != face_a || p.face_b != face_b; });
            if (space.cell(faces[face_a].cell)->is_locally_owned()) {
                pair.points.resize(static_cast<std::size_t>(end - point));
                for (auto& target : pair.points) {
                    space.evaluate(face_a, point->position_a, true, target.a);
                    space.evaluate(face_b, point->position_b, true, target.b);
                    target.normal = point->normal;
                    target.weight = point->weight;
                    ++point;
                }
                pair.part_a = static_cast<int>(faces[face_a].part);
                pair.part_b = static_cast<int>(faces[face_b].part);
                pair.depth_a = space.depth(face_a);
                pair.depth_b = space.depth(face_b);
                visit(pair);
            }
            point = end;
        }
}

const double* Gathered::gather(Vec vector)
{
    if (values_)
        DEADPOINT_PETSC(VecRestoreArrayRead(all_, &values_));
    DEADPOINT_PETSC(VecScatterBegin(scatter_, vector, all_, INSERT_VALUES, SCATTER_FORWARD));
    DEADPOINT_PETSC(VecScatterEnd(scatter_, vector, all_, INSERT_VALUES, SCATTER_FORWARD));
    DEADPOINT_PETSC(VecGetArrayRead(all_, &values_));
    return values_;
}

Gathered::~Gathered()
{
    if (values_)
        VecRestoreArrayRead(all_, &values_);
}

std::vector<double> gather_all(const Discretisation& space, const std::vector<double>& owned, int block)
{
    OwnedVec vector = create_vector(space, block);
    double* target = nullptr;
    DEADPOINT_PETSC(VecGetArray(vector, &target));
    std::copy(owned.begin(), owned.end(), target);
    DEADPOINT_PETSC(VecRestoreArray(vector, &target));
    Gathered gathered(vector);
    const double* all = gathered.gather(vector);
    return {all, all + block * space.total};
}

}  // namespace deadpoint::fem
