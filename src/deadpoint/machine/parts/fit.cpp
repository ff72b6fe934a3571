#include "deadpoint/machine/parts/fit.hpp"

#include "deadpoint/machine/geometry/part_mesh.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <set>

namespace deadpoint::machine {

namespace {

constexpr double plane_tolerance = 1e-7;
constexpr double relative_tolerance = 1e-6;
constexpr double snap_tolerance = 1e-6;
const double smooth_cosine = std::cos(40 * std::numbers::pi / 180);
const double coplanar_cosine = std::cos(0.5 * std::numbers::pi / 180);

/// Solves a small dense system by elimination with pivoting; nothing if it is singular.
template <std::size_t n>
std::optional<std::array<double, n>> solve(std::array<std::array<double, n>, n> a, std::array<double, n> b)
{
    for (std::size_t k = 0; k < n; ++k) {
        std::size_t pivot = k;
        for (std::size_t i = k + 1; i < n; ++i) {
            if (std::abs(a[i][k]) > std::abs(a[pivot][k])) {
                pivot = i;
            }
        }
        if (std::abs(a[pivot][k]) < 1e-30) {
            return std::nullopt;
        }
        std::swap(a[k], a[pivot]);
        std::swap(b[k], b[pivot]);
        for (std::size_t i = k + 1; i < n; ++i) {
            const double factor = a[i][k] / a[k][k];
            for (std::size_t j = k; j < n; ++j) {
                a[i][j] -= factor * a[k][j];
            }
            b[i] -= factor * b[k];
        }
    }
    for (std::size_t k = n; k-- > 0;) {
        for (std::size_t j = k + 1; j < n; ++j) {
            b[k] -= a[k][j] * b[j];
        }
        b[k] /= a[k][k];
    }
    return b;
}

/// A unit vector, along a coordinate axis if it nearly is.
Vec3 snapped(const Vec3& direction)
{
    for (std::size_t i = 0; i < 3; ++i) {
        if (std::abs(std::abs(direction[i]) - 1) < snap_tolerance) {
            Vec3 axis{};
            axis[i] = std::copysign(1.0, direction[i]);
            if (norm(axis - direction) < snap_tolerance) {
                return axis;
            }
        }
    }
    return direction;
}

std::vector<Vec3> points_of(const std::vector<Face>& faces, const std::vector<std::uint32_t>& members,
                            const std::vector<Vec3>& nodes)
{
    std::set<std::uint32_t> used;
    for (const std::uint32_t member : members) {
        for (int i = 0; i < faces[member].node_count; ++i) {
            used.insert(faces[member].nodes[i]);
        }
    }
    std::vector<Vec3> points;
    for (const std::uint32_t node : used) {
        points.push_back(nodes[node]);
    }
    return points;
}

Vec3 mean(const std::vector<Vec3>& points)
{
    Vec3 sum{};
    for (const Vec3& point : points) {
        sum = sum + point;
    }
    return (1.0 / static_cast<double>(points.size())) * sum;
}

std::optional<PlaneGeometry> fit_plane(const Vec3& area_sum, const std::vector<Vec3>& points)
{
    if (norm(area_sum) == 0) {
        return std::nullopt;
    }
    PlaneGeometry plane;
    plane.normal = snapped(normalised(area_sum));
    plane.offset = dot(plane.normal, mean(points));
    for (const Vec3& point : points) {
        if (std::abs(dot(plane.normal, point) - plane.offset) > plane_tolerance) {
            return std::nullopt;
        }
    }
    return plane;
}

/// The direction to which the normals are most perpendicular: smallest eigenvector by inverse iteration.
Vec3 axis_across(const std::vector<Vec3>& normals)
{
    std::array<std::array<double, 3>, 3> matrix{};
    for (const Vec3& n : normals) {
        for (std::size_t i = 0; i < 3; ++i) {
            for (std::size_t j = 0; j < 3; ++j) {
                matrix[i][j] += n[i] * n[j];
            }
        }
    }
    const double trace = matrix[0][0] + matrix[1][1] + matrix[2][2];
    for (std::size_t i = 0; i < 3; ++i) {
        matrix[i][i] += 1e-9 * trace;
    }
    Vec3 axis = normalised({0.5377, 0.6123, 0.5794});
    for (int iteration = 0; iteration < 30; ++iteration) {
        const auto next = solve<3>(matrix, axis);
        if (!next || norm(*next) == 0) {
            break;
        }
        axis = normalised(*next);
    }
    return axis;
}

double distance_to_axis(const CylinderGeometry& cylinder, const Vec3& point)
{
    const Vec3 arm = point - cylinder.point;
    return norm(arm - dot(arm, cylinder.axis) * cylinder.axis);
}

bool fits(const CylinderGeometry& cylinder, const std::vector<Vec3>& points)
{
    const double tolerance = std::max(plane_tolerance, relative_tolerance * cylinder.radius);
    return std::all_of(points.begin(), points.end(), [&](const Vec3& point) {
        return std::abs(distance_to_axis(cylinder, point) - cylinder.radius) < tolerance;
    });
}

std::array<Vec3, 2> axes_across(const Vec3& axis)
{
    std::size_t smallest = 0;
    for (std::size_t i = 1; i < 3; ++i) {
        if (std::abs(axis[i]) < std::abs(axis[smallest])) {
            smallest = i;
        }
    }
    Vec3 help{};
    help[smallest] = 1;
    const Vec3 first = normalised(help - dot(help, axis) * axis);
    return {first, cross(axis, first)};
}

/// Circle through the points seen along the axis, by linear least squares (Kasa).
std::optional<CylinderGeometry> circle_along(const Vec3& axis, const std::vector<Vec3>& points)
{
    const auto [e1, e2] = axes_across(axis);
    const Vec3 origin = mean(points);
    std::array<std::array<double, 3>, 3> matrix{};
    std::array<double, 3> right{};
    for (const Vec3& point : points) {
        const Vec3 arm = point - origin;
        const std::array<double, 3> row{dot(arm, e1), dot(arm, e2), 1.0};
        const double square = row[0] * row[0] + row[1] * row[1];
        for (std::size_t i = 0; i < 3; ++i) {
            for (std::size_t j = 0; j < 3; ++j) {
                matrix[i][j] += row[i] * row[j];
            }
            right[i] += row[i] * square;
        }
    }
    const auto x = solve<3>(matrix, right);
    if (!x) {
        return std::nullopt;
    }
    const double u = (*x)[0] / 2;
    const double v = (*x)[1] / 2;
    const double square = (*x)[2] + u * u + v * v;
    if (!(square > 0)) {
        return std::nullopt;
    }
    CylinderGeometry cylinder;
    cylinder.axis = axis;
    cylinder.point = origin + u * e1 + v * e2;
    cylinder.radius = std::sqrt(square);
    return cylinder;
}

/// Gauss-Newton on centre, direction and radius for an oblique axis.
std::optional<CylinderGeometry> refined(CylinderGeometry cylinder, const std::vector<Vec3>& points)
{
    for (int iteration = 0; iteration < 10; ++iteration) {
        const auto [e1, e2] = axes_across(cylinder.axis);
        std::array<std::array<double, 5>, 5> matrix{};
        std::array<double, 5> right{};
        for (const Vec3& point : points) {
            const Vec3 arm = point - cylinder.point;
            const double t = dot(arm, cylinder.axis);
            const Vec3 radial = arm - t * cylinder.axis;
            const double distance = norm(radial);
            if (distance == 0) {
                return std::nullopt;
            }
            const double n1 = dot(radial, e1) / distance;
            const double n2 = dot(radial, e2) / distance;
            const std::array<double, 5> row{n1, n2, t * n1, t * n2, 1.0};
            for (std::size_t i = 0; i < 5; ++i) {
                for (std::size_t j = 0; j < 5; ++j) {
                    matrix[i][j] += row[i] * row[j];
                }
                right[i] += row[i] * (distance - cylinder.radius);
            }
        }
        const auto step = solve<5>(matrix, right);
        if (!step) {
            return std::nullopt;
        }
        const auto& s = *step;
        cylinder.point = cylinder.point + s[0] * e1 + s[1] * e2;
        cylinder.axis = normalised(cylinder.axis + s[2] * e1 + s[3] * e2);
        cylinder.radius += s[4];
    }
    return cylinder.radius > 0 ? std::optional(cylinder) : std::nullopt;
}

std::optional<CylinderGeometry> fit_cylinder(const std::vector<Vec3>& normals, const std::vector<Vec3>& points)
{
    if (points.size() < 6) {
        return std::nullopt;
    }
    const Vec3 guess = axis_across(normals);
    for (std::size_t i = 0; i < 3; ++i) {
        if (std::abs(guess[i]) < 0.98) {
            continue;
        }
        Vec3 axis{};
        axis[i] = 1;
        const auto exact = circle_along(axis, points);
        if (exact && fits(*exact, points)) {
            return exact;
        }
    }
    const auto start = circle_along(guess, points);
    if (!start) {
        return std::nullopt;
    }
    const auto result = refined(*start, points);
    return result && fits(*result, points) ? result : std::nullopt;
}

using Members = std::vector<std::uint32_t>;

/// For each face, its neighbours over edges.
std::vector<Members> neighbours_of(const std::vector<Face>& faces)
{
    std::map<std::pair<std::uint32_t, std::uint32_t>, Members> edges;
    for (std::uint32_t f = 0; f < faces.size(); ++f) {
        const int count = faces[f].node_count;
        for (int i = 0; i < count; ++i) {
            edges[std::minmax(faces[f].nodes[i], faces[f].nodes[(i + 1) % count])].push_back(f);
        }
    }
    std::vector<Members> result(faces.size());
    for (const auto& [edge, pair] : edges) {
        if (pair.size() != 2) {
            continue;
        }
        result[pair[0]].push_back(pair[1]);
        result[pair[1]].push_back(pair[0]);
    }
    return result;
}

class Recogniser {
public:
    Recogniser(PartMesh& mesh, const std::vector<int>& labels)
        : mesh_(mesh), labels_(labels), neighbours_(neighbours_of(mesh.faces))
    {
        for (const Face& face : mesh.faces) {
            normals_.push_back(normalised(area_vector(face, mesh.nodes)));
        }
        mesh_.geometries.clear();
    }

    void run()
    {
        Members all(mesh_.faces.size());
        for (std::uint32_t i = 0; i < all.size(); ++i) {
            all[i] = i;
        }
        Members rest;
        std::map<int, Members> by_label;
        for (const std::uint32_t face : all) {
            if (labels_[face] < 0) {
                rest.push_back(face);
            } else {
                by_label[labels_[face]].push_back(face);
            }
        }
        for (const auto& [label, members] : by_label) {
            if (!assign(members)) {
                rest.insert(rest.end(), members.begin(), members.end());
            }
        }
        std::sort(rest.begin(), rest.end());
        divide(rest);
    }

private:
    bool assign(const Members& members)
    {
        const FaceGeometry geometry = fit_geometry(mesh_.faces, members, mesh_.nodes);
        if (std::holds_alternative<FreeformGeometry>(geometry)) {
            return false;
        }
        store(members, geometry);
        return true;
    }

    void store(const Members& members, const FaceGeometry& geometry)
    {
        for (const std::uint32_t face : members) {
            mesh_.faces[face].geometry = static_cast<std::uint32_t>(mesh_.geometries.size());
        }
        mesh_.geometries.push_back(geometry);
    }

    /// Connected faces of one label whose normals differ by less than an angle from face to face.
    [[nodiscard]] std::vector<Members> patches(const Members& members, double cosine) const
    {
        std::vector<char> open(mesh_.faces.size(), 0);
        for (const std::uint32_t face : members) {
            open[face] = 1;
        }
        std::vector<Members> result;
        for (const std::uint32_t seed : members) {
            if (open[seed] == 0) {
                continue;
            }
            open[seed] = 0;
            Members patch{seed};
            for (std::size_t i = 0; i < patch.size(); ++i) {
                for (const std::uint32_t next : neighbours_[patch[i]]) {
                    if (open[next] == 0 || labels_[next] != labels_[seed] ||
                        dot(normals_[patch[i]], normals_[next]) < cosine) {
                        continue;
                    }
                    open[next] = 0;
                    patch.push_back(next);
                }
            }
            std::sort(patch.begin(), patch.end());
            result.push_back(std::move(patch));
        }
        return result;
    }

    /// Whether at least one node has only faces of the patch around it; a strip of a coarse cylinder has no such node.
    [[nodiscard]] bool has_inner_node(const Members& patch) const
    {
        std::map<std::uint32_t, int> uses;
        for (const std::uint32_t face : patch) {
            for (int i = 0; i < mesh_.faces[face].node_count; ++i) {
                ++uses[mesh_.faces[face].nodes[i]];
            }
        }
        return std::any_of(uses.begin(), uses.end(),
                           [&](const auto& use) { return use.second == faces_at_.at(use.first); });
    }

    void divide(const Members& members)
    {
        for (const Face& face : mesh_.faces) {
            for (int i = 0; i < face.node_count; ++i) {
                ++faces_at_[face.nodes[i]];
            }
        }
        for (const Members& patch : patches(members, smooth_cosine)) {
            if (assign(patch)) {
                continue;
            }
            Members curved;
            for (const Members& flat : patches(patch, coplanar_cosine)) {
                if (!has_inner_node(flat) || !assign(flat)) {
                    curved.insert(curved.end(), flat.begin(), flat.end());
                }
            }
            std::sort(curved.begin(), curved.end());
            for (const Members& piece : patches(curved, smooth_cosine)) {
                if (!assign(piece)) {
                    store(piece, FreeformGeometry{});
                }
            }
        }
    }

    PartMesh& mesh_;
    const std::vector<int>& labels_;
    std::vector<Members> neighbours_;
    std::vector<Vec3> normals_;
    std::map<std::uint32_t, int> faces_at_;
};

}  // namespace

FaceGeometry fit_geometry(const std::vector<Face>& faces, const std::vector<std::uint32_t>& members,
                          const std::vector<Vec3>& nodes)
{
    const std::vector<Vec3> points = points_of(faces, members, nodes);
    Vec3 area_sum{};
    std::vector<Vec3> normals;
    for (const std::uint32_t member : members) {
        const Vec3 own = area_vector(faces[member], nodes);
        area_sum = area_sum + own;
        normals.push_back(normalised(own));
    }
    if (const auto plane = fit_plane(area_sum, points)) {
        return *plane;
    }
    auto cylinder = fit_cylinder(normals, points);
    if (!cylinder) {
        return FreeformGeometry{};
    }
    double outwards = 0;
    for (const std::uint32_t member : members) {
        outwards += dot(area_vector(faces[member], nodes), centre(faces[member], nodes) - cylinder->point);
    }
    cylinder->bore = outwards < 0;
    return *cylinder;
}

void recognise_geometries(PartMesh& mesh, const std::vector<int>& labels) { Recogniser(mesh, labels).run(); }

}  // namespace deadpoint::machine
