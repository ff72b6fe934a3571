#pragma once

#include "deadpoint/casefile/describe/case_loads.hpp"
#include "deadpoint/core/vec.hpp"

#include <optional>
#include <string>

/// The part of a case that says how interfaces conduct and what surfaces give to the air.
namespace deadpoint::casefile {

/// mean + amplitude cos(2 pi (t - time_of_maximum) / period), t on the clock of the run.
struct DailyCourse {
    double mean = 293.15;  ///< [K]
    double amplitude = 0;  ///< [K]
    double time_of_maximum = 0;
    double period = 86400;
};

/// A constant, a table over time, or a daily course.
struct Course {
    double constant = 0;
    std::optional<Table> table;
    std::optional<DailyCourse> daily;  ///< of temperatures only
};

/// A resistance, two films, or a law with its parameters. Conductivities and elasticity are the parts' own.
struct Conductance {
    double resistance = 0;  ///< of the whole contact, 0 = none [m2 K/W]; h1 = h2 = 2 / resistance
    double side_a = 0;      ///< film to side a [W/m2/K]; both given instead of `resistance`
    double side_b = 0;
    std::string law;                           ///< "fractal", "cooper_mikic_yovanovich", "oil_film", "rolling_elements"
    std::optional<double> pressure;            ///< else the joint's mean load over its area [Pa]
    std::optional<double> hardness;            ///< of the softer side [Pa]
    std::optional<double> fluid_conductivity;  ///< of what fills the gaps [W/m/K]
    std::optional<double> gas_jump;            ///< additional gap of a rarefied gas [m]
    std::optional<double> fractal_dimension;   ///< D
    std::optional<double> fractal_roughness;   ///< G [m]
    std::optional<double> sample_length;       ///< L_u [m]
    std::optional<double> separation;          ///< z [m]
    std::optional<double> roughness;           ///< sigma, of both sides combined [m]
    std::optional<double> slope;               ///< m, of both combined
    std::optional<double> thickness;           ///< of the film [m]
    std::optional<double> clearance;           ///< radial, of a journal [m]
    std::optional<double> eccentricity;        ///< share of the clearance
    std::optional<double> loaded_elements;     ///< of a rolling bearing, a whole number
    std::optional<double> element_diameter;
    std::optional<double> pitch_diameter;
    std::optional<Vec2> inner_spot;  ///< semi-axes across and along the rolling direction [m]
    std::optional<Vec2> outer_spot;
    std::string material;  ///< of rings and elements; else that of side a
};

/// A coefficient, or a law with its lengths.
struct Film {
    std::optional<double> coefficient;  ///< [W/m2/K]
    std::string law;               ///< "vertical", "horizontal_up", "horizontal_down", "cylinder", "rotating_cylinder",
                                   ///< "rotating_disk", "moving", "enclosed", "paper", "paper_vertical" and the like
    std::optional<double> length;  ///< height, area / perimeter, or length along the motion [m]
    std::optional<double> diameter;  ///< of a cylinder or disk [m]
    std::optional<double> speed;     ///< root mean square, of what moves [m/s]
    std::optional<double> exchange;  ///< of enclosed air with the room [W/K]
    std::string constant;            ///< of the paper: "frame" or "crankshaft"
    double emissivity = 0;
    std::optional<Course> ambient;  ///< else the operation's [K]
};

}  // namespace deadpoint::casefile
