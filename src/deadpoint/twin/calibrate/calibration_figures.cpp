#include "deadpoint/twin/calibrate/calibration_figures.hpp"

#include "deadpoint/calibration/discrepancy.hpp"
#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/casefile/studies/calibration_file.hpp"
#include "deadpoint/twin/map/point_observer.hpp"

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <optional>

namespace deadpoint::twin {

using calibration::Fit;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

std::vector<double> as_list(const VectorXd& values) { return {values.data(), values.data() + values.size()}; }

double error_of(const ModelErrors& errors, const std::string& output)
{
    const auto found = errors.find(output);
    return found == errors.end() ? 0 : found->second;
}

// What a curve shows of nothing that changes: the temperature at the start, or no rise, no change.
double unchanged(const ModelledRun& run, const CurveOfRun& curve)
{
    return run.model->start_of(run.model->outputs()[curve.output]) - curve.start;
}

// Figures of measured - predicted.
void add_figures(FittedCurve& curve, double nothing)
{
    const auto count = static_cast<double>(curve.time.size());
    double square = 0, square_before = 0, square_nothing = 0, within = 0;
    for (std::size_t k = 0; k < curve.time.size(); ++k) {
        const double y = curve.measured[k];
        square += std::pow(y - curve.predicted[k], 2);
        square_before += std::pow(y - curve.before[k], 2);
        square_nothing += std::pow(y - nothing, 2);
        curve.bias += (y - curve.predicted[k]) / count;
        within += y >= curve.lower[k] && y <= curve.upper[k] ? 1 : 0;
    }
    curve.rms = std::sqrt(square / count);
    curve.rms_before = std::sqrt(square_before / count);
    curve.rms_nothing = std::sqrt(square_nothing / count);
    curve.inside = within / count;
}

}  // namespace

double quantile_of(double level) { return quantile(boost::math::normal(), 0.5 + 0.5 * level); }

double value_of(const FittedParameter& unknown, double theta) { return unknown.unit.empty() ? std::exp(theta) : theta; }

Knowledge knowledge_of(double shrinkage, bool model_differs)
{
    constexpr double well = 0.9, hardly = 0.2;
    if (shrinkage < hardly)
        return Knowledge::prior;
    if (model_differs)
        return Knowledge::if_model_right;
    return shrinkage < well ? Knowledge::partly : Knowledge::data;
}

std::vector<KnownCombination> as_data(const std::vector<calibration::Combination>& combinations, bool model_differs)
{
    const auto determined = model_differs ? Knowledge::if_model_right : Knowledge::data;
    std::vector<KnownCombination> result;
    for (const auto& from : combinations)
        result.push_back(
            {from.singular_value, from.by_data ? determined : Knowledge::prior, from.words, as_list(from.direction)});
    return result;
}

std::vector<FittedCurve> fitted_curves(const MeasuredRuns& runs, const calibration::Problem& problem, bool hold_out,
                                       const Fit& fit, const ModelErrors& errors, double level)
{
    const auto all = runs.curves(hold_out);
    if (all.empty())
        return {};
    const double wide = quantile_of(level);
    const auto before = problem.model(VectorXd::Zero(fit.theta.size()), false).value;
    const auto after = problem.model(fit.theta, true);
    const auto first = problem.starts();
    std::vector<FittedCurve> result;
    for (std::size_t c = 0; c < all.size(); ++c) {
        const auto& [run, curve] = all[c];
        const auto& measured = *curve->measured;
        const auto& noise = problem.curves[c].noise;
        const Index count = problem.curves[c].time.size();
        FittedCurve of;
        of.run = run->run->name;
        of.column = measured.column;
        of.output = measured.output;
        of.of_gap = measured.of_gap;
        of.hold_out = hold_out;
        of.time = measured.time;
        of.measured = measured.value;
        of.before = as_list(before.segment(first[c], count));
        of.predicted = as_list(after.value.segment(first[c], count));
        of.correlation_time = noise.correlation_time;
        of.model_error = error_of(errors, measured.output);
        const MatrixXd slope = after.jacobian.middleRows(first[c], count);
        const double other = noise.sigma * noise.sigma + noise.model_error * noise.model_error;
        for (Index k = 0; k < count; ++k) {
            const double by_theta = slope.row(k) * fit.covariance * slope.row(k).transpose();
            const double half = wide * std::sqrt(std::max(by_theta, 0.0) + other);
            of.lower.push_back(of.predicted[static_cast<std::size_t>(k)] - half);
            of.upper.push_back(of.predicted[static_cast<std::size_t>(k)] + half);
        }
        add_figures(of, unchanged(*run, *curve));
        result.push_back(std::move(of));
    }
    return result;
}

void add_mean_baseline(std::vector<FittedCurve>& curves)
{
    for (auto& curve : curves) {
        std::vector<const FittedCurve*> fitted;
        for (const auto& other : curves)
            if (!other.hold_out && other.output == curve.output && other.run != curve.run)
                fitted.push_back(&other);
        if (fitted.empty())
            continue;
        double square = 0;
        for (std::size_t k = 0; k < curve.time.size(); ++k) {
            double mean = 0;
            for (const auto* other : fitted)
                mean += value_at(other->time, other->measured, curve.time[k]) / static_cast<double>(fitted.size());
            square += std::pow(curve.measured[k] - mean, 2);
        }
        curve.rms_mean = std::sqrt(square / static_cast<double>(curve.time.size()));
    }
}

std::vector<PredictedRun> predicted_runs(const MeasuredRuns& runs, const Fit& fit, const ModelErrors& errors,
                                         double level)
{
    const double wide = quantile_of(level);
    std::vector<PredictedRun> result;
    for (const auto& run : runs.runs()) {
        PointObserver silent(runs.asked());
        const auto after = run.model->run(runs.theta_of_case(fit.theta), true, silent);
        const auto others = runs.differences(run, fit.theta, after);
        const auto before = run.model->run(std::vector<double>(runs.case_parameters(), 0.0), false, silent);
        PredictedRun of{run.run->name, run.run->hold_out, after.time, {}};
        for (std::size_t o = 0; o < run.model->outputs().size(); ++o) {
            const auto& output = run.model->outputs()[o];
            if (output.kind == ForwardOutput::Kind::corner)
                continue;
            PredictedCurve curve{output.name, output.kind == ForwardOutput::Kind::dimension, {}, {}, {}, {}};
            const double error = error_of(errors, output.name);
            for (std::size_t row = 0; row < after.time.size(); ++row) {
                curve.before.push_back(value_at(before.time, before.value[o], after.time[row]));
                VectorXd slope = VectorXd::Zero(fit.theta.size());  // no sensor: biases and lags do not act
                for (std::size_t k = 0; k < runs.case_parameters(); ++k)
                    slope[static_cast<Index>(k)] = after.derivative[k][o][row];
                for (std::size_t k = 0; k < others.size(); ++k)
                    slope[runs.first_alternative() + static_cast<Index>(k)] = others[k][o][row];
                const auto shares = static_cast<Index>(others.size());
                const double value = after.value[o][row] + slope.tail(shares).dot(fit.theta.tail(shares));
                const double half = wide * std::sqrt(std::max(slope.dot(fit.covariance * slope), 0.0) + error * error);
                curve.value.push_back(value);
                curve.lower.push_back(value - half);
                curve.upper.push_back(value + half);
            }
            of.curves.push_back(std::move(curve));
        }
        result.push_back(std::move(of));
    }
    return result;
}

std::pair<double, double> change_by_steps(const MeasuredRuns& runs, const ReducedPress& press, const Fit& fit)
{
    std::pair<double, double> result{0, 0};
    for (const auto& run : runs.runs()) {
        PointObserver silent(runs.asked());
        const ForwardModel controlled(run.model->input(), press, run.model->parameters());
        const auto theta = runs.theta_of_case(fit.theta);
        const auto with = controlled.run(theta, false, silent), without = run.model->run(theta, false, silent);
        for (const auto& curve : run.curves) {
            auto& largest = curve.measured->of_gap ? result.second : result.first;
            for (const double time : curve.measured->time)
                largest = std::max(largest, std::abs(value_at(with.time, with.value[curve.output], time) -
                                                     value_at(without.time, without.value[curve.output], time)));
        }
    }
    return result;
}

}  // namespace deadpoint::twin
