#include "deadpoint/twin/calibrate/measured_runs.hpp"

#include "deadpoint/calibration/curves.hpp"
#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/casefile/files/numbers.hpp"
#include "deadpoint/casefile/studies/calibration_file.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/reduce/parallel/in_parallel.hpp"
#include "deadpoint/twin/map/point_observer.hpp"
#include "deadpoint/twin/model/reduced_press.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace deadpoint::twin {

using calibration::Prediction;
using calibration::Problem;
using casefile::CalibrationRun;
using casefile::MeasuredCurve;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

constexpr double least_change_of_size = 0.1;  // of cells between meshes, relative; below it a difference shows nothing
constexpr double least_model_time = 600;      // [s], correlation time of the reduced model's error

VectorXd as_vector(const std::vector<double>& values)
{
    return Eigen::Map<const VectorXd>(values.data(), static_cast<Index>(values.size()));
}

/// How the sensor of a curve sees an output: with its lag, at the times of the values.
class Sensor {
public:
    Sensor(const CurveOfRun& curve, const std::vector<double>& rows, const VectorXd& theta)
        : rows_(rows), weights_(calibration::interpolation(rows, curve.measured->time)),
          constant_(curve.time_constant * (curve.lag >= 0 ? std::exp(theta[curve.lag]) : 1))
    {}
    [[nodiscard]] VectorXd shows(const VectorXd& values) const
    {
        return weights_ * (constant_ > 0 ? calibration::lagged(rows_, values, constant_).value : values);
    }
    [[nodiscard]] VectorXd by_log_constant(const VectorXd& values) const
    {
        return weights_ * calibration::lagged(rows_, values, constant_).by_log_constant;
    }

private:
    const std::vector<double>& rows_;
    MatrixXd weights_;
    double constant_;
};

/// What the sensor of a curve shows of an output with its derivatives by all unknowns.
struct Shown {
    VectorXd value;
    MatrixXd jacobian;
};

Shown shown(const CurveOfRun& curve, const Forecast& forecast, const VectorXd& theta, bool jacobian)
{
    const Sensor sensor(curve, forecast.time, theta);
    const VectorXd rows = as_vector(forecast.value[curve.output]);
    Shown result{sensor.shows(rows), MatrixXd()};
    result.value.array() += (curve.bias >= 0 ? theta[curve.bias] : 0) - curve.start;
    if (!jacobian)
        return result;
    result.jacobian = MatrixXd::Zero(result.value.size(), theta.size());
    for (std::size_t k = 0; k < forecast.derivative.size(); ++k)
        result.jacobian.col(static_cast<Index>(k)) = sensor.shows(as_vector(forecast.derivative[k][curve.output]));
    if (curve.bias >= 0)
        result.jacobian.col(curve.bias).setOnes();
    if (curve.lag >= 0)
        result.jacobian.col(curve.lag) = sensor.by_log_constant(rows);
    return result;
}

// Adds the alternatives, whose shares are unknowns from `first` on.
void add_shares(const ModelledRun& run, std::size_t curve, Index first, const VectorXd& theta, Shown& to)
{
    for (std::size_t k = 0; k < run.alternatives.size(); ++k) {
        const Index at = first + static_cast<Index>(k);
        const auto& difference = run.alternatives[k].difference[curve];
        to.value += theta[at] * difference;
        if (to.jacobian.size() > 0)
            to.jacobian.col(at) = difference;
    }
}

FittedParameter unknown_of_case(const casefile::CalibrationParameter& from)
{
    const bool factor = from.kind == casefile::CalibrationParameter::Kind::factor;
    FittedParameter result;
    result.name = from.name;
    result.kind = factor ? FittedParameter::Kind::factor : FittedParameter::Kind::shift;
    result.unit = factor ? "" : std::string(dimension_info(from.dimension).si_unit);
    result.place = from.place;
    result.prior = from.prior;
    return result;
}

std::string sensor_place(std::size_t sensor, const std::string& output) { return fmt::format("{}|{}", sensor, output); }

}  // namespace

double value_at(const std::vector<double>& x, const std::vector<double>& y, double at)
{
    const auto upper = std::ranges::upper_bound(x, at);
    if (upper == x.begin())
        return y.front();
    if (upper == x.end())
        return y.back();
    const auto k = static_cast<std::size_t>(upper - x.begin());
    const double s = (at - x[k - 1]) / (x[k] - x[k - 1]);
    return (1 - s) * y[k - 1] + s * y[k];
}

std::pair<double, double> stated_errors(const ReducedPress& press)
{
    std::pair<double, double> result{0, 0};
    for (const auto& error : press.errors)
        result = {std::max(result.first, error.temperature), std::max(result.second, error.gap)};
    return result;
}

MeasuredRuns::MeasuredRuns(const casefile::CalibrationFile& file, const ReducedPress& press, OtherPresses others,
                           int threads, const Observer& asked)
    : file_(file), press_(press), others_(std::move(others)), threads_(threads), asked_(asked)
{
    others_.resize(file.alternatives.size());
    std::tie(reduced_temperature_, reduced_gap_) = stated_errors(press);
    for (const auto& from : file.parameters) {
        const bool factor = from.kind == casefile::CalibrationParameter::Kind::factor;
        parameters_.push_back(
            {from.name, from.keys, factor ? CaseParameter::Kind::factor : CaseParameter::Kind::shift});
        unknowns_.push_back(unknown_of_case(from));
        calibration::Parameter prior{from.name, from.prior};
        if (from.least != 0 || from.most != 0) {
            prior.lower = from.least;
            prior.upper = from.most;
        }
        priors_.push_back(std::move(prior));
    }
    of_case_ = parameters_.size();
    add_sensor_unknowns();
    add_alternative_unknowns();
    for (const auto& run : file.runs)
        runs_.push_back(modelled(run));
}

void MeasuredRuns::add_alternative_unknowns()
{
    first_alternative_ = static_cast<Index>(unknowns_.size());
    for (const auto& alternative : file_.alternatives) {
        FittedParameter unknown;
        unknown.name = alternative.name;
        unknown.kind = FittedParameter::Kind::alternative;
        unknown.unit = "share";
        unknown.place = alternative.place;
        unknown.prior = 1;
        unknowns_.push_back(unknown);
        priors_.push_back({alternative.name, 1});
    }
}

void MeasuredRuns::add_sensor_unknowns()
{
    const auto add = [&](FittedParameter::Kind kind, const std::string& name, const std::string& place, double prior,
                         const char* unit) {
        if (unknown_of(kind, place) >= 0)
            return;
        FittedParameter unknown;
        unknown.name = name;
        unknown.kind = kind;
        unknown.unit = unit;
        unknown.place = place;
        unknown.prior = prior;
        unknowns_.push_back(unknown);
        priors_.push_back({name, prior});
    };
    for (const auto& run : file_.runs)
        for (const auto& curve : run.curves) {
            const auto& sensor = file_.sensors[curve.sensor];
            const auto place = sensor_place(curve.sensor, curve.output);
            if (sensor.bias_sigma > 0)
                add(FittedParameter::Kind::bias, "bias of " + curve.output, place, sensor.bias_sigma,
                    curve.of_gap ? "m" : "K");
            if (sensor.time_constant && sensor.time_constant_factor > 1)
                add(FittedParameter::Kind::lag, "lag of " + curve.output, place, std::log(sensor.time_constant_factor),
                    "");
        }
}

Index MeasuredRuns::unknown_of(FittedParameter::Kind kind, const std::string& place) const
{
    const auto found = std::ranges::find_if(
        unknowns_, [&](const auto& unknown) { return unknown.kind == kind && unknown.place == place; });
    return found == unknowns_.end() ? -1 : found - unknowns_.begin();
}

ModelledRun MeasuredRuns::modelled(const CalibrationRun& run) const
{
    ModelledRun result;
    result.run = &run;
    ForwardOptions options;
    options.fixed_step = file_.options.fixed_step;
    options.threads = threads_;
    try {
        result.model = std::make_unique<ForwardModel>(*run.input, press_, parameters_, options);
    } catch (const InputError& error) {
        throw InputError(fmt::format("the run '{}': {}", run.name, error.what()));
    }
    add_alternatives(result, options);
    for (const auto& curve : run.curves)
        add_curve(result, curve);
    take_differences(result, VectorXd::Zero(static_cast<Index>(priors_.size())));
    return result;
}

// Cell sizes of both meshes from their numbers of cells. With errors of first order, error(h) = h / (h' - h) times the
// difference.
double MeasuredRuns::share_of(std::size_t alternative) const
{
    const auto& of = file_.alternatives[alternative];
    const auto& other = others_[alternative];
    if (of.share > 0)
        return of.share;
    if (!other)
        return 1;
    const double ratio = std::cbrt(static_cast<double>(press_.cells) / static_cast<double>(other->cells));
    if (std::abs(ratio - 1) < least_change_of_size)
        throw InputError(
            fmt::format("{}: the alternative '{}' has nearly the same mesh ({} and {} cells), so that their "
                        "difference does not show the error of the mesh\n  help: build its model with "
                        "'deadpoint reduce --size' one and a half times as large, or state `share`",
                        of.place, of.name, other->cells, press_.cells));
    return 1 / std::abs(ratio - 1);
}

void MeasuredRuns::add_alternatives(ModelledRun& to, const ForwardOptions& options) const
{
    for (std::size_t k = 0; k < file_.alternatives.size(); ++k) {
        const auto& input = *to.run->alternatives.at(k);
        AlternativeRun alternative;
        alternative.share = share_of(k);
        std::vector<CaseParameter> known;
        const auto numbers = casefile::numbers_of(input);
        for (std::size_t p = 0; p < of_case_; ++p) {
            auto parameter = parameters_[p];
            std::erase_if(parameter.keys, [&](const auto& key) {
                return std::ranges::find(numbers, key, &casefile::CaseNumber::path) == numbers.end();
            });
            if (parameter.keys.empty())
                continue;
            known.push_back(std::move(parameter));
            alternative.unknowns.push_back(p);
        }
        const auto& press = others_[k] ? *others_[k] : press_;
        try {
            alternative.model = std::make_unique<ForwardModel>(input, press, std::move(known), options);
        } catch (const InputError& error) {
            throw InputError(fmt::format("{}: the alternative '{}': {}", file_.alternatives[k].place,
                                         file_.alternatives[k].name, error.what()));
        }
        to.alternatives.push_back(std::move(alternative));
    }
}

std::vector<Differences> MeasuredRuns::differences(const ModelledRun& run, const VectorXd& theta,
                                                   const Forecast& own) const
{
    std::vector<Differences> result;
    for (const auto& alternative : run.alternatives) {
        std::vector<double> known;
        for (const auto k : alternative.unknowns)
            known.push_back(theta[static_cast<Index>(k)]);
        PointObserver silent(asked_);
        const auto other = alternative.model->run(known, false, silent);
        auto& of = result.emplace_back();
        for (std::size_t o = 0; o < own.value.size(); ++o) {
            auto& rows = of.emplace_back(own.value[o]);
            for (std::size_t row = 0; row < rows.size(); ++row)
                rows[row] = alternative.share * (value_at(other.time, other.value[o], own.time[row]) - rows[row]);
        }
    }
    return result;
}

void MeasuredRuns::take_differences(ModelledRun& of, const VectorXd& theta) const
{
    if (of.alternatives.empty())
        return;
    PointObserver silent(asked_);
    const auto own = of.model->run(theta_of_case(theta), false, silent);
    const auto all = differences(of, theta, own);
    for (std::size_t k = 0; k < all.size(); ++k) {
        of.alternatives[k].difference.clear();
        for (const auto& curve : of.curves)
            of.alternatives[k].difference.push_back(
                Sensor(curve, own.time, theta).shows(as_vector(all[k][curve.output])));
    }
}

void MeasuredRuns::turn_to(const VectorXd& theta)
{
    for (auto& run : runs_)
        take_differences(run, theta);
}

void MeasuredRuns::add_curve(ModelledRun& to, const MeasuredCurve& measured) const
{
    const auto& outputs = to.model->outputs();
    const auto found = std::ranges::find(outputs, measured.output, &ForwardOutput::name);
    if (found == outputs.end())
        throw InputError(fmt::format("the reduced model has no '{}'\n  help: build it again with 'deadpoint reduce'",
                                     measured.output));
    const auto& sensor = file_.sensors[measured.sensor];
    const auto place = sensor_place(measured.sensor, measured.output);
    CurveOfRun curve;
    curve.measured = &measured;
    curve.output = static_cast<std::size_t>(found - outputs.begin());
    curve.bias = unknown_of(FittedParameter::Kind::bias, place);
    curve.lag = unknown_of(FittedParameter::Kind::lag, place);
    curve.time_constant = sensor.time_constant.value_or(0);
    curve.start = measured.rise ? to.model->start_of(*found) : 0;
    to.curves.push_back(curve);
}

Problem MeasuredRuns::problem_of(std::vector<const ModelledRun*> runs, double coarser) const
{
    Problem result;
    result.parameters = priors_;
    for (const auto* run : runs)
        for (const auto& curve : run->curves) {
            const auto& measured = *curve.measured;
            const auto& sensor = file_.sensors[measured.sensor];
            calibration::Curve of{fmt::format("{} in {}", measured.output, run->run->name),
                                  as_vector(measured.time),
                                  as_vector(measured.value),
                                  {sensor.sigma, sensor.correlation_time, 0, least_model_time}};
            // The largest error that the build found counts as two standard deviations.
            of.noise.model_error =
                std::hypot(0.5 * (measured.of_gap ? reduced_gap_ : reduced_temperature_), sensor.model_sigma);
            of.noise.model_time = std::max(least_model_time, run->model->end() / 3);
            if (measured.value.empty())  // planned
                of.measured = VectorXd::Zero(of.time.size());
            result.curves.push_back(std::move(of));
        }
    result.model = [this, coarser, all = std::move(runs)](const VectorXd& theta, bool jacobian) {
        return predict(all, theta, jacobian, coarser);
    };
    return result;
}

Problem MeasuredRuns::problem_of(const ModelledRun& run) const
{
    return problem_of(std::vector<const ModelledRun*>{&run}, 1);
}

Problem MeasuredRuns::problem(bool hold_out, double coarser) const
{
    std::vector<const ModelledRun*> wanted;
    for (const auto& run : runs_)
        if (run.run->hold_out == hold_out && !run.curves.empty())
            wanted.push_back(&run);
    return problem_of(std::move(wanted), coarser);
}

std::vector<std::pair<const ModelledRun*, const CurveOfRun*>> MeasuredRuns::curves(bool hold_out) const
{
    std::vector<std::pair<const ModelledRun*, const CurveOfRun*>> result;
    for (const auto& run : runs_)
        if (run.run->hold_out == hold_out)
            for (const auto& curve : run.curves)
                result.emplace_back(&run, &curve);
    return result;
}

std::vector<double> MeasuredRuns::theta_of_case(const VectorXd& theta) const
{
    return {theta.data(), theta.data() + of_case_};
}

Prediction MeasuredRuns::predict(const std::vector<const ModelledRun*>& runs, const VectorXd& theta, bool jacobian,
                                 double coarser) const
{
    std::vector<std::vector<Shown>> parts(runs.size());
    const auto of_case = theta_of_case(theta);
    reduce::in_parallel(threads_, runs.size(), [&](std::size_t r) {
        PointObserver silent(asked_);
        const auto forecast = runs[r]->model->run(of_case, jacobian, silent, coarser);
        for (std::size_t c = 0; c < runs[r]->curves.size(); ++c) {
            parts[r].push_back(shown(runs[r]->curves[c], forecast, theta, jacobian));
            add_shares(*runs[r], c, first_alternative_, theta, parts[r].back());
        }
    });
    Index count = 0;
    for (const auto& run : parts)
        for (const auto& part : run)
            count += part.value.size();
    Prediction result{VectorXd(count), MatrixXd(jacobian ? count : 0, jacobian ? theta.size() : 0)};
    Index at = 0;
    for (const auto& run : parts)
        for (const auto& part : run) {
            result.value.segment(at, part.value.size()) = part.value;
            if (jacobian)
                result.jacobian.middleRows(at, part.value.size()) = part.jacobian;
            at += part.value.size();
        }
    return result;
}

}  // namespace deadpoint::twin
