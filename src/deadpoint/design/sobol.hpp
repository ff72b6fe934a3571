#pragma once

#include "deadpoint/design/points.hpp"

#include <span>

/// Variance-based sensitivity: Sobol' indices of first order and total ones.
namespace deadpoint::design {

/// The points at which a model is evaluated (Saltelli et al., Computer Physics Communications 181 (2010) 259): matrices
/// A and B of independent points, and for each input i the matrix AB_i, which is A with column i of B.
/// Points are numbered A first, then B, then AB_1, AB_2, ...
class SobolDesign {
public:
    /// @param rows  of each matrix, best a power of two: a Sobol' sequence of 2 * inputs coordinates
    SobolDesign(std::size_t inputs, std::size_t rows, unsigned seed);
    [[nodiscard]] std::size_t inputs() const { return inputs_; }
    [[nodiscard]] std::size_t rows() const { return both_.size(); }
    [[nodiscard]] std::size_t size() const { return rows() * (inputs_ + 2); }
    [[nodiscard]] Point point(std::size_t number) const;
    /// The point to evaluate as the k-th: row by row, since points of a row share most of their inputs.
    [[nodiscard]] std::size_t in_turn(std::size_t k) const { return k % (inputs_ + 2) * rows() + k / (inputs_ + 2); }

private:
    std::size_t inputs_;
    std::vector<Point> both_;  ///< a row of A, then the same row of B
};

/// Sensitivity of an output to one input.
struct SobolIndex {
    Band first;  ///< share of the variance that the input explains alone
    Band total;  ///< share that would remain if all other inputs were known; includes all interactions
};

struct SobolIndices {
    double mean = 0, variance = 0;   ///< of the output over A and B
    std::size_t rows = 0;            ///< that were used: those in which all values are finite
    std::vector<SobolIndex> inputs;  ///< all NaN where the output does not vary
};

/// With f0 and V the mean and variance of f over A and B:
///   S_i  = mean(f(B) (f(AB_i) - f(A))) / V     (Saltelli 2010, table 2 (b), with f - f0 for f)
///   ST_i = mean((f(A) - f(AB_i))^2) / (2 V)    (Jansen 1999; table 2 (f))
/// An output that varies by less than 1e-10 of its mean counts as constant.
///
/// @param values  of one output at all points of the design, in their order; a row with a value that is not finite
///                is left out
/// @throws DomainError if the number of values is not that of a design
SobolIndices sobol_indices(std::span<const double> values, std::size_t inputs, const Bootstrap& bootstrap);

/// Upper bound of the total index of a uniform input by derivatives (Sobol' and Kucherenko, Mathematics and Computers
/// in Simulation 79 (2009) 3009):
///   ST_i <= mean((df/du_i)^2) / (pi^2 V),   u_i in [0, 1]
/// @param slopes  df/du_i at points that fill the cube  @return NaN without slopes or variance
double total_index_bound(std::span<const double> slopes, double variance);

}  // namespace deadpoint::design
