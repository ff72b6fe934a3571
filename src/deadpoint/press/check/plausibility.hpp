#pragma once

#include <vector>

namespace deadpoint {
struct Machine;
}
namespace deadpoint::casefile {
struct Case;
struct Finding;
struct Surface;
}  // namespace deadpoint::casefile

/// Warnings of what can be computed but is hardly meant, as far as mesh and loads tell.
namespace deadpoint::press {

struct RunResult;

/// Whether a surface states how heat passes it, or that none does.
bool has_condition(const casefile::Surface& surface);

/// Masses by the mesh that differ from those stated by more than 2 %, overlaps, parts that are not connected, parts
/// with cells larger than they are, parts whose faces in air no surface claims, and cylinders in contact with fewer
/// than ten cells around.
/// @param size_scale  of the cells
std::vector<casefile::Finding> question_machine(const casefile::Case& input, const Machine& machine, double size_scale);

/// Joints that turn otherwise than `turns_fully` says, a process force below the weight of the slide or above what
/// bearings carry, a reaction angle across the force on the crank, and friction heat that no contact bears.
/// @param result  with its loads and friction heat, as far as there are any
std::vector<casefile::Finding> question_loads(const casefile::Case& input, const Machine& machine,
                                              const RunResult& result);

}  // namespace deadpoint::press
