#pragma once

#include <string>

/// Confines a process to computing and reading one file, for foreign code that reads foreign files.
namespace deadpoint {

/// A refused call of a confined process, in memory that parent and child share.
struct Refusal {
    int call = -1;                   ///< number of the system call, -1: none
    char path[256] = {};             ///< of the file that it wanted to open; empty for another call
    static constexpr int none = -1;  ///< no call was refused
};

/// Rights of a confined process.
struct Confinement {
    std::string file;            ///< the only one that it may read; none if empty
    std::string name;            ///< name under which it opens the file, for any real name: "part.msh"
    int to = -1;                 ///< the only descriptor that it may write to, apart from standard output and error
    Refusal* refusal = nullptr;  ///< where a refused call is noted
};

/// Afterwards this process can only read `file`, write to `to`, compute and end. The kernel
/// (seccomp) refuses all other calls: to open, make, change or remove a file, to start a program,
/// process or thread, or to send data. A call that no reader needs ends the process by SIGSYS and
/// is noted in `refusal`; a search for another file finds nothing. The confinement cannot be
/// undone, and all other open files are closed.
/// @throws IoError if the file cannot be opened, or if this kernel has no such filters
void confine(const Confinement& confinement);

/// The name of a system call: "execve".
std::string name_of_call(int number);

}  // namespace deadpoint
