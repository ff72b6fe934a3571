#pragma once

#include "deadpoint/io/write_file.hpp"

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// One self-contained HTML page from result folders. It loads nothing from the network; a content
/// policy forbids it.
namespace deadpoint::report {

/// A folder that `deadpoint run` or `deadpoint loads` wrote, and its name on the page.
struct ReportSource {
    std::filesystem::path folder;
    std::string name;
};

/// The folders under their own names, made unique by the folders above where they are alike.
std::vector<ReportSource> report_sources(std::span<const std::filesystem::path> folders);

/// Writes the page; complete or absent. Long tables are thinned to about as many rows as a screen
/// has pixels. @throws InputError if a folder holds no results, or one of its files was changed or
/// cannot be parsed
/// @throws IoError    if a file cannot be read or the page cannot be written
void write_report(const std::filesystem::path& file, std::span<const ReportSource> sources,
                  IfThere if_there = IfThere::replace);

/// A CSV text (comments, header, rows) with at most so many rows, evenly chosen; the last row stays.
std::string thinned_csv(std::string_view text, std::size_t most_rows);

}  // namespace deadpoint::report
