#include "deadpoint/reduce/online/shifted_solver.hpp"

#include <utility>

namespace deadpoint::reduce {
namespace {

constexpr std::size_t most_shifts = 32;  // step sizes change by factors of two: a run uses about a dozen

}  // namespace

void ShiftedSolver::set_matrix(const Eigen::MatrixXd& matrix)
{
    form_ = std::make_shared<const TridiagonalForm>(matrix);
    loads_.resize(matrix.rows(), 0);
    shifted_.clear();
    present_ = nullptr;
}

void ShiftedSolver::set_loads(const Eigen::MatrixXd& loads)
{
    loads_.noalias() = form_->basis.transpose() * loads;
    shifted_.clear();
    present_ = nullptr;
}

void ShiftedSolver::set_shift(double d)
{
    auto found = shifted_.find(d);
    if (found == shifted_.end()) {
        if (shifted_.size() >= most_shifts)
            shifted_.clear();
        found = shifted_.emplace(d, factored(d)).first;
    }
    present_ = &found->second;
}

ShiftedSolver::Shifted ShiftedSolver::factored(double d) const
{
    Shifted result{ShiftedFactor(*form_, d), loads_, {}};
    const auto& [below, pivots] = result.factor;
    auto& solved = result.solved;
    for (Eigen::Index i = 1; i < below.size(); ++i)
        solved.row(i) -= below[i] * solved.row(i - 1);
    solved.array().colwise() *= pivots.array();
    for (Eigen::Index i = below.size() - 2; i >= 0; --i)
        solved.row(i) -= below[i + 1] * solved.row(i + 1);
    result.products.noalias() = loads_.transpose() * solved;
    return result;
}

// Adds Z (1 - C L^T Z)^-1 C L^T x to x.
void ShiftedSolver::correct(const RowMatrix& loads, const Shifted& factor, const Eigen::VectorXd& coefficients)
{
    Eigen::MatrixXd small = -(coefficients.asDiagonal() * factor.products);
    small.diagonal().array() += 1;
    small_work_.noalias() = loads.transpose() * work_;
    small_work_.array() *= coefficients.array();
    work_.noalias() += factor.solved * small.partialPivLu().solve(small_work_);
}

// The loads beside the own ones, in the basis of T.
void ShiftedSolver::correct_with_others(const Eigen::VectorXd& of_loads, const Eigen::MatrixXd& others,
                                        const Eigen::VectorXd& of_others)
{
    const Eigen::Index own = of_loads.size(), more = of_others.size();
    RowMatrix loads(work_.size(), own + more);
    Shifted factor{{}, loads, {}};
    loads.leftCols(own) = loads_.leftCols(own);
    factor.solved.leftCols(own) = present_->solved.leftCols(own);
    for (Eigen::Index k = 0; k < more; ++k) {
        Eigen::VectorXd column = form_->basis.transpose() * others.col(k);
        loads.col(own + k) = column;
        present_->factor.solve_in_place(column);
        factor.solved.col(own + k) = column;
    }
    factor.products = loads.transpose() * factor.solved;
    Eigen::VectorXd coefficients(own + more);
    coefficients << of_loads, of_others;
    correct(loads, factor, coefficients);
}

void ShiftedSolver::solve(const Eigen::VectorXd& right, const Eigen::VectorXd& of_loads, const Eigen::MatrixXd& others,
                          const Eigen::VectorXd& of_others, Eigen::VectorXd& solution)
{
    work_.noalias() = form_->basis.transpose() * right;
    present_->factor.solve_in_place(work_);
    if (of_others.size() > 0)
        correct_with_others(of_loads, others, of_others);
    else if (of_loads.size() > 0)
        correct(loads_, *present_, of_loads);
    solution.noalias() = form_->basis * work_;
}

}  // namespace deadpoint::reduce
