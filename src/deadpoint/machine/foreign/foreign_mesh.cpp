#include "deadpoint/machine/foreign/foreign_mesh.hpp"

#include "deadpoint/error.hpp"
#include "deadpoint/io/child_process.hpp"

#include <algorithm>
#include <cstring>
#include <fmt/format.h>
#include <gmsh.h>
#include <string_view>
#include <type_traits>

namespace deadpoint::machine {
namespace {

constexpr double longest = 1800;  // [s]

// Bytes as they are in memory: child and parent are the same program.
template <class T>
void put(std::string& bytes, const std::vector<T>& values)
{
    static_assert(std::is_trivially_copyable_v<T>);
    const std::size_t count = values.size();
    bytes.append(reinterpret_cast<const char*>(&count), sizeof count);
    if (count > 0) {
        bytes.append(reinterpret_cast<const char*>(values.data()), count * sizeof(T));
    }
}

class Taker {
public:
    explicit Taker(const std::string& bytes) : at_(bytes.data()) {}
    template <class T>
    void take(std::vector<T>& values)
    {
        std::size_t count = 0;
        std::memcpy(&count, at_, sizeof count);
        at_ += sizeof count;
        values.resize(count);
        if (count > 0) {
            std::memcpy(values.data(), at_, count * sizeof(T));
            at_ += count * sizeof(T);
        }
    }

private:
    const char* at_;
};

std::string packed(const PartMesh& mesh)
{
    std::string bytes;
    put(bytes, std::vector{mesh.kind});
    put(bytes, mesh.nodes);
    put(bytes, mesh.cells);
    put(bytes, mesh.faces);
    put(bytes, mesh.geometries);
    put(bytes, std::vector{mesh.groups.size()});
    for (const auto& group : mesh.groups) {
        put(bytes, std::vector<char>(group.name.begin(), group.name.end()));
        put(bytes, group.faces);
    }
    return bytes;
}

PartMesh unpacked(const std::string& bytes)
{
    PartMesh mesh;
    Taker from(bytes);
    std::vector<CellKind> kind;
    from.take(kind);
    mesh.kind = kind.front();
    from.take(mesh.nodes);
    from.take(mesh.cells);
    from.take(mesh.faces);
    from.take(mesh.geometries);
    std::vector<std::size_t> groups;
    from.take(groups);
    mesh.groups.resize(groups.front());
    for (auto& group : mesh.groups) {
        std::vector<char> name;
        from.take(name);
        group.name.assign(name.begin(), name.end());
        from.take(group.faces);
    }
    return mesh;
}

}  // namespace

PartMesh mesh_foreign_file(const ForeignFile& file, const std::function<PartMesh()>& make, const Waiting& waiting)
{
    const ChildLimits limits{half_of_memory(), longest, file.path, file.name};
    return unpacked(run_in_child(
        fmt::format("part '{}': reading '{}'", file.part, file.path), limits, [&] { return packed(make()); }, waiting));
}

GmshComplaints::GmshComplaints() { gmsh::logger::start(); }

GmshComplaints::~GmshComplaints() { gmsh::logger::stop(); }

void GmshComplaints::require_none(const ForeignFile& file) const
{
    constexpr std::string_view mark = "Error: ";
    std::vector<std::string> lines;
    gmsh::logger::get(lines);
    const auto error = std::ranges::find_if(lines, [&](const auto& line) { return line.starts_with(mark); });
    if (error == lines.end()) {
        return;
    }
    // An error that only names the file adds nothing.
    const bool says_more = error->find(file.name) == std::string::npos;
    const std::string reason = says_more ? error->substr(mark.size()) : "its contents are incomplete or out of order";
    throw InputError(
        fmt::format("part '{}': '{}' cannot be read: {}\n  help: check the file with the program that wrote "
                    "it, and write it again",
                    file.part, file.path, reason));
}

}  // namespace deadpoint::machine
