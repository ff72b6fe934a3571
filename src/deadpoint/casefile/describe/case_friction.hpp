#pragma once

#include "deadpoint/casefile/describe/spelling.hpp"
#include "deadpoint/exchange/laws/friction.hpp"

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

/// The laws of friction heat, as a case states them: each law has its own struct with the keys that
/// it uses.
namespace deadpoint::casefile {

/// H(T) = c0 + c1 (nu(T) / (1 mm2/s))^p, fitted to a measured or computed machine.
struct CalibratedFriction {
    FrictionKind kind = FrictionKind::rolling;  ///< how heat scales with speed and load
    double load_part = 0;                       ///< c0 [W]
    double viscous_part = 0;                    ///< c1 [W]
    double exponent = 1;                        ///< p
    double reference_speed = 0;                 ///< [rad/s]
    std::optional<double> reference_force;      ///< of the process, at which c0 holds [N]
    std::optional<double> reference_stiffness;  ///< of each crankshaft bearing, at which c0 holds [N/m]
};

/// Rolling bearings by Palmgren, with the spin of their balls.
struct PalmgrenFriction {
    BearingType bearing = BearingType::deep_groove_ball;
    OilSupply oil_supply = OilSupply::bath;
    double mean_diameter = 0;                  ///< [m]
    double static_rating = 0;                  ///< C0 [N]
    std::optional<double> contact_angle;       ///< [rad]
    std::optional<double> lubrication_factor;  ///< f0; else by type and supply
    double axial_preload = 0;                  ///< [N]
    int balls = 0;                             ///< of a row, for spin
    std::optional<double> ball_diameter;       ///< for spin [m]
    double osculation = 0.52;                  ///< groove radius over ball diameter
    double spin_friction = 0.06;
    std::optional<double> ring_expansion;  ///< given: a ring temperature difference changes the preload [1/K]
    PairArrangement arrangement = PairArrangement::back_to_back;  ///< of a pair
    double row_distance = 0;                                      ///< of a pair [m]
};

/// Rolling bearings by the model of SKF.
struct SkfFriction {
    BearingType bearing = BearingType::deep_groove_ball;
    double bore = 0;              ///< [m]
    double outside_diameter = 0;  ///< [m]
    double axial_preload = 0;     ///< [N]
};

/// Pins in bushes: Coulomb friction and, with a clearance, the shear of the oil film (Petroff).
struct PinFriction {
    double coefficient = 0;           ///< of Coulomb friction
    std::optional<double> diameter;   ///< else that of the joint's elements or interface [m]
    std::optional<double> length;     ///< else the width of the joint's elements [m]
    std::optional<double> clearance;  ///< radial [m]; none: no oil film
};

/// Guides: Coulomb friction and the shear of the oil film.
struct GuideFriction {
    double coefficient = 0;                ///< of Coulomb friction
    std::optional<double> film_thickness;  ///< [m]; none: no oil film
    std::optional<double> film_area;       ///< of a joint, all faces [m2]
};

using FrictionLaw = std::variant<CalibratedFriction, PalmgrenFriction, SkfFriction, PinFriction, GuideFriction>;

/// Friction heat of the whole press, shared by all joints that name it.
struct Friction {
    FrictionLaw law;
    std::string lubricant;
    LoadMeasure load_measure = LoadMeasure::mean;
    double scale = 1;
    std::string source;
};

/// "calibrated", "palmgren", "skf", "pin" or "guide".
std::string_view law_name(const Friction& friction);

template <>
inline constexpr auto spelling<BearingType> =
    std::array<std::string_view, 7>{"deep_groove_ball",   "angular_contact_ball", "angular_contact_ball_pair",
                                    "cylindrical_roller", "needle_roller",        "tapered_roller",
                                    "spherical_roller"};
template <>
inline constexpr auto spelling<OilSupply> = std::array<std::string_view, 3>{"mist", "bath", "jet"};
/// A case speaks of pairs only.
template <>
inline constexpr auto spelling<PairArrangement> = std::array<std::string_view, 2>{"back_to_back", "face_to_face"};
template <>
inline constexpr auto spelling<LoadMeasure> = std::array<std::string_view, 2>{"mean", "peak"};
template <>
inline constexpr auto spelling<FrictionKind> = std::array<std::string_view, 3>{"rolling", "pin", "guide"};

}  // namespace deadpoint::casefile
