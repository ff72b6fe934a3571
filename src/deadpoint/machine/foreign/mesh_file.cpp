#include "deadpoint/error.hpp"
#include "deadpoint/machine/foreign/mesh_sections.hpp"
#include "deadpoint/machine/geometry/foreign_mesh.hpp"
#include "deadpoint/machine/parts/gmsh_mesh.hpp"
#include "deadpoint/machine/parts/gmsh_session.hpp"
#include "deadpoint/machine/parts/solids.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fstream>
#include <gmsh.h>
#include <iterator>
#include <sstream>

namespace deadpoint::machine {

namespace {

/// Elements of higher order become those of their corners.
/// @return whether there were any
bool straighten()
{
    std::vector<int> types;
    gmsh::model::mesh::getElementTypes(types, 3);
    const bool curved = std::ranges::any_of(types, [](int type) {
        std::string name;
        int dimension = 0;
        int order = 0;
        int nodes = 0;
        int primary = 0;
        std::vector<double> local;
        gmsh::model::mesh::getElementProperties(type, name, dimension, order, nodes, local, primary);
        return order > 1;
    });
    if (curved) {
        gmsh::model::mesh::setOrder(1);
    }
    return curved;
}

/// Only hexahedra, or only tetrahedra.
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
        throw InputError(fmt::format(
            "part '{}': '{}' holds cells of type '{}', but only hexahedra or tetrahedra can be used\n  help: mesh it "
            "again with one of these",
            part.name, source.path, name));
    }
    if (types.empty()) {
        throw InputError(
            fmt::format("part '{}': '{}' holds no solid cells\n  help: mesh the volume, and save all cells or give "
                        "the volume a physical group",
                        part.name, source.path));
    }
    if (types.size() > 1) {
        throw InputError(
            fmt::format("part '{}': '{}' mixes hexahedra and tetrahedra in one part\n  help: make two parts of it",
                        part.name, source.path));
    }
    return types.front() == hexahedron_type ? CellKind::hexahedron : CellKind::tetrahedron;
}

/// Removes cells beyond the symmetry plane; the mesh must have faces on that plane.
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
            throw InputError(
                fmt::format("part '{}': cells of its mesh straddle the symmetry plane x = 0\n  help: mesh it with "
                            "faces on that plane, or mesh only its half x <= 0",
                            part.name));
        }
        return right > 0;
    });
}

[[noreturn]] void refuse_format(const ForeignFile& file, const std::string& reason)
{
    throw InputError(fmt::format("part '{}': '{}' is not a Gmsh mesh file (MSH 2 or 4): {}\n  help: convert it with "
                                 "'gmsh <file> -save -format msh41 -o <mesh>.msh'",
                                 file.part, file.path, reason));
}

/// What the first lines of a mesh say.
struct MeshFormat {
    double version = 0;
    int binary = -1;
};

/// Gmsh reads a file that does not begin as a mesh as a script, which may run commands.
MeshFormat require_mesh_format(const ForeignFile& file, std::istream& stream)
{
    std::string line;
    std::getline(stream, line);
    if (line != "$MeshFormat" && line != "$MeshFormat\r") {
        refuse_format(file, "its first line is not '$MeshFormat'");
    }
    std::getline(stream, line);
    std::istringstream words(line);
    MeshFormat format;
    int size = 0;
    words >> format.version >> format.binary >> size;
    const bool known = (format.version >= 2 && format.version < 3) || (format.version >= 4 && format.version < 4.2);
    if (!words || !known || (format.binary != 0 && format.binary != 1) || size != 8) {
        refuse_format(file, "its second line does not name a supported version");
    }
    return format;
}

/// A file of Gmsh's own format consists of sections, each with an end mark; Gmsh reads a truncated file without an
/// error.
void require_whole(const ForeignFile& file, std::istream& stream)
{
    constexpr std::streamoff tail = 64;
    stream.clear();
    stream.seekg(0, std::ios::end);
    stream.seekg(std::max<std::streamoff>(stream.tellg() - tail, 0));
    const std::string end{std::istreambuf_iterator<char>(stream), {}};
    const auto last = end.rfind('$');
    if (last == std::string::npos || end.compare(last, 4, "$End") != 0) {
        throw InputError(
            fmt::format("part '{}': '{}' is cut short: its last section has no end\n  help: write or copy it again",
                        file.part, file.path));
    }
}

void check_file(const ForeignFile& file)
{
    require_readable(file.part, file.path);
    std::ifstream stream(file.path, std::ios::binary);
    const MeshFormat format = require_mesh_format(file, stream);
    require_whole(file, stream);
    stream.clear();
    stream.seekg(0);
    if (const auto wrong = format.binary == 0 ? wrong_count(stream, format.version) : ""; !wrong.empty()) {
        throw InputError(fmt::format("part '{}': '{}', {}\n  help: write the mesh again", file.part, file.path, wrong));
    }
}

void read_with_gmsh(const ForeignFile& file)
{
    reset_gmsh();
    const GmshComplaints complaints;
    try {
        gmsh::merge(file.name);
    } catch (...) {
        complaints.require_none(file);
        throw;
    }
    complaints.require_none(file);
}

}  // namespace

PartMesh read_mesh(const PartDescription& part, const MeshSource& source, bool half, const Waiting& waiting)
{
    const ForeignFile file{part.name, source.path, "part.msh"};
    check_file(file);
    const auto adjust = [&](PartMesh& raw) {
        for (Vec3& node : raw.nodes) {
            node = node + part.translation;
            if (!std::isfinite(norm(node))) {
                throw InputError(
                    fmt::format("part '{}': '{}' holds a node with a non-finite coordinate\n  help: mesh it "
                                "again",
                                part.name, source.path));
            }
        }
        if (half) {
            keep_half(part, raw);
        }
    };
    const auto make = [&] {
        PartMesh mesh;
        guard_gmsh(part.name, "reading its mesh file", [&] {
            read_with_gmsh(file);
            const bool straightened = straighten();
            mesh = collect_mesh(cell_kind_in_file(part, source), source.unit, SurfaceNames::from_groups, adjust);
            if (straightened) {
                mesh.notes.emplace_back(
                    "cells of higher order in its file are taken by their corners; `order` = 2 makes edges on "
                    "cylinders round again");
            }
        });
        return mesh;
    };
    return mesh_foreign_file(file, "reading", make, waiting);
}

}  // namespace deadpoint::machine
