#pragma once

#include "deadpoint/reduce/dense/products.hpp"

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
    Eigen::VectorXd factors;  ///< f_j . uniform
    /// Per term: number of a functional of the layout, and its factor, 0 where a term annihilates it.
    std::vector<std::pair<Eigen::Index, double>> of_term;
};
struct DenseTerms;
struct ResidualCut;

/// The vectors u_k of the full system in which the residual of a reduced run lies, by their products in K'^-1. K' is a
/// conduction matrix below those of all values of the box. In order: M V (a vector for each state), the y_j of each
/// term, the functionals of the layout, the observed functionals.
///
/// For each term A >= 0 of the conduction matrix, K_0 included, A V x is the sum of y_j (f_j . x) and a remainder. The
/// y_j are products of A^(1/2) with orthonormal columns, so that A >= Y Y^T.
struct ResidualTerms {
    Eigen::Index states = 0;
    std::vector<Eigen::Index> first;      ///< column of each term's first f_j in `factors`, and the end
    Eigen::MatrixXd factors;              ///< the f_j of all terms, in the order of PreparedTerms::each, then K_0
    std::vector<double> lowest, highest;  ///< the coefficient of each term in K', and in the box at most [W/m2/K]
    /// D with |remainder of x in K^-1|^2 <= max_q (coefficient / highest) |D x|^2
    Eigen::MatrixXd remainder;
    Eigen::Index functionals = 0, observed = 0;
    RowMatrix root;              ///< upper triangle R: u_i K'^-1 u_j = (R^T R)_ij
    Eigen::MatrixXd products;    ///< of the first y_j of each term, at most `corrections` of them
    Eigen::MatrixXd directions;  ///< R times these y_j

    [[nodiscard]] std::size_t terms() const { return lowest.size(); }
    [[nodiscard]] Eigen::Index kept(std::size_t term) const { return first[term + 1] - first[term]; }
    /// Number of the y_j of a term that make K larger than K'; K_0 is the same in both.
    [[nodiscard]] Eigen::Index corrections(std::size_t term) const;
    [[nodiscard]] Eigen::Index first_of_term(std::size_t term) const { return states + first[term]; }
    [[nodiscard]] Eigen::Index first_functional() const { return states + factors.cols(); }
    [[nodiscard]] Eigen::Index first_observed() const { return first_functional() + functionals; }
    [[nodiscard]] Eigen::Index count() const { return first_observed() + observed; }
};

UniformLoads uniform_loads(const DenseTerms& terms, const ResidualTerms& residual);

/// What ResidualTerms are to serve.
struct ResidualTask {
    const HeatProblem& lowest;    ///< with the coefficients of K'
    std::vector<double> highest;  ///< coefficient of each term in the box at most, that of K_0 last
    Eigen::MatrixXd typical;      ///< second moments of states, with the mean temperature taken out
    const ResidualCut& cut;
};

/// Sets ResidualTerms::directions from the root.
void set_directions(ResidualTerms& terms);
/// Sets ResidualTerms::products and directions from the root.
void set_products(ResidualTerms& terms);

/// What the terms see of states, column by column. They see the deviation of a state from its mean temperature, and
/// that mean by its loads, so that the absolute temperature is in no remainder.
struct SeenByTerms {
    Eigen::RowVectorXd means;    ///< mean temperatures
    Eigen::MatrixXd deviations;  ///< of the states from them
    Eigen::MatrixXd factors;     ///< f_j . deviation
    [[nodiscard]] SeenByTerms columns(Eigen::Index first, Eigen::Index count) const;
};
SeenByTerms seen_by_terms(const ResidualTerms& terms, const UniformLoads& loads, const Eigen::MatrixXd& states);

/// Coefficient of each term in the conduction matrix of a segment, in the order of PreparedTerms::each [W/m2/K], and
/// 1 for K_0. Films that follow the temperature have their constant one.
std::vector<double> coefficients_of(const HeatProblem& problem, const HeatSegment& segment);
/// True if no coefficient is below that of K', and none is of a term that the box has not.
bool covers(const ResidualTerms& terms, const std::vector<double>& coefficients);

/// Sizes of vectors of the full system in K^-1, of a conduction matrix K = K' + sum of D_q A_q with D_q >= 0. Since
/// A_q >= Y_q Y_q^T, K is at least K' + Y D Y^T, and a size in its inverse at most that of
/// this sum's (Woodbury's formula).
class ResidualNorm {
public:
    /// @param coefficients  of K, which the terms cover
    ResidualNorm(const ResidualTerms& terms, const UniformLoads& loads, const std::vector<double>& coefficients);

    /// |u|^2 of a vector for each column: u = sum of the u_k with coefficients c. @param rooted  R c
    [[nodiscard]] Eigen::VectorXd squares(const Eigen::MatrixXd& rooted) const;
    /// Products of these vectors in the inverse of the sum.
    [[nodiscard]] Eigen::MatrixXd products(const Eigen::MatrixXd& rooted) const;

    /// The coefficients of K V x, column by column, without the remainders.
    [[nodiscard]] Eigen::MatrixXd conducted(const SeenByTerms& states) const;
    /// |remainder of K V x|^2 in K^-1, at most, since K >= sum of theta_q A_q, column by column.
    [[nodiscard]] Eigen::VectorXd remainder_squares(const SeenByTerms& states) const;
    /// V z . (K - K_0) V x without the remainder, for each pair of columns.
    /// @param functionals  of the layout, of z
    [[nodiscard]] Eigen::VectorXd conducted_between(const SeenByTerms& z, const Eigen::MatrixXd& functionals,
                                                    const SeenByTerms& x) const;

private:
    [[nodiscard]] Eigen::MatrixXd along_corrections(const Eigen::MatrixXd& rooted) const;

    const ResidualTerms* terms_;
    const UniformLoads* loads_;
    std::vector<double> coefficients_;
    double remainder_factor_ = 0;             ///< largest coefficient / highest
    std::vector<Eigen::Index> chosen_;        ///< columns of ResidualTerms::directions with D > 0
    Eigen::LLT<Eigen::MatrixXd> correction_;  ///< of D^-1 + Y^T K'^-1 Y
};

}  // namespace deadpoint::reduce
