#pragma once

#include "deadpoint/calibration/fit.hpp"
#include "deadpoint/calibration/identify.hpp"
#include "deadpoint/twin/calibrate/calibration_result.hpp"
#include "deadpoint/twin/calibrate/measured_runs.hpp"

#include <map>
#include <string>
#include <vector>

/// From a fit to the figures of a calibration. Shows Eigen.
namespace deadpoint::twin {

/// What the model may be off beyond the stated noise, by output [K] or [m].
using ModelErrors = std::map<std::string, double>;

/// Factor of a standard deviation for a probability of the normal distribution: 1.645 for 0.9.
double quantile_of(double level);

/// Value of an unknown as engineers read it: a factor, or a shift.
double value_of(const FittedParameter& unknown, double theta);

/// What data tell of an unknown, by the share of its variance that they remove: of 0.9 on they determine it, below 0.2
/// it is as uncertain as before. The one place that decides.
/// @param model_differs  the model does not explain these data, so that a small variance is no knowledge
Knowledge knowledge_of(double shrinkage, bool model_differs);

std::vector<KnownCombination> as_data(const std::vector<calibration::Combination>& combinations, bool model_differs);

/// Curves of fitted or held-out runs beside the model.
/// @param noises  of the problem's curves
std::vector<FittedCurve> fitted_curves(const MeasuredRuns& runs, const calibration::Problem& problem, bool hold_out,
                                       const calibration::Fit& fit, const ModelErrors& errors, double level);

/// Adds FittedCurve::rms_mean to curves whose output was measured in a fitted run.
void add_mean_baseline(std::vector<FittedCurve>& curves);

/// All runs over their steps, with bands.
std::vector<PredictedRun> predicted_runs(const MeasuredRuns& runs, const calibration::Fit& fit,
                                         const ModelErrors& errors, double level);

/// Largest change of predictions of temperatures [K] and dimensions [m] if steps are controlled by accuracy.
std::pair<double, double> change_by_steps(const MeasuredRuns& runs, const ReducedPress& press,
                                          const calibration::Fit& fit);

}  // namespace deadpoint::twin
