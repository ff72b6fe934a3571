#pragma once

#include <string>
#include <vector>

/// What a run writes and keeps on its way.
namespace deadpoint::press {

struct RunOutputs {
    std::string state_file;             ///< where the temperatures at the end are written; empty: nowhere
    std::string field_folder;           ///< existing folder for field files; empty: no field files
    std::vector<std::string> comments;  ///< for the head of the field files: version, case hash, warnings so far
    bool view = false;                  ///< make RunResult::view
    bool causes = false;                ///< make RunResult::causes, where the case has a dimension chain
    std::string kept_checkpoint;        ///< where the state for a longer operation is kept; empty: nowhere
};

}  // namespace deadpoint::press
