#include "deadpoint/twin/calibrate/calibrate.hpp"

#include "deadpoint/calibration/course.hpp"
#include "deadpoint/calibration/discrepancy.hpp"
#include "deadpoint/calibration/sample.hpp"
#include "deadpoint/calibration/surrogate.hpp"
#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/casefile/files/numbers.hpp"
#include "deadpoint/casefile/files/write.hpp"
#include "deadpoint/casefile/studies/calibration_file.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/observer.hpp"
#include "deadpoint/twin/calibrate/calibration_figures.hpp"
#include "deadpoint/twin/model/reduced_press.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <fmt/format.h>

namespace deadpoint::twin {

using calibration::Fit;
using calibration::Problem;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

constexpr double no_influence = 1e-6;  // standard deviations of noise per one of the prior
constexpr Index few_values = 5;        // a curve with fewer shows no course
constexpr double far_from_prior = 3;   // standard deviations
constexpr double coarser_search = 5;   // factor on time steps while minima are sought
constexpr int most_refits = 4;
constexpr double significant_probability = 0.05;

/// The fit with all that follows from it.
class Calibrating {
public:
    Calibrating(const casefile::CalibrationFile& file, const ReducedPress& press, const OtherPresses& others,
                int threads, Observer& observer)
        : file_(file), press_(press), observer_(observer), runs_(file, press, others, threads, observer),
          problem_(runs_.problem(false))
    {}

    Calibration run()
    {
        begin();
        observer_.stage("fit");
        const auto start = std::chrono::steady_clock::now();
        fit_all();
        turn_alternatives();
        correct_correlation();
        correct_model();
        result_.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        observer_.stage("intervals");
        take_parameters();
        observer_.stage("predictions");
        take_curves();
        if (file_.options.samples > 0)
            draw();
        find_warnings();
        return std::move(result_);
    }

private:
    void begin()
    {
        result_.name = file_.name;
        result_.note = file_.note;
        result_.level = file_.options.level;
        result_.notes = file_.notes;
        result_.starts = 1 + static_cast<std::size_t>(file_.options.starts);
        std::tie(result_.reduced_temperature, result_.reduced_gap) = stated_errors(press_);
        result_.parameters = runs_.unknowns();
        observer_.stage("what the data can tell");
        const auto at = problem_.model(VectorXd::Zero(size()), true);
        const auto white = calibration::whiten(problem_, at);
        result_.cost_before = calibration::cost(problem_, white, VectorXd::Zero(size()));
        const auto known = calibration::identify(problem_.parameters, white.jacobian);
        require_influence(known);
        before_ = known.combinations;
        for (Index k = 0; k < size(); ++k)
            of(k).expected = known.shrinkage[k];
    }

    [[nodiscard]] Index size() const { return static_cast<Index>(problem_.parameters.size()); }
    FittedParameter& of(Index k) { return result_.parameters[static_cast<std::size_t>(k)]; }

    void require_influence(const calibration::Identifiability& known) const
    {
        for (Index k = 0; k < size(); ++k) {
            const auto& parameter = result_.parameters[static_cast<std::size_t>(k)];
            if (known.influence[k] < no_influence && parameter.kind == FittedParameter::Kind::alternative)
                throw InputError(
                    fmt::format("{}: the alternative '{}' changes no measured value\n  help: remove it, or "
                                "correct its `set` or `reduced`",
                                parameter.place, parameter.name));
            if (known.influence[k] < no_influence)
                throw InputError(fmt::format("{}: the parameter '{}' has no influence on any measured value\n  help: "
                                             "remove it, correct its keys, or measure what depends on it (--plan says "
                                             "what)",
                                             parameter.place, parameter.name));
        }
    }

    // ---------------------------------------------------------------- fits

    void fit_all()
    {
        auto fits = calibration::fit_from_many(problem_, runs_.problem(false, coarser_search), file_.options.starts);
        for (const auto& other : calibration::other_minima(fits))
            note_minimum(fits.front(), other);
        result_.evaluations += fits.front().evaluations;
        fit_ = std::move(fits.front());
    }

    void note_minimum(const Fit& best, const Fit& other)
    {
        std::vector<double> values;
        for (Index k = 0; k < size(); ++k)
            values.push_back(value_of(of(k), other.theta[k]));
        result_.other_minima.emplace_back(other.cost - best.cost, std::move(values));
    }

    void refit()
    {
        fit_ = calibration::fit(problem_, fit_.theta);
        result_.evaluations += fit_.evaluations;
    }

    // Their differences are those at the fit.
    void turn_alternatives()
    {
        if (file_.alternatives.empty())
            return;
        runs_.turn_to(fit_.theta);
        refit();
    }

    [[nodiscard]] VectorXd residual(std::size_t curve) const
    {
        const auto first = problem_.starts();
        const auto count = problem_.curves[curve].time.size();
        return problem_.curves[curve].measured - fit_.prediction.value.segment(first[curve], count);
    }

    void correct_correlation()
    {
        const auto curves = runs_.curves(false);
        bool changed = false;
        for (std::size_t c = 0; c < curves.size(); ++c) {
            auto& curve = problem_.curves[c];
            if (!file_.sensors[curves[c].second->measured->sensor].estimate_correlation ||
                curve.time.size() < few_values)
                continue;
            // What stays for longer than a tenth of the run is no noise, but the model or a bias.
            const double longest = (curve.time[curve.time.size() - 1] - curve.time[0]) / 10;
            curve.noise = calibration::with_estimated_correlation(curve.noise, curve.time, residual(c), longest);
            changed = true;
        }
        if (changed)
            refit();
    }

    // Adds what the model is off to the noise, if the residuals are unlike the stated errors.
    void correct_model()
    {
        const auto test = calibration::test_model(problem_, fit_.prediction);
        tests_ = test.curves;
        group_curves();
        auto courses = find_courses();
        result_.model_probability =
            courses.empty() ? test.probability
                            : std::min(1.0, 2 * std::min(test.probability, calibration::course_probability(courses)));
        result_.model_differs = result_.model_probability < significant_probability;
        if (!result_.model_differs)
            return;
        const auto stated = problem_.curves;
        for (int k = 0; k < most_refits; ++k) {
            take_model_errors(courses);
            for (std::size_t c = 0; c < stated.size(); ++c) {
                auto& noise = problem_.curves[c].noise;
                const double rom = stated[c].noise.model_error, more = errors_[output(c)];
                noise.model_error = std::hypot(rom, more);
                noise.model_time = std::max(stated[c].noise.model_time, times_[output(c)]);
            }
            refit();
            auto with = problem_.curves;
            problem_.curves = stated;
            courses = find_courses();
            problem_.curves = std::move(with);
        }
    }

    // Curves of an output share their course; too few values show none.
    void group_curves()
    {
        for (std::size_t c = 0; c < problem_.curves.size(); ++c) {
            const auto known = std::ranges::find(outputs_, output(c));
            const bool has_course = problem_.curves[c].time.size() >= few_values;
            if (has_course && known == outputs_.end())
                outputs_.push_back(output(c));
        }
        for (std::size_t c = 0; c < problem_.curves.size(); ++c)
            groups_.push_back(problem_.curves[c].time.size() >= few_values
                                  ? static_cast<std::size_t>(std::ranges::find(outputs_, output(c)) - outputs_.begin())
                                  : outputs_.size());
    }

    [[nodiscard]] std::vector<calibration::Course> find_courses() const
    {
        return calibration::find_courses(problem_, fit_.prediction, fit_.theta, groups_, outputs_.size());
    }

    [[nodiscard]] const std::string& output(std::size_t curve) const
    {
        return runs_.curves(false)[curve].second->measured->output;
    }

    // By output its course; for values without a course what all of them need together.
    void take_model_errors(const std::vector<calibration::Course>& courses)
    {
        errors_.clear();
        for (std::size_t g = 0; g < outputs_.size(); ++g) {
            errors_[outputs_[g]] = courses[g].amplitude;
            times_[outputs_[g]] = courses[g].time;
        }
        for (const bool gap : {false, true}) {
            const double common = common_error(gap);
            for (std::size_t c = 0; c < problem_.curves.size(); ++c)
                if (problem_.curves[c].time.size() < few_values && is_gap(c) == gap)
                    errors_[output(c)] = std::max(errors_[output(c)], common);
        }
    }

    [[nodiscard]] bool is_gap(std::size_t curve) const { return runs_.curves(false)[curve].second->measured->of_gap; }

    // m with sum r^2 = (n - p) m^2 + sum sigma^2: of n values that determine p combinations of unknowns.
    [[nodiscard]] double common_error(bool gap) const
    {
        double squares = 0, noise = 0, count = 0;
        for (std::size_t c = 0; c < problem_.curves.size(); ++c) {
            const auto& curve = problem_.curves[c];
            if (curve.time.size() >= few_values || is_gap(c) != gap)
                continue;
            squares += residual(c).squaredNorm();
            count += static_cast<double>(curve.time.size());
            noise += static_cast<double>(curve.time.size()) * curve.noise.sigma * curve.noise.sigma;
        }
        const auto known = calibration::identify(problem_.parameters, fit_.white.jacobian);
        const double all = static_cast<double>(problem_.starts().back());
        const double used = known.shrinkage.sum() * count / all;
        return count > used + 0.5 ? std::sqrt(std::max(squares - noise, 0.0) / (count - used)) : 0;
    }

    // ---------------------------------------------------------------- figures

    void take_parameters()
    {
        const auto known = calibration::identify(problem_.parameters, fit_.white.jacobian);
        result_.before = as_data(before_, result_.model_differs);
        result_.after = as_data(known.combinations, result_.model_differs);
        result_.cost = fit_.cost;
        result_.converged = fit_.converged;
        const double wide = quantile_of(file_.options.level);
        for (Index k = 0; k < size(); ++k) {
            auto& p = of(k);
            p.theta = fit_.theta[k];
            p.deviation = std::sqrt(fit_.covariance(k, k));
            p.estimate = value_of(p, p.theta);
            p.lower = value_of(p, p.theta - wide * p.deviation);
            p.upper = value_of(p, p.theta + wide * p.deviation);
            p.prior_lower = value_of(p, -wide * p.prior);
            p.prior_upper = value_of(p, wide * p.prior);
            p.at_limit = fit_.at_limit[static_cast<std::size_t>(k)];
            p.shrinkage = known.shrinkage[k];
            p.known = knowledge_of(p.shrinkage, result_.model_differs);
            p.influence = known.influence[k];
            if (file_.options.profiles && static_cast<std::size_t>(k) < runs_.case_parameters())
                take_profile(k);
        }
        take_correlation();
        take_values();
    }

    void take_profile(Index k)
    {
        auto& p = of(k);
        observer_.progress(static_cast<double>(k) / static_cast<double>(runs_.case_parameters()), p.name);
        const double wide = quantile_of(file_.options.level);
        const auto found = calibration::profile(problem_, fit_, static_cast<std::size_t>(k), 0.5 * wide * wide);
        p.by_profile = true;
        p.lower = value_of(p, found.lower);
        p.upper = value_of(p, found.upper);
        p.open_below = found.open_below;
        p.open_above = found.open_above;
        for (const auto& [theta, above] : found.points)
            p.profile.emplace_back(value_of(p, theta), above);
    }

    void take_correlation()
    {
        for (Index i = 0; i < size(); ++i) {
            auto& row = result_.correlation.emplace_back();
            for (Index j = 0; j < size(); ++j)
                row.push_back(fit_.covariance(i, j) / std::sqrt(fit_.covariance(i, i) * fit_.covariance(j, j)));
        }
    }

    void take_values()
    {
        const auto& model = *runs_.runs().front().model;
        const auto theta = runs_.theta_of_case(fit_.theta);
        result_.case_name = model.input().machine.name;
        result_.case_hash = casefile::case_hash(model.input());
        const auto after = with_parameters(model.input(), model.parameters(), theta);
        for (std::size_t k = 0; k < model.parameters().size(); ++k) {
            const auto& keys = model.parameters()[k].keys;
            const auto old_texts = casefile::texts_of(model.input(), keys), new_texts = casefile::texts_of(after, keys);
            for (const auto& key : keys)
                result_.parameters[k].values.push_back({key, old_texts.at(key), new_texts.at(key)});
        }
        result_.settings = settings_of(model.input(), model.parameters(), theta);
        for (const auto& run : runs_.runs())
            for (const auto& line : run.model->outside(theta))
                if (std::ranges::find(result_.outside, line) == result_.outside.end())
                    result_.outside.push_back(line);
    }

    void take_curves()
    {
        const double level = file_.options.level;
        result_.curves = fitted_curves(runs_, problem_, false, fit_, errors_, level);
        for (std::size_t c = 0; c < tests_.size(); ++c) {
            result_.curves[c].chi_square = tests_[c].chi_square;
            result_.curves[c].lag_one = tests_[c].lag_one;
            result_.curves[c].probability = tests_[c].probability;
        }
        auto held_out = runs_.problem(true);
        const auto curves = runs_.curves(true);
        for (std::size_t c = 0; c < curves.size(); ++c) {
            auto& noise = held_out.curves[c].noise;
            noise.model_error = std::hypot(noise.model_error, errors_[curves[c].second->measured->output]);
        }
        const auto more = fitted_curves(runs_, held_out, true, fit_, errors_, level);
        result_.curves.insert(result_.curves.end(), more.begin(), more.end());
        add_mean_baseline(result_.curves);
        result_.predictions = predicted_runs(runs_, fit_, errors_, level);
        std::tie(result_.step_temperature, result_.step_gap) = change_by_steps(runs_, press_, fit_);
    }

    void draw()
    {
        observer_.stage("samples");
        const calibration::Surrogate surrogate(problem_, fit_);
        PosteriorSamples samples;
        samples.surrogate_error = surrogate.checked_error(10);
        calibration::SampleOptions options;
        options.count = static_cast<std::size_t>(file_.options.samples);
        options.burn_in = options.count / 5;
        const auto found = calibration::sample([&](const VectorXd& theta) { return surrogate.log_density(theta); },
                                               fit_.theta, fit_.covariance, options);
        samples.accepted = found.accepted;
        for (Index s = 0; s < found.theta.cols(); ++s) {
            auto& row = samples.values.emplace_back();
            for (Index k = 0; k < size(); ++k)
                row.push_back(value_of(of(k), found.theta(k, s)));
        }
        for (Index k = 0; k < size(); ++k)
            samples.intervals.push_back(interval(samples.values, static_cast<std::size_t>(k)));
        result_.samples = std::move(samples);
    }

    [[nodiscard]] std::pair<double, double> interval(const std::vector<std::vector<double>>& rows, std::size_t k) const
    {
        std::vector<double> values;
        for (const auto& row : rows)
            values.push_back(row[k]);
        std::ranges::sort(values);
        const auto at = [&](double share) {
            return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
        };
        return {at(0.5 - 0.5 * file_.options.level), at(0.5 + 0.5 * file_.options.level)};
    }

    // ---------------------------------------------------------------- what the user must know

    void warn(std::string text)
    {
        observer_.warn(text);
        result_.warnings.push_back(std::move(text));
    }

    void find_warnings()
    {
        if (result_.model_differs)
            warn("the model and the stated errors do not explain the data: see the curves' model errors, by which "
                 "intervals and bands were widened; fitted values may stand in for what the model lacks");
        if (!result_.converged)
            warn("the fit did not converge in 40 steps; add starts, or narrow the limits");
        for (const auto& p : result_.parameters)
            warn_of(p);
        if (const auto others = result_.other_minima.size(); others > 0)
            warn(fmt::format(
                "{} starting points lead to {} other minim{}; the least cost of them is {:.3g} above that of the "
                "fit: the data allow both if that is below 2",
                result_.starts, others, others == 1 ? "um" : "a", result_.other_minima.front().first));
        if (!result_.outside.empty())
            warn(fmt::format("the reduced model was not built for the calibrated case: {} coefficient{} outside of its "
                             "range, such as {}; build it with wider ranges, or check the result with --full-run",
                             result_.outside.size(), result_.outside.size() == 1 ? "" : "s", result_.outside.front()));
        if (std::ranges::none_of(result_.after, [](const auto& c) { return c.known != Knowledge::prior; }))
            warn("the data determine no unknown: all values are those of the prior");
    }

    void warn_of(const FittedParameter& p)
    {
        if (p.at_limit)
            warn(fmt::format("{}: '{}' ends at its limit: the prior excludes what the data want; widen the limits if "
                             "such a value is possible",
                             p.place, p.name));
        else if (std::abs(p.theta) > far_from_prior * p.prior)
            warn(fmt::format("{}: '{}' ends {:.1f} standard deviations away from the case's value: the prior excludes "
                             "what the data want, or the model lacks something",
                             p.place, p.name, std::abs(p.theta) / p.prior));
    }

    const casefile::CalibrationFile& file_;
    const ReducedPress& press_;
    Observer& observer_;
    MeasuredRuns runs_;
    Problem problem_;
    Fit fit_;
    ModelErrors errors_;
    std::map<std::string, double> times_;
    std::vector<std::string> outputs_;  ///< with curves of enough values for a course
    std::vector<std::size_t> groups_;   ///< of each curve: place of its output there
    std::vector<calibration::CurveResidual> tests_;
    std::vector<calibration::Combination> before_;  ///< at the prior's centre
    Calibration result_;
};

}  // namespace

std::optional<Calibration> calibrate(const casefile::CalibrationFile& file, const ReducedPress& press,
                                     const OtherPresses& others, int threads, Observer& observer)
try {
    return Calibrating(file, press, others, threads, observer).run();
} catch (const Stopped&) {
    return std::nullopt;
}

}  // namespace deadpoint::twin
