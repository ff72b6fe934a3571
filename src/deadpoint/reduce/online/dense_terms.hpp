#pragma once

#include "deadpoint/heat/functionals.hpp"
#include "deadpoint/reduce/dense/products.hpp"
#include "deadpoint/reduce/dense/symmetric_matrix.hpp"
#include "deadpoint/reduce/online/conduction.hpp"

#include <Eigen/Dense>
#include <deque>
#include <memory>
#include <mutex>
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

/// The matrix of a term, made when first asked for. Several threads may ask.
class TermMatrix {
public:
    explicit TermMatrix(const LowRankTerm& term) : term_(term) {}
    [[nodiscard]] const LowRankTerm& term() const { return term_; }
    [[nodiscard]] const SymmetricMatrix& matrix() const;

private:
    const LowRankTerm& term_;
    mutable std::once_flag once_;
    mutable SymmetricMatrix matrix_;
};

/// How the conduction matrix is summed for a run's coefficients.
enum class Sums {
    /// From the terms' matrices, which are kept: for many runs. They take about n^2/2 numbers per term, and a sum of
    /// them costs far fewer operations than products of the factors.
    of_matrices,
    of_factors  ///< from the factors, until a third sum is asked for: for a run or two
};

/// Terms that conserve heat, and what a run's coefficients multiply; many runs can share it.
struct PreparedTerms {
    /// @throws InputError as conserve_heat()
    explicit PreparedTerms(DenseTerms given, Sums sums = Sums::of_matrices);

    /// K of the solids and of terms with their coefficients.
    [[nodiscard]] std::shared_ptr<const Conduction> conduction(const TermWeights& weights) const;
    [[nodiscard]] const TermMatrix& film(std::size_t surface) const { return each[4 * terms.joints.size() + surface]; }

    DenseTerms terms;
    /// First aa, bb, between and turning of each joint, then the films.
    std::deque<TermMatrix> each;
    /// The columns of the films' factors after the first, as rows: what differs from the surface's mean. Those of film
    /// s are [first_deviation[s], first_deviation[s + 1]).
    RowMatrix deviations;
    std::vector<Eigen::Index> first_deviation;
    std::vector<double> stiffest_film;  ///< largest eigenvalue of each film's matrix [m2 K/J]

private:
    [[nodiscard]] SymmetricMatrix sum_of_matrices(const TermWeights& weights) const;
    [[nodiscard]] SymmetricMatrix sum_of_factors(const TermWeights& weights) const;

    SymmetricMatrix solid_;
    Sums sums_;
    mutable Conductions conductions_;
};

}  // namespace deadpoint::reduce
