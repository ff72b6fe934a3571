#pragma once

#include <Eigen/Dense>
#include <cstddef>
#include <utility>
#include <vector>

namespace deadpoint {
struct HeatProblem;
struct HeatSegment;
}  // namespace deadpoint

/// Internal to reduce/, since it shows Eigen: what the residual of a reduced run in the full system needs.
namespace deadpoint::reduce {

/// What the terms of a conduction matrix do to a uniform temperature of 1 K: their loads are functionals.
struct UniformLoads {
    Eigen::VectorXd uniform;  ///< the states
    /// Per term: number of a functional of the layout, and its factor, 0 where a term annihilates it.
    std::vector<std::pair<Eigen::Index, double>> of_term;
};
struct DenseTerms;
UniformLoads uniform_loads(const DenseTerms& terms);

/// A term A >= 0 of the conduction matrix on a basis V: V^T A V = factor factor^T, its columns orthogonal, the largest
/// first. The first `kept` have a vector of the full system, y_j = A V f_j / |f_j|^2, so that A V x is the sum of
/// y_j (f_j . x) and a remainder whose size in A^-1 is that of the further f_j . x.
struct ResidualTerm {
    Eigen::MatrixXd factor;  ///< states x rank; without columns where there is no such term
    Eigen::Index kept = 0;
    [[nodiscard]] auto kept_factor() const { return factor.leftCols(kept); }
    [[nodiscard]] auto further_factor() const { return factor.rightCols(factor.cols() - kept); }
};

/// The vectors u_k of the full system in which the residual of a reduced run lies, by their products in K'^-1. K' is a
/// conduction matrix below those of all values of the box. In order: M V, K_0 V (a vector for each state), the kept
/// y_j of each term, the functionals of the layout, the observed functionals.
struct ResidualTerms {
    Eigen::Index states = 0;
    std::vector<ResidualTerm> terms;  ///< in the order of PreparedTerms::packed
    std::vector<double> lowest;       ///< the coefficient of each term in K' [W/m2/K]
    Eigen::Index functionals = 0, observed = 0;
    Eigen::MatrixXd root;      ///< upper triangle R: u_i K'^-1 u_j = (R^T R)_ij
    Eigen::MatrixXd products;  ///< of the first y_j of each term, at most `corrections` of them

    /// Number of the y_j of a term that make K larger than K'.
    [[nodiscard]] Eigen::Index corrections(std::size_t term) const;
    [[nodiscard]] Eigen::Index first_of_term(std::size_t term) const;
    [[nodiscard]] Eigen::Index first_functional() const { return first_of_term(terms.size()); }
    [[nodiscard]] Eigen::Index first_observed() const { return first_functional() + functionals; }
    [[nodiscard]] Eigen::Index count() const { return first_observed() + observed; }
};

/// Sets ResidualTerms::products from the root.
void set_products(ResidualTerms& terms);

/// Coefficient of each term in the conduction matrix of a segment, in the order of PreparedTerms::packed [W/m2/K].
/// Films that follow the temperature have their constant one.
std::vector<double> coefficients_of(const HeatProblem& problem, const HeatSegment& segment);
/// True if no coefficient is below that of K'.
bool covers(const ResidualTerms& terms, const std::vector<double>& coefficients);

/// Sizes of vectors of the full system in K^-1, of a conduction matrix K = K' + sum of D_q A_q with D_q >= 0. With the
/// kept vectors Y_q, for which A_q >= Y_q Y_q^T, K is at least K' + Y D Y^T, and a size in its inverse at most that of
/// this sum's (Woodbury's formula).
class ResidualNorm {
public:
    /// @param coefficients  of K, which the terms cover
    ResidualNorm(const ResidualTerms& terms, const UniformLoads& loads, const std::vector<double>& coefficients);

    /// |u|^2 of a vector for each column: u = sum of the u_k with these coefficients.
    [[nodiscard]] Eigen::VectorXd squares(const Eigen::MatrixXd& columns) const;

    /// The coefficients of K V x, column by column, without the remainders. Terms see the deviation of x from its mean
    /// temperature, and that mean by its loads, so that the absolute temperature is in no remainder.
    [[nodiscard]] Eigen::MatrixXd conducted(const Eigen::MatrixXd& states) const;
    /// |remainder of K V x|^2 in K^-1, at most sum of theta_q |further products|^2, since K >= sum of theta_q A_q.
    [[nodiscard]] Eigen::VectorXd remainder_squares(const Eigen::MatrixXd& states) const;
    /// a . V^T (K - K_0) V b. @param functionals_of_a  of the layout
    [[nodiscard]] double conduction_between(const Eigen::VectorXd& a, const Eigen::VectorXd& b,
                                            const Eigen::VectorXd& functionals_of_a) const;

private:
    [[nodiscard]] Eigen::RowVectorXd means(const Eigen::MatrixXd& states) const;
    [[nodiscard]] Eigen::MatrixXd deviations(const Eigen::MatrixXd& states) const;

    const ResidualTerms* terms_;
    const UniformLoads* loads_;
    std::vector<double> coefficients_;
    Eigen::MatrixXd directions_;              ///< R Y of the kept vectors with D > 0
    Eigen::LLT<Eigen::MatrixXd> correction_;  ///< of D^-1 + Y^T K'^-1 Y
};

}  // namespace deadpoint::reduce
