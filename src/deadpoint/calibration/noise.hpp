#pragma once

#include <Eigen/Dense>

/// Errors of a measured curve. Shows Eigen.
namespace deadpoint::calibration {

/// Covariance of the values of a curve at times t_i, in the curve's unit squared:
///   C_ij = sigma^2 exp(-|t_i - t_j| / correlation_time) + model_error^2 exp(-|t_i - t_j| / model_time)
/// The first is noise, AR(1) at even spacing (Ornstein and Uhlenbeck); without a correlation time it is white. The
/// second is what the model may be off, in a slow course (Kennedy and O'Hagan, J. R. Stat. Soc. B 63 (2001)).
struct Noise {
    double sigma = 0;             ///< > 0
    double correlation_time = 0;  ///< [s], >= 0
    double model_error = 0;       ///< >= 0
    double model_time = 3600;     ///< [s], > 0
};

Eigen::MatrixXd covariance(const Noise& noise, const Eigen::VectorXd& time);

/// L^-1 with C = L L^T, applied to residuals and Jacobians, whose errors then are independent with variance 1.
class Whitening {
public:
    /// @throws InputError if the covariance is singular, as for two noiseless values at one time
    Whitening(const Noise& noise, const Eigen::VectorXd& time);
    [[nodiscard]] Eigen::MatrixXd apply(const Eigen::MatrixXd& columns) const;
    /// ln det C
    [[nodiscard]] double log_determinant() const;

private:
    Eigen::LLT<Eigen::MatrixXd> factor_;
};

/// ln of the likelihood of residuals, without the constant.
double log_likelihood(const Noise& noise, const Eigen::VectorXd& time, const Eigen::VectorXd& residual);

/// Noise whose correlation time is the likeliest for these residuals, with its other values held.
/// @param longest  [s]
Noise with_estimated_correlation(Noise noise, const Eigen::VectorXd& time, const Eigen::VectorXd& residual,
                                 double longest);

}  // namespace deadpoint::calibration
