#include "deadpoint/machine/cad/cad_contacts.hpp"

#include "deadpoint/core/units.hpp"

// Coordinates stay numbers of double precision; Boost would round them to integers first.
#define BOOST_GEOMETRY_NO_ROBUSTNESS

#include <algorithm>
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/multi_polygon.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>
#include <cmath>
#include <optional>

namespace deadpoint::machine {
namespace {

namespace geometry = boost::geometry;
using Point = geometry::model::d2::point_xy<double>;
using Region = geometry::model::polygon<Point>;

constexpr double parallel_sine = 1e-3;  ///< sine of the angle

bool apart(const BoxShape& a, const BoxShape& b, double reach)
{
    for (std::size_t i = 0; i < 3; ++i) {
        if (a.min[i] > b.max[i] + reach || b.min[i] > a.max[i] + reach) {
            return true;
        }
    }
    return false;
}

/// Two directions across a third.
std::array<Vec3, 2> axes_in_plane(const Vec3& normal)
{
    const Vec3 other = std::abs(normal[0]) < 0.6 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
    const Vec3 u = normalised(cross(normal, other));
    return {u, cross(normal, u)};
}

void fill(Region::ring_type& ring, const std::vector<Vec3>& loop, const std::array<Vec3, 2>& frame)
{
    for (const Vec3& point : loop) {
        ring.emplace_back(dot(point, frame[0]), dot(point, frame[1]));
    }
}

Region polygon_of(const CadPlane& plane, const std::array<Vec3, 2>& frame)
{
    Region polygon;
    polygon.inners().resize(plane.loops.size() - 1);
    fill(polygon.outer(), plane.loops.front(), frame);
    for (std::size_t i = 1; i < plane.loops.size(); ++i) {
        fill(polygon.inners()[i - 1], plane.loops[i], frame);
    }
    geometry::correct(polygon);
    return polygon;
}

/// What two planes share: its area, and its centroid on the first plane.
struct Shared {
    double area = 0;
    Vec3 centre{};
};

Shared shared(const CadPlane& a, const CadPlane& b)
{
    const auto frame = axes_in_plane(a.normal);
    geometry::model::multi_polygon<Region> common;
    try {
        geometry::intersection(polygon_of(a, frame), polygon_of(b, frame), common);
    } catch (const geometry::exception&) {
        return {};  // an outline that crosses itself bounds no area
    }
    Shared result{geometry::area(common), {}};
    if (result.area > 0) {
        Point middle(0, 0);
        geometry::centroid(common, middle);
        result.centre = middle.x() * frame[0] + middle.y() * frame[1] + a.offset * a.normal;
    }
    return result;
}

std::optional<CadContact> contact_of(const CadPlane& a, const CadPlane& b, const CadReach& reach)
{
    if (dot(a.normal, b.normal) > -0.5 || norm(cross(a.normal, b.normal)) > parallel_sine || a.loops.front().empty() ||
        b.loops.front().empty()) {
        return std::nullopt;
    }
    // Measured at b's outline, so that a slight tilt does not count over a large distance.
    const double gap = dot(a.normal, b.loops.front().front()) - a.offset;
    if (gap > reach.plane || gap < -reach.into) {
        return std::nullopt;
    }
    CadContact contact;
    const Shared common = shared(a, b);
    contact.area = common.area;
    contact.clearance = gap;
    contact.point = common.centre;
    contact.direction = a.normal;
    return contact.area < reach.least_area ? std::nullopt : std::optional(contact);
}

double length_of(const std::array<double, 2>& interval) { return interval[1] - interval[0]; }

std::array<double, 2> common(const std::array<double, 2>& a, const std::array<double, 2>& b)
{
    const double from = std::max(a[0], b[0]);
    return {from, std::max(from, std::min(a[1], b[1]))};
}

/// Shared angle of two arcs about one axis, for all turns of one against the other.
double common_angle(const std::array<double, 2>& a, const std::array<double, 2>& b)
{
    double sum = 0;
    for (int k = -2; k <= 2; ++k) {
        sum += length_of(common(a, {b[0] + k * full_turn, b[1] + k * full_turn}));
    }
    return std::min(sum, full_turn);
}

/// Angles and range of a cylinder in the frame of another about the same axis.
CadCylinder seen_from(const CadCylinder& frame, CadCylinder other)
{
    const bool same_way = dot(frame.axis, other.axis) > 0;
    const Vec3 second = cross(frame.axis, frame.across);
    const double zero = std::atan2(dot(other.across, second), dot(other.across, frame.across));
    const double start = dot(other.point - frame.point, frame.axis);
    if (same_way) {
        other.angles = {zero + other.angles[0], zero + other.angles[1]};
        other.range = {start + other.range[0], start + other.range[1]};
    } else {
        other.angles = {zero - other.angles[1], zero - other.angles[0]};
        other.range = {start - other.range[1], start - other.range[0]};
    }
    return other;
}

/// How much of the rectangle of a cylinder's angles and range is its face.
double fullness(const CadCylinder& cylinder, double area)
{
    const double whole = cylinder.radius * length_of(cylinder.angles) * length_of(cylinder.range);
    return whole > 0 ? std::min(1.0, area / whole) : 0;
}

bool one_axis(const CadCylinder& a, const CadCylinder& b, double off)
{
    const Vec3 way = b.point - a.point;
    return norm(cross(a.axis, b.axis)) < parallel_sine && norm(way - dot(way, a.axis) * a.axis) <= off;
}

std::optional<CadContact> contact_of(const CadCylinder& bore, double bore_area, const CadCylinder& shaft,
                                     double shaft_area, const CadReach& reach)
{
    const double clearance = 2 * (bore.radius - shaft.radius);
    const double most = reach.cylinder * 2 * shaft.radius;
    if (!bore.bore || shaft.bore || clearance > most || clearance < -reach.into ||
        !one_axis(bore, shaft, std::min(0.5 * most, reach.axes))) {
        return std::nullopt;
    }
    const CadCylinder seen = seen_from(bore, shaft);
    CadContact contact;
    contact.kind = CadContact::Kind::cylinder;
    contact.range = common(bore.range, seen.range);
    contact.area = shaft.radius * common_angle(bore.angles, seen.angles) * length_of(contact.range) *
                   fullness(bore, bore_area) * fullness(shaft, shaft_area);
    contact.clearance = clearance;
    contact.diameter = 2 * shaft.radius;
    contact.point = bore.point;
    contact.direction = bore.axis;
    return contact.area < reach.least_area ? std::nullopt : std::optional(contact);
}

bool same_place(const CadContact& one, const CadContact& other)
{
    constexpr double near = 1e-5;
    if (one.kind != other.kind || one.a != other.a || one.b != other.b ||
        norm(cross(one.direction, other.direction)) > parallel_sine || std::abs(one.diameter - other.diameter) > near) {
        return false;
    }
    const Vec3 way = other.point - one.point;
    const double along = dot(way, one.direction);
    return one.kind == CadContact::Kind::plane ? dot(one.direction, other.direction) > 0 && std::abs(along) < near
                                               : norm(way - along * one.direction) < near;
}

void add_to(std::vector<CadContact>& contacts, const CadContact& next)
{
    const auto same = std::ranges::find_if(contacts, [&](const CadContact& one) { return same_place(one, next); });
    if (same == contacts.end()) {
        contacts.push_back(next);
        return;
    }
    const double start = dot(next.point - same->point, same->direction);
    const double sign = dot(next.direction, same->direction) > 0 ? 1 : -1;
    for (const double end : next.range) {
        same->range[0] = std::min(same->range[0], start + sign * end);
        same->range[1] = std::max(same->range[1], start + sign * end);
    }
    if (same->kind == CadContact::Kind::plane) {
        same->point = (1 / (same->area + next.area)) * (same->area * same->point + next.area * next.point);
    }
    same->area += next.area;
}

/// A contact of two faces, whichever is the bore.
std::optional<CadContact> contact_of(const CadFace& one, const CadFace& other, bool& swapped, const CadReach& reach)
{
    swapped = false;
    if (const auto* plane = std::get_if<CadPlane>(&one.form)) {
        const auto* facing = std::get_if<CadPlane>(&other.form);
        return facing != nullptr ? contact_of(*plane, *facing, reach) : std::nullopt;
    }
    const auto* first = std::get_if<CadCylinder>(&one.form);
    const auto* second = std::get_if<CadCylinder>(&other.form);
    if (first == nullptr || second == nullptr) {
        return std::nullopt;
    }
    swapped = second->bore;
    return swapped ? contact_of(*second, other.area, *first, one.area, reach)
                   : contact_of(*first, one.area, *second, other.area, reach);
}

/// A sphere of a solid with the area of all its faces.
struct WholeSphere {
    CadSphere sphere;
    double area = 0;
};

std::vector<WholeSphere> spheres_of(const CadSolid& solid)
{
    constexpr double near = 1e-5;
    std::vector<WholeSphere> spheres;
    for (const CadFace& face : solid.faces) {
        const auto* next = std::get_if<CadSphere>(&face.form);
        if (next == nullptr) {
            continue;
        }
        const auto same = std::ranges::find_if(spheres, [&](const WholeSphere& known) {
            return known.sphere.hollow == next->hollow && norm(known.sphere.centre - next->centre) < near &&
                   std::abs(known.sphere.radius - next->radius) < near;
        });
        if (same == spheres.end()) {
            spheres.push_back({*next, face.area});
        } else {
            same->area += face.area;
        }
    }
    return spheres;
}

/// A ball in a socket.
std::optional<CadContact> contact_of(const WholeSphere& socket, const WholeSphere& ball, const CadReach& reach)
{
    const double clearance = 2 * (socket.sphere.radius - ball.sphere.radius);
    const double most = reach.cylinder * 2 * ball.sphere.radius;
    if (!socket.sphere.hollow || ball.sphere.hollow || clearance > most || clearance < -reach.into ||
        norm(socket.sphere.centre - ball.sphere.centre) > std::min(0.5 * most, reach.axes)) {
        return std::nullopt;
    }
    CadContact contact;
    contact.kind = CadContact::Kind::sphere;
    contact.area = std::min(socket.area, ball.area);
    contact.clearance = clearance;
    contact.diameter = 2 * ball.sphere.radius;
    contact.point = socket.sphere.centre;
    return contact.area < reach.least_area ? std::nullopt : std::optional(contact);
}

void add_balls(const CadModel& model, std::size_t around, std::size_t inside, const CadReach& reach,
               std::vector<CadContact>& into)
{
    for (const WholeSphere& socket : spheres_of(model.solids[around])) {
        for (const WholeSphere& ball : spheres_of(model.solids[inside])) {
            if (auto contact = contact_of(socket, ball, reach)) {
                contact->a = around;
                contact->b = inside;
                into.push_back(*contact);
            }
        }
    }
}

void contacts_of(const CadModel& model, std::size_t a, std::size_t b, const CadReach& reach,
                 std::vector<CadContact>& into)
{
    add_balls(model, a, b, reach, into);
    add_balls(model, b, a, reach, into);
    for (const CadFace& one : model.solids[a].faces) {
        for (const CadFace& other : model.solids[b].faces) {
            bool swapped = false;
            if (auto contact = contact_of(one, other, swapped, reach)) {
                contact->a = swapped ? b : a;
                contact->b = swapped ? a : b;
                add_to(into, *contact);
            }
        }
    }
}

}  // namespace

std::vector<CadContact> find_contacts(const CadModel& model, const CadReach& reach)
{
    std::vector<CadContact> contacts;
    for (std::size_t a = 0; a < model.solids.size(); ++a) {
        for (std::size_t b = a + 1; b < model.solids.size(); ++b) {
            // Diameters may differ by a share of them, which the box of the smaller solid bounds.
            const Vec3 edges = model.solids[a].bounds.max - model.solids[a].bounds.min;
            const double near = std::max(reach.plane, reach.cylinder * *std::ranges::max_element(edges));
            if (!apart(model.solids[a].bounds, model.solids[b].bounds, near)) {
                contacts_of(model, a, b, reach, contacts);
            }
        }
    }
    return contacts;
}

}  // namespace deadpoint::machine
