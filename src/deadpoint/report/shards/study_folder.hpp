#pragma once

#include "deadpoint/io/file_lock.hpp"
#include "deadpoint/report/folder/folder_claim.hpp"
#include "deadpoint/twin/map/shard.hpp"
#include "deadpoint/twin/map/sweep_plan.hpp"

#include <cstddef>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

/// The folder of a study. One call works there alone, or one call for each shard, on any machines that share the
/// folder. Shards keep in `DIR/shards`
///
///     study.json           which study it is, and of how many shards
///     2-of-4.lock          held by the process that computes that shard
///     2-of-4/failed.json   its points that failed
///     2-of-4/points.csv    its points on a reduced model
namespace deadpoint::report {

class StudyFolder {
public:
    /// Makes the folder, or sees that it holds this study.
    /// @param marks  of the points, in their order: what each of them computes, with this version
    /// @param shard  that the call computes; none: all points, alone
    /// @throws IoError if another call works there on the same points, or if it is no folder of a study
    /// @throws InputError if shards of another study, or another number of shards, have begun there
    StudyFolder(const std::filesystem::path& folder, const std::vector<std::string>& marks,
                const std::optional<twin::Shard>& shard);

    /// Messages for the user, as FolderClaim.
    [[nodiscard]] std::vector<std::string> take_notes() { return std::exchange(notes_, {}); }

    /// A file of this shard. @param name  "points.csv"
    [[nodiscard]] std::filesystem::path file(const std::string& name) const;
    /// That file of each shard that has written one.
    [[nodiscard]] std::vector<std::filesystem::path> files_of_all(const std::string& name) const;

    /// Keeps the failures of this shard for the call that gathers. @param outcomes  of all points @throws IoError
    void keep_failures(const std::vector<twin::PointOutcome>& outcomes) const;
    /// The reasons of failed points, by their marks. @throws InputError, IoError as read_json()
    [[nodiscard]] std::map<std::string, std::string> failures() const;

private:
    void make_or_reuse() const;
    void require_study() const;
    void require_no_shard() const;

    std::filesystem::path folder_, shards_;
    std::vector<std::string> marks_;
    std::optional<twin::Shard> shard_;
    std::vector<std::string> notes_;
    std::optional<FolderClaim> claim_;  ///< of a call that works alone
    std::unique_ptr<FileLock> lock_;    ///< of a shard
};

/// @throws InputError that names points which no call has computed yet
void require_none_missing(const std::vector<twin::SweepPoint>& points, const std::vector<std::size_t>& missing);

}  // namespace deadpoint::report
