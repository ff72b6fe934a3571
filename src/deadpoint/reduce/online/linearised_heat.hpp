#pragma once

#include "deadpoint/heat/balance.hpp"
#include "deadpoint/heat/films.hpp"
#include "deadpoint/heat/joints.hpp"
#include "deadpoint/reduce/online/dense_terms.hpp"
#include "deadpoint/reduce/online/heat_scalars.hpp"

#include <Eigen/Dense>
#include <array>
#include <cstddef>
#include <map>
#include <vector>

namespace deadpoint {
struct HeatProblem;
struct HeatSegment;
}  // namespace deadpoint

/// Internal to reduce/, since it shows Eigen: the rate of the heat balance, linearised.
namespace deadpoint::reduce {

/// Products factor^T x of all terms with a vector.
struct TermProducts {
    std::vector<std::array<Eigen::VectorXd, 3>> joints;  ///< aa, bb and the coupling term of the joint's law
    std::vector<Eigen::VectorXd> films;
};

/// One time of a run, as far as the derivatives of its rate need it.
struct LinearisedState {
    std::vector<double> values;   ///< by functional [K]
    heat::HeatBalance balance;    ///< of the joints
    std::vector<double> faced;    ///< per surface condition: temperature that its film faces [K]
    Eigen::MatrixXd heat_slopes;  ///< a column per source: derivative of its heat by the states
    TermProducts products;        ///< with the states
};

/// The rate  f(T, p) = sources(T, p) - K(p) T  of a segment and its derivatives:
///   df/dT = J = -K + sum over sources of b_r (dH_r/dT)^T,
/// b_r the load of one watt of source r and H_r its heat, and df/dp by the scalars p of HeatScalars. With the sum
/// S = h_a + h_b + g of an interface and its shares s_x = x / S,
///   ds_x = (dx - s_x dS) / S,    d(x y / S) = dx s_y + x ds_y,
///   dH_r = H_r' (phi dF - phi^2 H_r dS / (area S^2)) + (1 + self H_r') H_r dshare / share,
/// where H_r' is the slope by the solids' part of the temperature of the source's contact layers, phi the share of the
/// source's heat that enters this one, and F = (h_a T_a + h_b T_b + g T_oil) / S.
/// It has no oil circuits, enclosed air and films that follow the temperature.
class LinearisedHeat {
public:
    /// @param terms  after conserve_heat(); they and the problem must outlive this
    LinearisedHeat(const DenseTerms& terms, const HeatProblem& problem, std::size_t segment);
    LinearisedHeat(const LinearisedHeat&) = delete;

    [[nodiscard]] std::size_t segment() const { return segment_; }
    [[nodiscard]] LinearisedState at(double time, const Eigen::VectorXd& temperature) const;

    /// df/dp times the changes of p.
    [[nodiscard]] Eigen::VectorXd rate_change(const LinearisedState& at, const HeatScalars& change) const;
    /// (df/dp)^T weights.
    [[nodiscard]] HeatScalars scalar_weights(const LinearisedState& at, const Eigen::VectorXd& weights) const;
    /// J x, and J^T x; of columns.
    [[nodiscard]] Eigen::MatrixXd apply(const LinearisedState& at, const Eigen::MatrixXd& x) const;
    [[nodiscard]] Eigen::MatrixXd apply_transposed(const LinearisedState& at, const Eigen::MatrixXd& x) const;
    /// (1 - factor J)^-1 right, and the same of J^T; of columns. With A = 1 + factor K, B the loads b_r as columns and
    /// G the derivatives of their heat, Z = A^-1 B is kept per factor:
    ///   x = A^-1 right + factor Z q,       (1 - factor G^T Z) q = G^T A^-1 right
    ///   y = A^-1 (right + factor G q),     (1 - factor Z^T G) q = Z^T right
    [[nodiscard]] Eigen::MatrixXd solve(double factor, const LinearisedState& at, const Eigen::MatrixXd& right);
    [[nodiscard]] Eigen::MatrixXd solve_transposed(double factor, const LinearisedState& at,
                                                   const Eigen::MatrixXd& right);

private:
    struct Factored {
        Eigen::LLT<Eigen::MatrixXd> matrix;  ///< A
        Eigen::MatrixXd solved_loads;        ///< Z
    };
    /// Change of what an interface contributes.
    struct JointEffect {
        double heat = 0;               ///< of its source [W]
        std::array<double, 2> side{};  ///< uniform over each side [W]
        std::array<double, 2> zone{};  ///< by load zone of each side [W]
        std::array<double, 3> term{};  ///< coefficients of TermProducts::joints [W/m2/K]
    };
    /// A change of the rate, by its parts.
    struct RateParts {
        Eigen::VectorXd watts;   ///< by functional
        Eigen::VectorXd heat;    ///< by source [W]
        Eigen::VectorXd states;  ///< of the terms
    };
    void add_stiffness();
    const Factored& factored(double factor);
    [[nodiscard]] Eigen::VectorXd row(std::size_t functional) const;
    [[nodiscard]] std::array<const LowRankTerm*, 3> joint_terms(std::size_t interface) const;
    [[nodiscard]] TermProducts products(const Eigen::VectorXd& vector) const;

    [[nodiscard]] double film_share(std::size_t interface) const;
    [[nodiscard]] double zoned_heat(std::size_t interface) const;
    [[nodiscard]] Eigen::VectorXd ring_functional(std::size_t source) const;
    [[nodiscard]] double heat_by_rings(std::size_t source, double difference, double source_slope) const;
    [[nodiscard]] Eigen::MatrixXd heat_slopes(const heat::HeatBalance& balance,
                                              const Eigen::VectorXd& temperature) const;
    [[nodiscard]] double heat_by_share(std::size_t source, const LinearisedState& at) const;
    [[nodiscard]] double heat_change(std::size_t interface, const LinearisedState& at,
                                     const JointScalars& change) const;
    [[nodiscard]] JointEffect effect(std::size_t interface, const LinearisedState& at,
                                     const JointScalars& change) const;
    [[nodiscard]] JointEffect effect_of_share(std::size_t interface) const;

    void add_effect(std::size_t interface, const LinearisedState& at, const JointEffect& effect, RateParts& sum) const;
    void add_joints(const LinearisedState& at, const HeatScalars& change, RateParts& sum) const;
    void add_films(const LinearisedState& at, const HeatScalars& change, RateParts& sum) const;

    const DenseTerms* terms_;
    const HeatProblem* problem_;
    const HeatSegment* laws_;
    std::size_t segment_;
    heat::JointBalance joints_;
    heat::FilmBalance films_;
    std::vector<double> self_;  ///< per source: temperature of its contact layers per watt of its own [K/W]
    Eigen::MatrixXd stiffness_, loads_;
    std::map<double, Factored> factors_;
};

}  // namespace deadpoint::reduce
