#include "options/checkpoint_options.hpp"

#include "deadpoint/casefile/describe/accuracy.hpp"
#include "deadpoint/casefile/files/write.hpp"
#include "deadpoint/core/quantity.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/fem/conduction/checkpoint.hpp"
#include "deadpoint/io/binary_file.hpp"
#include "deadpoint/report/folder/read_result.hpp"
#include "deadpoint/study/pipeline/run_record.hpp"
#include "output.hpp"

#include <cmath>
#include <fmt/format.h>
#include <limits>

using namespace deadpoint;
namespace fs = std::filesystem;

namespace {

/// Of --checkpoint [s]; infinite: none.
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

}  // namespace

void add_checkpoint_options(CLI::App& command, CheckpointOptions& options)
{
    command.add_flag(
        "--resume", options.resume,
        "continue from the checkpoint DIR.checkpoint of a stopped run; without one, start at the beginning");
    command
        .add_option("--checkpoint", options.interval,
                    "wall time between two checkpoints; 0: none, step: one after each time step")
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

void plan_checkpoints(const CheckpointOptions& options, const fs::path& folder, bool force, const casefile::Case& input,
                      bool first, study::RunOptions& wanted)
{
    const double interval = interval_of(options.interval);
    if (casefile::wanted_accuracy(input)) {
        if (options.resume) {
            throw InputError("a run that refines its parts writes no checkpoints, so there is none to continue from\n"
                             "  help: leave --resume out, or give the sizes that are known and no accuracy");
        }
        return;
    }
    const auto file = checkpoint_of(folder).string();
    const bool there = fs::exists(file);
    if (there && !options.resume && !force) {
        throw IoError(fmt::format("'{}' is the checkpoint of a run that was stopped\n  help: continue from it with "
                                  "--resume, or discard it with --force",
                                  file));
    }
    wanted.resume = there && options.resume;
    if (wanted.resume) {
        fem::CheckpointHead head;
        fem::open_checkpoint(file, casefile::case_hash(input), head);
        if (first) {
            print_out("continuing from {}, t = {:.2f} h\n", file, head.time / 3600);
        }
    } else if (options.resume && first) {
        print_out("there is no {}: starting at the beginning\n", file);
    }
    flush_out();
    if (wanted.resume || std::isfinite(interval)) {
        wanted.checkpoint_file = file;
    }
    wanted.checkpoint_interval = interval;
}

bool holds_interrupted(const fs::path& folder, const casefile::Case& input)
{
    if (!fs::exists(folder / "summary.json")) {
        return false;
    }
    const auto record = report::read_result(folder);
    return record.interrupted && record.hash == casefile::case_hash(input);
}
