#include "deadpoint/report/result_folder.hpp"

#include "deadpoint/core/error.hpp"
#include "deadpoint/core/write_file.hpp"
#include "deadpoint/report/result_files.hpp"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fmt/format.h>
#include <string>
#include <sys/stat.h>
#include <system_error>
#include <vector>

namespace deadpoint::report {
namespace {

namespace fs = std::filesystem;

void refuse_existing(const fs::path& target, ResultFolder::IfExists if_exists)
{
    if (!fs::exists(fs::symlink_status(target))) {
        return;
    }
    if (!fs::is_directory(target)) {
        throw IoError(
            fmt::format("'{}' exists and is not a folder\n  help: give another name for the results", target.string()));
    }
    if (if_exists == ResultFolder::IfExists::refuse) {
        throw IoError(fmt::format("the folder '{}' exists already and is not overwritten\n"
                                  "  help: give another name with -o, or replace it with --force",
                                  target.string()));
    }
}

[[noreturn]] void fail(const char* what, const fs::path& path, const std::string& reason)
{
    throw IoError(fmt::format("cannot {} '{}': {}\n  help: check that the folder above it exists and that you may "
                              "write there",
                              what, path.string(), reason));
}

/// A new, empty folder whose name begins with `prefix`.
fs::path make_unique_folder(const std::string& prefix)
{
    std::string name = prefix + "XXXXXX";
    if (mkdtemp(name.data()) == nullptr) {
        fail("create the folder", name, std::strerror(errno));
    }
    const mode_t mask = umask(0);  // mkdtemp() makes a private folder; give it the usual rights
    umask(mask);
    chmod(name.c_str(), static_cast<mode_t>(0777U & ~mask));
    return name;
}

/// Puts all files of a folder on the disk: results must not be gone after a loss of power once they have their name.
/// @throws IoError
void sync_folder(const fs::path& folder)
{
    std::vector<fs::path> all{folder};
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        all.push_back(entry.path());
    }
    for (const auto& path : all) {
        if (!sync_to_disk(path)) {
            fail("write", path, std::strerror(errno));
        }
    }
}

}  // namespace

ResultFolder::ResultFolder(const fs::path& target, IfExists if_exists) : if_exists_(if_exists)
{
    target_ = target.lexically_normal();
    if (!target_.has_filename()) {
        target_ = target_.parent_path();  // "results/" is "results"
    }
    if (target_.empty() || target_ == "." || target_ == "..") {
        throw IoError(fmt::format("'{}' is no name for a new folder of results\n  help: give one with -o, for example "
                                  "-o results",
                                  target.string()));
    }
    refuse_existing(target_, if_exists_);
    std::error_code error;
    if (target_.has_parent_path()) {
        fs::create_directories(target_.parent_path(), error);
        if (error) {
            fail("create the folder", target_.parent_path(), error.message());
        }
    }
    partial_ = make_unique_folder(target_.string() + ".partial-");
}

ResultFolder::~ResultFolder()
{
    if (!partial_.empty() && !keep_) {
        std::error_code ignored;
        fs::remove_all(partial_, ignored);
    }
}

void ResultFolder::commit()
{
    keep_ = true;  // from here on results are complete; never lose them
    if (!fs::exists(partial_ / manifest_name)) {
        write_manifest(partial_);
    }
    refuse_existing(target_, if_exists_);
    sync_folder(partial_);
    std::error_code error;
    fs::path old;
    if (fs::exists(target_)) {
        old = make_unique_folder(target_.string() + ".replaced-");
        fs::rename(target_, old, error);  // an empty folder may be renamed over
        if (error) {
            fail("replace", target_, error.message());
        }
    }
    fs::rename(partial_, target_, error);
    if (error) {
        fail("write", target_, fmt::format("{} (the results are in '{}')", error.message(), partial_.string()));
    }
    partial_.clear();
    sync_to_disk(target_.has_parent_path() ? target_.parent_path() : fs::path("."));
    if (!old.empty()) {
        fs::remove_all(old, error);
    }
}

}  // namespace deadpoint::report
