#pragma once

#include "deadpoint/exchange/heat.hpp"
#include "deadpoint/heat/balance.hpp"

#include <vector>

namespace deadpoint::heat {

struct HeatBalance;
struct HeatGeometry;

inline constexpr double stefan_boltzmann = 5.670374419e-8;  ///< [W/m2/K4]

/// True if the convection coefficient depends on the temperature of its surface, or the surface
/// radiates.
inline bool follows_temperature(const SurfaceCondition& c)
{
    return c.kind == SurfaceCondition::Kind::film && (!c.laws.empty() || c.emissivity > 0);
}

/// Heat that a surface gives off by convection and radiation [W/m2]. Temperatures in kelvin.
double film_flux(const LawValue& film, double emissivity, double surface, double surroundings);
/// Its slope by the surface's temperature [W/m2/K], never negative: a coefficient that falls with
/// temperature would make the matrix indefinite.
double film_slope(const LawValue& film, double emissivity, double surface, double surroundings);

/// A surface whose coefficient depends on temperature, at one time.
struct FilmAt {
    std::size_t surface = 0;  ///< index into HeatProblem::surfaces
    FilmLaw law;
    double emissivity = 0;
    double surroundings = 0;  ///< [K]
};

/// Heat that such surfaces give off.
struct FilmHeat {
    std::vector<double> lost;         ///< per surface condition, all of it [W]
    std::vector<double> to_surfaces;  ///< part of it that other surfaces of its radiant room receive [W]
    std::vector<double> untested;     ///< area where the law is out of range [m2]
};

/// Heat that surfaces exchange with the room, with enclosed air and by prescribed flux.
class FilmBalance {
public:
    FilmBalance(const HeatProblem& problem, const HeatGeometry& geometry);

    void enter(const HeatSegment& segment) { segment_ = &segment; }
    /// Sets the times of the step, for the courses.
    void set_step(const StepTimes& step) { step_ = step; }
    /// Functionals that evaluate() reads.
    [[nodiscard]] const std::vector<std::size_t>& needed() const { return needed_; }
    /// True if some coefficient depends on the temperature of its surface.
    [[nodiscard]] bool some_follow() const { return some_follow_; }

    /// Heat of a surface of prescribed flux, into the part [W/m2].
    [[nodiscard]] double flux(std::size_t surface, double time) const;
    /// Temperature that a surface faces [K]. @param air  of the enclosures [K]
    [[nodiscard]] double surroundings(std::size_t surface, double time, const std::vector<double>& air) const;
    /// Convection of a surface in the present segment.
    [[nodiscard]] FilmLaw law(std::size_t surface, double surroundings) const;
    /// Surfaces whose coefficient depends on temperature, of one enclosure, or all with -1.
    [[nodiscard]] std::vector<FilmAt> following(double time, const std::vector<double>& air, int enclosure = -1) const;
    /// Adds constant convection coefficients and fluxes to a balance and to the watts by
    /// functional.
    void evaluate(const std::vector<double>& values, double time, const std::vector<double>& air, HeatBalance& balance,
                  std::vector<double>& watts) const;
    /// Adds the heat of the other surfaces to a balance.
    void book(const FilmHeat& heat, HeatBalance& balance) const;

private:
    double& taker(HeatBalance& balance, std::size_t surface) const;

    const HeatProblem* problem_;
    const HeatGeometry* geometry_;
    const HeatSegment* segment_ = nullptr;
    StepTimes step_;
    std::vector<std::size_t> needed_;
    bool some_follow_ = false;
};

}  // namespace deadpoint::heat
