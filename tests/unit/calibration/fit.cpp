/// Requirement: fits, intervals and samples of models with known posteriors are those posteriors.
#include "deadpoint/calibration/fit.hpp"

#include "deadpoint/calibration/identify.hpp"
#include "deadpoint/calibration/sample.hpp"
#include "deadpoint/calibration/surrogate.hpp"
#include "deadpoint/error.hpp"
#include "linear.hpp"
#include "near.hpp"

#include <cmath>
#include <doctest/doctest.h>

using namespace linear;

namespace {

VectorXd pair(double a, double b) { return Eigen::Vector2d(a, b); }

/// Posterior of the linear model: covariance (A^T C^-1 A + Sigma^-1)^-1, mean covariance A^T C^-1 y.
struct Exact {
    VectorXd mean;
    MatrixXd covariance;
};
Exact exact_of(const Problem& problem)
{
    const MatrixXd a = matrix(problem.curves[0].time);
    const auto count = problem.curves[0].time.size();
    MatrixXd inverse = MatrixXd::Zero(2 * count, 2 * count);
    for (Index c = 0; c < 2; ++c)
        inverse.block(c * count, c * count, count, count) =
            covariance(problem.curves[static_cast<std::size_t>(c)].noise, problem.curves[0].time).inverse();
    MatrixXd hessian = a.transpose() * inverse * a;
    hessian.diagonal() += problem.sigmas().array().square().inverse().matrix();
    const MatrixXd posterior = hessian.inverse();
    return {posterior * (a.transpose() * inverse * problem.measured()), posterior};
}

/// One value exp(theta_0 + theta_1), measured as 2: a valley along theta_0 + theta_1 = ln 2.
Problem valley()
{
    Problem result;
    result.parameters = {{"rolling oil", 1}, {"plain oil", 1}};
    result.curves = {{"sum", VectorXd::Zero(1), VectorXd::Constant(1, 2), {0.01, 0, 0, 1}}};
    result.model = [](const VectorXd& theta, bool) {
        const double value = std::exp(theta[0] + theta[1]);
        return Prediction{VectorXd::Constant(1, value), MatrixXd::Constant(1, 2, value)};
    };
    return result;
}

}  // namespace

TEST_CASE("noise over time is whitened exactly: rho_k = exp(-dt / tau) as an autoregression says")
{
    // With even steps w_0 = r_0 / s, w_k = (r_k - rho r_k-1) / (s sqrt(1 - rho^2)); rounding of a Cholesky factor.
    const VectorXd time = even_times(30), residual = draw(30, 5);
    const double s = 0.3, rho = std::exp(-60.0 / 200);
    const VectorXd white = Whitening({s, 200, 0, 1}, time).apply(residual);
    CHECK(white[0] == near(residual[0] / s, 1e-12));
    for (Index k = 1; k < 30; ++k)
        CHECK(white[k] == near((residual[k] - rho * residual[k - 1]) / (s * std::sqrt(1 - rho * rho)), 1e-9));
    CHECK(Whitening({s, 200, 0, 1}, time).log_determinant() ==
          near(2 * 30 * std::log(s) + 29 * std::log(1 - rho * rho), 1e-12));
}

TEST_CASE("noise of zero is refused")
{
    CHECK_THROWS_AS(Whitening({0, 0, 0, 1}, even_times(3)), deadpoint::InputError);
}

TEST_CASE("the correlation time of noise is found from it")
{
    // 600 values over 36000 s at 300 s: the estimate of an AR(1) process scatters by sqrt(2 tau / T) = 13 %; the grid's
    // steps are 27 %.
    const VectorXd time = even_times(600);
    const MatrixXd root = covariance({0.2, 300, 0, 1}, time).llt().matrixL();
    const auto found = with_estimated_correlation({0.2, 0, 0, 1}, time, root * draw(600, 3), 3600);
    CHECK(found.correlation_time > 200);
    CHECK(found.correlation_time < 450);
    CHECK(with_estimated_correlation({0.2, 0, 0, 1}, time, 0.2 * draw(600, 3), 3600).correlation_time < 40);
}

TEST_CASE("the fit of a linear model is its posterior, with correlated noise and a model error")
{
    const auto of = problem(pair(0.5, -0.3), {0.05, 200, 0.02, 3000}, 1);
    const auto found = fit(of, pair(0, 0));
    const auto expected = exact_of(of);
    CHECK(found.converged);
    for (Index k = 0; k < 2; ++k) {
        // Convergence: less than 1e-3 of a standard deviation.
        CHECK(std::abs(found.theta[k] - expected.mean[k]) < 1e-3 * std::sqrt(expected.covariance(k, k)));
        for (Index j = 0; j < 2; ++j)
            CHECK(found.covariance(k, j) == near(expected.covariance(k, j), 1e-8));
    }
}

TEST_CASE("the profile of a linear model is its marginal: 1.645 standard deviations for 90 %")
{
    const auto of = problem(pair(0.5, -0.3), {0.05, 200, 0, 1}, 2);
    const auto found = fit(of, pair(0, 0));
    for (std::size_t k = 0; k < 2; ++k) {
        const auto interval = profile(of, found, k);
        const auto at = static_cast<Index>(k);
        const double half = std::sqrt(2.706 * found.covariance(at, at));
        CHECK(interval.lower == near(found.theta[at] - half, 1e-3));
        CHECK(interval.upper == near(found.theta[at] + half, 1e-3));
        CHECK(!interval.open_below);
        CHECK(!interval.open_above);
    }
}

TEST_CASE("a step to values at which the model fails is shortened")
{
    // The first step from 0 to a value of 50 would go to theta = 49, beyond what the model can take.
    Problem of;
    of.parameters = {{"power", 100}};
    of.curves = {{"c", VectorXd::Zero(1), VectorXd::Constant(1, 50), {0.01, 0, 0, 1}}};
    of.model = [](const VectorXd& theta, bool) {
        if (theta[0] > 10)
            throw deadpoint::ConvergenceError("too hot");
        return Prediction{VectorXd::Constant(1, std::exp(theta[0])), MatrixXd::Constant(1, 1, std::exp(theta[0]))};
    };
    CHECK(fit(of, VectorXd::Zero(1)).theta[0] == near(std::log(50), 1e-3));
    CHECK_THROWS_AS(fit(of, VectorXd::Constant(1, 11)), deadpoint::ConvergenceError);
}

TEST_CASE("a limit holds a parameter, and is said")
{
    auto of = problem(pair(0.5, -0.3), {0.05, 0, 0, 1}, 2);
    of.parameters[0].upper = 0.2;
    const auto found = fit(of, pair(0, 0));
    CHECK(found.theta[0] == 0.2);
    CHECK(found.at_limit == std::vector<bool>{true, false});
    CHECK(profile(of, found, 0).open_above);
}

TEST_CASE("points of the prior have its standard deviation, and two minima are told apart")
{
    auto of = valley();
    const auto points = prior_points(of, 1000);
    double sum = 0;
    for (const auto& point : points)
        sum += point[1] * point[1] / 1000;
    CHECK(sum == near(1, 0.02));  // a Sobol' sequence of 1000 points in two dimensions
    // theta^2 = 1 has a minimum at each side of zero.
    of.parameters = {{"either", 3}};
    of.model = [](const VectorXd& theta, bool) {
        return Prediction{VectorXd::Constant(1, theta[0] * theta[0] + 1), MatrixXd::Constant(1, 1, 2 * theta[0])};
    };
    const auto fits = fit_from_many(of, of, 10);
    REQUIRE(!other_minima(fits).empty());
    CHECK(std::abs(fits.front().theta[0]) == near(1, 1e-3));
    // The search runs on a model that is a little off; the minima are those of the problem.
    auto rough = of;
    rough.model = [](const VectorXd& theta, bool) {
        return Prediction{VectorXd::Constant(1, 1.1 * theta[0] * theta[0] + 1),
                          MatrixXd::Constant(1, 1, 2.2 * theta[0])};
    };
    CHECK(std::abs(fit_from_many(of, rough, 10).front().theta[0]) == near(1, 1e-3));
    const auto linear_one = problem(pair(0.5, -0.3), {0.05, 0, 0, 1}, 2);
    CHECK(other_minima(fit_from_many(linear_one, linear_one, 10)).empty());
}

TEST_CASE("a product is known and its ratio is not")
{
    const auto of = valley();
    const auto found = fit(of, pair(0, 0));
    CHECK(found.theta[0] + found.theta[1] == near(std::log(2), 1e-3));
    const auto told = identify(of.parameters, found.white.jacobian);
    REQUIRE(told.combinations.size() == 2);
    CHECK(told.combinations[0].words == "rolling oil x plain oil");
    CHECK(told.combinations[0].by_data);
    CHECK(told.combinations[0].singular_value == near(std::sqrt(2) * 2 / 0.01, 1e-3));
    CHECK((told.combinations[1].words == "rolling oil / plain oil" ||
           told.combinations[1].words == "plain oil / rolling oil"));
    CHECK(!told.combinations[1].by_data);
    CHECK(told.shrinkage[0] == near(0.5, 1e-4));  // one of two directions
    CHECK(told.covariance.isApprox(found.covariance, 1e-8));
}

TEST_CASE("the information of a value is that of its precision: 1/2 ln(1 + prior variance / noise variance)")
{
    const MatrixXd jacobian = MatrixXd::Constant(1, 1, 1 / 0.1);
    CHECK(information(MatrixXd::Constant(1, 1, 0.49), jacobian) == near(0.5 * std::log(1 + 0.49 / 0.01), 1e-5));
}

TEST_CASE("samples of a normal density have its mean and covariance, those of a banana its moments")
{
    // 40000 steps have some 4000 independent samples in two dimensions: standard errors of 1.6 % of a deviation, and
    // 2.2 % of a variance; four of them.
    const MatrixXd covariance = (MatrixXd(2, 2) << 1, 0.9, 0.9, 2).finished(), inverse = covariance.inverse();
    const auto normal = [&](const VectorXd& x) { return -0.5 * x.dot(inverse * x); };
    const auto found = sample(normal, pair(3, -3), MatrixXd::Identity(2, 2), {40000, 4000, 1});
    const VectorXd mean = found.theta.rowwise().mean();
    const MatrixXd off = found.theta.colwise() - mean;
    const MatrixXd scatter = off * off.transpose() / 40000;
    CHECK(std::abs(mean[0]) < 0.07);
    CHECK(std::abs(mean[1]) < 0.1);
    for (Index k = 0; k < 4; ++k)
        CHECK(scatter(k / 2, k % 2) == near(covariance(k / 2, k % 2), 0.1));
    CHECK(found.accepted > 0.3);
    // x normal, y = x^2 + normal of 0.5: mean of y is 1, its variance 2 + 0.25.
    const auto banana = [](const VectorXd& x) { return -0.5 * x[0] * x[0] - 2 * std::pow(x[1] - x[0] * x[0], 2); };
    const auto bent = sample(banana, pair(0, 0), MatrixXd::Identity(2, 2), {200000, 5000, 2});
    const double level = bent.theta.row(1).mean();
    CHECK(level == near(1, 0.07));
    CHECK((bent.theta.row(1).array() - level).square().mean() == near(2.25, 0.15));
}

TEST_CASE("a surrogate of a quadratic model is that model, and its posterior that of the linear one")
{
    auto of = problem(pair(0.5, -0.3), {0.05, 200, 0, 1}, 4);
    const auto best = fit(of, pair(0, 0));
    const Surrogate linear_one(of, best);
    const auto expected = exact_of(of);
    CHECK(linear_one.checked_error(5) < 1e-8);
    const VectorXd at = pair(0.4, -0.1), off = at - expected.mean, from = best.theta - expected.mean;
    CHECK(
        linear_one.log_density(at) - linear_one.log_density(best.theta) ==
        near(-0.5 * off.dot(expected.covariance.inverse() * off) + 0.5 * from.dot(expected.covariance.inverse() * from),
             1e-6));
    const auto plain = of.model;
    of.model = [plain](const VectorXd& theta, bool jacobian) {
        auto result = plain(theta, jacobian);
        result.value.array() += theta[0] * theta[1] + 3 * theta[0] * theta[0];
        if (jacobian) {
            result.jacobian.col(0).array() += theta[1] + 6 * theta[0];
            result.jacobian.col(1).array() += theta[0];
        }
        return result;
    };
    CHECK(Surrogate(of, fit(of, pair(0, 0))).checked_error(5) < 1e-8);
}
