#include "deadpoint/reduce/certificate/euler_run.hpp"

#include "deadpoint/exchange/heat.hpp"
#include "deadpoint/heat/sources.hpp"
#include "deadpoint/heat/stage_solver.hpp"
#include "deadpoint/reduce/dense/tridiagonal.hpp"
#include "deadpoint/reduce/online/dense_system.hpp"

#include <utility>

namespace deadpoint::reduce {

std::vector<EulerStep> steps_of(const std::vector<double>& times)
{
    std::vector<EulerStep> steps;
    std::size_t segment = 0;
    for (std::size_t k = 1; k < times.size(); ++k)
        if (times[k] > times[k - 1])
            steps.push_back({segment, times[k], times[k] - times[k - 1]});
        else
            ++segment;
    return steps;
}

struct EulerRun::Solver {
    DenseSystem system;
    heat::HeatSources<DenseSystem> sources;
    heat::StageSolver<DenseSystem> stages;

    Solver(const std::shared_ptr<const PreparedTerms>& terms, const HeatProblem& problem)
        : system(terms, problem), sources(system, problem), stages(system, sources)
    {}
};

EulerRun::EulerRun(const std::shared_ptr<const PreparedTerms>& terms, const HeatProblem& problem)
    : problem_(&problem), solver_(std::make_unique<Solver>(terms, problem))
{}

EulerRun::~EulerRun() = default;

void EulerRun::march(const std::vector<EulerStep>& steps)
{
    Eigen::VectorXd state = Eigen::VectorXd::Zero(solver_->system.parts().uniform.size()), stored = state;
    for (Eigen::Index p = 0; p < solver_->system.parts().parts.cols(); ++p)
        state += problem_->initial_temperature(static_cast<int>(p), {}) * solver_->system.parts().parts.col(p);
    for (const auto& step : steps) {
        enter(step.segment);
        Level level{step, state, {}, {}, {}, {}};
        solver_->stages.known = state;
        solver_->stages.solve(step.time, step.duration, {}, state, stored);
        auto rate = solver_->sources.balance_at(step.time, state);
        level.state = state;
        level.watts = std::move(rate.pending);
        level.slopes = rate.balance.source_slope;
        level.temperatures = rate.balance.source_temperature;
        levels_.push_back(std::move(level));
    }
}

std::vector<Eigen::MatrixXd> EulerRun::duals(const Eigen::MatrixXd& weights)
{
    const auto outputs = weights.cols();
    std::vector<Eigen::MatrixXd> result(static_cast<std::size_t>(outputs),
                                        Eigen::MatrixXd(weights.rows(), static_cast<Eigen::Index>(levels_.size())));
    Eigen::MatrixXd right = weights;
    for (auto end = static_cast<Eigen::Index>(levels_.size()); end > 0;) {
        const auto first = first_of_segment(end);
        const Eigen::MatrixXd found = duals_in_segment(first, end, right);
        for (Eigen::Index k = first; k < end; ++k)
            for (Eigen::Index i = 0; i < outputs; ++i)
                result[static_cast<std::size_t>(i)].col(k) = found.col((k - first) * outputs + i);
        right = found.leftCols(outputs);
        end = first;
    }
    return result;
}

std::vector<heat::Loads> EulerRun::source_loads(std::size_t segment)
{
    enter(segment);
    std::vector<heat::Loads> result;
    for (std::size_t r = 0; r < problem_->sources.size(); ++r)
        result.push_back(solver_->sources.joints.source_load(r));
    return result;
}

std::shared_ptr<const TridiagonalForm> EulerRun::conduction(std::size_t segment)
{
    enter(segment);
    solver_->system.build(1, Eigen::VectorXd::Zero(solver_->system.parts().uniform.size()), {});
    return solver_->system.tridiagonal();
}

Eigen::Index EulerRun::first_of_segment(Eigen::Index end) const
{
    auto first = end - 1;
    while (first > 0 && level(first - 1).step.segment == level(end - 1).step.segment)
        --first;
    return first;
}

// The outputs' columns of each step of [first, end), all of one segment, in the basis in which K is tridiagonal:
//   (1 + d K - d b S b^T) z = right,   S the slopes of the sources' heat.
Eigen::MatrixXd EulerRun::duals_in_segment(Eigen::Index first, Eigen::Index end, const Eigen::MatrixXd& right)
{
    const auto form = conduction(level(first).step.segment);
    Eigen::MatrixXd loads = load_states();
    form->into_basis(loads);
    const auto outputs = right.cols();
    Eigen::MatrixXd present = right, all(right.rows(), (end - first) * outputs);
    form->into_basis(present);
    for (auto k = end - 1; k >= first; --k) {
        const auto& [step, before, state, watts, slopes, temperatures] = level(k);
        const ShiftedFactor factor(*form, step.duration);
        const Eigen::VectorXd scaled = step.duration * Eigen::Map<const Eigen::VectorXd>(slopes.data(), loads.cols());
        Eigen::MatrixXd solved = loads;
        factor.solve_in_place(solved);
        factor.solve_in_place(present);
        Eigen::MatrixXd small = -(scaled.asDiagonal() * (loads.transpose() * solved));
        small.diagonal().array() += 1;
        const Eigen::MatrixXd heat = scaled.asDiagonal() * (loads.transpose() * present);
        present += solved * small.partialPivLu().solve(heat);
        all.middleCols((k - first) * outputs, outputs) = present;
    }
    form->from_basis(all);
    return all;
}

// The load of one watt of each source of the present segment.
Eigen::MatrixXd EulerRun::load_states() const
{
    const auto& functionals = solver_->system.parts().functionals;
    Eigen::MatrixXd result =
        Eigen::MatrixXd::Zero(functionals.cols(), static_cast<Eigen::Index>(problem_->sources.size()));
    for (std::size_t r = 0; r < problem_->sources.size(); ++r)
        for (const auto& [functional, weight] : solver_->sources.joints.source_load(r))
            result.col(static_cast<Eigen::Index>(r)) +=
                weight * functionals.row(static_cast<Eigen::Index>(functional)).transpose();
    return result;
}

void EulerRun::enter(std::size_t segment)
{
    if (present_ == segment)
        return;
    solver_->sources.enter(problem_->segments[segment]);
    present_ = segment;
}

}  // namespace deadpoint::reduce
