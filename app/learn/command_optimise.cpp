#include "commands.hpp"
#include "deadpoint/casefile/files/read.hpp"
#include "deadpoint/casefile/studies/study_file.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/full/run/press.hpp"
#include "deadpoint/full/run/run.hpp"
#include "deadpoint/press/result/run_result.hpp"
#include "deadpoint/report/design/optimise_files.hpp"
#include "deadpoint/report/folder/result_files.hpp"
#include "deadpoint/twin/explore/optimise.hpp"
#include "deadpoint/twin/model/reduced_press.hpp"
#include "interrupt.hpp"
#include "learn/design_study.hpp"
#include "options/result_options.hpp"
#include "ranks/ranks.hpp"

#include <chrono>
#include <fmt/format.h>
#include <memory>
#include <optional>

using namespace deadpoint;

namespace {

struct OptimiseOptions : DesignOptions {
    bool no_full_run = false;
    RankOptions ranks;
};

casefile::StudyFile read_section(const OptimiseOptions& options)
{
    auto study = casefile::read_study(options.study, options.files);
    if (!study.optimise) {
        throw InputError(
            fmt::format("'{}' has no section [optimise]\n  help: add one (docs/study-file.md)", options.study));
    }
    return study;
}

/// The optimum on the mesh of the reduced model. @param folder  afterwards of the first rank alone
std::optional<twin::FullDesign> run_in_full(const twin::OptimiseResult& result, double size_scale,
                                            const casefile::OptimiseSection& section, Ranks& ranks,
                                            std::unique_ptr<report::ResultFolder>& folder)
{
    auto optimum = result.optimum;
    optimum.output.fields = false;
    optimum.output.causes = false;
    full::Press press(std::move(optimum), size_scale);
    press.mesh(ranks.console);
    ranks.spread([&] { return press.machine(ranks.console).cells.size(); });
    leave_to_first(ranks, folder);
    ranks.agree = false;
    const auto run = press.run({}, ranks.console);
    if (run.thermal.interrupted) {
        return std::nullopt;
    }
    return twin::full_design(press.input(), run, section);
}

int optimise(const OptimiseOptions& options, Ranks& ranks)
{
    ranks.require_one("optimise");
    auto& console = ranks.console;
    const auto start = std::chrono::steady_clock::now();
    const auto study = read_section(options);
    const auto base = read_base(options, study, console);
    const auto press = twin::read_reduced(options.reduced);
    auto folder = begin_folder(options, base, console);
    const auto& section = *study.optimise;
    const auto result = twin::run_optimise(base.value, press, section, options.threads(), console);
    std::optional<twin::FullDesign> full;
    if (result && !options.no_full_run) {
        full = run_in_full(*result, press.size_scale, section, ranks, folder);
    }
    if (!result || console.cancelled()) {
        console.finish();
        return interrupted_exit_code;
    }
    if (!ranks.first) {
        return 0;
    }
    for (const auto& text : result->outside) {
        console.warn(fmt::format("the optimum lies outside the range of the reduced model: {}", text));
    }
    console.finish();
    const report::OptimiseReport report{studied_case(options, study, base.value, start), *result,
                                        full ? &*full : nullptr};
    report::write_optimise_files(folder->path(), report, console.warnings());
    report::write_manifest(folder->path());
    report::write_optimise_page(folder->path() / "report.html", folder->path());
    commit(*folder, options.tables, console);
    print_design(report::optimise_text(report), options);
    return 0;
}

}  // namespace

void add_optimise(CLI::App& app, int& exit_code)
{
    auto* command = app.add_subcommand("optimise", "find the values with the shortest warm-up or the least drift");
    const auto options = std::make_shared<OptimiseOptions>();
    add_design_options(*command, *options, "optimise", "number of searches at a time; default: as many as cores");
    command->add_flag("--no-full-run", options->no_full_run, "leave out the full run at the optimum");
    add_rank_options(*command, options->ranks);
    command->callback([options, &exit_code] {
        exit_code = on_ranks(options->ranks, options->console, [&](Ranks& ranks) { return optimise(*options, ranks); });
    });
}
