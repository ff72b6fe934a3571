#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/casefile/files/case_base.hpp"
#include "deadpoint/casefile/files/read.hpp"
#include "deadpoint/casefile/files/write.hpp"
#include "deadpoint/casefile/syntax/case_bytes.hpp"
#include "deadpoint/core/stopwatch.hpp"
#include "deadpoint/exchange/heat_causes.hpp"
#include "deadpoint/observer.hpp"
#include "deadpoint/press/drift/chain_model.hpp"
#include "deadpoint/press/loads/loads.hpp"
#include "deadpoint/press/loads/loads_cache.hpp"
#include "deadpoint/press/problem/run_laws.hpp"
#include "deadpoint/press/result/loads_result.hpp"
#include "deadpoint/press/result/run_result.hpp"
#include "deadpoint/reduce/certificate/certificate.hpp"
#include "deadpoint/reduce/certificate/residual_terms.hpp"
#include "deadpoint/reduce/online/dense_terms.hpp"
#include "deadpoint/reduce/online/reduced_run.hpp"
#include "deadpoint/report/folder/point_table.hpp"
#include "deadpoint/report/folder/record_of_run.hpp"
#include "deadpoint/twin/model/certificate_file.hpp"
#include "deadpoint/twin/model/reduced_press.hpp"
#include "deadpoint/twin/run/films_by_part.hpp"
#include "deadpoint/twin/run/run_reduced.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <memory>
#include <numeric>
#include <string>
#include <vector>

// How long the stages of a run on a reduced press take: benchmark_reduced_times case.toml press.rom [count
// [loads|runs|points|causes|certificate]] Prints the fastest and the median of `count` calls [ms].

namespace {

using namespace deadpoint;

class Silent : public Observer {};

void measure(const char* what, int count, const std::function<void(int)>& work)
{
    using Clock = std::chrono::steady_clock;
    std::vector<double> times;
    for (int k = 0; k < count; ++k) {
        const auto start = Clock::now();
        work(k);
        times.push_back(std::chrono::duration<double, std::milli>(Clock::now() - start).count());
    }
    std::ranges::sort(times);
    std::printf("%8.2f %8.2f  %s\n", times.front(), times[times.size() / 2], what);
    std::fflush(stdout);
}

class Stages {
public:
    Stages(const std::string& file, const std::filesystem::path& rom, int count)
        : file_(file), case_(casefile::read_case(file).value), press_(twin::read_reduced(rom)), rom_(rom), count_(count)
    {
        problem_ = split(heat_problem(case_, nullptr));
    }

    void loads()
    {
        measure("loads, nothing known", count_,
                [&](int) { press::compute_loads(case_, &press_.machine, 0, press::Vibration::left_out); });
        press::LoadsCache cache;
        measure("loads at another speed and force each", count_,
                [&](int k) { cache.get(at(k), &press_.machine, 0, press::Vibration::left_out); });
        cache.get(at(count_), &press_.machine, 0, press::Vibration::left_out);
        measure("laws and heat problem, loads known", count_, [&](int) { heat_problem(at(count_), &cache); });
    }

    void runs()
    {
        measure("run of a heat problem, another conductance each", count_, [&](int k) {
            auto problem = problem_;
            for (auto& segment : problem.segments)
                for (auto& law : segment.interfaces)
                    law.film_a *= 1 + 1e-12 * k;
            for (auto& law : problem.interfaces)
                law.film_a *= 1 + 1e-12 * k;
            run(problem);
        });
        measure("run of a heat problem, coefficients as before", count_, [&](int) { run(problem_); });
        twin::SharedParts shared;
        measure("run of a case for a study, another speed and force each", count_, [&](int k) {
            twin::run_reduced(at(k), press_, {}, twin::ReducedDetail::figures, observer_, nullptr, &shared);
        });
    }

    // A point of a study, with other coefficients each.
    void points()
    {
        const casefile::CaseBase base(file_, casefile::FileAccess::below);
        const auto settings = [](int k) {
            return std::vector<std::string>{"oil.crank_bearings=" + std::to_string(300 + 0.1 * k) + " W/m^2/K",
                                            "friction.crank_pin.scale=" + std::to_string(1 + 1e-3 * k)};
        };
        casefile::CaseTexts texts;
        twin::SharedParts shared;
        const auto point = base.with(settings(0));
        texts.hash(point);
        press::RunResult run;
        measure("point: case", count_, [&](int k) { (void)base.with(settings(k)); });
        measure("point: hash of its text", count_, [&](int k) { texts.hash(base.with(settings(k))); });
        measure("point: its fixed part as bytes", count_, [&](int) { casefile::case_bytes(twin::fixed_case(point)); });
        measure("point: known loads", count_,
                [&](int) { shared.loads.get(point, &press_.machine, 0, press::Vibration::left_out); });
        measure("point: laws and heat problem", count_, [&](int) { heat_problem(point, &shared.loads); });
        const auto problem = heat_problem(point, &shared.loads);
        measure("point: heat problem by part", count_, [&](int) { (void)split(problem); });
        measure("point: time steps", count_, [&](int) { this->run(problem_); });
        measure("point: run with all of these but case and text", count_, [&](int k) {
            run = twin::run_reduced(base.with(settings(k)), press_, {}, twin::ReducedDetail::figures, observer_,
                                    nullptr, &shared);
        });
        measure("point: record", count_, [&](int) { (void)report::brief(report::record_of(point, "hash", run)); });
    }

    void causes()
    {
        const reduce::States weights = press_.terms->terms.observed.row(drift::gap).transpose();
        HeatCauses found;
        double gap = 0;
        measure("run and causes of E_SW at its end", count_, [&](int) {
            reduce::ReducedRun reduced(press_.terms, problem_, press_.adjoints, press_.reference);
            const auto& history = reduced.go({}, observer_);
            gap = history.functionals[drift::gap].value.back();
            found = reduced.causes(weights, history.time.size() - 1);
        });
        std::printf("                   causes less E_SW %.2g of %.4g um\n", 1e6 * (sum(found) - gap), 1e6 * gap);
    }

    void certificate()
    {
        const auto file = twin::certificate_file(rom_);
        if (!std::filesystem::exists(file))
            return;
        twin::ReducedPress large;
        measure("reading the large model", 3,
                [&](int) { large = twin::read_reduced(rom_.parent_path() / press_.large_file); });
        std::shared_ptr<const reduce::ResidualTerms> residual;
        measure("reading the certificate", 3, [&](int) { residual = twin::read_certificate(file, large); });
        ThermalHistory history;
        measure("run of the large model", 3, [&](int) {
            history = reduce::ReducedRun(large.terms, problem_, large.adjoints, large.reference).go({}, observer_);
        });
        const auto& layout = large.terms->terms.geometry.layout;
        measure("certificate of E_SW", 3, [&](int) {
            reduce::certify(large.terms, *residual, problem_, history.time, {{{layout.count() + drift::gap, 1}}});
        });
    }

private:
    [[nodiscard]] casefile::Case at(int k) const
    {
        auto result = case_;
        for (auto& segment : result.operation) {
            segment.speed *= 1 - 0.002 * k;
            segment.force *= 1 + 0.001 * k;
        }
        return result;
    }
    HeatProblem heat_problem(const casefile::Case& input, press::LoadsCache* cache)
    {
        deadpoint::Stopwatch watch(observer_);
        press::RunResult unused;
        return press::run_laws(input, press_.machine, press::Vibration::left_out, watch, unused, observer_, cache);
    }
    [[nodiscard]] HeatProblem split(const HeatProblem& problem) const
    {
        auto result = twin::split_by_part(problem, press_.machine).problem;
        result.field_times.clear();
        return result;
    }
    void run(const HeatProblem& problem)
    {
        reduce::ReducedRun(press_.terms, problem, press_.adjoints, press_.reference).go({}, observer_);
    }
    static double sum(const HeatCauses& causes)
    {
        double result = causes.start;
        for (const auto* list : {&causes.friction, &causes.oil, &causes.surfaces, &causes.body_heat})
            result = std::accumulate(list->begin(), list->end(), result);
        return result;
    }

    Silent observer_;
    std::string file_;
    casefile::Case case_;
    twin::ReducedPress press_;
    std::filesystem::path rom_;
    int count_;
    HeatProblem problem_;
};

}  // namespace

int main(int count, char** arguments)
{
    if (count < 3) {
        std::fprintf(stderr,
                     "benchmark_reduced_times case.toml press.rom [count [loads|runs|points|causes|certificate]]\n");
        return 1;
    }
    Stages stages(arguments[1], arguments[2], count > 3 ? std::atoi(arguments[3]) : 21);
    const std::string only = count > 4 ? arguments[4] : "";
    if (only.empty() || only == "loads")
        stages.loads();
    if (only.empty() || only == "runs")
        stages.runs();
    if (only.empty() || only == "points")
        stages.points();
    if (only.empty() || only == "causes")
        stages.causes();
    if (only.empty() || only == "certificate")
        stages.certificate();
}
