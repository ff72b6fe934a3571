#pragma once

#include "deadpoint/io/write_file.hpp"

#include <filesystem>

namespace deadpoint::report {

/// Writes the page of a study: families of curves, the table of points, maps and windows, from
/// sweep.json and the folders of its points; complete or absent. Curves are thinned more if there
/// are more points. @throws InputError if a file cannot be parsed; IoError if one cannot be read or
/// the page not be written
void write_sweep_report(const std::filesystem::path& file, const std::filesystem::path& folder,
                        IfThere if_there = IfThere::replace);

}  // namespace deadpoint::report
