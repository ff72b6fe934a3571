#pragma once

#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/casefile/syntax/file_access.hpp"
#include "deadpoint/diagnostic.hpp"

#include <filesystem>
#include <string>
#include <vector>

/// Internal to api/: a case file with all its mistakes, as data.
namespace deadpoint {

struct ReadOptions;

struct CheckedCase {
    casefile::Case value;                      ///< invalid if there are errors
    std::vector<Diagnostic> diagnostics;       ///< errors and warnings
    std::vector<std::string> warnings;         ///< as texts for a person
    std::string errors;                        ///< all errors as text for a person; empty: none
    std::vector<std::filesystem::path> files;  ///< the case's own, those it includes, STEP and mesh files
};

casefile::FileAccess access_of(const ReadOptions& options);

/// @throws IoError if the file cannot be read
CheckedCase read_with_diagnostics(const std::filesystem::path& file, const ReadOptions& options);

/// @throws InputError if a factor on cell sizes is not between 0.01 and 100, the limits of the command line
void require_scale(double scale);

}  // namespace deadpoint
