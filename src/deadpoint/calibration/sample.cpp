#include "deadpoint/calibration/sample.hpp"

#include <algorithm>
#include <boost/random/mersenne_twister.hpp>
#include <boost/random/normal_distribution.hpp>
#include <boost/random/uniform_01.hpp>
#include <cmath>

namespace deadpoint::calibration {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double second_size = 0.2;  // of the second proposal
constexpr std::size_t adapt_every = 100;

class Chain {
public:
    Chain(const std::function<double(const VectorXd&)>& log_density, const VectorXd& start, const MatrixXd& covariance,
          unsigned seed)
        : density_(log_density), random_(seed), now_(start), value_(log_density(start)), mean_(start),
          scatter_(MatrixXd::Zero(start.size(), start.size())), first_(covariance)
    {
        set_proposal(covariance);
    }

    void step()
    {
        ++steps_;
        if (!first_stage())
            second_stage();
        adapt();
    }
    [[nodiscard]] const VectorXd& now() const { return now_; }
    [[nodiscard]] double accepted() const { return static_cast<double>(moved_) / static_cast<double>(steps_); }

private:
    void set_proposal(const MatrixXd& covariance)
    {
        const double scale = 2.38 * 2.38 / static_cast<double>(now_.size());
        const Eigen::LLT<MatrixXd> factor(scale * covariance);
        if (factor.info() == Eigen::Success)
            proposal_ = factor.matrixL();
    }
    VectorXd normals()
    {
        VectorXd result(now_.size());
        for (double& value : result)
            value = normal_(random_);
        return result;
    }
    void move(const VectorXd& to, double value)
    {
        now_ = to;
        value_ = value;
        ++moved_;
    }
    bool first_stage()
    {
        tried_ = now_ + proposal_ * normals();
        tried_value_ = density_(tried_);
        if (std::log(uniform_(random_)) >= tried_value_ - value_)
            return false;
        move(tried_, tried_value_);
        return true;
    }
    // ln of the density of a first proposal between two places, without its constant.
    [[nodiscard]] double log_proposal(const VectorXd& from, const VectorXd& to) const
    {
        return -0.5 * proposal_.triangularView<Eigen::Lower>().solve(to - from).squaredNorm();
    }
    // ln(1 - acceptance of `to` from `from`)
    static double log_rejected(double from, double to)
    {
        return to >= from ? -INFINITY : std::log1p(-std::exp(to - from));
    }
    void second_stage()
    {
        const VectorXd again = now_ + second_size * (proposal_ * normals());
        const double value = density_(again);
        const double ratio = value - value_ + log_proposal(again, tried_) - log_proposal(now_, tried_) +
                             log_rejected(value, tried_value_) - log_rejected(value_, tried_value_);
        if (std::log(uniform_(random_)) < ratio)
            move(again, value);
    }
    void adapt()
    {
        const auto count = static_cast<double>(steps_);
        const VectorXd off = now_ - mean_;
        mean_ += off / count;
        scatter_ += off * (now_ - mean_).transpose();
        if (steps_ % adapt_every != 0 || steps_ < 5 * adapt_every)
            return;
        const MatrixXd covariance = scatter_ / (count - 1);
        set_proposal(covariance + 1e-8 * first_);
    }

    const std::function<double(const VectorXd&)>& density_;
    boost::random::mt19937 random_;
    boost::random::normal_distribution<double> normal_;
    boost::random::uniform_01<double> uniform_;
    VectorXd now_, tried_;
    double value_, tried_value_ = 0;
    VectorXd mean_;
    MatrixXd scatter_, first_, proposal_;
    std::size_t steps_ = 0, moved_ = 0;
};

}  // namespace

Samples sample(const std::function<double(const VectorXd&)>& log_density, const VectorXd& start,
               const MatrixXd& covariance, const SampleOptions& options)
{
    Chain chain(log_density, start, covariance, options.seed);
    for (std::size_t k = 0; k < options.burn_in; ++k)
        chain.step();
    Samples result{MatrixXd(start.size(), static_cast<Index>(options.count)), 0};
    for (std::size_t k = 0; k < options.count; ++k) {
        chain.step();
        result.theta.col(static_cast<Index>(k)) = chain.now();
    }
    result.accepted = chain.accepted();
    return result;
}

}  // namespace deadpoint::calibration
