#include "deadpoint/fem/space/discretisation.hpp"

#include "deadpoint/exchange/machine.hpp"
#include "deadpoint/fem/algebra/session.hpp"
#include "deadpoint/heat/system.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <limits>

namespace deadpoint::fem {
namespace {

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

double flat_area(const Machine& machine, const Face& face)
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

namespace {

// By element index, with one point per direction more than the order.
std::vector<Quadrature> gauss_rules()
{
    return {gauss_on_cube(2), gauss_on_tetrahedron(2), gauss_on_cube(3), gauss_on_tetrahedron(3)};
}

}  // namespace

Discretisation::Discretisation(const Machine& machine_, std::vector<int> orders_)
    : machine(machine_), orders(std::move(orders_)), elements(lagrange_elements()), quadratures(gauss_rules()),
      maps(machine, orders, elements), unknowns_(machine, orders)
{
    const auto own = static_cast<std::size_t>(rank());
    const auto first_cells = stretches(machine, ranks());
    first_cell = first_cells[own];
    end_cell = first_cells[own + 1];
    first = unknowns_.met_before(first_cell);
    last = unknowns_.met_before(end_cell);
    total = unknowns_.total();
    int without = first == last ? 1 : 0;
    MPI_Allreduce(MPI_IN_PLACE, &without, 1, MPI_INT, MPI_SUM, PETSC_COMM_WORLD);
    if (without > 0)
        throw InputError(
            "a rank got no share of the mesh; use fewer ranks or a finer mesh (`--size`), the mesh has only " +
            std::to_string(machine.cells.size()) + " cells");
    number_neighbours_alike();
    depth_.reserve(machine.faces.size());
    for (const auto& face : machine.faces)
        depth_.push_back(cell_volume(machine, machine.cells[face.cell]) / flat_area(machine, face));
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

// Each rank has its own stretch, first to last; then all have all.
void share_stretches(std::vector<PetscInt>& values, PetscInt first, PetscInt last)
{
    const auto count = static_cast<std::size_t>(ranks());
    std::vector<int> counts(count), starts(count);
    const int own = last - first, start = first;
    MPI_Allgather(&own, 1, MPI_INT, counts.data(), 1, MPI_INT, PETSC_COMM_WORLD);
    MPI_Allgather(&start, 1, MPI_INT, starts.data(), 1, MPI_INT, PETSC_COMM_WORLD);
    MPI_Allgatherv(MPI_IN_PLACE, 0, MPI_DATATYPE_NULL, values.data(), counts.data(), starts.data(), MPIU_INT,
                   PETSC_COMM_WORLD);
}

}  // namespace

// Reverse Cuthill and McKee over each rank's unknowns, with all that couples them: parts that touch are neighbours too.
// Products with the matrices then read nearby memory. PETSc's version begins at the end of the longest path through
// the graph, which gives narrow bands.
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
    std::vector<PetscInt> number(static_cast<std::size_t>(total));
    for (PetscInt place = 0; place < count; ++place)
        number[static_cast<std::size_t>(first + ordered[place])] = first + place;
    DEADPOINT_PETSC(ISRestoreIndices(rows, &ordered));
    DEADPOINT_PETSC(ISDestroy(&rows));
    DEADPOINT_PETSC(ISDestroy(&same));
    share_stretches(number, first, last);
    unknowns_.renumber(number);
}

void Discretisation::evaluate_at(std::uint32_t cell, const Vec3& unit, bool gradients, PointShape& shape) const
{
    const auto& functions = element(cell);
    std::vector<PetscInt> unknowns;
    unknowns_of(cell, unknowns);
    shape.count = static_cast<int>(unknowns.size());
    std::ranges::copy(unknowns, shape.dof.begin());
    Matrix3 inverse{};
    if (gradients)
        inverse = inverse_transposed(maps.jacobian(cell, unit));
    for (int i = 0; i < shape.count; ++i) {
        shape.value[i] = functions.value(static_cast<unsigned>(i), unit);
        if (gradients)
            shape.gradient[i] = times(inverse, functions.slope(static_cast<unsigned>(i), unit));
    }
}

void Discretisation::evaluate(std::uint32_t face, const Vec3& position, bool gradients, PointShape& shape) const
{
    const auto cell = machine.faces[face].cell;
    Vec3 unit{};
    if (!maps.unit_position(cell, position, unit))
        throw InputError(fmt::format(
            "a cell of part '{}' near ({:.1f}, {:.1f}, {:.1f}) mm is so distorted that a point "
            "of its face has no place in it\n  help: look at the cells with 'deadpoint check', "
            "and mesh the part with another size",
            machine.parts[machine.cells[cell].part].name, 1000 * position[0], 1000 * position[1], 1000 * position[2]));
    evaluate_at(cell, maps.nearest_inside(cell, unit), gradients, shape);
}

void Discretisation::evaluate_in_part(int part, const Vec3& position, PointShape& shape) const
{
    const auto& range = machine.parts[part];
    double nearest = std::numeric_limits<double>::max();
    std::uint32_t found = range.first_cell;
    Vec3 found_unit{};
    for (std::uint32_t c = range.first_cell; c < range.first_cell + range.cell_count; ++c) {
        const double diameter = maps.diameter(c);
        if (norm(maps.centre(c) - position) > 2 * diameter)
            continue;
        Vec3 unit{};
        if (!maps.unit_position(c, position, unit))
            continue;
        const auto inside = maps.nearest_inside(c, unit);
        const double distance = norm(inside - unit) * diameter;
        if (distance < nearest) {
            nearest = distance;
            found = c;
            found_unit = inside;
        }
    }
    if (nearest == std::numeric_limits<double>::max())
        throw InputError("no cell of part '" + range.name + "' is near a probe; move the probe onto the part");
    if (nearest > 0.5 * maps.diameter(found))
        throw InputError("a probe lies " + std::to_string(1000 * nearest) + " mm outside its part '" + range.name +
                         "'; move it onto the part");
    evaluate_at(found, found_unit, false, shape);
}

double Discretisation::continue_cell(std::uint32_t cell, const Vec3& position, PointShape& shape) const
{
    Vec3 unit{};
    if (!maps.unit_position(cell, position, unit))
        return std::numeric_limits<double>::max();
    evaluate_at(cell, unit, false, shape);
    return distance_outside(cell, unit);
}

Couplings Discretisation::cell_couplings() const
{
    Couplings couplings(first, last);
    std::vector<PetscInt> unknowns;
    for (std::uint32_t cell = 0; cell < machine.cells.size(); ++cell) {
        unknowns_of(cell, unknowns);
        couplings.add(unknowns);
    }
    return couplings;
}

std::vector<PetscInt> Discretisation::unknowns_of(std::uint32_t cell) const
{
    std::vector<PetscInt> unknowns;
    unknowns_of(cell, unknowns);
    return unknowns;
}

int Discretisation::part_of(std::uint32_t cell) const { return static_cast<int>(machine.cells[cell].part); }

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

void Discretisation::cell_nodes(std::uint32_t cell, std::vector<std::size_t>& unknowns,
                                std::vector<Vec3>& position) const
{
    const auto own = unknowns_of(cell);
    unknowns.assign(own.begin(), own.end());
    for (unsigned i = 0; i < own.size(); ++i)
        position[unknowns[i]] = node_position(cell, i);
}

Vec3 Discretisation::node_position(std::uint32_t cell, unsigned i) const
{
    return maps.position(cell, element(cell).nodes()[i]);
}

std::vector<std::uint32_t> Discretisation::part_of_unknown() const
{
    std::vector<std::uint32_t> parts(static_cast<std::size_t>(last - first), 0);
    std::vector<PetscInt> unknowns;
    for (std::uint32_t cell = first_cell; cell < end_cell; ++cell) {
        unknowns_of(cell, unknowns);
        for (const auto unknown : unknowns)
            if (owns(unknown))
                parts[static_cast<std::size_t>(unknown - first)] = machine.cells[cell].part;
    }
    return parts;
}

std::vector<Vec3> Discretisation::support_points() const
{
    std::vector<Vec3> points(static_cast<std::size_t>(last - first));
    std::vector<PetscInt> unknowns;
    for (std::uint32_t cell = first_cell; cell < end_cell; ++cell) {
        unknowns_of(cell, unknowns);
        for (unsigned i = 0; i < unknowns.size(); ++i)
            if (owns(unknowns[i]))
                points[static_cast<std::size_t>(unknowns[i] - first)] = node_position(cell, i);
    }
    return points;
}

std::size_t Discretisation::vertex_unknown(std::uint32_t cell, unsigned node) const
{
    return static_cast<std::size_t>(unknowns_.at_node(machine.cells[cell].nodes[node]));
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
            if (space.owns_cell(faces[face_a].cell)) {
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
