#pragma once

#include <string>
#include <vector>

/// How a program ended.
enum class ProgramEnd { done, failed, missing, too_long, stopped };

/// Starts a program that is searched in PATH, without input and without showing its text, and waits for its end. It
/// gets a process group of its own; whatever of the group is left afterwards is killed, so that nothing outlives this
/// call.
/// @param settings  of its environment, besides those of this process: "NAME=value"
/// @param seconds   after which it is killed (too_long); Ctrl-C kills it too (stopped)
ProgramEnd run_limited(const std::vector<std::string>& command, const std::vector<std::string>& settings,
                       double seconds);
