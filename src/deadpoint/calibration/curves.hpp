#pragma once

#include <Eigen/Dense>
#include <vector>

/// From the rows of a run to what a sensor shows. Shows Eigen.
namespace deadpoint::calibration {

/// Weights of values at rows in values at times, a row for each time: cubic Hermite interpolation with slopes of
/// parabolas through three rows, exact for quadratics. Rows of equal time (segments that meet) end a piece: slopes do
/// not reach beyond them.
/// @param times  within the rows
Eigen::MatrixXd interpolation(const std::vector<double>& rows, const std::vector<double>& times);

/// What a sensor of first order shows of a temperature that is linear between rows, with its derivative by
/// ln(constant):
///   constant dz/dt = y - z,    z = y at the first row
struct Lagged {
    Eigen::VectorXd value;
    Eigen::VectorXd by_log_constant;
};
/// @param constant  [s], > 0
Lagged lagged(const std::vector<double>& rows, const Eigen::VectorXd& value, double constant);

}  // namespace deadpoint::calibration
