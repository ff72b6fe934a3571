#pragma once

#include "deadpoint/io/write_file.hpp"

#include <filesystem>
#include <string>

namespace deadpoint::study {

struct RunRecord;
struct Comparison;
}  // namespace deadpoint::study

/// A comparison as files and as text for the terminal.
namespace deadpoint::report {

/// Tables of values, curves and claims, for the terminal.
std::string compare_text(const study::RunRecord& run, const study::Comparison& comparison);

/// The same as a page of Markdown.
std::string compare_page(const study::RunRecord& run, const study::Comparison& comparison);

/// Writes `stem`.json and `stem`.md; the first also holds every point of every curve.
/// @throws IoError if a file cannot be written
void write_compare_files(const std::filesystem::path& stem, const study::RunRecord& run,
                         const study::Comparison& comparison, IfThere if_there = IfThere::replace);

}  // namespace deadpoint::report
