#pragma once

#include "deadpoint/casefile/describe/spelling.hpp"
#include "deadpoint/core/vec.hpp"

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// The part of a case about loads, besides bodies and joints.
namespace deadpoint::casefile {

/// A quantity over another one, linear between the points, constant beyond them.
struct Table {
    std::vector<double> x;
    std::vector<double> y;
};

/// Stiffness or damping between two places of the plane across the shaft, {{xx, xy}, {yx, yy}}.
using Matrix2 = std::array<std::array<double, 2>, 2>;

struct Mechanism {
    std::string slide_body;                ///< that carries the tool; empty: that of the dimension chain
    std::optional<Vec2> stroke_direction;  ///< of the slide away from the table; else along its guide, upwards
    int positions = 720;
    Table speed;  ///< over that of the operation, over the angle past bottom dead point [- over rad]; empty: steady
};

struct Crankshaft {
    /// A beam on springs, or bearing loads by statics alone.
    enum class Model { flexible, rigid };
    struct Section {
        double length = 0;
        double diameter = 0;
        double bore = 0;
        std::optional<double> density;
        std::optional<double> shear_factor;  ///< else that of the crankshaft
    };
    struct Disk {
        double position = 0;
        double mass = 0;
        double polar_inertia = 0;
        double diametral_inertia = 0;
        double eccentricity = 0;  ///< of its centre of mass [m]
        double eccentricity_angle = 0;
    };
    struct Bearing {
        std::string name;
        std::string seat;
        double position = 0;
        Matrix2 stiffness{};
        Matrix2 damping{};
        double housing_mass = 0;
        std::optional<Matrix2> support_stiffness;
        Matrix2 support_damping{};
        double hertz_exponent = 1;
        double reference_load = 0;
    };
    /// Pull of the belt that drives the shaft.
    struct Belt {
        double position = 0;
        double angle = 0;             ///< direction of the pull on the shaft [rad]
        std::optional<double> force;  ///< [N]; else power over belt speed
        double power = 0;
        double pulley_diameter = 0;
    };
    Model model = Model::flexible;
    std::string material;
    std::vector<Section> sections;
    std::vector<Disk> disks;
    std::vector<Bearing> bearings;
    double start = 0;         ///< position of the first section's end along the axis [m]
    double pin_position = 0;  ///< of the crank pin's middle [m]
    double pin_width = 0;     ///< over which the pin's load is spread [m]
    std::optional<Belt> belt;
    bool throw_unbalance = true;
    double modal_damping = 0.02;
    double shear_factor = 0.9;  ///< 0: no shear deformation
    double axial_load = 0;
    int critical_speeds = 4;  ///< number to compute
};

struct ProcessForce {
    enum class Kind { elastic, half_sine, rectangular, angle_table, travel_table, none };
    std::optional<Kind> kind;    ///< else elastic with a flexible crankshaft, else rectangular
    std::optional<double> from;  ///< crank angle [rad]; else 15 deg before bottom dead point
    std::optional<double> to;    ///< else 15 deg after it
    double stiffness = 1e9;      ///< of press and die [N/m]
    Table over_angle;            ///< share of the operation's force [- over rad]
    Table over_height;           ///< [- over m]
    bool both_ways = false;      ///< over_height holds on the way up as well
    double offset = 0;           ///< of the line of action from the slide's guided point [m]
};

template <>
inline constexpr auto spelling<Crankshaft::Model> = std::array<std::string_view, 2>{"flexible", "rigid"};
template <>
inline constexpr auto spelling<ProcessForce::Kind> =
    std::array<std::string_view, 6>{"elastic", "half_sine", "rectangular", "angle_table", "travel_table", "none"};

}  // namespace deadpoint::casefile
