#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/casefile/files/read.hpp"
#include "deadpoint/casefile/files/write.hpp"
#include "deadpoint/core/stopwatch.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/exchange/heat_causes.hpp"
#include "deadpoint/fem/algebra/session.hpp"
#include "deadpoint/full/model/model_parts.hpp"
#include "deadpoint/full/run/press.hpp"
#include "deadpoint/heat/run_state.hpp"
#include "deadpoint/io/binary_file.hpp"
#include "deadpoint/observer.hpp"
#include "deadpoint/press/drift/chain_model.hpp"
#include "deadpoint/press/result/run_result.hpp"
#include "deadpoint/reduce/certificate/certificate.hpp"
#include "deadpoint/reduce/certificate/residual_terms.hpp"
#include "deadpoint/reduce/offline/difference.hpp"
#include "deadpoint/reduce/offline/training.hpp"
#include "deadpoint/reduce/online/dense_terms.hpp"
#include "deadpoint/reduce/online/reduced_run.hpp"
#include "deadpoint/twin/model/certificate_file.hpp"
#include "deadpoint/twin/model/reduced_press.hpp"
#include "deadpoint/twin/run/films_by_part.hpp"
#include "deadpoint/twin/run/free_coefficients.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

// Compares a reduced press with full runs that its build never saw, a line for each:
//   benchmark_reduced_checks case.toml press.rom size_scale first count [cycles] [bounds] [keep=FOLDER]
// Coefficients are drawn from the box. With "cycles" the operation is one of work at other heat and rest in turn.
// With "keep" full runs are kept in a folder, and read from there for other reduced models of the same case, mesh and
// box. With "bounds" there are no full runs. Columns are then: number; certified bound [um]; processor time of the
// large model's run and of its certificate [s].
//
// Columns: number; largest errors after the first minute of the large and of the small model [K, um]; the small model
// to the large one [K, um]; error of the large model at the end [um] and its certified bound [um].

namespace {

using namespace deadpoint;

constexpr unsigned long long seed = 20260;
constexpr std::string_view kind = "deadpoint kept run 1\n";

class Silent : public Observer {};

// Work of 10 to 50 minutes at 0.3 to 1.5 times the heat, and rest of 5 to 30 minutes, in turn.
void make_cycle(HeatProblem& problem, reduce::Draws& draws)
{
    double left = 0;
    for (const auto& segment : problem.segments)
        left += segment.duration;
    const auto work = problem.segments.front();
    std::vector<HeatSegment> segments;
    for (bool works = true; left > 0; works = !works) {
        auto segment = work;
        segment.duration = std::min(left, 60 * (works ? 10 + 40 * draws.next() : 5 + 25 * draws.next()));
        const double level = works ? 0.3 + 1.2 * draws.next() : 0;
        for (std::size_t r = 0; r < segment.heat.size(); ++r)
            if (work.heat[r])
                segment.heat[r] = LawTable([law = work.heat[r], level](double at) {
                    const auto value = law(at);
                    return LawValue{level * value.value, level * value.slope, value.in_range};
                });
        for (auto& zoned : segment.zoned_heat)
            zoned *= level;
        left -= segment.duration;
        segments.push_back(std::move(segment));
    }
    problem.segments = std::move(segments);
}

/// The full model of a case, and its reduced ones.
class Checks {
public:
    Checks(const casefile::Case& input, const Machine& machine, const std::filesystem::path& file, bool with_full,
           Observer& observer)
        : parts_(machine, nullptr), small_(twin::read_reduced(file)),
          large_(twin::read_reduced(file.parent_path() / small_.large_file))
    {
        if (const auto certificate = twin::certificate_file(file); std::filesystem::exists(certificate))
            residual_ = twin::read_certificate(certificate, large_);
        deadpoint::Stopwatch watch(observer);
        press::RunResult unused;
        const auto problem = parts_.translate(input, watch, unused, observer);
        if (with_full)
            parts_.need_model(input, watch, observer);
        mark_ = casefile::case_hash(input) + " " + std::to_string(small_.unknowns);
        auto split = twin::split_by_part(problem, machine);
        split.problem.field_times.clear();
        nominal_ = twin::with_nominal_films(split.problem, input.machine.initial_temperature);
    }

    void keep_in(const std::filesystem::path& folder)
    {
        std::filesystem::create_directories(folder);
        folder_ = folder;
    }

    void check(int number, bool cycles)
    {
        const auto problem = drawn(number, cycles);
        const auto full = known_or_full_run(problem, (cycles ? "cycle-" : "set-") + std::to_string(number));
        const auto large = reduced_run(large_, problem), small = reduced_run(small_, problem);
        const auto of_large = off(large, full), of_small = off(small, full), estimate = off(small, large);
        const double end =
            std::abs(large.functionals[drift::gap].value.back() - full.functionals[drift::gap].value.back());
        std::printf("%4d %9.4f %9.5f %9.4f %9.5f %9.4f %9.5f %9.5f %9s\n", number, of_large.temperature,
                    1e6 * of_large.gap, of_small.temperature, 1e6 * of_small.gap, estimate.temperature,
                    1e6 * estimate.gap, 1e6 * end, bound(problem, large).c_str());
        std::fflush(stdout);
    }

    void time_bound(int number, bool cycles) const
    {
        const auto problem = drawn(number, cycles);
        const double start = seconds();
        const auto large = reduced_run(large_, problem);
        const double ran = seconds();
        const auto found = bound(problem, large);
        std::printf("%4d %9s %6.2f %6.2f\n", number, found.c_str(), ran - start, seconds() - ran);
        std::fflush(stdout);
    }

private:
    [[nodiscard]] static double seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }
    [[nodiscard]] HeatProblem drawn(int number, bool cycles) const
    {
        reduce::Draws draws(seed + static_cast<unsigned long long>(number));
        auto problem = reduce::drawn_problem({nominal_}, small_.box, draws);
        if (cycles)
            make_cycle(problem, draws);
        return problem;
    }
    [[nodiscard]] ThermalHistory known_or_full_run(const HeatProblem& problem, const std::string& name)
    {
        if (folder_.empty())
            return full_run(problem);
        const auto file = folder_ / name;
        ThermalHistory history;
        std::string mark;
        if (std::filesystem::exists(file)) {
            BinaryReader(file, kind, "remove it")(mark, history);
            if (mark != mark_)
                throw IoError("'" + file.string() +
                              "' is of another case or mesh\n  help: keep its runs in another folder");
            return history;
        }
        history = full_run(problem);
        std::ofstream out(file, std::ios::binary);
        BinaryWriter writer(out, kind);
        writer(mark_, history);
        writer.finish();
        return history;
    }
    [[nodiscard]] ThermalHistory full_run(const HeatProblem& problem)
    {
        Silent observer;
        parts_.model->assemble_heat(problem);
        const auto history =
            parts_.model->heat(parts_.adjoints, small_.reference, fem::Attribution(-1), observer, [](double) {}, {});
        parts_.model->release_heat();
        return history;
    }
    [[nodiscard]] static ThermalHistory reduced_run(const twin::ReducedPress& press, const HeatProblem& problem)
    {
        Silent observer;
        return reduce::ReducedRun(press.terms, problem, press.adjoints, press.reference).go({}, observer);
    }
    [[nodiscard]] static reduce::RunDifference off(const ThermalHistory& run, const ThermalHistory& other)
    {
        return reduce::difference(run, other, drift::gap);
    }
    [[nodiscard]] std::string bound(const HeatProblem& problem, const ThermalHistory& large) const
    {
        if (!residual_)
            return "-";
        const auto found = reduce::certify(large_.terms, *residual_, problem, large.time,
                                           {{{large_.terms->terms.geometry.layout.count() + drift::gap, 1}}});
        return found.refused.empty() ? std::to_string(1e6 * found.bounds[0]) : found.refused;
    }

    full::ModelParts parts_;
    twin::ReducedPress small_, large_;
    std::shared_ptr<const reduce::ResidualTerms> residual_;
    HeatProblem nominal_;
    std::string mark_;  ///< of the case and its mesh
    std::filesystem::path folder_;
};

}  // namespace

int main(int count, char** arguments)
{
    if (count < 6) {
        std::fprintf(
            stderr,
            "benchmark_reduced_checks case.toml press.rom size_scale first count [cycles] [bounds] [keep=FOLDER]\n");
        return 1;
    }
    const std::vector<std::string> more(arguments + 6, arguments + count);
    const bool cycles = std::ranges::find(more, "cycles") != more.end();
    const bool bounds = std::ranges::find(more, "bounds") != more.end();
    fem::Session session(count, arguments);
    Silent observer;
    full::Press press(casefile::read_case(arguments[1]).value, std::atof(arguments[3]));
    press.mesh(observer);
    Checks checks(press.input(), press.machine(observer), arguments[2], !bounds, observer);
    const int first = std::atoi(arguments[4]);
    for (const auto& word : more)
        if (word.starts_with("keep="))
            checks.keep_in(word.substr(5));
    for (int k = first; k < first + std::atoi(arguments[5]); ++k)
        if (bounds)
            checks.time_bound(k, cycles);
        else
            checks.check(k, cycles);
}
