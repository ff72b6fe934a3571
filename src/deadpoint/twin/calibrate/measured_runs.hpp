#pragma once

#include "deadpoint/calibration/problem.hpp"
#include "deadpoint/twin/calibrate/calibration_result.hpp"
#include "deadpoint/twin/calibrate/forward.hpp"
#include "deadpoint/twin/calibrate/other_presses.hpp"

#include <memory>
#include <string>
#include <vector>

namespace deadpoint::casefile {
struct CalibrationFile;
struct CalibrationRun;
struct MeasuredCurve;
}  // namespace deadpoint::casefile

/// Runs of a press with what was measured in them, as a problem of statistics. Shows Eigen.
namespace deadpoint::twin {

/// One curve of a run: which output, whose sensor, and which unknowns of the sensor act on it.
struct CurveOfRun {
    const casefile::MeasuredCurve* measured = nullptr;
    std::size_t output = 0;            ///< of the forward model
    Eigen::Index bias = -1, lag = -1;  ///< parameters; -1: none
    double time_constant = 0;          ///< [s]; 0: none
    double start = 0;                  ///< subtracted from values, for rises
};

/// A run in another model of the press. Its difference from the run's own model, times the share's standard deviation,
/// is a direction in which predictions may be off; the amount along it is an unknown of unit variance.
struct AlternativeRun {
    std::unique_ptr<ForwardModel> model;
    std::vector<std::size_t> unknowns;  ///< those of the case's that its laws have, by place
    double share = 1;
    std::vector<Eigen::VectorXd> difference;  ///< by curve of the run, at the values of the last turn_to()
};

/// What an alternative adds to a run by one standard deviation of its share: [output][row].
using Differences = std::vector<std::vector<double>>;

/// A run with its model.
struct ModelledRun {
    const casefile::CalibrationRun* run = nullptr;
    std::unique_ptr<ForwardModel> model;
    std::vector<CurveOfRun> curves;
    std::vector<AlternativeRun> alternatives;
};

/// All runs of a calibration file. The unknowns of the case come first, then those of sensors, then alternatives.
class MeasuredRuns {
public:
    /// @param file    must outlive this
    /// @param press   must outlive this
    /// @param others  of the file's alternatives
    /// @param asked   whether to stop; must outlive this. All functions that run a model throw Stopped then
    /// @throws InputError if a run is not of that press, if a parameter changes what a reduced model cannot, or if the
    ///         mesh of an alternative is too much like that of the press
    MeasuredRuns(const casefile::CalibrationFile& file, const ReducedPress& press, OtherPresses others, int threads,
                 const Observer& asked);

    /// The fitted runs (or the held-out ones) as a problem. It refers to this object.
    /// @param coarser  factor on the time step
    [[nodiscard]] calibration::Problem problem(bool hold_out, double coarser = 1) const;
    /// A further problem of other curves of a run, with the same unknowns.
    [[nodiscard]] calibration::Problem problem_of(const ModelledRun& run) const;
    /// A run that the file does not have, with its curves; not kept.
    [[nodiscard]] ModelledRun modelled(const casefile::CalibrationRun& run) const;
    /// Takes the differences of the alternatives at these values. They change little with them, and problems hold them
    /// fixed in between.
    void turn_to(const Eigen::VectorXd& theta);
    /// By alternative, at the rows of the run's own forecast.
    [[nodiscard]] std::vector<Differences> differences(const ModelledRun& run, const Eigen::VectorXd& theta,
                                                       const Forecast& own) const;

    /// Whoever is asked whether to stop.
    [[nodiscard]] const Observer& asked() const { return asked_; }
    /// Unknowns without estimates.
    [[nodiscard]] const std::vector<FittedParameter>& unknowns() const { return unknowns_; }
    [[nodiscard]] std::size_t case_parameters() const { return of_case_; }
    /// Place of the first alternative's share among the unknowns.
    [[nodiscard]] Eigen::Index first_alternative() const { return first_alternative_; }
    [[nodiscard]] const std::vector<ModelledRun>& runs() const { return runs_; }
    /// Only those of the case, as ForwardModel takes them.
    [[nodiscard]] std::vector<double> theta_of_case(const Eigen::VectorXd& theta) const;
    /// Curve of a problem, by its place.
    [[nodiscard]] std::vector<std::pair<const ModelledRun*, const CurveOfRun*>> curves(bool hold_out) const;

private:
    [[nodiscard]] calibration::Prediction predict(const std::vector<const ModelledRun*>& runs,
                                                  const Eigen::VectorXd& theta, bool jacobian, double coarser) const;
    void add_curve(ModelledRun& to, const casefile::MeasuredCurve& measured) const;
    void add_sensor_unknowns();
    void add_alternative_unknowns();
    void add_alternatives(ModelledRun& to, const ForwardOptions& options) const;
    [[nodiscard]] double share_of(std::size_t alternative) const;
    void take_differences(ModelledRun& of, const Eigen::VectorXd& theta) const;
    [[nodiscard]] Eigen::Index unknown_of(FittedParameter::Kind kind, const std::string& place) const;
    [[nodiscard]] calibration::Problem problem_of(std::vector<const ModelledRun*> runs, double coarser) const;

    const casefile::CalibrationFile& file_;
    const ReducedPress& press_;
    OtherPresses others_;
    int threads_ = 1;
    const Observer& asked_;
    double reduced_temperature_ = 0, reduced_gap_ = 0;
    std::vector<CaseParameter> parameters_;
    std::vector<FittedParameter> unknowns_;
    std::vector<calibration::Parameter> priors_;
    std::size_t of_case_ = 0;
    Eigen::Index first_alternative_ = 0;
    std::vector<ModelledRun> runs_;
};

/// A value of a curve of points between them, linear; beyond its ends that of the end.
double value_at(const std::vector<double>& x, const std::vector<double>& y, double at);

/// Errors that a reduced press states, the largest of all: of temperatures [K] and of the gap [m].
std::pair<double, double> stated_errors(const ReducedPress& press);

}  // namespace deadpoint::twin
