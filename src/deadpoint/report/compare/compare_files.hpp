#pragma once

#include "deadpoint/io/write_file.hpp"

#include <array>
#include <filesystem>
#include <string>
#include <vector>

namespace deadpoint::press {
struct RunRecord;
struct Comparison;
}  // namespace deadpoint::press

/// A comparison as files and as text for the terminal.
namespace deadpoint::report {

/// Tables of values, curves and claims, for the terminal.
std::string compare_text(const press::RunRecord& run, const press::Comparison& comparison);

/// The same as a page of Markdown. @param charts  names of the drawings that it shows
std::string compare_page(const press::RunRecord& run, const press::Comparison& comparison,
                         const std::vector<std::string>& charts = {});

/// What write_compare_files() adds to its stem.
inline constexpr std::array<const char*, 4> compare_endings{".json", ".md", "-temperatures.svg", "-chain.svg"};

/// Writes `stem`.json and `stem`.md; the first also holds every point of every curve. Draws computed over measured
/// values in `stem`-temperatures.svg and `stem`-chain.svg, where there are some.
/// @throws IoError if a file cannot be written
void write_compare_files(const std::filesystem::path& stem, const press::RunRecord& run,
                         const press::Comparison& comparison, IfThere if_there = IfThere::replace);

}  // namespace deadpoint::report
