#include "deadpoint/report/folder/result_folder.hpp"

#include "deadpoint/core/names/unique_name.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/io/plain_reason.hpp"
#include "deadpoint/io/rename.hpp"
#include "deadpoint/io/write_file.hpp"
#include "deadpoint/report/folder/result_files.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fmt/format.h>
#include <string>
#include <sys/stat.h>
#include <system_error>

namespace deadpoint::report {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const char* what, const fs::path& path, const std::string& reason)
{
    throw IoError(fmt::format("cannot {} '{}': {}\n  help: check that the folder above it exists, that you may write "
                              "there, and that the disk has room",
                              what, path.string(), reason));
}

/// A new, empty folder whose name begins with `prefix`.
fs::path make_unique_folder(const std::string& prefix)
{
    for (;;) {
        fs::path folder = unique_name(prefix);
        if (mkdir(folder.c_str(), 0777) == 0) {
            return folder;
        }
        if (errno != EEXIST) {
            fail("create the folder", folder, std::strerror(errno));
        }
    }
}

void sync(const fs::path& path)
{
    if (!sync_to_disk(path)) {
        fail("put on the disk", path, std::strerror(errno));
    }
}

/// Writes all files of a folder to the disk: results that have their name must survive a power failure.
/// @throws IoError
void sync_folder(const fs::path& folder)
{
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        sync(entry.path());
    }
    sync(folder);
}

bool lies_in(const fs::path& file, const fs::path& folder)
{
    const auto whole = fs::weakly_canonical(file), above = fs::weakly_canonical(folder);
    return std::ranges::mismatch(above, whole).in1 == above.end();
}

/// Whether a name is taken, by a link too.
bool is_there(const fs::path& path)
{
    std::error_code error;
    return fs::exists(fs::symlink_status(path, error));
}

bool is_taken(const std::error_code& error)
{
    return error == std::errc::file_exists || error == std::errc::directory_not_empty ||
           error == std::errc::not_a_directory;
}

/// @throws IoError that begins with `what` unless deadpoint wrote the folder and all that is in it
void require_own(const fs::path& folder)
{
    const auto refuse = [&](const std::string& reason, const char* help) {
        throw IoError(fmt::format("the folder '{}' is not replaced: {}\n  help: {}", folder.string(), reason, help));
    };
    constexpr const char* remove_yourself = "give another name with -o, or remove that folder yourself";
    try {
        const ResultFiles files(folder);
        if (const auto foreign = foreign_files(folder); !foreign.empty()) {
            refuse(fmt::format("it holds '{}', which deadpoint did not write", foreign.front().string()),
                   "move such files elsewhere, or give another name with -o");
        }
        for (const auto& [name, listed] : files.listed()) {
            if (fs::exists(folder / name)) {
                files.check(name);
            }
        }
    } catch (const InputError& error) {
        const std::string reason = error.what();
        refuse(reason.substr(0, reason.find('\n')), remove_yourself);
    } catch (const fs::filesystem_error& error) {
        refuse(plain_reason(error), remove_yourself);
    }
}

}  // namespace

ResultFolder::ResultFolder(FolderClaim claim, IfExists if_exists, std::vector<fs::path> inputs)
    : claim_(std::move(claim)), if_exists_(if_exists), inputs_(std::move(inputs))
{
    if (is_there(target())) {
        require_replaceable();
    }
    partial_ = make_unique_folder(partial_prefix(target()));
    try {
        mark_unfinished(partial_);
    } catch (...) {
        std::error_code ignored;
        fs::remove_all(partial_, ignored);
        throw;
    }
}

ResultFolder::~ResultFolder()
{
    if (!partial_.empty() && !keep_) {
        std::error_code ignored;
        fs::remove_all(partial_, ignored);
    }
}

void ResultFolder::refuse_existing() const
{
    throw IoError(fmt::format("the folder '{}' exists already and is not overwritten\n"
                              "  help: give another name with -o, or replace it with --force",
                              target().string()));
}

void ResultFolder::require_replaceable() const
{
    if (!fs::is_directory(fs::symlink_status(target()))) {
        throw IoError(fmt::format("'{}' exists and is not a folder\n  help: give another name for the results",
                                  target().string()));
    }
    if (if_exists_ == IfExists::refuse) {
        refuse_existing();
    }
    if (is_study(target())) {
        throw IoError(
            fmt::format("the folder '{}' holds a study, which no single result replaces\n  help: give another "
                        "name with -o",
                        target().string()));
    }
    for (const auto& input : inputs_) {
        if (lies_in(input, target())) {
            throw IoError(
                fmt::format("the folder '{}' holds '{}', from which its results would be computed, and is not "
                            "replaced\n  help: give another name with -o",
                            target().string(), input.string()));
        }
    }
    if (!fs::is_empty(target())) {
        require_own(target());
    }
}

void ResultFolder::commit()
{
    keep_ = true;  // from here on the results are complete and must not be lost
    try {
        if (!is_whole(partial_)) {
            write_manifest(partial_);
        }
        sync_folder(partial_);
        take_name();
    } catch (const std::exception& error) {
        if (partial_.empty()) {
            throw;
        }
        partial_ = rename_uniquely(partial_, kept_prefix(target()));
        throw IoError(fmt::format("{}\n  the results are in '{}'", plain_reason(error), partial_.string()));
    }
}

void ResultFolder::take_name()
{
    auto error = rename_to_new(partial_, target());
    if (!is_taken(error) && error) {
        fail("write", target(), error.message());
    }
    if (error) {
        require_replaceable();
        replace();
        return;
    }
    partial_.clear();
    sync(folder_above(target()));
}

void ResultFolder::replace()
{
    const auto error = exchange_names(partial_, target());
    if (error == std::errc::invalid_argument) {
        replace_in_two_steps();
        return;
    }
    if (error) {
        fail("replace", target(), error.message());
    }
    const auto old = std::exchange(partial_, {});
    try {
        sync(folder_above(target()));
    } catch (const IoError& failure) {
        throw IoError(fmt::format("{}\n  the new results are in place; the previous ones are in '{}'", failure.what(),
                                  rename_uniquely(old, kept_prefix(target())).string()));
    }
    drop(rename_uniquely(old, replaced_prefix(target())));
}

// Where the file system cannot swap names. Killed in between, the next claim gives the old results their name back.
void ResultFolder::replace_in_two_steps()
{
    const auto old = rename_uniquely(target(), replaced_prefix(target()));
    if (old == target()) {
        fail("replace", target(), "it cannot be renamed");
    }
    if (const auto error = rename_to_new(partial_, target())) {
        (void)rename_to_new(old, target());
        fail("write", target(), error.message());
    }
    partial_.clear();
    sync(folder_above(target()));
    drop(old);
}

// Something may have been added since the check.
void ResultFolder::drop(const fs::path& old)
{
    std::error_code error;
    if (fs::remove(old, error) && !error) {  // it was empty
        return;
    }
    if (!remove_written(old)) {
        claim_.note(fmt::format("'{}' was replaced; what deadpoint did not write there, or could not remove, is in "
                                "'{}'",
                                target().string(), old.string()));
    }
}

}  // namespace deadpoint::report
