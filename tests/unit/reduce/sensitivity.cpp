#include "deadpoint/reduce/sensitivity/sensitivity.hpp"

#include "deadpoint/error.hpp"
#include "near.hpp"
#include "subjects.hpp"

#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>
#include <functional>
#include <string>
#include <utility>

using namespace deadpoint;
using namespace deadpoint::reduce;
using subjects::bearings;
using subjects::enclosed_bearings;
using subjects::oiled_bearings;
using subjects::rods_with_break;
using subjects::Subject;
using subjects::warm_bearings;

namespace {

RecordedRun run_of(const Subject& subject)
{
    lumps::Quiet observer;
    return record_run(std::make_shared<const PreparedTerms>(subject.terms), subject.at(subject.values), 293, observer);
}
std::vector<Direction> directions_of(const Subject& subject)
{
    return directions(subject.problem, subject.box, subject.values);
}
std::vector<Output> outputs_of(const DenseTerms& terms)
{
    std::vector<Output> result;
    const auto add = [&](Output::Kind kind, std::size_t count) {
        for (std::size_t k = 0; k < count; ++k)
            result.push_back({kind, k});
    };
    add(Output::Kind::probe, terms.geometry.layout.probes);
    add(Output::Kind::side_a, terms.geometry.layout.interfaces);
    add(Output::Kind::side_b, terms.geometry.layout.interfaces);
    add(Output::Kind::observed, static_cast<std::size_t>(terms.observed.rows()));
    return result;
}

/// States at the ends of a run's steps, with other coefficients and the same step lengths.
std::vector<Eigen::VectorXd> repeated(const DenseTerms& terms, HeatProblem problem,
                                      const std::vector<RecordedStep>& steps)
{
    problem.fixed_step = 1;  // without error estimates
    DenseSystem system(terms, problem);
    heat::HeatSources<DenseSystem> sources(system, problem);
    heat::StageSolver<DenseSystem> stages(system, sources);
    heat::Stepper<DenseSystem> stepper(system, sources, stages, {});
    stepper.now().temperature.setZero();
    for (Eigen::Index p = 0; p < terms.parts.cols(); ++p)
        stepper.now().temperature += problem.initial_temperature(static_cast<int>(p), {}) * terms.parts.col(p);
    std::vector<double> sumps, air;
    for (const auto& circuit : problem.oil)
        sumps.push_back(circuit.sump_start);
    for (const auto& enclosure : problem.enclosures)
        air.push_back(enclosure.start);
    sources.oil.set_sumps(sumps);
    sources.air.start_from(air);
    std::vector<Eigen::VectorXd> result;
    for (std::size_t k = 0; k < steps.size(); ++k) {
        const auto& record = steps[k].record;
        if (k == 0 || record.segment != steps[k - 1].record.segment)
            stepper.begin_segment(problem.segments[record.segment], record.start.time);
        stepper.step(record.start.time, record.duration);
        stepper.complete_first_slope(record.duration);
        stepper.accept(record.duration);
        result.push_back(stepper.now().temperature);
    }
    return result;
}

double value_of(const DenseTerms& terms, Output output, const Eigen::VectorXd& states)
{
    const auto& layout = terms.geometry.layout;
    if (output.kind == Output::Kind::observed)
        return terms.observed.row(static_cast<Eigen::Index>(output.index)).dot(states);
    const auto row = output.kind == Output::Kind::probe
                         ? layout.probe(output.index)
                         : layout.mean(output.index, output.kind == Output::Kind::side_b);
    return terms.functionals.row(static_cast<Eigen::Index>(row)).dot(states);
}

/// Central differences of fourth order of the states at the ends of the steps, by a coefficient of a problem.
using ProblemAt = std::function<HeatProblem(double change)>;
std::vector<Eigen::VectorXd> differences(const DenseTerms& terms, const RecordedRun& run, const ProblemAt& problem_at,
                                         double step = 0.004)
{
    const auto with = [&](double change) { return repeated(terms, problem_at(change), run.steps); };
    const auto more = with(step), less = with(-step), much_more = with(2 * step), much_less = with(-2 * step);
    std::vector<Eigen::VectorXd> result;
    for (std::size_t k = 0; k < more.size(); ++k)
        result.emplace_back((8 * (more[k] - less[k]) - (much_more[k] - much_less[k])) / (12 * step));
    return result;
}
ProblemAt by_coefficient(const Subject& subject, std::size_t coefficient)
{
    return [&subject, coefficient](double change) {
        auto values = subject.values;
        values[coefficient] += change;
        return subject.at(values);
    };
}

/// Largest difference of a series to central differences, over the largest of them.
double error_of(const std::vector<double>& series, const RecordedRun& run, Output output,
                const std::vector<Eigen::VectorXd>& expected)
{
    double largest = 0, error = 0;
    for (std::size_t k = 0; k < expected.size(); ++k) {
        const double value = value_of(run.terms->terms, output, expected[k]);
        largest = std::max(largest, std::abs(value));
        error = std::max(error, std::abs(series[run.steps[k].record.row] - value));
    }
    return error / largest;
}

/// Largest error_of() of all outputs and coefficients: each series by its own size.
double largest_error(const Subject& subject)
{
    const auto run = run_of(subject);
    const auto outputs = outputs_of(subject.terms);
    const auto found = forward(run, directions_of(subject), outputs);
    double result = 0;
    for (std::size_t k = 0; k < subject.box.size(); ++k) {
        const auto expected = differences(subject.terms, run, by_coefficient(subject, k));
        for (std::size_t o = 0; o < outputs.size(); ++o)
            result = std::max(result, error_of(found[k][o], run, outputs[o], expected));
    }
    return result;
}

/// Largest difference of gradients at some rows to the forward derivatives, over the largest of all of that output.
double largest_mismatch(const Subject& subject)
{
    const auto run = run_of(subject);
    const auto outputs = outputs_of(subject.terms);
    const auto along = directions_of(subject);
    const auto found = forward(run, along, outputs);
    double result = 0;
    const std::size_t rows = run.history.time.size();
    for (std::size_t o = 0; o < outputs.size(); ++o) {
        double largest = 0, error = 0;
        for (const auto& of_direction : found)
            for (const double value : of_direction[o])
                largest = std::max(largest, std::abs(value));
        for (const std::size_t row : {std::size_t{0}, std::size_t{1}, rows / 3, rows / 2, rows - 1}) {
            const auto back = gradient(run, along, outputs[o], row);
            for (std::size_t k = 0; k < along.size(); ++k)
                error = std::max(error, std::abs(found[k][o][row] - back[k]));
        }
        result = std::max(result, error / largest);
    }
    return result;
}

}  // namespace

TEST_CASE("a run repeats with its own step lengths, which are not all equal")
{
    const auto subject = rods_with_break();
    const auto run = run_of(subject);
    const auto again = repeated(subject.terms, run.problem, run.steps);
    REQUIRE(run.steps.size() + 3 == run.history.time.size());
    for (std::size_t k = 0; k < again.size(); ++k)
        CHECK((again[k] - run.steps[k].end).norm() <= 1e-12 * again[k].norm());  // its own rounding
    CHECK(run.steps[5].record.duration > run.steps[0].record.duration);
}

TEST_CASE("forward derivatives are those of runs with other coefficients and the same step lengths")
{
    // The smallest series are of 0.01 K, and the steps round to 1e-12 K: over a difference of 0.004, that is 3e-8.
    CHECK(largest_error(rods_with_break()) < 1e-7);
    CHECK(largest_error(bearings()) < 1e-7);
}

TEST_CASE("forward derivatives with oil circuits, their sumps, films that follow the temperature, and enclosed air")
{
    CHECK(largest_error(oiled_bearings(4000)) < 1e-6);
    CHECK(largest_error(oiled_bearings(0)) < 1e-6);
    CHECK(largest_error(warm_bearings()) < 1e-6);
    CHECK(largest_error(enclosed_bearings()) < 1e-6);
}

/// A way to change a problem by a small amount, which need not be linear in it.
using Change = std::function<void(HeatProblem&, double by)>;

/// Largest error of the forward derivatives along a change, and of the gradients against them.
void check_change(const Subject& subject, const Change& change)
{
    const auto base = subject.at(subject.values);
    const ProblemAt problem_at = [&](double by) {
        auto result = base;
        change(result, by);
        return result;
    };
    lumps::Quiet observer;
    const auto run = record_run(std::make_shared<const PreparedTerms>(subject.terms), base, 293, observer);
    const double small = 1e-4;
    const std::vector<Direction> along{direction_between(problem_at(-small), problem_at(small), 2 * small)};
    const auto outputs = outputs_of(subject.terms);
    const auto found = forward(run, along, outputs);
    const auto expected = differences(subject.terms, run, problem_at, 0.02);
    const auto rows = run.history.time.size();
    for (std::size_t o = 0; o < outputs.size(); ++o) {
        CHECK(error_of(found[0][o], run, outputs[o], expected) < 1e-6);
        for (const std::size_t row : {std::size_t{0}, rows / 2, rows - 1})
            CHECK(gradient(run, along, outputs[o], row)[0] == near(found[0][o][row], 1e-10));
    }
}

TEST_CASE("derivatives by anything else that a heat problem says")
{
    const auto oiled = oiled_bearings(4000);
    check_change(oiled, [](HeatProblem& p, double by) { p.oil[0].inlet_temperature += by; });
    check_change(oiled, [](HeatProblem& p, double by) { p.segments[0].oil_flow[0] += by; });
    check_change(oiled, [](HeatProblem& p, double by) { p.segments[2].oil_flow[1] *= 1 + by; });
    check_change(oiled, [](HeatProblem& p, double by) { p.oil[1].sump_loss += by; });
    for (const std::size_t i : {0, 1, 3})  // as loads that move from one bearing to another
        check_change(oiled, [i](HeatProblem& p, double by) { p.interfaces[i].heat_weight += by; });
    check_change(oiled, [](HeatProblem& p, double by) { p.oil[1].sump_start += by; });
    check_change(oiled, [](HeatProblem& p, double by) { p.segments[1].zoned_heat[0] *= 1 + by; });
    check_change(oiled, [](HeatProblem& p, double by) { p.segments[2].body_heat[0] = lumps::steady(25 + by); });
    check_change(oiled, [](HeatProblem& p, double by) { p.surfaces[2].flux = lumps::steady(50 * std::exp(by)); });
    check_change(oiled, [](HeatProblem& p, double by) {
        p.initial_temperature = [by](int part, const Vec3&) { return 293 + part * (1 + by); };
    });
    check_change(oiled_bearings(0), [](HeatProblem& p, double by) { p.oil[1].sump_loss += by; });
    check_change(bearings(), [](HeatProblem& p, double by) {  // as a speed that changes a law of friction heat
        p.segments[0].heat[0] = [by](double t) {
            return LawValue{(80 - 0.5 * (t - 293)) * std::exp(3 * by), -0.5 * std::exp(3 * by), true};
        };
    });
}

TEST_CASE("derivatives by films that follow the temperature, and by what belongs to enclosed air")
{
    const auto warm = warm_bearings();
    const auto by_factor = [](std::size_t surface) {
        return
            [surface](HeatProblem& p, double by) { p.surfaces[surface].laws = {subjects::natural_convection(1 + by)}; };
    };
    check_change(warm, by_factor(0));
    check_change(warm, by_factor(2));
    check_change(warm, [](HeatProblem& p, double by) { p.surfaces[0].emissivity *= 1 + by; });
    check_change(warm, [](HeatProblem& p, double by) {
        p.segments[0].ambient = [was = p.segments[0].ambient, by](double time) { return was(time) + by; };
    });
    const auto enclosed = enclosed_bearings();
    check_change(enclosed, [](HeatProblem& p, double by) { p.surfaces[2].coefficient += by; });
    check_change(enclosed, [](HeatProblem& p, double by) { p.enclosures[0].exchange += by; });
    check_change(enclosed, [](HeatProblem& p, double by) { p.enclosures[1].start += by; });
    check_change(enclosed,
                 [](HeatProblem& p, double by) { p.segments[0].enclosure_power[1] = lumps::steady(20 + by); });
    check_change(enclosed, [](HeatProblem& p, double by) {
        for (auto& segment : p.segments)
            segment.ambient = [was = segment.ambient, by](double time) { return was(time) + by; };
    });
}

TEST_CASE("derivatives along tables over time, whose dense points a step passes over")
{
    const auto wavy = [](double mean, double swing) {
        std::vector<double> times, values;
        for (int k = 0; k <= 200; ++k) {
            times.push_back(7.0 * k);
            values.push_back(mean + swing * std::sin(0.02 * k) + 0.1 * swing * std::cos(2.3 * k));
        }
        return TimeCourse(times, values);
    };
    auto oiled = oiled_bearings(4000);
    for (auto& segment : oiled.problem.segments) {
        segment.ambient = wavy(293, 3);
        segment.body_heat[0] = wavy(25, 10);
    }
    oiled.problem.surfaces[2].flux = wavy(50, 20);
    const auto steps = run_of(oiled).steps;
    double longest = 0;
    for (const auto& step : steps)
        longest = std::max(longest, step.record.duration);
    CHECK(longest > 14);  // over two points of the tables at least
    check_change(oiled, [&](HeatProblem& p, double by) { p.segments[0].body_heat[0] = wavy(25 + by, 10 - 3 * by); });
    check_change(oiled, [&](HeatProblem& p, double by) { p.segments[0].ambient = wavy(293 + by, 3 + by); });
    check_change(oiled, [&](HeatProblem& p, double by) { p.surfaces[2].flux = wavy(50, 20 + 30 * by); });
    check_change(oiled, [](HeatProblem& p, double by) { p.oil[1].sump_loss += by; });
    auto enclosed = enclosed_bearings();
    enclosed.problem.segments[0].enclosure_power[1] = wavy(20, 10);
    for (auto& segment : enclosed.problem.segments)
        segment.ambient = wavy(293, 3);
    check_change(enclosed, [](HeatProblem& p, double by) { p.enclosures[0].exchange += by; });
    check_change(enclosed,
                 [&](HeatProblem& p, double by) { p.segments[0].enclosure_power[1] = wavy(20 + by, 10 + by); });
}

TEST_CASE("a factor on a film that follows the temperature acts on its convection and its radiation to the ambient")
{
    const auto warm = warm_bearings();
    const auto run = run_of(warm);
    const ScalarLayout layout(warm.problem);
    const std::vector<Direction> along{{{{{layout.film(0), 1}}}, nullptr}};
    const Output probe{Output::Kind::probe, 2};
    const ProblemAt problem_at = [&](double by) {
        auto problem = warm.at(warm.values);
        problem.surfaces[0].laws = {subjects::natural_convection(1 + by)};
        problem.surfaces[0].emissivity *= 1 + by;
        return problem;
    };
    const auto expected = differences(warm.terms, run, problem_at, 0.02);
    CHECK(error_of(forward(run, along, {probe})[0][0], run, probe, expected) < 1e-6);
}

TEST_CASE("relative directions are those of factors on what a problem has, and of whole degrees")
{
    const auto subject = bearings();
    const auto run = run_of(subject);
    const auto base = run.problem;
    const std::vector<Output> outputs{{Output::Kind::probe, 0}, {Output::Kind::side_a, 1}};
    for (const auto& coefficient : subject.box) {
        CAPTURE(coefficient.name);
        const bool is_degree = coefficient.kind == FreeCoefficient::Kind::oil_temperature ||
                               coefficient.kind == FreeCoefficient::Kind::ambient;
        auto of_base = coefficient;
        for (std::size_t k = 0; k < of_base.base.size(); ++k) {
            if (of_base.kind == FreeCoefficient::Kind::film)
                of_base.base[k] = base.surfaces[of_base.members[k]].coefficient;
            if (of_base.kind == FreeCoefficient::Kind::oil)
                of_base.base[k] = base.interfaces[of_base.members[k]].oil;
        }
        const ProblemAt problem_at = [&](double by) {
            auto problem = base;
            if (coefficient.kind == FreeCoefficient::Kind::ambient) {  // set_values() lets it build up
                problem.segments[0].ambient = [was = base.segments[0].ambient, by](double t) { return was(t) + by; };
                problem.surfaces[1].ambient = [was = base.surfaces[1].ambient, by](double t) { return was(t) + by; };
            } else {
                set_values(problem, {of_base}, {is_degree ? by : 1 + by});
            }
            return problem;
        };
        const auto found = forward(run, {relative_direction(base, coefficient)}, outputs);
        const auto expected = differences(subject.terms, run, problem_at);
        for (std::size_t o = 0; o < outputs.size(); ++o)
            CHECK(error_of(found[0][o], run, outputs[o], expected) < 1e-7);
    }
}

TEST_CASE("the gradient of an objective over outputs and times is the weighted sum of their derivatives")
{
    const auto subject = rods_with_break();
    const auto run = run_of(subject);
    const auto along = directions_of(subject);
    const std::vector<Output> outputs{{Output::Kind::probe, 1}, {Output::Kind::observed, 0}};
    Eigen::MatrixXd weights(2, static_cast<Eigen::Index>(run.history.time.size()));
    for (Eigen::Index row = 0; row < weights.cols(); ++row)
        weights.col(row) << std::sin(row), 1e6 * std::cos(row);
    const auto found = forward(run, along, outputs);
    const auto back = gradient(run, along, outputs, weights);
    for (std::size_t k = 0; k < along.size(); ++k) {
        double expected = 0;
        for (std::size_t o = 0; o < outputs.size(); ++o)
            for (std::size_t row = 0; row < run.history.time.size(); ++row)
                expected += weights(static_cast<Eigen::Index>(o), static_cast<Eigen::Index>(row)) * found[k][o][row];
        CHECK(back[k] == near(expected, 1e-11));
    }
}

TEST_CASE("with heat by ring temperatures, derivatives agree as far as Newton's method goes")
{
    auto subject = bearings();
    subject.problem.segments[0].ring_heat = {[](double difference) { return 3 * difference; }, {}};
    CHECK(largest_error(subject) < 2.5e-3);  // it leaves 1e-5 of the heat, over a change of 0.4 %
}

TEST_CASE("gradients are the forward derivatives, at every kind of output and any row")
{
    CHECK(largest_mismatch(rods_with_break()) < 1e-12);
    CHECK(largest_mismatch(bearings()) < 1e-12);
    CHECK(largest_mismatch(oiled_bearings(4000)) < 1e-11);
    CHECK(largest_mismatch(oiled_bearings(0)) < 1e-11);
    CHECK(largest_mismatch(warm_bearings()) < 1e-11);
    CHECK(largest_mismatch(enclosed_bearings()) < 1e-11);
}

TEST_CASE("where a segment starts, derivatives are those of the end of the segment before")
{
    const auto run = run_of(rods_with_break());
    const auto along = directions_of(rods_with_break());
    const Output probe{Output::Kind::probe, 1};
    const auto found = forward(run, along, {probe});
    int starts = 0;
    for (std::size_t row = 1; row < run.history.time.size(); ++row)
        if (run.history.time[row] == run.history.time[row - 1]) {
            ++starts;
            for (std::size_t k = 0; k < along.size(); ++k)
                CHECK(found[k][0][row] == found[k][0][row - 1]);
            CHECK(found[5][0][row] != 0);
            CHECK(gradient(run, along, probe, row) == gradient(run, along, probe, row - 1));
        }
    CHECK(starts == 2);
}

TEST_CASE("one lump with one film: the derivative of the steps' own formula, and of the steady state")
{
    // T_k = T_end + R(z)^k (T_start - T_end) with z = -h A dt / C, and T_end = ambient + power / (h A)
    const double area = 0.5, base = 20, factor = 1.5, capacity = 1000, power = 100, ambient = 290, start = 300;
    const double dt = 40;
    Subject lump;
    lump.problem.body_heat = {{"heater", {0}, -1}};
    lump.problem.surfaces = {lumps::film(base)};
    lump.problem.segments = {lumps::segment(lump.problem, 4000, ambient)};
    lump.problem.segments[0].body_heat[0] = lumps::steady(power);
    lump.problem.fixed_step = dt;
    lump.problem.initial_temperature = [=](int, const Vec3&) { return start; };
    lump.terms = lumps::terms_of({{capacity}, {}, {}, {{0, area}}, {0}}, lump.problem);
    lump.terms.parts = lump.terms.uniform;
    lump.box = {{"film", FreeCoefficient::Kind::film, {0}, {base}, 0.2, 5}};
    lump.values = {factor};
    const auto found = forward(run_of(lump), directions_of(lump), {{Output::Kind::probe, 0}})[0][0];

    const double rise = power / (factor * base * area);
    const double u = -heat::diagonal * factor * base * area * dt / capacity;  // diagonal z
    const double ratio = heat::bdf_middle * (1 + u) / std::pow(1 - u, 2) - heat::bdf_now / (1 - u);
    const double ratio_by_u = heat::bdf_middle * (3 + u) / std::pow(1 - u, 3) - heat::bdf_now / std::pow(1 - u, 2);
    for (const int k : {1, 2, 7}) {
        const double by_end = -rise / factor * (1 - std::pow(ratio, k));
        const double by_ratio = k * std::pow(ratio, k - 1) * ratio_by_u * u / factor * (start - ambient - rise);
        CHECK(found[static_cast<std::size_t>(k)] == near(by_end + by_ratio, 1e-12));
    }
    CHECK(found.back() == near(-rise / factor, 1e-12));  // after 60 time constants
    CHECK(found.front() == 0);
}

TEST_CASE("outputs and rows that a run does not have are refused")
{
    const auto run = run_of(rods_with_break());
    CHECK_THROWS_AS(gradient(run, {}, {Output::Kind::probe, 4}, 1), InputError);
    CHECK_THROWS_AS(gradient(run, {}, {Output::Kind::side_b, 1}, 1), InputError);
    CHECK_THROWS_AS(gradient(run, {}, {Output::Kind::observed, 1}, 1), InputError);
    CHECK_THROWS_AS(gradient(run, {}, {}, run.history.time.size()), InputError);
    CHECK_THROWS_AS(gradient(run, {}, {{Output::Kind::probe, 0}}, Eigen::MatrixXd::Zero(1, 3)), InputError);
}
