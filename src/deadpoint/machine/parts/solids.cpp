#include "deadpoint/machine/parts/solids.hpp"

#include "deadpoint/error.hpp"
#include "deadpoint/machine/foreign/foreign_mesh.hpp"
#include "deadpoint/machine/foreign/step_file.hpp"
#include "deadpoint/machine/geometry/shapes.hpp"
#include "deadpoint/machine/parts/cell_limit.hpp"
#include "deadpoint/machine/parts/frame.hpp"
#include "deadpoint/machine/parts/gmsh_mesh.hpp"
#include "deadpoint/machine/parts/gmsh_session.hpp"
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

double to_gmsh(double length) { return length / gmsh_unit; }

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

/// [m3], of solids in Gmsh's model.
double volume_of(const Tags& solids)
{
    double sum = 0;
    for (const auto& [dimension, tag] : solids) {
        double own = 0;
        occ::getMass(dimension, tag, own);
        sum += own;
    }
    return sum * gmsh_unit * gmsh_unit * gmsh_unit;
}

/// Quality from which no other size is tried.
constexpr double fair_quality = 0.1;
/// A slightly different size often avoids a sliver.
constexpr std::array<double, 4> size_factors{1.0, 0.93, 0.86, 0.8};

PartMesh generate_at(double size)
{
    gmsh::model::mesh::clear();
    gmsh::option::setNumber("Mesh.MeshSizeMax", to_gmsh(size));
    gmsh::option::setNumber("Mesh.MeshSizeFromCurvature", segments_per_circle);
    gmsh::model::mesh::generate(3);
    gmsh::model::mesh::optimize("");
    PartMesh mesh = collect_mesh(CellKind::tetrahedron, gmsh_unit, SurfaceNames::from_model, {});
    if (mesh.cells.empty()) {
        throw std::runtime_error("no tetrahedra were made");
    }
    return mesh;
}

/// Meshes the solids in Gmsh's model; lengths in the model are millimetres.
PartMesh generate(const std::string& part, double size, Observer& observer)
{
    Tags volumes;
    gmsh::model::getEntities(volumes, 3);
    if (volumes.empty()) {
        return {};
    }
    check_cell_count(part, about_tetrahedra(volume_of(volumes), size), size, observer);
    PartMesh best;
    for (const double factor : size_factors) {
        PartMesh mesh = generate_at(factor * size);
        if (best.cells.empty() || worst_cell(mesh).quality > worst_cell(best).quality) {
            best = std::move(mesh);
        }
        if (worst_cell(best).quality >= fair_quality) {
            break;
        }
    }
    return best;
}

/// The solids of a STEP file in Gmsh's model, in millimetres.
Tags import_solids(const ForeignFile& file)
{
    Tags solids;
    const GmshComplaints complaints;
    try {
        occ::importShapes(file.name, solids, true, "step");
    } catch (...) {
        complaints.require_none(file);
        throw;
    }
    complaints.require_none(file);
    std::erase_if(solids, [](const auto& shape) { return shape.first != 3; });
    if (solids.empty()) {
        throw InputError(fmt::format("part '{}': '{}' holds no solid; export a closed solid", file.part, file.path));
    }
    return solids;
}

}  // namespace

PartMesh mesh_tetrahedra(const std::string& name, const std::vector<Prism>& prisms, double size, bool half,
                         Observer& observer)
{
    PartMesh mesh;
    guard_gmsh(name, "meshing with tetrahedra", [&] {
        reset_gmsh();
        build_solid(prisms, half);
        mesh = generate(name, size, observer);
    });
    return mesh;
}

PartMesh mesh_step(const PartDescription& part, const StepSource& source, double size, bool half,
                   const Waiting& waiting)
{
    const ForeignFile file{part.name, source.path, "part.step"};
    // A file without a unit is read as millimetres.
    const double scale = check_step_file(part.name, source.path).has_unit ? 1 : source.unit / gmsh_unit;
    const auto make = [&] {
        PartMesh mesh;
        guard_gmsh(part.name, "reading and meshing its STEP file", [&] {
            reset_gmsh();
            const Tags solids = import_solids(file);
            if (scale != 1) {
                occ::dilate(solids, 0, 0, 0, scale, scale, scale);
            }
            if (half) {
                cut_at(-part.translation[0], solids);
            }
            occ::synchronize();
            Observer nobody;  // messages do not leave the process; only errors and the mesh do
            mesh = generate(part.name, size, nobody);
        });
        // The part is moved after meshing, since its position must not change its mesh.
        return to_machine(Frame{{0, 1, 2}, {1, 1, 1}, part.translation}, std::move(mesh));
    };
    return mesh_foreign_file(file, make, waiting);
}

}  // namespace deadpoint::machine
