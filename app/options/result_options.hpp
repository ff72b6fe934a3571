#pragma once

#include "deadpoint/report/folder/result_folder.hpp"
#include "options/case_options.hpp"

#include <memory>
#include <optional>

/// Options of all subcommands that write a result folder.
struct ResultOptions : CaseOptions {
    std::string folder;
    bool force = false;  ///< replace the folder if it exists
    deadpoint::CsvStyle tables = deadpoint::CsvStyle::comments;
};

/// The same for one segment of the operation.
struct SegmentOptions : ResultOptions {
    int segment = -1;  ///< from 0; -1: the command chooses
};

/// Adds the options of a case, --output, --force and --csv.
void add_result_options(CLI::App& command, ResultOptions& options);

/// Adds --segment to these.
void add_segment_options(CLI::App& command, SegmentOptions& options);

/// Claims a folder and reports leftovers of earlier runs on the console. @throws IoError as
/// FolderClaim
deadpoint::report::FolderClaim claim_folder(const std::filesystem::path& target, Console& console);

/// Claims the folder of results that a file is about to be added to; nothing for a file elsewhere, or where no run
/// could replace the folder. @throws IoError as FolderClaim
std::optional<deadpoint::report::FolderClaim> claim_folder_of(const std::filesystem::path& file, Console& console);

/// Starts the folder that the options name, for results of the case that was read. @throws IoError as ResultFolder
std::unique_ptr<deadpoint::report::ResultFolder>
start_folder(const ResultOptions& options, const deadpoint::casefile::ReadResult& read, Console& console);

/// Gives finished results their name, with tables in a style. @throws IoError as ResultFolder::commit()
void commit(deadpoint::report::ResultFolder& folder, deadpoint::CsvStyle tables, Console& console);
