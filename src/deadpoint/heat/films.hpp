#pragma once

#include "deadpoint/exchange/heat.hpp"
#include "deadpoint/heat/balance.hpp"
#include "deadpoint/heat/functionals.hpp"

#include <vector>

namespace deadpoint::heat {

inline constexpr double stefan_boltzmann = 5.670374419e-8;  ///< [W/m2/K4]

/// Whether a film's coefficient depends on the temperature of its surface.
inline bool follows_temperature(const SurfaceCondition& c)
{
    return c.kind == SurfaceCondition::Kind::film && (!c.laws.empty() || c.emissivity > 0);
}

/// Heat that a surface gives off by a film and by radiation [W/m2]. Temperatures in kelvin.
double film_flux(const LawValue& film, double emissivity, double surface, double surroundings);
/// Its slope by the surface's temperature [W/m2/K], never negative: a film that weakens as it warms would cost a
/// matrix its definiteness.
double film_slope(const LawValue& film, double emissivity, double surface, double surroundings);

/// A film that follows the temperature, at one time.
struct FilmAt {
    std::size_t surface = 0;  ///< index into HeatProblem::surfaces
    FilmLaw law;
    double emissivity = 0;
    double surroundings = 0;  ///< [K]
};

/// What such films give off.
struct FilmHeat {
    std::vector<double> lost;         ///< per surface condition, all of it [W]
    std::vector<double> to_surfaces;  ///< of that what other surfaces of its radiant room receive [W]
    std::vector<double> untested;     ///< area where the law is out of range [m2]
};

/// What surfaces exchange with the room, with enclosed air and by prescribed flux.
class FilmBalance {
public:
    FilmBalance(const HeatProblem& problem, const HeatGeometry& geometry);

    void enter(const HeatSegment& segment) { segment_ = &segment; }
    /// Functionals that evaluate() reads.
    [[nodiscard]] const std::vector<std::size_t>& needed() const { return needed_; }
    /// Some film follows the temperature of its surface.
    [[nodiscard]] bool some_follow() const { return some_follow_; }

    /// Temperature that a surface faces [K]. @param air  of the enclosures [K]
    [[nodiscard]] double surroundings(std::size_t surface, double time, const std::vector<double>& air) const;
    /// Convection of a surface in the present segment.
    [[nodiscard]] FilmLaw law(std::size_t surface, double surroundings) const;
    /// Films that follow the temperature; of one enclosure, or of all where that is -1.
    [[nodiscard]] std::vector<FilmAt> following(double time, const std::vector<double>& air, int enclosure = -1) const;
    /// Adds films of constant coefficient and fluxes to a balance and to the watts by functional.
    void evaluate(const std::vector<double>& values, double time, const std::vector<double>& air, HeatBalance& balance,
                  std::vector<double>& watts) const;
    /// Adds what the other films give off to a balance.
    void book(const FilmHeat& heat, HeatBalance& balance) const;

private:
    double& taker(HeatBalance& balance, std::size_t surface) const;

    const HeatProblem* problem_;
    const HeatGeometry* geometry_;
    const HeatSegment* segment_ = nullptr;
    std::vector<std::size_t> needed_;
    bool some_follow_ = false;
};

}  // namespace deadpoint::heat
