#include "deadpoint/core/mistakes.hpp"
#include "deadpoint/core/names/pattern_pair.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/machine/assembly/assembly.hpp"
#include "deadpoint/machine/assembly/contacts.hpp"
#include "deadpoint/machine/assembly/limits.hpp"
#include "deadpoint/machine/geometry/chart.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace deadpoint::machine {
namespace {

constexpr double least_bond_area = 1e-8;

bool apart(const BoxShape& a, const BoxShape& b)
{
    for (std::size_t i = 0; i < 3; ++i)
        if (a.min[i] > b.max[i] + contact_tolerance || b.min[i] > a.max[i] + contact_tolerance)
            return true;
    return false;
}

PatternPair needed_pair(const char* what, const std::string& text)
{
    if (auto pair = pattern_pair(text))
        return *pair;
    throw InputError(fmt::format("{} pair '{}' is not of the form 'part|part'", what, text));
}

/// A pair of a stated bond, and what became of it.
struct StatedPair {
    const BondDescription* bond;
    PatternPair pair;
    std::string text;
    std::string path;
    bool found = false;
    bool unbonded = false;  ///< touching parts that it names are left unbonded,
    bool joined = false;    ///< or an interface of a joint joins them
};

std::vector<StatedPair> stated_pairs(const std::vector<BondDescription>& bonds)
{
    std::vector<StatedPair> pairs;
    for (const auto& bond : bonds)
        for (std::size_t i = 0; i < bond.between.size(); ++i)
            pairs.push_back({&bond, needed_pair("bonded", bond.between[i]), bond.between[i],
                             fmt::format("bonds.{}.between.{}", bond.name, i)});
    return pairs;
}

/// Faces of one part on surfaces that lie on surfaces of another.
class TouchingFaces {
public:
    explicit TouchingFaces(const Assembly& assembly) : assembly_(assembly), geometries_(assembly.machine.parts.size())
    {
        for (std::uint32_t g = 0; g < assembly.machine.geometries.size(); ++g)
            geometries_[assembly.part_of_geometry[g]].push_back(g);
    }

    [[nodiscard]] Side of(std::uint32_t own, std::uint32_t other) const
    {
        Side side;
        const auto& all = assembly_.machine.geometries;
        for (const auto g : geometries_[own]) {
            const auto fits = [&](std::uint32_t h) { return can_touch(all[g], all[h], contact_tolerance); };
            const auto& faces = assembly_.faces_of_geometry[g];
            if (std::ranges::any_of(geometries_[other], fits))
                side.faces.insert(side.faces.end(), faces.begin(), faces.end());
        }
        return side;
    }

private:
    const Assembly& assembly_;
    std::vector<std::vector<std::uint32_t>> geometries_;  ///< by part
};

class BondFinder {
public:
    BondFinder(const Assembly& assembly, const MachineDescription& description,
               const std::vector<std::array<std::uint32_t, 2>>& joined, Mistakes& mistakes)
        : assembly_(assembly), joined_(joined), mistakes_(mistakes), faces_(assembly),
          stated_(stated_pairs(description.bonds))
    {
        for (const auto& text : description.unbonded)
            unbonded_.push_back(needed_pair("unbonded", text));
    }

    std::vector<Contact> find(std::vector<double>& covered)
    {
        const auto count = static_cast<std::uint32_t>(assembly_.machine.parts.size());
        for (std::uint32_t i = 0; i < count; ++i)
            for (std::uint32_t j = i + 1; j < count; ++j)
                look_at(i, j, covered);
        report_missing();
        return std::move(bonds_);
    }

private:
    [[nodiscard]] const std::string& name(std::uint32_t part) const { return assembly_.machine.parts[part].name; }

    void look_at(std::uint32_t i, std::uint32_t j, std::vector<double>& covered)
    {
        const auto& parts = assembly_.machine.parts;
        if (parts[i].body != parts[j].body || apart(assembly_.bounds[i], assembly_.bounds[j]))
            return;
        const bool joined = std::ranges::find(joined_, std::array{i, j}) != joined_.end();
        const bool unbonded =
            std::ranges::any_of(unbonded_, [&](const PatternPair& pair) { return pair.names(name(i), name(j)); });
        if (joined || unbonded) {
            for (auto& stated : stated_)
                if (stated.pair.names(name(i), name(j)))
                    (joined ? stated.joined : stated.unbonded) = true;
            return;
        }
        Contact bond = find_contact(assembly_, faces_.of(i, j), faces_.of(j, i), contact_tolerance, covered);
        if (bond.area < least_bond_area)
            return;
        bond.name = name(i) + "|" + name(j);
        bond.perfect = !is_stated(name(i), name(j));
        bonds_.push_back(std::move(bond));
    }

    bool is_stated(const std::string& a, const std::string& b)
    {
        const StatedPair* first = nullptr;
        for (auto& stated : stated_) {
            if (!stated.pair.names(a, b))
                continue;
            stated.found = true;
            if (first != nullptr && first->bond != stated.bond)
                mistakes_.add(stated.path, fmt::format("the bond of '{}' and '{}' is stated twice", a, b),
                              fmt::format("[bonds.{}] has it already: name each pair once", first->bond->name));
            else
                first = &stated;
        }
        return first != nullptr;
    }

    // A half model may have lost a pair behind its plane of symmetry.
    [[nodiscard]] bool lost(const StatedPair& stated) const
    {
        return std::ranges::any_of(assembly_.machine.dropped_parts, [&](const std::string& part) {
            return matches(stated.pair.first, part) || matches(stated.pair.second, part);
        });
    }

    void report_missing()
    {
        for (const auto& stated : stated_) {
            if (stated.found || lost(stated))
                continue;
            if (stated.joined)
                mistakes_.add(stated.path, fmt::format("'{}' touch in a joint", stated.text),
                              "give the conductance to the joint's interface, and remove the bond");
            else if (stated.unbonded)
                mistakes_.add(stated.path, fmt::format("'{}' are left unbonded", stated.text),
                              "remove the pair from `unbonded` of [machine], or the bond");
            else
                mistakes_.add(stated.path, fmt::format("'{}' do not touch", stated.text),
                              "draw their faces within 10 um of each other, or remove the pair; `deadpoint check` "
                              "lists the bonded pairs");
        }
    }

    const Assembly& assembly_;
    const std::vector<std::array<std::uint32_t, 2>>& joined_;
    Mistakes& mistakes_;
    TouchingFaces faces_;
    std::vector<StatedPair> stated_;
    std::vector<PatternPair> unbonded_;
    std::vector<Contact> bonds_;
};

bool is_open(const Contact& bond, const std::vector<BondDescription>& stated)
{
    const auto bar = bond.name.find('|');
    const auto a = bond.name.substr(0, bar), b = bond.name.substr(bar + 1);
    return std::ranges::any_of(stated, [&](const BondDescription& one) {
        return one.open && std::ranges::any_of(one.between, [&](const std::string& text) {
                   return needed_pair("bonded", text).names(a, b);
               });
    });
}

}  // namespace

std::vector<Contact> find_bonds(const Assembly& assembly, const MachineDescription& description,
                                const std::vector<std::array<std::uint32_t, 2>>& joined, std::vector<double>& covered,
                                Mistakes& mistakes)
{
    return BondFinder(assembly, description, joined, mistakes).find(covered);
}

std::vector<Contact> conducting_bonds(const std::vector<Contact>& bonds, const MachineDescription& description)
{
    std::vector<Contact> result;
    for (const auto& bond : bonds)
        if (!bond.perfect && !is_open(bond, description.bonds))
            result.push_back(bond);
    return result;
}

}  // namespace deadpoint::machine
