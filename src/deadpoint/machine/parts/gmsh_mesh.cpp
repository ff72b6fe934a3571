#include "deadpoint/machine/parts/gmsh_mesh.hpp"

#include "deadpoint/error.hpp"
#include "deadpoint/machine/geometry/part_mesh.hpp"
#include "deadpoint/machine/parts/fit.hpp"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <gmsh.h>
#include <map>
#include <unordered_map>

namespace deadpoint::machine {

namespace {

using Tags = gmsh::vectorpair;

/// Node tags to indices, in the order of first use.
class SpaceNumbering {
public:
    SpaceNumbering(std::vector<Vec3>& nodes, double unit) : nodes_(nodes)
    {
        std::vector<std::size_t> tags;
        std::vector<double> coordinates;
        std::vector<double> parameters;
        gmsh::model::mesh::getNodes(tags, coordinates, parameters);
        for (std::size_t i = 0; i < tags.size(); ++i) {
            positions_[tags[i]] = {coordinates[3 * i] * unit, coordinates[3 * i + 1] * unit,
                                   coordinates[3 * i + 2] * unit};
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
    std::vector<Vec3>& nodes_;
    std::unordered_map<std::size_t, Vec3> positions_;
    std::unordered_map<std::size_t, std::uint32_t> indices_;
};

void collect_cells(PartMesh& mesh, SpaceNumbering& numbering, CellKind kind)
{
    const int count = node_count(kind);
    std::vector<std::size_t> elements;
    std::vector<std::size_t> nodes;
    gmsh::model::mesh::getElementsByType(kind == CellKind::hexahedron ? hexahedron_type : tetrahedron_type, elements,
                                         nodes);
    for (std::size_t e = 0; e < elements.size(); ++e) {
        Cell cell;
        cell.kind = kind;
        for (int i = 0; i < count; ++i) {
            cell.nodes[i] = numbering(nodes[e * count + i]);
        }
        if (volume(cell, mesh.nodes) < 0) {
            if (kind == CellKind::tetrahedron) {
                std::swap(cell.nodes[1], cell.nodes[2]);
            } else {
                std::swap(cell.nodes[1], cell.nodes[3]);
                std::swap(cell.nodes[5], cell.nodes[7]);
            }
        }
        mesh.cells.push_back(cell);
    }
}

std::map<FaceKey, std::uint32_t> index_faces(const PartMesh& mesh)
{
    std::map<FaceKey, std::uint32_t> index;
    for (std::uint32_t f = 0; f < mesh.faces.size(); ++f) {
        index[face_key(mesh.faces[f])] = f;
    }
    return index;
}

/// Exterior faces that are surface elements of a surface.
std::vector<std::uint32_t> faces_on(int surface, SpaceNumbering& numbering,
                                    const std::map<FaceKey, std::uint32_t>& index)
{
    std::vector<std::uint32_t> found;
    for (const int type : {triangle_type, quad_type}) {
        const std::size_t count = type == triangle_type ? 3 : 4;
        std::vector<std::size_t> elements;
        std::vector<std::size_t> nodes;
        gmsh::model::mesh::getElementsByType(type, elements, nodes, surface);
        for (std::size_t e = 0; e < elements.size(); ++e) {
            Face face;
            for (std::size_t i = 0; i < count; ++i) {
                face.nodes[i] = numbering(nodes[e * count + i]);
            }
            face.node_count = static_cast<std::uint8_t>(count);
            const auto entry = index.find(face_key(face));
            if (entry != index.end()) {
                found.push_back(entry->second);
            }
        }
    }
    return found;
}

/// Last part of a path such as "Shapes/plate/top".
std::string last_name(const std::string& path)
{
    const std::size_t slash = path.find_last_of('/');
    return slash == std::string::npos ? path : path.substr(slash + 1);
}

void add_group(PartMesh& mesh, const std::string& name, const std::vector<std::uint32_t>& faces)
{
    if (name.empty() || faces.empty()) {
        return;
    }
    for (FaceGroup& group : mesh.groups) {
        if (group.name == name) {
            group.faces.insert(group.faces.end(), faces.begin(), faces.end());
            return;
        }
    }
    mesh.groups.push_back({name, faces});
}

/// Physical surfaces by name (or number) and the surfaces they hold.
std::map<std::string, std::vector<int>> physical_surfaces()
{
    std::map<std::string, std::vector<int>> result;
    Tags groups;
    gmsh::model::getPhysicalGroups(groups, 2);
    for (const auto& [dimension, tag] : groups) {
        std::string name;
        gmsh::model::getPhysicalName(dimension, tag, name);
        gmsh::model::getEntitiesForPhysicalGroup(dimension, tag, result[name.empty() ? std::to_string(tag) : name]);
    }
    return result;
}

/// Exterior faces, groups and geometries of a mesh in Gmsh whose cells are collected.
void collect_surfaces(PartMesh& mesh, SpaceNumbering& numbering, SurfaceNames names)
{
    mesh.faces = exterior_faces(mesh.cells);
    const auto index = index_faces(mesh);
    std::vector<int> labels(mesh.faces.size(), -1);
    Tags surfaces;
    gmsh::model::getEntities(surfaces, 2);
    for (const auto& [dimension, tag] : surfaces) {
        const std::vector<std::uint32_t> faces = faces_on(tag, numbering, index);
        for (const std::uint32_t face : faces) {
            labels[face] = tag;
        }
        std::string name;
        if (names == SurfaceNames::from_model) {
            gmsh::model::getEntityName(2, tag, name);
        }
        add_group(mesh, last_name(name), faces);
    }
    for (const auto& [name, members] : physical_surfaces()) {
        for (const int surface : members) {
            add_group(mesh, name, faces_on(surface, numbering, index));
        }
    }
    recognise_geometries(mesh, labels);
}

void drop_unused_nodes(PartMesh& mesh)
{
    std::vector<std::int64_t> fresh(mesh.nodes.size(), -1);
    std::vector<Vec3> nodes;
    for (Cell& cell : mesh.cells) {
        for (int i = 0; i < node_count(cell.kind); ++i) {
            std::int64_t& index = fresh[cell.nodes[i]];
            if (index < 0) {
                index = static_cast<std::int64_t>(nodes.size());
                nodes.push_back(mesh.nodes[cell.nodes[i]]);
            }
            cell.nodes[i] = static_cast<std::uint32_t>(index);
        }
    }
    for (Face& face : mesh.faces) {
        for (std::uint32_t& node : face.nodes) {
            node = static_cast<std::uint32_t>(fresh[node]);
        }
    }
    mesh.nodes = std::move(nodes);
}

}  // namespace

PartMesh collect_mesh(CellKind kind, double unit, SurfaceNames names, const std::function<void(PartMesh&)>& adjust)
{
    PartMesh mesh;
    mesh.kind = kind;
    SpaceNumbering numbering(mesh.nodes, unit);
    collect_cells(mesh, numbering, kind);
    if (adjust) {
        adjust(mesh);
    }
    if (mesh.cells.empty()) {
        return {};
    }
    collect_surfaces(mesh, numbering, names);
    drop_unused_nodes(mesh);
    return mesh;
}

void require_readable(const std::string& part, const std::string& path)
{
    std::error_code unknown;
    if (!std::filesystem::exists(path, unknown)) {
        throw IoError(fmt::format(
            "part '{}': there is no file '{}'\n  help: check the path, which is relative to the file that names it",
            part, path));
    }
    // Opening a pipe would wait for a writer.
    if (!std::filesystem::is_regular_file(path, unknown) || !std::ifstream(path)) {
        throw IoError(
            fmt::format("part '{}': the file '{}' cannot be read\n  help: check that it is a file, and its permissions",
                        part, path));
    }
}

}  // namespace deadpoint::machine
