#pragma once

#include "deadpoint/machine/part_mesh.hpp"
#include "deadpoint/machine/polygon.hpp"

#include <optional>
#include <vector>

/// The plane of parameters of a surface: two coordinates in a plane, (radius times angle, axial) on a cylinder.
namespace deadpoint::machine {

/// A face in a chart: its corners in the order of its nodes, and the counter-clockwise polygon that counts (clipped).
struct ChartFace {
    std::uint32_t face = 0;
    int count = 4;
    std::array<Vec2, 4> corners{};
    double full_area = 0;
    Polygon polygon;
};

class Chart {
public:
    /// @param geometry  a plane or a cylinder
    explicit Chart(const FaceGeometry& geometry);

    /// On a cylinder the face is unrolled, with its middle in [-period/2, period/2).
    [[nodiscard]] ChartFace flatten(const Face& face, std::uint32_t index, const std::vector<Vec3>& nodes) const;
    /// Clips the polygon of a face: exactly in a plane; on a cylinder along the axis only, whole faces by their centre
    /// in the other directions.
    void clip(ChartFace& chart_face, const Vec3& face_centre, const BoxShape& box) const;
    /// Unit normal of the true surface out of the solid.
    [[nodiscard]] Vec3 normal(const Vec2& parameters) const;
    /// A displacement of the surface in its parameters; none if it leaves the surface by more than `slack` [m]: across
    /// a plane, or across the axis of a cylinder.
    [[nodiscard]] std::optional<Vec2> shift(const Vec3& offset, double slack) const;
    /// Circumference of a cylinder, 0 for a plane [m].
    [[nodiscard]] double period() const { return period_; }

private:
    [[nodiscard]] Vec2 parameters(const Vec3& point) const;

    bool cylinder_ = false;
    Vec3 origin_{};
    Vec3 first_{};
    Vec3 second_{};
    Vec3 third_{};  ///< normal of the plane, axis of the cylinder
    double radius_ = 0;
    double sense_ = 1;
    double period_ = 0;
};

/// Local coordinates on the facet of the point with the given parameters (position_on() turns them into a point).
Vec2 local_coordinates(const ChartFace& face, const Vec2& parameters);

/// Whether two surfaces can touch: opposite coincident planes, or a bore and a shaft of one axis and nearly one radius.
/// @param gap  largest distance that counts as contact [m]
bool can_touch(const FaceGeometry& a, const FaceGeometry& b, double gap);

}  // namespace deadpoint::machine
