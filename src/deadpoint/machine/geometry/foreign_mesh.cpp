#include "deadpoint/machine/geometry/foreign_mesh.hpp"

#include "deadpoint/error.hpp"
#include "deadpoint/io/child_process.hpp"
#include "deadpoint/machine/geometry/packed.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <gmsh.h>
#include <string_view>

namespace deadpoint::machine {
namespace {

constexpr double longest_meshing = 1800;  // [s]

std::string packed(const PartMesh& mesh)
{
    Packer to;
    to.put(mesh.kind);
    to.put(mesh.nodes);
    to.put(mesh.cells);
    to.put(mesh.faces);
    to.put(mesh.geometries);
    to.put(mesh.groups.size());
    for (const auto& group : mesh.groups) {
        to.put(group.name);
        to.put(group.faces);
    }
    to.put(mesh.notes.size());
    for (const auto& note : mesh.notes) {
        to.put(note);
    }
    return to.take();
}

PartMesh unpacked_mesh(const std::string& bytes)
{
    PartMesh mesh;
    Unpacker from(bytes);
    from.get(mesh.kind);
    from.get(mesh.nodes);
    from.get(mesh.cells);
    from.get(mesh.faces);
    from.get(mesh.geometries);
    std::size_t count = 0;
    from.get(count);
    mesh.groups.resize(count);
    for (auto& group : mesh.groups) {
        from.get(group.name);
        from.get(group.faces);
    }
    from.get(count);
    mesh.notes.resize(count);
    for (auto& note : mesh.notes) {
        from.get(note);
    }
    return mesh;
}

}  // namespace

PartMesh mesh_foreign_file(const ForeignFile& file, const char* doing, const std::function<PartMesh()>& make,
                           const Waiting& waiting)
{
    const ChildLimits limits{half_of_memory(), longest_meshing, file.path, file.name};
    return unpacked_mesh(run_in_child(
        fmt::format("part '{}': {} '{}'", file.part, doing, file.path), limits, [&] { return packed(make()); },
        waiting));
}

GmshComplaints::GmshComplaints() { gmsh::logger::start(); }

GmshComplaints::~GmshComplaints() { gmsh::logger::stop(); }

std::string GmshComplaints::first(const std::string& text) const
{
    constexpr std::string_view mark = "Error: ";
    std::vector<std::string> lines;
    gmsh::logger::get(lines);
    const auto error = std::ranges::find_if(
        lines, [&](const auto& line) { return line.starts_with(mark) && line.find(text) != std::string::npos; });
    return error == lines.end() ? "" : error->substr(mark.size());
}

void GmshComplaints::require_none(const ForeignFile& file) const
{
    const std::string error = first();
    if (error.empty()) {
        return;
    }
    // An error that only names the file adds nothing.
    const bool says_more = error.find(file.name) == std::string::npos;
    const std::string reason = says_more ? error : "its contents are incomplete or out of order";
    throw InputError(
        fmt::format("part '{}': '{}' cannot be read: {}\n  help: check the file with the program that wrote "
                    "it, and write it again",
                    file.part, file.path, reason));
}

}  // namespace deadpoint::machine
