#pragma once

#include "deadpoint/heat/functionals.hpp"

#include <Eigen/Dense>
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

namespace deadpoint {
struct HeatProblem;
}

/// Internal to reduce/, since it shows Eigen: the reduced run whose error a certificate bounds.
namespace deadpoint::reduce {

struct PreparedTerms;
struct TridiagonalForm;

struct EulerStep {
    std::size_t segment = 0;
    double time = 0, duration = 0;
};

/// Steps between times, of which one that stands twice begins a segment.
std::vector<EulerStep> steps_of(const std::vector<double>& times);

/// The reduced system by implicit Euler steps, and its dual.
class EulerRun {
public:
    struct Level {
        EulerStep step;
        Eigen::VectorXd before, state;
        std::vector<double> watts;         ///< by functional
        std::vector<double> slopes;        ///< of each source's heat by the solids' part of its temperature [W/K]
        std::vector<double> temperatures;  ///< of the sources [K]
    };

    EulerRun(const std::shared_ptr<const PreparedTerms>& terms, const HeatProblem& problem);
    ~EulerRun();
    EulerRun(const EulerRun&) = delete;
    EulerRun& operator=(const EulerRun&) = delete;

    void march(const std::vector<EulerStep>& steps);

    /// Dual states of each output: a matrix with a column for each step. @param weights  of the states after the last
    /// step, a column for each output
    [[nodiscard]] std::vector<Eigen::MatrixXd> duals(const Eigen::MatrixXd& weights);

    /// The load of one watt of each source, by functional.
    [[nodiscard]] std::vector<heat::Loads> source_loads(std::size_t segment);

    /// Tridiagonal form of the conduction matrix on the states in a segment.
    [[nodiscard]] std::shared_ptr<const TridiagonalForm> conduction(std::size_t segment);

    [[nodiscard]] const std::vector<Level>& levels() const { return levels_; }

private:
    [[nodiscard]] const Level& level(Eigen::Index k) const { return levels_[static_cast<std::size_t>(k)]; }
    [[nodiscard]] Eigen::Index first_of_segment(Eigen::Index end) const;
    [[nodiscard]] Eigen::MatrixXd duals_in_segment(Eigen::Index first, Eigen::Index end, const Eigen::MatrixXd& right);
    [[nodiscard]] Eigen::MatrixXd load_states() const;
    void enter(std::size_t segment);

    const HeatProblem* problem_;
    struct Solver;
    std::unique_ptr<Solver> solver_;
    std::optional<std::size_t> present_;
    std::vector<Level> levels_;
};

}  // namespace deadpoint::reduce
