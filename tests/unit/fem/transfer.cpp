/// Requirement: fields between unlike meshes of the same parts: polynomials pass exactly, weights go the transposed
/// way, and the fit keeps a part's heat.
#include "deadpoint/fem/transfer/transfer.hpp"

#include "bricks.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/exchange/machine.hpp"
#include "deadpoint/fem/transfer/fitted_transfer.hpp"
#include "near.hpp"

#include <cmath>
#include <doctest/doctest.h>

using namespace deadpoint;
using namespace deadpoint::fem;
using bricks::column;
using bricks::values_of;

namespace {

Machine parts(std::array<int, 3> first, std::array<int, 3> second, bool tetrahedra = false)
{
    return bricks::machine_of(
        {{{0, 0, 0}, {2, 1, 1}, first, tetrahedra, {}}, {{0, 0, 1}, {1, 1, 1.5}, second, false, {}}});
}

double linear(const Vec3& x) { return 300 + 7 * x[0] - 11 * x[1] + 3 * x[2]; }
double wavy(const Vec3& x) { return 300 + 10 * std::sin(5 * x[0]) * std::cos(4 * x[1]) + 6 * x[2] * x[2]; }

double largest_difference(const std::vector<double>& a, const std::vector<double>& b)
{
    return (column(a) - column(b)).lpNorm<Eigen::Infinity>();
}

/// Shares of volume of the unknowns, cell by cell as even shares.
Eigen::VectorXd volumes(const bricks::Space& at)
{
    Eigen::VectorXd result = Eigen::VectorXd::Zero(at.space.total);
    for (std::uint32_t c = 0; c < at.machine.cells.size(); ++c) {
        const auto unknowns = at.space.unknowns_of(c);
        for (const auto unknown : unknowns)
            result[static_cast<Eigen::Index>(unknown)] +=
                at.space.maps.volume(c) / static_cast<double>(unknowns.size());
    }
    return result;
}

}  // namespace

TEST_CASE("a linear field passes to any other mesh, of either order and shape, and a constant stays one")
{
    const bricks::Space coarse(parts({2, 1, 2}, {1, 2, 1}), {1, 1}), fine(parts({3, 2, 3}, {2, 3, 2}), {1, 1}),
        second(parts({3, 2, 1}, {1, 1, 1}), {2, 1}), tetrahedra(parts({2, 3, 1}, {2, 1, 1}, true), {1, 2});
    for (const auto* from : {&coarse, &fine, &second, &tetrahedra})
        for (const auto* to : {&coarse, &fine, &second, &tetrahedra}) {
            const Transfer transfer(from->space, to->space);
            CHECK(largest_difference(transfer.apply(values_of(from->space, linear), 1), values_of(to->space, linear)) <
                  1e-10);
            const std::vector<double> ones(static_cast<std::size_t>(from->space.total), 1.0);
            for (const double one : transfer.apply(ones, 1))
                CHECK(one == near(1, 1e-13));
        }
}

TEST_CASE("to the same mesh a field passes as it is, a quadratic one from elements of second order to any mesh")
{
    const bricks::Space fine(parts({3, 2, 3}, {2, 3, 2}), {2, 2}), other(parts({2, 2, 1}, {1, 1, 1}), {1, 2});
    const auto values = values_of(fine.space, wavy);
    CHECK(largest_difference(Transfer(fine.space, fine.space).apply(values, 1), values) < 1e-10);
    const auto quadratic = [](const Vec3& x) { return x[0] * x[0] - 3 * x[1] * x[2] + x[1]; };
    const Transfer transfer(fine.space, other.space);
    CHECK(largest_difference(transfer.apply(values_of(fine.space, quadratic), 1), values_of(other.space, quadratic)) <
          1e-11);
}

TEST_CASE("parts do not see each other: at a common place each has its own value")
{
    const bricks::Space coarse(parts({2, 1, 2}, {1, 1, 1}), {1, 1}), fine(parts({4, 2, 2}, {2, 2, 2}), {1, 1});
    auto values = values_of(coarse.space, linear);
    const auto of_coarse = coarse.space.part_of_unknown();
    for (std::size_t i = 0; i < values.size(); ++i)
        values[i] = of_coarse[i] == 0 ? 1 : 2;
    const auto passed = Transfer(coarse.space, fine.space).apply(values, 1);
    const auto of_fine = fine.space.part_of_unknown();
    for (std::size_t i = 0; i < passed.size(); ++i)
        CHECK(passed[i] == near(of_fine[i] + 1, 1e-13));
}

TEST_CASE("three values per unknown pass as three fields do")
{
    const bricks::Space coarse(parts({2, 1, 2}, {1, 1, 1}), {1, 1}), fine(parts({3, 2, 2}, {2, 2, 2}), {1, 1});
    const Transfer transfer(coarse.space, fine.space);
    const auto a = values_of(coarse.space, linear), b = values_of(coarse.space, wavy);
    std::vector<double> three;
    for (std::size_t i = 0; i < a.size(); ++i)
        three.insert(three.end(), {a[i], b[i], a[i] - b[i]});
    const auto passed = transfer.apply(three, 3), first = transfer.apply(a, 1), second = transfer.apply(b, 1);
    for (std::size_t i = 0; i < first.size(); ++i) {
        CHECK(passed[3 * i] == near(first[i], 1e-14));
        CHECK(passed[3 * i + 1] == near(second[i], 1e-14));
        const double rounding = 1e-14 * (std::abs(first[i]) + std::abs(second[i]));
        CHECK(passed[3 * i + 2] == near(first[i] - second[i], 0, rounding));
    }
}

TEST_CASE("weights go back by the transposed, of values and of the fit")
{
    const bricks::Space coarse(parts({2, 1, 1}, {1, 1, 1}), {2, 1}), fine(parts({4, 3, 2}, {2, 2, 3}), {1, 1});
    const Transfer down(fine.space, coarse.space), up(coarse.space, fine.space);
    const FittedTransfer fitted(fine.space, coarse.space, down, up);
    const auto field = values_of(fine.space, wavy);
    const auto weights = values_of(coarse.space, [](const Vec3& x) { return 2 - x[0] + x[1] * x[2]; });
    CHECK(column(weights).dot(column(down.apply(field, 1))) ==
          near(column(down.apply_transposed(weights)).dot(column(field)), 1e-13));
    CHECK(column(weights).dot(column(fitted.apply(field))) ==
          near(column(fitted.apply_transposed(weights)).dot(column(field)), 1e-11));
}

TEST_CASE("the fit passes linear fields exactly, and what the coarse mesh can hold comes back as it was")
{
    const bricks::Space coarse(parts({2, 1, 1}, {1, 1, 1}), {1, 1}), fine(parts({4, 3, 2}, {2, 2, 3}), {1, 1});
    const Transfer down(fine.space, coarse.space), up(coarse.space, fine.space);
    const FittedTransfer fitted(fine.space, coarse.space, down, up);
    CHECK(largest_difference(fitted.apply(values_of(fine.space, linear)), values_of(coarse.space, linear)) < 1e-9);
}

TEST_CASE("the fit is nearer to a fine field than its values are, in the mean square, and keeps its heat")
{
    const bricks::Space coarse(parts({2, 1, 1}, {1, 1, 1}), {1, 1}), fine(parts({8, 6, 4}, {4, 4, 4}), {1, 1});
    const Transfer down(fine.space, coarse.space), up(coarse.space, fine.space);
    const FittedTransfer fitted(fine.space, coarse.space, down, up);
    const auto field = values_of(fine.space, wavy);
    const auto by_values = down.apply(field, 1), by_fit = fitted.apply(field);
    const auto weight = volumes(fine);
    const auto missed = [&](const std::vector<double>& on_coarse) {
        return Eigen::VectorXd(column(up.apply(on_coarse, 1)) - column(field));
    };
    const auto square = [&](const Eigen::VectorXd& miss) { return weight.dot(miss.cwiseAbs2()); };
    CHECK(square(missed(by_fit)) < 0.5 * square(missed(by_values)));
    // The normal equations: the mean misses by at most s = 1e-3 of how far the fit went from the values.
    const double moved = volumes(coarse).dot((column(by_fit) - column(by_values)).cwiseAbs());
    CHECK(std::abs(weight.dot(missed(by_fit))) <= 1e-3 * moved * (1 + 1e-6));
    CHECK(std::abs(weight.dot(missed(by_values))) > 0.01);
    // No other coarse field is nearer, but for the regularisation: any small change makes it worse.
    auto changed = by_fit;
    for (std::size_t i = 0; i < changed.size(); ++i) {
        changed[i] += 0.5;
        CHECK(square(missed(changed)) > square(missed(by_fit)));
        changed[i] -= 1;
        CHECK(square(missed(changed)) > square(missed(by_fit)));
        changed[i] += 0.5;
    }
}

TEST_CASE("a place is found in its cell, and beside the part in the cell it is least outside of")
{
    const bricks::Space at(parts({4, 2, 2}, {1, 1, 1}), {1, 1});
    const CellFinder finder(at.space, 0);
    for (std::uint32_t c = 0; c < at.machine.parts[0].cell_count; ++c) {
        const auto centre = at.space.maps.centre(c);
        const auto found = finder.find({centre[0], centre[1], centre[2]});
        CHECK(found.cell == c);
        CHECK(found.outside == 0);
        CHECK(norm(found.unit - Vec3{0.5, 0.5, 0.5}) < 1e-12);
    }
    const auto beside = finder.find({2.1, 0.25, 0.25});  // a fifth of a cell beyond x = 2
    CHECK(beside.outside == near(0.2, 1e-10));
    CHECK(at.space.maps.centre(beside.cell)[0] == near(1.75, 1e-12));
}

TEST_CASE("meshes of different numbers of parts are refused")
{
    const bricks::Space both(parts({1, 1, 1}, {1, 1, 1}), {1, 1}), one(bricks::Brick{}, 1);
    CHECK_THROWS_WITH_AS(Transfer(both.space, one.space), doctest::Contains("different parts"), InputError);
}
