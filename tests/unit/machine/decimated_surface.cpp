#include "deadpoint/machine/assembly/decimated_surface.hpp"

#include "deadpoint/exchange/decimated_surface.hpp"
#include "fixture.hpp"
#include "near.hpp"

#include <algorithm>
#include <map>

using namespace machine_test;

namespace {

Machine built(std::vector<PartDescription> parts, bool half = false)
{
    MachineDescription description;
    description.parts = std::move(parts);
    description.half_model = half;
    description.size = 0.01;
    Log log;
    return machine::build_machine(description, log);
}

/// Block of 0.4 x 0.3 x 0.2 m with a bore of 0.1 m.
PartDescription bored_block(const std::string& name, double size = 0.01)
{
    return part(name, name,
                {add(BoxShape{{-0.2, -0.15, 0}, {0.2, 0.15, 0.2}}), cut(cylinder(Axis::z, {0, 0}, 0.1, -1, 1))}, size);
}

/// Volume inside the triangles of a part (divergence theorem) [m3].
double volume(const DecimatedSurface& surface, std::size_t p)
{
    const auto& part = surface.parts[p];
    double sum = 0;
    for (std::size_t t = part.first_triangle; t < part.first_triangle + part.triangle_count; ++t) {
        const auto& [a, b, c] = surface.triangles[t];
        sum += dot(surface.positions[a], cross(surface.positions[b], surface.positions[c])) / 6;
    }
    return sum;
}

/// Whether every edge is passed as often one way as the other: no holes.
bool closed(const DecimatedSurface& surface)
{
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> passes;
    for (const auto& t : surface.triangles)
        for (std::size_t i = 0; i < 3; ++i) {
            const auto a = t[i], b = t[(i + 1) % 3];
            passes[std::minmax(a, b)] += a < b ? 1 : -1;
        }
    return std::ranges::all_of(passes, [](const auto& entry) { return entry.second == 0; });
}

bool has_vertex(const DecimatedSurface& surface, const Vec3& place)
{
    return std::ranges::any_of(surface.positions, [&](const Vec3& x) { return norm(x - place) < 1e-9; });
}

}  // namespace

TEST_CASE("light surface: below the limit every face stays, with its area")
{
    const auto whole = built({bored_block("block")});
    const auto surface = machine::decimated_surface(whole, 1000000);
    CHECK(surface.grid == 0);
    CHECK(surface.triangles.size() == 2 * whole.faces.size());
    CHECK(surface.parts[0].area == near(surface.parts[0].full_area, 1e-12));
    CHECK(closed(surface));
    for (std::size_t v = 0; v < surface.vertices.size(); ++v) {
        const auto& [cell, corner] = surface.vertices[v];
        REQUIRE(norm(whole.nodes[whole.cells[cell].nodes[corner]] - surface.positions[v]) == 0);
    }
}

TEST_CASE("light surface: a tenth of the triangles keeps area, volume, corners and closedness")
{
    const auto whole = built({bored_block("block", 0.006)});
    const auto full = machine::decimated_surface(whole, 1000000);
    const auto surface = machine::decimated_surface(whole, full.triangles.size() / 10);
    CHECK(surface.triangles.size() <= full.triangles.size() / 10);
    CHECK(surface.triangles.size() > full.triangles.size() / 40);
    CHECK(surface.grid > 0.006);
    CHECK(closed(surface));
    // Planes stay planes; the bore alone becomes a polygon, of eight sides at least: its 0.063 m2 of 0.52 m2 shrink by
    // 3 % at most, and the two planes around it grow by less.
    CHECK(surface.parts[0].area == near(surface.parts[0].full_area, 0.02));
    CHECK(volume(surface, 0) == near(whole.parts[0].volume, 0.01));
    for (const double x : {-0.2, 0.2})
        for (const double y : {-0.15, 0.15})
            for (const double z : {0.0, 0.2})
                CHECK(has_vertex(surface, {x, y, z}));
}

TEST_CASE("light surface: boxes of the size of holes fold nothing over them")
{
    std::vector<Shape> shapes{add(BoxShape{{0, 0, 0}, {0.4, 0.3, 0.02}})};
    for (const double x : {0.1, 0.2, 0.3})
        for (const double y : {0.1, 0.2})
            shapes.push_back(cut(cylinder(Axis::z, {x, y}, 0.05, -1, 1)));
    const auto whole = built({part("plate", "plate", shapes, 0.004)});
    const auto full = machine::decimated_surface(whole, 1000000);
    const auto surface = machine::decimated_surface(whole, full.triangles.size() / 40);
    CHECK(surface.grid > 0.03);
    CHECK(closed(surface));
    // Polygons of eight sides at least for the holes: 10 % of 5 % of the planes, and 3 % of a fifth of bores.
    CHECK(surface.parts[0].area == near(surface.parts[0].full_area, 0.015));
    CHECK(volume(surface, 0) == near(whole.parts[0].volume, 0.015));
}

TEST_CASE("light surface: walls and shafts thinner than the grid keep their thickness")
{
    const auto whole = built({part("wall", "wall", {add(BoxShape{{0, 0, 0}, {0.5, 0.5, 0.005}})}),
                              part("shaft", "shaft", {add(cylinder(Axis::y, {1, 0}, 0.02, 0, 0.5))}, 0.004)});
    const auto surface = machine::decimated_surface(whole, 400);
    CHECK(surface.grid > 0.02);
    CHECK(surface.triangles.size() <= 400);
    CHECK(volume(surface, 0) == near(whole.parts[0].volume, 1e-9));
    // An octagon holds 0.90 of its circle. Nodes merged within its eighths move its corners by half an eighth at most.
    CHECK(volume(surface, 1) > 0.6 * whole.parts[1].volume);
    CHECK(volume(surface, 1) < 1.001 * whole.parts[1].volume);
}

TEST_CASE("light surface: parts share no vertex, and a limit below the faces of the solids holds as well")
{
    std::vector<PartDescription> parts;
    for (int i = 0; i < 6; ++i) {
        auto& shapes = std::get<std::vector<Shape>>(
            parts.emplace_back(bored_block(std::string(1, static_cast<char>('a' + i)))).source);
        for (auto& shape : shapes) {
            if (auto* box = std::get_if<BoxShape>(&shape.form))
                box->min[2] = 0.3 * i, box->max[2] = 0.3 * i + 0.2;
            if (auto* bore = std::get_if<CylinderShape>(&shape.form))
                bore->from = -1, bore->to = 3;
        }
    }
    const auto whole = built(parts);
    const auto surface = machine::decimated_surface(whole, 120);
    CHECK(surface.triangles.size() <= 120);
    REQUIRE(surface.parts.size() == 6);
    for (std::size_t p = 0; p < 6; ++p) {
        const auto& own = surface.parts[p];
        for (std::size_t t = own.first_triangle; t < own.first_triangle + own.triangle_count; ++t)
            for (const auto v : surface.triangles[t]) {
                REQUIRE(v >= own.first_vertex);
                REQUIRE(v < own.first_vertex + own.vertex_count);
                REQUIRE(whole.cells[surface.vertices[v].cell].part == p);
            }
    }
}

TEST_CASE("light surface: in a half model the triangles of the symmetry plane come last in each part")
{
    const auto whole = built({part("block", "block", {add(BoxShape{{-0.1, 0, 0}, {0.1, 0.1, 0.1}})})}, true);
    const auto surface = machine::decimated_surface(whole, 300);
    const auto& own = surface.parts[0];
    REQUIRE(own.symmetry_triangles > 0);
    for (std::size_t t = 0; t < own.triangle_count; ++t) {
        const auto& corners = surface.triangles[own.first_triangle + t];
        const bool on_plane =
            std::ranges::all_of(corners, [&](std::uint32_t v) { return std::abs(surface.positions[v][0]) < 1e-12; });
        CHECK(on_plane == (t >= own.triangle_count - own.symmetry_triangles));
    }
}
