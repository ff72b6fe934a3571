#pragma once

#include <string>
#include <vector>

namespace deadpoint::press {

/// What becomes of the fields of a run.
struct FieldOptions {
    std::string folder;                 ///< existing, for field files; empty: no files
    std::vector<std::string> comments;  ///< for their heads
    bool checkpoints = false;           ///< whether the run may pass them on to a checkpoint
};

}  // namespace deadpoint::press
