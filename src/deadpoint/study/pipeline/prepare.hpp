#pragma once

#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/core/observer.hpp"
#include "deadpoint/exchange/machine.hpp"

#include <optional>

namespace deadpoint::study {

/// Meshes a case's machine and settles which surface each exterior face belongs to.
///
/// A face answers to one condition (film, temperature, flux or insulation). One that a surface names by place (plane,
/// cylinder, box, group) is taken from the surfaces that select whatever is "exposed".
///
/// @throws InputError as build_machine(), or where two surfaces claim a face with equal right
Machine prepare_machine(const casefile::Case& input, double size_scale, Observer& observer);

/// The case with the orders of the elements that the deformation takes.
casefile::Case case_of_deformation(casefile::Case input);

/// How much coarser the deformation's mesh is than the heat's: numerics.deformation_size, or where that is 0, 1 while a
/// sparse factor of the deformation fits (fem::largest_factor), and beyond it what leaves wanted_unknowns.
double deformation_scale(const casefile::Case& input, const Machine& machine);
inline constexpr double wanted_unknowns = 600'000;  ///< of a deformation on a mesh of its own

/// The machine meshed for its deformation, where that mesh differs from the heat's.
///
/// @param machine  from prepare_machine() with the same size_scale
/// @throws InputError as build_machine(), naming the mesh of the deformation
std::optional<Machine> prepare_deformation_machine(const casefile::Case& input, double size_scale,
                                                   const Machine& machine, Observer& observer);

}  // namespace deadpoint::study
