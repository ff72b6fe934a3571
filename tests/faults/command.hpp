#pragma once

#include "../scratch_folder.hpp"

#include <cstdlib>
#include <filesystem>
#include <fmt/format.h>
#include <string>
#include <sys/wait.h>

namespace fs = std::filesystem;

struct Outcome {
    int code = -1;  ///< of the shell: 128 + signal where one ended the program
    std::string text;
};

/// Runs a line of shell; `before` stands before the program: settings of the environment, a launcher.
inline Outcome run(const std::string& before, const std::string& arguments)
{
    const ScratchFolder folder;
    const auto out = (folder.path / "out").string();
    const int status = std::system(
        fmt::format("{} {} {} >{} 2>&1 </dev/null; exit $?", before, DEADPOINT_COMMAND, arguments, out).c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, content(out)};
}

inline bool has(const std::string& text, const std::string& piece) { return text.find(piece) != std::string::npos; }

/// What stands before the program so that the disk is full after so many bytes, or kills it then.
inline std::string short_disk(long long room, bool kills)
{
    return fmt::format("env LD_PRELOAD={} DEADPOINT_DISK_ROOM={}{}", DEADPOINT_SHORT_DISK, room,
                       kills ? " DEADPOINT_DISK_KILLS=1" : "");
}

/// What stands before the program so that a call on a file below a folder fails (failing_calls.cpp).
inline std::string failing(const fs::path& below, const std::string& fault, const fs::path& counts = {})
{
    return fmt::format("env LD_PRELOAD={} DEADPOINT_FAULT_BELOW={} DEADPOINT_FAULT='{}' DEADPOINT_FAULT_COUNTS={}",
                       DEADPOINT_FAILING_CALLS, below.string(), fault, counts.string());
}

/// How many kills a test of them makes.
inline int kills()
{
    const char* wanted = std::getenv("DEADPOINT_KILLS");
    return wanted != nullptr ? std::atoi(wanted) : 12;
}
