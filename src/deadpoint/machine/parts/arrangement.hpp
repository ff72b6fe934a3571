#pragma once

#include "deadpoint/core/vec.hpp"

#include <map>
#include <vector>

/// The outlines of a layered part, fitted together in one plane by OpenCASCADE. Needs a GmshSession; tags are those of
/// Gmsh's current model, whose lengths are millimetres.
namespace deadpoint::machine {

struct LayeredPart;

/// Surfaces by their signature().
using SurfaceGroups = std::map<std::vector<char>, std::vector<int>>;

/// Draws all outlines into the current model and divides the plane by them. Neighbouring surfaces
/// with equal signatures are joined, so that only outlines with different sides remain.
SurfaceGroups build_arrangement(const LayeredPart& part);

/// `count` + 1 points along a curve [m].
std::vector<Vec2> sampled(int curve, int count);
/// Tags of the points at the ends of a curve; the negative tag of the curve itself if it has none.
std::array<int, 2> ends_of(int curve);
std::vector<int> boundary_curves(int face);

}  // namespace deadpoint::machine
