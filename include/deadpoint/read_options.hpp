#pragma once

#include <string>
#include <vector>

namespace deadpoint {

/// How a case file is read.
struct ReadOptions {
    std::vector<std::string> overrides = {};  ///< "path=value", as --set: "operation.0.speed=400 rpm"
    double size_scale = 1;                    ///< factor on all cell sizes, 0.01..100: 2 is coarser and faster
    bool allow_outside = false;               ///< the case may name files outside its own folder
};

}  // namespace deadpoint
