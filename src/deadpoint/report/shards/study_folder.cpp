#include "deadpoint/report/shards/study_folder.hpp"

#include "deadpoint/core/hash.hpp"
#include "deadpoint/core/version.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/report/folder/json_file.hpp"
#include "deadpoint/report/folder/result_files.hpp"

#include <algorithm>
#include <chrono>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <string_view>
#include <thread>

namespace deadpoint::report {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

constexpr const char* failed_file = "failed.json";
constexpr auto longest_wait = 20s;  // for another shard that makes the folder

std::string name_of(const twin::Shard& shard) { return fmt::format("{}-of-{}", shard.number, shard.count); }

std::string mark_of_study(const std::vector<std::string>& marks)
{
    return stable_hash(fmt::format("{} {}", version, fmt::join(marks, " ")));
}

/// Claims the folder. Shards begin at the same time, and each holds the claim for a moment.
FolderClaim claim(const fs::path& folder, bool patient)
{
    bool was_locked = true;  // the lock that refused a claim may be gone when it is looked for
    for (const auto start = std::chrono::steady_clock::now();;) {
        try {
            return FolderClaim(folder);
        } catch (const IoError&) {
            const bool locked = fs::exists(folder.string() + ".lock");
            if (!patient || !(locked || was_locked) || std::chrono::steady_clock::now() - start > longest_wait) {
                throw;
            }
            was_locked = locked;
        }
        std::this_thread::sleep_for(50ms);
    }
}

/// What belongs to shards, in the order of their names.
std::vector<fs::path> of_shards(const fs::path& folder)
{
    std::vector<fs::path> result;
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(folder, error)) {
        if (entry.path().filename().string().find("-of-") != std::string::npos) {
            result.push_back(entry.path());
        }
    }
    std::ranges::sort(result);
    return result;
}

/// Reads a file of the shards. @throws InputError if it is not as deadpoint wrote it
template <class Take>
void read_shared(const fs::path& file, const Take& take)
{
    const auto json = read_json(file);
    try {
        take(json);
    } catch (const nlohmann::ordered_json::exception&) {
        throw InputError(fmt::format("'{}' was changed since deadpoint wrote it\n  help: remove the folder '{}' and "
                                     "repeat the shards; finished points stay",
                                     file.string(), file.parent_path().string()));
    }
}

}  // namespace

StudyFolder::StudyFolder(const fs::path& folder, const std::vector<std::string>& marks,
                         const std::optional<twin::Shard>& shard)
    : folder_(folder), shards_(folder / "shards"), marks_(marks), shard_(shard)
{
    auto claimed = claim(folder, shard.has_value());
    notes_ = claimed.take_notes();
    make_or_reuse();
    require_study();
    if (!shard) {
        require_no_shard();
        claim_.emplace(std::move(claimed));
        return;
    }
    lock_ = std::make_unique<FileLock>(
        shards_ / (name_of(*shard) + ".lock"),
        fmt::format("shard {}/{} of '{}' is being computed", shard->number, shard->count, folder.string()));
    fs::create_directories(shards_ / name_of(*shard));
    if (!lock_->held()) {
        notes_.push_back(fmt::format("the file system of '{}' has no locks: start no shard twice", folder.string()));
    }
}

void StudyFolder::make_or_reuse() const
{
    if (!fs::exists(folder_) || (fs::is_directory(folder_) && fs::is_empty(folder_))) {
        fs::create_directories(folder_ / "points");
        write_manifest(folder_);
    } else if (!fs::is_directory(folder_ / "points") || !is_whole(folder_)) {
        throw IoError(fmt::format(
            "'{}' exists already and holds no study\n  help: name a new folder, or that of a study to continue",
            folder_.string()));
    }
}

// The first shard writes which study it is; all others, and the call that gathers, compare with it.
void StudyFolder::require_study() const
{
    const auto file = shards_ / "study.json";
    const auto mark = mark_of_study(marks_);
    std::optional<std::string> known;
    std::string by;
    int count = 0;
    read_shared(file, [&](const auto& json) {
        if (json) {
            known = json->at("study").template get<std::string>();
            by = json->at("version").template get<std::string>();
            count = json->at("shards").template get<int>();
        }
    });
    if (!known) {
        if (shard_) {
            fs::create_directories(shards_);
            write_json(file,
                       {{"written_by", "deadpoint"}, {"version", version}, {"study", mark}, {"shards", shard_->count}});
        }
        return;
    }
    if (*known != mark) {
        if (!shard_) {
            return;  // it computes what is missing; points of other cases do not count
        }
        throw InputError(fmt::format("shards of another study have begun in '{}', or of the same with another case, "
                                     "option or version (theirs is {}, this is {})\n  help: name a new folder",
                                     folder_.string(), by, version));
    }
    if (shard_ && count != shard_->count) {
        throw InputError(
            fmt::format("'{}' is a study of {} shards, and --shard {}/{} is of {}\n  help: give {} as their "
                        "number, or name a new folder",
                        folder_.string(), count, shard_->number, shard_->count, shard_->count, count));
    }
}

void StudyFolder::require_no_shard() const
{
    for (const auto& file : of_shards(shards_)) {
        if (file.extension() == ".lock") {
            const FileLock free(
                file, fmt::format("shard {} of '{}' is being computed", file.stem().string(), folder_.string()));
        }
    }
}

fs::path StudyFolder::file(const std::string& name) const { return shards_ / name_of(*shard_) / name; }

std::vector<fs::path> StudyFolder::files_of_all(const std::string& name) const
{
    std::vector<fs::path> result;
    for (const auto& folder : of_shards(shards_)) {
        if (fs::exists(folder / name)) {
            result.push_back(folder / name);
        }
    }
    return result;
}

void StudyFolder::keep_failures(const std::vector<twin::PointOutcome>& outcomes) const
{
    auto failed = nlohmann::ordered_json::object();
    for (std::size_t p = 0; p < outcomes.size(); ++p) {
        if (outcomes[p].state == twin::PointOutcome::State::failed) {
            failed[marks_[p]] = outcomes[p].reason;
        }
    }
    write_json(file(failed_file), {{"written_by", "deadpoint"}, {"version", version}, {"failed", failed}});
}

std::map<std::string, std::string> StudyFolder::failures() const
{
    std::map<std::string, std::string> result;
    for (const auto& file : files_of_all(failed_file)) {
        read_shared(file, [&](const auto& json) {
            for (const auto& [mark, reason] : json.value().at("failed").items()) {
                result[mark] = reason.template get<std::string>();
            }
        });
    }
    return result;
}

void require_none_missing(const std::vector<twin::SweepPoint>& points, const std::vector<std::size_t>& missing)
{
    constexpr std::size_t named = 10;
    if (missing.empty()) {
        return;
    }
    std::string names;
    for (std::size_t i = 0; i < std::min(missing.size(), named); ++i) {
        names += fmt::format("\n  {}", points[missing[i]].name);
    }
    if (missing.size() > named) {
        names += fmt::format("\n  and {} more", missing.size() - named);
    }
    throw InputError(
        fmt::format("{} of {} points are missing:{}\n  help: repeat the shards that were stopped, or leave "
                    "out --gather to compute these points now",
                    missing.size(), points.size(), names));
}

}  // namespace deadpoint::report
