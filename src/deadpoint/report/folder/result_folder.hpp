#pragma once

#include "deadpoint/report/folder/folder_claim.hpp"

#include <filesystem>
#include <vector>

namespace deadpoint::report {

/// A folder of results that appears under its name only when it is complete.
///
/// Files are written to path(), a new folder "<target>.partial-..." beside the target; commit()
/// gives it the target's name. Without commit() the partial folder is removed with the object. A
/// process that is killed leaves the partial folder, which the next claim on the target removes.
class ResultFolder {
public:
    enum class IfExists { refuse, replace };

    /// Creates the partial folder.
    /// @param inputs  files of the user; a folder that holds one of them is never replaced
    /// @throws IoError if the target exists and may not be replaced, or if the folder cannot be
    /// created. Only an empty folder may be replaced, or one that holds only files that deadpoint
    /// wrote there
    explicit ResultFolder(FolderClaim claim, IfExists if_exists = IfExists::refuse,
                          std::vector<std::filesystem::path> inputs = {});
    ~ResultFolder();
    ResultFolder(const ResultFolder&) = delete;
    ResultFolder& operator=(const ResultFolder&) = delete;

    /// Where to write.
    [[nodiscard]] const std::filesystem::path& path() const { return partial_; }
    [[nodiscard]] const std::filesystem::path& target() const { return claim_.target(); }
    /// Messages of commit() about the replaced folder.
    [[nodiscard]] std::vector<std::string> take_notes() { return claim_.take_notes(); }
    /// Lists the files (result_files.hpp) if that was not done, writes everything to the disk and
    /// gives the partial folder the target's name. It never replaces a folder that may not be
    /// replaced, even one created a moment ago. The old folder is removed only after success.
    /// @throws IoError if the target may not be replaced or the disk fails; the results then stay in a folder
    ///         "<target>.kept-...", which the message names
    void commit();
    /// Leaves the folder to another process that has a copy of this object (fork).
    void disown() { partial_.clear(); }

private:
    void take_name();
    void replace();
    void replace_in_two_steps();
    void drop(const std::filesystem::path& old);
    void require_replaceable() const;
    [[noreturn]] void refuse_existing() const;

    FolderClaim claim_;
    std::filesystem::path partial_;
    IfExists if_exists_;
    std::vector<std::filesystem::path> inputs_;
    bool keep_ = false;
};

}  // namespace deadpoint::report
