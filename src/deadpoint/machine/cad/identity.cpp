#include "deadpoint/machine/cad/identity.hpp"

#include "deadpoint/core/names/pattern.hpp"
#include "deadpoint/core/names/suggest.hpp"
#include "deadpoint/error.hpp"
#include <BRepBndLib.hxx>
#include <BRepGProp.hxx>
#include <Bnd_Box.hxx>
#include <GProp_GProps.hxx>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <functional>
#include <limits>

namespace deadpoint::machine {
namespace {

using Indices = std::vector<std::size_t>;

constexpr double volume_tolerance = 5e-3;
constexpr double length_tolerance = 2e-3;  ///< of the longest edge

double longest_edge(const SolidPrint& one) { return *std::ranges::max_element(one.size); }

double largest_difference(const Vec3& a, const Vec3& b)
{
    return std::max({std::abs(a[0] - b[0]), std::abs(a[1] - b[1]), std::abs(a[2] - b[2])});
}

/// How far apart two fingerprints are, in tolerances.
double difference(const SolidPrint& one, const SolidPrint& other)
{
    const double length = std::max(longest_edge(one), longest_edge(other));
    const double volume = std::max({one.volume, other.volume, std::numeric_limits<double>::min()});
    return std::max({std::abs(one.volume - other.volume) / (volume_tolerance * volume),
                     largest_difference(one.size, other.size) / (length_tolerance * length),
                     largest_difference(one.centre, other.centre) / (length_tolerance * length)});
}

std::string figures(const SolidPrint& one)
{
    return fmt::format("{:.4g} L at ({:.1f}, {:.1f}, {:.1f}) mm", 1e3 * one.volume, 1e3 * one.centre[0],
                       1e3 * one.centre[1], 1e3 * one.centre[2]);
}

/// One choice for one part.
class Choice {
public:
    Choice(const std::string& part, const StepSource& source, const std::vector<SolidIdentity>& solids)
        : part_(part), path_(source.path), name_(solid_reference(source.solid).name),
          print_(solid_print(solid_reference(source.solid).fingerprint)), solids_(solids)
    {}

    ChosenSolids all() const
    {
        const Indices found = candidates();
        if (found.empty()) {
            refuse_unknown();
        }
        if (is_pattern(found)) {
            if (print_) {
                throw InputError(
                    fmt::format("part '{}': a `fingerprint` is that of one solid, but '{}' takes {}\n  help: "
                                "remove the fingerprint, or name one solid",
                                part_, name_, found.size()));
            }
            return {found, {}};
        }
        return print_ ? by_fingerprint(found) : by_name(found);
    }

private:
    Indices where(const std::function<bool(const SolidIdentity&)>& wanted) const
    {
        Indices found;
        for (std::size_t i = 0; i < solids_.size(); ++i) {
            if (wanted(solids_[i])) {
                found.push_back(i);
            }
        }
        return found;
    }

    Indices candidates() const
    {
        const auto& text = name_;
        Indices found = where([&](const SolidIdentity& s) { return text.empty() || s.called == text; });
        if (found.empty()) {
            found = where([&](const SolidIdentity& s) { return s.name == text; });
            // A key with a number is one of several solids of a name, by the order of the file, which says nothing.
            if (!found.empty()) {
                const auto& called = solids_[found.front()].called;
                found = where([&](const SolidIdentity& s) { return s.called == called; });
            }
        }
        return found.empty()
                   ? where([&](const SolidIdentity& s) { return matches(text, s.called) || matches(text, s.name); })
                   : found;
    }

    bool is_pattern(const Indices& found) const
    {
        const auto& first = solids_[found.front()];
        return name_.find('*') != std::string::npos && first.called != name_;
    }

    ChosenSolids by_fingerprint(const Indices& found) const
    {
        const auto away = [&](std::size_t i) { return difference(solids_[i].fingerprint, *print_); };
        const auto nearest = *std::ranges::min_element(found, {}, away);
        if (away(nearest) <= 1) {
            return {{nearest}, {}};
        }
        refuse_if_elsewhere();
        if (found.size() > 1) {
            throw InputError(
                fmt::format("part '{}': {} solids of '{}' are called '{}', and none is as its `fingerprint` "
                            "says ({}): {}\n  help: state the fingerprint of the one that is meant: {}",
                            part_, found.size(), path_, name_, figures(*print_), listed(found), prints(found)));
        }
        return {
            {nearest},
            fmt::format("part '{}': the solid '{}' of '{}' has changed: {}, and its `fingerprint` says {}\n  help: if "
                        "it is the part, write fingerprint = \"{}\"",
                        part_, name_, path_, figures(solids_[nearest].fingerprint), figures(*print_),
                        text_of(solids_[nearest].fingerprint))};
    }

    ChosenSolids by_name(const Indices& found) const
    {
        if (found.size() == 1) {
            return {found, {}};
        }
        if (name_.empty()) {
            throw InputError(
                fmt::format("part '{}': '{}' holds {} solids: {}\n  help: choose one by solid = \"{}\"; solid = \"*\" "
                            "makes all of them one piece; `deadpoint init --step` writes a part for each",
                            part_, path_, solids_.size(), names(found), shown(found.front())));
        }
        throw InputError(
            fmt::format("part '{}': {} solids of '{}' are called '{}': {}\n  help: which one is meant says "
                        "its fingerprint: {}",
                        part_, found.size(), path_, shown(found.front()), listed(found), prints(found)));
    }

    /// @throws InputError if another solid has the fingerprint
    void refuse_if_elsewhere() const
    {
        if (!print_) {
            return;
        }
        const auto others = where([&](const SolidIdentity& s) { return same_solid(s.fingerprint, *print_); });
        if (!others.empty()) {
            throw InputError(fmt::format("part '{}': the solid '{}' of '{}' is not the one that is meant: its "
                                         "`fingerprint` is that of '{}', {}\n  "
                                         "help: write solid = \"{}\"; or, if '{}' is meant, remove the fingerprint",
                                         part_, name_, path_, shown(others.front()),
                                         figures(solids_[others.front()].fingerprint), shown(others.front()), name_));
        }
    }

    [[noreturn]] void refuse_unknown() const
    {
        const Indices everything = where([](const SolidIdentity&) { return true; });
        std::vector<std::string> known;
        for (const std::size_t i : everything) {
            known.push_back(shown(i));
        }
        const auto others = where([&](const SolidIdentity& s) { return print_ && same_solid(s.fingerprint, *print_); });
        const std::string near = others.empty() ? closest_name(name_, known) : shown(others.front());
        throw InputError(
            fmt::format("part '{}': '{}' holds no solid '{}'; it holds {}{}", part_, path_, name_, names(everything),
                        near.empty()     ? ""
                        : others.empty() ? fmt::format("\n  help: did you mean '{}'?", near)
                                         : fmt::format("\n  help: by its fingerprint it is '{}' now", near)));
    }

    const std::string& shown(std::size_t i) const
    {
        return solids_[i].called.empty() ? solids_[i].name : solids_[i].called;
    }

    /// A text for each of the first few.
    std::string some(const Indices& which, const std::string& between,
                     const std::function<std::string(std::size_t)>& text) const
    {
        constexpr std::size_t most = 20;
        std::vector<std::string> texts;
        for (std::size_t k = 0; k < std::min(most, which.size()); ++k) {
            texts.push_back(text(which[k]));
        }
        const std::string more = which.size() > most ? fmt::format("{}and {} more", between, which.size() - most) : "";
        return fmt::format("{}{}", fmt::join(texts, between), more);
    }
    std::string names(const Indices& which) const
    {
        return some(which, ", ", [&](std::size_t i) { return shown(i); });
    }
    std::string listed(const Indices& which) const
    {
        return some(which, "; ", [&](std::size_t i) { return figures(solids_[i].fingerprint); });
    }
    std::string prints(const Indices& which) const
    {
        return some(which, ", or ", [&](std::size_t i) {
            return fmt::format("fingerprint = \"{}\"", text_of(solids_[i].fingerprint));
        });
    }

    const std::string& part_;
    const std::string& path_;
    std::string name_;
    std::optional<SolidPrint> print_;
    const std::vector<SolidIdentity>& solids_;
};

}  // namespace

SolidPrint fingerprint_of(const TopoDS_Shape& shape, double scale)
{
    const double metres = 1e-3 / scale;
    const auto in_metres = [&](const gp_Pnt& p) { return metres * Vec3{p.X(), p.Y(), p.Z()}; };
    GProp_GProps properties;
    BRepGProp::VolumeProperties(shape, properties);
    Bnd_Box box;
    BRepBndLib::AddOptimal(shape, box, false, false);
    const Vec3 low = in_metres(box.CornerMin()), high = in_metres(box.CornerMax());
    const Vec3 size = high - low;
    const double volume = std::abs(properties.Mass()) * metres * metres * metres;
    // Where faces cross, the volumes on both of their sides may cancel.
    constexpr double noise = 1e-9;
    if (!(volume > noise * size[0] * size[1] * size[2])) {
        return {0, size, 0.5 * (low + high)};
    }
    return {volume, size, in_metres(properties.CentreOfMass())};
}

bool same_solid(const SolidPrint& one, const SolidPrint& other) { return difference(one, other) <= 1; }

ChosenSolids chosen_solids(const std::string& part, const StepSource& source, const std::vector<SolidIdentity>& solids)
{
    return Choice(part, source, solids).all();
}

}  // namespace deadpoint::machine
