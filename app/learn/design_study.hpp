#pragma once

#include "deadpoint/casefile/files/read.hpp"
#include "deadpoint/casefile/files/study_file.hpp"
#include "deadpoint/report/design/studied_case.hpp"
#include "deadpoint/study/reduce/reduced_press.hpp"
#include "options/result_options.hpp"

#include <chrono>
#include <string>

/// What the studies on a reduced model share: their options, what they read, and their folder.
struct DesignOptions {
    std::string study;
    std::string folder;
    std::string reduced;
    int jobs = 0;
    bool force = false;
    deadpoint::casefile::FileAccess files = deadpoint::casefile::FileAccess::below;
    Console::Options console;
    /// By --jobs, or as many as cores.
    [[nodiscard]] int threads() const;
};

/// @param section  of the study file that the command needs
/// @param jobs     help of --jobs
void add_design_options(CLI::App& command, DesignOptions& options, const std::string& section, const std::string& jobs);

/// A study that is about to be computed.
struct DesignStudy {
    /// Reads its files, shows the case's warnings and begins its folder. @throws as the readers and ResultFolder
    DesignStudy(const DesignOptions& options, deadpoint::casefile::StudyFile study, Console& console);

    deadpoint::casefile::StudyFile study;
    deadpoint::casefile::ReadResult read;
    deadpoint::study::ReducedPress press;
    deadpoint::report::ResultFolder folder;
    std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();

    /// For its files, now that it is computed.
    [[nodiscard]] deadpoint::report::StudiedCase studied(const DesignOptions& options) const;
};

/// Says where the results are.
void print_design(const std::string& text, const DesignOptions& options);
