#pragma once

#include "deadpoint/press.hpp"

#include <string>
#include <vector>

/// The starter press, coarse and for ten minutes: some seconds of computing.
inline deadpoint::ReadOptions small_starter(const std::vector<std::string>& more = {})
{
    deadpoint::ReadOptions options;
    options.overrides = {"operation.0.duration=10 min", "numerics.time_tolerance=0.1 K", "output.field_times=[]"};
    options.overrides.insert(options.overrides.end(), more.begin(), more.end());
    options.size_scale = 3;
    return options;
}

inline std::string starter_file() { return std::string(DEADPOINT_SOURCE_DIR) + "/cases/starter/case.toml"; }

inline deadpoint::Press starter(const std::vector<std::string>& more = {})
{
    return deadpoint::Press::read(starter_file(), small_starter(more));
}
