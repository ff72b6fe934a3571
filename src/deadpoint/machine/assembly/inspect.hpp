#pragma once

namespace deadpoint {
class Observer;
}

/// Detects faults of meshes that later stages would accept silently.
namespace deadpoint::machine {

struct Assembly;

/// Counts the pieces of every part (MeshPart::pieces, Machine::piece_of_cell) and inspects its
/// cells:
///
/// - Overlapping cells, which count their mass twice: a face that two cells have on the same side,
/// or a free face
///   with another cell behind it.
/// - Coinciding free faces, which heat does not cross although no gap is visible: in front of the
/// middle of a
///   free face, nearer than a hundredth of its width, is a cell of the same part that shares no node with it.
/// - Pieces that are connected by nodes only, without a common face.
/// - Flat cells: thinner than ten times the seam tolerance and than a hundredth of their length.
///
/// @param seam_tolerance  free faces this close are an error, farther ones a warning [m]
/// @throws InputError  for overlapping cells and for free faces that coincide within the tolerance,
///                     with part and place; all of them at once
void inspect(Assembly& assembly, double seam_tolerance, Observer& observer);

}  // namespace deadpoint::machine
