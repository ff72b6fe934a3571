#include "deadpoint/reduce/online/sensitivity.hpp"

#include "deadpoint/error.hpp"
#include "subjects.hpp"

#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>
#include <string>

using doctest::Approx;
using namespace deadpoint;
using namespace deadpoint::reduce;
using subjects::bearings;
using subjects::rods_with_break;
using subjects::Subject;

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
    stepper.now().temperature = steps.front().start;
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

/// Central differences of fourth order of the states by a coefficient, at the ends of the steps.
std::vector<Eigen::VectorXd> differences(const Subject& subject, const RecordedRun& run, std::size_t coefficient)
{
    const double step = 0.004;
    const auto with = [&](double change) {
        auto values = subject.values;
        values[coefficient] += change;
        return repeated(subject.terms, subject.at(values), run.steps);
    };
    const auto more = with(step), less = with(-step), much_more = with(2 * step), much_less = with(-2 * step);
    std::vector<Eigen::VectorXd> result;
    for (std::size_t k = 0; k < more.size(); ++k)
        result.emplace_back((8 * (more[k] - less[k]) - (much_more[k] - much_less[k])) / (12 * step));
    return result;
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
        const auto expected = differences(subject, run, k);
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
        CHECK(found[static_cast<std::size_t>(k)] == Approx(by_end + by_ratio).epsilon(1e-12));
    }
    CHECK(found.back() == Approx(-rise / factor).epsilon(1e-12));  // after 60 time constants
    CHECK(found.front() == 0);
}

TEST_CASE("sensitivities name what they do not take")
{
    const auto message = [](const std::function<void(HeatProblem&)>& change) -> std::string {
        auto subject = rods_with_break();
        change(subject.problem);
        try {
            lumps::Quiet observer;
            record_run(std::make_shared<const PreparedTerms>(subject.terms), subject.problem, 293, observer);
        } catch (const InputError& error) {
            return error.what();
        }
        return "none";
    };
    CHECK(message([](HeatProblem&) {}) == "none");
    CHECK(message([](HeatProblem& p) {
              p.oil.push_back({"main", {{0}}});
          }).find("oil circuit 'main'") != std::string::npos);
    CHECK(message([](HeatProblem& p) {
              p.enclosures.push_back({"cabinet", 1, 1, 293});
          }).find("enclosed air 'cabinet'") != std::string::npos);
    CHECK(message([](HeatProblem& p) { p.surfaces[1].emissivity = 0.9; }).find("surface 'film'") != std::string::npos);
    CHECK(message([](HeatProblem& p) { p.sources[0].share = 0; }).find("source 'row'") != std::string::npos);
    const auto run = run_of(rods_with_break());
    CHECK_THROWS_AS(gradient(run, {}, {Output::Kind::probe, 4}, 1), InputError);
    CHECK_THROWS_AS(gradient(run, {}, {Output::Kind::side_b, 1}, 1), InputError);
    CHECK_THROWS_AS(gradient(run, {}, {Output::Kind::observed, 1}, 1), InputError);
    CHECK_THROWS_AS(gradient(run, {}, {}, run.history.time.size()), InputError);
}
