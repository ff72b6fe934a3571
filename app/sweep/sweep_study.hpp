#pragma once

#include "console.hpp"
#include "deadpoint/casefile/syntax/file_access.hpp"
#include "deadpoint/io/csv_style.hpp"
#include "deadpoint/report/shards/study_folder.hpp"
#include "deadpoint/twin/map/shard.hpp"
#include "deadpoint/twin/map/sweep_plan.hpp"
#include "ranks/ranks.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace deadpoint::report {
struct SweepResult;
}

struct SweepOptions {
    std::string study;
    std::string folder;
    double size_scale = 1;
    int jobs = 0;
    bool fields = false;
    std::string reduced;  ///< file of a reduced model to compute with
    std::optional<deadpoint::twin::Shard> shard;
    bool gather = false;  ///< computes nothing
    deadpoint::casefile::FileAccess files = deadpoint::casefile::FileAccess::below;
    deadpoint::CsvStyle tables = deadpoint::CsvStyle::comments;
    Console::Options console;
    RankOptions ranks;
};

/// The study of the options. @throws InputError also if it has no sets
deadpoint::twin::SweepStudy read_sweep(const SweepOptions& options);

/// Its folder; shows notes. @throws as StudyFolder
deadpoint::report::StudyFolder open_study(const SweepOptions& options, const std::vector<std::string>& marks,
                                          Console& console);

/// Says how many of all points belong to the shard, if it is one.
void say_share(const SweepOptions& options, std::size_t own, std::size_t all);

/// Tables, page and text of a study. @return the exit code
int finish(const SweepOptions& options, const deadpoint::report::SweepResult& result, Console& console);
/// Text of a shard, and its failures for the call that gathers. @param own  its points @return the exit code
int finish_shard(const SweepOptions& options, const std::vector<std::size_t>& own,
                 const deadpoint::report::SweepResult& result, const deadpoint::report::StudyFolder& folder,
                 Console& console);

/// The study on a reduced model, without meshes. @return the exit code
int sweep_reduced(const SweepOptions& options, Ranks& ranks);
