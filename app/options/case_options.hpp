#pragma once

#include "console.hpp"
#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/casefile/files/read.hpp"
#include "deadpoint/casefile/syntax/file_access.hpp"
#include "deadpoint/full/run/press.hpp"
#include "deadpoint/io/csv_style.hpp"

#include <CLI/CLI.hpp>
#include <filesystem>
#include <string>
#include <vector>

/// Options of all subcommands that read a case.
struct CaseOptions {
    std::string path;
    std::vector<std::string> overrides;  ///< "path=value"
    double size_scale = 1;
    deadpoint::casefile::FileAccess files = deadpoint::casefile::FileAccess::below;
    Console::Options console;
};

/// Adds --quiet and --verbose.
void add_console_options(CLI::App& command, Console::Options& options);

/// Adds --csv.
void add_table_option(CLI::App& command, deadpoint::CsvStyle& style);

/// Adds --allow-outside.
void add_file_access(CLI::App& command, deadpoint::casefile::FileAccess& files);

/// Adds the case file, --set, --size, --quiet and --verbose.
void add_case_options(CLI::App& command, CaseOptions& options);

/// Reads the case; its warnings go to the console.
deadpoint::casefile::ReadResult read_case(const CaseOptions& options, Console& console);

/// All files that a case is made of: its own, those it includes, STEP and mesh files.
std::vector<std::filesystem::path> input_files(const deadpoint::casefile::ReadResult& read);

/// The mesh of a press, the stage "mesh" on the console.
/// @param kept  as full::Press::machine()
const deadpoint::Machine& mesh_parts(deadpoint::full::Press& press, Console& console,
                                     deadpoint::MeshedParts* kept = nullptr);

/// Lines for the head of every result file: version, case and hash, warnings.
std::vector<std::string> file_comments(const deadpoint::casefile::Case& description, const Console& console);
