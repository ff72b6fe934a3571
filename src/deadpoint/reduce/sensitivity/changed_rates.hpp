#pragma once

#include "deadpoint/reduce/sensitivity/direction.hpp"
#include "deadpoint/reduce/sensitivity/stage_equations.hpp"

#include <Eigen/Dense>
#include <cstddef>
#include <map>
#include <vector>

/// Internal to reduce/, since it shows Eigen.
namespace deadpoint::reduce {

/// Changes of the rates of a segment along directions, and their transpose.
class ChangedRates {
public:
    /// All must outlive this.
    ChangedRates(const LinearisedHeat& heat, const std::vector<Direction>& directions);

    /// A column for each direction.
    [[nodiscard]] Derivatives at(const LinearisedState& state);
    /// Adds the products of weights on the rates with their changes to the sums of all directions. What lasts over the
    /// segment is only added by finish().
    void add_weighted(const LinearisedState& state, const Derivatives& weights, std::vector<double>& sums);
    void finish(std::vector<double>& sums);

private:
    /// A scalar that changes throughout the segment.
    struct Lasting {
        std::size_t scalar = 0;
        std::vector<std::pair<std::size_t, double>> terms;
        double weight = 0;  ///< derivative of the objective by it, without the terms
    };
    [[nodiscard]] const Eigen::MatrixXd& factor(std::size_t term);
    void add_effect(std::size_t scalar, double change, const LinearisedState& state, Eigen::Ref<Eigen::VectorXd> states,
                    Eigen::Ref<Eigen::VectorXd> inner) const;
    [[nodiscard]] double weight_of(std::size_t scalar, const LinearisedState& state,
                                   const Eigen::VectorXd& by_functional, const Eigen::MatrixXd& by_inner) const;

    const LinearisedHeat* heat_;
    const std::vector<Direction>* directions_;
    std::vector<Lasting> lasting_;
    std::map<std::size_t, std::size_t> index_;        ///< of a scalar in lasting_
    std::map<std::size_t, Eigen::MatrixXd> factors_;  ///< of terms, in the basis
    std::vector<Eigen::VectorXd> weights_, states_;   ///< of all times so far
};

}  // namespace deadpoint::reduce
