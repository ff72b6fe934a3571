#pragma once

#include "deadpoint/casefile/describe/case.hpp"

#include <optional>

namespace deadpoint {

class Observer;
struct Machine;
class MeshedParts;
}  // namespace deadpoint

namespace deadpoint::study {

/// Meshes a case's machine and assigns each exterior face to a surface. A face has one condition
/// (film, temperature, flux or insulation). A face that a surface selects by position (plane,
/// cylinder, box, group) is removed from the surfaces that select "exposed" faces.
///
/// @param kept  as build_machine()
/// @throws InputError as build_machine(), or if two surfaces claim a face with equal priority
Machine prepare_machine(const casefile::Case& input, double size_scale, Observer& observer,
                        MeshedParts* kept = nullptr);

/// The case with the element orders of the deformation.
casefile::Case case_of_deformation(casefile::Case input);

/// How much coarser the deformation's mesh is than the heat's: numerics.deformation_size, or, if
/// that is 0, 1 up to the limit of a sparse factor (fem::largest_factor), and beyond it the scale
/// that gives wanted_unknowns.
double deformation_scale(const casefile::Case& input, const Machine& machine);
inline constexpr double wanted_unknowns = 600'000;  ///< of a deformation on a separate mesh

/// The machine meshed for its deformation, if that mesh differs from the heat mesh.
///
/// @param machine  from prepare_machine() with the same size_scale
/// @throws InputError as build_machine(), naming the mesh of the deformation
std::optional<Machine> prepare_deformation_machine(const casefile::Case& input, double size_scale,
                                                   const Machine& machine, Observer& observer);

}  // namespace deadpoint::study
