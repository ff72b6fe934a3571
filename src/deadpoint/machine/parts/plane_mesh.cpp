#include "deadpoint/error.hpp"
#include "deadpoint/machine/parts/arrangement.hpp"
#include "deadpoint/machine/parts/gmsh_session.hpp"
#include "deadpoint/machine/parts/layers.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <gmsh.h>
#include <limits>
#include <map>
#include <numbers>
#include <set>
#include <unordered_map>

/// The plane arrangement of outlines, meshed with quadrilaterals.
namespace deadpoint::machine {

namespace {

constexpr int least_segments = 24;
/// Both ways to quadrilaterals mesh with double size and split every edge in two in the end.
constexpr int splitting = 2;
/// Smallest sine of a corner that is good enough not to try another way.
constexpr double good_corner = 0.3;
/// The same, good enough not to try another algorithm for the triangles.
constexpr double fair_corner = 0.1;

/// Ways to quadrilaterals, the usually best one first.
enum class Recombination { full_quads, blossom_split, simple_split };
constexpr std::array<Recombination, 3> recombinations{Recombination::full_quads, Recombination::blossom_split,
                                                      Recombination::simple_split};
/// A slightly different division often avoids a bad corner.
constexpr std::array<double, 3> size_factors{1.0, 0.93, 0.86};
/// Gmsh's numbers of its algorithms for the triangles: frontal, Delaunay, mesh adaptation. The first one gives the best
/// quadrilaterals; around some bores it makes triangles that lie in each other, where the second one does not.
constexpr std::array<int, 3> algorithms{6, 5, 1};
/// One way to mesh the arrangement.
struct Way {
    int algorithm = algorithms.front();
    double size_factor = 1;
    Recombination recombination = Recombination::full_quads;
};
constexpr double two_pi = 2 * std::numbers::pi;

/// How finely to mesh: cell size, and segments per full circle at least.
struct Fineness {
    double size = 0;
    double segments = least_segments;
};

std::vector<Circle> circles_of(const LayeredPart& part)
{
    std::vector<Circle> circles;
    for (const Prism& prism : part.prisms) {
        if (!prism.section.circle) {
            continue;
        }
        circles.push_back(*prism.section.circle);
        if (prism.section.bore_radius > 0) {
            circles.push_back({prism.section.circle->centre, prism.section.bore_radius});
        }
    }
    return circles;
}

PlaneCurve identified(const std::vector<Vec2>& samples, const std::vector<Circle>& circles)
{
    PlaneCurve curve{std::nullopt, samples.front(), samples.back()};
    const Vec2 chord = curve.to - curve.from;
    const double length = norm(chord);
    double bow = 0;
    for (const Vec2& p : samples) {
        const Vec2 d = p - curve.from;
        bow = std::max(bow, length > 0 ? std::abs(chord[0] * d[1] - chord[1] * d[0]) / length : norm(d));
    }
    if (bow < 1e-8) {
        return curve;
    }
    double best = 1e-6;
    for (const Circle& circle : circles) {
        double worst = 0;
        for (const Vec2& p : samples) {
            worst = std::max(worst, std::abs(norm(p - circle.centre) - circle.radius));
        }
        if (worst < best) {
            best = worst;
            curve.circle = circle;
        }
    }
    return curve;
}

double arc_angle(const std::vector<Vec2>& samples, const Circle& circle)
{
    double length = 0;
    for (std::size_t i = 0; i + 1 < samples.size(); ++i) {
        length += norm(samples[i + 1] - samples[i]);
    }
    return length / circle.radius;
}

/// A curve of the arrangement while it is being divided.
struct CurveData {
    PlaneCurve curve;
    std::vector<Vec2> samples;
    std::array<int, 2> ends{};
};

/// Least distance to curves without a common end: the thickness of thin walls and rings.
double clearance(const CurveData& own, const std::map<int, CurveData>& curves)
{
    double nearest = std::numeric_limits<double>::infinity();
    for (const auto& entry : curves) {
        const CurveData& other = entry.second;
        const auto shares = [&](int end) { return end == other.ends[0] || end == other.ends[1]; };
        if (&other == &own || shares(own.ends[0]) || shares(own.ends[1])) {
            continue;
        }
        for (std::size_t i = 8; i + 8 < own.samples.size(); i += 4) {
            const Vec2& point = own.samples[i];
            for (std::size_t k = 0; k + 1 < other.samples.size(); ++k) {
                const Vec2 edge = other.samples[k + 1] - other.samples[k];
                const double s = std::clamp(dot(point - other.samples[k], edge) / dot(edge, edge), 0.0, 1.0);
                nearest = std::min(nearest, norm(point - other.samples[k] - s * edge));
            }
        }
    }
    return nearest;
}

/// Along arcs, cells beside thin rings are at most this much longer than the ring is thick.
constexpr double ring_aspect = 2.5;
/// Smallest share of the wanted size that thin rings may ask for.
constexpr double least_refinement = 0.2;

void divide_curve(int tag, const PlaneCurve& curve, const std::vector<Vec2>& samples, const Fineness& fine,
                  Recombination way)
{
    int count = 1;
    if (curve.circle) {
        const double angle = arc_angle(samples, *curve.circle);
        const int by_angle = static_cast<int>(std::ceil(angle * fine.segments / splitting / two_pi - 0.05));
        count = std::max(by_angle, steps(angle * curve.circle->radius, splitting * fine.size));
    } else {
        count = steps(norm(curve.to - curve.from), splitting * fine.size);
    }
    // full quads first use every second node of the curve
    gmsh::model::mesh::setTransfiniteCurve(tag, (way == Recombination::full_quads ? splitting : 1) * count + 1);
}

/// Node tags to indices, in the order of first use.
class PlaneNumbering {
public:
    explicit PlaneNumbering(std::vector<Vec2>& nodes) : nodes_(nodes)
    {
        std::vector<std::size_t> tags;
        std::vector<double> coordinates;
        std::vector<double> parameters;
        gmsh::model::mesh::getNodes(tags, coordinates, parameters);
        for (std::size_t i = 0; i < tags.size(); ++i) {
            positions_[tags[i]] = {coordinates[3 * i] * gmsh_unit, coordinates[3 * i + 1] * gmsh_unit};
        }
    }
    std::uint32_t operator()(std::size_t tag)
    {
        const auto [entry, fresh] = indices_.try_emplace(tag, static_cast<std::uint32_t>(nodes_.size()));
        if (fresh) {
            nodes_.push_back(positions_.at(tag));
        }
        return entry->second;
    }

private:
    std::vector<Vec2>& nodes_;
    std::unordered_map<std::size_t, Vec2> positions_;
    std::unordered_map<std::size_t, std::uint32_t> indices_;
};

void orient(std::array<std::uint32_t, 4>& quad, const std::vector<Vec2>& nodes)
{
    const Vec2 d1 = nodes[quad[2]] - nodes[quad[0]];
    const Vec2 d2 = nodes[quad[3]] - nodes[quad[1]];
    if (d1[0] * d2[1] - d1[1] * d2[0] < 0) {
        std::swap(quad[1], quad[3]);
    }
}

void collect_face(PlaneMesh& mesh, PlaneNumbering& numbering, int face, std::uint32_t region)
{
    constexpr int triangle_type = 2;
    constexpr int quad_type = 3;
    std::vector<std::size_t> elements;
    std::vector<std::size_t> nodes;
    gmsh::model::mesh::getElementsByType(triangle_type, elements, nodes, face);
    if (!elements.empty()) {
        throw std::runtime_error(fmt::format("{} triangles are left", elements.size()));
    }
    gmsh::model::mesh::getElementsByType(quad_type, elements, nodes, face);
    for (std::size_t i = 0; i < elements.size(); ++i) {
        std::array<std::uint32_t, 4> quad{};
        for (std::size_t k = 0; k < 4; ++k) {
            quad[k] = numbering(nodes[4 * i + k]);
        }
        orient(quad, mesh.nodes);
        mesh.quads.push_back(quad);
        mesh.region.push_back(region);
    }
}

void collect_curve(PlaneMesh& mesh, PlaneNumbering& numbering, int tag, const PlaneCurve& curve)
{
    constexpr int line_type = 1;
    std::vector<std::size_t> elements;
    std::vector<std::size_t> nodes;
    gmsh::model::mesh::getElementsByType(line_type, elements, nodes, tag);
    const auto index = static_cast<std::uint32_t>(mesh.curves.size());
    mesh.curves.push_back(curve);
    for (std::size_t i = 0; i < elements.size(); ++i) {
        const PlaneMesh::CurveEdge edge{numbering(nodes[2 * i]), numbering(nodes[2 * i + 1]), index};
        mesh.curve_edges.push_back(edge);
        if (!curve.circle) {
            continue;
        }
        for (const std::uint32_t node : {edge.from, edge.to}) {
            const Vec2 arm = mesh.nodes[node] - curve.circle->centre;
            mesh.nodes[node] = curve.circle->centre + (curve.circle->radius / norm(arm)) * arm;
        }
    }
}

std::map<int, CurveData> curves_of(const LayeredPart& part, const SurfaceGroups& groups)
{
    const std::vector<Circle> circles = circles_of(part);
    std::map<int, CurveData> curves;
    for (const auto& [own, faces] : groups) {
        for (const int face : faces) {
            for (const int tag : boundary_curves(face)) {
                if (curves.contains(tag)) {
                    continue;
                }
                CurveData data;
                data.samples = sampled(tag, 64);
                data.curve = identified(data.samples, circles);
                data.ends = ends_of(tag);
                curves.emplace(tag, std::move(data));
            }
        }
    }
    return curves;
}

void choose(const Way& way, double size)
{
    const bool full = way.recombination == Recombination::full_quads;
    const bool blossom = way.recombination == Recombination::blossom_split;
    gmsh::option::setNumber("Mesh.Algorithm", way.algorithm);
    gmsh::option::setNumber("Mesh.MeshSizeMax", to_gmsh(splitting * size));
    gmsh::option::setNumber("Mesh.RecombineAll", 1);
    gmsh::option::setNumber("Mesh.RecombinationAlgorithm", full ? 2 : (blossom ? 1 : 0));
    gmsh::option::setNumber("Mesh.SubdivisionAlgorithm", full ? 0 : 1);
}

PlaneMesh generate(const LayeredPart& part, const Fineness& fine, const Way& way)
{
    reset_gmsh();
    const SurfaceGroups groups = build_arrangement(part);

    const std::map<int, CurveData> curves = curves_of(part, groups);
    for (const auto& [tag, data] : curves) {
        const double thin = data.curve.circle ? ring_aspect * clearance(data, curves) : fine.size;
        const double own = std::clamp(thin, least_refinement * fine.size, fine.size);
        divide_curve(tag, data.curve, data.samples, {own, fine.segments}, way.recombination);
    }
    choose(way, fine.size);
    gmsh::model::mesh::generate(2);

    PlaneMesh mesh;
    PlaneNumbering numbering(mesh.nodes);
    for (const auto& [own, faces] : groups) {
        for (const int face : faces) {
            collect_face(mesh, numbering, face, static_cast<std::uint32_t>(mesh.signatures.size()));
        }
        mesh.signatures.push_back(own);
    }
    for (const auto& [tag, data] : curves) {
        collect_curve(mesh, numbering, tag, data.curve);
    }
    return mesh;
}

double worst_corner(const PlaneMesh& mesh)
{
    double worst = mesh.quads.empty() ? -1.0 : 1.0;
    for (std::size_t q = 0; q < mesh.quads.size(); ++q) {
        worst = std::min(worst, worst_corner(mesh, q));
    }
    return worst;
}

/// Gmsh may fail to keep a curve between two faces and fold quadrilaterals over each other: then two of them are on the
/// same side of an edge.
bool folded(const PlaneMesh& mesh)
{
    std::set<std::array<std::uint32_t, 2>> edges;
    for (const auto& quad : mesh.quads) {
        for (std::size_t i = 0; i < 4; ++i) {
            if (!edges.insert({quad[i], quad[(i + 1) % 4]}).second) {
                return true;
            }
        }
    }
    return false;
}

/// In the order in which they are tried.
std::vector<Way> all_ways()
{
    std::vector<Way> ways;
    for (const int algorithm : algorithms) {
        for (const double factor : size_factors) {
            for (const auto recombination : recombinations) {
                ways.push_back({algorithm, factor, recombination});
            }
        }
    }
    return ways;
}

}  // namespace

PlaneMesh mesh_plane(const std::string& name, const LayeredPart& part, double size)
{
    PlaneMesh best;
    double best_corner = -2;
    std::string failure;
    const auto attempt = [&](const Way& way) {
        PlaneMesh mesh = generate(part, {way.size_factor * size, least_segments / way.size_factor}, way);
        if (folded(mesh)) {
            throw std::runtime_error("its quadrilaterals lie in each other");
        }
        smooth(mesh);
        const double corner = worst_corner(mesh);
        if (corner > best_corner) {
            best_corner = corner;
            best = std::move(mesh);
        }
    };
    for (const Way& way : all_ways()) {
        if (best_corner > (way.algorithm == algorithms.front() ? good_corner : fair_corner)) {
            return best;
        }
        try {
            guard_gmsh(name, "meshing its cross-section with quadrilaterals", [&] { attempt(way); });
        } catch (const InputError& error) {
            failure = error.what();
        }
    }
    if (best.quads.empty() && !failure.empty()) {
        throw InputError(failure);
    }
    return best;
}

}  // namespace deadpoint::machine
