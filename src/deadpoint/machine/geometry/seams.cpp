#include "deadpoint/machine/geometry/seams.hpp"

#include "deadpoint/core/mistakes.hpp"
#include "deadpoint/core/units.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <utility>

namespace deadpoint::machine {

namespace {

/// Coordinates this close differ by rounding only [m].
constexpr double rounding = 1e-9;
/// A corner this close to an edge lies on it [m].
constexpr double edge_tolerance = 1e-12;
/// Decimal numbers are a little off: a gap of the tolerance itself still counts.
constexpr double slack = 1 + 1e-6;

using Ring = std::vector<Vec2>;

/// Records the longest distance by which anything was moved.
class Moves {
public:
    explicit Moves(Healed& healed) : healed_(healed) {}
    void add(double way, const Vec3& where)
    {
        if (way > healed_.moved) {
            healed_.moved = way;
            healed_.where = where;
        }
    }

private:
    Healed& healed_;
};

/// Positions of planes across one coordinate axis: the first of several within the tolerance stands for all.
class Levels {
public:
    explicit Levels(double tolerance) : tolerance_(tolerance) {}
    double operator()(double value)
    {
        const auto nearer = [value](double a, double b) { return std::abs(a - value) < std::abs(b - value); };
        const auto nearest = std::min_element(values_.begin(), values_.end(), nearer);
        if (nearest != values_.end() && std::abs(*nearest - value) <= tolerance_) {
            return *nearest;
        }
        values_.push_back(value);
        return value;
    }

private:
    double tolerance_;
    std::vector<double> values_;
};

std::vector<Ring*> rings_of(Prism& prism)
{
    std::vector<Ring*> rings;
    if (!prism.box && !prism.section.circle) {
        rings.push_back(&prism.section.points);
        for (Ring& hole : prism.section.holes) {
            rings.push_back(&hole);
        }
    }
    return rings;
}

/// Whether the edge from corner i to its successor keeps coordinate k.
bool level_edge(const Ring& ring, std::size_t i, std::size_t k)
{
    return std::abs(ring[i][k] - ring[(i + 1) % ring.size()][k]) < rounding;
}

[[noreturn]] void fail_thin(const std::string& part, const Prism& prism, double tolerance)
{
    throw InputError(fmt::format("part '{}', shape {}: it is not thicker than the seam tolerance of {:.4g} um; make it "
                                 "thicker, or lower numerics.seam_tolerance",
                                 part, prism.shape + 1, micrometre * tolerance));
}

class Healer {
public:
    Healer(const std::string& part, Healed& result, double tolerance, bool half)
        : part_(part), prisms_(result.prisms), moves_(result), stated_(tolerance),
          tolerance_(tolerance * slack), levels_{Levels(tolerance_), Levels(tolerance_), Levels(tolerance_)}
    {
        if (half) {
            levels_[0](0);
        }
    }

    void run()
    {
        for (Prism& prism : prisms_) {
            level(prism);
        }
        for (std::size_t i = 0; i < prisms_.size(); ++i) {
            align_circle(i);
        }
        for (const Axis axis : {Axis::x, Axis::y, Axis::z}) {
            join_outlines(axis);
        }
        Mistakes mistakes("geometry");
        for (Prism& prism : prisms_) {
            mistakes.attempt(fmt::format("parts.{}.shapes.{}", part_, prism.shape), [&] { check(prism); });
        }
        mistakes.raise();
    }

private:
    /// A corner of a ring, and which of its coordinates its edges fix.
    struct Corner {
        Vec2* point = nullptr;
        std::size_t ring = 0;
        std::array<bool, 2> held{};
        [[nodiscard]] int holds() const { return (held[0] ? 1 : 0) + (held[1] ? 1 : 0); }
    };
    /// Outlines along one axis, and sections of boxes normal to it; boxes come first, since they cannot be deformed.
    struct Drawing {
        Axis axis = Axis::z;
        std::vector<Ring> boxes;
        std::vector<Ring*> rings;
        std::vector<double> positions;  ///< per ring, along the axis: for messages
        std::vector<Corner> corners;
    };

    void move(double& value, std::size_t k, const Vec3& where)
    {
        const double level = levels_[k](value);
        moves_.add(std::abs(level - value), where);
        value = level;
    }

    void level(Prism& prism)
    {
        if (prism.box) {
            for (std::size_t k = 0; k < 3; ++k) {
                move(prism.min[k], k, prism.min);
                move(prism.max[k], k, prism.max);
            }
            prism = along(prism, prism.axis);
            return;
        }
        const auto length = static_cast<std::size_t>(index_of(prism.axis));
        const Vec2 middle = prism.section.circle ? prism.section.circle->centre : prism.section.points.front();
        move(prism.from, length, point_at(prism.axis, middle, prism.from));
        move(prism.to, length, point_at(prism.axis, middle, prism.to));
        for (Ring* ring : rings_of(prism)) {
            level_edges(prism, *ring);
        }
    }

    void level_edges(const Prism& prism, Ring& ring)
    {
        const Ring drawn = ring;
        const auto directions = across(prism.axis);
        for (std::size_t i = 0; i < ring.size(); ++i) {
            for (std::size_t k = 0; k < 2; ++k) {
                if (level_edge(drawn, i, k)) {
                    const auto axis = static_cast<std::size_t>(directions[k]);
                    Vec2& next = ring[(i + 1) % ring.size()];
                    move(ring[i][k], axis, point_at(prism.axis, drawn[i], prism.from));
                    next[k] = ring[i][k];
                }
            }
        }
    }

    /// Replaces centre and radii of a circle by those of an earlier one if they nearly agree.
    void align_circle(std::size_t own)
    {
        Prism& prism = prisms_[own];
        for (std::size_t i = 0; i < own && prism.section.circle; ++i) {
            const Prism& other = prisms_[i];
            if (!other.section.circle || other.axis != prism.axis) {
                continue;
            }
            Vec2& centre = prism.section.circle->centre;
            const double away = norm(centre - other.section.circle->centre);
            if (away > tolerance_) {
                continue;
            }
            const bool outer = align_radius(prism, prism.section.circle->radius, other);
            const bool inner = align_radius(prism, prism.section.bore_radius, other);
            if (outer || inner || away < rounding) {
                moves_.add(away, point_at(prism.axis, centre, prism.from));
                centre = other.section.circle->centre;
            }
        }
    }

    bool align_radius(const Prism& prism, double& radius, const Prism& other)
    {
        for (const double target : {other.section.circle->radius, other.section.bore_radius}) {
            if (radius > 0 && target > 0 && std::abs(radius - target) <= tolerance_) {
                const Vec2 place = prism.section.circle->centre + Vec2{radius, 0};
                moves_.add(std::abs(radius - target), point_at(prism.axis, place, prism.from));
                radius = target;
                return true;
            }
        }
        return false;
    }

    Drawing drawing_along(Axis axis)
    {
        Drawing drawing;
        drawing.axis = axis;
        for (const Prism& prism : prisms_) {
            if (prism.box) {
                drawing.boxes.push_back(along(prism, axis).section.points);
                drawing.positions.push_back(prism.min[index_of(axis)]);
            }
        }
        for (Ring& box : drawing.boxes) {
            drawing.rings.push_back(&box);
        }
        for (Prism& prism : prisms_) {
            for (Ring* ring : prism.axis == axis ? rings_of(prism) : std::vector<Ring*>{}) {
                drawing.rings.push_back(ring);
                drawing.positions.push_back(prism.from);
            }
        }
        for (std::size_t r = 0; r < drawing.rings.size(); ++r) {
            Ring& ring = *drawing.rings[r];
            for (std::size_t i = 0; i < ring.size(); ++i) {
                const std::size_t before = (i + ring.size() - 1) % ring.size();
                Corner corner{&ring[i], r, {}};
                for (std::size_t k = 0; k < 2; ++k) {
                    corner.held[k] = level_edge(ring, i, k) || level_edge(ring, before, k);
                }
                drawing.corners.push_back(corner);
            }
        }
        std::stable_sort(drawing.corners.begin(), drawing.corners.end(),
                         [](const Corner& a, const Corner& b) { return a.holds() > b.holds(); });
        return drawing;
    }

    void join_outlines(Axis axis)
    {
        Drawing drawing = drawing_along(axis);
        if (drawing.rings.size() == drawing.boxes.size() || drawing.rings.size() == 1) {
            return;
        }
        for (std::size_t i = 0; i < drawing.corners.size(); ++i) {
            join_corner(drawing, i);
        }
        for (const Corner& corner : drawing.corners) {
            put_on_edge(drawing, corner);
        }
        divide_edges(drawing);
    }

    /// Moves a corner unless this would rotate an edge that is parallel to an axis; returns whether it moved.
    bool move_corner(const Drawing& drawing, const Corner& corner, const Vec2& target)
    {
        for (std::size_t k = 0; k < 2; ++k) {
            if (corner.held[k] && std::abs(target[k] - (*corner.point)[k]) > edge_tolerance) {
                return false;
            }
        }
        moves_.add(norm(target - *corner.point), point_at(drawing.axis, *corner.point, drawing.positions[corner.ring]));
        *corner.point = target;
        return true;
    }

    /// Moves a corner to the nearest corner of another ring that is earlier in the drawing's order.
    void join_corner(const Drawing& drawing, std::size_t own)
    {
        const Corner& corner = drawing.corners[own];
        const Vec2* nearest = nullptr;
        double distance = tolerance_;
        for (std::size_t i = 0; i < own; ++i) {
            const Corner& other = drawing.corners[i];
            if (other.ring != corner.ring && norm(*other.point - *corner.point) <= distance) {
                distance = norm(*other.point - *corner.point);
                nearest = other.point;
            }
        }
        if (nearest != nullptr && corner.ring >= drawing.boxes.size()) {
            move_corner(drawing, corner, *nearest);
        }
    }

    /// Projection of a point onto the edge from corner i of a ring, if it is near and well between the edge's ends.
    [[nodiscard]] bool foot_on_edge(const Ring& ring, std::size_t i, const Vec2& point, Vec2& foot) const
    {
        const Vec2 edge = ring[(i + 1) % ring.size()] - ring[i];
        const double length = norm(edge);
        const double place = dot(point - ring[i], edge) / length;
        if (!(place > tolerance_) || !(place < length - tolerance_)) {
            return false;
        }
        foot = ring[i] + (place / length) * edge;
        return norm(point - foot) <= tolerance_;
    }

    void put_on_edge(const Drawing& drawing, const Corner& corner)
    {
        for (std::size_t r = 0; r < corner.ring && corner.ring >= drawing.boxes.size(); ++r) {
            const Ring& ring = *drawing.rings[r];
            for (std::size_t i = 0; i < ring.size(); ++i) {
                Vec2 foot{};
                if (foot_on_edge(ring, i, *corner.point, foot) && move_corner(drawing, corner, foot)) {
                    return;
                }
            }
        }
    }

    /// Adds corners of other rings that are still beside an edge of an outline to that outline.
    void divide_edges(Drawing& drawing)
    {
        std::vector<Ring> divided;
        for (std::size_t r = drawing.boxes.size(); r < drawing.rings.size(); ++r) {
            Ring fresh;
            for (std::size_t i = 0; i < drawing.rings[r]->size(); ++i) {
                fresh.push_back((*drawing.rings[r])[i]);
                for (const Vec2& corner : corners_beside(drawing, r, i)) {
                    fresh.push_back(corner);
                }
            }
            divided.push_back(std::move(fresh));
        }
        for (std::size_t i = 0; i < divided.size(); ++i) {
            *drawing.rings[drawing.boxes.size() + i] = std::move(divided[i]);
        }
    }

    /// Corners of other rings beside an edge, sorted by their position along it.
    [[nodiscard]] std::vector<Vec2> corners_beside(const Drawing& drawing, std::size_t r, std::size_t i) const
    {
        const Ring& ring = *drawing.rings[r];
        std::vector<std::pair<double, Vec2>> beside;
        for (const Ring* other : drawing.rings) {
            for (std::size_t k = 0; k < other->size() && other != &ring; ++k) {
                const Vec2& point = (*other)[k];
                Vec2 foot{};
                if (foot_on_edge(ring, i, point, foot) && norm(point - foot) > edge_tolerance) {
                    beside.emplace_back(norm(foot - ring[i]), point);
                }
            }
        }
        std::sort(beside.begin(), beside.end());
        std::vector<Vec2> points;
        for (const auto& [place, point] : beside) {
            if (points.empty() || norm(points.back() - point) > tolerance_) {
                points.push_back(point);
            }
        }
        return points;
    }

    void check(Prism& prism) const
    {
        bool thin = prism.to - prism.from <= rounding;
        for (std::size_t k = 0; k < 3 && prism.box; ++k) {
            thin = thin || prism.max[k] - prism.min[k] <= rounding;
        }
        if (prism.section.circle) {
            thin = thin || prism.section.circle->radius - prism.section.bore_radius <= rounding;
        }
        for (Ring* ring : rings_of(prism)) {
            drop_equal_neighbours(*ring);
            thin = thin || ring->size() < 3;
        }
        if (thin) {
            fail_thin(part_, prism, stated_);
        }
    }

    static void drop_equal_neighbours(Ring& ring)
    {
        ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
        while (ring.size() > 1 && ring.front() == ring.back()) {
            ring.pop_back();
        }
    }

    const std::string& part_;
    std::vector<Prism>& prisms_;
    Moves moves_;
    double stated_;
    double tolerance_;
    std::array<Levels, 3> levels_;
};

}  // namespace

Healed healed(const std::string& part, std::vector<Prism> prisms, double tolerance, bool half)
{
    Healed result;
    result.prisms = std::move(prisms);
    Healer(part, result, tolerance, half).run();
    return result;
}

}  // namespace deadpoint::machine
