#pragma once

#include "deadpoint/exchange/machine.hpp"
#include "deadpoint/machine/geometry/polygon.hpp"

#include <optional>
#include <vector>

/// The plane of parameters of a surface: two coordinates in a plane, (radius times angle, axial) on a cylinder.
namespace deadpoint::machine {

/// A face in a chart: its corners in the order of its nodes, and its counter-clockwise polygon
/// (clipped).
struct ChartFace {
    std::uint32_t face = 0;
    int count = 4;
    std::array<Vec2, 4> corners{};
    double full_area = 0;  ///< of the polygons that represent the face
    double scale = 1;      ///< true area of the face over that
    Polygon polygon;
};

class Chart {
public:
    /// @param geometry  a plane or a cylinder
    explicit Chart(const FaceGeometry& geometry);

    /// On a cylinder the face is unrolled, with its middle in [-period/2, period/2).
    [[nodiscard]] ChartFace flatten(const Face& face, std::uint32_t index, const std::vector<Vec3>& nodes) const;
    /// The part of a convex polygon inside a box, in convex pieces: exact in a plane and on a
    /// cylinder along a coordinate axis; on an oblique cylinder the box's faces count as flat
    /// across each polygon.
    [[nodiscard]] std::vector<Polygon> within(const Polygon& polygon, const BoxShape& box) const;
    /// Share of a face's area that lies in a box, 0..1.
    [[nodiscard]] double share_within(const ChartFace& face, const BoxShape& box) const;
    [[nodiscard]] Vec2 parameters(const Vec3& point) const;
    /// From a point's parameters to these, the shorter way around.
    [[nodiscard]] Vec2 way(const Vec3& point, const Vec2& parameters) const;
    /// The point with the given parameters.
    [[nodiscard]] Vec3 position(const Vec2& parameters) const;
    /// Unit normal of the true surface out of the solid.
    [[nodiscard]] Vec3 normal(const Vec2& parameters) const;
    /// A displacement of the surface in its parameters; none if it leaves the surface by more than `slack` [m]: across
    /// a plane, or across the axis of a cylinder.
    [[nodiscard]] std::optional<Vec2> shift(const Vec3& offset, double slack) const;
    /// Circumference of a cylinder, 0 for a plane [m].
    [[nodiscard]] double period() const { return period_; }

private:
    [[nodiscard]] std::vector<Polygon> between(const Polygon& polygon, std::size_t axis, double low, double high) const;
    [[nodiscard]] std::vector<Polygon> between_angles(const Polygon& polygon, std::size_t axis, double low,
                                                      double high) const;
    [[nodiscard]] std::vector<Polygon> on_arc(const std::vector<Polygon>& polygons, double middle,
                                              double half_width) const;

    bool cylinder_ = false;
    Vec3 origin_{};      ///< on the axis of a cylinder; of a plane 0
    double offset_ = 0;  ///< of a plane along its normal
    Vec3 first_{};
    Vec3 second_{};
    Vec3 third_{};  ///< normal of the plane, axis of the cylinder
    double radius_ = 0;
    double sense_ = 1;
    double period_ = 0;
};

/// Local coordinates on the facet of the point with the given parameters (position_on() turns them into a point).
Vec2 local_coordinates(const ChartFace& face, const Vec2& parameters);

/// True if two surfaces can touch: opposite coincident planes, or a bore and a shaft of one axis
/// and nearly one radius.
/// @param gap  largest distance that counts as contact [m]
bool can_touch(const FaceGeometry& a, const FaceGeometry& b, double gap);

}  // namespace deadpoint::machine
