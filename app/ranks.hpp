#pragma once

#include "console.hpp"
#include "deadpoint/report/folder/result_folder.hpp"

#include <filesystem>
#include <functional>
#include <memory>
#include <string>

/// Context of work that all ranks do together.
struct OnRanks {
    Console& console;  ///< silent on all ranks but the first
    bool first = true;
    /// True if all ranks find the same errors from here on. Work sets it to false where a single
    /// rank may find an error.
    bool& agree;
};

/// Opens MPI, lets the work run on every rank and returns its exit code. The first rank shows an
/// error that all ranks find. An error that a single rank may have found ends all ranks, since the
/// others would wait forever.
int on_ranks(Console::Options options, const std::function<int(const OnRanks&)>& work);

/// Work that only the first rank does, with files. Its IoError becomes that of all ranks.
void on_first_rank(bool first, const std::function<void()>& work);

/// Starts a result folder on the first rank. All ranks get its path, or the same error.
std::string start_folder(bool first, const std::function<std::unique_ptr<deadpoint::report::ResultFolder>()>& start,
                         std::unique_ptr<deadpoint::report::ResultFolder>& folder);
