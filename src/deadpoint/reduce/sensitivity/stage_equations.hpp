#pragma once

#include "deadpoint/reduce/sensitivity/linearised_heat.hpp"

#include <Eigen/Dense>
#include <map>

/// Internal to reduce/, since it shows Eigen.
namespace deadpoint::reduce {

/// Derivatives of states and of inner values, a column for each direction.
struct Derivatives {
    Eigen::MatrixXd states, inner;
};

/// Solves the linearised equations of stages of a segment. With A = 1 + d K, the capacities C of inner values, and
/// s = d where there is one and 1 where the equation is algebraic, a stage of factor d is
///   A x - d L v = right_x,      (C - s D) v - s N^T x = right_v.
/// With Z = A^-1 L and E = C - s D - d s N^T Z its solution, and that of the transposed equations, is
///   v = E^-1 (right_v + s N^T A^-1 right_x),      x = A^-1 right_x + d Z v
///   w = E^-T (right_v + d Z^T right_x),           y = A^-1 (right_x + N s w).
class StageEquations {
public:
    /// @param heat  must outlive this
    explicit StageEquations(const LinearisedHeat& heat);

    /// Sets the stage: the factor d, and the state at its end.
    void set(double d, const LinearisedState& at);
    /// In place of the right-hand sides.
    void solve(Derivatives& right) const;
    void solve_transposed(Derivatives& right) const;

    /// s of each inner value.
    [[nodiscard]] Eigen::VectorXd scales(double d) const;
    /// s where there is a capacity, else 0.
    [[nodiscard]] Eigen::VectorXd scales_of_rates(double d) const;
    [[nodiscard]] const Eigen::VectorXd& capacity() const { return capacity_; }

    /// Algebraic inner values at the start of a segment from its states and the values with a capacity.
    /// @param changes  dg by coefficients
    void start(const LinearisedState& at, const Eigen::MatrixXd& changes, Derivatives& now) const;
    /// The transpose: weights on all inner values become weights on states and on those with a capacity.
    /// @return the weights on `changes`
    [[nodiscard]] Eigen::MatrixXd start_transposed(const LinearisedState& at, Derivatives& weights) const;

private:
    struct Shifted {
        ShiftedFactor factor;
        Eigen::MatrixXd solved_loads;  ///< Z
    };
    [[nodiscard]] const Shifted& shifted(double d);
    void solve_field(Eigen::MatrixXd& states) const;
    [[nodiscard]] Eigen::MatrixXd start_matrix(const LinearisedState& at) const;

    const LinearisedHeat* heat_;
    Eigen::VectorXd capacity_;
    double d_ = 0;
    const LinearisedState* at_ = nullptr;
    std::map<double, Shifted> shifted_;  ///< by d, where no film follows the temperature
    const Shifted* present_ = nullptr;
    Eigen::LLT<Eigen::MatrixXd> factor_;  ///< of A, where one does
    Eigen::MatrixXd solved_loads_;
    Eigen::PartialPivLU<Eigen::MatrixXd> small_;  ///< E
};

}  // namespace deadpoint::reduce
