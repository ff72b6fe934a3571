#pragma once

#include "deadpoint/io/csv_style.hpp"

#include <filesystem>

/// Tables of a result folder in the style that its user asked for.
///
/// Comment lines that leave a table go to tables.json beside it, so that the readers of this program lose nothing.
namespace deadpoint::report {

/// Changes the style of all tables of a folder and lists them again. Does nothing for CsvStyle::comments.
/// points.csv of a study stays as it is: a continued study appends to it.
/// @throws IoError if a file cannot be read or written
void style_tables(const std::filesystem::path& folder, CsvStyle style);

}  // namespace deadpoint::report
