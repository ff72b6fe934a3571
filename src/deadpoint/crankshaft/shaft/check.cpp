#include "deadpoint/crankshaft/shaft/check.hpp"

#include "deadpoint/core/mistakes.hpp"
#include "deadpoint/crankshaft/shaft/shaft.hpp"
#include "deadpoint/exchange/warning.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace deadpoint::crankshaft {
namespace {

constexpr double thick = 3.0;        ///< ratio of diameters beyond which a section does not bend like a beam
constexpr double heavy_share = 0.5;  ///< of a disk's mass in its section beyond which it is taken to count twice

void require(bool holds, const std::string& who, const char* what, double value)
{
    if (!holds || !std::isfinite(value))
        throw InputError(fmt::format("crankshaft, {}: {}, not {:g}", who, what, value));
}

void check_material(const Shaft& shaft)
{
    const std::string who = "material";
    require(shaft.youngs_modulus > 0, who, "Young's modulus must be positive", shaft.youngs_modulus);
    require(shaft.poissons_ratio > -1 && shaft.poissons_ratio <= 0.5, who, "Poisson's ratio must lie in -1..0.5",
            shaft.poissons_ratio);
    require(shaft.modal_damping >= 0 && shaft.modal_damping < 1, who,
            "the modal damping ratio must be at least 0 and below 1", shaft.modal_damping);
    require(true, who, "the axial load must be a number", shaft.axial_load);
    require(true, who, "the start of the shaft must be a number", shaft.start);
}

void check_section(const Section& section, const std::string& who)
{
    require(section.length > 0, who, "the length must be positive", section.length);
    require(section.diameter > 0, who, "the diameter must be positive", section.diameter);
    require(section.bore >= 0 && section.bore < section.diameter, who,
            "the bore must not be negative, and must be less than the diameter", section.bore);
    require(section.density >= 0, who, "the density must not be negative", section.density);
    require(section.shear_factor >= 0 && section.shear_factor <= 1, who, "the shear factor must lie in 0..1",
            section.shear_factor);
}

void check_sections(const Shaft& shaft, Mistakes& mistakes)
{
    if (shaft.sections.empty())
        mistakes.add("crankshaft.sections", "the crankshaft has no sections",
                     "give at least one length with its diameter");
    for (std::size_t i = 0; i < shaft.sections.size(); ++i)
        mistakes.attempt(fmt::format("crankshaft.sections.{}", i),
                         [&] { check_section(shaft.sections[i], fmt::format("section {}", i + 1)); });
}

void check_position(const Shaft& shaft, const std::string& who, double position)
{
    const double end = shaft_end(shaft);
    const double tolerance = same_place * (end - shaft.start);
    if (!(position >= shaft.start - tolerance && position <= end + tolerance))
        throw InputError(
            fmt::format("crankshaft, {}: at {:g} mm it is not on the shaft, which runs from {:g} to {:g} mm", who,
                        1e3 * position, 1e3 * shaft.start, 1e3 * end));
}

void check_disk(const Shaft& shaft, const Disk& disk, const std::string& who)
{
    check_position(shaft, who, disk.position);
    require(disk.mass >= 0, who, "the mass must not be negative", disk.mass);
    require(disk.polar_inertia >= 0, who, "the polar inertia must not be negative", disk.polar_inertia);
    require(disk.diametral_inertia >= 0, who, "the diametral inertia must not be negative", disk.diametral_inertia);
    require(disk.polar_inertia <= 2 * disk.diametral_inertia * (1 + 1e-9), who,
            "no body has a polar inertia over twice its diametral inertia; its polar inertia must be less",
            disk.polar_inertia);
    require(disk.unbalance >= 0, who, "the unbalance must not be negative", disk.unbalance);
    require(true, who, "the angle of the unbalance must be a number", disk.unbalance_angle);
}

void check_disks(const Shaft& shaft, Mistakes& mistakes)
{
    for (std::size_t i = 0; i < shaft.disks.size(); ++i)
        mistakes.attempt(fmt::format("crankshaft.disks.{}", i),
                         [&] { check_disk(shaft, shaft.disks[i], fmt::format("disk {}", i + 1)); });
    for (std::size_t i = 0; i < shaft.unbalances.size(); ++i)
        mistakes.attempt("crankshaft", [&] {
            const Unbalance& unbalance = shaft.unbalances[i];
            const std::string who = fmt::format("unbalance {}", i + 1);
            check_position(shaft, who, unbalance.position);
            require(unbalance.magnitude >= 0, who, "it must not be negative", unbalance.magnitude);
            require(true, who, "its angle must be a number", unbalance.angle);
        });
}

/// The matrix must not feed energy into a straight motion: its symmetric part has no negative eigenvalue.
void check_matrix(const std::string& who, const char* what, const Matrix2& m, bool all_directions)
{
    for (const auto& row : m)
        for (const double value : row)
            require(true, who, fmt::format("the {} must be numbers", what).c_str(), value);
    const double coupling = 0.5 * (m[0][1] + m[1][0]);
    const double mean = 0.5 * (m[0][0] + m[1][1]);
    const double lowest = mean - std::hypot(0.5 * (m[0][0] - m[1][1]), coupling);
    if (lowest < -1e-12 * std::abs(mean) || (all_directions && !(mean > 0)))
        throw InputError(fmt::format("crankshaft, {}: the {} [[{:g}, {:g}], [{:g}, {:g}]] must resist motion in every "
                                     "direction\n  help: positive values on the diagonal, larger than those beside it",
                                     who, what, m[0][0], m[0][1], m[1][0], m[1][1]));
}

void check_bearing(const Shaft& shaft, const Bearing& bearing)
{
    const std::string who = fmt::format("bearing '{}'", bearing.name);
    check_position(shaft, who, bearing.position);
    check_matrix(who, "stiffness", bearing.stiffness, true);
    check_matrix(who, "damping", bearing.damping, false);
    require(bearing.housing_mass >= 0, who, "the mass of its housing must not be negative", bearing.housing_mass);
    if (bearing.support_stiffness) {
        check_matrix(who, "support stiffness", *bearing.support_stiffness, true);
        check_matrix(who, "support damping", bearing.support_damping, false);
    }
    require(bearing.hertz_exponent >= 1 && bearing.hertz_exponent <= 3, who,
            "the exponent of the load must lie in 1..3 (10/9 for rollers, 3/2 for balls)", bearing.hertz_exponent);
    require(bearing.hertz_exponent == 1 || bearing.reference_load > 0, who,
            "stiffness that depends on load needs the positive load at which it was given", bearing.reference_load);
}

void check_bearings(const Shaft& shaft, Mistakes& mistakes)
{
    if (shaft.bearings.empty())
        return mistakes.add("crankshaft.bearings", "the crankshaft has no bearings", "give at least two");
    for (std::size_t i = 0; i < shaft.bearings.size(); ++i)
        mistakes.attempt(fmt::format("crankshaft.bearings.{}", i), [&] { check_bearing(shaft, shaft.bearings[i]); });
    const auto [first, last] =
        std::minmax_element(shaft.bearings.begin(), shaft.bearings.end(),
                            [](const Bearing& a, const Bearing& b) { return a.position < b.position; });
    if (!(last->position - first->position > same_place * (shaft_end(shaft) - shaft.start)))
        mistakes.add("crankshaft.bearings",
                     fmt::format("all bearings of the crankshaft are at {:g} mm and do not hold it straight",
                                 1e3 * first->position),
                     "give bearings at two positions at least");
}

bool has_value(const Matrix2& m) { return m[0][0] != 0 || m[1][1] != 0 || m[0][1] != 0 || m[1][0] != 0; }

/// How many times as thick as the thicker of its neighbours.
double thickness_ratio(const Shaft& shaft, std::size_t i)
{
    double neighbours = 0;
    if (i > 0)
        neighbours = shaft.sections[i - 1].diameter;
    if (i + 1 < shaft.sections.size())
        neighbours = std::max(neighbours, shaft.sections[i + 1].diameter);
    return neighbours > 0 ? shaft.sections[i].diameter / neighbours : 0;
}

void warn_of_disks(const Shaft& shaft, std::vector<Warning>& warnings)
{
    for (std::size_t d = 0; d < shaft.disks.size(); ++d) {
        const Disk& disk = shaft.disks[d];
        const double tolerance = same_place * (shaft_end(shaft) - shaft.start);
        double end = shaft.start;
        for (std::size_t i = 0; i < shaft.sections.size(); ++i) {
            const double begin = end;
            end += shaft.sections[i].length;
            const bool inside = disk.position >= begin - tolerance && disk.position <= end + tolerance;
            const double mass = section_mass(shaft.sections[i]);
            if (inside && mass > 0 && (mass > heavy_share * disk.mass || thickness_ratio(shaft, i) > thick))
                warnings.push_back(
                    {fmt::format("mass of disk {} and section {}", d + 1, i + 1),
                     fmt::format("crankshaft: disk {} ({:.4g} kg) is at section {}, which weighs {:.4g} kg itself: if "
                                 "they are the same body its mass counts twice; give the section the density 0",
                                 d + 1, disk.mass, i + 1, mass)});
        }
    }
}

}  // namespace

double shaft_end(const Shaft& shaft)
{
    double end = shaft.start;
    for (const Section& section : shaft.sections)
        end += section.length;
    return end;
}

double section_mass(const Section& section)
{
    return section.density * section.length * std::numbers::pi / 4 *
           (section.diameter * section.diameter - section.bore * section.bore);
}

void check_shaft(const Shaft& shaft)
{
    Mistakes mistakes;
    mistakes.attempt("crankshaft.material", [&] { check_material(shaft); });
    check_sections(shaft, mistakes);
    check_disks(shaft, mistakes);
    check_bearings(shaft, mistakes);
    mistakes.raise();
}

std::vector<Warning> shaft_warnings(const Shaft& shaft)
{
    check_shaft(shaft);
    std::vector<Warning> warnings;
    for (std::size_t i = 0; i < shaft.sections.size(); ++i)
        if (thickness_ratio(shaft, i) > thick)
            warnings.push_back(
                {fmt::format("thickness of section {}", i + 1),
                 fmt::format("crankshaft: section {} is {:.3g} times as thick as its thicker neighbour and "
                             "does not bend like a beam; a pulley or gear is better given as a disk",
                             i + 1, thickness_ratio(shaft, i))});
    warn_of_disks(shaft, warnings);
    if (shaft.modal_damping > 0)
        return warnings;
    const bool damped = std::any_of(shaft.bearings.begin(), shaft.bearings.end(), [](const Bearing& bearing) {
        return has_value(bearing.damping) || (bearing.support_stiffness && has_value(bearing.support_damping));
    });
    warnings.push_back({"damping of the crankshaft",
                        damped ? "crankshaft: only its bearings damp, which leaves its higher modes almost undamped; "
                                 "give a modal damping ratio (2 % is common)"
                               : "crankshaft: nothing damps it, so its response to the loads of a turn is unbounded at "
                                 "resonance; give a modal damping ratio (2 % is common)"});
    return warnings;
}

}  // namespace deadpoint::crankshaft
