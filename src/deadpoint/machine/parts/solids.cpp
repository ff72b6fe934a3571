#include "deadpoint/machine/parts/solids.hpp"

#include "deadpoint/machine/geometry/part_mesh.hpp"
#include "deadpoint/machine/geometry/shapes.hpp"
#include "deadpoint/machine/parts/frame.hpp"
#include "deadpoint/machine/parts/gmsh_mesh.hpp"
#include "deadpoint/machine/parts/gmsh_session.hpp"
#include "deadpoint/machine/parts/tetrahedra.hpp"
#include "deadpoint/observer.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <gmsh.h>

namespace deadpoint::machine {

namespace {

namespace occ = gmsh::model::occ;
using Tags = gmsh::vectorpair;

constexpr int segments_per_circle = 24;
constexpr double far_away = 1e3;

int add_box(const Vec3& min, const Vec3& max)
{
    return occ::addBox(to_gmsh(min[0]), to_gmsh(min[1]), to_gmsh(min[2]), to_gmsh(max[0] - min[0]),
                       to_gmsh(max[1] - min[1]), to_gmsh(max[2] - min[2]));
}

int add_cylinder(const Prism& prism, double radius)
{
    const Vec3 start = point_at(prism.axis, prism.section.circle->centre, prism.from);
    const Vec3 way = point_at(prism.axis, {0, 0}, prism.to - prism.from);
    return occ::addCylinder(to_gmsh(start[0]), to_gmsh(start[1]), to_gmsh(start[2]), to_gmsh(way[0]), to_gmsh(way[1]),
                            to_gmsh(way[2]), to_gmsh(radius));
}

int add_wire(const Prism& prism, const std::vector<Vec2>& points)
{
    std::vector<int> corners;
    for (const Vec2& point : points) {
        const Vec3 p = point_at(prism.axis, point, prism.from);
        corners.push_back(occ::addPoint(to_gmsh(p[0]), to_gmsh(p[1]), to_gmsh(p[2])));
    }
    std::vector<int> lines;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        lines.push_back(occ::addLine(corners[i], corners[(i + 1) % corners.size()]));
    }
    return occ::addCurveLoop(lines);
}

Tags add_outline(const Prism& prism)
{
    std::vector<int> wires{add_wire(prism, prism.section.points)};
    for (const auto& hole : prism.section.holes) {
        wires.push_back(add_wire(prism, hole));
    }
    const Vec3 way = point_at(prism.axis, {0, 0}, prism.to - prism.from);
    Tags swept;
    occ::extrude({{2, occ::addPlaneSurface(wires)}}, to_gmsh(way[0]), to_gmsh(way[1]), to_gmsh(way[2]), swept);
    std::erase_if(swept, [](const auto& entity) { return entity.first != 3; });
    return swept;
}

Tags add_prism(const Prism& prism)
{
    if (prism.box) {
        return {{3, add_box(prism.min, prism.max)}};
    }
    if (!prism.section.circle) {
        return add_outline(prism);
    }
    Tags solid{{3, add_cylinder(prism, prism.section.circle->radius)}};
    if (prism.section.bore_radius > 0) {
        Tags hollow;
        std::vector<Tags> map;
        occ::cut(solid, {{3, add_cylinder(prism, prism.section.bore_radius)}}, hollow, map);
        return hollow;
    }
    return solid;
}

/// Keeps what lies below a place along x.
Tags cut_at(double x, const Tags& solids)
{
    Tags kept;
    std::vector<Tags> map;
    const int beyond = add_box({x, -far_away, -far_away}, {x + far_away, far_away, far_away});
    occ::cut(solids, {{3, beyond}}, kept, map);
    return kept;
}

/// Draws the outlines of imprinted prisms into the solids.
Tags imprinted(const Tags& solids, const std::vector<Prism>& prisms)
{
    Tags tools;
    for (const Prism& prism : prisms) {
        if (prism.operation != Shape::Operation::imprint) {
            continue;
        }
        const Tags own = add_prism(prism);
        tools.insert(tools.end(), own.begin(), own.end());
    }
    if (tools.empty()) {
        return solids;
    }
    Tags pieces;
    std::vector<Tags> map;
    occ::fragment(solids, tools, pieces, map);
    Tags kept;
    for (std::size_t i = 0; i < solids.size(); ++i) {
        kept.insert(kept.end(), map[i].begin(), map[i].end());
    }
    std::sort(kept.begin(), kept.end());
    kept.erase(std::unique(kept.begin(), kept.end()), kept.end());
    Tags waste;
    std::copy_if(pieces.begin(), pieces.end(), std::back_inserter(waste), [&](const auto& piece) {
        return piece.first == 3 && !std::binary_search(kept.begin(), kept.end(), piece);
    });
    if (!waste.empty()) {
        occ::remove(waste, true);
    }
    return kept;
}

void build_solid(const std::vector<Prism>& prisms, bool half)
{
    Tags solids;
    for (const Prism& prism : prisms) {
        if (prism.operation == Shape::Operation::imprint) {
            continue;
        }
        const bool add = prism.operation == Shape::Operation::add;
        if (!add && solids.empty()) {
            continue;
        }
        const Tags own = add_prism(prism);
        Tags result;
        std::vector<Tags> map;
        if (solids.empty()) {
            result = own;
        } else if (add) {
            occ::fuse(solids, own, result, map);
        } else {
            occ::cut(solids, own, result, map);
        }
        solids = result;
    }
    if (half && !solids.empty()) {
        solids = cut_at(0, solids);
    }
    if (!solids.empty()) {
        imprinted(solids, prisms);
    }
    occ::synchronize();
}

}  // namespace

PartMesh mesh_tetrahedra(const std::string& name, const std::vector<Prism>& prisms, double size, bool half,
                         Observer& observer)
{
    PartMesh mesh;
    guard_gmsh(name, "meshing with tetrahedra", [&] {
        reset_gmsh();
        build_solid(prisms, half);
        mesh = mesh_model(name, {size, 0, segments_per_circle}, observer);
    });
    return mesh;
}

}  // namespace deadpoint::machine
