/// Requirement: the space of shape functions on a machine: each part by itself, polynomials of its order exact, and
/// functionals, vectors and patterns that fit its numbering.
#include "bricks.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/exchange/machine.hpp"
#include "near.hpp"

#include <algorithm>
#include <doctest/doctest.h>
#include <set>

using namespace deadpoint;
using namespace deadpoint::fem;
using bricks::Brick;

namespace {

Brick box(std::array<int, 3> cells, bool tetrahedra = false)
{
    return {{-0.2, 0.1, 0}, {0.4, 0.5, 1.5}, cells, tetrahedra, {}};
}

/// Bends a box without folding its cells.
Vec3 bent(Vec3 x) { return {x[0] + 0.1 * x[1] * x[2], x[1] - 0.05 * x[0] * x[2], x[2] + 0.08 * x[0] * x[1]}; }

double linear(const Vec3& x) { return 3 + 2 * x[0] - 5 * x[1] + 0.5 * x[2]; }
double quadratic(const Vec3& x) { return linear(x) + x[0] * x[0] - 2 * x[1] * x[2] + 3 * x[2] * x[2]; }

double at(const PointShape& shape, const std::vector<double>& values)
{
    double sum = 0;
    for (int i = 0; i < shape.count; ++i)
        sum += shape.value[i] * values[static_cast<std::size_t>(shape.dof[i])];
    return sum;
}
Vec3 gradient_at(const PointShape& shape, const std::vector<double>& values)
{
    Vec3 sum{};
    for (int i = 0; i < shape.count; ++i)
        for (std::size_t c = 0; c < 3; ++c)
            sum[c] += shape.gradient[i][c] * values[static_cast<std::size_t>(shape.dof[i])];
    return sum;
}

Vec3 middle_of(const Machine& machine, const Face& face)
{
    Vec3 sum{};
    for (std::size_t i = 0; i < face.node_count; ++i)
        sum = sum + (1.0 / face.node_count) * machine.nodes[face.nodes[i]];
    return sum;
}

Machine two_bricks()
{
    auto machine = bricks::machine_of(
        {{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, false, {}}, {{0, 0, 1}, {1, 1, 2}, {3, 1, 1}, false, {}}});
    machine.bonds = {bricks::contact(machine, 0, 1, 2)};
    return machine;
}

}  // namespace

TEST_CASE("unknowns sit on the lattice of the elements' order, one at each place")
{
    for (const bool tetrahedra : {false, true})
        for (const int order : {1, 2}) {
            const bricks::Space part(box({2, 1, 3}, tetrahedra), order);
            const auto places = part.space.support_points();
            CHECK(part.space.total == (2 * order + 1) * (order + 1) * (3 * order + 1));
            REQUIRE(static_cast<PetscInt>(places.size()) == part.space.total);
            std::set<std::array<long, 3>> seen;
            for (const auto& x : places) {
                std::array<long, 3> step{};
                const Vec3 spacing{0.6 / (2 * order), 0.4 / order, 1.5 / (3 * order)}, low{-0.2, 0.1, 0};
                for (std::size_t c = 0; c < 3; ++c) {
                    step[c] = std::lround((x[c] - low[c]) / spacing[c]);
                    CHECK(x[c] == near(low[c] + static_cast<double>(step[c]) * spacing[c], 1e-13));
                }
                seen.insert(step);
            }
            CHECK(seen.size() == places.size());
        }
}

TEST_CASE("parts share no unknown, and each unknown knows its part")
{
    const bricks::Space both(two_bricks(), {1, 2});
    CHECK(both.space.total == 27 + 7 * 3 * 3);
    const auto parts = both.space.part_of_unknown();
    const auto places = both.space.support_points();
    CHECK(std::ranges::count(parts, 0U) == 27);
    for (std::size_t i = 0; i < parts.size(); ++i)
        CHECK((parts[i] == 0 ? places[i][2] <= 1 : places[i][2] >= 1));
    for (std::uint32_t c = 0; c < both.machine.cells.size(); ++c)
        for (const auto unknown : both.space.unknowns_of(c))
            CHECK(parts[unknown] == both.machine.cells[c].part);
}

TEST_CASE("shape functions at faces: a polynomial of the elements' order and its gradient, exactly")
{
    for (const bool tetrahedra : {false, true})
        for (const int order : {1, 2}) {
            const bricks::Space part(box({2, 2, 1}, tetrahedra), order);
            const auto& field = order == 1 ? linear : quadratic;
            const auto values = bricks::values_of(part.space, field);
            PointShape shape;
            for (std::uint32_t f = 0; f < part.machine.faces.size(); ++f) {
                const auto x = middle_of(part.machine, part.machine.faces[f]);
                part.space.evaluate(f, x, true, shape);
                // The library ends its search for the place in a tetrahedron early.
                CHECK(at(shape, values) == near(field(x), tetrahedra ? 1e-11 : 1e-13));
                CHECK(at(shape, std::vector<double>(values.size(), 1.0)) == near(1, 1e-14));
                const Vec3 exact =
                    order == 1 ? Vec3{2, -5, 0.5} : Vec3{2 + 2 * x[0], -5 - 2 * x[2], 0.5 - 2 * x[1] + 6 * x[2]};
                CHECK(norm(gradient_at(shape, values) - exact) < 1e-11);
            }
        }
}

TEST_CASE("in bent cells a linear field and its gradient are exact too")
{
    auto brick = box({2, 2, 2});
    brick.map = bent;
    const bricks::Space part(brick, 1);
    const auto values = bricks::values_of(part.space, linear);
    PointShape shape;
    for (std::uint32_t f = 0; f < part.machine.faces.size(); ++f) {
        const auto x = middle_of(part.machine, part.machine.faces[f]);
        part.space.evaluate(f, x, true, shape);
        CHECK(at(shape, values) == near(linear(x), 1e-12));
        CHECK(norm(gradient_at(shape, values) - Vec3{2, -5, 0.5}) < 1e-10);
    }
}

TEST_CASE("a place in a cell has reference coordinates, from which the place comes back")
{
    auto brick = box({1, 1, 1});
    brick.map = bent;
    for (const bool tetrahedra : {false, true}) {
        brick.tetrahedra = tetrahedra;
        const bricks::Space part(brick, 1);
        for (std::uint32_t c = 0; c < part.machine.cells.size(); ++c) {
            Vec3 x{};
            const auto& cell = part.machine.cells[c];
            const unsigned corners = tetrahedra ? 4 : 8;
            for (unsigned i = 0; i < corners; ++i)  // somewhere inside, nearer to the later corners
                x = x + (2.0 * (i + 1) / (corners * (corners + 1))) * part.machine.nodes[cell.nodes[i]];
            Vec3 unit{};
            REQUIRE(part.space.maps.unit_position(c, x, unit));
            CHECK(part.space.distance_outside(c, unit) == 0);
            PointShape shape;
            part.space.evaluate_at(c, unit, false, shape);
            Vec3 back{};
            const auto places = part.space.support_points();
            for (int i = 0; i < shape.count; ++i)
                back = back + shape.value[i] * places[static_cast<std::size_t>(shape.dof[i])];
            CHECK(norm(back - x) < 1e-12);
        }
    }
}

TEST_CASE("a point is found in the cell of its part; one off the part is brought back, one far off is refused")
{
    const bricks::Space part(box({2, 2, 3}), 1);
    const auto values = bricks::values_of(part.space, linear);
    PointShape shape;
    for (const Vec3& x : {Vec3{-0.1, 0.15, 0.2}, Vec3{0.39, 0.49, 1.49}, Vec3{0.1, 0.3, 0.75}}) {
        part.space.evaluate_in_part(0, x, shape);
        CHECK(at(shape, values) == near(linear(x), 1e-12));
    }
    part.space.evaluate_in_part(0, {0.45, 0.3, 0.7}, shape);  // 50 mm beside the face at 0.4
    CHECK(at(shape, values) == near(linear({0.4, 0.3, 0.7}), 1e-12));
    CHECK_THROWS_WITH_AS(part.space.evaluate_in_part(0, {0.4 + 0.6, 0.3, 0.7}, shape),
                         doctest::Contains("outside its part 'part 0'"), InputError);
    CHECK_THROWS_WITH_AS(part.space.evaluate_in_part(0, {40, 0, 0}, shape), doctest::Contains("near a probe"),
                         InputError);
}

TEST_CASE("a cell continued beyond itself is the same polynomial there, and tells how far it went")
{
    for (const bool tetrahedra : {false, true}) {
        const bricks::Space part(box({1, 1, 1}, tetrahedra), 1);
        const auto values = bricks::values_of(part.space, linear);
        PointShape shape;
        const Vec3 beyond{0.46, 0.3, 0.7};  // a tenth of the cell beyond its face
        const double outside = part.space.continue_cell(0, beyond, shape);
        CHECK(at(shape, values) == near(linear(beyond), 1e-12));
        if (!tetrahedra)
            CHECK(outside == near(0.1, 1e-12));
        CHECK(outside > 0);
    }
}

TEST_CASE("the depth behind a face is the cell's volume over the face's area")
{
    const bricks::Space hexahedra(box({2, 1, 3}), 1), tetrahedra(box({2, 1, 3}, true), 1);
    for (const auto f : bricks::side(hexahedra.machine, 0, 0, true))
        CHECK(hexahedra.space.depth(f) == near(0.3, 1e-13));
    for (const auto f : bricks::side(hexahedra.machine, 0, 2, false))
        CHECK(hexahedra.space.depth(f) == near(0.5, 1e-13));
    for (const auto f : bricks::side(tetrahedra.machine, 0, 0, true))  // V = A h / 3
        CHECK(tetrahedra.space.depth(f) == near(0.1, 1e-13));
}

TEST_CASE("a cell's nodes are found by their unknowns, whatever the numbering")
{
    for (const bool tetrahedra : {false, true}) {
        const bricks::Space part(box({2, 2, 1}, tetrahedra), 2);
        const auto places = part.space.support_points();
        for (std::uint32_t c = 0; c < part.machine.cells.size(); ++c)
            for (unsigned i = 0; i < (tetrahedra ? 4U : 8U); ++i)
                CHECK(norm(places[part.space.vertex_unknown(c, i)] -
                           part.machine.nodes[part.machine.cells[c].nodes[i]]) < 1e-14);
    }
}

TEST_CASE("the matrix has a place where two unknowns share a cell, and only there; bonds add those across")
{
    const bricks::Space both(two_bricks(), {1, 1});
    auto couplings = both.space.cell_couplings();
    const auto exists = [](const SparseRows& rows, PetscInt i, PetscInt j) {
        const auto begin = rows.columns.begin() + rows.starts[static_cast<std::size_t>(i)];
        return std::binary_search(begin, rows.columns.begin() + rows.starts[static_cast<std::size_t>(i) + 1], j);
    };
    std::set<std::pair<PetscInt, PetscInt>> expected;
    for (std::uint32_t c = 0; c < both.machine.cells.size(); ++c)
        for (const auto i : both.space.unknowns_of(c))
            for (const auto j : both.space.unknowns_of(c))
                expected.emplace(i, j);
    const auto within = couplings.rows();
    CHECK(within.columns.size() == expected.size());
    for (const auto& [i, j] : expected)
        CHECK(exists(within, i, j));
    both.space.add_bond_couplings(couplings);
    const auto all = couplings.rows();
    for (const auto& point : both.machine.bonds[0].points)
        for (const auto i : both.space.unknowns_of(both.machine.faces[point.face_a].cell))
            for (const auto j : both.space.unknowns_of(both.machine.faces[point.face_b].cell)) {
                CHECK(exists(all, i, j));
                CHECK(exists(all, j, i));
            }
}

TEST_CASE("couplings are rows, sorted, of each column once; blocks repeat them for each component")
{
    Couplings couplings(2, 5);
    couplings.add(std::vector<PetscInt>{4, 1, 2});
    couplings.add(std::vector<PetscInt>{2, 7}, std::vector<PetscInt>{9, 1});
    couplings.add(std::vector<PetscInt>{0, 8});
    const auto rows = couplings.rows();
    CHECK(rows.starts == std::vector<PetscInt>{0, 4, 4, 7});
    CHECK(rows.columns == std::vector<PetscInt>{1, 2, 4, 9, 1, 2, 4});
    const auto blocks = by_blocks({{0, 2, 3}, {0, 3, 1}}, 2);
    CHECK(blocks.starts == std::vector<PetscInt>{0, 4, 8, 10, 12});
    CHECK(blocks.columns == std::vector<PetscInt>{0, 1, 6, 7, 0, 1, 6, 7, 2, 3, 2, 3});
}

TEST_CASE("bonded cells: their points cover the bond once, with both sides' shape functions there")
{
    const bricks::Space both(two_bricks(), {1, 2});
    const auto values = bricks::values_of(both.space, linear);
    double area = 0;
    int pairs = 0;
    for_each_bond_pair(both.space, [&](const BondPair& pair) {
        ++pairs;
        CHECK(pair.part_a == 0);
        CHECK(pair.part_b == 1);
        CHECK(pair.depth_a == near(0.5, 1e-13));
        CHECK(pair.depth_b == near(1, 1e-13));
        for (const auto& point : pair.points) {
            area += point.weight;
            CHECK(at(point.a, values) == near(at(point.b, values), 1e-12));
            CHECK(norm(gradient_at(point.b, values) - Vec3{2, -5, 0.5}) < 1e-11);
            CHECK(point.normal == Vec3{0, 0, 1});
        }
    });
    CHECK(area == near(1, 1e-14));
    CHECK(pairs == 8);  // 2 x 2 faces on 3 strips, of which the middle one lies on both halves
}

TEST_CASE("a functional takes its entries in any order, and those of one unknown together")
{
    const bricks::Space part(box({1, 1, 1}), 1);
    const auto functional = part.space.functional({{5, 2}, {1, 3}, {5, 0.5}, {0, -1}});
    CHECK(functional.local == std::vector<PetscInt>{0, 1, 5});
    CHECK(functional.weight == std::vector<double>{-1, 3, 2.5});
    const auto vector = bricks::vector_of(part.space, std::vector<double>{10, 20, 30, 40, 50, 60, 70, 80});
    const auto empty = part.space.functional({});
    CHECK(evaluate({&functional, &empty}, vector) == std::vector<double>{-10 + 60 + 150, 0});
    // Its load is the transposed.
    const auto load = bricks::vector_of(part.space, std::vector<double>(8, 0.0));
    add_to(load, functional, 4);
    CHECK(bricks::dense(load).dot(bricks::dense(vector)) == near(4 * 200, 1e-14));
}

TEST_CASE("what is gathered on every rank is the vector as it is then, as often as it is asked for")
{
    const bricks::Space part(box({1, 2, 1}), 1);
    auto vector = bricks::vector_of(part.space, linear);
    Gathered gathered(vector);
    const double* all = gathered.gather(vector);
    const auto values = bricks::values_of(part.space, linear);
    for (std::size_t i = 0; i < values.size(); ++i)
        CHECK(all[i] == values[i]);
    DEADPOINT_PETSC(VecScale(vector, 2));
    all = gathered.gather(vector);
    CHECK(all[3] == 2 * values[3]);
    std::vector<double> three(3 * values.size());
    for (std::size_t i = 0; i < three.size(); ++i)
        three[i] = static_cast<double>(i);
    CHECK(gather_all(part.space, three, 3) == three);
    std::vector<double> sums{1, 2};
    sum_over_ranks(sums);
    CHECK(sums == std::vector<double>{static_cast<double>(1), 2});
}

TEST_CASE("vectors and matrices have a block of rows for each unknown")
{
    const bricks::Space part(box({1, 1, 2}), 1);
    const auto vector = create_vector(part.space, 3);
    PetscInt size = 0, rows = 0;
    DEADPOINT_PETSC(VecGetSize(vector, &size));
    CHECK(size == 36);
    const auto matrix = create_matrix(by_blocks(part.space.cell_couplings().rows(), 3));
    DEADPOINT_PETSC(MatGetSize(matrix, &rows, nullptr));
    CHECK(rows == 36);
    auto copy = duplicate(vector);
    {
        Entries entries(copy);
        entries[PetscInt{35}] = 7;
    }
    const ConstEntries entries(copy);
    CHECK(entries[std::size_t{35}] == 7);
}

TEST_CASE("an owner hands its object on and frees it once")
{
    const bricks::Space part(box({1, 1, 1}), 1);
    OwnedVec first = create_vector(part.space, 1);
    const Vec handle = first;
    OwnedVec moved = std::move(first);
    CHECK(Vec(moved) == handle);
    OwnedVec other = create_vector(part.space, 1);
    other = std::move(moved);
    CHECK(Vec(other) == handle);
    other.reset();
    CHECK_FALSE(static_cast<bool>(other));
    other.reset();  // nothing left to free
}

TEST_CASE("a call of the linear algebra library that fails is an error that names the call")
{
    CHECK_NOTHROW(petsc_check(0, "nothing"));
    CHECK_THROWS_WITH_AS(petsc_check(55, "VecDuplicate(a, b)"), doctest::Contains("VecDuplicate(a, b)"),
                         ConvergenceError);
}
