#pragma once

#include "deadpoint/heat/functionals.hpp"

#include <memory>
#include <string>
#include <vector>

namespace deadpoint {
struct HeatProblem;
}

namespace deadpoint::reduce {

struct PreparedTerms;
struct ResidualTerms;

/// Bounds of what a reduced run is off its full system at the end of the run.
struct Certificate {
    std::string refused;         ///< why there is none, or empty
    std::vector<double> bounds;  ///< per output, in its unit
    std::vector<double> values;  ///< of each output of the reduced steps, of absolute temperatures
};

/// Bounds |output of the full system - output of the reduced one| after the last time, both by implicit Euler steps
/// between these times. With the residual r_n of the reduced states in the full system, and r*_n that of the reduced
/// dual problem, linearised at the reduced states,
///   |error| <= (sum dt |r_n|^2)^1/2 (sum dt |r*_n|^2)^1/2 / kappa + |sum dt z_n . r_n| + curvature,
/// sizes in K^-1. Conduction, convection of constant coefficients and friction heat that falls with the temperature
/// take energy from an error, whatever its size; so kappa is 1. Where the heat of sources rises,
/// kappa = 1 - lambda, lambda the largest eigenvalue of (w_q w_r)^1/2 (b_q . K^-1 b_r) with the slopes w and b the load
/// of one watt. The curvature counts what laws differ from their tangents within 5 K of the run's temperatures; errors
/// of these temperatures beyond 5 K are not covered. docs/reduced.md has its bound.
///
/// It is refused, with the reason, for films that follow the temperature, heat by ring temperatures, oil circuits,
/// enclosed air, a start that is no field of the basis, coefficients below their range, and where kappa is not
/// positive or a number is not finite.
/// @param times      ends of steps, as ThermalHistory::time: a time that stands twice begins a segment [s]
/// @param outputs    sums of functionals of the layout, by their numbers, and, behind these, of rows of
///                   DenseTerms::observed
/// @throws InputError if terms and problem do not fit
Certificate certify(const std::shared_ptr<const PreparedTerms>& terms, const ResidualTerms& residual,
                    const HeatProblem& problem, const std::vector<double>& times,
                    const std::vector<heat::Loads>& outputs);

}  // namespace deadpoint::reduce
