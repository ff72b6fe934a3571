#include "deadpoint/report/folder/folder_claim.hpp"

#include "deadpoint/core/names/unique_name.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/io/file_lock.hpp"
#include "deadpoint/io/rename.hpp"
#include "deadpoint/io/write_file.hpp"
#include "deadpoint/report/folder/json_file.hpp"
#include "deadpoint/report/folder/result_files.hpp"
#include "deadpoint/report/schema/schema.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <ranges>

namespace deadpoint::report {
namespace {

namespace fs = std::filesystem;

/// The name without "." and a slash at its end; a link to a folder is that folder. @throws IoError
fs::path normal_target(const fs::path& given)
{
    auto target = given.lexically_normal();
    if (!target.has_filename()) {
        target = target.parent_path();  // "results/" is "results"
    }
    if (target.empty() || target == "." || target == ".." || target.filename() == ".." || !target.has_filename()) {
        throw IoError(fmt::format("'{}' is no name for a new folder of results\n  help: give one with -o, for example "
                                  "-o results",
                                  given.string()));
    }
    std::error_code error;
    return fs::is_symlink(target, error) && fs::is_directory(target, error) ? fs::canonical(target) : target;
}

void make_folders_above(const fs::path& target)
{
    std::error_code error;
    fs::create_directories(folder_above(target), error);
    if (error) {
        throw IoError(fmt::format("cannot create the folder '{}': {}\n  help: check that the folder above it exists "
                                  "and that you may write there",
                                  folder_above(target).string(), error.message()));
    }
}

bool says_unfinished(const fs::path& folder)
{
    try {
        const auto json = read_json(folder / manifest_name);
        return json && json->is_object() && json->contains(unfinished_mark);
    } catch (const InputError&) {  // damaged by others, so it is not removed
        return false;
    }
}

/// Whether a folder holds nothing except the unfinished first file of a killed run.
bool is_hardly_begun(const fs::path& folder)
{
    const auto prefix = part_prefix(manifest_name);
    return std::ranges::all_of(fs::directory_iterator(folder), [&](const fs::directory_entry& entry) {
        return is_unique_name(entry.path().filename().string(), prefix);
    });
}

/// Names beside a path that begin with a prefix.
std::vector<fs::path> found(const std::string& prefix)
{
    std::vector<fs::path> result;
    const auto beginning = fs::path(prefix).filename().string();
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(folder_above(prefix), error)) {
        if (is_unique_name(entry.path().filename().string(), beginning) && !entry.is_symlink()) {
            result.push_back(entry.path());
        }
    }
    std::ranges::sort(result);
    return result;
}

/// @throws as ResultFiles, and if a folder cannot be read
void remove_listed(const fs::path& folder)
{
    const auto foreign = foreign_files(folder);
    std::vector<fs::path> all;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        if (std::ranges::find(foreign, entry.path()) == foreign.end() && entry.path() != folder / manifest_name) {
            all.push_back(entry.path());
        }
    }
    std::ranges::sort(all, std::greater<>{});  // the content of a folder comes before the folder
    all.push_back(folder / manifest_name);     // last, so that after a kill the remaining files are still listed
    all.push_back(folder);
    std::error_code ignored;  // a folder that is not empty stays
    for (const auto& path : all) {
        fs::remove(path, ignored);
    }
}

/// The folder of results that a file lies in or below; empty if there is none.
fs::path results_around(const fs::path& file)
{
    for (auto folder = file.parent_path(); folder.has_relative_path(); folder = folder.parent_path()) {
        if (is_whole(folder)) {
            return folder;
        }
    }
    return {};
}

/// Whether `report` or `compare` adds a file of this name to results.
bool is_added(const std::string& name)
{
    return std::ranges::any_of(schema::files(), [&](const schema::File& file) {
        return file.name == name && (file.written_by == "compare" || file.written_by.ends_with("report"));
    });
}

/// Whether a file is one of those that are added to results, as it was written. @throws IoError for other files of
/// results
bool is_added_and_unchanged(const fs::path& file)
{
    const auto whole = fs::weakly_canonical(folder_above(file)) / file.filename();
    const auto folder = results_around(whole);
    if (folder.empty()) {
        return false;
    }
    const auto name = whole.lexically_relative(folder).generic_string();
    const ResultFiles results(folder);
    const bool listed = results.listed().contains(name);
    if (name == manifest_name || (listed && !is_added(name))) {
        throw IoError(fmt::format("'{}' belongs to the results in '{}' and is not replaced\n  help: give another name",
                                  file.string(), folder.string()));
    }
    try {
        results.check(name);
        return true;
    } catch (const InputError&) {
        return false;
    }
}

}  // namespace

fs::path folder_above(const fs::path& path) { return path.has_parent_path() ? path.parent_path() : fs::path("."); }

std::string partial_prefix(const fs::path& target) { return target.string() + ".partial-"; }
std::string replaced_prefix(const fs::path& target) { return target.string() + ".replaced-"; }
std::string kept_prefix(const fs::path& target) { return target.string() + ".kept-"; }

bool is_whole(const fs::path& folder)
{
    std::error_code error;
    return fs::exists(folder / manifest_name, error) && !says_unfinished(folder);
}

void mark_unfinished(const fs::path& folder)
{
    write_json(folder / manifest_name,
               {{"written_by", "deadpoint"}, {"format", result_format}, {unfinished_mark, true}});
}

fs::path rename_uniquely(const fs::path& folder, const std::string& prefix)
{
    for (;;) {
        const fs::path name = unique_name(prefix);
        const auto error = rename_to_new(folder, name);
        if (error != std::errc::file_exists) {
            return error ? folder : name;
        }
    }
}

bool remove_written(const fs::path& folder)
{
    try {
        remove_listed(folder);
    } catch (const std::exception&) {
        // it stays
    }
    std::error_code ignored;
    return !fs::exists(fs::symlink_status(folder, ignored));
}

FolderClaim::FolderClaim(const fs::path& target) : target_(normal_target(target))
{
    make_folders_above(target_);
    lock_ = std::make_unique<FileLock>(target_.string() + ".lock",
                                       fmt::format("the folder '{}' is being written", target_.string()));
    if (lock_->held()) {
        tidy();
    } else {
        note(fmt::format("the file system of '{}' has no locks: start no second run into this folder",
                         target_.string()));
    }
}

void FolderClaim::tidy()
{
    std::ranges::for_each(found(replaced_prefix(target_)), [&](const auto& folder) { tidy_replaced(folder); });
    std::ranges::for_each(found(partial_prefix(target_)), [&](const auto& folder) { tidy_partial(folder); });
    std::error_code ignored;
    for (const auto& part : found(part_prefix(target_.string() + ".checkpoint"))) {
        fs::remove(part, ignored);
    }
}

void FolderClaim::tidy_partial(const fs::path& folder)
{
    std::error_code ignored;
    if (!fs::is_directory(folder, ignored)) {
        return;
    }
    if (is_whole(folder)) {
        note(fmt::format("complete results of a run that ended before it could rename them are in '{}'",
                         rename_uniquely(folder, kept_prefix(target_)).string()));
    } else if (says_unfinished(folder) || is_hardly_begun(folder)) {
        fs::remove_all(folder, ignored);
    }
}

void FolderClaim::tidy_replaced(const fs::path& folder)
{
    std::error_code error;
    if (!fs::is_directory(folder, error) || !is_whole(folder)) {
        return;
    }
    if (!fs::exists(fs::symlink_status(target_)) && !rename_to_new(folder, target_)) {
        note(fmt::format("'{}' was restored: a run had begun to replace it when it ended", target_.string()));
    } else if (!remove_written(folder)) {
        note(fmt::format("'{}' still holds files that deadpoint did not write", folder.string()));
    }
}

IfThere if_there(const fs::path& file, bool force, bool renews)
{
    if (!fs::exists(fs::symlink_status(file))) {
        return IfThere::refuse;
    }
    const bool own = is_added_and_unchanged(file);
    if (force || (renews && own)) {
        return IfThere::replace;
    }
    throw IoError(fmt::format("'{}' exists{}\n  help: choose another name, or add --force to replace it", file.string(),
                              renews ? " and is not as deadpoint wrote it" : ""));
}

}  // namespace deadpoint::report
