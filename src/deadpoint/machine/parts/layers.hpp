#pragma once

#include "deadpoint/machine/geometry/shapes.hpp"

#include <string>
#include <vector>

/// A part as a stack of layers along one axis, with one plane arrangement of all its outlines.
namespace deadpoint::machine {

struct LayeredPart {
    Axis axis = Axis::z;
    std::vector<Prism> prisms;      ///< all along `axis`; see healed()
    std::vector<double> positions;  ///< ends of all prisms along the axis, ascending
    bool half_plane = false;        ///< keep only the half of the plane where its first coordinate is negative
};

/// Axes along which all prisms extend, z first.
std::vector<Axis> common_axes(const std::vector<Prism>& prisms);

/// @param half  keep x <= 0 only
LayeredPart layered_along(const std::vector<Prism>& prisms, Axis axis, bool half);

/// Membership of a point of the plane: one entry per layer (solid or not), then one per imprinted
/// outline. Empty if no layer is solid or the point is beyond the symmetry plane.
std::vector<char> signature(const LayeredPart& part, const Vec2& point);

/// Number of equal steps of about `size` for a length.
int steps(double length, double size);

/// A straight line, or an arc of a circle.
struct PlaneCurve {
    std::optional<Circle> circle;
    Vec2 from{};
    Vec2 to{};
};

/// Quadrilaterals of the arrangement, counter-clockwise. Every quadrilateral lies in one region; edges on outlines
/// carry the curve they lie on.
struct PlaneMesh {
    struct CurveEdge {
        std::uint32_t from = 0;
        std::uint32_t to = 0;
        std::uint32_t curve = 0;
    };
    std::vector<Vec2> nodes;
    std::vector<std::array<std::uint32_t, 4>> quads;
    std::vector<std::uint32_t> region;          ///< per quadrilateral
    std::vector<std::vector<char>> signatures;  ///< per region
    std::vector<PlaneCurve> curves;
    std::vector<CurveEdge> curve_edges;
};

/// Structured grid for parts made of boxes only.
PlaneMesh grid_plane(const LayeredPart& part, double size);
bool only_boxes(const LayeredPart& part);

/// Smallest sine of a corner of a quadrilateral; negative where it is not convex.
double worst_corner(const PlaneMesh& mesh, std::size_t quad);
/// Moves nodes that lie on no curve towards their neighbours' mean where that makes the worst corner around them
/// better.
void smooth(PlaneMesh& mesh);

/// Unstructured quadrilaterals by Gmsh; needs a GmshSession.
/// @throws InputError naming the part when Gmsh fails or leaves triangles
PlaneMesh mesh_plane(const std::string& name, const LayeredPart& part, double size);

}  // namespace deadpoint::machine
