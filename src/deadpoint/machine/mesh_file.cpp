#include "deadpoint/core/error.hpp"
#include "deadpoint/machine/gmsh_mesh.hpp"
#include "deadpoint/machine/gmsh_session.hpp"
#include "deadpoint/machine/solids.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fstream>
#include <gmsh.h>
#include <iterator>

namespace deadpoint::machine {

namespace {

/// Only first-order hexahedra, or only first-order tetrahedra.
CellKind cell_kind_in_file(const PartDescription& part, const MeshSource& source)
{
    std::vector<int> types;
    gmsh::model::mesh::getElementTypes(types, 3);
    for (const int type : types) {
        if (type == tetrahedron_type || type == hexahedron_type) {
            continue;
        }
        std::string name;
        int dimension = 0;
        int order = 0;
        int nodes = 0;
        int primary = 0;
        std::vector<double> local;
        gmsh::model::mesh::getElementProperties(type, name, dimension, order, nodes, local, primary);
        throw InputError(
            fmt::format("part '{}': '{}' holds cells of type '{}', but only first-order hexahedra or tetrahedra "
                        "can be used; mesh it again with one of these",
                        part.name, source.path, name));
    }
    if (types.empty()) {
        throw InputError(
            fmt::format("part '{}': '{}' holds no solid cells; mesh the volume, and save all cells or give the "
                        "volume a physical group",
                        part.name, source.path));
    }
    if (types.size() > 1) {
        throw InputError(fmt::format("part '{}': '{}' mixes hexahedra and tetrahedra in one part; make two parts of it",
                                     part.name, source.path));
    }
    return types.front() == hexahedron_type ? CellKind::hexahedron : CellKind::tetrahedron;
}

/// Drops what lies beyond the symmetry plane; the mesh must have faces on that plane.
void keep_half(const PartDescription& part, PartMesh& mesh)
{
    constexpr double tolerance = 1e-7;
    for (Vec3& node : mesh.nodes) {
        if (std::abs(node[0]) < tolerance) {
            node[0] = 0;
        }
    }
    std::erase_if(mesh.cells, [&](const Cell& cell) {
        const int count = node_count(cell.kind);
        int left = 0;
        int right = 0;
        for (int i = 0; i < count; ++i) {
            const double x = mesh.nodes[cell.nodes[i]][0];
            left += x < 0 ? 1 : 0;
            right += x > 0 ? 1 : 0;
        }
        if (left > 0 && right > 0) {
            throw InputError(fmt::format("part '{}': cells of its mesh straddle the symmetry plane x = 0; mesh it with "
                                         "faces on that plane, or mesh only its half x <= 0",
                                         part.name));
        }
        return right > 0;
    });
}

/// A file of Gmsh's own format consists of sections, each with its end; Gmsh reads one that is cut short without a
/// word.
void require_whole(const std::string& part, const std::string& path)
{
    std::ifstream file(path, std::ios::binary);
    std::string start(11, '\0');
    file.read(start.data(), static_cast<std::streamsize>(start.size()));
    if (start != "$MeshFormat") {
        return;
    }
    constexpr std::streamoff tail = 64;
    file.seekg(0, std::ios::end);
    file.seekg(std::max<std::streamoff>(file.tellg() - tail, 0));
    const std::string end{std::istreambuf_iterator<char>(file), {}};
    const auto last = end.rfind('$');
    if (last == std::string::npos || end.compare(last, 4, "$End") != 0) {
        throw InputError(fmt::format(
            "part '{}': '{}' is cut short: its last section has no end; write or copy it again", part, path));
    }
}

}  // namespace

PartMesh read_mesh(const PartDescription& part, const MeshSource& source, bool half)
{
    require_readable(part.name, source.path);
    require_whole(part.name, source.path);
    PartMesh mesh;
    guard_gmsh(part.name, "reading its mesh file", [&] {
        reset_gmsh();
        gmsh::merge(source.path);
        const auto adjust = [&](PartMesh& raw) {
            for (Vec3& node : raw.nodes) {
                node = node + part.translation;
                if (!std::isfinite(norm(node))) {
                    throw InputError(
                        fmt::format("part '{}': '{}' holds a node whose place is no finite number; mesh it "
                                    "again",
                                    part.name, source.path));
                }
            }
            if (half) {
                keep_half(part, raw);
            }
        };
        mesh = collect_mesh(cell_kind_in_file(part, source), source.unit, SurfaceNames::from_groups, adjust);
    });
    return mesh;
}

}  // namespace deadpoint::machine
