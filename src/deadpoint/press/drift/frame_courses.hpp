#pragma once

#include <cstddef>

namespace deadpoint {
class Observer;
struct ThermalHistory;
}  // namespace deadpoint
namespace deadpoint::casefile {
struct Case;
}

/// Forces of rods and closed bonds over a run, and what they warn of. Needs no mesh.
namespace deadpoint::press {

struct FrameResult;

/// Reads the courses of rods and bonds from the history's functionals from index `first` on.
void read_courses(const ThermalHistory& history, std::size_t first, FrameResult& result);

/// Warns of rods whose force is too small and of closed bonds that would open.
void warn_about_frame(const casefile::Case& input, const ThermalHistory& history, const FrameResult& result,
                      Observer& observer);

}  // namespace deadpoint::press
