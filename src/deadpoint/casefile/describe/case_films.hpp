#pragma once

#include "deadpoint/casefile/describe/case_loads.hpp"
#include "deadpoint/casefile/describe/spelling.hpp"
#include "deadpoint/core/vec.hpp"
#include "deadpoint/exchange/laws/speed_growth.hpp"

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

/// The part of a case about contact conductances of interfaces and convection of surfaces.
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

/// A known resistance of the whole contact, split equally between the sides.
struct ContactResistance {
    double value = 0;  ///< 0: no conduction [m2 K/W]
};

/// A known conductance of the whole contact, split equally between the sides.
struct WholeConductance {
    double value = 0;  ///< 0: no conduction [W/m2/K]
};

/// A known conductance to each side.
struct SideFilms {
    double a = 0;  ///< [W/m2/K]
    double b = 0;  ///< [W/m2/K]
};

/// Pressure, hardness and gap fluid of two rough surfaces.
struct PressedSurfaces {
    std::optional<double> pressure;  ///< else the joint's mean load over its area [Pa]
    double hardness = 0;             ///< of the softer side [Pa]
    double fluid_conductivity = 0;   ///< [W/m/K]
    std::optional<double> gas_jump;  ///< additional gap of a rarefied gas [m]
};

struct FractalContact {
    PressedSurfaces surfaces;
    double fractal_dimension = 0;  ///< D
    double fractal_roughness = 0;  ///< G [m]
    double sample_length = 0;      ///< L_u [m]
    double separation = 0;         ///< z [m]
};

/// Cooper, Mikic and Yovanovich.
struct RoughContact {
    PressedSurfaces surfaces;
    double roughness = 0;         ///< sigma, of both sides combined [m]
    std::optional<double> slope;  ///< m, of both combined; else by the roughness
};

struct OilFilm {
    double fluid_conductivity = 0;       ///< [W/m/K]
    std::optional<double> gas_jump;      ///< additional gap of a rarefied gas [m]
    std::optional<double> thickness;     ///< [m]; else by clearance and eccentricity
    std::optional<double> clearance;     ///< radial, of a journal [m]
    std::optional<double> eccentricity;  ///< share of the clearance
};

/// Conductance from ring to ring through balls or rollers.
struct RollingElements {
    std::optional<double> fluid_conductivity;  ///< of the lubricant in the contacts [W/m/K]
    std::optional<double> thickness;           ///< of that lubricant [m]
    double loaded_elements = 0;                ///< a whole number
    double element_diameter = 0;               ///< [m]
    std::optional<double> pitch_diameter;      ///< [m]; none: the elements stand still
    Vec2 inner_spot{};                         ///< semi-axes across and along the rolling direction [m]
    Vec2 outer_spot{};
    std::string material;  ///< of rings and elements; else that of side a
};

/// Known values, or a law with its parameters. Conductivity and elasticity are those of the parts.
using Conductance = std::variant<ContactResistance, SideFilms, FractalContact, RoughContact, OilFilm, RollingElements,
                                 WholeConductance>;

/// Stated to let no heat pass.
bool is_open(const Conductance& conductance);
/// Empty for known values.
std::string_view law_name(const Conductance& conductance);

/// A known coefficient [W/m2/K].
struct FilmCoefficient {
    std::optional<double> value;  ///< none only before the case is read
};

/// A flat surface at rest.
struct PlateFilm {
    enum class Facing { sideways, up, down };
    Facing facing = Facing::sideways;
    bool as_printed = false;       ///< by the paper's correlation with its Table 7, errors included
    std::optional<double> length;  ///< height, or area over perimeter; else from the geometry [m]

    [[nodiscard]] bool is_same_law(const PlateFilm& other) const
    {
        return facing == other.facing && as_printed == other.as_printed;
    }
};

/// A cylinder or a disk.
struct RoundFilm {
    enum class Form { cylinder, rotating_cylinder, rotating_disk };
    Form form = Form::cylinder;
    bool as_printed = false;
    std::optional<double> diameter;  ///< else from the geometry [m]

    [[nodiscard]] bool is_same_law(const RoundFilm& other) const
    {
        return form == other.form && as_printed == other.as_printed;
    }
};

/// A wall that moves along itself.
struct MovingFilm {
    std::optional<double> length;  ///< along the motion; else from the geometry [m]
    std::optional<double> speed;   ///< root mean square; else from the loads [m/s]
};

/// A wall around air that exchanges little heat with the room.
struct EnclosedFilm {
    std::optional<double> length;  ///< height; else from the geometry [m]
    double exchange = 0;           ///< of the air with the room [W/K]
};

/// One of the paper's two constants.
struct PaperFilm {
    enum class Of { frame, crankshaft };
    Of of = Of::frame;
};

using FilmLaw = std::variant<FilmCoefficient, PlateFilm, RoundFilm, MovingFilm, EnclosedFilm, PaperFilm>;

/// Convection and radiation of a surface.
struct Film {
    FilmLaw law;
    std::optional<SpeedGrowth> with_speed;  ///< of a known coefficient
    double emissivity = 0;
    std::optional<Course> ambient;  ///< else the operation's [K]
};

/// Empty for a known coefficient.
std::string_view law_name(const Film& film);

template <>
inline constexpr auto spelling<PaperFilm::Of> = std::array<std::string_view, 2>{"frame", "crankshaft"};

}  // namespace deadpoint::casefile
