#include "deadpoint/full/frame/frame_state.hpp"

#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/core/mistakes.hpp"
#include "deadpoint/core/names/pattern.hpp"
#include "deadpoint/core/units.hpp"
#include "deadpoint/fem/model.hpp"
#include "deadpoint/fem/tighten.hpp"
#include "deadpoint/press/problem/heat.hpp"
#include "deadpoint/press/translate/lookup.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <limits>
#include <map>
#include <set>

namespace deadpoint::full {
namespace {

Vec3 gravity_of(const casefile::Case& input)
{
    return input.foundation ? input.foundation->gravity * normalised(input.machine.gravity_direction) : Vec3{};
}

bool pair_matches(const std::string& pair, const std::string& a, const std::string& b)
{
    const auto bar = pair.find('|');
    const auto first = pair.substr(0, bar), second = pair.substr(bar + 1);
    return (matches(first, a) && matches(second, b)) || (matches(first, b) && matches(second, a));
}

void add(std::vector<PartStress>& sum, const std::vector<PartStress>& other)
{
    for (std::size_t p = 0; p < sum.size(); ++p)
        for (std::size_t i = 0; i < sum[p].stress.size(); ++i)
            for (std::size_t c = 0; c < 6; ++c)
                sum[p].stress[i][c] += other[p].stress[i][c];
}

press::StressPeak peak_of(const Machine& machine, const PartStress& part, double time)
{
    press::StressPeak peak{time, machine.parts[part.part].name, -1, {}, {}, 0, 0};
    peak.highest_principal = std::numeric_limits<double>::lowest();
    peak.lowest_principal = std::numeric_limits<double>::max();
    for (std::size_t i = 0; i < part.nodes.size(); ++i) {
        const double here = von_mises(part.stress[i]);
        const auto main = principal(part.stress[i]);
        peak.highest_principal = std::max(peak.highest_principal, main[0]);
        peak.lowest_principal = std::min(peak.lowest_principal, main[2]);
        if (here <= peak.von_mises)
            continue;
        peak.von_mises = here;
        peak.place = machine.nodes[part.nodes[i]];
        peak.principal = main;
    }
    return peak;
}

std::vector<fem::PointData> field_data(const Machine& machine, const std::vector<PartStress>& stress)
{
    constexpr float nothing = std::numeric_limits<float>::quiet_NaN();
    fem::PointData mises{"von Mises stress [MPa]", 1, std::vector<float>(machine.nodes.size(), nothing)};
    fem::PointData main{"principal stresses [MPa]", 3, std::vector<float>(3 * machine.nodes.size(), nothing)};
    for (const auto& part : stress)
        for (std::size_t i = 0; i < part.nodes.size(); ++i) {
            mises.values[part.nodes[i]] = static_cast<float>(megapascal * von_mises(part.stress[i]));
            const auto values = principal(part.stress[i]);
            for (std::size_t c = 0; c < 3; ++c)
                main.values[3 * part.nodes[i] + c] = static_cast<float>(megapascal * values[c]);
        }
    return {mises, main};
}

}  // namespace

bool has_frame_state(const casefile::Case& input)
{
    return input.foundation || !input.preload.empty() || !input.output.stress.empty();
}

namespace {

Foundation::Kind kind_of(casefile::Foundation::Kind stated)
{
    switch (stated) {
    case casefile::Foundation::Kind::clamped:
        return Foundation::Kind::clamped;
    case casefile::Foundation::Kind::elastic:
        return Foundation::Kind::elastic;
    default:
        return Foundation::Kind::free;
    }
}

}  // namespace

Foundation describe_foundation(const casefile::Case& input, const Machine& machine)
{
    Foundation result;
    std::string surface = input.chain ? input.chain->ground_surface : std::string{};
    if (input.foundation) {
        const auto& stated = *input.foundation;
        result.kind = kind_of(stated.kind);
        result.vertical = stated.vertical_stiffness.value_or(0);
        result.horizontal = stated.horizontal_stiffness.value_or(0);
        if (!stated.surface.empty())
            surface = stated.surface;
    }
    result.surface = press::surface_index(machine, surface);
    return result;
}

namespace {

/// The rods and closed bonds of one preload after those before it.
class GaugeFinder {
public:
    GaugeFinder(const Machine& machine, FrameGauges& gauges, Mistakes& mistakes)
        : machine_(machine), gauges_(gauges), mistakes_(mistakes)
    {}

    void add(const std::string& name, const casefile::Preload& preload)
    {
        const auto before = gauges_.rods.size();
        for (int p = 0; p < static_cast<int>(machine_.parts.size()); ++p)
            if (std::ranges::any_of(preload.parts,
                                    [&](const auto& wanted) { return matches(wanted, machine_.parts[p].name); }))
                add_rod(name, preload, p);
        if (gauges_.rods.size() == before)
            mistakes_.add("preload." + name, "none of its rods is in the modelled half");
        for (std::size_t i = 0; i < preload.closes.size(); ++i)
            add_bonds(name, preload.closes[i], fmt::format("preload.{}.closes.{}", name, i));
    }

private:
    void add_rod(const std::string& name, const casefile::Preload& preload, int index)
    {
        const auto& part = machine_.parts[index].name;
        if (!taken_.insert(part).second)
            mistakes_.add("preload." + name, fmt::format("rod '{}' is preloaded twice; name it once", part));
        gauges_.rods.push_back({part, ForceGauge::Kind::rod, index, preload.axis});
        gauges_.wanted.push_back(preload.force);
        gauges_.start.rods.push_back({part, name, preload.force, {}, preload.process_share});
    }

    void add_bonds(const std::string& name, const std::string& pair, const std::string& path)
    {
        const auto known = gauges_.bonds.size();
        for (int b = 0; b < static_cast<int>(machine_.bonds.size()); ++b) {
            const auto& bond = machine_.bonds[b];
            if (!pair_matches(pair, machine_.parts[bond.part_a].name, machine_.parts[bond.part_b].name))
                continue;
            gauges_.bonds.push_back({bond.name, ForceGauge::Kind::bond, b, Axis::y});
            gauges_.start.bonds.push_back({bond.name, name, bond.area, 0, {}, {}});
        }
        if (gauges_.bonds.size() == known)
            mistakes_.add(path, fmt::format("no bonded pair of parts is '{}'", pair),
                          "see the bonded pairs of `deadpoint check`");
    }

    const Machine& machine_;
    FrameGauges& gauges_;
    Mistakes& mistakes_;
    std::set<std::string> taken_;
};

}  // namespace

FrameGauges frame_gauges(const casefile::Case& input, const Machine& machine)
{
    FrameGauges gauges;
    Mistakes mistakes;
    GaugeFinder finder(machine, gauges, mistakes);
    for (const auto& [name, preload] : input.preload)
        finder.add(name, preload);
    mistakes.raise();
    return gauges;
}

FrameState::FrameState(const casefile::Case& input, const Machine& machine, fem::Model& model)
    : machine_(machine), model_(model), gauges_(frame_gauges(input, machine))
{
    loads_ = about("preload", [&] {
        return fem::tighten(model_, machine_.parts.size(), gauges_.rods, gauges_.wanted, gravity_of(input));
    });
    const bool weights = norm(loads_.gravity) > 0;
    auto gauges = gauges_.rods;
    gauges.insert(gauges.end(), gauges_.bonds.begin(), gauges_.bonds.end());
    adjoints_ = model_.adjoints(gauges);
    if (!weights && loads_.initial_strain.empty())
        return;
    at_rest_ = model_.displacement(loads_);
    if (weights)
        gauges.push_back({"feet", ForceGauge::Kind::feet, 0, Axis::y});
    const auto forces = model_.forces(gauges, loads_, *at_rest_);
    for (std::size_t i = 0; i < gauges_.rods.size(); ++i)
        gauges_.start.rods[i].start = forces[i];
    for (std::size_t i = 0; i < gauges_.bonds.size(); ++i)
        gauges_.start.bonds[i].start = forces[gauges_.rods.size() + i];
    if (weights)
        gauges_.start.support_force = forces.back();
}

int FrameState::finer_part(int bond) const
{
    const auto& contact = machine_.bonds[bond];
    const auto cell = [&](std::uint32_t p) { return machine_.parts[p].volume / machine_.parts[p].cell_count; };
    return static_cast<int>(cell(contact.part_a) < cell(contact.part_b) ? contact.part_a : contact.part_b);
}

std::vector<int> FrameState::stressed_parts(const casefile::Case& input) const
{
    std::vector<int> result;
    for (int p = 0; p < static_cast<int>(machine_.parts.size()); ++p)
        if (std::ranges::any_of(input.output.stress, [&](const auto& wanted) {
                return wanted == machine_.parts[p].body || matches(wanted, machine_.parts[p].name);
            }))
            result.push_back(p);
    return result;
}

// At the nodes of the finer side, each with its share of the contact points' area.
press::Opening FrameState::opening(int bond, const PartStress& stress, double time) const
{
    struct Node {
        double area = 0;
        Vec3 normal{};
    };
    std::map<std::uint32_t, Node> nodes;
    for (const auto& point : machine_.bonds[bond].points) {
        const auto& a = machine_.faces[point.face_a];
        const auto& face = static_cast<int>(a.part) == stress.part ? a : machine_.faces[point.face_b];
        for (unsigned i = 0; i < face.node_count; ++i) {
            auto& node = nodes[face.nodes[i]];
            node.area += point.weight / face.node_count;
            node.normal = node.normal + point.weight * point.normal;
        }
    }
    press::Opening result{time, std::numeric_limits<double>::lowest(), {}, 0};
    double area = 0;
    for (std::size_t i = 0; i < stress.nodes.size(); ++i) {
        const auto found = nodes.find(stress.nodes[i]);
        if (found == nodes.end())
            continue;
        const double tension = normal_stress(stress.stress[i], normalised(found->second.normal));
        area += found->second.area;
        if (tension > 0)
            result.share += found->second.area;
        if (tension > result.largest) {
            result.largest = tension;
            result.place = machine_.nodes[stress.nodes[i]];
        }
    }
    result.share /= area;
    return result;
}

std::vector<fem::PointData> FrameState::add_time(const casefile::Case& input, double time,
                                                 const fem::Field& temperature, const fem::Displacement& displacement,
                                                 press::FrameResult& result) const
{
    const auto shown = stressed_parts(input);
    auto parts = shown;
    for (const auto& bond : gauges_.bonds)
        parts.push_back(finer_part(bond.index));
    if (parts.empty())
        return {};
    std::ranges::sort(parts);
    parts.erase(std::unique(parts.begin(), parts.end()), parts.end());
    auto stress = model_.stress(parts, displacement, temperature, input.machine.initial_temperature);
    if (at_rest_)
        add(stress, model_.stress(parts, *at_rest_, loads_));
    const auto of = [&](int part) -> const PartStress& {
        return *std::ranges::find_if(stress, [&](const auto& s) { return s.part == part; });
    };
    for (std::size_t i = 0; i < gauges_.bonds.size(); ++i)
        result.bonds[i].openings.push_back(
            opening(gauges_.bonds[i].index, of(finer_part(gauges_.bonds[i].index)), time));
    std::erase_if(stress, [&](const auto& s) { return !std::ranges::binary_search(shown, s.part); });
    for (const auto& part : stress)
        result.stress.push_back(peak_of(machine_, part, time));
    return stress.empty() ? std::vector<fem::PointData>{} : field_data(machine_, stress);
}

}  // namespace deadpoint::full
