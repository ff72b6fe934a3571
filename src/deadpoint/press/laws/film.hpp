#pragma once

#include "deadpoint/exchange/laws/speed_growth.hpp"
#include "deadpoint/surroundings/film.hpp"

#include <optional>
#include <string>

namespace deadpoint::casefile {
struct Film;
}
namespace deadpoint::press {
struct LoadsResult;
}

namespace deadpoint {
struct Machine;
struct MeshSurface;
}  // namespace deadpoint

/// Convection of the surfaces of a case.
namespace deadpoint::press {

/// The convection of one surface, without radiation.
struct SurfaceFilm {
    std::string surface;
    std::string law;                      ///< "given" where the case states the coefficient
    std::optional<double> constant;       ///< a stated coefficient [W/m2/K]
    SpeedGrowth growth;                   ///< of the stated coefficient with the speed of the crank
    surroundings::AirSurface air;         ///< without speed
    bool as_printed = false;              ///< by the paper's correlations and its Table 7
    double speed_per_turn = 0;            ///< speed of the surface divided by that of the crank [- or m]
    std::optional<double> running_speed;  ///< given: the speed whenever the press runs [m/s]
    double area = 0;                      ///< of the modelled half [m2]
    std::optional<double> exchange;       ///< of enclosed air, of the modelled half [W/K]

    /// The speed in the law [rad/s or m/s] at a speed of the crank [rad/s].
    [[nodiscard]] double speed_at(double crank_speed) const;
    /// The law at a speed of the crank; DomainError as surroundings::film_law() when called with an ambient.
    [[nodiscard]] FilmLawAt law_at(double crank_speed) const;
};

/// Translates the `film` of a surface.
///
/// Lengths that the case leaves out: the height of a surface on a single part (walls, what moves,
/// enclosed surfaces), area over perimeter of a single horizontal plane, the diameter of a single
/// cylinder, and of the cylinder around a disk. A rotating surface turns with the crank. A moving
/// one has the root mean square speed of its faces over the turn by the loads, in proportion to the
/// speed of the crank; a stated `speed` takes precedence.
///
/// @param loads  for the speed of moving surfaces that state none; may be null
/// @throws InputError if a length is neither given nor clear from the geometry, or a speed neither given nor computed
SurfaceFilm surface_film(const casefile::Film& film, const Machine& machine, const std::string& surface,
                         const LoadsResult* loads);

/// Root mean square speed of a surface's faces over a turn, at the speed of the loads [m/s].
/// @throws InputError if the surface lies on several bodies, or on one that the linkage does not move
double rms_speed(const Machine& machine, const MeshSurface& surface, const LoadsResult& loads);

}  // namespace deadpoint::press
