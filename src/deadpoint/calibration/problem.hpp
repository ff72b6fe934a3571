#pragma once

#include "deadpoint/calibration/noise.hpp"

#include <Eigen/Dense>
#include <functional>
#include <string>
#include <vector>

/// What is fitted to what. Shows Eigen.
namespace deadpoint::calibration {

/// Values that parameters predict, in the order of Problem::curves, each with its times.
struct Prediction {
    Eigen::VectorXd value;
    Eigen::MatrixXd jacobian;  ///< a column for each parameter; empty if not asked for
};

/// A measured curve, or single values of one quantity.
struct Curve {
    std::string name;
    Eigen::VectorXd time;      ///< [s]
    Eigen::VectorXd measured;  ///< in the unit of the model's values
    Noise noise;
};

/// Unknowns with a normal prior N(0, sigma^2) and limits: theta = ln(p / p0) for positive values.
struct Parameter {
    std::string name;
    double sigma = 0;  ///< > 0
    double lower = -1e300, upper = 1e300;
};

struct Problem {
    std::vector<Parameter> parameters;
    std::vector<Curve> curves;
    std::function<Prediction(const Eigen::VectorXd& theta, bool jacobian)> model;

    [[nodiscard]] Eigen::VectorXd sigmas() const;
    [[nodiscard]] Eigen::VectorXd measured() const;
    /// First value of each curve in a prediction, and the number of all values behind them.
    [[nodiscard]] std::vector<Eigen::Index> starts() const;
};

/// Residuals measured - predicted and their Jacobian by theta, both divided by L of the curves' errors, C = L L^T.
struct Whitened {
    Eigen::VectorXd residual;
    Eigen::MatrixXd jacobian;  ///< of the prediction: -d residual / d theta
};
Whitened whiten(const Problem& problem, const Prediction& prediction);
/// Only the Jacobian of any values with the curves' errors.
Eigen::MatrixXd whiten_columns(const Problem& problem, const Eigen::MatrixXd& columns);

/// 1/2 |residual|^2 + 1/2 |theta / sigma|^2
double cost(const Problem& problem, const Whitened& at, const Eigen::VectorXd& theta);

}  // namespace deadpoint::calibration
