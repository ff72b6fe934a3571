#pragma once

namespace deadpoint {
struct Machine;
}
namespace deadpoint::casefile {
struct Case;
}

namespace deadpoint::press {

class TurnCache;
struct LoadsResult;

/// True if a case has the data of a linkage for its loads: a driver and the body that carries the
/// tool.
bool has_loads(const casefile::Case& input);

/// The first segment in which the press runs, or -1.
int first_running_segment(const casefile::Case& input);

/// True if the loads need the meshed parts, because some masses are not stated.
bool loads_need_machine(const casefile::Case& input);

/// Natural frequencies and critical speeds of the crankshaft, on which no heat depends, take most of the time.
enum class Vibration { computed, left_out };

/// Computes the loads of the whole machine in one segment of the operation.
///
/// The crank turns counter-clockwise with the segment's speed. The load on the crankshaft's pin is
/// the sum of the forces of all joints of the driven body except the driver. The rigid crankshaft
/// is always solved, the flexible one if the case states it.
///
/// @param machine  may be null where loads_need_machine() is false
/// @param segment  index into Case::operation
/// @param turns    positions of the linkage that several calls share; null: none
/// @throws InputError, DomainError, ConvergenceError
LoadsResult compute_loads(const casefile::Case& input, const Machine* machine, int segment,
                          Vibration vibration = Vibration::computed, TurnCache* turns = nullptr);

}  // namespace deadpoint::press
