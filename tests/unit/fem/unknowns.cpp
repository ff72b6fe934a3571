/// Requirement: numbers of unknowns that make each rank's a stretch, and cells of which ranks have equal work.
#include "deadpoint/fem/space/unknowns.hpp"

#include "bricks.hpp"
#include "deadpoint/fem/space/cell_values.hpp"
#include "near.hpp"

#include <doctest/doctest.h>
#include <set>

using namespace deadpoint;
using namespace deadpoint::fem;
using bricks::Brick;

namespace {

/// Hexahedra of second order, tetrahedra of second order, hexahedra of first order.
const std::vector<int> orders{2, 2, 1};
Machine three_parts()
{
    return bricks::machine_of({{{0, 0, 0}, {1, 1, 1}, {3, 2, 2}, false, {}},
                               {{2, 0, 0}, {3, 1, 1}, {2, 1, 3}, true, {}},
                               {{4, 0, 0}, {5, 1, 1}, {4, 4, 4}, false, {}}});
}

Vec3 bent(Vec3 x) { return {x[0] + 0.1 * x[1] * x[2], x[1] - 0.05 * x[0] * x[2], x[2] + 0.08 * x[0] * x[1]}; }

}  // namespace

TEST_CASE("cells number their unknowns as they meet them: those of the first cells are the first")
{
    const auto machine = three_parts();
    const Unknowns unknowns(machine, orders);
    std::set<PetscInt> met;
    std::vector<PetscInt> own;
    for (std::uint32_t cell = 0; cell < machine.cells.size(); ++cell) {
        CHECK(unknowns.met_before(cell) == static_cast<PetscInt>(met.size()));
        unknowns.of(cell, own);
        met.insert(own.begin(), own.end());
        CHECK(*met.rbegin() == static_cast<PetscInt>(met.size()) - 1);
    }
    CHECK(unknowns.total() == 7 * 5 * 5 + 5 * 3 * 7 + 5 * 5 * 5);
    CHECK(static_cast<PetscInt>(met.size()) == unknowns.total());
}

TEST_CASE("new numbers reach all cells and nodes")
{
    const auto machine = three_parts();
    const Unknowns before(machine, orders);
    auto after = before;
    std::vector<PetscInt> number(static_cast<std::size_t>(before.total()));
    for (std::size_t i = 0; i < number.size(); ++i)
        number[i] = before.total() - 1 - static_cast<PetscInt>(i);
    after.renumber(number);
    std::vector<PetscInt> old_ones, new_ones;
    for (std::uint32_t cell = 0; cell < machine.cells.size(); ++cell) {
        before.of(cell, old_ones);
        after.of(cell, new_ones);
        REQUIRE(new_ones.size() == old_ones.size());
        for (std::size_t i = 0; i < old_ones.size(); ++i)
            CHECK(new_ones[i] == number[static_cast<std::size_t>(old_ones[i])]);
        CHECK(after.at_node(machine.cells[cell].nodes[0]) == new_ones[0]);
    }
}

TEST_CASE("the ranks' stretches have all cells, in order, and the same work: rows of 27 and of 15 entries")
{
    // 125 nodes among hexahedra, 216 among tetrahedra: 3375 and 3240 entries. The last hexahedron has more of them than
    // the difference from half of all, 67.5: its corner's whole row and shares of seven others, 27 (1 + 3/2 + 3/4 +
    // 1/8).
    const auto machine =
        bricks::machine_of({{{0, 0, 0}, {1, 1, 1}, {4, 4, 4}, false, {}}, {{2, 0, 0}, {3, 1, 1}, {5, 5, 5}, true, {}}});
    CHECK(stretches(machine, 1) == std::vector<std::uint32_t>{0, 64 + 750});
    const auto two = stretches(machine, 2);
    CHECK(two.front() == 0);
    CHECK(two.back() == 64 + 750);
    CHECK(two[1] == 63);
    const auto many = stretches(machine, 40);
    CHECK(many.size() == 41);
    CHECK(std::ranges::is_sorted(many));
    CHECK(many.back() == 64 + 750);
    const auto few_cells = stretches(bricks::machine_of({Brick{}}), 3);  // one cell: it has one owner
    CHECK(few_cells.front() == 0);
    CHECK(few_cells.back() == 1);
}

// Whole steps of Newton's method miss 18 of the 64.
TEST_CASE("all places of a cell are found that is thin at one end and leans")
{
    const auto leaning = [](Vec3 x) {
        const double width = 1 - 0.9 * x[2];
        return Vec3{width * (x[0] - 0.5) + 2 * x[2] * x[1], width * (x[1] - 0.5), x[2]};
    };
    const bricks::Space cell(Brick{{0, 0, 0}, {1, 1, 1}, {1, 1, 1}, false, leaning});
    const std::array<double, 4> steps{0.01, 0.3, 0.8, 0.99};
    for (const double x : steps)
        for (const double y : steps)
            for (const double z : steps) {
                const auto place = cell.space.maps.position(0, {x, y, z});
                Vec3 unit{};
                CAPTURE(x);
                CAPTURE(y);
                CAPTURE(z);
                REQUIRE(cell.space.maps.unit_position(0, {place[0], place[1], place[2]}, unit));
                CHECK(norm(unit - Vec3{x, y, z}) < 1e-10);
            }
}

TEST_CASE("values in a cell: weights sum to its volume, gradients are those of the field, in bent cells too")
{
    for (const bool tetrahedra : {false, true})
        for (const int order : {1, 2}) {
            const bricks::Space part(Brick{{0, 0, 0}, {1, 2, 1}, {2, 2, 1}, tetrahedra, bent}, order);
            const auto linear = [](const Vec3& x) { return 3 + 2 * x[0] - 5 * x[1] + 0.5 * x[2]; };
            const auto field = bricks::values_of(part.space, linear);
            double volume = 0;
            CellValues v(part.space);
            for (std::uint32_t cell = 0; cell < part.machine.cells.size(); ++cell) {
                v.reinit(cell);
                const auto unknowns = part.space.unknowns_of(cell);
                double own = 0;
                for (const auto q : v.quadrature_point_indices()) {
                    double value = 0;
                    Vec3 gradient{};
                    for (const auto i : v.dof_indices()) {
                        value += v.shape_value(i, q) * field[static_cast<std::size_t>(unknowns[i])];
                        gradient = gradient + field[static_cast<std::size_t>(unknowns[i])] * v.shape_grad(i, q);
                    }
                    CHECK(value == near(linear(v.quadrature_point(q)), 1e-12));
                    CHECK(norm(gradient - Vec3{2, -5, 0.5}) < 1e-11);
                    own += v.JxW(q);
                }
                CHECK(own == near(part.space.maps.volume(cell), 1e-13));
                volume += own;
            }
            // The map is trilinear; its determinant is 1 + 0.004 x^2 - 0.008 y^2 + 0.005 z^2 - 0.0008 xyz.
            if (!tetrahedra)
                CHECK(volume == near(2 + 0.008 / 3 - 0.064 / 3 + 0.01 / 3 - 0.0004, 1e-13));
        }
}
