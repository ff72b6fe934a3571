#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace deadpoint::report {
class ResultFolder;
}
namespace deadpoint::full {
class Press;
}
namespace deadpoint::press {
struct RunResult;
}

/// Internal to api/: the result folder of a run.
namespace deadpoint {

class Listener;
struct RunOptions;

class ResultWriter {
public:
    /// Claims and starts the folder on the first rank, if one is requested. Collective.
    /// @param inputs  files of the user; a folder that holds one of them is never replaced
    /// @throws InputError, IoError on all ranks alike
    ResultWriter(const RunOptions& options, const std::vector<std::filesystem::path>& inputs);
    ~ResultWriter();

    /// Meshes and runs a press; the first rank writes the same files as `deadpoint run` and gives the folder its name.
    /// @param reading   warnings of reading the case
    /// @param listener  has all warnings of the files afterwards
    press::RunResult run(full::Press& press, const std::vector<std::string>& reading, Listener& listener);
    /// Folder of the finished results; empty: none were wanted.
    [[nodiscard]] std::string folder() const { return wanted_folder_.string(); }

private:
    std::filesystem::path wanted_folder_;
    std::string start_from_;
    std::string path_;                              ///< where to write, on all ranks
    std::unique_ptr<report::ResultFolder> folder_;  ///< on the first rank
};

}  // namespace deadpoint
