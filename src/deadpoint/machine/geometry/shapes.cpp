#include "deadpoint/machine/geometry/shapes.hpp"

#include "deadpoint/core/mistakes.hpp"
#include "deadpoint/machine/geometry/polygon.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace deadpoint::machine {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double least_extent = 1e-6;

void require(bool holds, const std::string& part, std::size_t number, const char* problem)
{
    if (!holds) {
        throw InputError(fmt::format("part '{}', shape {}: {}; correct this shape", part, number + 1, problem));
    }
}

bool finite(double value) { return std::isfinite(value); }

Prism box_prism(const BoxShape& shape)
{
    Prism prism;
    prism.box = true;
    prism.min = shape.min;
    prism.max = shape.max;
    return along(prism, Axis::z);
}

Prism cylinder_prism(Axis axis, const Vec2& centre, double diameter, double bore, double from, double to)
{
    Prism prism;
    prism.axis = axis;
    prism.section.circle = Circle{centre, diameter / 2};
    prism.section.bore_radius = bore / 2;
    prism.from = from;
    prism.to = to;
    return prism;
}

double inner_distance(const std::vector<Vec2>& polygon, const Vec2& point)
{
    double nearest = infinity;
    bool in = false;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec2& a = polygon[i];
        const Vec2& b = polygon[(i + 1) % polygon.size()];
        const Vec2 edge = b - a;
        const double s = std::clamp(dot(point - a, edge) / dot(edge, edge), 0.0, 1.0);
        nearest = std::min(nearest, norm(point - a - s * edge));
        if ((a[1] > point[1]) != (b[1] > point[1]) && point[0] < a[0] + (point[1] - a[1]) / edge[1] * edge[0]) {
            in = !in;
        }
    }
    return in ? nearest : -nearest;
}

void check_outline(const std::string& part, std::size_t number, const std::vector<Vec2>& points)
{
    require(points.size() >= 3, part, number, "an outline needs at least 3 points");
    for (std::size_t i = 0; i < points.size(); ++i) {
        require(norm(points[i] - points[(i + 1) % points.size()]) > least_extent, part, number,
                "two neighbouring points of the outline coincide");
    }
    require(std::abs(signed_area(points)) > least_extent * least_extent, part, number, "the outline has no area");
}

struct Expand {
    const std::string& part;
    std::size_t number;
    std::vector<Prism>& prisms;

    void range(double from, double to) const
    {
        require(finite(from) && finite(to) && to - from > least_extent, part, number,
                "its end must lie beyond its beginning (by more than 1 um)");
    }
    void operator()(const BoxShape& shape) const
    {
        for (std::size_t i = 0; i < 3; ++i) {
            range(shape.min[i], shape.max[i]);
        }
        prisms.push_back(box_prism(shape));
    }
    void operator()(const CylinderShape& shape) const
    {
        range(shape.from, shape.to);
        require(finite(shape.diameter) && shape.diameter > least_extent, part, number, "its diameter must be positive");
        require(shape.bore >= 0 && shape.bore < shape.diameter - least_extent, part, number,
                "its bore must be smaller than its diameter");
        prisms.push_back(cylinder_prism(shape.axis, shape.centre, shape.diameter, shape.bore, shape.from, shape.to));
    }
    void operator()(const OutlineShape& shape) const
    {
        range(shape.from, shape.to);
        check_outline(part, number, shape.points);
        for (const auto& hole : shape.holes) {
            check_outline(part, number, hole);
        }
        Prism prism;
        prism.axis = shape.axis;
        prism.section.points = shape.points;
        prism.section.holes = shape.holes;
        prism.from = shape.from;
        prism.to = shape.to;
        prisms.push_back(prism);
    }
    void operator()(const ShaftShape& shape) const
    {
        require(!shape.sections.empty(), part, number, "a shaft needs at least one section");
        double position = shape.from;
        for (const ShaftSection& section : shape.sections) {
            require(finite(section.length) && section.length > least_extent, part, number,
                    "every section of a shaft needs a positive length");
            require(finite(section.diameter) && section.diameter > least_extent, part, number,
                    "every section of a shaft needs a positive diameter");
            prisms.push_back(cylinder_prism(shape.axis, shape.centre + section.offset, section.diameter, 0, position,
                                            position + section.length));
            position += section.length;
        }
    }
};

}  // namespace

Vec3 point_at(Axis axis, const Vec2& across_axis, double position)
{
    Vec3 point{};
    const auto [u, v] = across(axis);
    point[u] = across_axis[0];
    point[v] = across_axis[1];
    point[index_of(axis)] = position;
    return point;
}

Vec2 project(Axis axis, const Vec3& point)
{
    const auto [u, v] = across(axis);
    return {point[u], point[v]};
}

std::vector<Prism> prisms_of(const std::string& part, const std::vector<Shape>& shapes)
{
    std::vector<Prism> prisms;
    Mistakes mistakes("geometry");
    for (std::size_t i = 0; i < shapes.size(); ++i) {
        const std::size_t first = prisms.size();
        mistakes.attempt(fmt::format("parts.{}.shapes.{}", part, i), [&] {
            std::visit(Expand{part, i, prisms}, shapes[i].form);
        });
        for (std::size_t k = first; k < prisms.size(); ++k) {
            prisms[k].operation = shapes[i].operation;
            prisms[k].shape = i;
        }
    }
    mistakes.raise();
    const auto adds = [](const Prism& prism) { return prism.operation == Shape::Operation::add; };
    if (std::none_of(prisms.begin(), prisms.end(), adds)) {
        throw InputError(fmt::format("part '{}' has no shape that adds material; give it at least one 'add'", part));
    }
    return prisms;
}

Prism along(const Prism& prism, Axis axis)
{
    if (!prism.box) {
        return prism;
    }
    Prism turned = prism;
    const Vec2 low = project(axis, prism.min);
    const Vec2 high = project(axis, prism.max);
    turned.axis = axis;
    turned.section.points = {low, {high[0], low[1]}, high, {low[0], high[1]}};
    turned.from = prism.min[index_of(axis)];
    turned.to = prism.max[index_of(axis)];
    return turned;
}

double inner_distance(const Section& section, const Vec2& point)
{
    if (section.circle) {
        const double distance = norm(point - section.circle->centre);
        const double to_bore = section.bore_radius > 0 ? distance - section.bore_radius : infinity;
        return std::min(section.circle->radius - distance, to_bore);
    }
    double result = inner_distance(section.points, point);
    for (const auto& hole : section.holes) {
        result = std::min(result, -inner_distance(hole, point));
    }
    return result;
}

bool inside(const Section& section, const Vec2& point) { return inner_distance(section, point) > 0; }

double depth(const std::vector<Prism>& prisms, const Vec3& point)
{
    double result = -infinity;
    for (const Prism& prism : prisms) {
        if (prism.operation == Shape::Operation::imprint) {
            continue;
        }
        const double position = point[index_of(prism.axis)];
        const double lengthwise = std::min(position - prism.from, prism.to - position);
        const double own = std::min(lengthwise, inner_distance(prism.section, project(prism.axis, point)));
        result = prism.operation == Shape::Operation::add ? std::max(result, own) : std::min(result, -own);
    }
    return result;
}

BoxShape empty_box() { return {{infinity, infinity, infinity}, {-infinity, -infinity, -infinity}}; }

void include(BoxShape& box, const Vec3& point)
{
    for (std::size_t i = 0; i < 3; ++i) {
        box.min[i] = std::min(box.min[i], point[i]);
        box.max[i] = std::max(box.max[i], point[i]);
    }
}

}  // namespace deadpoint::machine
