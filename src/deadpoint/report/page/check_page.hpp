#pragma once

#include "deadpoint/diagnostic.hpp"
#include "deadpoint/io/write_file.hpp"

#include <filesystem>
#include <vector>

namespace deadpoint::casefile {
struct Case;
}
namespace deadpoint::press {
struct CaseSketch;
}

/// One self-contained HTML page: the machine of a case in three dimensions before it is solved.
namespace deadpoint::report {

/// Writes the page; complete or absent.
/// @param found  mistakes and warnings of the check
/// @throws IoError if it cannot be written
void write_check_page(const std::filesystem::path& file, const casefile::Case& input, const press::CaseSketch& sketch,
                      const std::vector<Diagnostic>& found, IfThere if_there);
/// Whether a file is a page of deadpoint that nobody has changed. @throws IoError if it cannot be read
bool is_unchanged_page(const std::filesystem::path& file);

}  // namespace deadpoint::report
