#include "deadpoint/fem/model.hpp"
#include "deadpoint/full/refine/estimate.hpp"
#include "deadpoint/full/refine/refine.hpp"
#include "deadpoint/full/run/press.hpp"
#include "deadpoint/full/run/run.hpp"
#include "solved_case.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

// The estimate of the error against the true one, and what a refinement by it comes to.

using namespace verification;
using namespace deadpoint;

namespace {

Observer silent;

struct Estimated {
    double estimate;
    double error;  ///< true, largest of the probes at the end [K]
    press::RunResult result;
};

// A case whose probes have exact values at the end, by name [degC].
Estimated estimated(const casefile::Case& input, const std::function<double(const Vec3&)>& exact)
{
    const auto machine = full::prepare_machine(input, 1, silent);
    full::RunOptions options;
    options.kept_times = {full::estimate_times(input).back()};
    Estimated outcome{};
    options.on_finish = [&](const full::RunContext& run) {
        outcome.estimate = full::estimate_error(run, casefile::Accuracy::Of::rises).total;
    };
    outcome.result = full::run_case(input, machine, options, silent);
    std::size_t i = 0;
    for (const auto& [name, probe] : input.probes)
        outcome.error = std::max(outcome.error, std::abs(outcome.result.thermal.probes[i++].value.back() -
                                                         zero_celsius - exact(probe.position)));
    return outcome;
}

// Sets the cells along an edge of the cube and two probes inside it.
casefile::Case cube(int order, bool tetrahedra, double cells)
{
    auto input = read("cube", {"numerics.order=" + std::to_string(order),
                               std::string("parts.cube.tetrahedra=") + (tetrahedra ? "true" : "false")});
    input.numerics.size = 0.1 / cells;
    input.probes.clear();
    input.probes["middle"] = {"cube", {0.05, 0.05, 0.05}, ""};
    input.probes["outside"] = {"cube", {0.08, 0.07, 0.06}, ""};
    return input;
}

double exact_in_cube(const Vec3& x)
{
    return 20 + 20 * std::exp(std::sqrt(2.0) * 10 * x[0]) * std::sin(10 * x[1]) * std::sin(10 * x[2]);
}

// Largest difference of the probes of two runs over their time [K].
double difference(const press::RunResult& one, const press::RunResult& other)
{
    double largest = 0;
    for (std::size_t i = 0; i < one.thermal.probes.size(); ++i)
        for (int k = 1; k <= 20; ++k) {
            const double time = one.thermal.time.back() * k / 20;
            largest = std::max(largest, std::abs(interpolate(one.thermal.time, one.thermal.probes[i], time) -
                                                 interpolate(other.thermal.time, other.thermal.probes[i], time)));
        }
    return largest;
}

double size_of(const full::RefinedRun& run, const std::string& part) { return *run.press->input().parts.at(part).size; }

}  // namespace

TEST_CASE("estimate: probes in a field without sources")
{
    // The error at a point depends on where in its cell it lies, and unstructured tetrahedra scatter; the estimate is
    // to have its size.
    struct Target {
        bool tetrahedra;
        double coarse, fine;
    };
    for (const auto& target : {Target{false, 7, 13}, {true, 7, 13}})
        for (const double cells : {target.coarse, target.fine}) {
            const auto found = estimated(cube(1, target.tetrahedra, cells), exact_in_cube);
            MESSAGE(std::string(target.tetrahedra ? "tetrahedra" : "hexahedra")
                    << ": estimate " << found.estimate << " K, error " << found.error << " K, index "
                    << found.estimate / found.error);
            CHECK(found.estimate / found.error > 0.4);
            CHECK(found.estimate / found.error < 3);
        }
}

TEST_CASE("estimate: the mean temperature of a cube that is heated inside and cold outside")
{
    // T = sum over odd l, m, n of sines: Carslaw and Jaeger, sec. 6.2; its mean with the heat q [W/m3]
    const double edge = 0.1, heat = 1e5, conductivity = 45;
    double exact = 0;
    for (int l = 1; l < 60; l += 2)
        for (int m = 1; m < 60; m += 2)
            for (int n = 1; n < 60; n += 2)
                exact += 1 / (std::pow(l * m * n, 2) * (l * l + m * m + n * n));
    exact *= 512 * heat * edge * edge / (std::pow(std::numbers::pi, 8) * conductivity);

    struct Mean {
        double estimate, error;
    };
    const auto solve_mean = [&](int order, unsigned cells) {
        auto input = cube(order, false, cells);
        input.surfaces.at("outside").temperature_formula = "293.15";
        input.heat_sources["inside"].parts = {"cube"};
        input.heat_sources["inside"].power = casefile::Course{heat * edge * edge * edge, std::nullopt, std::nullopt};
        input.heat_sources["inside"].at_rest = true;
        const auto machine = full::prepare_machine(input, 1, silent);
        // one point per cell, or two along each edge, integrate elements of first and second order exactly
        std::vector<HeatProbe> points;
        const std::vector<double> places =
            order == 1 ? std::vector{0.5} : std::vector{0.5 - 0.5 / std::sqrt(3.0), 0.5 + 0.5 / std::sqrt(3.0)};
        std::vector<double> along;
        for (unsigned i = 0; i < cells; ++i)
            for (const double place : places)
                along.push_back(edge * (i + place) / cells);
        for (const double x : along)
            for (const double y : along)
                for (const double z : along)
                    points.push_back({"", 0, {x, y, z}});
        full::RunOptions options;
        options.kept_times = {full::estimate_times(input).back()};
        Mean outcome{};
        options.on_finish = [&](const full::RunContext& run) {
            const auto& [time, field] = run.fields.at(0);
            fem::Adjoint mean{"mean", std::vector<double>(field.owned.size(), 0.0)};
            for (const auto& point : points) {
                const auto one = run.model.probe_weights(point);
                for (std::size_t i = 0; i < mean.owned.size(); ++i)
                    mean.owned[i] += one.owned[i] / static_cast<double>(points.size());
            }
            const auto dual = run.model.heat_adjoints(run.problem, time, field, {mean});
            outcome = {run.model.conduction_errors(field, dual)[0][0], exact - run.model.apply(mean, field, 293.15)};
        };
        full::run_case(input, machine, options, silent);
        return outcome;
    };
    for (const int order : {1, 2}) {
        const auto coarse = solve_mean(order, order == 1 ? 6 : 3), fine = solve_mean(order, order == 1 ? 12 : 6);
        for (const auto& [estimate, error] : {coarse, fine}) {
            MESSAGE("order " << order << ": estimate " << estimate << " K, error " << error << " K of " << exact
                             << ", index " << estimate / error);
            // first order: exact as the mesh becomes fine. Second order: the fitted polynomials lack the highest terms
            // of the elements' own, so that the estimate is too large, by up to ten.
            CHECK(estimate / error > (order == 1 ? 0.8 : 1));
            CHECK(estimate / error < (order == 1 ? 1.25 : 12));
        }
        // Twice the order of the elements, but for second order, where the edges of the cube, at which the heat and the
        // cold faces meet, hold it below four.
        const double falls = std::log2(coarse.error / fine.error);
        MESSAGE("falls with order " << falls);
        CHECK(falls > (order == 1 ? 1.85 : 3));
    }
}

TEST_CASE("refinement goes where the field is steep, and keeps its promise")
{
    const auto input = read("hot-patch");
    const auto run = full::run_to_accuracy(input, 1, {}, silent);
    REQUIRE(run.result.accuracy);
    const auto& report = *run.result.accuracy;
    CHECK(report.reached);
    REQUIRE(report.rounds.size() > 1);
    CHECK(*report.rounds.back().change <= 0.1);
    CHECK(report.rounds.back().estimate + report.time_change <= 0.1);
    auto fine = run.press->input();  // 24 000 cells, and time steps half as long
    for (auto& [name, part] : fine.parts)
        part.size = 0.005;
    fine.numerics.time_tolerance /= 8;
    fine.numerics.max_step /= 2;
    const auto machine = full::prepare_machine(fine, 1, silent);
    const auto reference = full::run_case(fine, machine, {}, silent);
    MESSAGE("true error " << difference(run.result, reference) << " K");
    CHECK(difference(run.result, reference) < 0.1);
    CHECK(report.rounds.front().worst_part == "hot");
    CHECK(size_of(run, "hot") < size_of(run, "middle"));
    CHECK(size_of(run, "hot") < size_of(run, "far"));
}
