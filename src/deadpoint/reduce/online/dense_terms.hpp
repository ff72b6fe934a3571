#pragma once

#include "deadpoint/heat/functionals.hpp"
#include "deadpoint/reduce/dense/products.hpp"
#include "deadpoint/reduce/dense/symmetric_matrix.hpp"
#include "deadpoint/reduce/online/conduction.hpp"

#include <Eigen/Dense>
#include <vector>

/// Internal to reduce/, since it shows Eigen: the matrices of a small system of temperatures.
namespace deadpoint::reduce {

/// A positive semidefinite matrix over the states, factor factor^T.
struct LowRankTerm {
    Eigen::MatrixXd factor;  ///< states x rank; without rows where there is no such term
    [[nodiscard]] bool is_missing() const { return factor.rows() == 0; }
};

/// Terms of one interface in the conduction matrix. With the conductances h_a, h_b and g of its sides and its oil
/// (see heat/joints.hpp), S = h_a + h_b + g, its matrix is
///   h_a h_b / S (between or turning) + h_a g / S aa + h_b g / S bb,
/// a sum of nonnegative multiples: no law makes such a joint give off heat of its own.
struct DenseJoint {
    LowRankTerm aa, bb;   ///< integrals of N_a N_a^T and N_b N_b^T [m2]
    LowRankTerm between;  ///< aa + bb less the integrals of N_a N_b^T + N_b N_a^T of opposite points [m2]
    /// The same with the means around the circumference in place of N_a and N_b in those integrals, for laws that turn
    /// fully. A joint needs only those of the two that its laws use.
    LowRankTerm turning;
};

/// A system by its terms. The states are orthonormal with respect to the heat capacity: M is the identity, and a state
/// has the unit (J K)^(1/2).
struct DenseTerms {
    heat::HeatGeometry geometry;
    Eigen::MatrixXd solid;           ///< K of the solids, symmetric [1/s]
    std::vector<DenseJoint> joints;  ///< per interface
    std::vector<LowRankTerm> films;  ///< per surface condition: integral of N N^T [m2]; may miss where it is no film
    RowMatrix functionals;           ///< a row for each functional of the layout
    RowMatrix observed;              ///< a row for each further functional, of T - T_reference; or empty
    Eigen::VectorXd uniform;         ///< states of a temperature of 1 K everywhere
    Eigen::MatrixXd parts;           ///< of 1 K on a part and 0 K elsewhere, a column for each; or empty
};

/// Removes from the terms what rounding and truncation changed in their heat, so that a run's energy balance closes
/// to its own rounding:
/// - solid, between and turning conduct nothing at a uniform temperature;
/// - aa, bb and films conduct at a uniform temperature what the functional of their mean says. The first column of such
///   a factor is then that functional times the root of the area, and all other columns are zero for a uniform
///   temperature.
/// @throws InputError if sizes do not fit, a term conducts far more at a uniform temperature than rounding explains, or
///         a term with an area has no mean
void conserve_heat(DenseTerms& terms);

/// Terms that conserve heat, and what a run's coefficients multiply; many runs can share it. It takes about n^2/2
/// numbers per term, since a sum of such matrices costs fewer operations than products with their factors.
struct PreparedTerms {
    /// @throws InputError as conserve_heat()
    explicit PreparedTerms(DenseTerms given);

    DenseTerms terms;
    SymmetricMatrix solid;
    /// Matrix of each term, without rows where there is none. First aa, bb, between and turning of each joint, then the
    /// films.
    std::vector<SymmetricMatrix> packed;
    /// The columns of the films' factors after the first, as rows: what differs from the surface's mean. Those of film
    /// s are [first_deviation[s], first_deviation[s + 1]).
    RowMatrix deviations;
    std::vector<Eigen::Index> first_deviation;
    std::vector<double> stiffest_film;  ///< largest eigenvalue of each film's matrix [m2 K/J]
    mutable Conductions conductions;    ///< sums of solid and packed
};

}  // namespace deadpoint::reduce
