#include "deadpoint/machine/parts/tetrahedra.hpp"

#include "deadpoint/io/plain_reason.hpp"
#include "deadpoint/machine/parts/cell_limit.hpp"
#include "deadpoint/machine/parts/gmsh_mesh.hpp"
#include "deadpoint/machine/parts/gmsh_session.hpp"
#include "deadpoint/machine/parts/part_mesh.hpp"
#include "deadpoint/observer.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <gmsh.h>
#include <stdexcept>
#include <vector>

namespace deadpoint::machine {
namespace {

namespace occ = gmsh::model::occ;

/// Quality from which no other attempt is made: nothing is said about such cells.
constexpr double fair_quality = 0.05;
/// Attempts after which a form that always gives about the same quality is taken to allow no better.
constexpr std::size_t enough_attempts = 3;
constexpr double about_the_same = 1.25;

/// Gmsh's numbers of its algorithms for surfaces and solids.
constexpr double frontal = 6;
constexpr double delaunay = 5;
constexpr double delaunay_3d = 1;
constexpr double hxt = 10;

/// One way to mesh: a slightly different size or another algorithm often avoids a sliver.
struct Attempt {
    double factor;
    double on_surfaces;
    double in_solids;
};
constexpr std::array<Attempt, 8> attempts{{{1.0, frontal, delaunay_3d},
                                           {0.93, frontal, delaunay_3d},
                                           {1.0, delaunay, delaunay_3d},
                                           {1.0, frontal, hxt},
                                           {0.86, frontal, delaunay_3d},
                                           {0.9, delaunay, delaunay_3d},
                                           {0.8, frontal, delaunay_3d},
                                           {0.8, delaunay, hxt}}};

/// [m3], of solids in Gmsh's model.
double volume_of(const gmsh::vectorpair& solids)
{
    double sum = 0;
    for (const auto& [dimension, tag] : solids) {
        double own = 0;
        occ::getMass(dimension, tag, own);
        sum += own;
    }
    return sum * gmsh_unit * gmsh_unit * gmsh_unit;
}

PartMesh generate(const TetrahedronSize& sizes, const Attempt& attempt)
{
    const auto set = [](const char* name, double value) { gmsh::option::setNumber(name, value); };
    gmsh::model::mesh::clear();
    set("Mesh.MeshSizeMax", attempt.factor * sizes.size / gmsh_unit);
    set("Mesh.MeshSizeMin", attempt.factor * sizes.smallest / gmsh_unit);
    set("Mesh.MeshSizeFromCurvature", sizes.circle_cells);
    set("Mesh.MeshSizeExtendFromBoundary", sizes.fine_at_curves_only ? 0 : 1);
    set("Mesh.Algorithm", attempt.on_surfaces);
    set("Mesh.Algorithm3D", attempt.in_solids);
    gmsh::model::mesh::generate(3);
    gmsh::model::mesh::optimize("");
    return collect_mesh(CellKind::tetrahedron, gmsh_unit, SurfaceNames::from_model, {});
}

/// The text of whatever Gmsh throws; nothing where the attempt gave cells.
std::string failure_of(const TetrahedronSize& sizes, const Attempt& attempt, PartMesh& mesh)
{
    try {
        mesh = generate(sizes, attempt);
        return mesh.cells.empty() ? "no tetrahedra were made" : "";
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::runtime_error& error) {  // with the text of Gmsh
        return error.what();
    } catch (const std::exception& error) {
        return plain_reason(error);
    } catch (const std::string& message) {
        return message;
    } catch (int code) {
        return fmt::format("Gmsh error {}", code);
    }
}

/// A sliver comes and goes with the size; where faces meet at a grazing angle, all meshes have such cells.
bool no_better_to_expect(const std::vector<double>& qualities)
{
    const auto [worst, best] = std::ranges::minmax(qualities);
    return best >= fair_quality || (qualities.size() >= enough_attempts && best < about_the_same * worst);
}

}  // namespace

PartMesh mesh_model(const std::string& part, const TetrahedronSize& sizes, Observer& observer)
{
    gmsh::vectorpair solids;
    gmsh::model::getEntities(solids, 3);
    if (solids.empty()) {
        return {};
    }
    check_cell_count(part, about_tetrahedra(volume_of(solids), sizes.size), sizes.size, observer);
    PartMesh best;
    std::vector<double> qualities;
    std::string failure;
    for (const Attempt& attempt : attempts) {
        PartMesh mesh;
        if (const std::string text = failure_of(sizes, attempt, mesh); !text.empty()) {
            failure = text;
            continue;
        }
        qualities.push_back(worst_cell(mesh).quality);
        if (qualities.back() >= *std::ranges::max_element(qualities)) {
            best = std::move(mesh);
        }
        if (no_better_to_expect(qualities)) {
            break;
        }
    }
    if (best.cells.empty()) {
        throw std::runtime_error(failure);
    }
    return best;
}

PartMesh mesh_model(const std::string& part, const TetrahedronSize& sizes)
{
    Observer nobody;  // messages do not leave the process that reads a foreign file; only errors and the mesh do
    return mesh_model(part, sizes, nobody);
}

}  // namespace deadpoint::machine
