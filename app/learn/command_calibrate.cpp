#include "commands.hpp"
#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/casefile/files/read.hpp"
#include "deadpoint/casefile/studies/calibration_file.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/full/run/press.hpp"
#include "deadpoint/full/run/run.hpp"
#include "deadpoint/io/resources.hpp"
#include "deadpoint/press/result/reduced_result.hpp"
#include "deadpoint/press/result/run_result.hpp"
#include "deadpoint/report/calibration/calibration_files.hpp"
#include "deadpoint/twin/calibrate/calibrate.hpp"
#include "deadpoint/twin/calibrate/parameter.hpp"
#include "deadpoint/twin/model/reduced_press.hpp"
#include "deadpoint/twin/run/run_reduced.hpp"
#include "interrupt.hpp"
#include "options/result_options.hpp"
#include "output.hpp"
#include "ranks/ranks.hpp"

#include <algorithm>
#include <memory>

using namespace deadpoint;
namespace fs = std::filesystem;

namespace {

struct CalibrateOptions : ResultOptions {
    std::string calibration;
    std::string reduced;
    int jobs = 0;
    bool plan = false;
    bool full_run = false;
    RankOptions ranks;
};

casefile::CalibrationFile read_file(const CalibrateOptions& options)
{
    casefile::CalibratedCase of;
    of.path = options.path;
    of.overrides = options.overrides;
    of.files = options.files;
    of.keys_of = [](const casefile::Case& input, const std::vector<std::string>& patterns) {
        return twin::keys_of(input, patterns, "keys");
    };
    auto file = casefile::read_calibration(options.calibration, of, options.plan);
    if (!options.reduced.empty())
        file.options.reduced = options.reduced;
    if (file.options.reduced.empty())
        throw InputError("the calibration needs a reduced model\n  help: build one with 'deadpoint reduce CASE -o "
                         "press.rom', and name it with --reduced press.rom");
    return file;
}

twin::OtherPresses read_others(const casefile::CalibrationFile& file)
{
    twin::OtherPresses result;
    for (const auto& alternative : file.alternatives)
        result.push_back(alternative.reduced.empty()
                             ? nullptr
                             : std::make_shared<twin::ReducedPress>(twin::read_reduced(alternative.reduced)));
    return result;
}

/// On all ranks: a full run of the first fitted run with the calibrated values, against the reduced one.
std::pair<double, double> check_by_full_run(const CalibrateOptions& options, const casefile::CalibrationFile& file,
                                            const twin::ReducedPress& reduced, const twin::Calibration& result,
                                            Ranks& ranks, report::ResultFolder& folder)
{
    auto& console = ranks.console;
    const auto first = std::ranges::find(file.runs, false, &casefile::CalibrationRun::hold_out);
    auto overrides = options.overrides;
    overrides.insert(overrides.end(), first->set.begin(), first->set.end());
    overrides.insert(overrides.end(), result.settings.begin(), result.settings.end());
    overrides.emplace_back("output.fields=false");
    const auto input = casefile::read_case(options.path, overrides, options.files).value;
    full::Press press(input, reduced.size_scale);
    press.mesh(console);
    ranks.spread([&] { return press.machine(console).cells.size(); });
    if (!ranks.first)
        folder.disown();
    ranks.agree = false;
    const auto full = press.run({}, console);
    const auto quick = twin::run_reduced(input, reduced, {}, twin::ReducedDetail::figures, console);
    const auto error = twin::difference_to_full(quick, full);
    return {error.temperature, error.gap};
}

int calibrate(const CalibrateOptions& options, Ranks& ranks)
{
    if (options.size_scale != 1)
        throw InputError("calibrate computes without a mesh\n  help: leave out --size");
    ranks.require_one("calibrate");
    auto& console = ranks.console;
    const auto read = read_case(options, console);
    const auto file = read_file(options);
    const auto press = twin::read_reduced(file.options.reduced);
    const auto others = read_others(file);
    const int threads = options.jobs > 0 ? options.jobs : usable_cores();
    auto inputs = input_files(read);
    inputs.insert(inputs.end(), {options.calibration, file.options.reduced});
    for (const auto& alternative : file.alternatives)
        if (!alternative.reduced.empty())
            inputs.push_back(alternative.reduced);
    using enum report::ResultFolder::IfExists;
    report::ResultFolder folder(claim_folder(options.folder, console), options.force ? replace : refuse, inputs);
    const auto model = fs::path(file.options.reduced).filename().string();
    if (options.plan) {
        auto plan = twin::plan_calibration(file, press, others, threads, console);
        console.finish();
        if (!plan)
            return interrupted_exit_code;
        plan->reduced_file = model;
        report::write_plan_files(folder.path(), *plan);
        commit(folder, options.tables, console);
        const auto page = folder.target() / "report.html";
        report::write_plan_page(page, *plan);
        print_out("{}\nresults are in {}\nthe page is {}\n", report::calibration_text(*plan), folder.target().string(),
                  page.string());
        return 0;
    }
    auto result = twin::calibrate(file, press, others, threads, console);
    if (result && options.full_run)
        result->full_run = check_by_full_run(options, file, press, *result, ranks, folder);
    if (!result || console.cancelled()) {
        console.finish();
        return interrupted_exit_code;
    }
    if (!ranks.first)
        return 0;
    console.finish();
    result->reduced_file = model;
    report::write_calibration_files(folder.path(), *result);
    commit(folder, options.tables, console);
    const auto page = folder.target() / "report.html";
    report::write_calibration_page(page, *result);
    print_out("{}\nresults are in {}\nthe page is {}\n", report::calibration_text(*result), folder.target().string(),
              page.string());
    return 0;
}

}  // namespace

void add_calibrate(CLI::App& app, int& exit_code)
{
    auto* command = app.add_subcommand("calibrate", "find unknown values of a case from measurements");
    const auto options = std::make_shared<CalibrateOptions>();
    add_result_options(*command, *options);
    command->add_option("calibration", options->calibration, "the calibration file (TOML)")
        ->required()
        ->type_name("CALIBRATION");
    command
        ->add_option("--reduced", options->reduced,
                     "compute with this reduced model of the press, which 'reduce' has written")
        ->type_name("FILE");
    command->add_flag("--plan", options->plan,
                      "say what the planned measurements can determine, and which further one would help most");
    command->add_flag("--full-run", options->full_run,
                      "check the calibrated case by a full run of its first fitted run");
    command->add_option("-j,--jobs", options->jobs, "threads; default: as many as processors")
        ->check(CLI::Range(1, 1024))
        ->type_name("N");
    add_rank_options(*command, options->ranks);
    command->callback([options, &exit_code] {
        exit_code =
            on_ranks(options->ranks, options->console, [&](Ranks& ranks) { return calibrate(*options, ranks); });
    });
}
