#pragma once

namespace deadpoint {
struct Machine;
}
namespace deadpoint::casefile {
struct Case;
}

/// How the mesh of the deformation differs from that of the heat.
namespace deadpoint::press {

/// The case with the element orders of the deformation.
casefile::Case case_of_deformation(casefile::Case input);

/// How much coarser the deformation's mesh is than the heat's: numerics.deformation_size, or, if
/// that is 0, 1 up to the limit of a sparse factor (largest_factor), and beyond it the scale
/// that gives wanted_unknowns.
double deformation_scale(const casefile::Case& input, const Machine& machine);
inline constexpr double wanted_unknowns = 600'000;  ///< of a deformation on a separate mesh

}  // namespace deadpoint::press
