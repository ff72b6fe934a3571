#pragma once

#include "deadpoint/calibration/fit.hpp"

/// A quick stand-in for a model near a fit. Shows Eigen.
namespace deadpoint::calibration {

/// A quadratic in theta for each value of a model, by least squares to values and derivatives of the model at points
/// of the normal distribution about the fit. With v = the fit's root of the covariance, theta = fit + v u:
///   f(u) = c + g . u + 1/2 u^T Q u
class Surrogate {
public:
    /// @param points  beside the fit; 0: twice as many as the coefficients need
    Surrogate(const Problem& problem, const Fit& fit, int points = 0);
    [[nodiscard]] Eigen::VectorXd value(const Eigen::VectorXd& theta) const;
    /// ln of the posterior density with it, without the constant; -infinity beyond a limit.
    [[nodiscard]] double log_density(const Eigen::VectorXd& theta) const;
    /// Largest root mean square of its whitened error at points of the distribution that it has not seen: 1 is the size
    /// of a measurement's error.
    [[nodiscard]] double checked_error(int points) const;

private:
    [[nodiscard]] Eigen::VectorXd features(const Eigen::VectorXd& u) const;
    [[nodiscard]] Eigen::VectorXd drawn(const Eigen::VectorXd& normal) const;

    const Problem& problem_;
    Eigen::VectorXd centre_;
    Eigen::MatrixXd root_;
    Eigen::MatrixXd coefficients_;  ///< a column for each whitened value
    Eigen::VectorXd target_;        ///< whitened measured values
    Eigen::MatrixXd points_;        ///< normal, a column for each
};

}  // namespace deadpoint::calibration
