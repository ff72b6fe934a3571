#pragma once

#include "deadpoint/io/file_lock.hpp"
#include "ranks/ranks.hpp"

#include <filesystem>
#include <optional>
#include <string>

namespace deadpoint::casefile {
struct Case;
}
namespace deadpoint::full {
struct ReduceOptions;
}
namespace deadpoint::twin {
struct Reduction;
}

/// Behaviour if a build of the same file was stopped before.
enum class StoppedBuild { refuse, resume, discard };

/// By --resume and --force.
StoppedBuild stopped_build(bool resume, bool force);

/// The files of a reduced press that is being built: press.rom, press.large.rom, press.fields.rom, and until they are
/// there press.rom.checkpoint, a folder with what the build has finished.
class BuildFolder {
public:
    /// Takes the lock, and makes the folder. Says on the first rank where the build starts. All ranks call it.
    /// @throws IoError if another process builds this file, if it cannot be written, if a finished press or a stopped
    ///         build is there that must be asked for, or a file that is neither; InputError if that is of another case
    ///         or version
    BuildFolder(const std::string& file, StoppedBuild stopped, const deadpoint::casefile::Case& input, Ranks& ranks);
    [[nodiscard]] std::string checkpoint() const { return checkpoint_.string(); }
    /// Writes the reduced press, tells about it and removes the folder; without one, says how to go on.
    /// @param command  that continues the build  @return exit code
    int finish(std::optional<deadpoint::twin::Reduction> reduction, const deadpoint::full::ReduceOptions& options,
               const std::string& command, Ranks& ranks) const;

private:
    std::filesystem::path file_, checkpoint_;
    std::optional<deadpoint::FileLock> lock_;
};

/// Full runs to compare with, if nothing else is asked for: the case itself, and one with drawn coefficients.
inline constexpr int usual_full_runs = 2;

/// What to ask the library for: as the case says, with all processors.
deadpoint::full::ReduceOptions wanted_reduction(const deadpoint::casefile::Case& input, int full_runs);
