#pragma once

#include "deadpoint/io/file_lock.hpp"

#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

/// The names beside a folder of results, "results" say:
///
///     results.lock            held by the process that writes the folder or its checkpoint
///     results.partial-...     is being written; has no list of files (result_files.hpp) until it is whole
///     results.replaced-...    was replaced and is about to go
///     results.kept-...        whole, but could not get its name; never touched again
namespace deadpoint::report {

/// The sole right to write one folder of results and its checkpoint. It lasts from the first look at what is there to
/// the last file.
class FolderClaim {
public:
    /// Makes missing folders above, takes the lock, and tidies what runs into this folder have left that were ended:
    /// removes what is not whole and what was replaced, gives a result its name back that lost it in between, and keeps
    /// what is whole.
    /// @throws IoError if another process holds the claim (which, on which host, since when), if the name is none for a
    ///         folder, or if nothing can be read or written there
    explicit FolderClaim(const std::filesystem::path& target);

    [[nodiscard]] const std::filesystem::path& target() const { return target_; }
    /// What a user should know of what was found since the last call.
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

/// What unique names of the folders beside a target begin with.
std::string partial_prefix(const std::filesystem::path& target);
std::string replaced_prefix(const std::filesystem::path& target);
std::string kept_prefix(const std::filesystem::path& target);

/// Whether a folder has a list of its files, so that it is whole. @throws IoError if the list cannot be read
bool is_whole(const std::filesystem::path& folder);

/// Marks a new folder as one that deadpoint writes, until write_manifest() says that it is whole. @throws IoError
void mark_unfinished(const std::filesystem::path& folder);

/// Gives a folder the first name that is free of those that begin with `prefix`. @return it; `folder` itself if that
/// fails
std::filesystem::path rename_uniquely(const std::filesystem::path& folder, const std::string& prefix);

/// Removes the files that a folder's list names, then what has become empty. What deadpoint did not write stays.
/// @return whether all of it is gone
bool remove_written(const std::filesystem::path& folder);

/// Where a name is: the folder above, "." for a bare one.
std::filesystem::path folder_above(const std::filesystem::path& path);

}  // namespace deadpoint::report
