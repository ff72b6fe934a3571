#include "deadpoint/report/mesh/mesh_files.hpp"

#include "deadpoint/exchange/machine.hpp"
#include "deadpoint/io/vtu.hpp"
#include "deadpoint/report/schema/columns.hpp"
#include "deadpoint/report/tables/csv.hpp"

#include <algorithm>
#include <numeric>
#include <span>

namespace deadpoint::report {
namespace {

using Integers = std::vector<std::int32_t>;

VtuArray cell_array(const std::string& name, Integers values)
{
    return {name, VtuArray::Place::cell, 1, std::move(values)};
}

VtuArray node_array(Integers numbers) { return {node_array_name, VtuArray::Place::point, 1, std::move(numbers)}; }

void write_cells(const std::filesystem::path& path, const Machine& machine, const VtuNotes& notes)
{
    VtuGrid grid;
    grid.points = machine.nodes;
    const auto bodies = body_of_part(machine);
    Integers parts;
    Integers body_numbers;
    for (const auto& cell : machine.cells) {
        const bool hexahedron = cell.kind == CellKind::hexahedron;
        grid.add_cell(hexahedron ? VtuCell::hexahedron : VtuCell::tetrahedron,
                      std::span(cell.nodes).first(hexahedron ? 8 : 4));
        parts.push_back(static_cast<std::int32_t>(cell.part));
        body_numbers.push_back(bodies.at(cell.part));
    }
    Integers nodes(machine.nodes.size());
    std::iota(nodes.begin(), nodes.end(), 1);
    const std::vector<VtuArray> arrays{node_array(std::move(nodes)), cell_array("part", std::move(parts)),
                                       cell_array("body", std::move(body_numbers))};
    write_vtu(path, grid, arrays, notes);
}

/// Per face the surface it belongs to, the smallest one where there are several.
Integers surface_of_face(const Machine& machine)
{
    std::vector<std::size_t> order(machine.surfaces.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, std::greater{}, [&](std::size_t i) { return machine.surfaces[i].area; });
    Integers result(machine.faces.size(), -1);
    for (const std::size_t i : order) {
        for (const auto& face : machine.surfaces[i].faces) {
            if (face.central) {
                result.at(face.face) = static_cast<std::int32_t>(i);
            }
        }
    }
    return result;
}

Integers interface_of_face(const Machine& machine)
{
    Integers result(machine.faces.size(), -1);
    for (std::size_t i = 0; i < machine.interfaces.size(); ++i) {
        for (const auto& point : machine.interfaces[i].points) {
            result.at(point.face_a) = static_cast<std::int32_t>(i);
            result.at(point.face_b) = static_cast<std::int32_t>(i);
        }
    }
    return result;
}

/// Keeps only the points that cells use, in their order. @return their former numbers, from 1
Integers drop_unused_points(VtuGrid& grid)
{
    std::vector<std::uint32_t> number(grid.points.size(), 0);
    for (const auto node : grid.connectivity) {
        number[node] = 1;
    }
    std::vector<Vec3> points;
    Integers former;
    for (std::size_t i = 0; i < number.size(); ++i) {
        if (number[i] != 0) {
            number[i] = static_cast<std::uint32_t>(points.size());
            points.push_back(grid.points[i]);
            former.push_back(static_cast<std::int32_t>(i) + 1);
        }
    }
    for (auto& node : grid.connectivity) {
        node = number[node];
    }
    grid.points = std::move(points);
    return former;
}

void write_faces(const std::filesystem::path& path, const Machine& machine, const VtuNotes& notes)
{
    VtuGrid grid;
    grid.points = machine.nodes;
    const auto bodies = body_of_part(machine);
    Integers parts;
    Integers body_numbers;
    Integers symmetry;
    for (const auto& face : machine.faces) {
        grid.add_cell(face.node_count == 4 ? VtuCell::quad : VtuCell::triangle,
                      std::span(face.nodes).first(face.node_count));
        parts.push_back(static_cast<std::int32_t>(face.part));
        body_numbers.push_back(bodies.at(face.part));
        symmetry.push_back(face.symmetry ? 1 : 0);
    }
    auto nodes = drop_unused_points(grid);
    std::vector<float> exposed(machine.faces.size(), 0.0F);
    std::ranges::transform(machine.exposed_fraction, exposed.begin(), [](double f) { return static_cast<float>(f); });
    const std::vector<VtuArray> arrays{node_array(std::move(nodes)),
                                       cell_array("part", std::move(parts)),
                                       cell_array("body", std::move(body_numbers)),
                                       cell_array("surface", surface_of_face(machine)),
                                       cell_array("interface", interface_of_face(machine)),
                                       cell_array("symmetry", std::move(symmetry)),
                                       {"exposed", VtuArray::Place::cell, 1, std::move(exposed)}};
    write_vtu(path, grid, arrays, notes);
}

void write_names(const std::filesystem::path& path, const Machine& machine, const std::vector<std::string>& comments)
{
    std::vector<std::string> kinds;
    std::vector<std::string> numbers;
    std::vector<std::string> names;
    const auto add = [&](const char* kind, const auto& items, const auto& name) {
        for (std::size_t i = 0; i < items.size(); ++i) {
            kinds.emplace_back(kind);
            numbers.push_back(std::to_string(i));
            names.push_back(name(items[i]));
        }
    };
    const auto name_of = [](const auto& item) { return item.name; };
    add("part", machine.parts, name_of);
    add("body", body_names(machine), [](const std::string& name) { return name; });
    add("surface", machine.surfaces, name_of);
    add("interface", machine.interfaces, name_of);
    const std::vector<CsvColumn> columns{csv_column(schema::names::kind, kinds),
                                         csv_column(schema::names::number, numbers),
                                         csv_column(schema::names::name, names)};
    write_table(path, comments, columns);
}

}  // namespace

std::vector<std::string> body_names(const Machine& machine)
{
    std::vector<std::string> names;
    for (const auto& part : machine.parts) {
        if (std::ranges::find(names, part.body) == names.end()) {
            names.push_back(part.body);
        }
    }
    return names;
}

std::vector<std::int32_t> body_of_part(const Machine& machine)
{
    const auto names = body_names(machine);
    Integers result;
    for (const auto& part : machine.parts) {
        result.push_back(static_cast<std::int32_t>(std::ranges::find(names, part.body) - names.begin()));
    }
    return result;
}

void write_mesh_files(const std::filesystem::path& folder, const Machine& machine,
                      const std::vector<std::string>& comments)
{
    const VtuNotes notes{{}, comments};
    write_cells(folder / "mesh.vtu", machine, notes);
    write_faces(folder / "surfaces.vtu", machine, notes);
    write_names(folder / "names.csv", machine, comments);
}

}  // namespace deadpoint::report
