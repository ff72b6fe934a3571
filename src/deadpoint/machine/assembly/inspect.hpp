#pragma once

#include "deadpoint/core/observer.hpp"
#include "deadpoint/machine/assembly/assembly.hpp"

/// Looks for faults of meshes that every later stage would take without a word.
namespace deadpoint::machine {

/// Counts the pieces of every part (MeshPart::pieces, Machine::piece_of_cell) and looks at its cells:
///
/// - Cells in each other, which count their mass twice: a face that two cells have on the same side, or a free face
///   with another cell behind it.
/// - Free faces that lie on each other, which heat does not cross though nobody sees a gap: in front of the middle of a
///   free face, nearer than a hundredth of its width, is a cell of the same part that shares no node with it.
/// - Pieces that hang together by nodes only, without a common face.
/// - Flat cells: thinner than ten times the seam tolerance and than a hundredth of their length.
///
/// @param seam_tolerance  free faces this close are an error, farther ones a warning [m]
/// @throws InputError  for cells in each other and for free faces on each other within the tolerance, with part and
///                     place; all of them at once
void inspect(Assembly& assembly, double seam_tolerance, Observer& observer);

}  // namespace deadpoint::machine
