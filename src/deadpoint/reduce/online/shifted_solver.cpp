#include "deadpoint/reduce/online/shifted_solver.hpp"

#include "deadpoint/reduce/dense/kernels.hpp"

#include <utility>

namespace deadpoint::reduce {
namespace {

constexpr std::size_t most_shifts = 32;  // step sizes change by factors of two: a run uses about a dozen

}  // namespace

void ShiftedSolver::set_matrix(std::shared_ptr<const TridiagonalForm> form)
{
    form_ = std::move(form);
    loads_.resize(0, form_->diagonal.size());
    shifted_.clear();
    present_ = nullptr;
}

void ShiftedSolver::set_loads(const Eigen::MatrixXd& loads)
{
    Eigen::MatrixXd columns = loads;
    form_->into_basis(columns);
    loads_ = columns.transpose();
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
    Shifted result{ShiftedFactor(*form_, d), {}, {}};
    Eigen::MatrixXd columns = loads_.transpose();
    result.factor.solve_in_place(columns);
    result.solved = columns.transpose();
    result.products.noalias() = loads_ * columns;
    return result;
}

// Adds Z (1 - C L^T Z)^-1 C L^T x to x.
void ShiftedSolver::correct(const RowMatrix& loads, const Shifted& factor, const Eigen::VectorXd& coefficients)
{
    const Eigen::Index count = loads.rows(), n = loads.cols();
    Eigen::MatrixXd small = -(coefficients.asDiagonal() * factor.products);
    small.diagonal().array() += 1;
    Eigen::VectorXd of_loads(count);
    kernels::row_products(loads.data(), n, count, n, work_.data(), of_loads.data());
    of_loads.array() *= coefficients.array();
    const Eigen::VectorXd weights = small.partialPivLu().solve(of_loads);
    kernels::add_rows(factor.solved.data(), n, count, n, weights.data(), work_.data());
}

// The loads beside the own ones, in the basis of T.
void ShiftedSolver::correct_with_others(const Eigen::VectorXd& of_loads, const Eigen::MatrixXd& others,
                                        const Eigen::VectorXd& of_others)
{
    const Eigen::Index own = of_loads.size(), more = of_others.size();
    Eigen::MatrixXd columns = others;
    form_->into_basis(columns);
    RowMatrix loads(own + more, work_.size());
    loads << loads_.topRows(own), columns.transpose();
    present_->factor.solve_in_place(columns);
    Shifted factor{{}, RowMatrix(own + more, work_.size()), {}};
    factor.solved << present_->solved.topRows(own), columns.transpose();
    factor.products = loads * factor.solved.transpose();
    Eigen::VectorXd coefficients(own + more);
    coefficients << of_loads, of_others;
    correct(loads, factor, coefficients);
}

void ShiftedSolver::solve(const Eigen::VectorXd& right, const Eigen::VectorXd& of_loads, const Eigen::MatrixXd& others,
                          const Eigen::VectorXd& of_others, Eigen::VectorXd& solution)
{
    work_ = right;
    form_->into_basis(work_);
    present_->factor.solve_in_place(work_);
    if (of_others.size() > 0)
        correct_with_others(of_loads, others, of_others);
    else if (of_loads.size() > 0)
        correct(loads_, *present_, of_loads);
    form_->from_basis(work_);
    solution = work_;
}

}  // namespace deadpoint::reduce
