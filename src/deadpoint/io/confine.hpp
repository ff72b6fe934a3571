#pragma once

#include <string>

/// A process that may compute and read one file, and nothing else: for code of others that reads files of others.
namespace deadpoint {

/// What a confined process asked for in vain; it lies in memory that parent and child share.
struct Refusal {
    int call = -1;                   ///< number of the system call, -1: none
    char path[256] = {};             ///< of the file that it wanted to open; empty for another call
    static constexpr int none = -1;  ///< no call was refused
};

/// What a confined process keeps.
struct Confinement {
    std::string file;            ///< the only one that it may read; none if empty
    std::string name;            ///< what it opens the file as, whatever the file is called: "part.msh"
    int to = -1;                 ///< the only descriptor that it may write to, apart from standard output and error
    Refusal* refusal = nullptr;  ///< where a refused call is noted
};

/// From here on this process can read `file`, write to `to`, compute and end. The kernel (seccomp) refuses all other
/// calls: to open, make, change or remove a file, to start a program, a process or a thread, to send anything anywhere.
/// What a reader does not need at all ends the process by SIGSYS, noted in `refusal`; to look for another file finds
/// nothing. It cannot be undone, and all other open files are closed.
/// @throws IoError if the file cannot be opened, or if this kernel has no such filters
void confine(const Confinement& confinement);

/// The name of a system call: "execve".
std::string name_of_call(int number);

}  // namespace deadpoint
