#pragma once

#include "console.hpp"
#include "deadpoint/casefile/syntax/file_access.hpp"
#include "deadpoint/io/csv_style.hpp"

#include <chrono>
#include <memory>
#include <string>

namespace CLI {
class App;
}
namespace deadpoint::casefile {
struct Case;
struct ReadResult;
struct StudyFile;
}  // namespace deadpoint::casefile
namespace deadpoint::report {
class ResultFolder;
struct StudiedCase;
}  // namespace deadpoint::report

/// Options that the studies on a reduced model share.
struct DesignOptions {
    std::string study;
    std::string folder;
    std::string reduced;
    int jobs = 0;
    bool force = false;
    deadpoint::CsvStyle tables = deadpoint::CsvStyle::comments;
    deadpoint::casefile::FileAccess files = deadpoint::casefile::FileAccess::below;
    Console::Options console;
    /// By --jobs, or as many as cores.
    [[nodiscard]] int threads() const;
};

/// @param section  of the study file that the command needs
/// @param jobs     help of --jobs
void add_design_options(CLI::App& command, DesignOptions& options, const std::string& section, const std::string& jobs);

/// The base case of a study; shows its warnings. @throws as read_case()
deadpoint::casefile::ReadResult read_base(const DesignOptions& options, const deadpoint::casefile::StudyFile& study,
                                          Console& console);

/// Begins the folder of results that read these. @throws IoError as ResultFolder
std::unique_ptr<deadpoint::report::ResultFolder>
begin_folder(const DesignOptions& options, const deadpoint::casefile::ReadResult& base, Console& console);

/// What a computed study names in its files. @param start  when it began
deadpoint::report::StudiedCase studied_case(const DesignOptions& options, const deadpoint::casefile::StudyFile& study,
                                            const deadpoint::casefile::Case& base,
                                            std::chrono::steady_clock::time_point start);

/// Says where the results are.
void print_design(const std::string& text, const DesignOptions& options);
