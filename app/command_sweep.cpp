#include "commands.hpp"
#include "deadpoint/casefile/files/read.hpp"
#include "deadpoint/casefile/files/study_file.hpp"
#include "deadpoint/casefile/files/write.hpp"
#include "deadpoint/core/hash.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/fem/space/session.hpp"
#include "deadpoint/io/read_file.hpp"
#include "deadpoint/report/charts/sweep_charts.hpp"
#include "deadpoint/report/charts/sweep_figures.hpp"
#include "deadpoint/report/files/run_files.hpp"
#include "deadpoint/report/files/sweep_files.hpp"
#include "deadpoint/report/folder/point_table.hpp"
#include "deadpoint/report/folder/read_result.hpp"
#include "deadpoint/report/folder/record_of_run.hpp"
#include "deadpoint/report/folder/result_files.hpp"
#include "deadpoint/report/folder/table_style.hpp"
#include "deadpoint/report/page/sweep_page.hpp"
#include "deadpoint/report/text/plan_text.hpp"
#include "deadpoint/report/text/table.hpp"
#include "deadpoint/study/pipeline/run.hpp"
#include "deadpoint/study/pipeline/run_record.hpp"
#include "deadpoint/study/reduce/reduced_press.hpp"
#include "deadpoint/study/reduce/reduced_sweep.hpp"
#include "deadpoint/study/result/run_result.hpp"
#include "deadpoint/study/sweep/sweep.hpp"
#include "interrupt.hpp"
#include "options/case_options.hpp"
#include "options/result_options.hpp"
#include "output.hpp"
#include "ranks.hpp"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <map>
#include <memory>
#include <set>
#include <thread>

using namespace deadpoint;
using report::ResultFolder;
namespace fs = std::filesystem;

namespace {

/// A point of the shipped press takes about this; only to tell a long study from a short one beforehand [s].
constexpr double seconds_per_cell = 2e-4;

struct SweepOptions {
    std::string study;
    std::string folder;
    double size_scale = 1;
    int jobs = 0;
    bool fields = false;
    std::string reduced;  ///< file of a reduced model to compute with
    casefile::FileAccess files = casefile::FileAccess::below;
    CsvStyle tables = CsvStyle::comments;
    Console::Options console;
};

/// Keeps the warnings of one point for its files; says nothing.
class PointObserver : public Observer {
public:
    explicit PointObserver(const Observer& study) : study_(study) {}
    void warn(std::string_view text) override { warnings.emplace_back(text); }
    [[nodiscard]] bool cancelled() const override { return study_.cancelled(); }
    std::vector<std::string> warnings;

private:
    const Observer& study_;
};

std::vector<casefile::Case> read_cases(const std::vector<study::SweepPoint>& points, const SweepOptions& options,
                                       const std::string& base)
{
    std::vector<casefile::Case> cases;
    for (const auto& point : points) {
        cases.push_back(casefile::read_case(base, point.overrides, options.files).value);
        auto& input = cases.back();
        input.output.fields = options.fields;
        study::scale_sizes(input, options.size_scale);
    }
    return cases;
}

study::SweepStudy read_sweep(const SweepOptions& options)
{
    const auto file = casefile::read_study(options.study, options.files);
    if (file.sets.empty()) {
        throw InputError(fmt::format("'{}' has no sets of runs\n  help: add [[sets]] (docs/study-file.md), or use "
                                     "'deadpoint sensitivity'",
                                     options.study));
    }
    return study::translate_study(file);
}

fs::path folder_of(const SweepOptions& options, const study::SweepPoint& point)
{
    return fs::path(options.folder) / "points" / point.name;
}

/// What an earlier call finished of this very case.
std::optional<study::RunRecord> finished(const fs::path& folder, const casefile::Case& input)
{
    if (!fs::exists(folder / "summary.json")) {
        return std::nullopt;
    }
    auto record = report::read_result(folder);
    return record.hash == casefile::case_hash(input) && !record.interrupted ? std::optional(std::move(record))
                                                                            : std::nullopt;
}

/// Makes the folder of a study, or sees that it is one. @throws IoError
void make_or_reuse(const fs::path& folder)
{
    if (!fs::exists(folder) || (fs::is_directory(folder) && fs::is_empty(folder))) {
        fs::create_directories(folder / "points");
        report::write_manifest(folder);
    } else if (!fs::is_directory(folder / "points") || !report::is_whole(folder)) {
        throw IoError(fmt::format(
            "'{}' exists already and holds no study\n  help: name a new folder, or that of a study to continue",
            folder.string()));
    }
}

/// @param inputs  files of the user that no point replaces
study::PointAction action_of(const SweepOptions& options, const std::vector<fs::path>& inputs, const OnRanks& ranks)
{
    return [&options, &inputs, &ranks](const study::SweepPoint& point, study::Press& press) {
        PointObserver observer(ranks.console);
        const auto& input = press.input();
        const auto& machine = press.machine(observer);
        for (const auto& warning : report::plan_warnings(input, machine)) {
            observer.warn(warning);
        }
        std::unique_ptr<ResultFolder> folder;
        const auto start = [&] {
            return std::make_unique<ResultFolder>(claim_folder(folder_of(options, point), ranks.console),
                                                  ResultFolder::IfExists::replace, inputs);
        };
        const auto path = start_folder(ranks.first, start, folder);
        study::RunOptions wanted;
        wanted.field_folder = options.fields ? path : std::string{};
        const auto result = press.run(wanted, observer);
        if (!result.thermal.interrupted && folder) {
            report::write_run_files(folder->path(), input, machine, result, observer.warnings);
            commit(*folder, options.tables, ranks.console);
        }
    };
}

/// Reads the points that are there already. @return the indices of the others
std::vector<std::size_t> find_pending(const SweepOptions& options, const std::vector<casefile::Case>& cases,
                                      report::SweepResult& result)
{
    result.records.resize(result.points.size());
    std::vector<std::size_t> pending;
    for (std::size_t p = 0; p < result.points.size(); ++p) {
        result.records[p] = finished(folder_of(options, result.points[p]), cases[p]);
        if (!result.records[p]) {
            pending.push_back(p);
        }
    }
    return pending;
}

/// Tells the points that were there already and reads those that are done. @return whether one failed
bool collect(const SweepOptions& options, const std::vector<std::optional<study::RunRecord>>& kept,
             report::SweepResult& result)
{
    using State = study::PointOutcome::State;
    bool failed = false;
    for (std::size_t p = 0; p < result.points.size(); ++p) {
        if (kept[p]) {
            result.outcomes[p].state = State::kept;
        } else if (result.outcomes[p].state == State::done) {
            result.records[p] = report::read_result(folder_of(options, result.points[p]));
        }
        failed = failed || result.outcomes[p].state == State::failed;
    }
    return failed;
}

/// Tables, page and text of a study. @return the exit code
int finish(const SweepOptions& options, const report::SweepResult& result, bool failed, Console& console)
{
    report::write_sweep_files(options.folder, result, console.warnings());
    const auto page = fs::path(options.folder) / "report.html";
    report::write_sweep_report(page, options.folder);
    report::style_tables(options.folder, options.tables);
    print_out("{}\nresults{} are in {}\nthe page is {}\n", report::sweep_text(result),
              console.cancelled() ? " so far (the same command continues)" : "", options.folder, page.string());
    if (console.cancelled()) {
        return interrupted_exit_code;
    }
    return failed ? static_cast<int>(ErrorKind::convergence) : 0;
}

/// A mark of all that the points of a study on a reduced model have in common.
std::string mark_of_study(const SweepOptions& options, const study::SweepStudy& study)
{
    const auto base = casefile::read_case(study.base, study.overrides, options.files).value;
    return stable_hash(read_file(options.reduced, largest_result).value_or("") + casefile::case_hash(base));
}

/// A mark of what a point sets.
std::string mark_of(const study::SweepPoint& point) { return stable_hash(fmt::format("{}", point.overrides)); }

/// Takes over what an earlier call finished, but for points whose course over time is drawn. @return the others
std::vector<std::size_t> take_kept(std::vector<report::PointRow> rows, const std::set<std::size_t>& drawn,
                                   report::SweepResult& result)
{
    std::map<std::string, report::PointRow*> known;
    for (auto& row : rows) {
        known[row.mark] = &row;
    }
    std::vector<std::size_t> pending;
    for (std::size_t p = 0; p < result.points.size(); ++p) {
        const auto found = known.find(mark_of(result.points[p]));
        if (found == known.end() || !found->second->record || drawn.contains(p)) {
            pending.push_back(p);
            continue;
        }
        result.records[p] = std::move(found->second->record);
        result.outcomes[p] = {study::PointOutcome::State::kept, {}, found->second->outcome.seconds};
    }
    return pending;
}

report::PointRow row_of(const report::SweepResult& result, std::size_t point)
{
    auto outcome = result.outcomes[point];
    if (outcome.state == study::PointOutcome::State::kept) {
        outcome.state = study::PointOutcome::State::done;
    }
    return {result.points[point].name, mark_of(result.points[point]), std::move(outcome), result.records[point]};
}

/// Those of all points that ended so far.
std::vector<report::PointRow> rows_of(const report::SweepResult& result)
{
    std::vector<report::PointRow> rows;
    for (std::size_t p = 0; p < result.points.size(); ++p) {
        if (result.outcomes[p].state != study::PointOutcome::State::left) {
            rows.push_back(row_of(result, p));
        }
    }
    return rows;
}

/// Runs the points that are not there yet. Their numbers stand in the tables only.
void run_on_model(const SweepOptions& options, const study::ReducedPress& press, report::SweepResult& result,
                  Console& console)
{
    const auto file = fs::path(options.folder) / "points.csv";
    const auto mark = mark_of_study(options, result.study);
    const auto drawn = report::points_over_time(result);
    const auto pending = take_kept(report::read_points(file, mark), drawn, result);
    const auto known = rows_of(result);
    report::PointTable table(file, mark, known);
    if (pending.size() < result.points.size()) {
        print_out("{} of {} points are there already\n", result.points.size() - pending.size(), result.points.size());
    }
    flush_out();
    study::ReducedSweep how;
    how.threads = options.jobs > 0 ? options.jobs : static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
    how.read = [&](const study::SweepPoint& point) {
        return casefile::read_case(result.study.base, point.overrides, options.files).value;
    };
    how.record = [&](std::size_t point, const casefile::Case& input, const study::RunResult& run) {
        const auto record = report::record_of(input, run);
        return drawn.contains(point) ? record : report::brief(record);
    };
    how.take = [&](std::size_t point, study::EndedPoint ended) {
        result.outcomes[point] = std::move(ended.outcome);
        result.records[point] = std::move(ended.record);
        table.add(row_of(result, point));
    };
    study::run_points_reduced(result.points, pending, press, how, console);
    if (!known.empty()) {
        table.replace(rows_of(result));
    }
}

/// A study without meshes.
int sweep_reduced(const SweepOptions& options, const OnRanks& ranks)
{
    if (options.size_scale != 1 || options.fields) {
        throw InputError("--reduced computes without a mesh\n  help: leave out --size and --fields");
    }
    if (!ranks.first) {
        return 0;
    }
    auto& console = ranks.console;
    const auto press = study::read_reduced(options.reduced);
    report::SweepResult result;
    result.study = read_sweep(options);
    result.points = study::sweep_points(result.study, study::base_values(result.study));
    result.records.resize(result.points.size());
    result.outcomes.resize(result.points.size());
    result.reduced_model = fs::path(options.reduced).filename().string();
    print_out("{}", report::sweep_plan_text(result.study, result.points));
    const auto claim = claim_folder(options.folder, console);
    make_or_reuse(options.folder);
    run_on_model(options, press, result, console);
    console.finish();
    const bool failed = std::ranges::any_of(result.outcomes, [](const study::PointOutcome& outcome) {
        return outcome.state == study::PointOutcome::State::failed;
    });
    return finish(options, result, failed, console);
}

int sweep(const SweepOptions& options, const OnRanks& ranks)
{
    if (!options.reduced.empty()) {
        return sweep_reduced(options, ranks);
    }
    auto& console = ranks.console;
    const auto study = read_sweep(options);
    report::SweepResult result;
    result.study = study;
    result.points = study::sweep_points(study, study::base_values(study));
    const auto cases = read_cases(result.points, options, study.base);
    if (ranks.first) {
        print_out("{}", report::sweep_plan_text(study, result.points));
    }
    std::optional<report::FolderClaim> claim;
    on_first_rank(ranks.first, [&] {
        claim.emplace(claim_folder(options.folder, console));
        make_or_reuse(options.folder);
    });
    const auto pending = find_pending(options, cases, result);
    if (pending.size() < result.points.size() && ranks.first) {
        print_out("{} of {} points are there already\n", result.points.size() - pending.size(), result.points.size());
    }
    flush_out();

    ranks.agree = false;
    study::SweepOptions how;
    how.workers = options.jobs;
    how.on_prepared = [&](const Machine& machine, std::size_t points, int workers) {
        if (ranks.first) {
            const double seconds = seconds_per_cell * static_cast<double>(machine.cells.size() * points) / workers;
            print_out("{} points of {} cells, {} at a time: about {}\n", points, machine.cells.size(), workers,
                      report::duration_text(seconds));
            flush_out();
        }
    };
    const auto kept = result.records;
    const std::vector<fs::path> inputs{options.study, study.base};
    result.outcomes = study::run_points(result.points, cases, pending, how, action_of(options, inputs, ranks), console);
    console.finish();
    if (!ranks.first) {
        return console.cancelled() ? interrupted_exit_code : 0;
    }
    const bool failed = collect(options, kept, result);
    return finish(options, result, failed, console);
}

}  // namespace

void add_sweep(CLI::App& app, int& exit_code)
{
    auto* command = app.add_subcommand("sweep", "compute a study of many cases, or continue one that was stopped");
    const auto options = std::make_shared<SweepOptions>();
    command->add_option("study", options->study, "the study file (TOML)")->required()->type_name("STUDY");
    command->add_option("-o,--output", options->folder, "the folder to write into, new or of the same study")
        ->required()
        ->type_name("DIR");
    command->add_option("--size", options->size_scale, "scales all cell sizes; 2 is coarse and quick")
        ->check(CLI::PositiveNumber);
    command
        ->add_option("-j,--jobs", options->jobs,
                     "number of points at a time; default: as many as cores and memory allow")
        ->check(CLI::Range(1, 1024));
    add_table_option(*command, options->tables);
    command->add_flag("--fields", options->fields, "write the fields of every point");
    command
        ->add_option("--reduced", options->reduced,
                     "compute with a reduced model; the points then have no folders of their own")
        ->type_name("FILE");
    add_file_access(*command, options->files);
    add_console_options(*command, options->console);
    command->callback([options, &exit_code] {
        exit_code = on_ranks(options->console, [&](const OnRanks& ranks) { return sweep(*options, ranks); });
    });
}
