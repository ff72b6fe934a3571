#include "deadpoint/machine/geometry/chart.hpp"

#include "deadpoint/machine/geometry/part_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace deadpoint::machine {

namespace {

/// Two unit vectors across a unit vector; coordinate axes if it is one.
std::array<Vec3, 2> frame_across(const Vec3& direction)
{
    std::size_t smallest = 0;
    for (std::size_t i = 1; i < 3; ++i) {
        if (std::abs(direction[i]) < std::abs(direction[smallest]) - 1e-12) {
            smallest = i;
        }
    }
    Vec3 help{};
    help[smallest] = 1;
    const Vec3 first = normalised(help - dot(help, direction) * direction);
    return {first, cross(direction, first)};
}

/// Cosines below this are 0 [-].
constexpr double level = 1e-9;
/// A plane so close to a face of a box lies in it [m].
constexpr double face_slack = 1e-6;

bool are_parallel(const Vec3& a, const Vec3& b) { return norm(cross(a, b)) < 1e-6; }

}  // namespace

Chart::Chart(const FaceGeometry& geometry)
{
    if (const auto* cylinder = std::get_if<CylinderGeometry>(&geometry)) {
        cylinder_ = true;
        origin_ = cylinder->point;
        third_ = cylinder->axis;
        radius_ = cylinder->radius;
        sense_ = cylinder->bore ? -1 : 1;
        period_ = 2 * std::numbers::pi * radius_;
    } else {
        third_ = std::get<PlaneGeometry>(geometry).normal;
        offset_ = std::get<PlaneGeometry>(geometry).offset;
    }
    const auto frame = frame_across(third_);
    first_ = frame[0];
    second_ = frame[1];
}

Vec2 Chart::parameters(const Vec3& point) const
{
    const Vec3 arm = point - origin_;
    if (!cylinder_) {
        return {dot(arm, first_), dot(arm, second_)};
    }
    return {radius_ * std::atan2(dot(arm, second_), dot(arm, first_)), dot(arm, third_)};
}

Vec2 Chart::way(const Vec3& point, const Vec2& wanted) const
{
    Vec2 result = wanted - parameters(point);
    if (cylinder_) {
        result[0] -= period_ * std::round(result[0] / period_);
    }
    return result;
}

ChartFace Chart::flatten(const Face& face, std::uint32_t index, const std::vector<Vec3>& nodes) const
{
    ChartFace result;
    result.face = index;
    result.count = face.node_count;
    double middle = 0;
    for (int i = 0; i < result.count; ++i) {
        Vec2& corner = result.corners[i];
        corner = parameters(nodes[face.nodes[i]]);
        if (cylinder_ && i > 0) {
            corner[0] -= period_ * std::round((corner[0] - result.corners[0][0]) / period_);
        }
        middle += corner[0] / result.count;
    }
    if (cylinder_) {
        const double shift = period_ * std::floor(middle / period_ + 0.5);
        for (Vec2& corner : result.corners) {
            corner[0] -= shift;
        }
    }
    result.polygon.assign(result.corners.begin(), result.corners.begin() + result.count);
    result.full_area = signed_area(result.polygon);
    if (result.full_area < 0) {
        std::reverse(result.polygon.begin(), result.polygon.end());
        result.full_area = -result.full_area;
    }
    return result;
}

Vec3 Chart::position(const Vec2& point) const
{
    if (!cylinder_) {
        return offset_ * third_ + point[0] * first_ + point[1] * second_;
    }
    const double angle = point[0] / radius_;
    return origin_ + (radius_ * std::cos(angle)) * first_ + (radius_ * std::sin(angle)) * second_ + point[1] * third_;
}

// Part of the polygons that lies less than half a width from an angle of the cylinder.
std::vector<Polygon> Chart::on_arc(const std::vector<Polygon>& polygons, double middle, double half_width) const
{
    std::vector<Polygon> pieces;
    for (const Polygon& polygon : polygons) {
        for (int turn = -1; turn <= 1; ++turn) {
            const double centre = radius_ * middle + turn * period_;
            const double reach = radius_ * half_width;
            const Polygon below = clipped(polygon, HalfPlane{{1, 0}, centre + reach});
            pieces.push_back(clipped(below, HalfPlane{{-1, 0}, reach - centre}));
        }
    }
    std::erase_if(pieces, [](const Polygon& piece) { return piece.empty(); });
    return pieces;
}

// x_i = origin_i + radius cos(angle - direction) where the axis lies across coordinate i; low and high by the radius.
std::vector<Polygon> Chart::between_angles(const Polygon& polygon, std::size_t axis, double low, double high) const
{
    const double direction = std::atan2(second_[axis], first_[axis]);
    if (low >= 1 || high <= -1) {
        return {};
    }
    std::vector<Polygon> pieces(1, polygon);
    if (low > -1) {
        pieces = on_arc(pieces, direction, std::acos(low));
    }
    if (high < 1) {
        pieces = on_arc(pieces, direction + std::numbers::pi, std::numbers::pi - std::acos(high));
    }
    return pieces;
}

std::vector<Polygon> Chart::between(const Polygon& polygon, std::size_t axis, double low, double high) const
{
    if (cylinder_ && std::abs(third_[axis]) < level) {
        return between_angles(polygon, axis, (low - origin_[axis]) / radius_, (high - origin_[axis]) / radius_);
    }
    const auto above = [&](const Vec2& p) { return position(p)[axis] - high; };
    const auto below = [&](const Vec2& p) { return low - position(p)[axis]; };
    std::vector<Polygon> pieces(1, clipped_where(clipped_where(polygon, above), below));
    std::erase_if(pieces, [](const Polygon& piece) { return piece.empty(); });
    return pieces;
}

std::vector<Polygon> Chart::within(const Polygon& polygon, const BoxShape& box) const
{
    std::vector<Polygon> pieces(1, polygon);
    for (std::size_t i = 0; i < 3 && !pieces.empty(); ++i) {
        // a plane across coordinate i lies in the box, or not
        const double slack = !cylinder_ && std::abs(third_[i]) > 1 - level ? face_slack : 0;
        std::vector<Polygon> left;
        for (const Polygon& piece : pieces) {
            const auto found = between(piece, i, box.min[i] - slack, box.max[i] + slack);
            left.insert(left.end(), found.begin(), found.end());
        }
        pieces = std::move(left);
    }
    return pieces;
}

double Chart::share_within(const ChartFace& face, const BoxShape& box) const
{
    constexpr double noise = 1e-9;
    double area = 0;
    for (const Polygon& piece : within(face.polygon, box)) {
        area += signed_area(piece);
    }
    const double share = area / face.full_area;
    return share > 1 - noise ? 1 : share;
}

Vec3 Chart::normal(const Vec2& point) const
{
    if (!cylinder_) {
        return third_;
    }
    const double angle = point[0] / radius_;
    return (sense_ * std::cos(angle)) * first_ + (sense_ * std::sin(angle)) * second_;
}

std::optional<Vec2> Chart::shift(const Vec3& offset, double slack) const
{
    const Vec2 across{dot(offset, first_), dot(offset, second_)};
    const double along = dot(offset, third_);
    if (cylinder_ ? norm(across) > slack : std::abs(along) > slack) {
        return std::nullopt;
    }
    return cylinder_ ? Vec2{0, along} : across;
}

Vec2 local_coordinates(const ChartFace& face, const Vec2& point)
{
    const auto& c = face.corners;
    const auto solve = [](const Vec2& a, const Vec2& b, const Vec2& right) {
        const double determinant = a[0] * b[1] - a[1] * b[0];
        return Vec2{(right[0] * b[1] - right[1] * b[0]) / determinant,
                    (a[0] * right[1] - a[1] * right[0]) / determinant};
    };
    if (face.count == 3) {
        return solve(c[1] - c[0], c[2] - c[0], point - c[0]);
    }
    Vec2 local{0.5, 0.5};
    for (int iteration = 0; iteration < 25; ++iteration) {
        const auto [r, s] = local;
        const Vec2 x = ((1 - r) * (1 - s)) * c[0] + (r * (1 - s)) * c[1] + (r * s) * c[2] + ((1 - r) * s) * c[3];
        const Vec2 dr = (1 - s) * (c[1] - c[0]) + s * (c[2] - c[3]);
        const Vec2 ds = (1 - r) * (c[3] - c[0]) + r * (c[2] - c[1]);
        const Vec2 step = solve(dr, ds, point - x);
        local = local + step;
        if (norm(step) < 1e-13) {
            break;
        }
    }
    return {std::clamp(local[0], 0.0, 1.0), std::clamp(local[1], 0.0, 1.0)};
}

bool can_touch(const FaceGeometry& a, const FaceGeometry& b, double gap)
{
    if (a.index() != b.index()) {
        return false;
    }
    if (const auto* p = std::get_if<PlaneGeometry>(&a)) {
        const auto& q = std::get<PlaneGeometry>(b);
        return norm(p->normal + q.normal) < 1e-6 && std::abs(p->offset + q.offset) <= gap;
    }
    if (const auto* c = std::get_if<CylinderGeometry>(&a)) {
        const auto& d = std::get<CylinderGeometry>(b);
        if (c->bore == d.bore || std::abs(c->radius - d.radius) > gap || !are_parallel(c->axis, d.axis)) {
            return false;
        }
        const Vec3 between = d.point - c->point;
        return norm(between - dot(between, c->axis) * c->axis) <= gap;
    }
    return false;
}

}  // namespace deadpoint::machine
