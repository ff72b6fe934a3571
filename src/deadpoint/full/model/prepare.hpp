#pragma once

#include "deadpoint/casefile/describe/case.hpp"

#include <optional>

namespace deadpoint {

class MeshedParts;
class Mistakes;
class Observer;
struct Machine;
}  // namespace deadpoint

namespace deadpoint::full {

/// Meshes a case's machine and assigns each exterior face to a surface. A face has one condition
/// (film, temperature, flux or insulation). A face that a surface selects by position (plane,
/// cylinder, box, group) is removed from the surfaces that select "exposed" faces. Reads press::model_part() only.
///
/// @param mistakes  gets surfaces that claim a face with equal priority, or no face
/// @param kept      as build_machine()
/// @throws InputError as build_machine()
Machine mesh_machine(const casefile::Case& input, double size_scale, Observer& observer, Mistakes& mistakes,
                     MeshedParts* kept = nullptr);

/// Looks at what a case asks of its machine beside the mesh: probes outside of their parts, formulas in degC, cells
/// that are too large for it. Warnings go to the observer.
/// @param mistakes  those found before
/// @throws CaseError with them and those found here
void check_on_machine(const casefile::Case& input, const Machine& machine, double size_scale, Observer& observer,
                      Mistakes& mistakes);

/// Both.
Machine prepare_machine(const casefile::Case& input, double size_scale, Observer& observer);

/// The machine meshed for its deformation, if that mesh differs from the heat mesh.
///
/// @param machine  from prepare_machine() with the same size_scale
/// @throws InputError as build_machine(), naming the mesh of the deformation
std::optional<Machine> prepare_deformation_machine(const casefile::Case& input, double size_scale,
                                                   const Machine& machine, Observer& observer);

}  // namespace deadpoint::full
