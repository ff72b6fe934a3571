/// Requirement: minima are those of functions whose minima are known, under bounds and limits, with and without
/// derivatives.
#include "deadpoint/design/minimise.hpp"

#include "deadpoint/error.hpp"
#include "near.hpp"

#include <cmath>
#include <doctest/doctest.h>

using namespace deadpoint::design;

namespace {

/// (x - 0.9)^2 + 4 (y - 0.2)^2 under x + y <= 0.8: by Lagrange's multiplier l, x = 0.9 - l/2, y = 0.2 - l/8 with
/// 5 l/8 = 0.3, so l = 0.48, x = 0.66, y = 0.14, value 0.0576 + 0.0144 = 0.072.
MinimiseProblem limited_parabola()
{
    return {
        2,
        1,
        [](const Point& at, bool derivatives) {
            Evaluation found{std::pow(at[0] - 0.9, 2) + 4 * std::pow(at[1] - 0.2, 2), {}, {at[0] + at[1] - 0.8}, {}};
            if (derivatives) {
                found.slope = {2 * (at[0] - 0.9), 8 * (at[1] - 0.2)};
                found.slopes = {{1, 1}};
            }
            return found;
        },
        {}};
}

/// Rosenbrock's valley over [-2, 2]^2, minimum 0 at (1, 1), that is (0.75, 0.75) of the cube.
MinimiseProblem valley()
{
    return {2,
            0,
            [](const Point& at, bool derivatives) {
                const double x = 4 * at[0] - 2, y = 4 * at[1] - 2;
                Evaluation found{std::pow(1 - x, 2) + 100 * std::pow(y - x * x, 2), {}, {}, {}};
                if (derivatives)
                    found.slope = {4 * (-2 * (1 - x) - 400 * x * (y - x * x)), 4 * 200 * (y - x * x)};
                return found;
            },
            {}};
}

}  // namespace

TEST_CASE("all methods find the minimum on a limit, worked out with Lagrange's multiplier")
{
    for (const auto method : {MinimiseMethod::slsqp, MinimiseMethod::ccsa, MinimiseMethod::cobyla}) {
        CAPTURE(name_of(method));
        const auto found = minimise(limited_parabola(), {0.1, 0.9}, {method, 300, 1e-8, 1e-8});
        CHECK(found.feasible);
        // The value is flat at the minimum: 1e-6 of it is 1e-3 of the variables.
        CHECK(found.value == near(0.072, 1e-5));
        CHECK(found.at[0] == near(0.66, 2e-3));
        CHECK(found.at[1] == near(0.14, 2e-2));
        CHECK(found.steps.size() > 3);
    }
}

TEST_CASE("Rosenbrock's valley leads to its end, and bounds hold")
{
    const auto found = minimise(valley(), {0.2, 0.75}, {MinimiseMethod::slsqp, 500, 1e-12, 1e-6});
    CHECK(found.at[0] == near(0.75, 1e-3));
    CHECK(found.value < 1e-5);
    auto beyond = limited_parabola();
    beyond.limits = 0;
    beyond.evaluate = [](const Point& at, bool) { return Evaluation{-at[0] - 2 * at[1], {-1, -2}, {}, {}}; };
    const auto corner = minimise(beyond, {0.5, 0.5}, {MinimiseMethod::slsqp, 100, 1e-8, 1e-8});
    CHECK(corner.at == Point{1, 1});
}

TEST_CASE("limits that cannot be kept are said, with the point that exceeds them least")
{
    auto problem = limited_parabola();
    problem.evaluate = [](const Point& at, bool) { return Evaluation{at[1], {0, 1}, {1.5 - at[0]}, {{-1, 0}}}; };
    const auto found = minimise(problem, {0.2, 0.5}, {MinimiseMethod::slsqp, 100, 1e-6, 1e-4});
    CHECK_FALSE(found.feasible);
    CHECK(found.at[0] == near(1, 1e-3));
}

TEST_CASE("an error of the function passes through, and a search can be stopped")
{
    auto problem = valley();
    problem.evaluate = [](const Point&, bool) -> Evaluation { throw deadpoint::DomainError("too hot"); };
    CHECK_THROWS_WITH_AS(minimise(problem, {0.2, 0.2}, {}), "too hot", deadpoint::DomainError);
    problem = valley();
    int asked = 0;
    problem.stopped = [&] { return ++asked > 5; };
    const auto found = minimise(problem, {0.2, 0.75}, {MinimiseMethod::slsqp, 500, 1e-12, 1e-6});
    CHECK(found.end == "it was stopped");
    CHECK(found.steps.size() <= 7);
}
