#pragma once

#include <optional>
#include <string>

/// The laws of friction heat, as a case states them.
namespace deadpoint::casefile {

/// Friction heat of the whole press, shared by all joints that name it: calibrated, H(T) = c0 + c1 (nu(T) / (1
/// mm2/s))^p, or from sizes, oil and the loads over the turn.
struct Friction {
    std::string law;   ///< "calibrated", "palmgren", "skf", "pin", "guide"
    std::string kind;  ///< calibrated: "rolling", "pin", "guide": how heat scales with speed and load
    std::string lubricant;
    std::string load_measure = "mean";          ///< or "peak"
    double load_part = 0;                       ///< c0 [W]
    double viscous_part = 0;                    ///< c1 [W]
    double exponent = 1;                        ///< p
    double reference_speed = 0;                 ///< [rad/s]
    std::optional<double> reference_force;      ///< of the process, at which c0 holds [N]
    std::optional<double> reference_stiffness;  ///< of each crankshaft bearing, at which c0 holds [N/m]
    double scale = 1;
    std::string source;

    // rolling bearings
    std::string bearing;  ///< type
    std::string oil_supply = "bath";
    std::optional<double> lubrication_factor;  ///< f0; else by type and supply
    std::optional<double> mean_diameter;       ///< [m]
    std::optional<double> static_rating;       ///< C0 [N]
    std::optional<double> contact_angle;       ///< [rad]
    double axial_preload = 0;                  ///< [N]
    std::optional<double> bore;                ///< SKF [m]
    std::optional<double> outside_diameter;    ///< SKF [m]
    int balls = 0;                             ///< of a row, for spin
    std::optional<double> ball_diameter;       ///< for spin [m]
    double osculation = 0.52;                  ///< groove radius over ball diameter
    double spin_friction = 0.06;
    std::optional<double> ring_expansion;      ///< given: a ring temperature difference changes the preload [1/K]
    std::string arrangement = "back_to_back";  ///< of a pair, or "face_to_face"
    double row_distance = 0;                   ///< of a pair [m]

    // pins and guides
    std::optional<double> coefficient;     ///< of Coulomb friction
    std::optional<double> diameter;        ///< of a pin; else that of the joint's elements or interface [m]
    std::optional<double> length;          ///< of a pin; else the width of the joint's elements [m]
    std::optional<double> clearance;       ///< radial [m]; none: no film
    std::optional<double> film_thickness;  ///< of a guide [m]; none: no film
    std::optional<double> film_area;       ///< of a joint's guide, all faces [m2]
};

}  // namespace deadpoint::casefile
