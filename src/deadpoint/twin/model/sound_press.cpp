#include "deadpoint/twin/model/sound_press.hpp"

#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/drift/chain.hpp"
#include "deadpoint/io/binary_file.hpp"
#include "deadpoint/reduce/online/dense_terms.hpp"
#include "deadpoint/twin/model/reduced_members.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <sstream>
#include <vector>

namespace deadpoint::twin {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_cells = std::size_t{1} << 40;  // far beyond any memory

// A name may lead nowhere but to a file in the folder of the model: this one's, or where the model itself is linked to.
std::string flaw_of_link(const std::string& large_file, const fs::path& file)
{
    const fs::path name(large_file);
    if (name.empty())
        return {};
    std::error_code none;
    const auto folder_of = [&](const fs::path& path) { return fs::weakly_canonical(path, none).parent_path(); };
    const auto large = file.parent_path() / name;
    const auto folder = folder_of(large);
    const bool plain = name == name.filename() && name != "." && name != "..";
    if (plain &&
        (!fs::exists(large, none) || folder == folder_of(file) || folder == folder_of(file.parent_path() / "x")))
        return {};
    return fmt::format("it names the large model '{}', which is not in its own folder", large_file);
}

bool contacts_fit(const std::vector<Contact>& contacts, std::size_t parts)
{
    return std::ranges::all_of(contacts, [&](const Contact& c) {
        return c.part_a < parts && c.part_b < parts && c.area >= 0 && c.area_a >= 0 && c.area_b >= 0;
    });
}

bool surface_fits(const MeshSurface& surface, std::size_t parts)
{
    const auto share_fits = [&](const SurfaceShare& share) { return share.part < parts && share.area >= 0; };
    return surface.area >= 0 && std::ranges::all_of(surface.figures.parts, share_fits);
}

bool positive(const std::vector<double>& values)
{
    return std::ranges::all_of(values, [](double value) { return value >= 0; });
}

std::string flaw_of_machine(const Machine& machine, const heat::HeatGeometry& geometry)
{
    const auto parts = machine.parts.size();
    if (parts != geometry.layout.parts || machine.interfaces.size() != geometry.layout.interfaces)
        return "its machine has other numbers of parts and interfaces than its terms";
    for (std::size_t i = 0; i < machine.interfaces.size(); ++i)
        if (machine.interfaces[i].name != geometry.interface_names[i])
            return fmt::format("interface '{}' of its machine is '{}' of its terms", machine.interfaces[i].name,
                               geometry.interface_names[i]);
    const auto part_fits = [](const MeshPart& part) { return part.volume >= 0 && part.mass >= 0; };
    if (!contacts_fit(machine.interfaces, parts) || !contacts_fit(machine.bonds, parts) ||
        !std::ranges::all_of(machine.parts, part_fits) || !positive(geometry.interface_area) ||
        !positive(geometry.surface_area) ||
        !std::ranges::all_of(machine.surfaces, [&](const auto& surface) { return surface_fits(surface, parts); }))
        return "a part, surface or contact of its machine belongs to no part, or has a negative size";
    return {};
}

// Corners are none, or four of which two may be mirror images. Observed functionals beyond the adjoints split E_SW and
// the growths of the plays by part.
std::string flaw_of_chain(const ReducedPress& press, std::size_t observed)
{
    const auto split = observed - press.adjoints;
    if (!press.chain)
        return split == 0 ? "" : "it splits functionals by part and has no dimension chain";
    const auto& [figures, gaps, first_gap] = *press.chain;
    const auto bearings = static_cast<std::size_t>(std::max(figures.bearings, 0));
    const bool fits = figures.bearings >= 0 && bearings < observed && first_gap == drift::dimension_count + bearings &&
                      first_gap <= press.adjoints &&
                      gaps.corners.size() + gaps.clearances.size() <= press.adjoints - first_gap &&
                      (gaps.corners.empty() || gaps.corners.size() == (gaps.mirrored ? 2U : 4U)) &&
                      split == (1 + bearings) * press.machine.parts.size();
    return fits ? "" : "the bearings, corners and clearances of its chain are not those that it observes";
}

std::string flaw_of_frame(const ReducedPress& press)
{
    const auto forces = press.frame ? press.frame->rods.size() + press.frame->bonds.size() : 0;
    const bool fits = press.first_frame <= press.adjoints && forces <= press.adjoints - press.first_frame;
    return !press.frame || fits ? "" : "it has more rods and bonds under preload than it observes";
}

// Members of heat are found by their names, those of oil temperatures and ambients where they are.
std::string flaw_of(const reduce::FreeCoefficient& one, const heat::FunctionalLayout& layout)
{
    using enum reduce::FreeCoefficient::Kind;
    const auto below = [&](std::size_t limit) {
        return std::ranges::all_of(one.members, [&](std::size_t member) { return member < limit; });
    };
    const bool fits = one.base.size() == one.members.size() && !one.base.empty() && one.from <= one.to &&
                      (one.kind == ambient || one.kind == oil_temperature || one.from >= 0) && positive(one.base) &&
                      (one.kind != film || below(layout.surfaces)) &&
                      (one.kind != side || below(2 * layout.interfaces)) &&
                      (one.kind != oil || below(layout.interfaces));
    return fits ? ""
                : fmt::format("its coefficient '{}' has no range, or changes what the press does not have", one.name);
}

std::string flaw_of_figures(const ReducedPress& press)
{
    const auto error_fits = [](const auto& error) { return error.temperature >= 0 && error.gap >= 0; };
    const bool fits = press.size_scale > 0 && press.cells < most_cells && press.unknowns < most_cells &&
                      press.reference > 0 && std::ranges::all_of(press.errors, error_fits) &&
                      std::ranges::all_of(press.sizes, error_fits);
    return fits ? "" : "its cells, its reference temperature or its errors cannot be";
}

// Conditions of surfaces, part by part, as split_by_part() makes them of a case.
std::size_t pieces_of(const casefile::Case& input, const Machine& machine)
{
    std::size_t count = 0;
    for (const auto& [name, surface] : input.surfaces)
        for (const auto& mesh : machine.surfaces)
            if (mesh.name == name &&
                (surface.film || surface.temperature || !surface.temperature_formula.empty() || surface.heat_flux))
                count += mesh.figures.parts.size();
    return count;
}

template <class Things>
std::vector<std::string> names_in(const Things& things)
{
    std::vector<std::string> names;
    for (const auto& thing : things)
        names.push_back(thing.name);
    return names;
}

// In the order in which a machine has them.
std::vector<std::string> interfaces_of(const casefile::Case& input)
{
    std::vector<std::string> names;
    for (const auto& [joint, of] : input.joints)
        for (const auto& interface : of.interfaces)
            names.push_back(joint + "." + interface.name);
    return names;
}

bool are_parts_of(const casefile::Case& input, const Machine& machine)
{
    const auto names = names_in(machine.parts);
    return std::ranges::adjacent_find(names, std::ranges::greater_equal{}) == names.end() &&
           std::ranges::all_of(machine.parts, [&](const MeshPart& part) {
               const auto found = input.parts.find(part.name);
               return found != input.parts.end() && found->second.body == part.body;
           });
}

bool are_surfaces_of(const casefile::Case& input, const Machine& machine)
{
    std::vector<std::string> names;
    for (const auto& [name, surface] : input.surfaces)
        names.push_back(name);
    return names == names_in(machine.surfaces);
}

// Those of joints first; behind them bonds with a conductance.
bool are_interfaces_of(const casefile::Case& input, const Machine& machine)
{
    const auto own = interfaces_of(input), found = names_in(machine.interfaces);
    return found.size() >= own.size() && std::equal(own.begin(), own.end(), found.begin()) &&
           std::all_of(found.begin() + static_cast<std::ptrdiff_t>(own.size()), found.end(),
                       [](const std::string& name) { return name.find('|') != std::string::npos; });
}

bool is_chain_of(const casefile::Case& input, const std::optional<ReducedChain>& chain)
{
    return chain.has_value() == input.chain.has_value() &&
           (!chain || std::ranges::all_of(chain->gaps.clearances, [&](const press::GapModel::Clearance& clearance) {
               return input.joints.contains(clearance.joint);
           }));
}

std::string common_bytes(const ReducedPress& press)
{
    std::ostringstream out;
    BinaryWriter writer(out, "");
    std::apply([&](auto... member) { writer(press.*member...); }, common_members(&press));
    writer(press.terms->terms.geometry);
    return out.str();
}

}  // namespace

std::string flaw_of(const ReducedPress& press, const fs::path& file)
{
    const auto& terms = press.terms->terms;
    const auto observed = static_cast<std::size_t>(terms.observed.rows());
    if (press.adjoints > observed)
        return fmt::format("it observes {} functionals, and says that {} have a meaning", observed, press.adjoints);
    std::vector<std::string> flaws{flaw_of_link(press.large_file, file), flaw_of_machine(press.machine, terms.geometry),
                                   flaw_of_chain(press, observed), flaw_of_frame(press), flaw_of_figures(press)};
    for (const auto& one : press.box)
        flaws.push_back(flaw_of(one, terms.geometry.layout));
    const auto first = std::ranges::find_if(flaws, [](const std::string& flaw) { return !flaw.empty(); });
    return first == flaws.end() ? "" : *first;
}

std::string flaw_for(const casefile::Case& input, const ReducedPress& press)
{
    const auto& layout = press.terms->terms.geometry.layout;
    if (!are_parts_of(input, press.machine) || press.machine.half_model != input.machine.half_model)
        return "its parts are not those of the case";
    if (!are_interfaces_of(input, press.machine))
        return "its interfaces are not those of the joints of the case";
    if (!are_surfaces_of(input, press.machine) || layout.surfaces != pieces_of(input, press.machine))
        return "its surfaces are not those of the case";
    if (layout.probes != input.probes.size() || layout.bodies != input.heat_sources.size())
        return fmt::format("it has {} probes and {} sources of other heat; the case has {} and {}", layout.probes,
                           layout.bodies, input.probes.size(), input.heat_sources.size());
    return is_chain_of(input, press.chain) ? "" : "its dimension chain is not that of the case";
}

bool is_same_press(const ReducedPress& press, const ReducedPress& large)
{
    return press.case_hash == large.case_hash && press.fixed_part == large.fixed_part &&
           press.terms->terms.observed.rows() == large.terms->terms.observed.rows() &&
           common_bytes(press) == common_bytes(large);
}

}  // namespace deadpoint::twin
