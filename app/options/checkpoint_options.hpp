#pragma once

#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/full/run/run.hpp"

#include <CLI/CLI.hpp>
#include <filesystem>
#include <string>

/// Checkpoints of a run, in FOLDER.checkpoint beside its result folder.
struct CheckpointOptions {
    std::string interval = "10 min";  ///< wall time from one to the next, "step" or "0"
    bool resume = false;
};

/// Adds --checkpoint and --resume.
void add_checkpoint_options(CLI::App& command, CheckpointOptions& options);

/// The checkpoint of the run that fills a folder of results.
std::filesystem::path checkpoint_of(const std::filesystem::path& folder);

/// Sets the checkpoints of a run, and says on the first rank where it starts. If it continues, the
/// file has been checked except for its mesh and start. The kept one is left to the caller.
/// @param force  true if an existing checkpoint may be lost
/// @return whether the run continues one whose results in the folder it may replace: those up to a stop, or of a
/// finished run with a shorter operation, whose history begins with it
/// @throws InputError, IoError on all ranks alike
bool plan_checkpoints(const CheckpointOptions& options, const std::filesystem::path& folder, bool force,
                      const deadpoint::casefile::Case& input, bool first, deadpoint::full::RunOptions& wanted);

/// Whether a run saves its state as plan_checkpoints() has set it.
bool keeps_checkpoints(const deadpoint::full::RunOptions& wanted);
