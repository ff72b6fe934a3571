#include "deadpoint/machine/geometry/part_mesh.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace deadpoint::machine {

namespace {

using Quad = std::array<int, 4>;
constexpr std::array<Quad, 6> hexahedron_faces{
    {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}};
constexpr std::array<std::array<int, 3>, 4> tetrahedron_faces{{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
/// Neighbours of each corner, in right-handed order.
constexpr std::array<std::array<int, 3>, 8> hexahedron_corners{
    {{1, 3, 4}, {2, 0, 5}, {3, 1, 6}, {0, 2, 7}, {7, 5, 0}, {4, 6, 1}, {5, 7, 2}, {6, 4, 3}}};
/// The other nodes, seen from each of the four, in an order that gives a cell its positive volume.
constexpr std::array<std::array<int, 3>, 4> tetrahedron_corners{{{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};
const double gauss = 0.5 / std::sqrt(3.0);

double triple(const Vec3& a, const Vec3& b, const Vec3& c) { return dot(a, cross(b, c)); }

struct KeyedFace {
    FaceKey key{};
    Face face;
};

Face face_through(const Cell& cell, const int* corners, int count)
{
    Face face;
    face.node_count = static_cast<std::uint8_t>(count);
    for (int i = 0; i < 4; ++i) {
        face.nodes[i] = cell.nodes[corners[std::min(i, count - 1)]];
    }
    return face;
}

std::vector<KeyedFace> all_faces(const std::vector<Cell>& cells)
{
    std::vector<KeyedFace> faces;
    faces.reserve(cells.size() * 6);
    for (std::size_t c = 0; c < cells.size(); ++c) {
        for (int i = 0; i < face_count(cells[c].kind); ++i) {
            KeyedFace keyed{{}, machine::face_of(cells[c], i)};
            keyed.face.cell = static_cast<std::uint32_t>(c);
            keyed.key = face_key(keyed.face);
            faces.push_back(keyed);
        }
    }
    return faces;
}

double hexahedron_volume(const Cell& cell, const std::vector<Vec3>& nodes)
{
    double sum = 0;
    const std::array<double, 2> points{0.5 - gauss, 0.5 + gauss};
    for (const double r : points) {
        for (const double s : points) {
            for (const double t : points) {
                Vec3 dr{};
                Vec3 ds{};
                Vec3 dt{};
                for (int i = 0; i < 8; ++i) {
                    const bool right = i % 4 == 1 || i % 4 == 2;
                    const bool back = i % 4 >= 2;
                    const bool top = i >= 4;
                    const double fr = right ? r : 1 - r;
                    const double fs = back ? s : 1 - s;
                    const double ft = top ? t : 1 - t;
                    const Vec3& x = nodes[cell.nodes[i]];
                    dr = dr + ((right ? 1 : -1) * fs * ft) * x;
                    ds = ds + ((back ? 1 : -1) * fr * ft) * x;
                    dt = dt + ((top ? 1 : -1) * fr * fs) * x;
                }
                sum += triple(dr, ds, dt) / 8;
            }
        }
    }
    return sum;
}

double hexahedron_quality(const Cell& cell, const std::vector<Vec3>& nodes)
{
    double worst = 1;
    for (int corner = 0; corner < 8; ++corner) {
        const Vec3& x = nodes[cell.nodes[corner]];
        const Vec3 a = nodes[cell.nodes[hexahedron_corners[corner][0]]] - x;
        const Vec3 b = nodes[cell.nodes[hexahedron_corners[corner][1]]] - x;
        const Vec3 c = nodes[cell.nodes[hexahedron_corners[corner][2]]] - x;
        const double lengths = norm(a) * norm(b) * norm(c);
        worst = std::min(worst, lengths > 0 ? triple(a, b, c) / lengths : 0.0);
    }
    return worst;
}

double tetrahedron_quality(const Cell& cell, const std::vector<Vec3>& nodes)
{
    double best = 0;
    for (int corner = 0; corner < 4; ++corner) {
        const Vec3& x = nodes[cell.nodes[corner]];
        const Vec3 a = nodes[cell.nodes[tetrahedron_corners[corner][0]]] - x;
        const Vec3 b = nodes[cell.nodes[tetrahedron_corners[corner][1]]] - x;
        const Vec3 c = nodes[cell.nodes[tetrahedron_corners[corner][2]]] - x;
        const double lengths = norm(a) * norm(b) * norm(c);
        const double volumes = triple(a, b, c);
        if (volumes <= 0 || lengths <= 0) {
            return std::min(0.0, volumes);
        }
        best = std::max(best, volumes / lengths);
    }
    return std::min(1.0, std::numbers::sqrt2 * best);
}

}  // namespace

Face face_of(const Cell& cell, int number)
{
    return cell.kind == CellKind::hexahedron ? face_through(cell, hexahedron_faces[number].data(), 4)
                                             : face_through(cell, tetrahedron_faces[number].data(), 3);
}

FaceKey face_key(const Face& face)
{
    FaceKey key = face.nodes;
    if (face.node_count == 3) {
        key[3] = std::numeric_limits<std::uint32_t>::max();
    }
    std::sort(key.begin(), key.end());
    return key;
}

std::vector<Face> exterior_faces(const std::vector<Cell>& cells)
{
    std::vector<KeyedFace> faces = all_faces(cells);
    std::vector<std::uint32_t> order(faces.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        order[i] = static_cast<std::uint32_t>(i);
    }
    std::sort(order.begin(), order.end(), [&](std::uint32_t i, std::uint32_t j) {
        return faces[i].key != faces[j].key ? faces[i].key < faces[j].key : i < j;
    });
    std::vector<char> single(faces.size(), 1);
    for (std::size_t i = 1; i < order.size(); ++i) {
        if (faces[order[i]].key == faces[order[i - 1]].key) {
            single[order[i]] = single[order[i - 1]] = 0;
        }
    }
    std::vector<Face> result;
    for (std::size_t i = 0; i < faces.size(); ++i) {
        if (single[i] != 0) {
            result.push_back(faces[i].face);
        }
    }
    return result;
}

double volume(const Cell& cell, const std::vector<Vec3>& nodes)
{
    if (cell.kind == CellKind::hexahedron) {
        return hexahedron_volume(cell, nodes);
    }
    const Vec3& x = nodes[cell.nodes[0]];
    return triple(nodes[cell.nodes[1]] - x, nodes[cell.nodes[2]] - x, nodes[cell.nodes[3]] - x) / 6;
}

Vec3 area_vector(const Face& face, const std::vector<Vec3>& nodes)
{
    const auto& n = face.nodes;
    if (face.node_count == 3) {
        return 0.5 * cross(nodes[n[1]] - nodes[n[0]], nodes[n[2]] - nodes[n[0]]);
    }
    return 0.5 * cross(nodes[n[2]] - nodes[n[0]], nodes[n[3]] - nodes[n[1]]);
}

double area(const Face& face, const std::vector<Vec3>& nodes)
{
    if (face.node_count == 3) {
        return norm(area_vector(face, nodes));
    }
    const auto& n = face.nodes;
    double sum = 0;
    for (const double r : {0.5 - gauss, 0.5 + gauss}) {
        for (const double s : {0.5 - gauss, 0.5 + gauss}) {
            const Vec3 dr = (1 - s) * (nodes[n[1]] - nodes[n[0]]) + s * (nodes[n[2]] - nodes[n[3]]);
            const Vec3 ds = (1 - r) * (nodes[n[3]] - nodes[n[0]]) + r * (nodes[n[2]] - nodes[n[1]]);
            sum += norm(cross(dr, ds)) / 4;
        }
    }
    return sum;
}

Vec3 centre(const Face& face, const std::vector<Vec3>& nodes)
{
    Vec3 sum{};
    for (int i = 0; i < face.node_count; ++i) {
        sum = sum + nodes[face.nodes[i]];
    }
    return (1.0 / face.node_count) * sum;
}

Vec3 centre(const Cell& cell, const std::vector<Vec3>& nodes)
{
    Vec3 sum{};
    const int count = node_count(cell.kind);
    for (int i = 0; i < count; ++i) {
        sum = sum + nodes[cell.nodes[i]];
    }
    return (1.0 / count) * sum;
}

bool inside(const Cell& cell, const std::vector<Vec3>& nodes, const Vec3& point)
{
    for (int i = 0; i < face_count(cell.kind); ++i) {
        const Face face = face_of(cell, i);
        if (dot(point - centre(face, nodes), area_vector(face, nodes)) > 0) {
            return false;
        }
    }
    return true;
}

double quality(const Cell& cell, const std::vector<Vec3>& nodes)
{
    return cell.kind == CellKind::hexahedron ? hexahedron_quality(cell, nodes) : tetrahedron_quality(cell, nodes);
}

Worst worst_cell(const PartMesh& mesh)
{
    Worst worst;
    for (const Cell& cell : mesh.cells) {
        const double own = quality(cell, mesh.nodes);
        if (own < worst.quality) {
            worst = {own, centre(cell, mesh.nodes)};
        }
    }
    return worst;
}

Vec3 position_on(const Face& face, const std::vector<Vec3>& nodes, const Vec2& local)
{
    const auto& n = face.nodes;
    const auto [r, s] = local;
    if (face.node_count == 3) {
        return (1 - r - s) * nodes[n[0]] + r * nodes[n[1]] + s * nodes[n[2]];
    }
    return ((1 - r) * (1 - s)) * nodes[n[0]] + (r * (1 - s)) * nodes[n[1]] + (r * s) * nodes[n[2]] +
           ((1 - r) * s) * nodes[n[3]];
}

}  // namespace deadpoint::machine
