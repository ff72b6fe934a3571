#pragma once

#include "deadpoint/exchange/heat.hpp"
#include "deadpoint/heat/balance.hpp"
#include "deadpoint/reduce/online/dense_terms.hpp"
#include "deadpoint/reduce/sensitivity/direction.hpp"

#include <cstddef>
#include <memory>
#include <vector>

namespace deadpoint {
class Observer;
}

/// Derivatives of a reduced run's outputs by its coefficients. Internal to reduce/, since it shows Eigen.
///
/// A step of length dt from T_0 over T_m to T_1 (heat/tr_bdf2.hpp), with the rate f(T, p) and d = diagonal dt, solves
///   T_m = T_0 + d (f_0 + f_m),    T_1 = bdf_middle T_m - bdf_now T_0 + d f_1.
/// With J the derivative of f by T (slopes of friction heat included), f' that by a coefficient, and S the derivative
/// of T by it,
///   (1 - d J_m) S_m = (1 + d J_0) S_0 + d (f'_0 + f'_m),    (1 - d J_1) S_1 = bdf_middle S_m - bdf_now S_0 + d f'_1.
/// Weights l_1 on T_1 give those on T_0, and what the step adds to the gradient, by the transposed step:
///   (1 - d J_1)^T y_2 = l_1,    (1 - d J_m)^T y_1 = bdf_middle y_2,    l_0 = (1 + d J_0)^T y_1 - bdf_now y_2,
///   d (y_1 . (f'_0 + f'_m) + y_2 . f'_1).
/// T has the states and the inner values of the heat balance (linearised_heat.hpp): sumps and enclosed air with their
/// capacities in place of 1, all others by equations that hold at each of the three times.
/// Both are the derivatives of the steps as they are, with their lengths held. They take the equations of the stages as
/// solved: Newton's method leaves 1e-5 of the heat where a heat law is curved or depends on its rings, and 1e-3 of a
/// step's tolerance in temperatures of circulating oil (see heat/stage_solver.hpp), which they do not know of. The
/// first slope of a segment is that of its own laws.
namespace deadpoint::reduce {

struct TridiagonalForm;

/// An accepted step with its states.
struct RecordedStep {
    heat::StepRecord record;
    Eigen::VectorXd start, middle, end;
    std::shared_ptr<const TridiagonalForm> form;  ///< of K; null if a film follows the temperature
};

/// A finished run, with what its derivatives need.
struct RecordedRun {
    std::shared_ptr<const PreparedTerms> terms;
    HeatProblem problem;
    ThermalHistory history;
    std::vector<RecordedStep> steps;
};

/// A scalar of the history.
struct Output {
    enum class Kind { probe, side_a, side_b, observed };
    Kind kind = Kind::probe;
    std::size_t index = 0;  ///< of the probe, interface or row of DenseTerms::observed
};

/// Runs a problem and records it.
/// @param reference  temperature at which observed functionals are zero [K]
/// @throws InputError if the problem does not fit the terms; other errors as ReducedRun
RecordedRun record_run(std::shared_ptr<const PreparedTerms> terms, const HeatProblem& problem, double reference,
                       Observer& observer);

/// Derivatives of outputs at all rows of the history: [direction][output][row] [unit of the output per unit of the
/// coefficient]. One run forward serves all outputs.
/// @param directions  from the run's problem
std::vector<std::vector<std::vector<double>>> forward(const RecordedRun& run, const std::vector<Direction>& directions,
                                                      const std::vector<Output>& outputs);

/// Derivatives of an objective per direction. One run backward serves all directions.
/// @param weights  derivatives of the objective by each output (row) at each row of the history (column)
std::vector<double> gradient(const RecordedRun& run, const std::vector<Direction>& directions,
                             const std::vector<Output>& outputs, const Eigen::MatrixXd& weights);

/// The same of one output at one row of the history.
std::vector<double> gradient(const RecordedRun& run, const std::vector<Direction>& directions, Output output,
                             std::size_t row);

}  // namespace deadpoint::reduce
