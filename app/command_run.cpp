#include "commands.hpp"
#include "deadpoint/casefile/files/case_source.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/full/refine/refine.hpp"
#include "deadpoint/full/run/press.hpp"
#include "deadpoint/full/run/reduce.hpp"
#include "deadpoint/full/run/run.hpp"
#include "deadpoint/observer.hpp"
#include "deadpoint/press/run/field_options.hpp"
#include "deadpoint/report/folder/result_files.hpp"
#include "deadpoint/report/page/run_folder.hpp"
#include "deadpoint/report/run/run_text.hpp"
#include "deadpoint/twin/model/certificate_file.hpp"
#include "deadpoint/twin/model/reduced_press.hpp"
#include "deadpoint/twin/run/reduced_states.hpp"
#include "deadpoint/twin/run/run_reduced.hpp"
#include "deadpoint/twin/run/run_sensitivities.hpp"
#include "interrupt.hpp"
#include "options/build_folder.hpp"
#include "options/checkpoint_options.hpp"
#include "options/result_options.hpp"
#include "output.hpp"
#include "ranks/ranks.hpp"

#include <fmt/format.h>
#include <memory>
#include <optional>

using namespace deadpoint;
using report::ResultFolder;

namespace {

struct RunOptions : ResultOptions {
    std::string from;      ///< result folder whose final temperatures are the start
    std::string accuracy;  ///< numerics.accuracy, overrides the case's
    std::string reduced;   ///< file of a reduced model to compute with
    std::string reduce;    ///< file of a reduced model to build after the run
    bool sensitivities = false;
    bool full_run = false;  ///< computes the case in full too, for the error of the reduced run
    bool certify = false;   ///< bounds the error of the reduced run, or makes what that needs
    bool fields = false;    ///< also stores the fields of the reduced model's states
    CheckpointOptions checkpoints;
    RankOptions ranks;
};

/// Writes and names the folder of a finished run, and says where it is.
void show_results(ResultFolder& folder, const RunOptions& options, const casefile::Case& input, const Machine& machine,
                  const press::RunResult& result, Console& console)
{
    const auto problem = report::finish_run_folder(folder, input, machine, result, console.warnings(), options.tables);
    for (const auto& note : folder.take_notes()) {
        console.note(note);
    }
    if (!problem.empty()) {
        console.warn(problem);
    }
    const auto where = folder.target().string();
    const auto detail = options.console.verbose ? report::Detail::all : report::Detail::short_text;
    print_out("{}\nresults{} are in {}\n", report::run_text(input, result, detail),
              result.thermal.interrupted ? " up to the interruption" : "", where);
    if (problem.empty()) {
        print_out("see them on a page: deadpoint view {}  (opens {}/report.html)\n", where, where);
    }
}

/// On as many meshes as the case's accuracy takes. `ranks.agree` is false from here on, and the folder of the first
/// rank alone.
full::RefinedRun compute_to_accuracy(const casefile::Case& input, const RunOptions& options,
                                     const full::RunOptions& wanted, Ranks& ranks,
                                     std::unique_ptr<ResultFolder>& folder)
{
    constexpr std::size_t growth = 4;  // of the meshes that follow, about
    ranks.spread([&] { return growth * full::Press(input, options.size_scale).machine(ranks.console).cells.size(); });
    leave_to_first(ranks, folder);
    ranks.agree = false;
    auto run = full::run_to_accuracy(
        input, options.size_scale,
        [&](const casefile::Case& refined) {
            auto of_last = wanted;
            of_last.comments = file_comments(refined, ranks.console);
            return of_last;
        },
        ranks.console);
    return run;
}

std::shared_ptr<const reduce::ResidualTerms> certificate_of(const std::filesystem::path& press,
                                                            const twin::ReducedPress& large)
{
    const auto file = twin::certificate_file(press);
    if (!std::filesystem::exists(file)) {
        throw InputError(fmt::format("there is no certificate '{}' of this reduced press\n  help: make it with "
                                     "'deadpoint reduce CASE -o {} --certify'",
                                     file.string(), press.string()));
    }
    return twin::read_certificate(file, large);
}

/// Without a mesh. The large model beside the file tells the error.
press::RunResult compute_reduced(const casefile::Case& input, const twin::ReducedPress& press,
                                 const RunOptions& options, twin::ReducedStates* states, Console& console)
{
    const std::filesystem::path file = options.reduced;
    const auto large = file.parent_path() / press.large_file;
    std::optional<twin::ReducedPress> other;
    if (press.large_file.empty()) {
        console.warn("this is the large model itself, so the error of this run is not estimated");
    } else if (std::filesystem::exists(large)) {
        other = twin::read_reduced_for_few_runs(large);
    } else {
        console.warn(fmt::format("'{}' is missing, so the error of this run is not estimated", large.string()));
    }
    std::shared_ptr<const reduce::ResidualTerms> residual;
    if (options.certify) {
        if (!other) {
            throw InputError("--certify needs the large model beside the reduced press");
        }
        residual = certificate_of(file, *other);
    }
    auto result = casefile::with_places(input, [&] {
        return twin::run_reduced(input, press, {other ? &*other : nullptr, residual.get()}, twin::ReducedDetail::all,
                                 console, states);
    });
    result.reduced->file = file.filename().string();
    return result;
}

/// On one mesh. `ranks.agree` is false after meshing. @param folder  from then on of the first rank alone
full::RefinedRun compute_once(const casefile::Case& input, const RunOptions& options, const full::RunOptions& wanted,
                              Ranks& ranks, std::unique_ptr<ResultFolder>& folder)
{
    auto& console = ranks.console;
    full::Press press(input, options.size_scale);
    press.mesh(console);
    console.finish();
    ranks.spread([&] { return press.machine(console).cells.size(); });
    leave_to_first(ranks, folder);
    ranks.agree = false;
    auto result = press.run(wanted, console);
    if (options.reduce.empty()) {
        press.drop_model();
    }
    result.timings.insert(result.timings.begin(), {"mesh", press.mesh_seconds()});
    return {std::make_unique<full::Press>(std::move(press)), std::move(result)};
}

/// The checkpoint of a run that is over is of no use.
void say_or_remove(const std::filesystem::path& checkpoint, bool interrupted)
{
    if (!interrupted) {
        std::error_code ignored;
        std::filesystem::remove(checkpoint, ignored);
    } else if (std::filesystem::exists(checkpoint)) {
        print_out("the same command with --resume continues from there\n");
    }
}

void refuse_beside_reduced(const RunOptions& options)
{
    const bool other_mesh = options.size_scale != 1 || !options.accuracy.empty();
    if (other_mesh || !options.from.empty() || options.checkpoints.resume) {
        throw InputError("--reduced computes without a mesh, from the start of the case\n  help: leave out --size, "
                         "--accuracy, --from and --resume");
    }
}

bool wants_fields(const casefile::Case& input) { return input.output.fields || !input.output.stress.empty(); }

/// Lifts the fields of a reduced run onto the mesh of its press.
void lift_fields(const RunOptions& options, full::Press& press, const twin::ReducedStates& states,
                 const std::string& folder, press::RunResult& result, Console& console)
{
    const auto& input = press.input();
    const press::FieldOptions wanted{input.output.fields ? folder : std::string{}, file_comments(input, console)};
    press.lift(twin::fields_file(options.reduced).string(), states, wanted, result, console);
}

/// Passes progress on, but no warnings: the reduced run has given them.
class Progress : public Observer {
public:
    explicit Progress(Observer& to) : to_(to) {}
    void stage(std::string_view name) override { to_.stage(fmt::format("full run: {}", name)); }
    void progress(double fraction, std::string_view detail) override { to_.progress(fraction, detail); }
    [[nodiscard]] bool cancelled() const override { return to_.cancelled(); }

private:
    Observer& to_;
};

/// Computes the case in full and states how far the reduced run is off.
void compare_with_full(full::Press& press, press::RunResult& result, Console& console)
{
    auto bare = press.input();
    bare.output.fields = bare.output.causes = false;
    press.take(std::move(bare));
    Progress progress(console);
    const auto full = press.run({}, progress);
    if (full.thermal.interrupted) {
        console.warn("the full run was stopped, so the error of this run to it is not known");
        return;
    }
    result.reduced->full_run = twin::difference_to_full(result, full);
}

/// What a reduced run asks of the mesh. `ranks.agree` is false after meshing.
std::unique_ptr<full::Press> use_mesh(const casefile::Case& input, const RunOptions& options,
                                      const twin::ReducedPress& reduced, const twin::ReducedStates* states,
                                      std::unique_ptr<ResultFolder>& result_folder, const std::string& folder,
                                      press::RunResult& result, Ranks& ranks)
{
    auto& console = ranks.console;
    auto press = std::make_unique<full::Press>(input, reduced.size_scale);
    press->mesh(console);
    result.timings.emplace_back("mesh", press->mesh_seconds());
    ranks.spread([&] { return press->machine(console).cells.size(); });
    leave_to_first(ranks, result_folder);
    ranks.agree = false;
    if (states) {
        lift_fields(options, *press, *states, folder, result, console);
    }
    if (options.full_run && !result.thermal.interrupted) {
        compare_with_full(*press, result, console);
    }
    press->drop_model();
    return press;
}

/// Every rank computes the same; together they use the mesh.
int run_reduced_case(const RunOptions& options, Ranks& ranks)
{
    refuse_beside_reduced(options);
    auto& console = ranks.console;
    const auto read = read_case(options, console);
    const auto press = twin::read_reduced(options.reduced);
    const bool lifts = wants_fields(read.value) && std::filesystem::exists(twin::fields_file(options.reduced));
    std::unique_ptr<ResultFolder> folder;
    const auto path = start_folder(
        ranks.first, [&] { return start_folder(options, read, console); }, folder);
    twin::ReducedStates states;
    auto result = compute_reduced(read.value, press, options, lifts ? &states : nullptr, console);
    if (options.sensitivities && !result.thermal.interrupted) {
        console.stage("sensitivities");
        result.sensitivities =
            casefile::with_places(read.value, [&] { return twin::run_sensitivities(read.value, press, console); });
    }
    std::unique_ptr<full::Press> meshed;
    if (lifts || options.full_run) {
        meshed = use_mesh(read.value, options, press, lifts ? &states : nullptr, folder, path, result, ranks);
    }
    console.finish();
    if (!folder) {
        return result.thermal.interrupted ? interrupted_exit_code : 0;
    }
    show_results(*folder, options, read.value, meshed ? meshed->machine(console) : press.machine, result, console);
    if (wants_fields(read.value) && !lifts) {
        print_out("there are no fields, since '{}' is missing; 'deadpoint reduce --fields' writes it\n",
                  twin::fields_file(options.reduced).string());
    }
    return result.thermal.interrupted ? interrupted_exit_code : 0;
}

void refuse_beside_reduce(const RunOptions& options, const casefile::Case& input)
{
    if (!options.reduce.empty() && casefile::wanted_accuracy(input)) {
        throw InputError(
            "--reduce builds on the mesh of the case, and a run that refines its parts has others\n  help: "
            "give the sizes that are known and no accuracy, or leave out --reduce");
    }
}

std::optional<BuildFolder> start_build(const RunOptions& options, const casefile::Case& input, Ranks& ranks)
{
    refuse_beside_reduce(options, input);
    if (options.reduce.empty()) {
        return std::nullopt;
    }
    const auto stopped = stopped_build(options.checkpoints.resume, options.force);
    return std::make_optional<BuildFolder>(options.reduce, stopped, input, ranks);
}

/// On the mesh of the run, and with its functionals. A run from the start of the case is one of the full runs.
int build_after(full::RefinedRun& run, const BuildFolder& build, const RunOptions& options, Ranks& ranks)
{
    auto wanted = wanted_reduction(run.press->input(), usual_full_runs);
    wanted.checkpoint = build.checkpoint();
    wanted.run = options.from.empty() ? &run.result.thermal : nullptr;
    wanted.build.certificate = options.certify;
    if (options.fields) {
        wanted.fields_file = twin::fields_file(options.reduce).string();
    }
    const auto again = fmt::format("'deadpoint reduce' of this case with -o {} --resume", options.reduce);
    return build.finish(run.press->reduce(wanted, ranks.console), wanted, again, ranks);
}

int run_case(RunOptions options, Ranks& ranks)
{
    if (!options.reduced.empty()) {
        return run_reduced_case(options, ranks);
    }
    if (options.certify && options.reduce.empty()) {
        throw InputError("--certify bounds the error of a reduced run\n  help: give it with --reduced FILE, or with "
                         "--reduce FILE to write what that needs");
    }
    if (options.certify) {
        ranks.stay_alone("a certificate");
    }
    auto& console = ranks.console;
    if (!options.accuracy.empty()) {
        options.overrides.push_back("numerics.accuracy=\"" + options.accuracy + "\"");
    }
    const auto read = read_case(options, console);
    const auto& input = read.value;
    const auto build = start_build(options, input, ranks);
    std::optional<report::FolderClaim> claim;  // taken before files beside the folder are trusted
    on_first_rank(ranks.first, [&] { claim.emplace(claim_folder(options.folder, console)); });
    full::RunOptions wanted;
    const bool continues =
        plan_checkpoints(options.checkpoints, options.folder, options.force, input, ranks.first, wanted);
    const bool replaces = options.force || continues;
    std::unique_ptr<ResultFolder> folder;
    const auto start = [&] {
        using enum ResultFolder::IfExists;
        return std::make_unique<ResultFolder>(*std::move(claim), replaces ? replace : refuse, input_files(read));
    };
    const auto path = start_folder(ranks.first, start, folder);

    if (!options.from.empty()) {
        report::ResultFiles(options.from).check("state.bin");
        wanted.start_from = options.from + "/state.bin";
    }
    report::write_along(wanted, path, input, console.warnings());
    if (!keeps_checkpoints(wanted)) {
        wanted.kept_checkpoint.clear();
    }
    wanted.causes = true;
    auto run =
        (casefile::wanted_accuracy(input) ? compute_to_accuracy : compute_once)(input, options, wanted, ranks, folder);
    const auto& result = run.result;
    console.finish();
    if (folder) {
        console.stage("files");
        show_results(*folder, options, run.press->input(), run.press->machine(console), result, console);
        say_or_remove(checkpoint_of(options.folder), result.thermal.interrupted);
    }
    if (result.thermal.interrupted) {
        return interrupted_exit_code;
    }
    return build ? build_after(run, *build, options, ranks) : 0;
}

}  // namespace

void add_run(CLI::App& app, int& exit_code)
{
    auto* command = app.add_subcommand("run", "compute a case and write the results into a new folder");
    const auto options = std::make_shared<RunOptions>();
    add_result_options(*command, *options);
    command
        ->add_option("--from", options->from,
                     "a result folder to continue from: the run starts with its final temperatures")
        ->type_name("DIR");
    command
        ->add_option("--accuracy", options->accuracy,
                     "refine until the rises (0.1K) or the gap (0.2um) change by less; as numerics.accuracy")
        ->type_name("VALUE");
    auto* reduced = command
                        ->add_option("--reduced", options->reduced,
                                     "compute with a reduced model that 'deadpoint reduce' built, without a mesh")
                        ->type_name("FILE");
    auto* reduce = command
                       ->add_option("--reduce", options->reduce,
                                    "after the run, also build the reduced model that 'deadpoint reduce' builds, on "
                                    "its mesh")
                       ->type_name("FILE")
                       ->excludes(reduced);
    command
        ->add_flag("--fields", options->fields,
                   "with --reduce: also store the fields of the states, as 'deadpoint "
                   "reduce --fields' does")
        ->needs(reduce);
    command
        ->add_flag("--sensitivities", options->sensitivities,
                   "with --reduced: also derive the gap and the probes at the end by every free coefficient")
        ->needs(reduced);
    command
        ->add_flag("--full-run", options->full_run,
                   "with --reduced: also compute the case in full, for the error of this very run")
        ->needs(reduced);
    command->add_flag("--certify", options->certify,
                      "with --reduced: bound the error at the end of the run; needs 'deadpoint reduce --certify'. With "
                      "--reduce: write what that needs");
    add_checkpoint_options(*command, options->checkpoints);
    add_rank_options(*command, options->ranks);
    command->callback([options, &exit_code] {
        exit_code = on_ranks(options->ranks, options->console, [&](Ranks& ranks) { return run_case(*options, ranks); });
    });
}
