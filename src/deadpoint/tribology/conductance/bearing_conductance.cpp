#include "deadpoint/tribology/conductance/bearing_conductance.hpp"

#include "deadpoint/error.hpp"
#include "deadpoint/tribology/conductance/conductance.hpp"
#include "deadpoint/tribology/friction/hertz.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace deadpoint::tribology {
namespace {

void require_path(bool holds, const char* what, double value, const char* help)
{
    if (!holds || !std::isfinite(value))
        throw DomainError(fmt::format("conductance of a rolling bearing: {} is {}\n  help: {}", what, value, help));
}

void check(const ContactSpot& spot)
{
    for (const double semi_axis : {spot.across, spot.along})
        require_path(semi_axis > 0, "a semi-axis of a contact ellipse [m]", semi_axis,
                     "leave elements without load out of the list");
}

void check_conductivity(double conductivity)
{
    require_path(conductivity > 0, "the conductivity of ring or element [W/m/K]", conductivity,
                 "bearing steel has about 46");
}

/// One side of a contact, at rest or at speed.
double side_conductance(const ContactSpot& spot, const SolidHeat& solid, double speed)
{
    const double rest = spot_conductance(spot, solid.conductivity);
    return speed == 0 ? rest : std::hypot(rest, passing_spot_conductance(spot, solid, speed));
}

double contact_conductance(const ContactSpot& spot, const BearingPath& path)
{
    double resistance = 1 / side_conductance(spot, path.ring, path.rolling_speed) +
                        1 / side_conductance(spot, path.element, path.rolling_speed);
    if (path.film_thickness > 0)
        resistance += path.film_thickness / (path.film_conductivity * std::numbers::pi * spot.across * spot.along);
    return 1 / resistance;
}

double shell_resistance(const RingShell& ring, double conductivity)
{
    require_path(ring.width >= 0, "the width of a ring [m]", ring.width, "give zero to leave the ring out");
    if (ring.width == 0)
        return 0;
    require_path(ring.inner_diameter > 0, "the inner diameter of a ring [m]", ring.inner_diameter,
                 "give a positive one");
    require_path(ring.outer_diameter > ring.inner_diameter, "the outer diameter of a ring [m]", ring.outer_diameter,
                 "it must exceed the inner one");
    return std::log(ring.outer_diameter / ring.inner_diameter) / (2 * std::numbers::pi * conductivity * ring.width);
}

void check_path(const BearingPath& path)
{
    require_path(!path.elements.empty(), "the number of loaded elements", 0,
                 "give the preload, or the conductance as a value");
    require_path(path.element_diameter > 0, "the diameter of the elements [m]", path.element_diameter,
                 "give the ball's or roller's diameter");
    require_path(path.film_thickness >= 0, "the lubricant film [m]", path.film_thickness, "give zero or more");
    require_path(path.film_thickness == 0 || path.film_conductivity > 0, "the conductivity of the lubricant [W/m/K]",
                 path.film_conductivity, "oil has about 0.14");
}

}  // namespace

ContactConductance BearingConductance::per_area(double area) const
{
    require_path(area > 0, "the area [m2]", area, "give the area of the seat or raceway");
    return {total / area, in_range, notes};
}

double spot_conductance(const ContactSpot& spot, double conductivity)
{
    check(spot);
    check_conductivity(conductivity);
    const double a = std::max(spot.across, spot.along);
    const double ratio = std::min(spot.across, spot.along) / a;
    return 2 * std::numbers::pi * conductivity * a / elliptic_integrals(ratio).first;
}

double passing_spot_conductance(const ContactSpot& spot, const SolidHeat& solid, double speed)
{
    check(spot);
    check_conductivity(solid.conductivity);
    require_path(solid.density > 0, "the density of ring or element [kg/m3]", solid.density, "steel has 7850");
    require_path(solid.heat_capacity > 0, "the heat capacity of ring or element [J/kg/K]", solid.heat_capacity,
                 "steel has 460");
    require_path(true, "the rolling speed [m/s]", speed, "check the bearing's speed");
    static const double shape = std::sqrt(std::numbers::pi) * std::tgamma(1.25) / std::tgamma(1.75);
    const double effusivity_squared = solid.conductivity * solid.density * solid.heat_capacity;
    return 2 * shape * spot.across *
           std::sqrt(2 * spot.along * effusivity_squared * std::abs(speed) / std::numbers::pi);
}

BearingConductance bearing_conductance(const BearingPath& path)
{
    check_path(path);
    double inner = 0;
    double outer = 0;
    double longest = 0;
    for (const auto& element : path.elements) {
        inner += contact_conductance(element.inner, path);
        outer += contact_conductance(element.outer, path);
        longest = std::max({longest, 2 * element.inner.along, 2 * element.outer.along});
    }
    BearingConductance result;
    result.inner = 1 / (shell_resistance(path.inner_ring, path.ring.conductivity) + 1 / inner);
    result.outer = 1 / (shell_resistance(path.outer_ring, path.ring.conductivity) + 1 / outer);
    result.total = 1 / (1 / result.inner + 1 / result.outer);
    if (longest > 0.2 * path.element_diameter) {
        result.in_range = false;
        result.notes.push_back(fmt::format("a contact {:.3g} m long on elements of {:.3g} m: the constriction of a "
                                           "half-space holds up to a fifth of the diameter",
                                           longest, path.element_diameter));
    }
    return result;
}

}  // namespace deadpoint::tribology
