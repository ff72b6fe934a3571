#include "deadpoint/machine/assembly/contacts.hpp"

#include "deadpoint/error.hpp"
#include "deadpoint/exchange/face_points.hpp"
#include "deadpoint/exchange/round_edges.hpp"
#include "deadpoint/machine/assembly/assembly.hpp"
#include "deadpoint/machine/assembly/round.hpp"
#include "deadpoint/machine/geometry/chart.hpp"
#include "deadpoint/machine/geometry/part_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <map>
#include <utility>

namespace deadpoint::machine {

namespace {

/// Shares of a face smaller than this are noise of the clipping.
constexpr double least_overlap_share = 1e-10;

struct Rectangle {
    Vec2 low{};
    Vec2 high{};
};

Rectangle bounds(const Polygon& polygon)
{
    Rectangle box{polygon.front(), polygon.front()};
    for (const Vec2& p : polygon) {
        for (std::size_t i = 0; i < 2; ++i) {
            box.low[i] = std::min(box.low[i], p[i]);
            box.high[i] = std::max(box.high[i], p[i]);
        }
    }
    return box;
}

Polygon shifted(Polygon polygon, const Vec2& shift)
{
    for (Vec2& p : polygon) {
        p = p + shift;
    }
    return polygon;
}

/// Finds polygons by their bounding boxes through a uniform grid.
class PolygonGrid {
public:
    explicit PolygonGrid(const std::vector<Rectangle>& boxes)
        : boxes_(boxes), all_(boxes.front()), seen_(boxes.size(), 0)
    {
        Vec2 mean{};
        for (const Rectangle& box : boxes) {
            for (std::size_t i = 0; i < 2; ++i) {
                all_.low[i] = std::min(all_.low[i], box.low[i]);
                all_.high[i] = std::max(all_.high[i], box.high[i]);
                mean[i] += (box.high[i] - box.low[i]) / static_cast<double>(boxes.size());
            }
        }
        for (std::size_t i = 0; i < 2; ++i) {
            const double count = mean[i] > 0 ? (all_.high[i] - all_.low[i]) / mean[i] : 1.0;
            counts_[i] = static_cast<int>(std::clamp(count, 1.0, 256.0));
        }
        cells_.resize(static_cast<std::size_t>(counts_[0]) * static_cast<std::size_t>(counts_[1]));
        for (std::uint32_t k = 0; k < boxes.size(); ++k) {
            visit(boxes[k], [&](std::vector<std::uint32_t>& cell) { cell.push_back(k); });
        }
    }

    /// Indices of boxes that overlap `box`, ascending.
    std::vector<std::uint32_t> find(const Rectangle& box)
    {
        ++stamp_;
        std::vector<std::uint32_t> found;
        visit(box, [&](const std::vector<std::uint32_t>& cell) {
            for (const std::uint32_t k : cell) {
                if (seen_[k] == stamp_ || !overlap(boxes_[k], box)) {
                    continue;
                }
                seen_[k] = stamp_;
                found.push_back(k);
            }
        });
        std::sort(found.begin(), found.end());
        return found;
    }

private:
    static bool overlap(const Rectangle& a, const Rectangle& b)
    {
        return a.low[0] < b.high[0] && b.low[0] < a.high[0] && a.low[1] < b.high[1] && b.low[1] < a.high[1];
    }
    [[nodiscard]] int cell_of(double value, std::size_t i) const
    {
        const double width = all_.high[i] - all_.low[i];
        const double place = width > 0 ? (value - all_.low[i]) / width * counts_[i] : 0.0;
        return static_cast<int>(std::clamp(std::floor(place), 0.0, counts_[i] - 1.0));
    }
    template <typename Visitor>
    void visit(const Rectangle& box, Visitor visitor)
    {
        for (int j = cell_of(box.low[1], 1); j <= cell_of(box.high[1], 1); ++j) {
            for (int i = cell_of(box.low[0], 0); i <= cell_of(box.high[0], 0); ++i) {
                visitor(cells_[static_cast<std::size_t>(j) * static_cast<std::size_t>(counts_[0]) +
                               static_cast<std::size_t>(i)]);
            }
        }
    }

    const std::vector<Rectangle>& boxes_;
    Rectangle all_;
    std::array<int, 2> counts_{1, 1};
    std::vector<std::vector<std::uint32_t>> cells_;
    std::vector<std::uint32_t> seen_;
    std::uint32_t stamp_ = 0;
};

using FacesByGeometry = std::map<std::uint32_t, std::vector<std::uint32_t>>;

FacesByGeometry by_geometry(const Machine& machine, const std::vector<std::uint32_t>& faces)
{
    FacesByGeometry result;
    for (const std::uint32_t face : faces) {
        result[machine.faces[face].geometry].push_back(face);
    }
    return result;
}

/// A point of the boundary of a face: local coordinates a share of the way along an edge.
Vec2 point_on_edge(int node_count, int edge, double share)
{
    static constexpr std::array<Vec2, 4> four{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
    static constexpr std::array<Vec2, 3> three{{{0, 0}, {1, 0}, {0, 1}}};
    const auto corner = [&](int i) { return node_count == 3 ? three[i % 3] : four[i % 4]; };
    return (1 - share) * corner(edge) + share * corner(edge + 1);
}

/// A plane face with round edges as triangles around its middle, its round edges in chords of a sixth.
std::vector<Polygon> fan_of(const Machine& machine, const Chart& chart, const Face& face)
{
    constexpr int chords = 6;
    std::vector<Vec2> outline;
    const auto place = [&](const Vec2& local) { return chart.parameters(place_on(machine, face, local).position); };
    for (int i = 0; i < face.node_count; ++i) {
        const bool round = bulge(machine, face.nodes[i], face.nodes[(i + 1) % face.node_count]) != Vec3{};
        const int pieces = round ? chords : 1;
        for (int k = 0; k < pieces; ++k) {
            outline.push_back(place(point_on_edge(face.node_count, i, static_cast<double>(k) / pieces)));
        }
    }
    const Vec2 middle = place(face.node_count == 3 ? Vec2{1.0 / 3, 1.0 / 3} : Vec2{0.5, 0.5});
    std::vector<Polygon> triangles;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        Polygon triangle{middle, outline[i], outline[(i + 1) % outline.size()]};
        if (signed_area(triangle) < 0) {
            std::swap(triangle[1], triangle[2]);
        }
        triangles.push_back(std::move(triangle));
    }
    return triangles;
}

/// The polygons of a face in a chart: its own, or those of its fan, which then count by the face's true area.
std::vector<Polygon> outlines(const Machine& machine, const Chart& chart, ChartFace& chart_face)
{
    const Face& face = machine.faces[chart_face.face];
    if (chart.period() > 0 || !is_round(machine, face)) {
        return {1, chart_face.polygon};
    }
    std::vector<Polygon> triangles = fan_of(machine, chart, face);
    chart_face.full_area = 0;
    for (const Polygon& triangle : triangles) {
        chart_face.full_area += signed_area(triangle);
    }
    chart_face.scale = face_area(machine, face) / chart_face.full_area;
    return triangles;
}

std::vector<ChartFace> flattened(const Machine& machine, const Chart& chart, const std::vector<std::uint32_t>& faces,
                                 const std::optional<BoxShape>& within)
{
    std::vector<ChartFace> result;
    result.reserve(faces.size());
    for (const std::uint32_t index : faces) {
        ChartFace face = chart.flatten(machine.faces[index], index, machine.nodes);
        for (const Polygon& outline : outlines(machine, chart, face)) {
            for (const Polygon& piece : within ? chart.within(outline, *within) : std::vector<Polygon>(1, outline)) {
                face.polygon = piece;
                result.push_back(face);
            }
        }
    }
    return result;
}

double total_area(const Machine& machine, const FacesByGeometry& sides, const std::optional<BoxShape>& within)
{
    double sum = 0;
    for (const auto& [geometry, faces] : sides) {
        if (std::holds_alternative<FreeformGeometry>(machine.geometries[geometry])) {
            for (const std::uint32_t face : faces) {
                sum += area(machine, machine.faces[face]);
            }
            continue;
        }
        const Chart chart(machine.geometries[geometry]);
        for (const ChartFace& face : flattened(machine, chart, faces, within)) {
            sum += face.scale * signed_area(face.polygon);
        }
    }
    return sum;
}

/// Clips all faces of one surface of side a against those of one surface of side b.
class Clipper {
public:
    Clipper(const Assembly& assembly, const FaceGeometry& geometry, std::vector<ChartFace> side_a,
            std::vector<ChartFace> side_b)
        : machine_(assembly.machine), fine_(assembly.second_order), chart_(geometry), side_a_(std::move(side_a)),
          side_b_(std::move(side_b))
    {
        for (std::uint32_t k = 0; k < side_b_.size(); ++k) {
            for (int turn = -1; turn <= 1; ++turn) {
                if (turn != 0 && chart_.period() == 0) {
                    continue;
                }
                copies_.push_back({k, {turn * chart_.period(), 0}});
                boxes_.push_back(bounds(shifted(side_b_[k].polygon, copies_.back().shift)));
            }
        }
        if (!boxes_.empty()) {
            grid_.emplace(boxes_);
        }
    }

    /// Receives points and covered shares; if there is none, only the area is computed.
    struct Sink {
        std::vector<ContactPoint>* points = nullptr;
        std::vector<double>* covered = nullptr;
        double* max_gap = nullptr;
    };

    /// Contact area with side a displaced by `stop`; points are weighted with the share of the stop.
    double run(const TravelStop& stop, double gap, const Sink& sink)
    {
        const std::optional<Vec2> shift = chart_.shift(stop.offset, gap);
        if (!grid_ || !shift) {
            return 0;
        }
        double area = 0;
        for (const ChartFace& a : side_a_) {
            const Polygon polygon = shifted(a.polygon, *shift);
            for (const std::uint32_t k : grid_->find(bounds(polygon))) {
                area += add_pair(a, polygon, *shift, copies_[k], stop, sink);
            }
        }
        return area;
    }

private:
    struct Copy {
        std::uint32_t face;
        Vec2 shift;
    };

    /// Point of a face at the given parameters; for round edges it is corrected until it has these parameters.
    [[nodiscard]] Vec3 place(const ChartFace& face, const Vec2& parameters) const
    {
        const Face& on = machine_.faces[face.face];
        Vec2 target = parameters;
        if (!is_round(machine_, on)) {
            return position_on(on, machine_.nodes, local_coordinates(face, target));
        }
        constexpr int corrections = 8;
        Vec3 position{};
        for (int i = 0; i < corrections; ++i) {
            position = place_on(machine_, on, local_coordinates(face, target)).position;
            target = target + chart_.way(position, parameters);
        }
        return position;
    }

    double add_pair(const ChartFace& a, const Polygon& polygon, const Vec2& shift, const Copy& copy,
                    const TravelStop& stop, const Sink& sink)
    {
        const ChartFace& b = side_b_[copy.face];
        const Polygon common = intersection(polygon, shifted(b.polygon, copy.shift));
        if (common.empty()) {
            return 0;
        }
        const double flat = signed_area(common);
        if (flat < least_overlap_share * std::min(a.full_area, b.full_area)) {
            return 0;
        }
        if (sink.covered) {
            (*sink.covered)[a.face] += stop.share * flat / a.full_area;
            (*sink.covered)[b.face] += stop.share * flat / b.full_area;
        }
        const double area = a.scale * flat;
        if (!sink.points) {
            return area;
        }
        points_.clear();
        append_points(common, fine_, points_);
        for (const PlanePoint& point : points_) {
            ContactPoint contact;
            contact.face_a = a.face;
            contact.face_b = b.face;
            contact.position_a = place(a, point.position - shift);
            contact.position_b = place(b, point.position - copy.shift);
            contact.normal = chart_.normal(point.position);
            contact.weight = a.scale * stop.share * point.weight;
            *sink.max_gap = std::max(*sink.max_gap, norm(contact.position_b - (contact.position_a + stop.offset)));
            sink.points->push_back(contact);
        }
        return area;
    }

    const Machine& machine_;
    bool fine_;
    Chart chart_;
    std::vector<ChartFace> side_a_;
    std::vector<ChartFace> side_b_;
    std::vector<Copy> copies_;
    std::vector<Rectangle> boxes_;
    std::optional<PolygonGrid> grid_;
    std::vector<PlanePoint> points_;
};

double length_of(const std::vector<TravelStop>& travel)
{
    double longest = 0;
    for (const TravelStop& one : travel) {
        for (const TravelStop& other : travel) {
            longest = std::max(longest, norm(one.offset - other.offset));
        }
    }
    return longest;
}

}  // namespace

Contact find_contact(const Assembly& assembly, const Side& a, const Side& b, double gap, std::vector<double>& covered,
                     const std::vector<TravelStop>& travel)
{
    const Machine& machine = assembly.machine;
    const FacesByGeometry side_a = by_geometry(machine, a.faces);
    const FacesByGeometry side_b = by_geometry(machine, b.faces);
    Contact contact;
    const Clipper::Sink over_time{&contact.points, &covered, &contact.max_gap};
    const Clipper::Sink as_drawn{&contact.drawn_points, nullptr, &contact.max_gap};
    const TravelStop drawn{{}, 1};
    std::vector<double> at_stop(travel.size(), 0.0);
    double largest = 0;
    for (const auto& [geometry_a, faces_a] : side_a) {
        double own = 0;
        for (const auto& [geometry_b, faces_b] : side_b) {
            const FaceGeometry& geometry = machine.geometries[geometry_a];
            if (!can_touch(geometry, machine.geometries[geometry_b], gap)) {
                continue;
            }
            const Chart chart(geometry);
            Clipper clipper(assembly, geometry, flattened(machine, chart, faces_a, a.within),
                            flattened(machine, chart, faces_b, b.within));
            own += clipper.run(drawn, gap, travel.empty() ? over_time : as_drawn);
            for (std::size_t k = 0; k < travel.size(); ++k) {
                at_stop[k] += clipper.run(travel[k], gap, travel[k].share > 0 ? over_time : Clipper::Sink{});
            }
        }
        contact.drawn_area += own;
        if (own > largest) {
            largest = own;
            contact.geometry = machine.geometries[geometry_a];
        }
    }
    contact.area = travel.empty() ? contact.drawn_area : 0.0;
    contact.least_area = contact.drawn_area;
    for (std::size_t k = 0; k < travel.size(); ++k) {
        contact.area += travel[k].share * at_stop[k];
        contact.least_area = std::min(contact.least_area, at_stop[k]);
    }
    contact.stroke = length_of(travel);
    contact.area_a = total_area(machine, side_a, a.within);
    contact.area_b = total_area(machine, side_b, b.within);
    if (!contact.points_as_drawn().empty()) {
        contact.part_a = machine.faces[contact.points_as_drawn().front().face_a].part;
        contact.part_b = machine.faces[contact.points_as_drawn().front().face_b].part;
    }
    return contact;
}

}  // namespace deadpoint::machine
