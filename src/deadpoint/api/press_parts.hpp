#pragma once

#include "deadpoint/press.hpp"
#include "deadpoint/study/pipeline/press.hpp"

#include <filesystem>
#include <string>
#include <vector>

/// Internal to api/: the implementation of a public press.
namespace deadpoint {

struct Press::Implementation {
    study::Press press;
    std::filesystem::path file;  ///< that it was read from
    ReadOptions options;
    std::vector<Diagnostic> warnings;
    std::vector<std::string> reading;           ///< the same warnings as texts
    std::vector<std::filesystem::path> inputs;  ///< all files of the user that belong to it
};

/// @throws InputError where no Session is open
void require_session();

}  // namespace deadpoint
