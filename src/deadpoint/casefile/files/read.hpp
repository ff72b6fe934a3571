#pragma once

#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/casefile/syntax/file_access.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace deadpoint::casefile {

struct ReadResult {
    Case value;
    std::vector<std::string> warnings;         ///< each with its place, as it would be shown for an error
    std::vector<std::filesystem::path> files;  ///< the case file and all it includes
};

/// Reads a case file with its includes, checks it, and fills in the shipped library.
///
/// It checks syntax, every key and its unit, ranges, and every name that refers to something else.
/// It does not check geometry. All mistakes are reported together.
///
/// @param path       the case file (TOML, format = 1)
/// @param overrides  "path=value", applied after reading: "operation.0.speed=400 rpm", "parts.link_9.size=8 mm"
/// @param files      allowed locations of STEP, mesh and included files
/// @return the case, in SI units; paths of STEP and mesh files are absolute
/// @throws CaseError whose text lists every mistake with file:line:column, the line and a remedy
/// @throws IoError if the case file cannot be read
ReadResult read_case(const std::filesystem::path& path, const std::vector<std::string>& overrides = {},
                     FileAccess files = FileAccess::below);

class Diagnostics;
struct Document;
/// As read_case, with the mistakes as data; the sources of the overrides are the last ones of the document.
/// @throws IoError if the case file cannot be read
Document read_case(const std::filesystem::path& path, const std::vector<std::string>& overrides, Case& value,
                   Diagnostics& diagnostics, FileAccess files = FileAccess::below);

}  // namespace deadpoint::casefile
