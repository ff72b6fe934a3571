#pragma once

#include "deadpoint/reduce/online/box.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace deadpoint {
struct HeatProblem;
struct HeatSource;
struct Machine;
struct SurfaceCondition;
}  // namespace deadpoint

/// The coefficients that are free in a reduced model of a case.
namespace deadpoint::twin {

struct SplitProblem;

/// A range of values.
struct Span {
    double from = 0, to = 0;
};

/// Ranges over which coefficients are free: factors on those of the case, and differences. A range from 1 to 1 (a
/// difference from 0 to 0) holds them.
struct FreeRanges {
    Span film{0.2, 5};
    Span side{0.1, 10};
    Span oil{0, 5};
    Span heat{0.3, 3};
    Span speed{1, 1};  ///< of the whole operation
    Span force{1, 1};
    Span oil_temperature{-10, 20};  ///< [K]
    Span ambient{-10, 10};          ///< [K]
    bool by_piece = true;  ///< films per part and conductances per side; else films per surface, joints as a whole
};

/// Oil coefficient to which the range of a joint without oil refers [W/m2/K].
inline constexpr double assumed_oil = 500;

/// The box of a problem. Held coefficients are in it too, with a range of no width. Films that follow the temperature
/// count by nominal_film() of the first segment.
/// @param start   temperature at the start [K]
/// @param others  the case at other points of operation, whose films, conductances and oil the box holds too
reduce::Box free_coefficients(const SplitProblem& split, const Machine& machine, const FreeRanges& ranges, double start,
                              const std::vector<SplitProblem>& others = {});

/// The box, as wide as the friction heat of all running segments and of other points of operation is: for these a model
/// is trained that has seen them with values from the box.
reduce::Box with_heat_of(reduce::Box box, const SplitProblem& split, const std::vector<SplitProblem>& others,
                         double start);

/// Name of the coefficient of a source's heat.
std::string heat_name(const HeatSource& source);

/// A coefficient with its members in another problem of the same press. A case may have other friction laws than the
/// one that was reduced, so sources are known by their names; there may be none.
reduce::FreeCoefficient in_problem(reduce::FreeCoefficient coefficient, const HeatProblem& problem);

/// A coefficient's value in a segment: a factor on its base, or a difference to it. A press at rest has no friction.
/// @param coefficient  in_problem()
/// @param member       of the coefficient
/// @param start        temperature at the start [K]
/// @return infinity where there is something that the reduced case had not; nothing for the ambient, which is no single
///         number, where both are zero, for a source at rest, and for the temperature of oil that carries no heat away
std::optional<double> value_of(const reduce::FreeCoefficient& coefficient, std::size_t member,
                               const HeatProblem& problem, std::size_t segment, double start);

/// A film's coefficient at a surface 20 K above the start temperature, in air at it, radiation included [W/m2/K].
double nominal_film(const SurfaceCondition& film, std::size_t segment, double start);

/// The problem with constant films: each at its nominal_film() of the first segment.
HeatProblem with_nominal_films(const HeatProblem& problem, double start);

}  // namespace deadpoint::twin
