#pragma once

#include "deadpoint/surroundings/film.hpp"

#include <span>

/// Convection as printed by Zheng et al. 2018: available by name to compare with that paper, not as
/// a default. Errors of the paper, relative to dry air and the correlations of convection.hpp:
/// - Table 7 lists as kinematic viscosity the dynamic one (18.1, 18.6, 19.1 at 20..40 C, in 1e-6 Pa s) and the thermal
///   diffusivity (25.7, 27.2, 28.6 at 50..70 C, in 1e-6 m2/s): 20, 16, 13, 43, 43 and 43 % above the true values. Its
///   unit "mm2/s" beside "x 1e-6" is read here as m2/s.
/// - Eq. 31 has g alpha dT L^3 / nu^2 with alpha the conductivity column of Table 7 (0.026..0.030) instead of the
///   expansion 1/T (0.0029..0.0034), 7.6 to 10 times too large. With the printed viscosities the Grashof number comes
///   out 4.5 to 6.7 times too large and the coefficient of a warm surface 1.5 to 2.1 times.
/// - Eq. 28 and 29 with Table 7 give a rotating cylinder 8 to 11 % too little at 20..40 C, 21 % at 50..70 C.
/// - The constants 5 and 9.7 W/m2/K do not depend on speed or temperature, and radiation is left out, which on painted
///   surfaces is about twice the natural convection. 9.7 on the crankshaft is forced convection and grows as n^(2/3).
namespace deadpoint::surroundings {

/// The paper's convection coefficients [W/m2/K].
inline constexpr double paper_frame_coefficient = 5;
inline constexpr double paper_crankshaft_coefficient = 9.7;

/// A row of the paper's Table 7.
struct PaperAir {
    double temperature = 0;          ///< [K]
    double conductivity = 0;         ///< [W/m/K]
    double kinematic_viscosity = 0;  ///< as printed, read as [m2/s]
};

/// Table 7 as printed, 20..70 C.
std::span<const PaperAir> paper_air_table();

/// Table 7, linear between its rows; beyond them the end rows.
PaperAir paper_air(double temperature);

/// One coefficient as the paper computes it and from true air properties.
struct FilmComparison {
    double paper = 0;            ///< [W/m2/K]
    double corrected = 0;        ///< [W/m2/K], without radiation
    bool paper_in_range = true;  ///< false outside the scope printed in Table 6 or with Eq. 29, or outside Table 7
    bool corrected_in_range = true;

    [[nodiscard]] double ratio() const { return paper / corrected; }
};

/// Natural convection of a flat surface by Eq. 28, 30, 31 and Tables 6 and 7 with Pr = 0.707, and by film_law().
///
/// Table 6: vertical 0.59 Ra^(1/4) to 1e9, then 0.13 Ra^(1/3); facing up 0.54 Ra^(1/4) to 2e7, then 0.14 Ra^(1/3);
/// facing down 0.27 Ra^(1/4). Below the scope of a row its laminar law is used and flagged.
/// @param flow    vertical, facing_up or facing_down (of a surface warmer than the air)
/// @param length  height, or area / perimeter [m]
/// @throws DomainError for another flow, or as film_law()
FilmComparison compare_natural_film(NaturalFlow flow, double length, double surface_temperature, double ambient);

/// A rotating cylinder by Eq. 28, 29 and Table 7 with Pr = 0.707, and by Becker's law with true air, without natural
/// convection. The "flow velocity of ambient air" in the paper's Reynolds number is read as the surface speed.
/// @param speed     [rad/s], any sign but zero
/// @param diameter  [m]
/// @param film      film temperature [K]
/// @throws DomainError if a number has no meaning
FilmComparison compare_rotating_film(double speed, double diameter, double film);

/// The paper's coefficient of a surface over its temperature at an ambient [K]: compare_rotating_film where it turns,
/// else compare_natural_film, a cylinder at rest as a wall of the height of its diameter. A surface colder than the air
/// counts as one as much warmer. Slopes by differences over 0.01 K.
/// @throws DomainError as the two
FilmLaw paper_film_law(const AirSurface& surface, double ambient);

}  // namespace deadpoint::surroundings
