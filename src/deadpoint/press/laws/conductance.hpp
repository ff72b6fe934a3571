#pragma once

#include <optional>
#include <string>
#include <vector>

namespace deadpoint::press {
struct LoadsResult;
}

namespace deadpoint {
struct Machine;
}
namespace deadpoint::casefile {
struct Case;
}

/// Contact conductances of the interfaces of a case.
namespace deadpoint::press {

/// The conductance of one interface and its source.
struct InterfaceConductance {
    std::string joint;               ///< empty: a bond
    std::string name;                ///< of the interface, or of the bonded pair
    std::string law;                 ///< "given" where the case states the value
    std::optional<double> pressure;  ///< only of laws that need it [Pa]
    bool pressure_from_loads = false;
    double area = 0;    ///< in contact, of the modelled half [m2]
    double film_a = 0;  ///< [W/m2/K]
    double film_b = 0;
    bool in_range = true;
    std::vector<std::string> notes;
    std::string path = {};  ///< of the key in the case
    /// Area of a ball joint's seat over that drawn, a factor on what is per area.
    double seat_over_drawn = 1;

    [[nodiscard]] double resistance() const { return 1 / film_a + 1 / film_b; }  ///< R'' [m2 K/W]
};

/// Conductances of all interfaces, in the order of the machine's: of joints, then of bonds with a conductance.
///
/// A law's conductance h is split equally between the sides, film_a = film_b = 2 h. If the case
/// states no contact pressure, it is the mean load of the joint over the turn divided by the area
/// of the interfaces that carry it in parallel: those of the joint with the same `seat`, `journal`
/// and `stands_still`; the others are in series. A slide's faces on either side have
/// the mean force of that side (guide_sides), preload included; without both sides, the sum of all faces. In a half
/// model, a joint that exists once has twice the modelled area. A ball joint has the area of its seat, in the pressure
/// and in the heat that passes; the films are per drawn area. Rolling elements turn with the crank at `speed`.
///
/// @param loads  for pressures that the case leaves out; may be null
/// @param speed  of the crank [rad/s]
/// @throws InputError   if a pressure is needed and neither given nor computed; DomainError from the laws, naming the
///                      interface
std::vector<InterfaceConductance> interface_conductances(const casefile::Case& input, const Machine& machine,
                                                         const LoadsResult* loads, double speed);

/// The speed of the crank for which conductances are computed: that of the first segment in which
/// the press runs, else 0 [rad/s].
double conductance_speed(const casefile::Case& input);

/// The warning about a conductance outside its law's tested range.
std::string out_of_range_text(const InterfaceConductance& conductance);

}  // namespace deadpoint::press
