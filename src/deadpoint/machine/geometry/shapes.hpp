#pragma once

#include "deadpoint/exchange/machine.hpp"

#include <optional>
#include <string>
#include <vector>

/// Shapes reduced to prisms: a plane cross-section between two positions along an axis.
namespace deadpoint::machine {

struct Circle {
    Vec2 centre{};
    double radius = 0;
};

/// A cross-section: a circle with a concentric bore, or a polygon with polygonal holes.
struct Section {
    std::optional<Circle> circle;
    double bore_radius = 0;
    std::vector<Vec2> points;
    std::vector<std::vector<Vec2>> holes;
};

struct Prism {
    Shape::Operation operation = Shape::Operation::add;
    Axis axis = Axis::z;
    bool box = false;  ///< a prism along any axis; `min` and `max` hold it
    Vec3 min{};
    Vec3 max{};
    Section section;
    double from = 0;
    double to = 0;
    std::size_t shape = 0;  ///< which of the part's shapes it comes from, counted from 0
};

/// Indices of the two coordinates across an axis, in the order of the alphabet.
constexpr std::array<int, 2> across(Axis axis)
{
    if (axis == Axis::x) {
        return {1, 2};
    }
    if (axis == Axis::y) {
        return {0, 2};
    }
    return {0, 1};
}
constexpr int index_of(Axis axis) { return static_cast<int>(axis); }
/// The point with the given coordinates across and along an axis.
Vec3 point_at(Axis axis, const Vec2& across_axis, double along);
/// The coordinates of a point across an axis.
Vec2 project(Axis axis, const Vec3& point);

/// The shapes of a part as prisms, checked.
/// @throws InputError naming the part for shapes without extent
std::vector<Prism> prisms_of(const std::string& part, const std::vector<Shape>& shapes);

/// A box turned into a prism along `axis`; other prisms unchanged.
Prism along(const Prism& prism, Axis axis);

/// Distance of a point of the plane to the outline of a section, positive inside [m].
double inner_distance(const Section& section, const Vec2& point);
bool inside(const Section& section, const Vec2& point);

/// Depth of a point inside a part [m]: at most the distance to its surface; negative or zero
/// outside. Near the interface of two added shapes inside the solid it is too small, never too
/// large.
double depth(const std::vector<Prism>& prisms, const Vec3& point);

/// An empty box.
BoxShape empty_box();
/// Extends a box to a point.
void include(BoxShape& box, const Vec3& point);

}  // namespace deadpoint::machine
