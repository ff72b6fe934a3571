#pragma once

#include "deadpoint/error.hpp"
#include "deadpoint/heat/films.hpp"
#include "deadpoint/heat/functionals.hpp"

#include <concepts>
#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace deadpoint {
struct InterfaceLaw;
}

/// Interface of a system of temperatures for the time integration.
///
/// The same integrator runs on the finite elements of a machine (fem/conduction) and on a small dense system
/// (reduce/online). Scalars of joints, oil, films and air stay on this side; the system knows matrices, functionals,
/// and how to solve.
namespace deadpoint::heat {

/// A vector and its factor in a sum.
template <class Vector>
using Scaled = std::pair<double, const Vector*>;

/// coefficient load load^T, a term that is subtracted from a stage's matrix.
template <class Vector>
struct RankOne {
    double coefficient = 0;
    const Vector* load = nullptr;
};

/// Terms of low rank in the matrix of a stage: M + factor K - factor sum of slope_r b_r b_r^T - sum of the others.
template <class Vector>
struct LowRank {
    std::vector<double> source_slopes;  ///< per source [W/K]; empty: none
    std::vector<RankOne<Vector>> others;
};

/// Tolerance of a linear solve: residual below `relative` times the right-hand side, or a root mean
/// square error below `absolute` [K].
struct SolveTolerance {
    double relative = 0;
    double absolute = 0;
};

/// A linear solve in which a value became infinite or not a number, or whose matrix holds such values.
struct NotFinite : ConvergenceError {
    using ConvergenceError::ConvergenceError;
};

/// One term of the heat balance, for error messages.
struct Term {
    std::string text;
    double size = 0;  ///< its approximate magnitude [W]
};

// clang-format off
template <class S>
concept HeatSystem = requires(S& s, const S& c, typename S::Vector& v, const typename S::Vector& x, double number,
                              const std::vector<double>& numbers, const std::vector<FilmAt>& films,
                              const LowRank<typename S::Vector>& low_rank,
                              std::span<const std::size_t> which,
                              const std::vector<Scaled<typename S::Vector>>& sum) {
    // a vector space
    { c.make_vector() } -> std::same_as<typename S::Vector>;      // of zeros
    c.copy(x, v);
    c.combine(sum, v);                                            // v = sum; v is none of them
    c.add(number, x, v);                                          // v += number x
    { c.total(x) } -> std::convertible_to<double>;
    { c.dot(x, x) } -> std::convertible_to<double>;
    { c.largest(x) } -> std::convertible_to<double>;              // of the magnitudes
    { c.is_finite(x) } -> std::convertible_to<bool>;
    { c.any(true) } -> std::convertible_to<bool>;                 // of all ranks

    // functionals, whose transposes are loads
    { c.geometry() } -> std::same_as<const HeatGeometry&>;
    { c.evaluate(which, x) } -> std::same_as<std::vector<double>>;
    c.add_loads(numbers, v);                                      // watts by functional

    // terms: set by coefficients, never integrated again
    s.set_laws(std::declval<const std::vector<InterfaceLaw>&>(), std::declval<const std::vector<Loads>&>());
    { c.is_linear() } -> std::convertible_to<bool>;               // the stage's matrix is M + factor K for all unknowns
    { c.follows_temperature() } -> std::convertible_to<bool>;     // the stage's matrix depends on temperature
    c.store(x, v);                                                // M h(T)  [J]
    c.conduct(x, v);                                              // K T, without coefficients that depend on temperature [W]
    c.apply_stage(x, v);                                          // (M + factor K) T of the last build(), if is_linear()
    { c.stored_between(x, x) } -> std::convertible_to<double>;    // [J]

    // convection coefficients that depend on the temperature of their surface
    { c.add_films(films, x, v) } -> std::same_as<FilmHeat>;
    c.add_film_slopes(films, x, v);                               // d(heat into the air) / d(air), as a load
    c.finish_load(v);

    // prescribed temperatures
    { c.some_prescribed() } -> std::convertible_to<bool>;
    c.impose(number, v);                                          // at a time
    c.clear_prescribed(v);
    { c.total_prescribed(x) } -> std::convertible_to<double>;

    // the system of a stage
    s.build(number, x, films);                                    // factor, temperature of the tangents
    { s.solve(x, v, low_rank, SolveTolerance{}, std::string()) } -> std::convertible_to<int>;  // iterations
    { c.terms() } -> std::same_as<std::vector<Term>>;

    // further values that a run records
    { c.observe(x, x, true) } -> std::same_as<std::vector<double>>;
    c.widen(x, std::declval<std::vector<double>&>(), std::declval<std::vector<double>&>());
};
// clang-format on

}  // namespace deadpoint::heat
