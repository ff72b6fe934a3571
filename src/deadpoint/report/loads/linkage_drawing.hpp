#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace deadpoint {
struct CycleHistory;
struct Linkage;
}  // namespace deadpoint

namespace deadpoint::report {

/// The linkage at several crank positions side by side, as an SVG document.
///
/// Bodies are lines or polygons between their joints' centres, joints circles, joints on the ground triangles, guides
/// hatched lines over the travel of the turn. Joints' paths are drawn as thin lines. An image of a mirrored body (name
/// with a prime) has the colour of its original.
///
/// @param positions  indices into the history, one per panel, at least one
/// @throws InputError if history and linkage do not fit together
std::string linkage_drawing(const std::string& title, const Linkage& linkage, const CycleHistory& history,
                            const std::vector<std::size_t>& positions);

}  // namespace deadpoint::report
