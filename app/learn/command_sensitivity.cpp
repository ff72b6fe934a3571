#include "commands.hpp"
#include "deadpoint/casefile/files/read.hpp"
#include "deadpoint/casefile/studies/study_file.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/report/design/sensitivity_files.hpp"
#include "deadpoint/report/folder/result_files.hpp"
#include "deadpoint/twin/explore/sensitivity.hpp"
#include "deadpoint/twin/model/reduced_press.hpp"
#include "interrupt.hpp"
#include "learn/design_study.hpp"
#include "options/result_options.hpp"

#include <chrono>
#include <fmt/format.h>
#include <memory>

using namespace deadpoint;

namespace {

casefile::StudyFile read_section(const DesignOptions& options)
{
    auto study = casefile::read_study(options.study, options.files);
    if (!study.sensitivity) {
        throw InputError(
            fmt::format("'{}' has no section [sensitivity]\n  help: add one (docs/study-file.md), or run its "
                        "sets with 'deadpoint sweep'",
                        options.study));
    }
    return study;
}

int sensitivity(const DesignOptions& options)
{
    Console console(options.console);
    const auto start = std::chrono::steady_clock::now();
    const auto study = read_section(options);
    const auto base = read_base(options, study, console);
    const auto press = twin::read_reduced(options.reduced);
    const auto folder = begin_folder(options, base, console);
    const auto result = twin::run_sensitivity(base.value, press, *study.sensitivity, options.threads(), console);
    if (!result) {
        console.finish();
        return interrupted_exit_code;
    }
    for (const auto& text : result->outside) {
        console.warn(fmt::format("outside the range of the reduced model: {}", text));
    }
    for (const auto& text : report::vague_figures(*result)) {
        console.warn(text);
    }
    if (result->failed > 0) {
        console.warn(fmt::format("{} of {} runs failed and are left out; the first because: {}", result->failed,
                                 result->runs, result->failure));
    }
    console.finish();
    const report::SensitivityReport report{studied_case(options, study, base.value, start), *result};
    report::write_sensitivity_files(folder->path(), report, console.warnings());
    report::write_manifest(folder->path());
    report::write_sensitivity_page(folder->path() / "report.html", folder->path());
    commit(*folder, options.tables, console);
    print_design(report::sensitivity_text(report), options);
    return 0;
}

}  // namespace

void add_sensitivity(CLI::App& app, int& exit_code)
{
    auto* command = app.add_subcommand("sensitivity", "find which parameters matter for gap and temperatures");
    const auto options = std::make_shared<DesignOptions>();
    add_design_options(*command, *options, "sensitivity", "number of runs at a time; default: as many as cores");
    command->callback([options, &exit_code] { exit_code = sensitivity(*options); });
}
