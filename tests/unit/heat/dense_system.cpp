/// Requirement: the matrices of a small system are those of its laws, whichever terms they need.
#include "deadpoint/reduce/online/dense_system.hpp"

#include "deadpoint/error.hpp"
#include "deadpoint/exchange/heat.hpp"
#include "deadpoint/heat/films.hpp"
#include "lumps.hpp"
#include "near.hpp"

#include <cmath>
#include <doctest/doctest.h>
#include <utility>
#include <vector>

using namespace deadpoint;
using namespace deadpoint::reduce;

namespace {

InterfaceLaw law_of(double a, double b, double oil)
{
    InterfaceLaw law;
    law.film_a = a;
    law.film_b = b;
    law.oil = oil;
    return law;
}

HeatProblem one_joint(const InterfaceLaw& law)
{
    HeatProblem problem;
    problem.interfaces = {law};
    problem.segments = {lumps::segment(problem, 1000, 290)};
    return problem;
}

const lumps::Machine pair{{2e3, 5e3}, {}, {{0, 1, 0.1}}, {}, {0, 1}};

}  // namespace

TEST_CASE("a joint conducts what its contact layer does: each side's flux over the layer's temperature, on paper")
{
    for (const auto& law : {law_of(800, 400, 0), law_of(800, 400, 250), law_of(0, 400, 30), law_of(1e6, 1, 1e3)}) {
        const auto problem = one_joint(law);
        DenseSystem system(lumps::terms_of(pair, problem), problem);
        system.set_laws(problem.interfaces, {});
        Eigen::VectorXd out(2);
        system.conduct(lumps::states_of(pair, Eigen::Vector2d(330, 310)), out);
        const Eigen::VectorXd watts = lumps::watts_of(pair, out);
        // Oil of 0 K: the matrix holds no oil temperature.
        const double layer = (law.film_a * 330 + law.film_b * 310) / (law.film_a + law.film_b + law.oil);
        CHECK(watts[0] == near(0.1 * law.film_a * (330 - layer), 1e-11));
        CHECK(watts[1] == near(0.1 * law.film_b * (310 - layer), 1e-11));
    }
}

TEST_CASE("a joint needs only those terms that its laws use, and tells which one misses")
{
    auto problem = one_joint(law_of(800, 400, 250));
    auto terms = lumps::terms_of(pair, problem);
    terms.joints[0].turning = {};
    DenseSystem still(terms, problem);
    CHECK_NOTHROW(still.set_laws(problem.interfaces, {}));
    problem.interfaces[0].turns_fully = true;
    CHECK_THROWS_WITH_AS(still.set_laws(problem.interfaces, {}), doctest::Contains("turns fully that did not"),
                         InputError);
    terms.joints[0].turning = terms.joints[0].between;
    terms.joints[0].between = {};
    DenseSystem turning(terms, problem);
    CHECK_NOTHROW(turning.set_laws(problem.interfaces, {}));
    problem.interfaces[0].turns_fully = false;
    CHECK_THROWS_WITH_AS(turning.set_laws(problem.interfaces, {}), doctest::Contains("does not turn fully that did"),
                         InputError);
}

TEST_CASE("sizes of a correction are in kelvin: the largest mean or probe, not the largest state")
{
    HeatProblem problem = one_joint(law_of(800, 400, 0));
    problem.surfaces = {lumps::film(10)};
    const lumps::Machine machine{{2e3, 5e3}, {}, {{0, 1, 0.1}}, {{1, 0.25}}, {}};
    DenseSystem system(lumps::terms_of(machine, problem), problem);
    CHECK(system.largest(lumps::states_of(machine, Eigen::Vector2d(-3, 2))) == near(3, 1e-14));
    CHECK(system.largest(lumps::states_of(machine, Eigen::Vector2d(1, -2))) == near(2, 1e-14));
}

TEST_CASE("a film without a term is refused by name, a flux needs none")
{
    auto problem = one_joint(law_of(800, 400, 0));
    problem.surfaces = {lumps::film(10)};
    problem.surfaces[0].name = "front";
    auto terms = lumps::terms_of({{2e3, 5e3}, {}, {{0, 1, 0.1}}, {{1, 0.25}}, {}}, problem);
    terms.films[0] = {};
    CHECK_THROWS_WITH_AS(DenseSystem(terms, problem), doctest::Contains("surface 'front' has a film but no term"),
                         InputError);
    problem.surfaces[0].kind = SurfaceCondition::Kind::flux;
    CHECK_NOTHROW(DenseSystem(terms, problem));
    problem.surfaces[0].kind = SurfaceCondition::Kind::temperature;
    CHECK_THROWS_WITH_AS(DenseSystem(terms, problem), doctest::Contains("no prescribed temperature"), InputError);
}

namespace {

/// A plate of 24 lumps, each of another capacity and a 24th of its 0.6 m2, that faces one film.
struct Plate {
    static constexpr int count = 24;
    static constexpr double area = 0.6, air = 293;
    explicit Plate(SurfaceCondition condition)
    {
        condition.name = "plate";
        problem.surfaces = {std::move(condition)};
        problem.segments = {lumps::segment(problem, 1000, air)};
        auto& layout = terms.geometry.layout;
        layout = {0, 0, 1, 0, 0};
        terms.geometry.surface_area = {area};
        terms.uniform = Eigen::VectorXd::LinSpaced(count, 20, 60);
        terms.solid = Eigen::MatrixXd::Zero(count, count);
        terms.functionals = (area / count / terms.uniform.array()).matrix().transpose();
        const Eigen::VectorXd weights = std::sqrt(area / count) / terms.uniform.array();
        terms.films = {{weights.asDiagonal()}};
    }
    /// Heat of the whole surface: that is booked, and that the states lose.
    [[nodiscard]] std::pair<double, double> heat(const Eigen::VectorXd& temperatures) const
    {
        DenseSystem system(terms, problem);
        Eigen::VectorXd watts = system.make_vector();
        heat::HeatGeometry geometry = terms.geometry;
        heat::FilmBalance films(problem, geometry);
        films.enter(problem.segments[0]);
        const auto booked = system.add_films(films.following(0, {}), states(temperatures), watts);
        return {booked.lost[0], -system.total(watts)};
    }
    [[nodiscard]] Eigen::VectorXd states(const Eigen::VectorXd& temperatures) const
    {
        return terms.uniform.cwiseProduct(temperatures);
    }
    /// Heat of the law at each lump's own temperature.
    template <class Flux>
    static double pointwise(const Eigen::VectorXd& temperatures, const Flux& flux)
    {
        double sum = 0;
        for (const double t : temperatures)
            sum += area / count * flux(t);
        return sum;
    }
    HeatProblem problem;
    reduce::DenseTerms terms;
};

/// Temperatures around 330 K with a skewed distribution of a given amplitude.
Eigen::VectorXd spread(double amplitude)
{
    const Eigen::ArrayXd x = Eigen::ArrayXd::LinSpaced(Plate::count, -1, 1);
    const Eigen::ArrayXd shape = x + 0.6 * x.square() - 0.3 * x.cube();
    return 330 + amplitude * (shape - shape.mean());
}

SurfaceCondition natural_convection()
{
    SurfaceCondition condition;
    condition.laws.emplace_back([](double air) -> FilmLaw {
        return [air](double t) {
            const double value = 1.7 * std::pow(t - air, 0.25);
            return LawValue{value, 0.25 * value / (t - air), true};
        };
    });
    return condition;
}

}  // namespace

TEST_CASE("a film's heat over an uneven surface is that of all its points, to third order in the unevenness")
{
    auto radiating = lumps::film(0);
    radiating.emissivity = 0.8;
    const auto radiation = [](double t) {
        return 0.8 * heat::stefan_boltzmann * (std::pow(t, 4) - std::pow(Plate::air, 4));
    };
    const auto convection = [](double t) { return 1.7 * std::pow(t - Plate::air, 1.25); };
    const auto errors = [](const Plate& plate, const auto& flux) {
        std::vector<double> result;
        for (const double amplitude : {16.0, 8.0, 4.0}) {
            const auto [booked, lost] = plate.heat(spread(amplitude));
            CHECK(lost == near(booked, 1e-12));
            result.push_back(std::abs(booked - Plate::pointwise(spread(amplitude), flux)));
        }
        return result;
    };
    const auto of_radiation = errors(Plate(radiating), radiation);
    const auto of_convection = errors(Plate(natural_convection()), convection);
    for (const auto* error : {&of_radiation, &of_convection}) {
        // What is left out is q''' times the skewness: an eighth at half the amplitude, q'''' makes the rest.
        CHECK((*error)[0] / (*error)[1] == near(8, 0.15));
        CHECK((*error)[1] / (*error)[2] == near(8, 0.1));
    }
    // The law at the mean alone would leave out the variance: 7 and 2 W of some 100 W.
    CHECK(of_radiation[0] < 0.1);
    CHECK(of_convection[0] < 0.1);
}

TEST_CASE("a film over an uneven surface takes heat where it is warm: the tangent times the distance to the mean")
{
    auto radiating = lumps::film(0);
    radiating.emissivity = 0.8;
    const Plate plate(radiating);
    DenseSystem system(plate.terms, plate.problem);
    heat::FilmBalance films(plate.problem, plate.terms.geometry);
    films.enter(plate.problem.segments[0]);
    const Eigen::VectorXd even = spread(0), uneven = spread(4);
    Eigen::VectorXd watts = system.make_vector();
    const auto booked = system.add_films(films.following(0, {}), plate.states(uneven), watts);
    const double slope = 4 * 0.8 * heat::stefan_boltzmann * std::pow(330.0, 3);
    for (int k = 0; k < Plate::count; ++k) {
        const double flux = -watts[k] * plate.terms.uniform[k] / (Plate::area / Plate::count);
        CHECK(flux - booked.lost[0] / Plate::area == near(slope * (uneven[k] - even[k]), 1e-9));
    }
}

TEST_CASE("surfaces that radiate to each other exchange heat and lose none, however uneven they are")
{
    auto radiating = lumps::film(0);
    radiating.emissivity = 0.8;
    Plate plate(radiating);
    // Half of the plate against the other half; exchange of 0.1 m2.
    plate.problem.surfaces.push_back(plate.problem.surfaces[0]);
    plate.problem.radiation = {{{0, 1}, {0, 0.1, 0.1, 0}}};
    auto& terms = plate.terms;
    terms.geometry.layout = {0, 0, 2, 0, 0};
    terms.geometry.surface_area = {Plate::area / 2, Plate::area / 2};
    const Eigen::MatrixXd whole = terms.films[0].factor;
    const reduce::RowMatrix row = terms.functionals;
    terms.films = {{whole.leftCols(12)}, {whole.rightCols(12)}};
    terms.functionals = reduce::RowMatrix::Zero(2, Plate::count);
    terms.functionals.row(0).head(12) = row.row(0).head(12);
    terms.functionals.row(1).tail(12) = row.row(0).tail(12);
    for (auto& condition : plate.problem.surfaces)
        condition.emissivity = 0.1 / (Plate::area / 2);
    DenseSystem system(terms, plate.problem);
    heat::FilmBalance films(plate.problem, terms.geometry);
    films.enter(plate.problem.segments[0]);
    Eigen::VectorXd watts = system.make_vector();
    const Eigen::VectorXd uneven = spread(16);
    const auto booked = system.add_films(films.following(0, {}), plate.states(uneven), watts);
    CHECK(booked.to_surfaces[0] == near(-booked.to_surfaces[1], 1e-12));
    CHECK(std::abs(system.total(watts)) < 1e-12 * std::abs(booked.lost[0]) * Plate::count);
    const auto mean_power = [&](int begin) { return uneven.segment(begin, 12).array().square().square().mean(); };
    const double exact = 0.1 * heat::stefan_boltzmann * (mean_power(0) - mean_power(12));
    CHECK(booked.lost[0] == near(exact, 2e-3));  // third order: the means of T^4 without skewness
}

TEST_CASE("a film whose slope grows many times within a run is followed: the matrix is reduced anew where it must be")
{
    // A lump of 500 J/K gives off 2e-4 W/K^4 x (T - 290)^4: y = T - 290, y' = -a y^4, 1/y^3 = 1/y0^3 + 3 a t.
    SurfaceCondition steep;
    steep.name = "steep";
    steep.laws.emplace_back([](double air) -> FilmLaw {
        return [air](double t) {
            const double rise = t - air;
            return LawValue{2e-4 * rise * rise * rise, 6e-4 * rise * rise, true};
        };
    });
    HeatProblem problem;
    problem.surfaces = {steep};
    problem.body_heat = {{"motor", {0}, -1}};
    problem.segments = {lumps::segment(problem, 2e4, 290), lumps::segment(problem, 4000, 290)};
    problem.segments[0].body_heat[0] = lumps::steady(2e4);  // steady at 100 K
    problem.surfaces[0].laws.push_back(problem.surfaces[0].laws[0]);
    problem.time_tolerance = 1e-4;
    lumps::Run run({{500}, {}, {}, {{0, 1.0}}, {0}}, problem, 291);
    const auto& history = run.go();
    CHECK(interpolate(history.time, history.probes[0], 2e4) == near(390, 1e-9));
    const double end = std::pow(1e-6 + 3 * 2e-4 / 500 * 4000, -1 / 3.0);
    CHECK(history.probes[0].value.back() - 290 == near(end, 1e-3));  // the errors of steps add up
    CHECK(history.energy.mismatch() < 1e-7);                         // Newton ends at 1e-7 K
}
