#include "deadpoint/report/mesh/calculix_deck.hpp"

#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/core/names/plain_text.hpp"
#include "deadpoint/core/units.hpp"
#include "deadpoint/exchange/machine.hpp"
#include "deadpoint/io/write_file.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ostream.h>
#include <map>
#include <ostream>
#include <set>

namespace deadpoint::report {
namespace {

using Nodes = std::set<std::uint32_t>;

Nodes nodes_of(const Machine& machine, std::uint32_t face)
{
    const Face& on = machine.faces[face];
    return {on.nodes.begin(), on.nodes.begin() + on.node_count};
}

/// Nodes of the faces of all bonds, which ties may have moved with others already.
Nodes tied(const Machine& machine)
{
    Nodes nodes;
    for (const Contact& bond : machine.bonds)
        for (const auto& point : bond.points)
            for (const auto face : {point.face_a, point.face_b})
                nodes.merge(nodes_of(machine, face));
    return nodes;
}

Nodes of_symmetry(const Machine& machine)
{
    Nodes nodes;
    for (std::uint32_t f = 0; f < machine.faces.size(); ++f)
        if (machine.faces[f].symmetry)
            nodes.merge(nodes_of(machine, f));
    return nodes;
}

Nodes of_body(const Machine& machine, const std::string& body)
{
    Nodes nodes;
    for (const Cell& cell : machine.cells)
        if (machine.parts[cell.part].body == body)
            nodes.insert(cell.nodes.begin(), cell.nodes.begin() + (cell.kind == CellKind::hexahedron ? 8 : 4));
    return nodes;
}

std::size_t largest(const Vec3& v)
{
    return static_cast<std::size_t>(std::ranges::max_element(v, {}, [](double x) { return std::abs(x); }) - v.begin());
}

template <class Measure>
std::uint32_t farthest(const Nodes& nodes, const Measure& measure)
{
    return *std::ranges::max_element(nodes, {}, measure);
}

/// Single supports: node and direction.
class Supports {
public:
    Supports(const Machine& machine, const casefile::Case& input)
        : machine_(machine), tied_(tied(machine)), symmetry_(of_symmetry(machine))
    {
        for (const auto node : symmetry_)
            hold(node, 0);
        const auto feet = input.chain ? feet_of(input.chain->ground_surface) : Nodes{};
        for (const auto& [name, body] : input.bodies) {
            const Nodes nodes = of_body(machine, name);
            if (nodes.empty())
                continue;
            body.ground && !feet.empty() ? stand(feet) : hang(free(nodes), cut(nodes));
        }
    }
    [[nodiscard]] const std::set<std::pair<std::uint32_t, std::size_t>>& all() const { return held_; }

private:
    void hold(std::uint32_t node, std::size_t axis) { held_.insert({node, axis}); }
    [[nodiscard]] const Vec3& at(std::uint32_t node) const { return machine_.nodes[node]; }
    [[nodiscard]] bool cut(const Nodes& nodes) const
    {
        return std::ranges::any_of(nodes, [&](auto node) { return symmetry_.contains(node); });
    }
    [[nodiscard]] Nodes free(const Nodes& nodes) const
    {
        Nodes result;
        std::ranges::set_difference(nodes, tied_, std::inserter(result, result.end()));
        return result.size() < 3 ? nodes : result;
    }
    [[nodiscard]] Nodes feet_of(const std::string& surface) const
    {
        Nodes nodes;
        for (const auto& one : machine_.surfaces)
            if (one.name == surface)
                for (const auto& entry : one.faces)
                    if (entry.central)
                        nodes.merge(nodes_of(machine_, entry.face));
        return nodes;
    }

    /// On a plane of feet: they cannot lift, and two of them keep their place in it.
    void stand(const Nodes& feet)
    {
        Vec3 low = at(*feet.begin()), high = low;
        for (const auto node : feet)
            for (std::size_t i = 0; i < 3; ++i) {
                low[i] = std::min(low[i], at(node)[i]);
                high[i] = std::max(high[i], at(node)[i]);
            }
        const Vec3 edges = high - low;
        const auto up = static_cast<std::size_t>(std::ranges::min_element(edges) - edges.begin());
        const Nodes kept = free(feet);
        for (const auto node : kept)
            hold(node, up);
        const bool half = cut(feet);
        const auto first = *kept.begin();
        const auto second = farthest(kept, [&](auto node) { return norm(at(node) - at(first)); });
        const auto along = largest(at(second) - at(first));
        for (std::size_t i = 0; i < 3; ++i)
            if (i != up && !(half && i == 0))
                hold(first, i);
        if (!half)
            hold(second, 3 - up - along);
    }

    /// Without force: three nodes hold the rigid motions; the plane of symmetry holds three of the six.
    void hang(const Nodes& nodes, bool half)
    {
        const auto first = *nodes.begin();
        if (half) {
            const auto second = farthest(
                nodes, [&](auto node) { return std::hypot(at(node)[1] - at(first)[1], at(node)[2] - at(first)[2]); });
            hold(first, 1);
            hold(first, 2);
            const Vec3 way = at(second) - at(first);
            hold(second, std::abs(way[1]) > std::abs(way[2]) ? 2 : 1);
            return;
        }
        const auto second = farthest(nodes, [&](auto node) { return norm(at(node) - at(first)); });
        const Vec3 way = at(second) - at(first);
        const auto third = farthest(nodes, [&](auto node) { return norm(cross(way, at(node) - at(first))); });
        const auto along = largest(way);
        for (std::size_t i = 0; i < 3; ++i) {
            hold(first, i);
            if (i != along)
                hold(second, i);
        }
        Vec3 around = cross(way, at(third) - at(first));
        around[along] = 0;
        hold(third, largest(around));
    }

    const Machine& machine_;
    Nodes tied_;
    Nodes symmetry_;
    std::set<std::pair<std::uint32_t, std::size_t>> held_;
};

void write_materials(std::ostream& out, const Machine& machine, const casefile::Case& input)
{
    std::set<std::string> names;
    for (const MeshPart& part : machine.parts)
        names.insert(input.parts.at(part.name).material);
    for (const auto& name : names) {
        const auto& m = input.materials.at(name);
        fmt::print(out, "*MATERIAL, NAME={}\n*ELASTIC\n{:.9g}, {:.9g}\n*EXPANSION, ZERO={:.9g}\n{:.9g}\n",
                   calculix_name("M_", name), m.youngs_modulus, m.poissons_ratio,
                   input.machine.initial_temperature - zero_celsius, m.expansion);
        fmt::print(out, "*DENSITY\n{:.9g}\n*CONDUCTIVITY\n{:.9g}\n*SPECIFIC HEAT\n{:.9g}\n", m.density, m.conductivity,
                   m.specific_heat);
    }
    for (const MeshPart& part : machine.parts)
        fmt::print(out, "*SOLID SECTION, ELSET={}, MATERIAL={}\n", calculix_name("PART_", part.name),
                   calculix_name("M_", input.parts.at(part.name).material));
}

double mean_area(double area, const Nodes& faces) { return area / static_cast<double>(faces.size()); }

/// The side with the smaller faces follows the other one, point by point. Nodes on its rim may lie a little beside the
/// other side.
void write_ties(std::ostream& out, const Machine& machine)
{
    constexpr double reach = 2e-3;  // [m]
    int number = 0;
    for (const Contact& bond : machine.bonds) {
        Nodes a, b;
        for (const auto& point : bond.points) {
            a.insert(point.face_a);
            b.insert(point.face_b);
        }
        const bool a_follows = mean_area(bond.area_a, a) <= mean_area(bond.area_b, b);
        const std::string name = calculix_name("BOND_", bond.name);
        fmt::print(out, "*TIE, NAME=TIE{}, POSITION TOLERANCE={:.6g}, ADJUST=NO\n{}_{}, {}_{}\n", ++number,
                   reach + 1.5 * bond.max_gap, name, a_follows ? "A" : "B", name, a_follows ? "B" : "A");
    }
}

}  // namespace

std::string calculix_name(const std::string& prefix, std::string name)
{
    std::ranges::replace_if(
        name, [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
    return prefix + name;
}

void write_calculix_deck(const std::filesystem::path& path, const Machine& machine, const casefile::Case& input,
                         std::span<const double> temperatures, const std::string& mesh,
                         const std::vector<std::string>& comments)
{
    const Supports supports(machine, input);
    write_file(path, [&](std::ostream& out) {
        for (const auto& comment : comments)
            fmt::print(out, "** {}\n", one_line(comment));
        fmt::print(out, "*INCLUDE, INPUT={}\n", mesh);
        write_materials(out, machine, input);
        write_ties(out, machine);
        out << "*BOUNDARY\n";
        for (const auto& [node, axis] : supports.all())
            fmt::print(out, "{}, {}, {}\n", node + 1, axis + 1, axis + 1);
        fmt::print(out, "*INITIAL CONDITIONS, TYPE=TEMPERATURE\nALL, {:.9g}\n*STEP\n*STATIC\n*TEMPERATURE\n",
                   input.machine.initial_temperature - zero_celsius);
        for (std::size_t n = 0; n < temperatures.size(); ++n)
            fmt::print(out, "{}, {:.7g}\n", n + 1, temperatures[n]);
        out << "*NODE FILE\nU, NT\n*EL FILE\nS\n*END STEP\n";
    });
}

}  // namespace deadpoint::report
