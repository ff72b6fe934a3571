#include "deadpoint/casefile/files/case_base.hpp"
#include "deadpoint/casefile/files/read.hpp"
#include "deadpoint/casefile/files/write.hpp"
#include "deadpoint/core/hash.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/io/read_file.hpp"
#include "deadpoint/io/resources.hpp"
#include "deadpoint/press/result/run_result.hpp"
#include "deadpoint/report/folder/point_table.hpp"
#include "deadpoint/report/folder/record_of_run.hpp"
#include "deadpoint/report/sweep/sweep_charts.hpp"
#include "deadpoint/report/sweep/sweep_files.hpp"
#include "deadpoint/report/tables/sweep_figures.hpp"
#include "deadpoint/twin/map/reduced_sweep.hpp"
#include "deadpoint/twin/model/reduced_press.hpp"
#include "output.hpp"
#include "sweep/sweep_study.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <iterator>
#include <map>
#include <numeric>
#include <set>

using namespace deadpoint;
namespace fs = std::filesystem;

namespace {

/// A mark of all that the points of a study on a reduced model have in common.
std::string mark_of_study(const SweepOptions& options, const twin::SweepStudy& study)
{
    const auto base = casefile::read_case(study.base, study.overrides, options.files).value;
    return stable_hash(read_file(options.reduced, largest_result).value_or("") + casefile::case_hash(base));
}

/// A mark of what a point sets.
std::string mark_of(const twin::SweepPoint& point) { return stable_hash(fmt::format("{}", point.overrides)); }

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
        result.outcomes[p] = {twin::PointOutcome::State::kept, {}, found->second->outcome.seconds};
    }
    return pending;
}

report::PointRow row_of(const report::SweepResult& result, std::size_t point)
{
    auto outcome = result.outcomes[point];
    if (outcome.state == twin::PointOutcome::State::kept) {
        outcome.state = twin::PointOutcome::State::done;
    }
    return {result.points[point].name, mark_of(result.points[point]), std::move(outcome), result.records[point]};
}

/// Those of some points that ended so far.
std::vector<report::PointRow> rows_of(const report::SweepResult& result, const std::vector<std::size_t>& points)
{
    std::vector<report::PointRow> rows;
    for (const auto point : points) {
        if (result.outcomes[point].state != twin::PointOutcome::State::left) {
            rows.push_back(row_of(result, point));
        }
    }
    return rows;
}

/// The tables of points that calls before have written, and the one of this call.
struct Tables {
    std::string mark;  ///< of the study
    fs::path own;
    std::vector<fs::path> before;
};

Tables tables_of(const SweepOptions& options, const report::StudyFolder& folder, std::string mark)
{
    const auto of_all = fs::path(options.folder) / "points.csv";
    if (options.shard) {
        return {std::move(mark), folder.file("points.csv"), {of_all, folder.file("points.csv")}};
    }
    auto before = folder.files_of_all("points.csv");
    before.push_back(of_all);
    return {std::move(mark), of_all, std::move(before)};
}

std::vector<report::PointRow> read_tables(const Tables& tables)
{
    std::vector<report::PointRow> rows;
    for (const auto& file : tables.before) {
        auto more = report::read_points(file, tables.mark);
        rows.insert(rows.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
    }
    return rows;
}

/// With --gather: points that failed stay failed, and none may be missing. @return those whose course is drawn
std::vector<std::size_t> require_all(const std::vector<report::PointRow>& rows, const std::vector<std::size_t>& pending,
                                     report::SweepResult& result)
{
    std::map<std::string, const report::PointRow*> known;
    for (const auto& row : rows) {
        known[row.mark] = &row;
    }
    std::vector<std::size_t> missing, drawn;
    for (const auto point : pending) {
        const auto row = known.find(mark_of(result.points[point]));
        if (row == known.end()) {
            missing.push_back(point);
        } else if (row->second->outcome.state == twin::PointOutcome::State::failed) {
            result.outcomes[point] = row->second->outcome;
        } else {
            drawn.push_back(point);
        }
    }
    report::require_none_missing(result.points, missing);
    return drawn;
}

/// The points of this call.
std::vector<std::size_t> own_points(const SweepOptions& options, const report::SweepResult& result)
{
    std::vector<std::size_t> all(result.points.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    return options.shard ? twin::points_of(*options.shard, all) : all;
}

/// Runs the points of this call that are not there yet. Their numbers stand in the tables only.
void run_on_model(const SweepOptions& options, const twin::ReducedPress& press, const Tables& tables,
                  report::SweepResult& result, Console& console)
{
    // A shard draws nothing.
    const auto drawn = options.shard ? std::set<std::size_t>{} : report::points_over_time(result);
    const auto rows = read_tables(tables);
    auto pending = take_kept(rows, drawn, result);
    if (pending.size() < result.points.size()) {
        print_out("{} of {} points are there already\n", result.points.size() - pending.size(), result.points.size());
    }
    if (options.gather) {
        pending = require_all(rows, pending, result);
    }
    const auto own = own_points(options, result);
    std::erase_if(pending, [&](std::size_t point) { return !std::ranges::binary_search(own, point); });
    const auto known = rows_of(result, own);
    report::PointTable table(tables.own, tables.mark, known);
    flush_out();
    twin::ReducedSweep how;
    how.threads = options.jobs > 0 ? options.jobs : usable_cores();
    const casefile::CaseBase base(result.study.base, options.files);
    how.read = [&](const twin::SweepPoint& point) { return base.with(point.overrides); };
    casefile::CaseTexts texts;
    how.record = [&](std::size_t point, const casefile::Case& input, const press::RunResult& run) {
        const auto record = report::record_of(input, texts.hash(input), run);
        return drawn.contains(point) ? record : report::brief(record);
    };
    how.take = [&](std::size_t point, twin::EndedPoint ended) {
        result.outcomes[point] = std::move(ended.outcome);
        result.records[point] = std::move(ended.record);
        table.add(row_of(result, point));
    };
    twin::run_points_reduced(result.points, pending, press, how, console);
    if (!known.empty()) {
        table.replace(rows_of(result, own));
    }
}

}  // namespace

int sweep_reduced(const SweepOptions& options, Ranks& ranks)
{
    if (options.size_scale != 1 || options.fields) {
        throw InputError("--reduced computes without a mesh\n  help: leave out --size and --fields");
    }
    if (!ranks.first) {
        return 0;
    }
    auto& console = ranks.console;
    const auto press = twin::read_reduced(options.reduced);
    report::SweepResult result;
    result.study = read_sweep(options);
    result.points = twin::sweep_points(result.study, twin::base_values(result.study));
    result.records.resize(result.points.size());
    result.outcomes.resize(result.points.size());
    result.reduced_model = fs::path(options.reduced).filename().string();
    print_out("{}", report::sweep_plan_text(result.study, result.points));
    const auto mark = mark_of_study(options, result.study);
    std::vector<std::string> marks;
    for (const auto& point : result.points) {
        marks.push_back(stable_hash(mark + mark_of(point)));
    }
    const auto folder = open_study(options, marks, console);
    const auto own = own_points(options, result);
    say_share(options, own.size(), result.points.size());
    run_on_model(options, press, tables_of(options, folder, mark), result, console);
    console.finish();
    return options.shard ? finish_shard(options, own, result, folder, console) : finish(options, result, console);
}
