#include "commands.hpp"
#include "deadpoint/casefile/files/read.hpp"
#include "deadpoint/casefile/files/write.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/full/run/run.hpp"
#include "deadpoint/full/sweep/sweep.hpp"
#include "deadpoint/io/resources.hpp"
#include "deadpoint/press/result/run_result.hpp"
#include "deadpoint/press/run/run_record.hpp"
#include "deadpoint/report/folder/read_result.hpp"
#include "deadpoint/report/run/run_files.hpp"
#include "deadpoint/report/sweep/sweep_files.hpp"
#include "deadpoint/report/tables/sweep_figures.hpp"
#include "deadpoint/report/tables/table.hpp"
#include "deadpoint/twin/map/point_observer.hpp"
#include "interrupt.hpp"
#include "options/case_options.hpp"
#include "options/result_options.hpp"
#include "output.hpp"
#include "ranks/ranks.hpp"
#include "sweep/sweep_study.hpp"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <iterator>
#include <memory>

using namespace deadpoint;
using report::ResultFolder;
namespace fs = std::filesystem;

namespace {

/// A point of the shipped press takes about this; only to tell a long study from a short one beforehand [s].
constexpr double seconds_per_cell = 2e-4;

std::vector<casefile::Case> read_cases(const std::vector<twin::SweepPoint>& points, const SweepOptions& options,
                                       const std::string& base)
{
    std::vector<casefile::Case> cases;
    for (const auto& point : points) {
        cases.push_back(casefile::read_case(base, point.overrides, options.files).value);
        auto& input = cases.back();
        input.output.fields = options.fields;
        full::scale_sizes(input, options.size_scale);
    }
    return cases;
}

fs::path folder_of(const SweepOptions& options, const twin::SweepPoint& point)
{
    return fs::path(options.folder) / "points" / point.name;
}

/// What an earlier call finished of this very case.
std::optional<press::RunRecord> finished(const fs::path& folder, const casefile::Case& input)
{
    if (!fs::exists(folder / "summary.json")) {
        return std::nullopt;
    }
    auto record = report::read_result(folder);
    return record.hash == casefile::case_hash(input) && !record.interrupted ? std::optional(std::move(record))
                                                                            : std::nullopt;
}

/// @param inputs  files of the user that no point replaces
full::PointAction action_of(const SweepOptions& options, const std::vector<fs::path>& inputs, Ranks& ranks)
{
    return [&options, &inputs, &ranks](const twin::SweepPoint& point, full::Press& press) {
        twin::PointObserver observer(ranks.console);
        const auto& input = press.input();
        const auto& machine = press.machine(observer);
        std::unique_ptr<ResultFolder> folder;
        const auto start = [&] {
            return std::make_unique<ResultFolder>(claim_folder(folder_of(options, point), ranks.console),
                                                  ResultFolder::IfExists::replace, inputs);
        };
        const auto path = start_folder(ranks.first, start, folder);
        full::RunOptions wanted;
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

/// Tells the points that were there already, and reads those that are done.
void collect(const SweepOptions& options, const std::vector<std::optional<press::RunRecord>>& kept,
             report::SweepResult& result)
{
    using State = twin::PointOutcome::State;
    for (std::size_t p = 0; p < result.points.size(); ++p) {
        if (kept[p]) {
            result.outcomes[p].state = State::kept;
        } else if (result.outcomes[p].state == State::done) {
            result.records[p] = report::read_result(folder_of(options, result.points[p]));
        }
    }
}

/// What each point computes.
std::vector<std::string> marks_of(const std::vector<casefile::Case>& cases)
{
    std::vector<std::string> marks;
    for (const auto& input : cases) {
        marks.push_back(casefile::case_hash(input));
    }
    return marks;
}

/// Makes tables and page of what shards have computed. @throws InputError that names missing points
int gather(const SweepOptions& options, const report::StudyFolder& folder, const std::vector<std::string>& marks,
           const std::vector<std::size_t>& pending, report::SweepResult& result, Console& console)
{
    const auto failures = folder.failures();
    result.outcomes.resize(result.points.size());
    std::vector<std::size_t> missing;
    for (const auto point : pending) {
        if (const auto failure = failures.find(marks[point]); failure != failures.end()) {
            result.outcomes[point] = {twin::PointOutcome::State::failed, failure->second, 0};
            console.warn(fmt::format("point {} failed: {}", result.points[point].name, failure->second));
        } else {
            missing.push_back(point);
        }
    }
    report::require_none_missing(result.points, missing);
    const auto kept = result.records;
    collect(options, kept, result);
    return finish(options, result, console);
}

/// The points that this call is for.
std::vector<std::size_t> own_points(const SweepOptions& options, const std::vector<casefile::Case>& cases)
{
    return twin::points_of(options.shard.value_or(twin::Shard{}), twin::order_by_model(cases));
}

int sweep(const SweepOptions& options, Ranks& ranks)
{
    if (!options.reduced.empty()) {
        return sweep_reduced(options, ranks);
    }
    auto& console = ranks.console;
    const auto study = read_sweep(options);
    report::SweepResult result;
    result.study = study;
    result.points = twin::sweep_points(study, twin::base_values(study));
    const auto cases = read_cases(result.points, options, study.base);
    if (ranks.first) {
        print_out("{}", report::sweep_plan_text(study, result.points));
    }
    const auto marks = marks_of(cases);
    std::optional<report::StudyFolder> folder;
    on_first_rank(ranks.first, [&] { folder.emplace(open_study(options, marks, console)); });
    const auto missing = find_pending(options, cases, result);
    if (options.gather) {
        return ranks.first ? gather(options, *folder, marks, missing, result, console) : 0;
    }
    const auto own = own_points(options, cases);
    if (ranks.first) {
        say_share(options, own.size(), cases.size());
    }
    std::vector<std::size_t> pending;
    std::ranges::set_intersection(own, missing, std::back_inserter(pending));
    if (missing.size() < result.points.size() && ranks.first) {
        print_out("{} of {} points are there already\n", result.points.size() - missing.size(), result.points.size());
    }
    flush_out();

    ranks.agree = false;
    full::SweepOptions how;
    how.workers = options.jobs;
    // Points side by side need no word between them; ranks are for points that are few, or too large for that.
    const bool side_by_side =
        options.jobs > 0 || full::most_alike(cases, pending) >= static_cast<std::size_t>(usable_cores());
    how.on_meshed = [&](const Machine& machine) {
        if (side_by_side) {
            ranks.spread_if_wanted();
        } else {
            ranks.spread([&] { return machine.cells.size(); });
        }
    };
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
    result.outcomes = full::run_points(result.points, cases, pending, how, action_of(options, inputs, ranks), console);
    console.finish();
    if (!ranks.first) {
        return console.cancelled() ? interrupted_exit_code : 0;
    }
    collect(options, kept, result);
    return options.shard ? finish_shard(options, own, result, *folder, console) : finish(options, result, console);
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
    auto* shard =
        command
            ->add_option_function<std::string>(
                "--shard", [options](const std::string& text) { options->shard = twin::read_shard(text); },
                "compute one share of the points, such as 2/4: other calls compute the others at the same time, "
                "into the same folder")
            ->type_name("I/N");
    command
        ->add_flag("--gather", options->gather, "compute nothing: make the tables and the page of what shards computed")
        ->excludes(shard);
    add_rank_options(*command, options->ranks);
    add_file_access(*command, options->files);
    add_console_options(*command, options->console);
    command->callback([options, &exit_code] {
        exit_code = on_ranks(options->ranks, options->console, [&](Ranks& ranks) { return sweep(*options, ranks); });
    });
}
