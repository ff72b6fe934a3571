#include "deadpoint/report/mesh/plan_text.hpp"

#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/core/units.hpp"
#include "deadpoint/exchange/machine.hpp"
#include "deadpoint/press/check/whole_mass.hpp"
#include "deadpoint/press/problem/deformation_mesh.hpp"
#include "deadpoint/press/problem/heat.hpp"
#include "deadpoint/report/mesh/mesh_files.hpp"
#include "deadpoint/report/tables/table.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace deadpoint::report {
namespace {

using casefile::Case;

std::string percent(double share, int decimals = 1) { return fmt::format("{:.{}f} %", 100 * share, decimals); }

/// Separates thousands by blanks: 101 234.
std::string grouped(long long number)
{
    std::string digits = std::to_string(number);
    for (int at = static_cast<int>(digits.size()) - 3; at > 0; at -= 3) {
        digits.insert(static_cast<std::size_t>(at), 1, ' ');
    }
    return digits;
}

std::string section(const std::string& title, const TextTable& table)
{
    return table.empty() ? std::string{} : "\n" + title + "\n" + table.text();
}

std::string bodies_section(const Case& description, const Machine& machine)
{
    TextTable table({"body", "parts", "mass [kg]", "stated [kg]", "difference"});
    for (const auto& mass : press::whole_masses(description, machine)) {
        const auto deviation = mass.deviation();
        table.add_row({mass.body, std::to_string(mass.parts), significant(mass.computed, 4),
                       mass.stated ? significant(*mass.stated, 4) : "",
                       deviation      ? fmt::format("{:+.1f} %", 100 * *deviation)
                       : mass.partial ? "cut"
                                      : ""});
    }
    return section(machine.half_model ? "Bodies (masses of the whole machine)" : "Bodies", table);
}

std::string parts_section(const Machine& machine)
{
    TextTable table({"part", "body", "pieces", "cells", "kind", "exposed [m2]", "quality min", "mean"});
    table.align_left(1);
    table.align_left(4);
    for (const auto& part : machine.parts) {
        table.add_row({part.name, part.body, std::to_string(part.pieces), grouped(part.cell_count),
                       std::string(part.kind == CellKind::hexahedron ? "hex" : "tet") + (part.cut ? ", cut" : ""),
                       significant(part.exposed_area), fmt::format("{:.2f}", part.min_quality),
                       fmt::format("{:.2f}", part.mean_quality)});
    }
    return section("Parts and their meshes", table);
}

std::string part_name(const Machine& machine, std::uint32_t part)
{
    return part < machine.parts.size() ? machine.parts[part].name : std::string("?");
}

std::string interfaces_section(const Case& description, const Machine& machine)
{
    TextTable table(
        {"interface", "kind", "between", "and", "area [cm2]", "covered", "gap [um]", "stroke [mm]", "least"});
    table.align_left(1);
    table.align_left(2);
    table.align_left(3);
    for (const auto& contact : machine.interfaces) {
        if (!contact.perfect) {
            continue;  // a bond
        }
        const auto joint = description.joints.find(contact.name.substr(0, contact.name.find('.')));
        table.add_row(
            {contact.name, joint == description.joints.end() ? "" : std::string(casefile::name_of(joint->second.kind)),
             part_name(machine, contact.part_a), part_name(machine, contact.part_b), significant(1e4 * contact.area, 4),
             percent(contact.coverage()), fmt::format("{:.1f}", micrometre * contact.max_gap),
             contact.stroke > 0 ? fmt::format("{:.1f}", 1e3 * contact.stroke) : "",
             contact.stroke > 0 ? percent(contact.least_coverage()) : ""});
    }
    return section("Joints and their interfaces", table);
}

std::string bonds_section(const Machine& machine)
{
    TextTable table({"bonded pair", "area [cm2]", "heat"});
    table.align_left(2);
    for (const auto& contact : machine.bonds) {
        const bool conducts =
            std::ranges::find(machine.interfaces, contact.name, &Contact::name) != machine.interfaces.end();
        table.add_row({contact.name, significant(1e4 * contact.area, 4),
                       contact.perfect ? "perfect contact"
                       : conducts      ? "by a conductance"
                                       : "open"});
    }
    return section(fmt::format("Bonded pairs ({})", machine.bonds.size()), table);
}

std::string condition_text(const casefile::Surface& surface)
{
    if (surface.film) {
        const auto* known = std::get_if<casefile::FilmCoefficient>(&surface.film->law);
        std::string text = known ? fmt::format("convection {} W/m2/K", significant(known->value.value_or(0)))
                                 : fmt::format("convection by law '{}'", casefile::law_name(*surface.film));
        if (surface.film->emissivity > 0) {
            text += fmt::format(", emissivity {}", significant(surface.film->emissivity));
        }
        return text;
    }
    if (surface.temperature || !surface.temperature_formula.empty()) {
        return "prescribed temperature";
    }
    if (surface.heat_flux) {
        return "heat flux";
    }
    return surface.insulated ? "insulated" : "named only";
}

std::string surfaces_section(const Case& description, const Machine& machine)
{
    TextTable table({"surface", "area [m2]", "condition"});
    table.align_left(2);
    for (const auto& surface : machine.surfaces) {
        const auto found = description.surfaces.find(surface.name);
        table.add_row({surface.name, significant(surface.area, 4),
                       found == description.surfaces.end() ? "" : condition_text(found->second)});
    }
    return section("Surfaces", table);
}

std::string operation_section(const Case& description)
{
    TextTable table({"operation", "duration", "speed [rpm]", "force [kN]"});
    for (const auto& segment : description.operation) {
        table.add_row({segment.name, duration_text(segment.duration),
                       significant(segment.speed * 30 / std::numbers::pi, 4), significant(segment.force / 1e3, 4)});
    }
    return section("Operation", table);
}

std::string orders_text(const Case& description, const Machine& machine)
{
    const auto orders = press::describe_orders(description, machine);
    const auto second = std::ranges::count(orders, 2);
    return second == 0                    ? "1"
           : second == std::ssize(orders) ? "2"
                                          : fmt::format("2 in {} of {} parts, else 1", second, orders.size());
}

std::string size_section(const Case& description, const Machine& machine)
{
    const auto size = estimate_size(description, machine);
    std::string text =
        fmt::format("\nSize\n  {} hexahedra, {} tetrahedra, order {}\n  {} unknowns of heat", grouped(size.hexahedra),
                    grouped(size.tetrahedra), orders_text(description, machine), grouped(size.heat_unknowns));
    if (size.deformation_unknowns > 0) {
        text += fmt::format(", {}{} of deformation", size.deformation_scale == 1 ? "" : "about ",
                            grouped(size.deformation_unknowns));
    }
    if (size.deformation_unknowns > 0 && size.deformation_scale != 1) {
        text += fmt::format(" on a separate mesh with cells {:.2f} times as large", size.deformation_scale);
    }
    return text + fmt::format("\n  about {:.1f} GB of memory\n", size.memory / 1e9);
}

}  // namespace

SizeEstimate estimate_size(const Case& description, const Machine& machine)
{
    SizeEstimate size;
    for (const auto& cell : machine.cells) {
        ++(cell.kind == CellKind::hexahedron ? size.hexahedra : size.tetrahedra);
    }
    const auto corners = press::count_corners(description, machine);
    size.heat_unknowns = corners.unknowns();
    size.deformation_scale = press::deformation_scale(description, machine);
    const double share = description.chain ? std::pow(size.deformation_scale, -3) : 0;
    const auto deformed = press::count_corners(press::case_of_deformation(description), machine);
    size.deformation_unknowns = std::llround(3 * share * static_cast<double>(deformed.unknowns()));
    const auto rows = [](const press::CornerCount& count) {
        return static_cast<double>(count.first_order) + 2.5 * 8 * static_cast<double>(count.second_order);
    };
    size.memory = memory_base + rows(corners) * memory_per_heat_unknown +
                  3 * share * rows(deformed) * memory_per_deformation_unknown;
    return size;
}

std::string plan_text(const Case& description, const Machine& machine)
{
    std::string text = description.machine.name.empty() ? "Plan" : description.machine.name;
    text += machine.half_model ? " (half model, x <= 0)\n" : "\n";
    text += bodies_section(description, machine) + parts_section(machine) + interfaces_section(description, machine) +
            bonds_section(machine) + surfaces_section(description, machine) + operation_section(description);
    if (!machine.dropped_parts.empty()) {
        text += fmt::format("\nLeft out, beyond the symmetry plane: {}\n", fmt::join(machine.dropped_parts, ", "));
    }
    return text + size_section(description, machine);
}

}  // namespace deadpoint::report
