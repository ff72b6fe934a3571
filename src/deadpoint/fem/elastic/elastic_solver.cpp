#include "deadpoint/fem/elastic/elastic_solver.hpp"

#include "deadpoint/error.hpp"
#include "deadpoint/exchange/face_points.hpp"
#include "deadpoint/fem/elastic/condensation.hpp"
#include "deadpoint/fem/elastic/elastic_cells.hpp"
#include "deadpoint/fem/elastic/rigid_pieces.hpp"
#include "deadpoint/fem/space/discretisation.hpp"
#include "deadpoint/fem/space/fields.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <set>
#include <variant>

namespace deadpoint::fem {
namespace {

constexpr double elastic_tolerance = 1e-10;
constexpr std::size_t block = 32;  ///< loads that are solved for together

void set_column(Mat dense, PetscInt k, Vec from)
{
    Vec column = nullptr;
    DEADPOINT_PETSC(MatDenseGetColumnVecWrite(dense, k, &column));
    DEADPOINT_PETSC(VecCopy(from, column));
    DEADPOINT_PETSC(MatDenseRestoreColumnVecWrite(dense, k, &column));
}

void take_column(Mat dense, PetscInt k, Vec to)
{
    Vec column = nullptr;
    DEADPOINT_PETSC(MatDenseGetColumnVecRead(dense, k, &column));
    DEADPOINT_PETSC(VecCopy(column, to));
    DEADPOINT_PETSC(MatDenseRestoreColumnVecRead(dense, k, &column));
}

// As PETSc calls a preconditioner of ours; no exception may pass through it.
PetscErrorCode apply_factor(PC shell, Vec right, Vec solution) noexcept
{
    void* factor = nullptr;
    const PetscErrorCode error = PCShellGetContext(shell, &factor);
    if (error != 0)
        return error;
    try {
        static_cast<SparseFactor*>(factor)->solve(right, solution);
    } catch (const ConvergenceError&) {
        return PETSC_ERR_LIB;
    }
    return 0;
}

}  // namespace

ElasticSolver::ElasticSolver(const Discretisation& space, const std::vector<Material>& materials,
                             const Foundation& foundation)
    : space_(space), materials_(materials), foundation_(foundation), ties_(space)
{
    find_supports(foundation);
    auto supported = held_;
    supported.insert(supported.end(), feet_.begin(), feet_.end());
    pieces_ = std::make_unique<RigidPieces>(space_, supported, ties_);
    held_.insert(held_.end(), pieces_->holds().begin(), pieces_->holds().end());
    ties_.hold(held_);

    assemble();
    PetscInt first_free = 0;
    DEADPOINT_PETSC(MatGetOwnershipRange(matrix_, &first_free, nullptr));
    const auto free = ties_.free_nodes(space_);
    const std::set<PetscInt> wanted(held_.begin(), held_.end());
    for (std::size_t i = 0; i < free.size(); ++i)
        for (PetscInt c = 0; c < 3; ++c)
            if (wanted.contains(3 * (space_.first + free[i]) + c))
                fixed_.push_back(first_free + static_cast<PetscInt>(3 * i) + c);
    PetscScalar trace = 0;
    PetscInt size = 0;
    DEADPOINT_PETSC(MatGetTrace(matrix_, &trace));
    DEADPOINT_PETSC(MatGetSize(matrix_, &size, nullptr));
    DEADPOINT_PETSC(MatZeroRowsColumns(matrix_, static_cast<PetscInt>(fixed_.size()), fixed_.data(), trace / size,
                                       nullptr, nullptr));
    choose_solver(size);
    DEADPOINT_PETSC(KSPSetOptionsPrefix(solver_, "deformation_"));
    DEADPOINT_PETSC(KSPSetFromOptions(solver_));
    solution_ = create_vector(space_, 3);
    rhs_ = create_vector(space_, 3);
    DEADPOINT_PETSC(MatCreateVecs(matrix_, free_solution_.out(), free_rhs_.out()));
    make_factor();
}

// A sparse factor serves all adjoints and field times, and thin frames of many plates, which multigrid takes hundreds
// of iterations for; beyond its memory, multigrid with the rigid motions.
void ElasticSolver::choose_solver(PetscInt size)
{
    const bool direct = size <= largest_factor;
    DEADPOINT_PETSC(KSPCreate(PETSC_COMM_WORLD, solver_.out()));
    DEADPOINT_PETSC(KSPSetType(solver_, KSPCG));
    DEADPOINT_PETSC(KSPSetInitialGuessNonzero(solver_, PETSC_TRUE));
    DEADPOINT_PETSC(KSPSetTolerances(solver_, elastic_tolerance, 1e-300, 1e12, 2000));
    PC preconditioner = nullptr;
    DEADPOINT_PETSC(KSPGetPC(solver_, &preconditioner));
    if (direct) {
        DEADPOINT_PETSC(PCSetType(preconditioner, PCSHELL));
    } else {
        DEADPOINT_PETSC(MatSetBlockSize(matrix_, 3));
        set_near_null_space();
        DEADPOINT_PETSC(PCSetType(preconditioner, PCGAMG));
    }
    DEADPOINT_PETSC(KSPSetOperators(solver_, matrix_, matrix_));
}

// Half the entries suffice for a factor. Options may have chosen another solver.
void ElasticSolver::make_factor()
{
    PC preconditioner = nullptr;
    PetscBool is_factor = PETSC_FALSE;
    DEADPOINT_PETSC(KSPGetPC(solver_, &preconditioner));
    DEADPOINT_PETSC(PetscObjectTypeCompare(reinterpret_cast<PetscObject>(preconditioner), PCSHELL, &is_factor));
    if (!is_factor)
        return;
    upper_half_ = std::make_unique<SymmetricTriplets>(matrix_);
    operator_ = std::make_unique<ShellMatrix>(static_cast<PetscInt>(upper_half_->owned()), upper_half_->size(),
                                              [this](Vec in, Vec out) { upper_half_->multiply(in, out); });
    DEADPOINT_PETSC(KSPSetOperators(solver_, *operator_, *operator_));
    matrix_.reset();
    factor_ = std::make_unique<SparseFactor>(*upper_half_, 3);
    factor_->factorise(*upper_half_);
    DEADPOINT_PETSC(PCShellSetContext(preconditioner, factor_.get()));
    DEADPOINT_PETSC(PCShellSetApply(preconditioner, apply_factor));
}

void ElasticSolver::take_free_load()
{
    DEADPOINT_PETSC(MatMultTranspose(expansion_, rhs_, free_rhs_));
    clear_fixed(free_rhs_);
}

// Solves for rhs_ and stores the result in solution_. Without a factor a previous solution in free_solution_ is the
// first guess.
void ElasticSolver::solve_free(const char* what)
{
    take_free_load();
    PetscReal size = 0;
    DEADPOINT_PETSC(VecNorm(free_rhs_, NORM_INFINITY, &size));
    if (!(size > 0) && !std::isnan(size)) {
        DEADPOINT_PETSC(VecSet(free_solution_, 0));
    } else if (factor_) {
        const auto right = free_columns(1), solution = free_columns(1);
        set_column(right, 0, free_rhs_);
        const bool solved = factor_solver_.solve(*upper_half_, *factor_, right, solution, elastic_tolerance);
        take_column(solution, 0, free_solution_);
        iterations_ += solved ? 1 : solve(solver_, free_rhs_, free_solution_, what);
    } else {
        iterations_ += solve(solver_, free_rhs_, free_solution_, what);
    }
    DEADPOINT_PETSC(MatMult(expansion_, free_solution_, solution_));
}

// Loads or displacements of the free nodes, a column each.
OwnedMat ElasticSolver::free_columns(PetscInt count) const
{
    PetscInt rows = 0;
    DEADPOINT_PETSC(VecGetLocalSize(free_rhs_, &rows));
    return dense_columns(rows, count);
}

void ElasticSolver::solve_all(std::size_t count, const char* what, const std::function<void(std::size_t)>& load,
                              const std::function<void(std::size_t)>& take)
{
    if (factor_) {
        for (std::size_t first = 0; first < count; first += block)
            solve_block(first, std::min(first + block, count), what, load, take);
        return;
    }
    for (std::size_t k = 0; k < count; ++k) {
        load(k);
        DEADPOINT_PETSC(VecSet(free_solution_, 0));
        solve_free(what);
        take(k);
    }
}

void ElasticSolver::solve_block(std::size_t first, std::size_t last, const char* what,
                                const std::function<void(std::size_t)>& load,
                                const std::function<void(std::size_t)>& take)
{
    const auto count = static_cast<PetscInt>(last - first);
    const auto right = free_columns(count), solution = free_columns(count);
    for (PetscInt k = 0; k < count; ++k) {
        load(first + static_cast<std::size_t>(k));
        take_free_load();
        set_column(right, k, free_rhs_);
    }
    const bool solved = factor_solver_.solve(*upper_half_, *factor_, right, solution, elastic_tolerance);
    for (PetscInt k = 0; k < count; ++k) {
        take_column(solution, k, free_solution_);
        if (solved) {
            DEADPOINT_PETSC(MatMult(expansion_, free_solution_, solution_));
        } else {
            load(first + static_cast<std::size_t>(k));
            solve_free(what);
        }
        take(first + static_cast<std::size_t>(k));
    }
}

namespace {

// Means over the feet's area of their normals, out of the machine, and of the squares of the normals' components.
struct FootNormals {
    Vec3 mean{};
    Vec3 squares{};
};

FootNormals foot_normals(const Machine& machine, const MeshSurface& feet)
{
    FootNormals sum;
    double area = 0;
    for (const auto& foot : feet.faces) {
        const auto& face = machine.faces[foot.face];
        const auto* plane = std::get_if<PlaneGeometry>(&machine.geometries[face.geometry]);
        const Vec3 n = plane ? plane->normal : Vec3{};
        for (const auto& point : face_points(machine, face)) {
            sum.mean = sum.mean + point.weight * n;
            sum.squares = sum.squares + point.weight * Vec3{n[0] * n[0], n[1] * n[1], n[2] * n[2]};
            area += point.weight;
        }
    }
    return area > 0 ? FootNormals{(1 / area) * sum.mean, (1 / area) * sum.squares} : sum;
}

// The axis along which the feet face; -y if they face in several directions.
Vec3 foot_normal(const Machine& machine, const Foundation& foundation)
{
    constexpr double even = 0.999, along_axis = 1 - 1e-9;
    const Vec3 down{0, -1, 0};
    if (foundation.surface < 0 || foundation.kind == Foundation::Kind::clamped)
        return down;
    const auto [normal, squares] = foot_normals(machine, machine.surfaces[foundation.surface]);
    for (std::size_t c = 0; c < 3; ++c)
        if (squares[c] > along_axis) {
            Vec3 axis{};
            axis[c] = normal[c] > 0 ? 1 : -1;
            return axis;
        }
    if (norm(normal) < even)
        return down;
    throw InputError(fmt::format("surfaces.{}: the feet look along ({:.4g}, {:.4g}, {:.4g}), which is no axis, so they "
                                 "cannot slide in their plane\n  help: add kind = \"clamped\" to [foundation], or turn "
                                 "the coordinates so that the feet look along x, y or z",
                                 machine.surfaces[foundation.surface].name, normal[0], normal[1], normal[2]));
}

}  // namespace

void ElasticSolver::find_supports(const Foundation& foundation)
{
    foot_normal_ = foot_normal(space_.machine, foundation);
    std::set<PetscInt> held, feet;
    PointShape shape;
    const auto collect = [&](std::uint32_t face, int component, std::set<PetscInt>& target) {
        for (const auto& point : face_points(space_.machine, space_.machine.faces[face])) {
            space_.evaluate(face, point.position, false, shape);
            for (int i = 0; i < shape.count; ++i)
                if (std::abs(shape.value[i]) > 1e-9)
                    target.insert(3 * shape.dof[i] + component);
        }
    };
    for (std::uint32_t f = 0; f < space_.machine.faces.size(); ++f)
        if (space_.machine.faces[f].symmetry)
            collect(f, 0, held);
    const bool elastic = foundation.kind == Foundation::Kind::elastic;
    const bool sideways = elastic ? foundation.horizontal > 0 : foundation.kind == Foundation::Kind::clamped;
    if (foundation.surface >= 0)
        for (const auto& foot : space_.machine.surfaces[foundation.surface].faces)
            for (const int component : {0, 1, 2})
                if ((foot_normal_[static_cast<std::size_t>(component)] != 0 || sideways) && (elastic || foot.central))
                    collect(foot.face, component, feet);
    if (!elastic)
        held.insert(feet.begin(), feet.end());
    held_.assign(held.begin(), held.end());
    feet_.assign(feet.begin(), feet.end());
}

void ElasticSolver::clear_fixed(Vec vector) const
{
    double* values = nullptr;
    DEADPOINT_PETSC(VecGetArray(vector, &values));
    PetscInt first_free = 0;
    DEADPOINT_PETSC(VecGetOwnershipRange(vector, &first_free, nullptr));
    for (const PetscInt row : fixed_)
        values[row - first_free] = 0;
    DEADPOINT_PETSC(VecRestoreArray(vector, &values));
}

void ElasticSolver::assemble()
{
    const Condensation condensation(space_, ties_);
    Couplings couplings(condensation.first(), condensation.last());
    for (std::uint32_t cell = 0; cell < space_.machine.cells.size(); ++cell)
        couplings.add(condensation.free_nodes(space_.unknowns_of(cell)));
    matrix_ = create_matrix(by_blocks(couplings.rows(), 3));
    couplings = {0, 0};
    std::vector<PetscInt> nodes;
    std::vector<double> block;
    const auto add = [&] {
        const auto free = condensation.condense(nodes, block);
        const auto count = static_cast<PetscInt>(free.size());
        DEADPOINT_PETSC(MatSetValues(matrix_, count, free.data(), count, free.data(), block.data(), ADD_VALUES));
    };
    for_each_cell(space_, [&](const CellValues& v, const auto& dofs, int part) {
        cell_stiffness(v, materials_[part], block);
        nodes.assign(dofs.begin(), dofs.end());
        add();
    });
    for_each_pad([&](const PointShape& shape, const std::vector<double>& pad) {
        nodes.assign(shape.dof.begin(), shape.dof.begin() + shape.count);
        block = pad;
        add();
    });
    DEADPOINT_PETSC(MatAssemblyBegin(matrix_, MAT_FINAL_ASSEMBLY));
    DEADPOINT_PETSC(MatAssemblyEnd(matrix_, MAT_FINAL_ASSEMBLY));
    DEADPOINT_PETSC(MatSetOption(matrix_, MAT_SPD, PETSC_TRUE));
    expansion_ = ties_.expansion(space_);
}

void ElasticSolver::set_near_null_space()
{
    OwnedVec coordinates;
    DEADPOINT_PETSC(MatCreateVecs(matrix_, coordinates.out(), nullptr));
    DEADPOINT_PETSC(VecSetBlockSize(coordinates, 3));
    const auto points = space_.support_points();
    const auto free = ties_.free_nodes(space_);
    double* values = nullptr;
    DEADPOINT_PETSC(VecGetArray(coordinates, &values));
    for (std::size_t i = 0; i < free.size(); ++i)
        std::copy(points[free[i]].begin(), points[free[i]].end(), values + 3 * i);
    DEADPOINT_PETSC(VecRestoreArray(coordinates, &values));
    OwnedNullSpace rigid;
    DEADPOINT_PETSC(MatNullSpaceCreateRigidBody(coordinates, rigid.out()));
    DEADPOINT_PETSC(MatSetNearNullSpace(matrix_, rigid));
}

void ElasticSolver::load(const Functional& functional, Vec target) const
{
    std::vector<std::pair<PetscInt, double>> entries;
    PointShape shape;
    DEADPOINT_PETSC(VecSet(target, 0));
    double* values = nullptr;
    DEADPOINT_PETSC(VecGetArray(target, &values));
    for (const auto& point : functional.points) {
        space_.evaluate(point.face, point.position, false, shape);
        for (int i = 0; i < shape.count; ++i)
            if (space_.owns(shape.dof[i]))
                for (int c = 0; c < 3; ++c)
                    values[3 * (shape.dof[i] - space_.first) + c] += shape.value[i] * point.weight[c];
    }
    DEADPOINT_PETSC(VecRestoreArray(target, &values));
}

void ElasticSolver::load_dual(const Functional& functional)
{
    load(functional, rhs_);
    pieces_->equilibrate(rhs_);
}

Displacement ElasticSolver::dual(const Functional& functional)
{
    load_dual(functional);
    DEADPOINT_PETSC(VecSet(free_solution_, 0));
    solve_free("the deformation's adjoint");
    return owned_solution();
}

std::vector<Adjoint> ElasticSolver::adjoints(const std::vector<Functional>& functionals)
{
    std::vector<Adjoint> result;
    Pending pending;
    Gathered gathered(solution_);
    solve_all(
        functionals.size(), "the deformation's adjoint", [&](std::size_t k) { load_dual(functionals[k]); },
        [&](std::size_t k) {
            const double* all = gathered.gather(solution_);
            add_adjoint(pending, functionals[k].name, {all, all + 3 * space_.total}, result);
        });
    finish_adjoints(pending, result);
    return result;
}

Displacement ElasticSolver::displacement(const Field& rise)
{
    DEADPOINT_PETSC(VecSet(rhs_, 0));
    load_thermal(rise, rhs_);
    solve_free("the thermal deformation");
    pieces_->remove_rigid_motion(solution_);
    return owned_solution();
}

std::vector<Displacement> ElasticSolver::displacements(const std::vector<Field>& rises)
{
    std::vector<Displacement> result;
    const auto load_rise = [&](std::size_t k) {
        DEADPOINT_PETSC(VecSet(rhs_, 0));
        load_thermal(rises[k], rhs_);
    };
    solve_all(rises.size(), "the thermal deformation", load_rise, [&](std::size_t) {
        pieces_->remove_rigid_motion(solution_);
        result.push_back(owned_solution());
    });
    return result;
}

Displacement ElasticSolver::displacement(const RestLoads& loads)
{
    DEADPOINT_PETSC(VecSet(rhs_, 0));
    load_weight(loads.gravity, rhs_);
    require_equilibrium();
    load_initial_strain(loads.initial_strain, rhs_);
    DEADPOINT_PETSC(VecSet(free_solution_, 0));
    solve_free("the deformation by weights and preload");
    pieces_->remove_rigid_motion(solution_);
    return owned_solution();
}

// Refuses a load that the feet cannot carry.
void ElasticSolver::require_equilibrium()
{
    PetscReal whole = 0, moving = 0;
    DEADPOINT_PETSC(VecNorm(rhs_, NORM_2, &whole));
    DEADPOINT_PETSC(VecCopy(rhs_, solution_));
    pieces_->equilibrate(solution_);
    DEADPOINT_PETSC(VecAXPY(solution_, -1, rhs_));
    DEADPOINT_PETSC(VecNorm(solution_, NORM_2, &moving));
    if (moving > 1e-6 * whole)
        throw InputError("the feet leave the machine free to follow its weight; let gravity act straight down on feet "
                         "that carry the machine, or add kind = \"clamped\" to [foundation]");
}

Displacement ElasticSolver::owned_solution() const
{
    Displacement result;
    const double* owned = nullptr;
    DEADPOINT_PETSC(VecGetArrayRead(solution_, &owned));
    result.owned.assign(owned, owned + 3 * (space_.last - space_.first));
    DEADPOINT_PETSC(VecRestoreArrayRead(solution_, &owned));
    return result;
}

std::vector<double> ElasticSolver::evaluate(const std::vector<Functional>& functionals,
                                            const Displacement& displacement)
{
    std::vector<double> sums(functionals.size(), 0.0);
    PointShape shape;
    for (std::size_t k = 0; k < functionals.size(); ++k)
        for (const auto& point : functionals[k].points) {
            space_.evaluate(point.face, point.position, false, shape);
            for (int i = 0; i < shape.count; ++i)
                if (space_.owns(shape.dof[i]))
                    for (int c = 0; c < 3; ++c)
                        sums[k] += shape.value[i] * point.weight[c] *
                                   displacement.owned[3 * static_cast<std::size_t>(shape.dof[i] - space_.first) + c];
        }
    sum_over_ranks(sums);
    return sums;
}

}  // namespace deadpoint::fem
