#pragma once

#include <string>
#include <vector>

/// Heat conduction from ring to ring of a rolling bearing through its elements.
namespace deadpoint::tribology {

struct ContactConductance;

/// Contact ellipse of one element on one raceway.
struct ContactSpot {
    double across = 0;  ///< semi-axis across the direction of rolling [m]; of a roller, half its length
    double along = 0;   ///< semi-axis along it [m]
};

/// The two contacts of one loaded element; elements without load are left out.
struct LoadedElement {
    ContactSpot inner;
    ContactSpot outer;
};

struct SolidHeat {
    double conductivity = 0;   ///< [W/m/K]
    double density = 0;        ///< [kg/m3]; like the heat capacity, only read at speed
    double heat_capacity = 0;  ///< [J/kg/K]
};

/// A ring as a cylindrical shell between its seat and its raceway; width 0: not part of the path.
struct RingShell {
    double inner_diameter = 0;  ///< [m]
    double outer_diameter = 0;  ///< [m]
    double width = 0;           ///< [m]
};

struct BearingPath {
    std::vector<LoadedElement> elements;
    double element_diameter = 0;  ///< [m]
    SolidHeat element;
    SolidHeat ring;
    RingShell inner_ring;
    RingShell outer_ring;
    double rolling_speed = 0;      ///< of the spots over both surfaces, any sign [m/s]; 0: a bearing at rest
    double film_thickness = 0;     ///< lubricant in the contacts [m]; 0: none
    double film_conductivity = 0;  ///< of the lubricant [W/m/K]
};

/// Conductances of one bearing [W/K].
struct BearingConductance {
    double inner = 0;  ///< seat of the inner ring to the elements
    double outer = 0;  ///< elements to the seat of the outer ring
    double total = 0;  ///< seat to seat
    bool in_range = true;
    std::vector<std::string> notes;

    /// Seat to seat, referred to an area. @throws DomainError if the area is not positive
    [[nodiscard]] ContactConductance per_area(double area) const;
};

/// Conductance of one side of a contact at rest, from an elliptical spot of one temperature into a half-space:
///
///   G = 2 pi k a / K(e), e^2 = 1 - (b/a)^2, a >= b,   4 k a for a circle
///
/// with K the complete elliptic integral of the first kind (Carslaw and Jaeger, sec. 8.2; Yovanovich). With
/// 2 a the length of a roller about as long as thick it equals the plane solution of the roller,
/// ln(2 d / b) / (pi k L) per contact.
/// @throws DomainError if a semi-axis or the conductivity is not positive
double spot_conductance(const ContactSpot& spot, double conductivity);

/// Conductance of one side of a contact that moves fast over the solid: a strip of the surface is
/// at the spot's temperature while the spot passes, 2 k dT / sqrt(pi alpha t) on the mean of the
/// time t (Carslaw and Jaeger, sec. 2.5), summed over the ellipse with semi-axes a across and b
/// along the motion:
///
///   G = 2 B a sqrt(2 b k rho c v / pi),   B = sqrt(pi) Gamma(5/4) / Gamma(7/4) = 1.748
///
/// @throws DomainError if a semi-axis or a property is not positive, or the speed is not finite
double passing_spot_conductance(const ContactSpot& spot, const SolidHeat& solid, double speed);

/// A bearing as series of inner ring, inner contacts, outer contacts and outer ring. Contacts of all loaded elements
/// act in parallel and the elements share one temperature, since each passes every load within one turn of the cage.
///
/// A contact consists of the ring's side, the lubricant t / (k_f pi a b) and the element's side in
/// series; a side conducts sqrt(G_rest^2 + G_passing^2): both limits are exact, the exponent
/// between them is an assumption (such blends are usual for moving heat sources, Muzychka and
/// Yovanovich 2001). The rings conduct as shells, ln(D/d) / (2 pi k w). At 1 m/s a moving spot
/// conducts several times more than a spot at rest.
///
/// Left out: oil and air beside the contacts and the cage (which conduct in addition), the finite
/// size of the elements, spreading from the track into the rings (which resists in addition).
/// Flagged if a spot's length along the motion exceeds a fifth of the element's diameter, since the
/// solids are then not half-spaces.
/// @throws DomainError if no element is loaded or a number is invalid
BearingConductance bearing_conductance(const BearingPath& path);

}  // namespace deadpoint::tribology
