#pragma once

#include "deadpoint/calibration/problem.hpp"

#include <string>
#include <vector>

/// Residuals that are not noise. Shows Eigen.
namespace deadpoint::calibration {

/// How the residuals of one curve differ from the errors that are stated for it.
struct CurveResidual {
    std::string curve;
    Eigen::Index values = 0;
    double rms = 0;          ///< of measured - predicted, in the curve's unit
    double bias = 0;         ///< their mean
    double chi_square = 0;   ///< sum of whitened squares over their number
    double lag_one = 0;      ///< correlation of neighbouring whitened residuals
    double probability = 1;  ///< of residuals as unlike noise as these, by the least of the three tests, times three
};

/// @param residual  measured - predicted
CurveResidual residual_of(const Curve& curve, const Eigen::VectorXd& residual);

struct ModelTest {
    std::vector<CurveResidual> curves;
    double probability = 1;  ///< least of the curves times their number, at most 1
    bool differs = false;    ///< below 0.05: the model, or the stated errors, do not explain the data
};
/// Chi-square, lag-one correlation and mean of the whitened residuals, each against its distribution for independent
/// normal errors (two-sided for the mean, else only above), with Bonferroni's correction for the number of tests.
/// Fitted parameters make residuals smaller, so that the test flags a right model less often than it states.
ModelTest test_model(const Problem& problem, const Prediction& prediction);

/// Root of the mean square.
double rms(const Eigen::VectorXd& values);

}  // namespace deadpoint::calibration
