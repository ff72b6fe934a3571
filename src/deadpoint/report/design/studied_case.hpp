#pragma once

#include <string>
#include <vector>

namespace deadpoint::casefile {
struct StudyFile;
}

namespace deadpoint::report {

/// A study on a reduced model that was computed, as all its files name it.
struct StudiedCase {
    const casefile::StudyFile& study;
    std::string machine;        ///< name of the case
    std::string hash;           ///< of the case with the settings of the study
    std::string reduced_model;  ///< name of its file
    double seconds = 0;         ///< wall time
};

/// The comment lines before its tables.
std::vector<std::string> comments_of(const StudiedCase& studied, const std::vector<std::string>& warnings);

}  // namespace deadpoint::report
