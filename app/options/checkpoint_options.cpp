#include "options/checkpoint_options.hpp"

#include "deadpoint/casefile/describe/accuracy.hpp"
#include "deadpoint/casefile/files/write.hpp"
#include "deadpoint/core/quantity.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/fem/conduction/checkpoint.hpp"
#include "deadpoint/full/run/run_mark.hpp"
#include "deadpoint/press/run/run_record.hpp"
#include "deadpoint/report/folder/folder_claim.hpp"
#include "deadpoint/report/folder/read_result.hpp"
#include "deadpoint/report/folder/result_files.hpp"
#include "deadpoint/report/page/run_folder.hpp"
#include "output.hpp"

#include <cmath>
#include <fmt/format.h>
#include <fstream>
#include <limits>
#include <string_view>

using namespace deadpoint;
namespace fs = std::filesystem;

namespace {

/// Interval of --checkpoint [s]; infinite: none.
double interval_of(const std::string& text)
{
    constexpr double never = std::numeric_limits<double>::infinity();
    if (text == "step") {
        return 0;
    }
    if (text == "0") {
        return never;
    }
    const double interval = parse_quantity(text, Dimension::time);
    if (interval < 0) {
        throw InputError(fmt::format("--checkpoint \"{}\" is negative\n  help: give a time such as \"10 min\", "
                                     "0 for none, or step for one after each time step",
                                     text));
    }
    return interval > 0 ? interval : never;
}

using report::kept_checkpoint;

bool is_result(const fs::path& folder) { return fs::exists(folder / "summary.json") && report::is_whole(folder); }

/// The checkpoint in a folder of results from which a longer run of the case continues.
/// @throws InputError if the folder keeps none, or holds another run
fs::path kept_in(const fs::path& folder, const fem::RunMark& run)
{
    const report::ResultFiles files(folder);
    if (!files.listed().contains(kept_checkpoint)) {
        throw InputError(fmt::format(
            "'{}' holds results without a checkpoint, so they cannot be prolonged: reduced runs, runs to an accuracy "
            "and "
            "runs with --checkpoint 0 keep none\n  help: continue into another folder with --from {}, or compute the "
            "whole run anew with --force instead of --resume",
            folder.string(), folder.string()));
    }
    files.check(kept_checkpoint);
    const auto file = folder / kept_checkpoint;
    const auto head = fem::checkpoint_head(file.string(), run);
    if (run.end() <= head.run.end()) {
        throw InputError(fmt::format("the run in '{}' ended at {:.2f} h, and this operation ends at {:.2f} h\n  help: "
                                     "to prolong the run, state a "
                                     "longer operation: a longer duration of the last segment, as --set "
                                     "'operation.{}.duration=\"{:g} h\"', or a further segment",
                                     folder.string(), head.run.end() / 3600, run.end() / 3600,
                                     head.run.segments.size() - 1, 2 * head.run.durations.back() / 3600));
    }
    return file;
}

/// By its first bytes, in any version.
bool is_checkpoint(const fs::path& file)
{
    constexpr std::string_view kind = "deadpoint-checkpoint-";
    std::string beginning(kind.size(), '\0');
    std::ifstream(file, std::ios::binary).read(beginning.data(), static_cast<std::streamsize>(beginning.size()));
    return fs::is_regular_file(file) && beginning == kind;
}

/// @throws IoError unless a checkpoint may be lost, and is one
void require_discardable(const fs::path& file, bool force)
{
    if (!force) {
        throw IoError(fmt::format("'{}' is the checkpoint of a run that was stopped\n  help: continue from it with "
                                  "--resume, or discard it with --force",
                                  file.string()));
    }
    if (!is_checkpoint(file)) {
        throw IoError(fmt::format("'{}' is the name of this run's checkpoint, but that file is something else\n  help: "
                                  "rename the file, or give another folder with -o",
                                  file.string()));
    }
}

/// Says where a run begins.
void say(bool first, const std::string& text)
{
    if (first) {
        print_out("{}\n", text);
        flush_out();
    }
}

/// Whether a run that continues from a checkpoint replaces what is in its folder: the results of the same run up to its
/// stop, or its beginning. @throws InputError if the folder keeps the checkpoint of another run
bool replaces_results(const fs::path& folder, const fem::CheckpointHead& head, const fem::RunMark& run)
{
    if (!is_result(folder)) {
        return false;
    }
    const auto record = report::read_result(folder);
    if (record.interrupted && (record.hash == head.run.case_hash || record.hash == run.case_hash)) {
        return true;
    }
    if (!report::ResultFiles(folder).listed().contains(kept_checkpoint)) {
        return false;
    }
    kept_in(folder, run);
    return true;
}

bool holds_stopped(const fs::path& folder, const fem::RunMark& run)
{
    const auto record = report::read_result(folder);
    return record.interrupted && record.hash == run.case_hash;
}

}  // namespace

void add_checkpoint_options(CLI::App& command, CheckpointOptions& options)
{
    command.add_flag(
        "--resume", options.resume,
        "continue a stopped run from DIR.checkpoint, or the finished run in DIR if the operation is longer now; "
        "without either, start at the beginning");
    command
        .add_option(
            "--checkpoint", options.interval,
            "wall time between two checkpoints; 0: none, also not in the results; step: one after each time step")
        ->type_name("TIME")
        ->capture_default_str();
}

fs::path checkpoint_of(const fs::path& folder)
{
    auto path = folder.lexically_normal();
    if (!path.has_filename()) {
        path = path.parent_path();
    }
    return path += ".checkpoint";
}

bool plan_checkpoints(const CheckpointOptions& options, const fs::path& folder, bool force, const casefile::Case& input,
                      bool first, full::RunOptions& wanted)
{
    const double interval = interval_of(options.interval);
    if (casefile::wanted_accuracy(input)) {
        if (options.resume) {
            throw InputError("a run that refines its parts writes no checkpoints, so there is none to continue from\n"
                             "  help: leave --resume out, or give the sizes that are known and no accuracy");
        }
        return false;
    }
    const auto file = checkpoint_of(folder);
    const bool there = fs::exists(fs::symlink_status(file));
    if (there && !options.resume) {
        require_discardable(file, force);
    }
    wanted.checkpoint_interval = interval;
    if (there || std::isfinite(interval)) {
        wanted.checkpoint_file = file.string();
    }
    if (!options.resume) {
        return false;
    }
    const auto run = full::run_mark(input);
    if (there) {
        wanted.resume_from = file.string();
    } else if (is_result(folder) && !holds_stopped(folder, run)) {
        wanted.resume_from = kept_in(folder, run).string();
    } else {
        say(first, fmt::format("there is no {}: starting at the beginning", file.string()));
        return false;
    }
    const auto head = fem::checkpoint_head(wanted.resume_from, run);
    const bool replaces = !force && replaces_results(folder, head, run);
    say(first, fmt::format("continuing from {}, t = {:.2f} h", wanted.resume_from, head.time / 3600));
    return replaces;
}

bool keeps_checkpoints(const full::RunOptions& wanted)
{
    return !wanted.checkpoint_file.empty() && std::isfinite(wanted.checkpoint_interval);
}
