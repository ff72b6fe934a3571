#pragma once

#include "deadpoint/calibration/problem.hpp"

#include <cstddef>
#include <vector>

/// Slow courses that a model lacks. Shows Eigen.
namespace deadpoint::calibration {

/// A course with the covariance amplitude^2 exp(-|t_i - t_j| / time), as Noise::model_error.
struct Course {
    double amplitude = 0;  ///< in the unit of its curves
    double time = 0;       ///< [s]
    double gain = 0;       ///< of ln(likelihood) over none, without the courses of other groups
};

/// Likeliest courses on top of the stated errors, each shared by the curves of a group.
///
/// The likelihood is that of all values with the unknowns integrated out (restricted likelihood: Patterson, Thompson,
/// Biometrika 58 (1971)), by the Jacobian at the fit: z = residual + J theta has the covariance C + J Sigma J^T. A
/// course that unknowns imitate in part is therefore found with its whole size, not with that of the part which they
/// leave. Curves are averaged in up to 40 blocks of time; amplitudes and times lie on a grid, and groups are searched
/// in turn.
///
/// @param at      values and Jacobian at theta
/// @param group   of each curve, below `groups`; curves beyond that have no course
/// @return one for each group
std::vector<Course> find_courses(const Problem& problem, const Prediction& at, const Eigen::VectorXd& theta,
                                 const std::vector<std::size_t>& group, std::size_t groups);

/// Probability of a gain as large as the largest of these, if the model lacks nothing: at most their number times
/// exp(-gain), as for two further parameters.
double course_probability(const std::vector<Course>& courses);

}  // namespace deadpoint::calibration
