#include "deadpoint/reduce/sensitivity/stage_equations.hpp"

namespace deadpoint::reduce {

using Eigen::MatrixXd;
using Eigen::VectorXd;

StageEquations::StageEquations(const LinearisedHeat& heat)
    : heat_(&heat), capacity_(Eigen::Map<const VectorXd>(heat.inner().capacity.data(), heat.inner().count()))
{}

VectorXd StageEquations::scales(double d) const
{
    return (capacity_.array() > 0).select(d, VectorXd::Ones(capacity_.size()));
}

VectorXd StageEquations::scales_of_rates(double d) const
{
    return (capacity_.array() > 0).select(d, VectorXd::Zero(capacity_.size()));
}

const StageEquations::Shifted& StageEquations::shifted(double d)
{
    const auto [found, is_new] = shifted_.try_emplace(d);
    if (is_new) {
        found->second.factor = ShiftedFactor(*heat_->form(), d);
        found->second.solved_loads = heat_->loads(*at_);
        found->second.factor.solve_in_place(found->second.solved_loads);
    }
    return found->second;
}

void StageEquations::set(double d, const LinearisedState& at)
{
    d_ = d;
    at_ = &at;
    if (heat_->form()) {
        present_ = &shifted(d);
    } else {
        MatrixXd matrix = d * at.stiffness.lower();
        matrix.diagonal().array() += 1;
        factor_.compute(matrix);
        solved_loads_ = factor_.solve(heat_->loads(at));
    }
    const auto& solved = present_ ? present_->solved_loads : solved_loads_;
    MatrixXd small = -at.inner - d * (at.rows.transpose() * solved);
    small = scales(d).asDiagonal() * small;
    small.diagonal() += capacity_;
    small_.compute(small);
}

void StageEquations::solve_field(MatrixXd& states) const
{
    if (present_)
        present_->factor.solve_in_place(states);
    else
        factor_.solveInPlace(states);
}

void StageEquations::solve(Derivatives& right) const
{
    solve_field(right.states);
    if (capacity_.size() == 0)
        return;
    right.inner += scales(d_).asDiagonal() * (at_->rows.transpose() * right.states);
    right.inner = small_.solve(right.inner);
    right.states += (present_ ? present_->solved_loads : solved_loads_) * (d_ * right.inner);
}

void StageEquations::solve_transposed(Derivatives& right) const
{
    if (capacity_.size() > 0) {
        right.inner += d_ * ((present_ ? present_->solved_loads : solved_loads_).transpose() * right.states);
        right.inner = small_.transpose().solve(right.inner);
        right.states += at_->rows * (scales(d_).asDiagonal() * right.inner);
    }
    solve_field(right.states);
}

// The algebraic equations, and identities for the others.
MatrixXd StageEquations::start_matrix(const LinearisedState& at) const
{
    MatrixXd matrix = at.inner;
    for (Eigen::Index k = 0; k < capacity_.size(); ++k)
        if (capacity_[k] > 0)
            matrix.row(k) = VectorXd::Unit(capacity_.size(), k);
    return matrix;
}

void StageEquations::start(const LinearisedState& at, const MatrixXd& changes, Derivatives& now) const
{
    if (capacity_.size() == 0)
        return;
    MatrixXd right = -(at.rows.transpose() * now.states) - changes;
    for (Eigen::Index k = 0; k < capacity_.size(); ++k)
        if (capacity_[k] > 0)
            right.row(k) = now.inner.row(k);
    now.inner = start_matrix(at).partialPivLu().solve(right);
}

MatrixXd StageEquations::start_transposed(const LinearisedState& at, Derivatives& weights) const
{
    if (capacity_.size() == 0)
        return weights.inner;
    const MatrixXd solved = start_matrix(at).transpose().partialPivLu().solve(weights.inner);
    MatrixXd on_changes = -solved;
    for (Eigen::Index k = 0; k < capacity_.size(); ++k) {
        weights.inner.row(k).setZero();
        if (capacity_[k] > 0) {
            weights.inner.row(k) = solved.row(k);
            on_changes.row(k).setZero();
        }
    }
    weights.states += at.rows * on_changes;
    return on_changes;
}

}  // namespace deadpoint::reduce
