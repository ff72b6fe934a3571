#include "commands.hpp"
#include "deadpoint/casefile/files/read.hpp"
#include "deadpoint/casefile/files/study_file.hpp"
#include "deadpoint/casefile/files/write.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/report/design/sensitivity_files.hpp"
#include "deadpoint/report/folder/result_files.hpp"
#include "deadpoint/study/design/sensitivity.hpp"
#include "deadpoint/study/reduce/reduced_press.hpp"
#include "interrupt.hpp"
#include "options/result_options.hpp"
#include "output.hpp"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fmt/format.h>
#include <memory>
#include <thread>

using namespace deadpoint;
namespace fs = std::filesystem;

namespace {

struct SensitivityOptions {
    std::string study;
    std::string folder;
    std::string reduced;
    int jobs = 0;
    bool force = false;
    casefile::FileAccess files = casefile::FileAccess::below;
    Console::Options console;
};

casefile::StudyFile read_section(const SensitivityOptions& options)
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

int sensitivity(const SensitivityOptions& options)
{
    Console console(options.console);
    const auto study = read_section(options);
    const auto read = casefile::read_case(study.base, study.set, options.files);
    for (const auto& warning : read.warnings) {
        console.warn(warning);
    }
    const auto press = study::read_reduced(options.reduced);
    auto inputs = input_files(read);
    inputs.emplace_back(options.study);
    inputs.emplace_back(options.reduced);
    using enum report::ResultFolder::IfExists;
    report::ResultFolder folder(claim_folder(options.folder, console), options.force ? replace : refuse, inputs);
    const int threads =
        options.jobs > 0 ? options.jobs : static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
    const auto start = std::chrono::steady_clock::now();
    const auto result = study::run_sensitivity(read.value, press, *study.sensitivity, threads, console);
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
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    const report::SensitivityReport report{study,
                                           *result,
                                           read.value.machine.name,
                                           casefile::case_hash(read.value),
                                           fs::path(options.reduced).filename().string(),
                                           seconds.count()};
    report::write_sensitivity_files(folder.path(), report, console.warnings());
    report::write_manifest(folder.path());
    report::write_sensitivity_page(folder.path() / "report.html", folder.path());
    commit(folder, console);
    print_out("{}\nresults are in {}\nthe page is {}\n", report::sensitivity_text(report), options.folder,
              (fs::path(options.folder) / "report.html").string());
    return 0;
}

}  // namespace

void add_sensitivity(CLI::App& app, int& exit_code)
{
    auto* command = app.add_subcommand("sensitivity", "find which parameters matter for gap and temperatures");
    const auto options = std::make_shared<SensitivityOptions>();
    command->add_option("study", options->study, "the study file (TOML), with a section [sensitivity]")
        ->required()
        ->type_name("STUDY");
    command->add_option("--reduced", options->reduced, "the reduced model of the base case, from 'deadpoint reduce'")
        ->required()
        ->type_name("FILE");
    command->add_option("-o,--output", options->folder, "the folder to write into; it must not exist")
        ->required()
        ->type_name("DIR");
    command->add_flag("--force", options->force,
                      "replace a folder that deadpoint wrote, once the new results are complete");
    command->add_option("-j,--jobs", options->jobs, "number of runs at a time; default: as many as cores")
        ->check(CLI::Range(1, 1024));
    add_file_access(*command, options->files);
    add_console_options(*command, options->console);
    command->callback([options, &exit_code] { exit_code = sensitivity(*options); });
}
