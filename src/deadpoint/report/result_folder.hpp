#pragma once

#include <filesystem>

namespace deadpoint::report {

/// A folder of results that appears under its name only when it is complete.
///
/// Files are written to path(), a new folder "<target>.partial-XXXXXX" beside the target; commit() gives it the
/// target's name. Without commit() the partial folder is removed with the object, unless keep_partial() was called. A
/// process that is killed leaves the partial folder, whose name says what it is.
class ResultFolder {
public:
    enum class IfExists { refuse, replace };

    /// Creates the partial folder, and missing parents of the target.
    /// @throws IoError if the target exists and may not be replaced, if it exists and is no folder, or if the folder
    ///         cannot be created
    explicit ResultFolder(const std::filesystem::path& target, IfExists if_exists = IfExists::refuse);
    ~ResultFolder();
    ResultFolder(const ResultFolder&) = delete;
    ResultFolder& operator=(const ResultFolder&) = delete;

    /// Where to write.
    [[nodiscard]] const std::filesystem::path& path() const { return partial_; }
    [[nodiscard]] const std::filesystem::path& target() const { return target_; }
    /// Lists the files (result_files.hpp) unless that was done, and renames the partial folder to the target. What
    /// stood there is removed only after that has succeeded.
    /// @throws IoError if the target appeared in the meantime or renaming fails; the results then stay in path()
    void commit();
    /// Leaves the partial folder on disk if commit() is not reached.
    void keep_partial() { keep_ = true; }

private:
    std::filesystem::path target_;
    std::filesystem::path partial_;
    IfExists if_exists_;
    bool keep_ = false;
};

}  // namespace deadpoint::report
