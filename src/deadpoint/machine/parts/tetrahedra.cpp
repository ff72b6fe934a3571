#include "deadpoint/machine/parts/tetrahedra.hpp"

#include "deadpoint/io/plain_reason.hpp"
#include "deadpoint/machine/geometry/foreign_mesh.hpp"
#include "deadpoint/machine/geometry/part_mesh.hpp"
#include "deadpoint/machine/parts/cell_limit.hpp"
#include "deadpoint/machine/parts/gmsh_mesh.hpp"
#include "deadpoint/machine/parts/gmsh_session.hpp"
#include "deadpoint/observer.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
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
    double on_curves = 1;  ///< of the smallest cell; below 1 only where nothing gave a mesh before
};
constexpr std::array<Attempt, 10> attempts{{{1.0, frontal, delaunay_3d},
                                            {1.0, frontal, delaunay_3d, 0.25},
                                            {1.0, frontal, delaunay_3d, 0.1},
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
    set("Mesh.MeshSizeMin", attempt.factor * attempt.on_curves * sizes.smallest / gmsh_unit);
    set("Mesh.MeshSizeFromCurvature", sizes.circle_cells);
    set("Mesh.MeshSizeExtendFromBoundary", sizes.fine_at_curves_only ? 0 : 1);
    set("Mesh.Algorithm", attempt.on_surfaces);
    set("Mesh.Algorithm3D", attempt.in_solids);
    gmsh::model::mesh::generate(3);
    gmsh::model::mesh::optimize("");
    return collect_mesh(CellKind::tetrahedron, gmsh_unit, SurfaceNames::from_model, {});
}

/// The middle of the box around two surfaces' common part, by their tags.
Vec3 between(int one, int other)
{
    std::array<Vec3, 2> low{};
    std::array<Vec3, 2> high{};
    for (std::size_t i = 0; i < 2; ++i) {
        gmsh::model::getBoundingBox(2, i == 0 ? one : other, low[i][0], low[i][1], low[i][2], high[i][0], high[i][1],
                                    high[i][2]);
    }
    Vec3 middle{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        middle[axis] = 0.5 * (std::max(low[0][axis], low[1][axis]) + std::min(high[0][axis], high[1][axis]));
    }
    return middle;
}

/// What Gmsh complained of, in plain words and with its place. Words other than those of gmsh 4.8 stay as they are.
MeshFailure in_words(const std::string& complaint)
{
    int one = 0;
    int other = 0;
    Vec3 at{};
    const auto crossing = complaint.find("intersection (");
    if (crossing != std::string::npos &&
        std::sscanf(complaint.c_str() + crossing, "intersection (%lf,%lf,%lf)", &at[0], &at[1], &at[2]) == 3) {
        return {"its surface crosses itself", gmsh_unit * at};
    }
    const auto overlap = complaint.find("(overlapping facets)");
    if (overlap != std::string::npos &&
        std::sscanf(complaint.c_str() + overlap, "(overlapping facets) on surface %d surface %d", &one, &other) == 2) {
        return {"two of its faces lie on each other", gmsh_unit * between(one, other)};
    }
    return {complaint, std::nullopt};
}

/// Why an attempt failed; nothing where it gave cells.
std::optional<MeshFailure> failure_of(const TetrahedronSize& sizes, const Attempt& attempt, PartMesh& mesh)
{
    const GmshComplaints complaints;
    std::string failure = "no tetrahedra were made";
    try {
        mesh = generate(sizes, attempt);
        if (!mesh.cells.empty()) {
            return std::nullopt;
        }
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::runtime_error& error) {  // with the text of Gmsh
        failure = error.what();
    } catch (const std::exception& error) {
        failure = plain_reason(error);
    } catch (const std::string& message) {
        failure = message;
    } catch (int code) {
        failure = fmt::format("Gmsh error {}", code);
    }
    const std::string said = complaints.first("Invalid boundary mesh");
    return in_words(said.empty() ? failure : said);
}

/// A sliver comes and goes with the size; where faces meet at a grazing angle, all meshes have such cells.
bool no_better_to_expect(const std::vector<double>& qualities)
{
    const auto [worst, best] = std::ranges::minmax(qualities);
    return best >= fair_quality || (qualities.size() >= enough_attempts && best < about_the_same * worst);
}

std::string smaller_cells(const TetrahedronSize& sizes, const Attempt& attempt, const MeshFailure& without)
{
    return fmt::format("cells on curved faces are as small as {:.3g} mm: with the smallest cell of {:.3g} mm {}",
                       1e3 * attempt.on_curves * sizes.smallest, 1e3 * sizes.smallest, without.what());
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
    std::optional<MeshFailure> failure;
    for (const Attempt& attempt : attempts) {
        // HXT ends the process where the surface crosses itself.
        if (attempt.in_solids == hxt ? failure.has_value() : attempt.on_curves < 1 && !best.cells.empty()) {
            continue;
        }
        PartMesh mesh;
        if (auto reason = failure_of(sizes, attempt, mesh)) {
            failure = failure ? failure : std::move(reason);
            continue;
        }
        qualities.push_back(worst_cell(mesh).quality);
        if (qualities.back() >= *std::ranges::max_element(qualities)) {
            if (attempt.on_curves < 1) {
                mesh.notes.push_back(smaller_cells(sizes, attempt, *failure));
            }
            best = std::move(mesh);
        }
        if (no_better_to_expect(qualities)) {
            break;
        }
    }
    if (best.cells.empty()) {
        throw *failure;
    }
    return best;
}

PartMesh mesh_model(const std::string& part, const TetrahedronSize& sizes)
{
    Observer nobody;  // messages do not leave the process that reads a foreign file; only errors and the mesh do
    return mesh_model(part, sizes, nobody);
}

}  // namespace deadpoint::machine
