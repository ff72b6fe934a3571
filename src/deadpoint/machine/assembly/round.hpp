#pragma once

#include <cstddef>

namespace deadpoint {
struct Face;
struct Machine;
}  // namespace deadpoint

/// Round edges of parts of second order.
namespace deadpoint::machine {

/// Finds the round edges of the part appended last and measures its volume with them. The middle of
/// an edge moves from its chord to all planes and cylinders of the edge; edges of cells that would
/// be inverted stay straight.
/// @returns how many cells keep straight edges for that reason
std::size_t add_round_edges(Machine& machine, double density);

/// Area of a face [m2], of the surface that its edges span.
double area(const Machine& machine, const Face& face);

}  // namespace deadpoint::machine
