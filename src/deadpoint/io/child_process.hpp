#pragma once

#include "deadpoint/error.hpp"

#include <cstddef>
#include <functional>
#include <string>

namespace deadpoint {

/// Limits of a child process.
struct ChildLimits {
    std::size_t memory = 0;  ///< beyond what this process has mapped already [byte]
    double seconds = 0;      ///< of wall time [s]
    std::string file = {};   ///< the only one that it may read; none if empty
    std::string name = {};   ///< what it opens the file as: "part.step"
};

/// A child process took longer than its limit.
struct TimeLimitError : InputError {
    using InputError::InputError;
};

/// The foreign code of a child process was stopped or stopped by itself.
struct StoppedChild : InputError {
    using InputError::InputError;
};
/// It crashed, ended the process, or threw an error of its own.
struct ForeignError : StoppedChild {
    using StoppedChild::StoppedChild;
};

/// Runs `work` in a child process and returns its bytes. Code of others may there crash, hang, fill
/// the memory or run commands of a file without harm to this process and this machine, since the
/// child is confined (confine.hpp). The child has a copy of this process's memory, and no other
/// threads.
///
/// @param what     begins the error messages: "part 'frame': reading 'frame.step'"
/// @param waiting  called about once a second with the seconds since the start, in this process
/// @throws InputError if the child made a forbidden call (StoppedChild), ran out of memory or time (TimeLimitError),
/// was ended by a signal or by exit(), or failed with a foreign error (ForeignError); a deadpoint error of `work` is
/// thrown again unchanged
/// @throws IoError if no child can be started or confined
std::string run_in_child(const std::string& what, const ChildLimits& limits, const std::function<std::string()>& work,
                         const std::function<void(double)>& waiting = {});

/// Half of the machine's memory [byte].
std::size_t half_of_memory();

}  // namespace deadpoint
