#include "deadpoint/reduce/sensitivity/linearised_heat.hpp"

#include "deadpoint/reduce/sensitivity/changed_rates.hpp"
#include "deadpoint/reduce/sensitivity/stage_equations.hpp"
#include "near.hpp"
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

/// The rates as the time integration has them: sources - K T of the states, then those of sumps and enclosed air [W].
struct Rates {
    VectorXd states, media;
    heat::StageRecord record;
};
Rates rates(const DenseTerms& terms, const HeatProblem& problem, const VectorXd& temperature)
{
    DenseSystem system(terms, problem);
    heat::HeatSources<DenseSystem> sources(system, problem);
    sources.enter(problem.segments[0]);
    std::vector<double> sumps, air;
    for (const auto& circuit : problem.oil)
        sumps.push_back(circuit.sump_start);
    for (const auto& enclosure : problem.enclosures)
        air.push_back(enclosure.start);
    sources.oil.set_sumps(sumps);
    sources.air.start_from(air);
    VectorXd conducted = system.make_vector();
    system.conduct(temperature, conducted);
    const auto found = sources.equilibrate_oil(now, temperature);
    Rates result{found.watts - conducted, {}, found.balance};
    std::vector<double> media;
    for (std::size_t k = 0; k < problem.oil.size(); ++k)
        if (!problem.oil[k].cooled && problem.oil[k].sump_capacity > 0)
            media.push_back(problem.oil[k].sump_capacity * found.balance.oil[k].sump_rate);
    for (const auto& flow : found.balance.air)
        media.push_back(flow.kept());
    result.media = Eigen::Map<const VectorXd>(media.data(), static_cast<Eigen::Index>(media.size()));
    return result;
}
VectorXd joined(const Rates& rates)
{
    VectorXd result(rates.states.size() + rates.media.size());
    result << rates.states, rates.media;
    return result;
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

/// A subject at its values, linearised.
struct Linearised {
    explicit Linearised(const subjects::Subject& subject)
        : problem(subject.at(subject.values)), prepared(subject.terms), heat(prepared, problem, 0), stages(heat),
          temperature(some_temperatures(prepared.terms)),
          state(heat.at(rates(prepared.terms, problem, temperature).record, heat.into_basis(temperature)))
    {}
    /// Rates as of rates(), where the states change, and what coefficients do.
    [[nodiscard]] VectorXd rates_along(const VectorXd& x, const Derivatives& changes) const
    {
        const auto count = heat.inner().count();
        Derivatives along{heat.into_basis(x), Eigen::MatrixXd::Zero(count, 1)};
        stages.start(state, changes.inner, along);
        Rates result;
        result.states =
            heat.from_basis(heat.loads(state) * along.inner - heat.conduct(state, along.states) + changes.states);
        const VectorXd inner = state.rows.transpose() * along.states + state.inner * along.inner + changes.inner;
        std::vector<double> media;
        for (Eigen::Index k = 0; k < count; ++k)
            if (stages.capacity()[k] > 0)
                media.push_back(inner[k]);
        result.media = Eigen::Map<const VectorXd>(media.data(), static_cast<Eigen::Index>(media.size()));
        return joined(result);
    }
    [[nodiscard]] Derivatives nothing() const
    {
        return {VectorXd::Zero(prepared.terms.uniform.size()), VectorXd::Zero(heat.inner().count())};
    }
    HeatProblem problem;
    PreparedTerms prepared;
    LinearisedHeat heat;
    StageEquations stages;
    VectorXd temperature;
    LinearisedState state;
};

std::vector<subjects::Subject> all_subjects()
{
    return {subjects::rods_with_break(),    subjects::bearings(),        curved_bearings(),
            subjects::oiled_bearings(4000), subjects::oiled_bearings(0), subjects::warm_bearings(),
            subjects::enclosed_bearings()};
}

}  // namespace

TEST_CASE("the derivative of the rates by temperature: conduction, friction heat, oil, air and films")
{
    for (const auto& subject : all_subjects()) {
        const Linearised at(subject);
        const VectorXd x = some_change(subject.terms, 0.3);
        const auto expected = slope_of(
            [&](double step) { return joined(rates(at.prepared.terms, at.problem, at.temperature + step * x)); }, 0.1);
        // Laws are tables to 1e-10 of their heat, and oil and joints agree to 1e-9 K.
        check_equal(at.rates_along(x, at.nothing()), expected, 1e-7);
    }
}

TEST_CASE("the derivative of the rates by every coefficient, and its transpose")
{
    for (const auto& subject : all_subjects()) {
        const Linearised at(subject);
        const auto along = directions(subject.problem, subject.box, subject.values);
        ChangedRates changed(at.heat, along);
        const auto found = changed.at(at.state);
        const Derivatives weights{at.heat.into_basis(some_change(subject.terms, 0.9)),
                                  VectorXd::LinSpaced(at.heat.inner().count(), 0.5, 2)};
        std::vector<double> products(along.size(), 0.0);
        changed.add_weighted(at.state, weights, products);
        changed.finish(products);
        for (std::size_t k = 0; k < subject.box.size(); ++k) {
            CAPTURE(subject.box[k].name);
            const auto column = static_cast<Eigen::Index>(k);
            const auto with = [&](double step) {
                auto values = subject.values;
                values[k] += step;
                return joined(rates(at.prepared.terms, subject.at(values), at.temperature));
            };
            check_equal(at.rates_along(VectorXd::Zero(at.temperature.size()),
                                       {found.states.col(column), found.inner.col(column)}),
                        slope_of(with, 0.01), 1e-7);
            CHECK(products[k] == near(found.states.col(column).dot(weights.states.col(0)) +
                                          found.inner.col(column).dot(weights.inner.col(0)),
                                      1e-11));
        }
    }
}

TEST_CASE("the equations of a stage and their transpose, solved")
{
    for (const auto& subject : all_subjects()) {
        Linearised at(subject);
        const auto count = at.heat.inner().count();
        const Derivatives right{some_change(subject.terms, 0.2), VectorXd::LinSpaced(count, -1, 2)};
        const Eigen::MatrixXd &loads = at.heat.loads(at.state), &rows = at.state.rows;
        for (const double d : {3.0, 100.0, 3.0}) {
            const Eigen::MatrixXd scales = at.stages.scales(d).asDiagonal();
            Eigen::MatrixXd inner = -scales * at.state.inner;
            inner += Eigen::MatrixXd(at.stages.capacity().asDiagonal());
            at.stages.set(d, at.state);
            auto x = right, y = right;
            at.stages.solve(x);
            at.stages.solve_transposed(y);
            check_equal(x.states + d * (at.heat.conduct(at.state, x.states) - loads * x.inner), right.states, 1e-11);
            check_equal(inner * x.inner - scales * rows.transpose() * x.states, right.inner, 1e-11);
            check_equal(y.states + d * at.heat.conduct(at.state, y.states) - rows * scales * y.inner, right.states,
                        1e-11);
            check_equal(inner.transpose() * y.inner - d * loads.transpose() * y.states, right.inner, 1e-11);
        }
    }
}

TEST_CASE("the change of a problem's scalars per unit of a coefficient")
{
    const auto problem = subjects::bearings().problem;
    auto changed = problem;
    changed.surfaces[0].coefficient += 6;
    changed.sources[1].share = 1.5;
    changed.segments[0].interfaces = problem.interfaces;
    changed.segments[0].interfaces[2].oil += 8;
    changed.segments[0].zoned_heat = {20, 11};
    const ScalarLayout layout(problem);
    CHECK(lasting_changes(problem, changed, 2, 0) == ScalarChanges{{layout.joint(2, JointScalar::oil), 4},
                                                                   {layout.film(0), 3},
                                                                   {layout.share(1), 0.25},
                                                                   {layout.zoned(1), 0.5}});
    CHECK(lasting_changes(problem, problem, 2, 0).empty());
}
