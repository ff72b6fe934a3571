#pragma once

#include "console.hpp"
#include "deadpoint/report/folder/result_folder.hpp"

#include <filesystem>
#include <functional>
#include <memory>
#include <string>

/// Work that all ranks do together.
struct OnRanks {
    Console& console;  ///< silent on all ranks but the first
    bool first = true;
    /// Whether an error met from here on is met by all ranks alike. Work sets it to false where one may meet it alone.
    bool& agree;
};

/// Opens MPI, lets the work run on every rank and returns its exit code. An error that all meet is shown by the first;
/// one that a single rank may have met ends them all, since the others would wait for it for ever.
int on_ranks(Console::Options options, const std::function<int(const OnRanks&)>& work);

/// Work that only the first rank does, with files. Its IoError becomes that of all ranks.
void on_first_rank(bool first, const std::function<void()>& work);

/// Starts a result folder on the first rank. All ranks get its path, or the same error.
std::string start_folder(bool first, const std::function<std::unique_ptr<deadpoint::report::ResultFolder>()>& start,
                         std::unique_ptr<deadpoint::report::ResultFolder>& folder);
