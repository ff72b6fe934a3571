#pragma once

#include <filesystem>

/// What of the machine this process may use. The limits of the process count (sched_setaffinity, control groups of a
/// container or a queue), not the machine alone.
namespace deadpoint {

/// Cores for work that keeps them busy: the processors that the process may run on, where two hyperthreads of one core
/// count once, and no more than its control groups give time for.
/// @param system  the folder with proc and sys
/// @return >= 1
int usable_cores(const std::filesystem::path& system = "/");

/// Memory that can be taken without ending other programs: what is free or holds caches, and no more than what is left
/// in the process's control groups [byte].
/// @param system  the folder with proc and sys
/// @return infinity if the system does not tell
double available_memory(const std::filesystem::path& system = "/");

/// Watches how many cores other programs keep busy. Ranks wait for each other all the time, so one that shares its core
/// holds up all.
class OtherLoad {
public:
    /// @param system  the folder with proc
    explicit OtherLoad(std::filesystem::path system = "/");
    /// Mean since the construction; waits until that is a quarter of a second ago. Of the processors on which this
    /// process may run.
    [[nodiscard]] double busy_cores() const;

private:
    std::filesystem::path system_;
    double start_, busy_, own_;  ///< [s]
};

}  // namespace deadpoint
