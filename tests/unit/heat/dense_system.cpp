/// Requirement: the matrices of a small system are those of its laws, whichever terms they need.
#include "deadpoint/reduce/online/dense_system.hpp"

#include "deadpoint/error.hpp"
#include "deadpoint/exchange/heat.hpp"
#include "lumps.hpp"

#include <cmath>
#include <doctest/doctest.h>

using namespace deadpoint;
using namespace deadpoint::reduce;
using doctest::Approx;

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
        CHECK(watts[0] == Approx(0.1 * law.film_a * (330 - layer)).epsilon(1e-11));
        CHECK(watts[1] == Approx(0.1 * law.film_b * (310 - layer)).epsilon(1e-11));
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
    CHECK(system.largest(lumps::states_of(machine, Eigen::Vector2d(-3, 2))) == Approx(3).epsilon(1e-14));
    CHECK(system.largest(lumps::states_of(machine, Eigen::Vector2d(1, -2))) == Approx(2).epsilon(1e-14));
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
