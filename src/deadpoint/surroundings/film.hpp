#pragma once

#include "deadpoint/exchange/laws/laws.hpp"
#include "deadpoint/surroundings/convection.hpp"

#include <span>

/// Convection coefficients of a machine's surfaces as curves of the surface temperature.
namespace deadpoint::surroundings {

enum class NaturalFlow { none, vertical, facing_up, facing_down, horizontal_cylinder };
enum class ForcedFlow { none, rotating_cylinder, rotating_disk, moving_plate };

/// A surface of the machine in air.
struct AirSurface {
    NaturalFlow natural = NaturalFlow::vertical;
    double natural_length = 0;  ///< height, or area / perimeter of a horizontal plate, or diameter [m]; unused if none
    ForcedFlow forced = ForcedFlow::none;
    double forced_length = 0;  ///< diameter of a cylinder or disk, or length of a plate along its motion [m]
    double speed = 0;          ///< of rotation [rad/s], or root mean square over the turn of a moving plate [m/s]
    double emissivity = 0;     ///< 0..1; for radiation to the room
    VerticalLaw vertical_law = VerticalLaw::churchill_chu;
    DownLaw down_law = DownLaw::quarter;
    RotatingLaw rotating_law = RotatingLaw::becker;
};

/// Below this difference to the ambient [K] natural convection is smoothed.
inline constexpr double smoothed_difference = 0.1;

/// Heat transfer coefficient of a surface in air at one ambient temperature, convection plus
/// radiation:
///
///   h(T_s) = (h_F^n + h_N^n)^(1/n) + h_radiation
///
/// with the correlations of convection.hpp at the film temperature (T_s + T_a) / 2, n = 4 on
/// cylinders, 3.5 on horizontal plates and 3 elsewhere, and radiation_coefficient() to walls at the
/// ambient temperature. A plate facing up that is colder than the air uses the law of a warm plate
/// facing down, and the reverse. Kays and Bjorklund's law contains natural convection, so none is
/// added to it.
///
/// Natural convection vanishes with an infinite slope at T_s = T_a. Therefore |T_s - T_a| enters
/// exactly above d = 0.1 K, and below as d (3/8 + 3/4 x^2 - x^4/8), x = (T_s - T_a) / d: value,
/// slope and curvature are continuous, and the coefficient at equal temperatures is positive. The
/// heat flux differs by less than 0.01 W/m2.
///
/// The slope is exact (differentiated with the formula). Flagged as out of range if a correlation
/// or the air is; a Rayleigh number below the tested range is not flagged within 1 K of the
/// ambient, where no heat depends on it. Left out: neighbours of the surface, draughts of the
/// workshop (a moving_plate with their speed can stand for one).
///
/// @param ambient  temperature of air and walls [K]
/// @throws DomainError here if a needed length is not positive, a number is not finite or the emissivity leaves 0..1;
///         from the law where the film temperature leaves 150..1000 K
FilmLaw film_law(const AirSurface& surface, double ambient);

/// The same as data: the correlations by name, lengths [m], speed [rad/s or m/s], emissivity.
LawFormula formula_of(const AirSurface& surface);

/// The natural flow on a flat face by its direction: facing up or down if the normal is within 45 degrees of the
/// vertical, else vertical.
/// @param up  component of the outward unit normal along the upward vertical, -1..1
/// @throws DomainError outside -1..1
NaturalFlow natural_flow_of_face(double up);

/// Convection coefficient of a surface around an enclosed volume whose air exchanges G [W/K] with
/// the ambient through openings and walls:
///
///   h = h_open / (1 + h_open A / G)
///
/// the surface coefficient and the exchange in series, exact for one surface, or all A at one
/// temperature, with h_open taken on the difference to the ambient (too high by about a third of
/// the share of the drop that falls on G). Give h_open without radiation, since enclosed surfaces
/// do not radiate to the room. G to infinity is an open surface, G = 0 an insulated one.
/// @param area      A > 0, of all surfaces around the volume [m2]
/// @param exchange  G >= 0, e.g. density times c_p times air flow plus walls [W/K]
/// @throws DomainError outside these ranges
FilmLaw enclosed_film(FilmLaw open, double area, double exchange);

}  // namespace deadpoint::surroundings
