#pragma once

#include <cstddef>
#include <tuple>
#include <vector>

/// Internal to fem/: where a run stands, as far as its fields do not say.
namespace deadpoint::fem {

/// Between two steps.
struct RunPlace {
    std::size_t segment = 0;
    double segment_start = 0;     ///< [s]
    std::size_t segment_row = 0;  ///< of the history
    double time = 0;              ///< [s]
    double wanted = 0;            ///< length of the next step [s]
};
constexpr auto members(const RunPlace*)
{
    return std::tuple{&RunPlace::segment, &RunPlace::segment_start, &RunPlace::segment_row, &RunPlace::time,
                      &RunPlace::wanted};
}

/// Of what the multigrid hierarchy at hand was built, which outlasts its step: with it the same one can be built again.
struct MultigridOrigin {
    std::size_t segment = 0;
    double time = 0;             ///< [s]
    std::vector<double> air;     ///< per enclosure [K]
    std::vector<double> slopes;  ///< of the heat of sources [W/K]
};
constexpr auto members(const MultigridOrigin*)
{
    return std::tuple{&MultigridOrigin::segment, &MultigridOrigin::time, &MultigridOrigin::air,
                      &MultigridOrigin::slopes};
}

}  // namespace deadpoint::fem
