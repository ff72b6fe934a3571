#pragma once

#include <cstddef>
#include <functional>
#include <memory>

namespace Eigen {
template <typename Scalar, int rows, int columns, int options, int most_rows, int most_columns>
class Matrix;
}

namespace deadpoint {
class Observer;
struct HeatCauses;
struct HeatProblem;
struct ThermalHistory;
}  // namespace deadpoint

namespace deadpoint::heat {
struct StepRecord;
}

namespace deadpoint::reduce {

struct PreparedTerms;
struct TridiagonalForm;
using States = Eigen::Matrix<double, -1, 1, 0, -1, 1>;

/// Called during a run; empty functions are not called.
struct ReducedHooks {
    std::function<void(double time, const States&)> on_step;   ///< after each accepted step
    std::function<void(double time, const States&)> on_field;  ///< for each of HeatProblem::field_times
    /// After each accepted step, with the states at its three times.
    std::function<void(const heat::StepRecord&, const States& start, const States& middle, const States& end)>
        on_stages = {};
};

/// A heat problem over its segments on reduced terms. The problem must outlive it. Several runs may share terms, each
/// on its own thread.
class ReducedRun {
public:
    /// @param adjoints   rows of terms.observed that are recorded with their slopes; the others split them by part
    /// @param reference  temperature at which observed functionals are zero [K]
    /// @throws InputError if the terms do not fit the problem
    ReducedRun(std::shared_ptr<const PreparedTerms> terms, const HeatProblem& problem, std::size_t adjoints,
               double reference);
    ~ReducedRun();
    ReducedRun(ReducedRun&&) noexcept;

    /// Errors as heat::HeatRun. @return the history, as of fem::Model::heat()
    const ThermalHistory& go(const ReducedHooks& hooks, Observer& observer);
    /// Form of the conduction matrix in the last step; null if a film follows the temperature.
    [[nodiscard]] std::shared_ptr<const TridiagonalForm> tridiagonal() const;
    /// As fem::Model::heat_causes(), of weights by state. The run cannot continue afterwards.
    HeatCauses causes(const States& weights, std::size_t row);

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace deadpoint::reduce
