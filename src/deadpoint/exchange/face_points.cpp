#include "deadpoint/exchange/face_points.hpp"

#include "deadpoint/exchange/heat.hpp"
#include "deadpoint/exchange/machine.hpp"
#include "deadpoint/exchange/round_edges.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace deadpoint {
namespace {

std::vector<FacePoint> quadrilateral_points(const Vec3& p0, const Vec3& p1, const Vec3& p2, const Vec3& p3)
{
    const double g = std::sqrt(0.15);
    const std::array<double, 3> at{0.5 - g, 0.5, 0.5 + g};
    const std::array<double, 3> weight{5.0 / 18, 8.0 / 18, 5.0 / 18};
    std::vector<FacePoint> points;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
            const double s = at[i], t = at[j];
            const Vec3 along_s = (1 - t) * (p1 - p0) + t * (p2 - p3);
            const Vec3 along_t = (1 - s) * (p3 - p0) + s * (p2 - p1);
            const Vec3 x = (1 - s) * (1 - t) * p0 + s * (1 - t) * p1 + s * t * p2 + (1 - s) * t * p3;
            points.push_back({x, weight[i] * weight[j] * norm(cross(along_s, along_t))});
        }
    return points;
}

std::vector<FacePoint> triangle_points(const Vec3& p0, const Vec3& p1, const Vec3& p2)
{
    // Degree 4 rule of Dunavant (1985), six points.
    struct Orbit {
        double corner, other, weight;
    };
    const std::array<Orbit, 2> orbits{{{0.108103018168070, 0.445948490915965, 0.223381589678011},
                                       {0.816847572980459, 0.091576213509771, 0.109951743655322}}};
    const double area = 0.5 * norm(cross(p1 - p0, p2 - p0));
    std::vector<FacePoint> points;
    for (const auto& o : orbits) {
        points.push_back({o.corner * p0 + o.other * p1 + o.other * p2, o.weight * area});
        points.push_back({o.other * p0 + o.corner * p1 + o.other * p2, o.weight * area});
        points.push_back({o.other * p0 + o.other * p1 + o.corner * p2, o.weight * area});
    }
    return points;
}

/// The rule of a face in its local coordinates, which are the positions' first two.
const std::vector<FacePoint>& local_rule(const Face& face)
{
    static const auto four = quadrilateral_points({0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0});
    static const auto three = triangle_points({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    return face.node_count == 3 ? three : four;
}

std::vector<FacePoint> round_points(const Machine& machine, const Face& face)
{
    std::vector<FacePoint> points;
    for (const auto& at : local_rule(face)) {
        const auto place = place_on(machine, face, {at.position[0], at.position[1]});
        points.push_back({place.position, at.weight * norm(cross(place.along_r, place.along_s))});
    }
    return points;
}

}  // namespace

std::vector<FacePoint> face_points(const Machine& machine, const Face& face)
{
    if (is_round(machine, face))
        return round_points(machine, face);
    const auto& x = machine.nodes;
    const auto& n = face.nodes;
    if (face.node_count == 3)
        return triangle_points(x[n[0]], x[n[1]], x[n[2]]);
    return quadrilateral_points(x[n[0]], x[n[1]], x[n[2]], x[n[3]]);
}

double face_area(const Machine& machine, const Face& face)
{
    double area = 0;
    if (is_round(machine, face)) {
        for (const auto& point : round_points(machine, face))
            area += point.weight;
        return area;
    }
    const auto& x = machine.nodes;
    const auto& n = face.nodes;
    for (int i = 2; i < face.node_count; ++i)
        area += 0.5 * norm(cross(x[n[i - 1]] - x[n[0]], x[n[i]] - x[n[0]]));
    return area;
}

double face_volume(const Machine& machine, const Face& face)
{
    double sum = 0;
    for (const auto& at : local_rule(face)) {
        const auto place = place_on(machine, face, {at.position[0], at.position[1]});
        sum += at.weight * dot(place.position, cross(place.along_r, place.along_s)) / 3;
    }
    return sum;
}

std::vector<SurfaceFace> faces_of(const Machine& machine, const SurfaceCondition& condition)
{
    const auto& faces = machine.surfaces[static_cast<std::size_t>(condition.surface)].faces;
    if (condition.part < 0)
        return faces;
    std::vector<SurfaceFace> result;
    std::ranges::copy_if(faces, std::back_inserter(result), [&](const SurfaceFace& face) {
        return machine.faces[face.face].part == static_cast<std::uint32_t>(condition.part);
    });
    return result;
}

}  // namespace deadpoint
