#include "deadpoint/report/mesh/calculix_mesh.hpp"

#include "deadpoint/core/names/plain_text.hpp"
#include "deadpoint/exchange/machine.hpp"
#include "deadpoint/io/write_file.hpp"
#include "deadpoint/report/mesh/calculix_deck.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ostream.h>
#include <ostream>
#include <set>

namespace deadpoint::report {
namespace {

// Number of an element's face by its nodes: CalculiX 2.20 manual, sections "C3D8" and "C3D4".
int face_number(const Cell& cell, const Face& face)
{
    static constexpr std::array<std::array<int, 4>, 6> hexahedron{
        {{0, 1, 2, 3}, {4, 5, 6, 7}, {0, 1, 4, 5}, {1, 2, 5, 6}, {2, 3, 6, 7}, {0, 3, 4, 7}}};
    static constexpr std::array<std::array<int, 4>, 4> tetrahedron{
        {{0, 1, 2, 2}, {0, 1, 3, 3}, {1, 2, 3, 3}, {0, 2, 3, 3}}};
    const auto find = [&](const auto& faces) {
        for (std::size_t f = 0; f < faces.size(); ++f)
            if (std::ranges::all_of(faces[f], [&](int i) {
                    return std::ranges::count(face.nodes.begin(), face.nodes.begin() + face.node_count,
                                              cell.nodes[static_cast<std::size_t>(i)]) == 1;
                }))
                return static_cast<int>(f) + 1;
        return 0;
    };
    return cell.kind == CellKind::hexahedron ? find(hexahedron) : find(tetrahedron);
}

void write_surface(std::ostream& out, const Machine& machine, const std::string& name,
                   const std::set<std::uint32_t>& faces)
{
    if (faces.empty())
        return;
    fmt::print(out, "*SURFACE, NAME={}, TYPE=ELEMENT\n", name);
    for (const auto index : faces) {
        const auto& face = machine.faces[index];
        fmt::print(out, "{}, S{}\n", face.cell + 1, face_number(machine.cells[face.cell], face));
    }
}

void write_contact(std::ostream& out, const Machine& machine, const std::string& name, const Contact& contact)
{
    std::set<std::uint32_t> a, b;
    for (const auto& point : contact.points_as_drawn()) {
        a.insert(point.face_a);
        b.insert(point.face_b);
    }
    write_surface(out, machine, name + "_A", a);
    write_surface(out, machine, name + "_B", b);
}

void write_parts(std::ostream& out, const Machine& machine)
{
    for (const auto& part : machine.parts) {
        const bool hexahedra = part.kind == CellKind::hexahedron;
        fmt::print(out, "*ELEMENT, TYPE={}, ELSET={}\n", hexahedra ? "C3D8" : "C3D4",
                   calculix_name("PART_", part.name));
        for (std::uint32_t c = part.first_cell; c < part.first_cell + part.cell_count; ++c) {
            fmt::print(out, "{}", c + 1);
            for (std::size_t i = 0; i < (hexahedra ? 8U : 4U); ++i)
                fmt::print(out, ", {}", machine.cells[c].nodes[i] + 1);
            out << '\n';
        }
    }
}

void write_surfaces(std::ostream& out, const Machine& machine)
{
    for (const auto& surface : machine.surfaces) {
        std::set<std::uint32_t> faces;
        for (const auto& entry : surface.faces)
            if (entry.central)
                faces.insert(entry.face);
        write_surface(out, machine, calculix_name("SURFACE_", surface.name), faces);
    }
    for (const auto& contact : machine.interfaces)
        if (contact.perfect)  // the others are bonds
            write_contact(out, machine, calculix_name("INTERFACE_", contact.name), contact);
    for (const auto& contact : machine.bonds)
        write_contact(out, machine, calculix_name("BOND_", contact.name), contact);
    std::set<std::uint32_t> symmetry;
    for (std::uint32_t f = 0; f < machine.faces.size(); ++f)
        if (machine.faces[f].symmetry)
            symmetry.insert(f);
    write_surface(out, machine, "SYMMETRY", symmetry);
}

}  // namespace

void write_calculix_mesh(const std::filesystem::path& path, const Machine& machine,
                         const std::vector<std::string>& comments)
{
    write_file(path, [&](std::ostream& out) {
        for (const auto& comment : comments)
            fmt::print(out, "** {}\n", one_line(comment));
        out << "*NODE, NSET=ALL\n";
        for (std::size_t n = 0; n < machine.nodes.size(); ++n) {
            const auto& x = machine.nodes[n];
            fmt::print(out, "{}, {:.12e}, {:.12e}, {:.12e}\n", n + 1, x[0], x[1], x[2]);
        }
        write_parts(out, machine);
        write_surfaces(out, machine);
    });
}

}  // namespace deadpoint::report
