/// Requirement: films that follow the temperature give off what their laws say at every point, with tangents that are
/// derivatives; radiation inside a room keeps its heat.
#include "deadpoint/fem/conduction/terms/film_points.hpp"

#include "bricks.hpp"
#include "deadpoint/exchange/heat.hpp"
#include "deadpoint/exchange/laws/laws.hpp"
#include "deadpoint/exchange/machine.hpp"
#include "deadpoint/fem/conduction/terms/joint_terms.hpp"
#include "deadpoint/fem/conduction/terms/prescribed.hpp"
#include "deadpoint/heat/films.hpp"
#include "near.hpp"

#include <doctest/doctest.h>
#include <memory>
#include <tuple>

using namespace deadpoint;
using namespace deadpoint::fem;
using bricks::dense;

namespace {

/// Two blocks a metre apart that look at each other over 1 m2, and the first one's top, half of it exposed.
Machine facing()
{
    auto machine = bricks::machine_of(
        {{{0, 0, 0}, {1, 1, 1}, {2, 1, 2}, false, {}}, {{2, 0, 0}, {3, 1, 1}, {1, 2, 1}, false, {}}});
    bricks::add_surface(machine, 0, 0, true);
    bricks::add_surface(machine, 1, 0, false);
    bricks::add_surface(machine, 0, 2, true, 0.5);
    return machine;
}

FilmLaw rising(double air)
{
    return [air](double t) { return LawValue{4 + 0.1 * (t - air), 0.1, t < 400}; };
}

struct Films {
    explicit Films(bool room = false) : both(facing(), {1, 1}), vector(create_vector(both.space, 1))
    {
        for (int s = 0; s < 3; ++s) {
            SurfaceCondition condition;
            condition.surface = s;
            condition.emissivity = 0.6 + 0.1 * s;
            condition.laws.emplace_back(rising);
            problem.surfaces.push_back(condition);
        }
        if (room)
            problem.radiation = {{{0, 1}, {0.1, 0.5, 0.5, 0.2}}};  // rows sum to eps A = 0.6 and 0.7 m2
        prescribed = std::make_unique<PrescribedTemperatures>(both.space, problem);
        points = std::make_unique<FilmPoints>(both.space, problem, areas, *prescribed, vector);
        for (std::size_t s = 0; s < 3; ++s)
            films.push_back({s, rising(290), problem.surfaces[s].emissivity, 290});
    }
    /// Heat by unknown and sums at temperatures.
    heat::FilmHeat heat(const Eigen::VectorXd& temperature, Eigen::VectorXd& watts) const
    {
        const auto at = bricks::vector_of(both.space, {temperature.begin(), temperature.end()});
        auto target =
            bricks::vector_of(both.space, std::vector<double>(static_cast<std::size_t>(both.space.total), 0.0));
        const auto result = points->add_heat(films, at, target);
        watts = dense(target);
        return result;
    }
    Eigen::MatrixXd tangent(const Eigen::VectorXd& temperature)
    {
        const auto matrix = create_matrix(both.space.cell_couplings().rows());
        const auto at = bricks::vector_of(both.space, {temperature.begin(), temperature.end()});
        points->build_tangents(films, at, matrix);
        return dense(matrix);
    }
    bricks::Space both;
    OwnedVec vector;
    HeatProblem problem;
    const std::vector<double> areas{1, 1, 0.5};
    std::unique_ptr<PrescribedTemperatures> prescribed;
    std::unique_ptr<FilmPoints> points;
    std::vector<heat::FilmAt> films;
};

double uneven(const Vec3& x) { return 330 + 20 * x[1] + 10 * x[2]; }

}  // namespace

TEST_CASE("at an even temperature a surface gives off area times flux, and the unknowns lose it")
{
    const Films at;
    Eigen::VectorXd watts;
    const Eigen::VectorXd even = Eigen::VectorXd::Constant(at.both.space.total, 350);
    const auto heat = at.heat(even, watts);
    for (std::size_t s = 0; s < 3; ++s) {
        const double flux = heat::film_flux(rising(290)(350), at.problem.surfaces[s].emissivity, 350, 290);
        CHECK(heat.lost[s] == near(at.areas[s] * flux, 1e-13));
        CHECK(heat.to_surfaces[s] == 0);
        CHECK(heat.untested[s] == 0);
    }
    CHECK(watts.sum() == near(-(heat.lost[0] + heat.lost[1] + heat.lost[2]), 1e-13));
}

TEST_CASE("radiation of an uneven surface is the integral of its fourth power")
{
    Films at;
    for (auto& film : at.films)
        film.law = [](double) { return LawValue{}; };
    Eigen::VectorXd watts;
    const auto heat = at.heat(bricks::column(at.both.space, uneven), watts);
    // Over y, z = 0..1 of (330 + 20 y + 10 z)^4: differences of the sixth power.
    double integral = 0;
    for (const auto& [y, z, sign] : {std::tuple(1.0, 1.0, 1), {0.0, 1.0, -1}, {1.0, 0.0, -1}, {0.0, 0.0, 1}})
        integral += sign * std::pow(330 + 20 * y + 10 * z, 6) / (30.0 * 20 * 10);
    const double expected = heat::stefan_boltzmann * (integral - std::pow(290.0, 4));
    CHECK(heat.lost[0] == near(0.6 * expected, 1e-9));  // of 5e12 in the sixth powers
    CHECK(heat.lost[1] == near(0.7 * expected, 1e-9));
}

TEST_CASE("a film's tangent is the derivative of its heat")
{
    Films at;
    const auto temperature = bricks::column(at.both.space, uneven);
    const auto matrix = at.tangent(temperature);
    CHECK((matrix - matrix.transpose()).norm() < 1e-13 * matrix.norm());
    Eigen::VectorXd direction = bricks::column(at.both.space, [](const Vec3& x) { return 1 + x[0] - 2 * x[1] * x[2]; });
    constexpr double h = 1e-3;
    Eigen::VectorXd up, down;
    at.heat(temperature + h * direction, up);
    at.heat(temperature - h * direction, down);
    const Eigen::VectorXd by_difference = -(up - down) / (2 * h);
    CHECK((matrix * direction - by_difference).norm() < 1e-7 * by_difference.norm());
}

TEST_CASE("slopes by the air: of the convection alone, point by point")
{
    const Films at;
    auto load =
        bricks::vector_of(at.both.space, std::vector<double>(static_cast<std::size_t>(at.both.space.total), 0.0));
    const auto temperature = bricks::vector_of(at.both.space, uneven);
    at.points->add_slopes({at.films[0]}, temperature, load);
    DEADPOINT_PETSC(VecAssemblyBegin(load));
    DEADPOINT_PETSC(VecAssemblyEnd(load));
    // h + h' (T - T_air) = 4 + 0.2 (T - 290), whose mean over the surface is that at its middle.
    CHECK(dense(load).sum() == near(4 + 0.2 * (345 - 290), 1e-13));
    const auto before = dense(load);
    at.points->add_slopes({}, temperature, load);
    CHECK(dense(load) == before);
}

TEST_CASE("where a law leaves its range the area is told")
{
    const Films at;
    Eigen::VectorXd watts;
    const auto heat =
        at.heat(bricks::column(at.both.space, [](const Vec3& x) { return x[0] < 1.5 ? 420.0 : 350.0; }), watts);
    CHECK(heat.untested[0] == near(1, 1e-13));
    CHECK(heat.untested[1] == 0);
    CHECK(heat.untested[2] == near(0.5, 1e-13));
}

TEST_CASE("films of given coefficients are those of constant films")
{
    const Films at;
    const auto matrix = create_matrix(at.both.space.cell_couplings().rows());
    at.points->build_constant({7, 11, 13}, matrix);
    auto constant = at.problem;
    for (auto& condition : constant.surfaces) {
        condition.emissivity = 0;
        condition.laws.clear();
    }
    const auto terms = film_terms(at.both.space, constant);
    const auto expected = create_matrix(at.both.space.cell_couplings().rows());
    for (std::size_t s = 0; s < 3; ++s)
        terms[s].add_to(expected, std::array{7.0, 11.0, 13.0}[s]);
    DEADPOINT_PETSC(MatAssemblyBegin(expected, MAT_FINAL_ASSEMBLY));
    DEADPOINT_PETSC(MatAssemblyEnd(expected, MAT_FINAL_ASSEMBLY));
    CHECK((dense(matrix) - dense(expected)).norm() < 1e-14 * dense(expected).norm());
}

TEST_CASE("surfaces of a room give each other what they take, and at one temperature nothing")
{
    const Films at(true);
    Eigen::VectorXd watts;
    const auto warm =
        at.heat(bricks::column(at.both.space, [](const Vec3& x) { return uneven(x) + 40 * x[0]; }), watts);
    CHECK(std::abs(warm.to_surfaces[0]) > 50);
    CHECK(std::abs(warm.to_surfaces[0] + warm.to_surfaces[1]) < 1e-9);  // of some hundred watts: rounding
    CHECK(warm.to_surfaces[2] == 0);                                    // no surface of the room
    const auto even = at.heat(Eigen::VectorXd::Constant(at.both.space.total, 350), watts);
    CHECK(std::abs(even.to_surfaces[0]) < 1e-9);
    // What is exchanged: X_01 sigma (T_0^4 - T_1^4) at even temperatures.
    const auto apart =
        at.heat(bricks::column(at.both.space, [](const Vec3& x) { return x[0] < 1.5 ? 400.0 : 300.0; }), watts);
    CHECK(apart.to_surfaces[0] ==
          near(0.5 * heat::stefan_boltzmann * (std::pow(400.0, 4) - std::pow(300.0, 4)), 1e-11));
    CHECK(apart.lost[0] - apart.to_surfaces[0] == near(heat::film_flux(rising(290)(400), 0, 400, 290), 1e-12));
}

TEST_CASE("a room's tangent with its coupling is the derivative of its heat, at one temperature")
{
    Films at(true);
    const Eigen::VectorXd even = Eigen::VectorXd::Constant(at.both.space.total, 350);
    const auto matrix = at.tangent(even);
    const auto direction =
        bricks::column(at.both.space, [](const Vec3& x) { return x[0] < 1.5 ? 1 + x[1] : x[2] - 2; });
    const auto in = bricks::vector_of(at.both.space, {direction.begin(), direction.end()});
    auto out =
        bricks::vector_of(at.both.space, std::vector<double>(static_cast<std::size_t>(at.both.space.total), 0.0));
    at.points->multiply_rooms(1, in, out);
    constexpr double h = 1e-3;
    Eigen::VectorXd up, down;
    at.heat(even + h * direction, up);
    at.heat(even - h * direction, down);
    const Eigen::VectorXd by_difference = -(up - down) / (2 * h);
    CHECK((matrix * direction + dense(out) - by_difference).norm() < 1e-6 * by_difference.norm());
    CHECK(dense(out).norm() > 0.01 * by_difference.norm());
    // Symmetric, and forgotten when asked to be.
    const auto other = bricks::vector_of(at.both.space, uneven);
    auto of_other =
        bricks::vector_of(at.both.space, std::vector<double>(static_cast<std::size_t>(at.both.space.total), 0.0));
    at.points->multiply_rooms(1, other, of_other);
    CHECK(dense(out).dot(dense(other)) == near(dense(of_other).dot(direction), 1e-11));
    at.points->forget_rooms();
    const auto before = dense(out);
    at.points->multiply_rooms(1, in, out);
    CHECK(dense(out) == before);
}

TEST_CASE("constant films alone need no points")
{
    Films at;
    for (auto& condition : at.problem.surfaces) {
        condition.emissivity = 0;
        condition.laws.clear();
    }
    const FilmPoints none(at.both.space, at.problem, at.areas, *at.prescribed, at.vector);
    CHECK_FALSE(none.some());
    CHECK(at.points->some());
}
