
#include "deadpoint/reduce/sensitivity/sensitivity.hpp"

#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/casefile/files/read.hpp"
#include "deadpoint/core/stopwatch.hpp"
#include "deadpoint/fem/algebra/session.hpp"
#include "deadpoint/observer.hpp"
#include "deadpoint/press/problem/run_laws.hpp"
#include "deadpoint/press/result/run_result.hpp"
#include "deadpoint/reduce/online/reduced_run.hpp"
#include "deadpoint/twin/model/reduced_press.hpp"
#include "deadpoint/twin/run/films_by_part.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <functional>
#include <limits>

// What derivatives of a reduced run cost: benchmark_sensitivity case.toml press.rom

namespace {

using namespace deadpoint;
using namespace deadpoint::reduce;

class Silent : public Observer {};

// The best of five, in milliseconds.
double best(const std::function<void()>& work)
{
    using Clock = std::chrono::steady_clock;
    double least = std::numeric_limits<double>::infinity();
    for (int k = 0; k < 5; ++k) {
        const auto start = Clock::now();
        work();
        least = std::min(least, std::chrono::duration<double, std::milli>(Clock::now() - start).count());
    }
    return least;
}

}  // namespace

int main(int count, char** arguments)
{
    fem::Session session(count, arguments);
    Silent observer;
    const auto input = casefile::read_case(arguments[1]).value;
    const auto press = twin::read_reduced(arguments[2]);
    press::RunResult unused;
    deadpoint::Stopwatch watch(observer);
    const auto problem =
        twin::split_by_part(press::run_laws(input, press.machine, press::Vibration::left_out, watch, unused, observer),
                            press.machine)
            .problem;
    auto fixed = problem;
    fixed.field_times.clear();
    std::vector<Output> sensors;
    for (std::size_t k = 0; k < press.terms->terms.geometry.layout.probes; ++k)
        sensors.push_back({Output::Kind::probe, k});
    const std::vector<double> neutral = [&] {
        std::vector<double> values;
        for (const auto& coefficient : press.box)
            values.push_back(coefficient.kind == FreeCoefficient::Kind::oil_temperature ||
                                     coefficient.kind == FreeCoefficient::Kind::ambient
                                 ? 0
                                 : 1);
        return values;
    }();
    const double of_run =
        best([&] { ReducedRun(press.terms, fixed, press.adjoints, press.reference).go({}, observer); });
    RecordedRun run;
    const double recorded = best([&] { run = record_run(press.terms, fixed, press.reference, observer); });
    std::vector<Direction> all;
    const double making = best([&] { all = directions(fixed, press.box, neutral); });
    std::vector<Direction> some;
    for (std::size_t k = 0; k < 12; ++k)
        some.push_back(all[k * (all.size() - 1) / 11]);
    const double by_some = best([&] { forward(run, some, sensors); });
    const double by_all = best([&] { forward(run, all, sensors); });
    const Eigen::MatrixXd weights = Eigen::MatrixXd::Ones(static_cast<Eigen::Index>(sensors.size()),
                                                          static_cast<Eigen::Index>(run.history.time.size()));
    const double of_gradient = best([&] { gradient(run, all, sensors, weights); });
    std::printf("%zu states, %zu steps, %zu sensors, %zu coefficients\n", press.states, run.steps.size(),
                sensors.size(), all.size());
    std::printf("%8.1f ms  run\n%8.1f ms  run, recorded\n%8.1f ms  directions of all coefficients\n", of_run, recorded,
                making);
    std::printf("%8.1f ms  forward, 12 coefficients\n%8.1f ms  forward, all coefficients\n%8.1f ms  gradient by all\n",
                by_some, by_all, of_gradient);
}
