#pragma once

#include "deadpoint/calibration/problem.hpp"
#include "deadpoint/study/learn/calibration_result.hpp"
#include "deadpoint/study/learn/forward.hpp"

#include <memory>
#include <string>
#include <vector>

namespace deadpoint::casefile {
struct CalibrationFile;
struct CalibrationRun;
struct MeasuredCurve;
}  // namespace deadpoint::casefile

/// Runs of a press with what was measured in them, as a problem of statistics. Internal to study/: shows Eigen.
namespace deadpoint::study {

/// One curve of a run: which output, whose sensor, and which unknowns of the sensor act on it.
struct CurveOfRun {
    const casefile::MeasuredCurve* measured = nullptr;
    std::size_t output = 0;            ///< of the forward model
    Eigen::Index bias = -1, lag = -1;  ///< parameters; -1: none
    double time_constant = 0;          ///< [s]; 0: none
    double start = 0;                  ///< subtracted from values, for rises
};

/// A run with its model.
struct ModelledRun {
    const casefile::CalibrationRun* run = nullptr;
    std::unique_ptr<ForwardModel> model;
    std::vector<CurveOfRun> curves;
};

/// All runs of a calibration file. The unknowns of the case come first, then those of sensors.
class MeasuredRuns {
public:
    /// @param file   must outlive this
    /// @param press  must outlive this
    /// @throws InputError if a run is not of that press, or if a parameter changes what a reduced model cannot
    MeasuredRuns(const casefile::CalibrationFile& file, const ReducedPress& press, int threads);

    /// The fitted runs (or the held-out ones) as a problem. It refers to this object.
    [[nodiscard]] calibration::Problem problem(bool hold_out) const;
    /// A further problem of other curves of a run, with the same unknowns.
    [[nodiscard]] calibration::Problem problem_of(const ModelledRun& run) const;
    /// A run that the file does not have, with its curves; not kept.
    [[nodiscard]] ModelledRun modelled(const casefile::CalibrationRun& run) const;

    /// Unknowns without estimates.
    [[nodiscard]] const std::vector<FittedParameter>& unknowns() const { return unknowns_; }
    [[nodiscard]] std::size_t case_parameters() const { return of_case_; }
    [[nodiscard]] const std::vector<ModelledRun>& runs() const { return runs_; }
    /// Only those of the case, as ForwardModel takes them.
    [[nodiscard]] std::vector<double> theta_of_case(const Eigen::VectorXd& theta) const;
    /// Curve of a problem, by its place.
    [[nodiscard]] std::vector<std::pair<const ModelledRun*, const CurveOfRun*>> curves(bool hold_out) const;

private:
    [[nodiscard]] calibration::Prediction predict(const std::vector<const ModelledRun*>& runs,
                                                  const Eigen::VectorXd& theta, bool jacobian) const;
    void add_curve(ModelledRun& to, const casefile::MeasuredCurve& measured) const;
    void add_sensor_unknowns();
    [[nodiscard]] Eigen::Index unknown_of(FittedParameter::Kind kind, const std::string& place) const;
    [[nodiscard]] calibration::Problem problem_of(std::vector<const ModelledRun*> runs) const;

    const casefile::CalibrationFile& file_;
    const ReducedPress& press_;
    int threads_ = 1;
    double reduced_temperature_ = 0, reduced_gap_ = 0;
    std::vector<CaseParameter> parameters_;
    std::vector<FittedParameter> unknowns_;
    std::vector<calibration::Parameter> priors_;
    std::size_t of_case_ = 0;
    std::vector<ModelledRun> runs_;
};

/// Errors that a reduced press states, the largest of all: of temperatures [K] and of the gap [m].
std::pair<double, double> stated_errors(const ReducedPress& press);

}  // namespace deadpoint::study
