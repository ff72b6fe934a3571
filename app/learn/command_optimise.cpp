#include "commands.hpp"
#include "deadpoint/casefile/files/read.hpp"
#include "deadpoint/casefile/files/study_file.hpp"
#include "deadpoint/casefile/files/write.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/fem/space/session.hpp"
#include "deadpoint/report/design/optimise_files.hpp"
#include "deadpoint/report/folder/result_files.hpp"
#include "deadpoint/study/design/optimise.hpp"
#include "deadpoint/study/pipeline/press.hpp"
#include "deadpoint/study/pipeline/run.hpp"
#include "deadpoint/study/reduce/reduced_press.hpp"
#include "deadpoint/study/result/run_result.hpp"
#include "interrupt.hpp"
#include "options/result_options.hpp"
#include "output.hpp"
#include "ranks.hpp"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fmt/format.h>
#include <memory>
#include <optional>
#include <thread>

using namespace deadpoint;
namespace fs = std::filesystem;

namespace {

struct OptimiseOptions {
    std::string study;
    std::string folder;
    std::string reduced;
    int jobs = 0;
    bool force = false;
    bool no_full_run = false;
    casefile::FileAccess files = casefile::FileAccess::below;
    Console::Options console;
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

/// The optimum on the mesh of the reduced model.
std::optional<study::FullDesign> run_in_full(const study::OptimiseResult& result, double size_scale,
                                             const casefile::OptimiseSection& section, Console& console)
{
    auto optimum = result.optimum;
    optimum.output.fields = false;
    optimum.output.causes = false;
    study::Press press(std::move(optimum), size_scale);
    const auto run = press.run({}, console);
    if (run.thermal.interrupted) {
        return std::nullopt;
    }
    return study::full_design(press.input(), run, section);
}

int optimise(const OptimiseOptions& options, Console& console)
{
    const auto study = read_section(options);
    const auto& section = *study.optimise;
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
    const auto result = study::run_optimise(read.value, press, section, threads, console);
    std::optional<study::FullDesign> full;
    if (result && !options.no_full_run) {
        full = run_in_full(*result, press.size_scale, section, console);
    }
    if (!result || console.cancelled()) {
        console.finish();
        return interrupted_exit_code;
    }
    for (const auto& text : result->outside) {
        console.warn(fmt::format("the optimum lies outside the range of the reduced model: {}", text));
    }
    console.finish();
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    const report::OptimiseReport report{study,
                                        *result,
                                        full ? &*full : nullptr,
                                        read.value.machine.name,
                                        casefile::case_hash(read.value),
                                        fs::path(options.reduced).filename().string(),
                                        seconds.count()};
    report::write_optimise_files(folder.path(), report, console.warnings());
    report::write_manifest(folder.path());
    report::write_optimise_page(folder.path() / "report.html", folder.path());
    commit(folder, console);
    print_out("{}\nresults are in {}\nthe page is {}\n", report::optimise_text(report), options.folder,
              (fs::path(options.folder) / "report.html").string());
    return 0;
}

}  // namespace

void add_optimise(CLI::App& app, int& exit_code)
{
    auto* command = app.add_subcommand("optimise", "find the values with the shortest warm-up or the least drift");
    const auto options = std::make_shared<OptimiseOptions>();
    command->add_option("study", options->study, "the study file (TOML), with a section [optimise]")
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
    command->add_flag("--no-full-run", options->no_full_run, "leave out the full run at the optimum");
    command->add_option("-j,--jobs", options->jobs, "number of searches at a time; default: as many as cores")
        ->check(CLI::Range(1, 1024));
    add_file_access(*command, options->files);
    add_console_options(*command, options->console);
    command->callback([options, &exit_code] {
        exit_code = on_ranks(options->console, [&](const OnRanks& ranks) {
            if (fem::ranks() > 1) {
                throw InputError("optimise computes on one process\n  help: call it without mpirun; it uses all cores");
            }
            return optimise(*options, ranks.console);
        });
    });
}
