#pragma once

#include "deadpoint/io/file_lock.hpp"
#include "deadpoint/io/write_file.hpp"

#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

/// The names beside a folder of results, "results" say:
///
///     results.lock            held by the process that writes the folder or its checkpoint
///     results.partial-...     is being written; has no list of files (result_files.hpp) until it is whole
///     results.replaced-...    was replaced and will be removed
///     results.kept-...        complete, but could not get its name; never changed again
namespace deadpoint::report {

/// The exclusive right to write one result folder and its checkpoint, from the first check of
/// existing files to the last written file.
class FolderClaim {
public:
    /// Makes missing folders above, takes the lock, and cleans up after ended runs into this
    /// folder: it removes incomplete and replaced results, restores the name of a result that lost
    /// it, and keeps complete results.
    /// @throws IoError if another process holds the claim (which, on which host, since when), if the name is none for a
    ///         folder, or if nothing can be read or written there
    explicit FolderClaim(const std::filesystem::path& target);

    [[nodiscard]] const std::filesystem::path& target() const { return target_; }
    /// Messages for the user about leftovers found since the last call.
    [[nodiscard]] std::vector<std::string> take_notes() { return std::exchange(notes_, {}); }
    void note(std::string text) { notes_.push_back(std::move(text)); }

private:
    void tidy();
    void tidy_partial(const std::filesystem::path& folder);
    void tidy_replaced(const std::filesystem::path& folder);

    std::filesystem::path target_;
    std::unique_ptr<FileLock> lock_;
    std::vector<std::string> notes_;
};

/// Prefixes of the unique names of folders beside a target.
std::string partial_prefix(const std::filesystem::path& target);
std::string replaced_prefix(const std::filesystem::path& target);
std::string kept_prefix(const std::filesystem::path& target);

/// True if a folder has a list of its files, and is therefore complete. @throws IoError if the list
/// cannot be read
bool is_whole(const std::filesystem::path& folder);

/// Marks a new folder as one that deadpoint writes, until write_manifest() marks it as complete.
/// @throws IoError
void mark_unfinished(const std::filesystem::path& folder);

/// Gives a folder the first name that is free of those that begin with `prefix`. @return it; `folder` itself if that
/// fails
std::filesystem::path rename_uniquely(const std::filesystem::path& folder, const std::string& prefix);

/// Removes the files that a folder's list names, then empty folders. Files that deadpoint did not
/// write stay. @return true if the folder is gone
bool remove_written(const std::filesystem::path& folder);

/// The parent folder of a path; "." for a bare name.
std::filesystem::path folder_above(const std::filesystem::path& path);

/// What a command may do that writes a file for the user. Files of results are never replaced, the list least of all.
/// Page and comparison of a folder (report.html, compare.*) are made anew if `renews`, as long as they are as deadpoint
/// wrote them. Any other file is replaced by force only.
/// @param renews  the user has given no name
/// @throws IoError that names the file and what to do, if it must stay
IfThere if_there(const std::filesystem::path& file, bool force, bool renews = false);

}  // namespace deadpoint::report
