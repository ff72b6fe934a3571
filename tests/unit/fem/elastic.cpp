/// Requirement: ties, rigid pieces and the solve of the deformation pass what must pass exactly: rigid motions, even
/// warmth, uniform stress; and the adjoint says what the deformation says.
#include "bricks.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/exchange/face_points.hpp"
#include "deadpoint/exchange/machine.hpp"
#include "deadpoint/fem/elastic/condensation.hpp"
#include "deadpoint/fem/elastic/dual_functions.hpp"
#include "deadpoint/fem/elastic/elastic_law.hpp"
#include "deadpoint/fem/elastic/elastic_solver.hpp"
#include "deadpoint/fem/elastic/rigid_pieces.hpp"
#include "deadpoint/fem/elastic/stress_recovery.hpp"
#include "deadpoint/fem/space/discretisation.hpp"
#include "deadpoint/fem/space/fields.hpp"
#include "near.hpp"

#include <doctest/doctest.h>
#include <numeric>
#include <set>

using namespace deadpoint;
using namespace deadpoint::fem;
using bricks::Brick;

namespace {

using VectorField = std::function<Vec3(const Vec3&)>;
const auto steel = bricks::steel();
const std::vector<Material> steels(2, steel);  // a solver keeps a reference

/// Two bonded blocks, 0.2 x 0.1 m2 and 0.1 m high each, whose meshes do not match at y = 0.1.
Machine bonded()
{
    auto machine = bricks::machine_of(
        {{{0, 0, 0}, {0.2, 0.1, 0.1}, {2, 1, 1}, false, {}}, {{0, 0.1, 0}, {0.2, 0.2, 0.1}, {3, 2, 2}, false, {}}});
    machine.bonds = {bricks::contact(machine, 0, 1, 1)};
    return machine;
}

std::vector<double> displacement_of(const Discretisation& space, const VectorField& field)
{
    std::vector<double> result;
    for (const auto& x : space.support_points())
        for (const double u : field(x))
            result.push_back(u);
    return result;
}

/// Largest of a displacement less another one, apart from the rigid motion that fits the difference best.
double apart(const Discretisation& space, const std::vector<double>& u, const VectorField& field)
{
    const auto places = space.support_points();
    const auto count = static_cast<Eigen::Index>(3 * places.size());
    Eigen::MatrixXd motions = Eigen::MatrixXd::Zero(count, 6);
    for (std::size_t i = 0; i < places.size(); ++i)
        for (int axis = 0; axis < 3; ++axis) {
            const auto row = static_cast<Eigen::Index>(3 * i);
            motions(row + axis, axis) = 1;
            const auto turned = cross(Vec3{axis == 0 ? 1.0 : 0, axis == 1 ? 1.0 : 0, axis == 2 ? 1.0 : 0}, places[i]);
            for (int c = 0; c < 3; ++c)
                motions(row + c, 3 + axis) = turned[static_cast<std::size_t>(c)];
        }
    const Eigen::VectorXd difference = bricks::column(u) - bricks::column(displacement_of(space, field));
    return (difference - motions * motions.colPivHouseholderQr().solve(difference)).lpNorm<Eigen::Infinity>();
}

/// Force per area on a side of a part.
void pull(const Machine& machine, std::uint32_t part, std::size_t axis, bool up, const Vec3& traction, Functional& load)
{
    for (const auto face : bricks::side(machine, part, axis, up))
        for (const auto& point : face_points(machine, machine.faces[face]))
            load.points.push_back({face, point.position, point.weight * traction});
}

Functional stretch(const Machine& machine)
{
    Functional result;
    for (std::uint32_t f = 0; f < machine.faces.size(); ++f)
        for (const auto& point : face_points(machine, machine.faces[f])) {
            const auto& x = point.position;
            result.points.push_back({f, x, point.weight * Vec3{x[0] + 2 * x[1], 3 * x[1] - x[2], x[2] + 0.5 * x[0]}});
        }
    return result;
}

CoveredFace square(double from, double to)
{
    CoveredFace face;
    const std::array<double, 3> at{0.5 - std::sqrt(0.15), 0.5, 0.5 + std::sqrt(0.15)},
        weight{5 / 18.0, 8 / 18.0, 5 / 18.0};
    face.shape.resize(9, 4);
    face.weight.resize(9);
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
            const double x = from + at[i] * (to - from), y = at[j];
            face.shape.row(3 * i + j) << (1 - x) * (1 - y), x * (1 - y), x * y, (1 - x) * y;
            face.weight[3 * i + j] = weight[i] * weight[j] * (to - from);
        }
    return face;
}

}  // namespace

TEST_CASE("dual functions: orthogonal to all shape functions but their own, and one in the sum")
{
    for (const auto& face : {square(0, 1), square(0, 0.6)})
        for (const auto& chosen : {std::vector<int>{0, 1, 2, 3}, std::vector<int>{0, 3}, std::vector<int>{0, 2, 3}}) {
            const auto psi = dual_functions(face, chosen);
            REQUIRE(psi);
            const Eigen::MatrixXd products = psi->transpose() * face.weight.asDiagonal() * face.shape;
            for (std::size_t i = 0; i < chosen.size(); ++i)
                for (std::size_t j = 0; j < chosen.size(); ++j) {
                    const double expected = i == j ? face.weight.dot(face.shape.col(chosen[j])) : 0;
                    CHECK(std::abs(products(static_cast<Eigen::Index>(i), chosen[j]) - expected) < 1e-14);
                }
            CHECK((psi->rowwise().sum() - Eigen::VectorXd::Ones(9)).norm() < 1e-12);
        }
}

TEST_CASE("where a face is hardly covered there are no dual functions of its far nodes")
{
    CHECK_FALSE(dual_functions(square(0, 0.02), {0, 1, 2, 3}));
    CHECK(dual_functions(square(0, 0.02), {0, 3}));
    CHECK_FALSE(dual_functions(square(0, 0.001), {1, 2}));
}

TEST_CASE("ties: the finer side's nodes follow the coarser side's, with weights that keep linear displacements")
{
    for (const auto& orders : {std::vector<int>{1, 1}, std::vector<int>{2, 2}, std::vector<int>{1, 2}}) {
        const bricks::Space both(bonded(), orders);
        const Ties ties(both.space);
        const auto places = both.space.support_points();
        const auto parts = both.space.part_of_unknown();
        std::size_t tied = 0;
        for (std::size_t i = 0; i < places.size(); ++i) {
            const bool at_bond = parts[i] == 1 && std::abs(places[i][1] - 0.1) < 1e-9;
            CHECK(ties.is_tied(static_cast<PetscInt>(i)) == at_bond);
            tied += at_bond;
        }
        CHECK(ties.ties().size() == tied);
        std::set<PetscInt> before;
        for (const auto& tie : ties.ties()) {
            double sum = 0;
            Vec3 place{};
            for (const auto& [node, weight] : tie.masters) {
                sum += weight;
                place = place + weight * places[static_cast<std::size_t>(node)];
                CHECK((!ties.is_tied(node) || before.contains(node)));
            }
            CHECK(sum == near(1, 1e-12));
            CHECK(norm(place - places[static_cast<std::size_t>(tie.node)]) < 1e-12);
            before.insert(tie.node);
        }
        CHECK(ties.free_nodes(both.space).size() + tied == places.size());
    }
}

TEST_CASE("the expansion makes all displacements of the free ones, and holds what is to be held")
{
    const bricks::Space both(bonded(), {1, 1});
    Ties ties(both.space);
    const auto linear = displacement_of(both.space, [](const Vec3& x) {
        return Vec3{x[0] + 2, x[1] - x[2], 3 * x[0]};
    });
    const auto free = ties.free_nodes(both.space);
    Eigen::VectorXd of_free(static_cast<Eigen::Index>(3 * free.size()));
    for (std::size_t i = 0; i < free.size(); ++i)
        for (int c = 0; c < 3; ++c)
            of_free[static_cast<Eigen::Index>(3 * i) + c] = linear[static_cast<std::size_t>(3 * free[i] + c)];
    const auto expansion = bricks::dense(ties.expansion(both.space));
    CHECK((expansion * of_free - bricks::column(linear)).norm() < 1e-12);
    const auto node = ties.ties().front().node;
    CHECK(ties.follows(node, 1));
    ties.hold({3 * node + 1});
    CHECK_FALSE(ties.follows(node, 1));
    CHECK(ties.follows(node, 0));
    CHECK(bricks::dense(ties.expansion(both.space)).row(3 * node + 1).norm() == 0);
    CHECK(bricks::dense(ties.expansion(both.space)).row(3 * node) == expansion.row(3 * node));
}

TEST_CASE("a condensed cell matrix is that of the free displacements")
{
    const bricks::Space both(bonded(), {1, 1});
    Ties ties(both.space);
    ties.hold({3 * ties.ties().front().node + 1});
    const Condensation condensation(both.space, ties);
    const auto expansion = bricks::dense(ties.expansion(both.space));
    CHECK(condensation.first() == 0);
    CHECK(3 * condensation.last() == expansion.cols());
    bool some_tied = false;
    for (std::uint32_t cell = 0; cell < both.machine.cells.size(); ++cell) {
        const auto nodes = both.space.unknowns_of(cell);
        const auto count = static_cast<Eigen::Index>(3 * nodes.size());
        std::vector<double> matrix(static_cast<std::size_t>(count * count));
        for (std::size_t k = 0; k < matrix.size(); ++k)
            matrix[k] = std::sin(1.0 + static_cast<double>(k));
        Eigen::MatrixXd all = Eigen::MatrixXd::Zero(expansion.rows(), expansion.rows());
        for (Eigen::Index i = 0; i < count; ++i)
            for (Eigen::Index j = 0; j < count; ++j)
                all(3 * nodes[static_cast<std::size_t>(i / 3)] + i % 3,
                    3 * nodes[static_cast<std::size_t>(j / 3)] + j % 3) =
                    matrix[static_cast<std::size_t>(i * count + j)];
        const auto free = condensation.condense(nodes, matrix);
        REQUIRE(matrix.size() == free.size() * free.size());
        some_tied = some_tied || free.size() != 3 * nodes.size();
        Eigen::MatrixXd condensed = Eigen::MatrixXd::Zero(expansion.cols(), expansion.cols());
        for (std::size_t i = 0; i < free.size(); ++i)
            for (std::size_t j = 0; j < free.size(); ++j)
                condensed(free[i], free[j]) = matrix[i * free.size() + j];
        CHECK((condensed - expansion.transpose() * all * expansion).norm() < 1e-12 * all.norm());
        const auto numbers = condensation.free_nodes(nodes);
        for (const PetscInt displacement : free)
            CHECK(std::ranges::find(numbers, displacement / 3) != numbers.end());
    }
    CHECK(some_tied);
}

TEST_CASE("a factor that is not exact is found out and refined")
{
    // A tridiagonal matrix, and the factor of one that differs by a share.
    constexpr PetscInt count = 50;
    const auto matrix_of = [&](double diagonal) {
        OwnedMat matrix;
        DEADPOINT_PETSC(MatCreateSeqAIJ(PETSC_COMM_SELF, count, count, 3, nullptr, matrix.out()));
        for (PetscInt i = 0; i < count; ++i)
            for (PetscInt j = std::max(0, i - 1); j < std::min(count, i + 2); ++j)
                DEADPOINT_PETSC(MatSetValue(matrix, i, j, i == j ? diagonal : -1, INSERT_VALUES));
        DEADPOINT_PETSC(MatAssemblyBegin(matrix, MAT_FINAL_ASSEMBLY));
        DEADPOINT_PETSC(MatAssemblyEnd(matrix, MAT_FINAL_ASSEMBLY));
        return matrix;
    };
    const auto matrix = matrix_of(3);
    const auto right = dense_columns(count, 2), solution = dense_columns(count, 2);
    double* entries = nullptr;
    DEADPOINT_PETSC(MatDenseGetArray(right, &entries));
    for (PetscInt i = 0; i < 2 * count; ++i)
        entries[i] = std::sin(1.0 + i);
    DEADPOINT_PETSC(MatDenseRestoreArray(right, &entries));
    const auto solve_with = [&](double diagonal) {
        const auto other = matrix_of(diagonal);
        const SymmetricTriplets half(other);
        SparseFactor factor(half, 1);
        factor.factorise(half);
        FactorSolver solver;
        return solver.solve(SymmetricTriplets(matrix), factor, right, solution, 1e-10);
    };
    const auto residual = [&] {
        OwnedMat product;
        double size = 0;
        DEADPOINT_PETSC(MatMatMult(matrix, solution, MAT_INITIAL_MATRIX, PETSC_DEFAULT, product.out()));
        DEADPOINT_PETSC(MatAXPY(product, -1, right, SAME_NONZERO_PATTERN));
        DEADPOINT_PETSC(MatNorm(product, NORM_FROBENIUS, &size));
        return size;
    };
    CHECK(solve_with(3));
    CHECK(residual() < 1e-13);
    CHECK(solve_with(3 + 1e-6));  // each round gains six places
    CHECK(residual() < 1e-10);
    CHECK_FALSE(solve_with(4));
}

TEST_CASE("a free body has six motions to hold; what is supported needs fewer, what is bonded is one piece")
{
    auto apart_machine = bonded();
    apart_machine.bonds.clear();
    const bricks::Space both(bonded(), {1, 1}), two(apart_machine, {1, 1});
    const Ties ties(both.space), none(two.space);
    CHECK(RigidPieces(both.space, {}, ties).holds().size() == 6);
    CHECK(RigidPieces(two.space, {}, none).holds().size() == 12);
    CHECK(RigidPieces(both.space, {}, ties).piece(0) == RigidPieces(both.space, {}, ties).piece(both.space.total - 1));
    std::vector<PetscInt> feet, all;
    const auto places = both.space.support_points();
    for (std::size_t i = 0; i < places.size(); ++i)
        if (places[i][1] < 1e-9)
            for (PetscInt c = 0; c < 3; ++c) {
                all.push_back(static_cast<PetscInt>(3 * i) + c);
                if (c == 1)
                    feet.push_back(all.back());
            }
    CHECK(RigidPieces(both.space, feet, ties).holds().size() == 3);  // slides and turns on its feet
    CHECK(RigidPieces(both.space, all, ties).holds().empty());
}

TEST_CASE("what is taken out is the rigid motion, all of it and nothing else")
{
    const bricks::Space both(bonded(), {1, 2});
    const RigidPieces pieces(both.space, {}, Ties(both.space));
    const auto rigid = displacement_of(both.space, [](const Vec3& x) {
        return Vec3{1, -2, 3} + cross({0.5, 2, -1}, x);
    });
    const auto strained = displacement_of(both.space, [](const Vec3& x) {
        return Vec3{x[0] * x[1], x[2], x[1] * x[1]};
    });
    auto vector = bricks::vector_of(both.space, rigid, 3);
    pieces.remove_rigid_motion(vector);
    CHECK(bricks::dense(vector).norm() < 1e-11);
    vector = bricks::vector_of(both.space, strained, 3);
    pieces.remove_rigid_motion(vector);
    const auto once = bricks::dense(vector);
    pieces.remove_rigid_motion(vector);
    CHECK((bricks::dense(vector) - once).norm() < 1e-12 * once.norm());
    auto sum = bricks::column(rigid);
    sum += bricks::column(strained);
    auto both_motions = bricks::vector_of(both.space, {sum.begin(), sum.end()}, 3);
    pieces.remove_rigid_motion(both_motions);
    CHECK((bricks::dense(both_motions) - once).norm() < 1e-11);
}

TEST_CASE("a load in equilibrium does no work in a rigid motion, and is the transposed of the motion's removal")
{
    const bricks::Space both(bonded(), {1, 1});
    const RigidPieces pieces(both.space, {}, Ties(both.space));
    const auto load = displacement_of(both.space, [](const Vec3& x) { return Vec3{x[1] + 3, x[0] * x[2], 7 - x[1]}; });
    const auto field = displacement_of(both.space, [](const Vec3& x) { return Vec3{x[2], 2 + x[0] * x[0], x[1]}; });
    auto balanced = bricks::vector_of(both.space, load, 3), relative = bricks::vector_of(both.space, field, 3);
    pieces.equilibrate(balanced);
    pieces.remove_rigid_motion(relative);
    for (int k = 0; k < 6; ++k) {
        const auto motion = displacement_of(both.space, [k](const Vec3& x) {
            Vec3 axis{};
            axis[static_cast<std::size_t>(k % 3)] = 1;
            return k < 3 ? axis : cross(axis, x);
        });
        CHECK(std::abs(bricks::dense(balanced).dot(bricks::column(motion))) < 1e-11);
    }
    CHECK(bricks::dense(balanced).dot(bricks::column(field)) ==
          near(bricks::column(load).dot(bricks::dense(relative)), 1e-11));
}

TEST_CASE("an evenly warm machine of free bonded blocks grows by alpha dT x")
{
    for (const auto& orders : {std::vector<int>{1, 1}, std::vector<int>{2, 2}}) {
        const bricks::Space both(bonded(), orders);
        ElasticSolver solver(both.space, steels, {});
        const Field rise{std::vector<double>(static_cast<std::size_t>(both.space.total), 50.0)};
        const auto u = solver.displacement(rise).owned;
        const auto grown = [](const Vec3& x) { return 1.2e-5 * 50 * x; };
        CHECK(apart(both.space, u, grown) < 1e-9 * 1.2e-4);  // the solver's 1e-10 of 0.1 mm
        CHECK(solver.iterations() > 0);
    }
}

TEST_CASE("deformations solved for together are those of each alone")
{
    const bricks::Space both(bonded(), {2, 1});
    ElasticSolver together(both.space, steels, {}), alone(both.space, steels, {});
    std::vector<Field> rises;
    for (int k = 0; k < 40; ++k)  // more than one block; one without any load
        rises.push_back(
            {bricks::values_of(both.space, [k](const Vec3& x) { return k * (1 + std::sin(k * x[0]) + x[1]); })});
    const auto found = together.displacements(rises);
    REQUIRE(found.size() == rises.size());
    CHECK(together.iterations() == 0);  // the factor alone reached the tolerance
    for (std::size_t k = 0; k < rises.size(); ++k) {
        const auto wanted = bricks::column(alone.displacement(rises[k]).owned);
        CHECK((bricks::column(found[k].owned) - wanted).norm() <= 1e-9 * wanted.norm());  // each to 1e-10
    }
}

TEST_CASE("a linear rise bends a free block without stress, exactly with elements of second order")
{
    for (const bool tetrahedra : {false, true}) {
        const bricks::Space part(Brick{{0, 0, 0}, {0.3, 0.1, 0.2}, {2, 1, 2}, tetrahedra, {}}, 2);
        ElasticSolver solver(part.space, steels, {});
        const auto rise = bricks::values_of(part.space, [](const Vec3& x) { return 10 + 100 * x[0] - 40 * x[2]; });
        const auto u = solver.displacement(Field{rise}).owned;
        // alpha ((c + a . x) x - a |x|^2 / 2), whose strain is alpha (c + a . x) in all directions.
        const VectorField free = [](const Vec3& x) {
            return 1.2e-5 * ((10 + 100 * x[0] - 40 * x[2]) * x - 0.5 * dot(x, x) * Vec3{100, 0, -40});
        };
        CHECK(apart(part.space, u, free) < 1e-8 * 1e-4);
        const StressRecovery stress(part.space, steel, 0, {u.data(), rise.data(), {}});
        for (std::size_t node = 0; node < stress.nodes().size(); ++node)
            for (const double s : stress.at_node(node))
                CHECK(std::abs(s) < 1);  // of E alpha 40 K = 1e8 Pa
    }
}

TEST_CASE("patch test: blocks that are pulled stand under uniform stress, across meshes that do not match")
{
    const bricks::Space both(bonded(), {1, 1});
    ElasticSolver solver(both.space, steels, {});
    Functional load;
    pull(both.machine, 1, 1, true, {0, 1e6, 0}, load);
    pull(both.machine, 0, 1, false, {0, -1e6, 0}, load);
    const auto u = solver.dual(load).owned;
    const double strain = 1e6 / 2.1e11;
    const VectorField exact = [&](const Vec3& x) {
        return Vec3{-0.3 * strain * x[0], strain * x[1], -0.3 * strain * x[2]};
    };
    CHECK(apart(both.space, u, exact) < 1e-8 * strain);
    for (const int part : {0, 1}) {
        const StressRecovery stress(both.space, steel, part, {u.data(), nullptr, {}});
        for (std::size_t node = 0; node < stress.nodes().size(); ++node) {
            const auto s = stress.at_node(node);
            CHECK(s[1] == near(1e6, 1e-6));
            for (const std::size_t c : {0, 2, 3, 4, 5})
                CHECK(std::abs(s[c]) < 1);
        }
    }
}

TEST_CASE("adjoint weights give what the deformation gives, for any rise")
{
    auto materials = steels;
    materials[1].expansion = 2e-5;
    for (const auto& orders : {std::vector<int>{1, 1}, std::vector<int>{1, 2}}) {
        const bricks::Space both(bonded(), orders);
        ElasticSolver solver(both.space, materials, {});
        const std::vector<Functional> wanted{stretch(both.machine)};
        const auto rise =
            bricks::values_of(both.space, [](const Vec3& x) { return 30 + 200 * x[0] * x[1] - 90 * x[2]; });
        const double direct = solver.evaluate(wanted, solver.displacement(Field{rise}))[0];
        const auto adjoint = solver.adjoints(wanted)[0];
        CHECK(bricks::column(adjoint.owned).dot(bricks::column(rise)) == near(direct, 1e-8));
        CHECK(std::abs(direct) > 1e-9);
    }
}

TEST_CASE("duals of loads in equilibrium are reciprocal: the work of one load in the other's displacement")
{
    const bricks::Space both(bonded(), {1, 1});
    ElasticSolver solver(both.space, steels, {});
    Functional upward, sideways;
    pull(both.machine, 1, 1, true, {0, 2e5, 0}, upward);
    pull(both.machine, 0, 1, false, {0, -2e5, 0}, upward);
    pull(both.machine, 1, 0, true, {3e5, 0, 0}, sideways);
    pull(both.machine, 1, 0, false, {-3e5, 0, 0}, sideways);
    const double one = solver.evaluate({sideways}, solver.dual(upward))[0];
    const double other = solver.evaluate({upward}, solver.dual(sideways))[0];
    CHECK(one == near(other, 1e-8));
    // Uniform stress narrows the upper block by nu sigma / E over 0.2 m, where 3e5 Pa pull on 0.1 x 0.1 m2.
    CHECK(one == near(-0.3 * 2e5 / 2.1e11 * 0.2 * 3e5 * 0.01, 1e-7));
}

TEST_CASE("a column without contraction stands under its own weight as a bar does, and its feet carry it")
{
    std::vector<Material> materials{steel};
    materials[0].poissons_ratio = 0;
    auto machine = bricks::machine_of({{{0, 0, 0}, {0.2, 0.6, 0.1}, {1, 3, 1}, false, {}}});
    const int feet = bricks::add_surface(machine, 0, 1, false);
    const bricks::Space part(machine, {2});
    for (const auto kind : {Foundation::Kind::free, Foundation::Kind::clamped}) {
        ElasticSolver solver(part.space, materials, {feet, kind, 0, 0});
        const RestLoads loads{{0, -9.81, 0}, {}};
        const auto displacement = solver.displacement(loads);
        const VectorField exact = [](const Vec3& x) {
            return Vec3{0, -7800 * 9.81 / 2.1e11 * (0.6 * x[1] - 0.5 * x[1] * x[1]), 0};
        };
        CHECK(apart(part.space, displacement.owned, exact) < 1e-7 * 6.6e-8);
        ForceGauge gauge{"feet", ForceGauge::Kind::feet, 0, Axis::y};
        const double weight = 7800 * 9.81 * 0.2 * 0.6 * 0.1;
        CHECK(solver.forces({gauge}, loads, displacement)[0] == near(weight, 1e-8));
    }
}

TEST_CASE("pads give way by weight over stiffness")
{
    std::vector<Material> materials{steel};
    materials[0].poissons_ratio = 0;
    auto machine = bricks::machine_of({{{0, 0, 0}, {0.2, 0.6, 0.1}, {1, 3, 1}, false, {}}});
    const int feet = bricks::add_surface(machine, 0, 1, false);
    const bricks::Space part(machine, {2});
    ElasticSolver solver(part.space, materials, {feet, Foundation::Kind::elastic, 1e9, 1e9});
    const auto u = solver.displacement(RestLoads{{0, -9.81, 0}, {}}).owned;
    const auto places = part.space.support_points();
    for (std::size_t i = 0; i < places.size(); ++i)
        if (places[i][1] < 1e-9)
            CHECK(u[3 * i + 1] == near(-7800 * 9.81 * 0.6 / 1e9, 1e-7));  // rho g H over k
}

TEST_CASE("a machine that its weight would carry off is refused")
{
    auto machine = bricks::machine_of({{{0, 0, 0}, {0.2, 0.6, 0.1}, {1, 1, 1}, false, {}}});
    const int feet = bricks::add_surface(machine, 0, 1, false);
    const bricks::Space part(machine, {1});
    ElasticSolver solver(part.space, steels, {feet, Foundation::Kind::free, 0, 0});
    CHECK_THROWS_WITH_AS(solver.displacement(RestLoads{{2, -9.81, 0}, {}}),
                         doctest::Contains("free to follow its weight"), InputError);
    CHECK_NOTHROW(solver.displacement(RestLoads{{0, -9.81, 0}, {}}));
}

TEST_CASE("an initial strain that nothing hinders becomes the strain, without stress")
{
    const Tensor6 strain{1e-4, -2e-4, 3e-4, 0.5e-4, -1e-4, 2e-4};
    const bricks::Space both(bonded(), {1, 1});
    ElasticSolver solver(both.space, steels, {});
    const auto u = solver.displacement(RestLoads{{}, {strain, strain}}).owned;
    const VectorField exact = [&](const Vec3& x) {
        return Vec3{strain[0] * x[0] + strain[3] * x[1] + strain[5] * x[2],
                    strain[3] * x[0] + strain[1] * x[1] + strain[4] * x[2],
                    strain[5] * x[0] + strain[4] * x[1] + strain[2] * x[2]};
    };
    CHECK(apart(both.space, u, exact) < 1e-8 * 1e-4);
    const StressRecovery stress(both.space, steel, 1, {u.data(), nullptr, {strain, strain}});
    for (const double s : stress.at({0.1, 0.15, 0.05}))
        CHECK(std::abs(s) < 10);  // of 6e7 Pa
}

TEST_CASE("Hooke's law: uniaxial strain, shear and pressure by their moduli")
{
    const auto stretched = hooke(steel, {1e-4, 0, 0, 0, 0, 0});
    CHECK(stretched[0] == near(1e-4 * 2.1e11 * 0.7 / (1.3 * 0.4), 1e-13));
    CHECK(stretched[1] == near(stretched[0] * 0.3 / 0.7, 1e-13));
    CHECK(hooke(steel, {0, 0, 0, 1e-4, 0, 0})[3] == near(2.1e11 / 1.3 * 1e-4, 1e-13));
    const auto pressed = hooke(steel, {1e-4, 1e-4, 1e-4, 0, 0, 0});
    CHECK(pressed[2] == near(3e-4 * 2.1e11 / (3 * 0.4), 1e-13));
}

TEST_CASE("recovered stress: linear with elements of second order exactly, and of first order at every node")
{
    // u = (x^2 + y z, x y, 0): strains linear in x, y, z.
    const VectorField bent = [](const Vec3& x) { return Vec3{x[0] * x[0] + x[1] * x[2], x[0] * x[1], 0}; };
    const auto strain = [](const Vec3& x) { return Tensor6{2 * x[0], x[0], 0, 0.5 * (x[2] + x[1]), 0, 0.5 * x[1]}; };
    for (const int order : {1, 2}) {
        const bricks::Space part(Brick{{0, 0, 0}, {1, 1, 1}, {3, 2, 2}, false, {}}, order);
        const auto u = displacement_of(part.space, bent);
        const StressRecovery stress(part.space, steel, 0, {u.data(), nullptr, {}});
        CHECK(stress.nodes().size() == part.machine.nodes.size());
        for (std::size_t node = 0; node < stress.nodes().size(); ++node) {
            const auto got = stress.at_node(node);
            const auto exact = hooke(steel, strain(part.machine.nodes[stress.nodes()[node]]));
            for (std::size_t c = 0; c < 6; ++c)
                CHECK(std::abs(got[c] - exact[c]) < 1e-9 * 2.1e11);  // middles of cells are exact for quadratics
        }
    }
}

TEST_CASE("warm but free: no stress is recovered; warm and held: that of the rise")
{
    const bricks::Space part(Brick{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, false, {}}, 1);
    const std::vector<double> rise(27, 50.0);
    const auto grown = displacement_of(part.space, [](const Vec3& x) { return 6e-4 * x; });
    const std::vector<double> held(81, 0.0);
    const StressRecovery free(part.space, steel, 0, {grown.data(), rise.data(), {}}),
        clamped(part.space, steel, 0, {held.data(), rise.data(), {}});
    for (const double s : free.at_node(5))
        CHECK(std::abs(s) < 1);
    CHECK(clamped.at_node(5)[0] == near(-2.1e11 * 6e-4 / 0.4, 1e-12));  // -E alpha dT / (1 - 2 nu)
    CHECK(std::abs(clamped.at_node(5)[3]) < 1);
}
