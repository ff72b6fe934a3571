#pragma once

#include "deadpoint/core/vec.hpp"

#include <vector>

namespace deadpoint {

struct Face;
struct Machine;
struct SurfaceCondition;
struct SurfaceFace;

struct FacePoint {
    Vec3 position{};
    double weight = 0;  ///< area [m2]
};

/// Quadrature points of an exterior face: Gauss 3 x 3 on a quadrilateral (as a bilinear patch), six points of degree 4
/// on a triangle, on the surface that round edges span. The weights sum to the face's area (to rounding, where the face
/// is flat and its edges are straight).
std::vector<FacePoint> face_points(const Machine& machine, const Face& face);

/// The faces of a condition: of its surface, or those of them on its part.
std::vector<SurfaceFace> faces_of(const Machine& machine, const SurfaceCondition& condition);

/// Area of an exterior face [m2]: of its points where its edges are round, else of its triangles.
double face_area(const Machine& machine, const Face& face);
/// Contribution of an exterior face to its part's volume, int x . n dA / 3 [m3]: exact, round edges
/// included.
double face_volume(const Machine& machine, const Face& face);

}  // namespace deadpoint
