#include "sweep/sweep_study.hpp"

#include "deadpoint/casefile/studies/study_file.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/report/folder/table_style.hpp"
#include "deadpoint/report/page/sweep_page.hpp"
#include "deadpoint/report/sweep/sweep_files.hpp"
#include "deadpoint/report/tables/sweep_figures.hpp"
#include "interrupt.hpp"
#include "output.hpp"

#include <algorithm>
#include <fmt/format.h>

using namespace deadpoint;
namespace fs = std::filesystem;

namespace {

int exit_code_of_points(const report::SweepResult& result, const Console& console)
{
    if (console.cancelled()) {
        return interrupted_exit_code;
    }
    const auto failed =
        std::ranges::count(result.outcomes, twin::PointOutcome::State::failed, &twin::PointOutcome::state);
    return failed > 0 ? static_cast<int>(ErrorKind::convergence) : 0;
}

}  // namespace

twin::SweepStudy read_sweep(const SweepOptions& options)
{
    const auto file = casefile::read_study(options.study, options.files);
    if (file.sets.empty()) {
        throw InputError(fmt::format("'{}' has no sets of runs\n  help: add [[sets]] (docs/study-file.md), or use "
                                     "'deadpoint sensitivity'",
                                     options.study));
    }
    return twin::translate_study(file);
}

report::StudyFolder open_study(const SweepOptions& options, const std::vector<std::string>& marks, Console& console)
{
    report::StudyFolder folder(options.folder, marks, options.shard);
    for (const auto& note : folder.take_notes()) {
        console.note(note);
    }
    return folder;
}

void say_share(const SweepOptions& options, std::size_t own, std::size_t all)
{
    if (options.shard) {
        print_out("shard {}/{}: {} of {} points\n", options.shard->number, options.shard->count, own, all);
    }
}

int finish(const SweepOptions& options, const report::SweepResult& result, Console& console)
{
    report::write_sweep_files(options.folder, result, console.warnings());
    const auto page = fs::path(options.folder) / "report.html";
    report::write_sweep_report(page, options.folder);
    report::style_tables(options.folder, options.tables);
    print_out("{}\nresults{} are in {}\nthe page is {}\n", report::sweep_text(result),
              console.cancelled() ? " so far (the same command continues)" : "", options.folder, page.string());
    return exit_code_of_points(result, console);
}

int finish_shard(const SweepOptions& options, const std::vector<std::size_t>& own, const report::SweepResult& result,
                 const report::StudyFolder& folder, Console& console)
{
    using State = twin::PointOutcome::State;
    const auto count = [&](State state) {
        return std::ranges::count(own, state, [&](std::size_t point) { return result.outcomes[point].state; });
    };
    folder.keep_failures(result.outcomes);
    print_out("shard {}/{}: {} points computed, {} were there, {} failed\n", options.shard->number,
              options.shard->count, count(State::done), count(State::kept), count(State::failed));
    print_out("{}\n", console.cancelled()
                          ? "the same command continues"
                          : "once all shards are done, the same command with --gather instead of --shard makes tables, "
                            "charts and the page");
    return exit_code_of_points(result, console);
}
