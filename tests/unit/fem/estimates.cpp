/// Requirement: estimates of the error are the error where it is known on paper, and modes are those of the fields.
#include "bricks.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/exchange/heat.hpp"
#include "deadpoint/exchange/machine.hpp"
#include "deadpoint/fem/estimate/error_estimate.hpp"
#include "deadpoint/fem/estimate/pod.hpp"
#include "near.hpp"

#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>

using namespace deadpoint;
using namespace deadpoint::fem;
using bricks::Brick;

namespace {

const auto steel = bricks::steel();
const std::vector<Material> one_steel{steel};

/// A box of 1 x 1 x 2 m3 in cubes of 1/n.
bricks::Space box(int n, int order = 1)
{
    return bricks::Space(Brick{{0, 0, 0}, {1, 1, 2}, {n, n, 2 * n}, false, {}}, order);
}

double square(const Vec3& x) { return x[0] * x[0]; }

Field field(const Discretisation& space, const bricks::Scalar& f) { return {bricks::values_of(space, f)}; }

}  // namespace

TEST_CASE("a linear temperature has no error, whatever the dual")
{
    for (const int order : {1, 2}) {
        const auto at = box(2, order);
        const auto errors =
            conduction_errors(at.space, one_steel, field(at.space, [](const Vec3& x) { return 300 + x[0] - 2 * x[2]; }),
                              {field(at.space, square)});
        REQUIRE(errors.size() == 1);
        CHECK(std::abs(errors[0][0]) < 1e-5);  // of 45 W/m/K x 2 m3: the ridge of 1e-5 (second order)
        if (order == 1)
            CHECK(std::abs(errors[0][0]) < 1e-9);
    }
}

TEST_CASE("of x squared between the nodes, elements of first order miss k V h^2 / 3 in energy, all of it seen")
{
    for (const int n : {2, 4}) {
        const auto at = box(n);
        const auto t = field(at.space, square);
        const double h = 1.0 / n;
        // The gradient of the nodes' field is 2 x in the middle of a cell: 2 (x - middle) is missed.
        const double exact = 45 * 2 * h * h / 3;
        CHECK(conduction_errors(at.space, one_steel, t, {t})[0][0] == near(exact, 1e-6));
        // Bilinear: twice the dual is twice the error, and a dual across sees none.
        auto twice = t;
        for (double& value : twice.owned)
            value *= -2;
        const auto across = field(at.space, [](const Vec3& x) { return x[1] * x[1]; });
        const auto errors = conduction_errors(at.space, one_steel, t, {twice, across});
        CHECK(errors[0][0] == near(-2 * exact, 1e-6));
        CHECK(std::abs(errors[1][0]) < 1e-6 * exact);
    }
}

TEST_CASE("with elements of second order a quadratic temperature has no error")
{
    const auto at = box(2, 2);
    const auto t = field(at.space, square);
    CHECK(std::abs(conduction_errors(at.space, one_steel, t, {t})[0][0]) < 1e-3 * 45 * 2 / 12.0);
}

TEST_CASE("each part has its own error, by its own conductivity")
{
    const bricks::Space both(bricks::machine_of({{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, false, {}},
                                                 {{2, 0, 0}, {3, 1, 1}, {4, 2, 2}, false, {}},
                                                 {{4, 0, 0}, {5, 1, 1}, {2, 2, 2}, false, {}}}),
                             {1, 1, 1});
    auto copper = steel;
    copper.conductivity = 390;
    const auto t = field(both.space, [](const Vec3& x) { return x[0] < 3.5 ? x[0] * x[0] : 7 * x[0]; });
    const auto errors = conduction_errors(both.space, {steel, copper, steel}, t, {t});
    REQUIRE(errors[0].size() == 3);
    CHECK(errors[0][0] == near(45 / 4.0 / 3, 1e-6));
    CHECK(errors[0][1] == near(390 / 16.0 / 3, 1e-6));
    CHECK(std::abs(errors[0][2]) < 1e-6);
}

TEST_CASE("the estimate of a rough field falls with the square of the cell size, as the error does")
{
    std::vector<double> errors;
    for (const int n : {4, 8}) {
        const auto at = box(n);
        const auto t = field(at.space, [](const Vec3& x) { return std::sin(2 * x[0]) * std::exp(x[1]); });
        errors.push_back(conduction_errors(at.space, one_steel, t, {t})[0][0]);
    }
    CHECK(errors[1] > 0);
    CHECK(std::log2(errors[0] / errors[1]) == near(2, 0.1));
}

TEST_CASE("of a stretched box, elements of first order miss (lambda + 2 mu) V h^2 / 3")
{
    const auto at = box(2);
    Displacement u;
    for (const auto& x : at.space.support_points())
        u.owned.insert(u.owned.end(), {x[0] * x[0], 0, 0});
    const double e = 2.1e11, nu = 0.3;
    const double modulus = e * (1 - nu) / ((1 + nu) * (1 - 2 * nu));
    CHECK(deformation_errors(at.space, one_steel, u, {u})[0][0] == near(modulus * 2 * 0.25 / 3, 1e-6));
    Displacement sheared;  // a shear of the same shape: mu for lambda + 2 mu
    for (const auto& x : at.space.support_points())
        sheared.owned.insert(sheared.owned.end(), {0, x[0] * x[0], 0});
    CHECK(deformation_errors(at.space, one_steel, sheared, {sheared})[0][0] ==
          near(e / (2 * (1 + nu)) * 2 * 0.25 / 3, 1e-6));
}

TEST_CASE("a rigid motion and an even strain have no error")
{
    const auto at = box(2);
    Displacement u;
    for (const auto& x : at.space.support_points()) {
        const Vec3 moved = Vec3{1e-3, 0, 0} + cross({1e-4, 2e-4, -1e-4}, x) + 1e-4 * Vec3{x[1], 2 * x[2], x[0]};
        u.owned.insert(u.owned.end(), moved.begin(), moved.end());
    }
    CHECK(std::abs(deformation_errors(at.space, one_steel, u, {u})[0][0]) < 1e-9 * 2.1e11 * 1e-8);
}

TEST_CASE("what interpolation leaves out of a quadratic temperature is found exactly, at any point")
{
    const auto at = box(2);
    const auto quadratic = [](const Vec3& x) { return 300 + x[0] * x[0] - 3 * x[1] * x[1] + 0.5 * x[2] * x[2] + x[0]; };
    const auto t = field(at.space, quadratic);
    std::vector<HeatProbe> probes;
    for (const Vec3& x : {Vec3{0.1, 0.2, 0.3}, Vec3{0.25, 0.75, 1.25}, Vec3{0.5, 0.5, 1}, Vec3{0.9, 0.1, 1.7}})
        probes.push_back({"p", 0, x});
    const auto errors = interpolation_errors(at.space, t, probes);
    PointShape shape;
    for (std::size_t k = 0; k < probes.size(); ++k) {
        at.space.evaluate_in_part(0, probes[k].position, shape);
        double own = 0;
        for (int i = 0; i < shape.count; ++i)
            own += shape.value[i] * t.owned[static_cast<std::size_t>(shape.dof[i])];
        CHECK(std::abs(errors[k] - (quadratic(probes[k].position) - own)) < 1e-7);
    }
    CHECK(std::abs(errors[2]) < 1e-7);  // at a node
    CHECK(std::abs(errors[1]) > 0.05);
    const auto second = box(2, 2);
    CHECK(interpolation_errors(second.space, field(second.space, quadratic), probes) == std::vector<double>(4, 0.0));
}

namespace {

std::vector<float> snapshot(double a, double b, double c)
{
    std::vector<float> result;
    for (int i = 0; i < 40; ++i)
        result.push_back(static_cast<float>(300 + a * std::sin(0.3 * i) + b * i / 40.0 + c * (i % 2)));
    return result;
}

double rebuilt(const Pod& modes, std::size_t time, std::size_t unknown)
{
    double value = modes.base.owned[unknown];
    for (std::size_t k = 0; k < modes.modes.size(); ++k)
        value += modes.coefficients[k][time] * modes.modes[k].owned[unknown];
    return value;
}

}  // namespace

TEST_CASE("fields of two shapes have two modes that make each of them again")
{
    const std::vector<std::vector<float>> fields{snapshot(0, 0, 0), snapshot(3, 1, 0), snapshot(5, 4, 0),
                                                 snapshot(1, 9, 0)};
    const auto modes = pod(fields, 1e-5, 10);
    REQUIRE(modes.modes.size() == 2);
    double largest = 0;
    for (std::size_t j = 0; j < fields.size(); ++j)
        for (std::size_t i = 0; i < 40; ++i)
            largest = std::max(largest, std::abs(rebuilt(modes, j, i) - static_cast<double>(fields[j][i])));
    CHECK(largest < 1e-4);  // float: 3e-5 at 300 K
    CHECK(modes.error == near(largest, 1e-4, 1e-4));
    CHECK(modes.residual_energy[0] == near(1, 1e-12));
    CHECK(modes.residual_energy[1] < modes.residual_energy[0]);
    // Modes are orthogonal, the strongest first.
    const auto first = bricks::column(modes.modes[0].owned), second = bricks::column(modes.modes[1].owned);
    CHECK(std::abs(first.dot(second)) < 1e-6 * first.norm() * second.norm());
    CHECK(bricks::column(modes.coefficients[0]).norm() * first.norm() >
          bricks::column(modes.coefficients[1]).norm() * second.norm());
}

TEST_CASE("as few modes as the tolerance allows, and never more than wanted")
{
    const std::vector<std::vector<float>> fields{snapshot(0, 0, 0), snapshot(3, 1, 0.01), snapshot(5, 4, -0.02),
                                                 snapshot(1, 9, 0.03)};
    CHECK(pod(fields, 0.01, 10).modes.size() == 2);
    CHECK(pod(fields, 1e-4, 10).modes.size() == 3);
    const auto one = pod(fields, 1e-9, 1);
    CHECK(one.modes.size() == 1);
    CHECK(one.error > 1e-9 * one.largest_rise);
    for (const double tolerance : {0.3, 0.01, 1e-4}) {
        const auto modes = pod(fields, tolerance, 10);
        CHECK(modes.error <= tolerance * modes.largest_rise);
        double largest = 0;
        for (const auto& later : fields)
            for (std::size_t i = 0; i < later.size(); ++i)
                largest =
                    std::max(largest, std::abs(static_cast<double>(later[i]) - static_cast<double>(fields[0][i])));
        CHECK(modes.largest_rise == near(largest, 1e-12));
    }
}

TEST_CASE("a single field is its own base; none, or fields of unlike length, are refused")
{
    const auto modes = pod({snapshot(1, 2, 3)}, 1e-3, 10);
    CHECK(modes.modes.empty());
    CHECK(modes.error == 0);
    CHECK(modes.base.owned[7] == static_cast<double>(snapshot(1, 2, 3)[7]));
    CHECK_THROWS_AS(pod({}, 1e-3, 10), InputError);
    CHECK_THROWS_AS(pod({snapshot(1, 2, 3), {1.0F, 2.0F}}, 1e-3, 10), InputError);
}
