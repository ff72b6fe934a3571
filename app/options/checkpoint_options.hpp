#pragma once

#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/study/pipeline/run.hpp"

#include <CLI/CLI.hpp>
#include <filesystem>
#include <string>

/// How a run keeps itself on disk while it lasts, in FOLDER.checkpoint beside its folder of results.
struct CheckpointOptions {
    std::string interval = "10 min";  ///< wall time from one to the next, "step" or "0"
    bool resume = false;
};

/// Adds --checkpoint and --resume.
void add_checkpoint_options(CLI::App& command, CheckpointOptions& options);

/// The checkpoint of the run that fills a folder of results.
std::filesystem::path checkpoint_of(const std::filesystem::path& folder);

/// Sets the checkpoints of a run, and says on the first rank where it starts. Where it goes on, the file has been
/// checked, but for its mesh and start.
/// @param force  whether a checkpoint that is there may be lost
/// @throws InputError, IoError on all ranks alike
void plan_checkpoints(const CheckpointOptions& options, const std::filesystem::path& folder, bool force,
                      const deadpoint::casefile::Case& input, bool first, deadpoint::study::RunOptions& wanted);

/// Whether a folder holds the results of this case up to an interruption, which a resumed run may replace.
bool holds_interrupted(const std::filesystem::path& folder, const deadpoint::casefile::Case& input);
