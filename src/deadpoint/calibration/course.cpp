#include "deadpoint/calibration/course.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace deadpoint::calibration {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr Index most_blocks = 40;
constexpr int sweeps = 3;
constexpr std::array times{0.1, 0.3, 1.0, 3.0};         // of the longest curve of the group
constexpr int amplitudes = 20;                          // from a tenth to 30 times the root mean square residual
constexpr double least_amplitude = 0.1, decades = 2.5;  // log10(30 / 0.1)

/// What a curve adds to the restricted likelihood: with whitened z and J, J^T J, J^T z, z^T z and ln det C.
struct Share {
    MatrixXd square;
    VectorXd mixed;
    double own = 0, log_determinant = 0;
};

/// A curve averaged in blocks of time.
class Blocks {
public:
    Blocks(const Curve& curve, const VectorXd& z, const MatrixXd& scaled_jacobian)
    {
        const Index count = curve.time.size(), blocks = std::min(count, most_blocks);
        MatrixXd mean = MatrixXd::Zero(blocks, count);
        for (Index k = 0; k < count; ++k)
            mean(k * blocks / count, k) = 1;
        mean = mean.rowwise().sum().cwiseInverse().asDiagonal() * mean;
        time_ = mean * curve.time;
        columns_.resize(blocks, 1 + scaled_jacobian.cols());
        columns_ << mean * z, mean * scaled_jacobian;
        noise_ = mean * covariance(curve.noise, curve.time) * mean.transpose();
    }
    [[nodiscard]] Share share(const Course& course) const
    {
        MatrixXd all = noise_;
        if (course.amplitude > 0)
            all += covariance({0, 0, course.amplitude, course.time}, time_);
        const Eigen::LLT<MatrixXd> factor(all);
        const MatrixXd white = factor.matrixL().solve(columns_);
        const auto jacobian = white.rightCols(white.cols() - 1);
        return {jacobian.transpose() * jacobian, jacobian.transpose() * white.col(0), white.col(0).squaredNorm(),
                2 * factor.matrixLLT().diagonal().array().log().sum()};
    }
    [[nodiscard]] double span() const { return time_[time_.size() - 1] - time_[0]; }

private:
    VectorXd time_;
    MatrixXd columns_, noise_;
};

class Search {
public:
    Search(const Problem& problem, const Prediction& at, const VectorXd& theta, const std::vector<std::size_t>& group,
           std::size_t groups)
        : group_(group), span_(groups, 0), size_(groups, 0)
    {
        const auto first = problem.starts();
        const MatrixXd scaled = at.jacobian * problem.sigmas().asDiagonal();
        const VectorXd residual = problem.measured() - at.value, z = residual + at.jacobian * theta;
        std::vector<double> count(groups, 0);
        for (std::size_t c = 0; c < problem.curves.size(); ++c) {
            const Index values = problem.curves[c].time.size();
            blocks_.emplace_back(problem.curves[c], z.segment(first[c], values), scaled.middleRows(first[c], values));
            shares_.push_back(blocks_.back().share({}));
            if (group[c] >= groups)
                continue;
            span_[group[c]] = std::max(span_[group[c]], blocks_.back().span());
            size_[group[c]] += residual.segment(first[c], values).squaredNorm();
            count[group[c]] += static_cast<double>(values);
        }
        for (std::size_t g = 0; g < groups; ++g)
            size_[g] = count[g] > 0 ? std::sqrt(size_[g] / count[g]) : 0;
    }

    /// Likeliest course of a group with those of the others as they are; takes its shares.
    Course improve(std::size_t group)
    {
        Course best;
        take(group, best);
        if (!(size_[group] > 0 && span_[group] > 0))
            return best;
        const double none = log_likelihood();
        for (const double time : times)
            for (int k = 0; k < amplitudes; ++k) {
                const double factor = std::pow(10.0, decades * k / (amplitudes - 1));
                const Course course{least_amplitude * factor * size_[group], time * span_[group], 0};
                take(group, course);
                if (const double gain = log_likelihood() - none; gain > best.gain)
                    best = {course.amplitude, course.time, gain};
            }
        take(group, best);
        return best;
    }
    void take(std::size_t group, const Course& course)
    {
        for (std::size_t c = 0; c < blocks_.size(); ++c)
            if (group_[c] == group)
                shares_[c] = blocks_[c].share(course);
    }

private:
    // Without its constant: z^T V^-1 z and ln det V by Woodbury, V = C + J J^T with scaled columns of J.
    [[nodiscard]] double log_likelihood() const
    {
        Share sum = shares_.front();
        for (std::size_t c = 1; c < shares_.size(); ++c) {
            sum.square += shares_[c].square;
            sum.mixed += shares_[c].mixed;
            sum.own += shares_[c].own;
            sum.log_determinant += shares_[c].log_determinant;
        }
        sum.square.diagonal().array() += 1;
        const Eigen::LLT<MatrixXd> factor(sum.square);
        const double explained = factor.matrixL().solve(sum.mixed).squaredNorm();
        return -0.5 * (sum.own - explained + sum.log_determinant) - factor.matrixLLT().diagonal().array().log().sum();
    }

    const std::vector<std::size_t>& group_;
    std::vector<double> span_, size_;
    std::vector<Blocks> blocks_;
    std::vector<Share> shares_;
};

}  // namespace

std::vector<Course> find_courses(const Problem& problem, const Prediction& at, const VectorXd& theta,
                                 const std::vector<std::size_t>& group, std::size_t groups)
{
    Search search(problem, at, theta, group, groups);
    std::vector<Course> result(groups);
    std::vector<double> alone;
    for (std::size_t g = 0; g < groups; ++g) {
        alone.push_back(search.improve(g).gain);
        search.take(g, {});
    }
    for (int k = 0; k < sweeps; ++k)
        for (std::size_t g = 0; g < groups; ++g)
            result[g] = search.improve(g);
    for (std::size_t g = 0; g < groups; ++g)
        result[g].gain = alone[g];
    return result;
}

double course_probability(const std::vector<Course>& courses)
{
    if (courses.empty())
        return 1;
    double most = 0;
    for (const auto& course : courses)
        most = std::max(most, course.gain);
    return std::min(1.0, static_cast<double>(courses.size()) * std::exp(-most));
}

}  // namespace deadpoint::calibration
