#pragma once

#include "deadpoint/core/vec.hpp"

#include <optional>

namespace deadpoint {
struct Machine;
struct MeshSurface;
}  // namespace deadpoint

/// Lengths of a surface's mesh.
namespace deadpoint::study {

/// Height along y of a surface that lies on one part; none if it lies on several, or has no faces [m].
std::optional<double> height_of(const Machine& machine, const MeshSurface& surface);

/// Diameter of a surface that is a single cylinder [m].
std::optional<double> cylinder_diameter(const Machine& machine, const MeshSurface& surface);

/// Diameter of a disk: of the largest cylinder at which its faces end, along the normal of one of them. None where
/// there is no such cylinder, or the surface lies on several parts or reaches beyond it [m].
std::optional<double> disk_diameter(const Machine& machine, const MeshSurface& surface);

/// Area over perimeter of a surface that is a single plane. Its perimeter runs along the edges of its faces that no
/// other of its faces shares, the plane of symmetry left out: a half has the quotient of the whole [m].
std::optional<double> area_over_perimeter(const Machine& machine, const MeshSurface& surface);

/// First and second moment of a surface's area about the machine's axis, by its area.
struct PlaneMoments {
    Vec2 mean{};             ///< of x and y [m]
    double mean_square = 0;  ///< of x^2 + y^2 [m2]
};
/// One point per face: exact in the mean of flat faces, second moments as fine as the mesh.
PlaneMoments plane_moments(const Machine& machine, const MeshSurface& surface);

}  // namespace deadpoint::study
