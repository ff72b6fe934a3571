#include "deadpoint/machine/parts/layers.hpp"

#include <algorithm>
#include <cmath>

namespace deadpoint::machine {

namespace {

std::vector<double> unique_sorted(std::vector<double> values)
{
    std::sort(values.begin(), values.end());
    values.erase(std::unique(values.begin(), values.end()), values.end());
    return values;
}

std::vector<double> subdivided(const std::vector<double>& ends, double size)
{
    std::vector<double> result{ends.front()};
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
        const int count = steps(ends[i + 1] - ends[i], size);
        for (int k = 1; k < count; ++k) {
            result.push_back(ends[i] + (ends[i + 1] - ends[i]) * k / count);
        }
        result.push_back(ends[i + 1]);
    }
    return result;
}

}  // namespace

int steps(double length, double size)
{
    constexpr double rounding = 1e-6;  // lengths that are stated as two and a quarter sizes are two, in any unit
    return std::max(1, static_cast<int>(std::ceil(length / size - 0.25 - rounding)));
}

std::vector<Axis> common_axes(const std::vector<Prism>& prisms)
{
    std::vector<Axis> axes;
    for (const Axis axis : {Axis::z, Axis::y, Axis::x}) {
        const auto fits = [axis](const Prism& prism) { return prism.box || prism.axis == axis; };
        if (std::all_of(prisms.begin(), prisms.end(), fits)) {
            axes.push_back(axis);
        }
    }
    return axes;
}

LayeredPart layered_along(const std::vector<Prism>& prisms, Axis axis, bool half)
{
    LayeredPart part;
    part.axis = axis;
    part.half_plane = half && axis != Axis::x;
    for (const Prism& prism : prisms) {
        part.prisms.push_back(along(prism, axis));
    }
    const bool cut_lengthwise = half && axis == Axis::x;
    for (const Prism& prism : part.prisms) {
        part.positions.push_back(prism.from);
        part.positions.push_back(prism.to);
    }
    if (cut_lengthwise) {
        part.positions.push_back(0);
    }
    part.positions = unique_sorted(part.positions);
    if (cut_lengthwise) {
        std::erase_if(part.positions, [](double position) { return position > 0; });
    }
    return part;
}

std::vector<char> signature(const LayeredPart& part, const Vec2& point)
{
    if (part.half_plane && point[0] > 0) {
        return {};
    }
    std::vector<const Prism*> around;
    for (const Prism& prism : part.prisms) {
        if (inside(prism.section, point)) {
            around.push_back(&prism);
        }
    }
    std::vector<char> result;
    bool any = false;
    for (std::size_t i = 0; i + 1 < part.positions.size(); ++i) {
        const double middle = 0.5 * (part.positions[i] + part.positions[i + 1]);
        bool solid = false;
        for (const Prism* prism : around) {
            if (prism->operation == Shape::Operation::imprint || middle < prism->from || middle > prism->to) {
                continue;
            }
            solid = prism->operation == Shape::Operation::add;
        }
        result.push_back(solid ? 1 : 0);
        any = any || solid;
    }
    if (!any) {
        return {};
    }
    for (const Prism& prism : part.prisms) {
        if (prism.operation == Shape::Operation::imprint) {
            result.push_back(inside(prism.section, point) ? 1 : 0);
        }
    }
    return result;
}

bool only_boxes(const LayeredPart& part)
{
    return std::all_of(part.prisms.begin(), part.prisms.end(), [](const Prism& prism) { return prism.box; });
}

namespace {

/// Lines of a grid along both axes.
struct GridLines {
    std::array<std::vector<double>, 2> ends;  ///< positions where shapes begin and end
    std::vector<double> u, v;                 ///< all lines

    [[nodiscard]] std::uint32_t columns() const { return static_cast<std::uint32_t>(u.size()); }
    [[nodiscard]] std::uint32_t rows() const { return static_cast<std::uint32_t>(v.size()); }
};

GridLines grid_lines(const LayeredPart& part, double size)
{
    GridLines lines;
    auto& ends = lines.ends;
    for (const Prism& prism : part.prisms) {
        for (const Vec2& point : prism.section.points) {
            ends[0].push_back(point[0]);
            ends[1].push_back(point[1]);
        }
    }
    if (part.half_plane) {
        ends[0].push_back(0);
        std::erase_if(ends[0], [](double value) { return value > 0; });
    }
    for (auto& values : ends) {
        values = unique_sorted(values);
    }
    lines.u = subdivided(ends[0], size);
    lines.v = subdivided(ends[1], size);
    return lines;
}

void add_quads(const LayeredPart& part, const GridLines& lines, PlaneMesh& mesh)
{
    const auto& [ends, u, v] = lines;
    for (std::uint32_t j = 0; j + 1 < lines.rows(); ++j) {
        for (std::uint32_t i = 0; i + 1 < lines.columns(); ++i) {
            const std::vector<char> own = signature(part, {0.5 * (u[i] + u[i + 1]), 0.5 * (v[j] + v[j + 1])});
            if (own.empty()) {
                continue;
            }
            const auto found = std::find(mesh.signatures.begin(), mesh.signatures.end(), own);
            mesh.region.push_back(static_cast<std::uint32_t>(found - mesh.signatures.begin()));
            if (found == mesh.signatures.end()) {
                mesh.signatures.push_back(own);
            }
            const std::uint32_t first = j * lines.columns() + i;
            mesh.quads.push_back({first, first + 1, first + lines.columns() + 1, first + lines.columns()});
        }
    }
}

void add_curves(const GridLines& lines, PlaneMesh& mesh)
{
    const auto on_end = [](const std::vector<double>& values, double x) {
        return std::binary_search(values.begin(), values.end(), x);
    };
    for (std::uint32_t j = 0; j < lines.rows(); ++j) {
        for (std::uint32_t i = 0; i < lines.columns(); ++i) {
            const std::uint32_t node = j * lines.columns() + i;
            const auto add = [&](std::uint32_t other) {
                mesh.curve_edges.push_back({node, other, static_cast<std::uint32_t>(mesh.curves.size())});
                mesh.curves.push_back({std::nullopt, mesh.nodes[node], mesh.nodes[other]});
            };
            if (i + 1 < lines.columns() && on_end(lines.ends[1], lines.v[j])) {
                add(node + 1);
            }
            if (j + 1 < lines.rows() && on_end(lines.ends[0], lines.u[i])) {
                add(node + lines.columns());
            }
        }
    }
}

}  // namespace

PlaneMesh grid_plane(const LayeredPart& part, double size)
{
    const auto lines = grid_lines(part, size);
    PlaneMesh mesh;
    for (const double y : lines.v) {
        for (const double x : lines.u) {
            mesh.nodes.push_back({x, y});
        }
    }
    add_quads(part, lines, mesh);
    add_curves(lines, mesh);
    return mesh;
}

}  // namespace deadpoint::machine
