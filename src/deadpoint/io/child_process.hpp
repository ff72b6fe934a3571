#pragma once

#include <cstddef>
#include <functional>
#include <string>

namespace deadpoint {

/// What a child process may use.
struct ChildLimits {
    std::size_t memory = 0;  ///< beyond what this process has mapped already [byte]
    double seconds = 0;      ///< of wall time [s]
    std::string file = {};   ///< the only one that it may read; none if empty
    std::string name = {};   ///< what it opens the file as: "part.step"
};

/// Runs `work` in a child process and returns its bytes, so that code that is not ours can crash, hang, fill the memory
/// or obey a file without harm to this process and this machine: the child is confined (confine.hpp). It sees this
/// process's memory as it is now and changes nothing of it; threads do not go with it.
///
/// @param what     begins the error messages: "part 'frame': reading 'frame.step'"
/// @param waiting  called about once a second with the seconds since the start, in this process
/// @throws InputError if the child was ended by a signal, asked for what a reader does not need, ran out of memory or
///         time, or failed with an error not ours; an error of ours thrown by `work` comes back as it is
/// @throws IoError if no child can be started or confined
std::string run_in_child(const std::string& what, const ChildLimits& limits, const std::function<std::string()>& work,
                         const std::function<void(double)>& waiting = {});

/// Half of the machine's memory [byte].
std::size_t half_of_memory();

}  // namespace deadpoint
