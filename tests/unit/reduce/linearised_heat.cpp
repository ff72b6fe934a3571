#include "deadpoint/reduce/online/linearised_heat.hpp"

#include "subjects.hpp"

#include <doctest/doctest.h>

using namespace deadpoint;
using namespace deadpoint::reduce;
using Eigen::VectorXd;

namespace {

constexpr double now = 400;  // [s]

/// Bearings with curved laws of friction heat, by film and by ring temperatures.
subjects::Subject curved_bearings()
{
    auto result = subjects::bearings();
    auto& segment = result.problem.segments[0];
    segment.heat[0] = [](double t) {
        const double value = 80 * std::exp(-(t - 293) / 40);
        return LawValue{value, -value / 40, true};
    };
    segment.ring_heat = {[](double difference) { return 3 * difference + 0.2 * difference * difference; }, {}};
    return result;
}

VectorXd some_temperatures(const DenseTerms& terms)
{
    VectorXd result = 300 * terms.uniform;
    for (Eigen::Index k = 0; k < result.size(); ++k)
        result[k] *= 1 + 0.02 * std::sin(3 * static_cast<double>(k));
    return result;
}
VectorXd some_change(const DenseTerms& terms, double phase)
{
    VectorXd result = terms.uniform;
    for (Eigen::Index k = 0; k < result.size(); ++k)
        result[k] *= std::cos(phase + static_cast<double>(k));
    return result;
}

/// sources - K T as the time integration has it.
VectorXd rate(const DenseTerms& terms, const HeatProblem& problem, const VectorXd& temperature)
{
    DenseSystem system(terms, problem);
    heat::HeatSources<DenseSystem> sources(system, problem);
    sources.enter(problem.segments[0]);
    VectorXd conducted = system.make_vector();
    system.conduct(temperature, conducted);
    return sources.at(now, temperature).watts - conducted;
}

/// Central difference of fourth order of a function at 0.
template <class Function>
VectorXd slope_of(const Function& function, double step)
{
    return (8 * (function(step) - function(-step)) - (function(2 * step) - function(-2 * step))) / (12 * step);
}

void check_equal(const VectorXd& found, const VectorXd& expected, double tolerance)
{
    CHECK((found - expected).norm() <= tolerance * expected.norm());
}

}  // namespace

TEST_CASE("the derivative of the rate by temperature: conduction, friction heat by film and by ring temperatures")
{
    for (const auto& subject : {subjects::rods_with_break(), subjects::bearings(), curved_bearings()}) {
        const auto problem = subject.at(subject.values);
        const auto temperature = some_temperatures(subject.terms);
        const VectorXd x = some_change(subject.terms, 0.3), y = some_change(subject.terms, 1.7);
        LinearisedHeat heat(subject.terms, problem, 0);
        const auto state = heat.at(now, temperature);
        const auto expected =
            slope_of([&](double step) { return rate(subject.terms, problem, temperature + step * x); }, 0.1);
        check_equal(heat.apply(state, x), expected, 1e-8);  // the laws are tables to 1e-10 of their heat
        CHECK(y.dot(VectorXd(heat.apply(state, x))) ==
              doctest::Approx(x.dot(VectorXd(heat.apply_transposed(state, y)))).epsilon(1e-12));
    }
}

TEST_CASE("the derivative of the rate by every coefficient, and its transpose")
{
    for (const auto& subject : {subjects::rods_with_break(), subjects::bearings(), curved_bearings()}) {
        const auto problem = subject.at(subject.values);
        const auto temperature = some_temperatures(subject.terms);
        const VectorXd weights = some_change(subject.terms, 0.9);
        const LinearisedHeat heat(subject.terms, problem, 0);
        const auto state = heat.at(now, temperature);
        const auto by_scalar = heat.scalar_weights(state, weights);
        for (std::size_t k = 0; k < subject.box.size(); ++k) {
            CAPTURE(subject.box[k].name);
            const auto with = [&](double step) {
                auto values = subject.values;
                values[k] += step;
                return subject.at(values);
            };
            const auto change = change_per(1, problem, with(1), 0, now);
            const auto found = heat.rate_change(state, change);
            check_equal(found,
                        slope_of([&](double step) { return rate(subject.terms, with(step), temperature); }, 0.003),
                        1e-8);
            CHECK(dot(change, by_scalar) == doctest::Approx(found.dot(weights)).epsilon(1e-11));
        }
    }
}

TEST_CASE("the equations of a stage and their transpose, solved")
{
    const auto subject = curved_bearings();
    const auto problem = subject.at(subject.values);
    LinearisedHeat heat(subject.terms, problem, 0);
    const auto state = heat.at(now, some_temperatures(subject.terms));
    const VectorXd right = some_change(subject.terms, 0.2);
    for (const double factor : {3.0, 100.0, 3.0}) {
        const VectorXd x = heat.solve(factor, state, right), y = heat.solve_transposed(factor, state, right);
        check_equal(x - factor * heat.apply(state, x), right, 1e-12);
        check_equal(y - factor * heat.apply_transposed(state, y), right, 1e-12);
    }
}

TEST_CASE("the change of a problem's scalars per unit of a coefficient, at a time")
{
    const auto problem = subjects::bearings().problem;
    auto changed = problem;
    changed.surfaces[0].coefficient += 6;
    changed.surfaces[1].ambient = [](double time) { return 285 + 0.01 * time; };
    changed.sources[1].share = 1.5;
    changed.segments[0].interfaces = problem.interfaces;
    changed.segments[0].interfaces[2].oil += 8;
    const auto change = change_per(2, problem, changed, 0, now);
    CHECK(change.films == std::vector<double>{3, 0, 0});
    CHECK(change.surroundings == std::vector<double>{0, 2, 0});
    CHECK(change.shares == std::vector<double>{0, 0.25});
    CHECK(change.joints == std::vector<JointScalars>{{}, {}, {0, 0, 4, 0}});
}
