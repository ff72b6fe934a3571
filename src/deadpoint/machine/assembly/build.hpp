#pragma once

namespace deadpoint {

class Observer;
struct Machine;
struct MachineDescription;
class MeshedParts;
}  // namespace deadpoint

/// The machine stage: from a description of solids, surfaces and contacts to a mesh with contact points.
namespace deadpoint::machine {

/// Meshes every part, finds exterior faces, contacts, bonds, surfaces and overlaps. SI units throughout.
///
/// Parts whose shapes are prisms along one axis become layers of hexahedra: their outlines are
/// drawn into one plane arrangement, which is meshed with quadrilaterals and extruded. All other
/// parts, STEP sources, and parts with tetrahedra = true become tetrahedra. Circles have at least
/// 24 segments. Nodes of circles lie on the circle; volumes and facet areas are those of the
/// inscribed polygons, areas of contacts are those of the true surfaces. Equal descriptions give
/// bitwise equal machines.
///
/// Surfaces of shapes of one part that are within the seam tolerance of each other are joined first
/// (see healed()). Every finished part, imported ones too, is inspected for cracks, overlapping
/// cells and flat cells (see inspect()).
///
/// Contacts are found on surfaces of equal geometry (planes, cylinders) by clipping the facets of both sides against
/// each other in the parameters of the surface, so that areas are exact on non-matching meshes too. Freeform surfaces
/// of imported parts make no contact. Bonds join touching parts of one body, unless the pair is listed as unbonded or
/// an interface joins it.
///
/// An interface of bodies that slide along each other (Travel) holds the contact at each stop of
/// the travel, weighted with its share of time: its area is the mean over time, which is that of
/// the bodies as drawn unless they slide off each other, and what is exposed is a mean over time
/// too. Interfaces must be covered as drawn; along the travel they may slide off each other in
/// part, which the observer is told. Overlaps are detected for the drawn position only.
///
/// The machine carries the figures of its parts and surfaces (see measure()).
///
/// @param description  what to build; see exchange/machine.hpp
/// @param kept         meshes of the parts of this description that were made before, and where they are kept; may be
/// null
/// @param observer     gets progress, one line per part that could not be meshed with hexahedra, and warnings
/// @throws InputError  for wrong shapes, unusable files, bad or cracked meshes, selectors that
///                     match nothing, interfaces between more than two parts, interfaces that are
///                     not `partial` and less than 98 % covered, and interfaces whose surface does
///                     not lie along their travel (all of them at once)
/// @throws IoError     if a file cannot be read
Machine build_machine(const MachineDescription& description, Observer& observer, MeshedParts* kept = nullptr);

}  // namespace deadpoint::machine
