#include "deadpoint/twin/explore/optimise.hpp"

#include "deadpoint/calibration/curves.hpp"
#include "deadpoint/casefile/files/numbers.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/observer.hpp"
#include "deadpoint/press/loads/loads_cache.hpp"
#include "deadpoint/press/result/run_result.hpp"
#include "deadpoint/reduce/parallel/in_parallel.hpp"
#include "deadpoint/twin/explore/objectives.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <mutex>

namespace deadpoint::twin {
namespace {

using casefile::Objective;

constexpr std::size_t limit_times = 40;   // at which a limit of an output is checked
constexpr double temperature_size = 10;   // [K], and
constexpr double length_size = 1e-5;      // [m]: sizes by which limits are divided
constexpr double earliest = 0.4;          // share of the first time to warm that is not tried
constexpr double gain = 0.999;            // of the time to warm, below which a round has helped
constexpr int rounds = 5;                 // of lowering rates
constexpr std::size_t cached_loads = 60;  // 2 MB each for the shipped press

/// The variables of a profile, one speed for each interval.
std::vector<casefile::VariedKeys> profile_keys(const casefile::SpeedProfile& profile)
{
    std::vector<casefile::VariedKeys> result;
    for (std::size_t k = 0; k < profile.ends.size(); ++k) {
        casefile::VariedKeys keys;
        keys.name = fmt::format("speed {}", k + 1);
        keys.keys = {fmt::format("operation.{}.speed", static_cast<std::size_t>(profile.segment) + k)};
        keys.kind = casefile::VariedKeys::Kind::value;
        keys.low = profile.least;
        keys.high = profile.most;
        keys.dimension = Dimension::angular_velocity;
        result.push_back(std::move(keys));
    }
    return result;
}

std::vector<casefile::VariedKeys> variables_of(const casefile::OptimiseSection& section)
{
    auto result = section.speed_profile ? profile_keys(*section.speed_profile) : std::vector<casefile::VariedKeys>();
    result.insert(result.end(), section.variables.begin(), section.variables.end());
    return result;
}

/// Shares of the ranges at which the case itself lies, or the nearest ones.
design::Point shares_of_case(const casefile::Case& input, const std::vector<casefile::VariedKeys>& variables,
                             const std::vector<VariedRange>& ranges)
{
    const auto numbers = casefile::numbers_of(input);
    design::Point result;
    for (std::size_t k = 0; k < ranges.size(); ++k) {
        if (ranges[k].kind != VariedRange::Kind::value) {
            result.push_back(0.5);
            continue;
        }
        const auto found = std::ranges::find(numbers, variables[k].keys.front(), &casefile::CaseNumber::path);
        result.push_back(std::clamp(ranges[k].share_of(found->value), 0.0, 1.0));
    }
    return result;
}

casefile::Case warmer(casefile::Case input, double by)
{
    input.machine.ambient += by;
    for (auto& segment : input.operation)
        if (segment.ambient)
            segment.ambient->constant += by;
    return input;
}

// A probe or a dimension of a run; null for corners.
const std::vector<double>* series_of(const casefile::Case& input, const press::RunResult& run,
                                     const std::string& output)
{
    if (const auto probe = input.probes.find(output); probe != input.probes.end())
        return &run.thermal.probes[static_cast<std::size_t>(std::distance(input.probes.begin(), probe))].value;
    const auto& drift = *run.drift;
    for (const auto& [name, series] : {std::pair{"E_SW", &drift.gap},
                                       {"E_BG", &drift.bearing_to_ground},
                                       {"E_WG", &drift.table_to_ground},
                                       {"E_CS", &drift.crank_to_slide},
                                       {"E_BC", &drift.clearance}})
        if (output == name)
            return &series->value;
    return nullptr;
}

/// What a stage of the search makes least.
struct Stage {
    bool lower_rates = false;  ///< largest_rate() from a time on; else the objective of the study
    double from = 0;
    [[nodiscard]] std::string name() const
    {
        return lower_rates ? fmt::format("rates after {:.2f} h", from / 3600) : "objective";
    }
};

/// Looks for the optimum of a study.
class Optimise {
public:
    Optimise(const casefile::Case& input, const ReducedPress& press, const casefile::OptimiseSection& section,
             int threads, Observer& observer)
        : section_(section), threads_(threads), observer_(observer), variables_(variables_of(section)),
          base_(section.speed_profile ? divided(input, *section.speed_profile) : input), centred_(base_),
          varied_(varied_case(centred_, variables_)), loads_(cached_loads),
          model_(centred_, press, varied_.parameters, options())
    {
        if (section.objective() == Objective::ambient)
            for (const double by : {section.ambient_step, -section.ambient_step})
                ambient_.push_back(
                    std::make_unique<ForwardModel>(warmer(centred_, by), press, varied_.parameters, options()));
        for (const auto& limit : section.limits)
            limited_.push_back(output_named(limit.output));
        start_ = shares_of_case(base_, variables_, varied_.ranges);
    }

    std::optional<OptimiseResult> run()
    {
        result_.ranges = varied_.ranges;
        search_all();
        if (observer_.cancelled())
            return std::nullopt;
        choose();
        const auto& best = result_.starts[result_.best].minimum.at;
        std::tie(result_.before, result_.course_before) = figures_at(start_);
        std::tie(result_.after, result_.course_after) = figures_at(best);
        result_.optimum = with_parameters(centred_, varied_.parameters, thetas_at(varied_.ranges, best));
        result_.outside = model_.outside(thetas_at(varied_.ranges, best));
        return std::move(result_);
    }

private:
    ForwardOptions options() { return {section_.step, 1, &loads_}; }

    [[nodiscard]] std::size_t output_named(const std::string& name) const
    {
        const auto found = std::ranges::find(model_.outputs(), name, &ForwardOutput::name);
        if (found == model_.outputs().end())
            throw InputError(
                fmt::format("the model has no output '{}'\n  help: name a probe, a dimension or a corner", name));
        return static_cast<std::size_t>(found - model_.outputs().begin());
    }

    /// By shares instead of by theta.
    [[nodiscard]] std::vector<double> by_share(std::vector<double> slope, const design::Point& at) const
    {
        for (std::size_t k = 0; k < slope.size(); ++k)
            slope[k] *= varied_.ranges[k].theta_slope(at[k]);
        return slope;
    }

    [[nodiscard]] Judged objective(const GapCourse& course, const std::vector<double>& theta, bool derivatives) const
    {
        Observer silent;
        switch (section_.objective()) {
        case Objective::warm_up:
            return warm_time(course, section_.rate);
        case Objective::ambient:
            return ambient_effect(gap_course(*ambient_[0], ambient_[0]->run(theta, derivatives, silent)),
                                  gap_course(*ambient_[1], ambient_[1]->run(theta, derivatives, silent)),
                                  section_.ambient_step, section_.from);
        default:
            return drift_of(course, section_.from);
        }
    }

    [[nodiscard]] design::Evaluation evaluate(const design::Point& at, bool derivatives, const Stage& stage) const
    {
        Observer silent;
        const auto theta = thetas_at(varied_.ranges, at);
        const auto forecast = model_.run(theta, derivatives, silent);
        const auto course = gap_course(model_, forecast);
        const auto judged =
            stage.lower_rates ? largest_rate(course, section_.rate, stage.from) : objective(course, theta, derivatives);
        // Divided by its size at the start, so that one tolerance serves all objectives.
        design::Evaluation found{judged.value / size_of(stage), by_share(judged.slope, at), {}, {}};
        for (double& slope : found.slope)
            slope /= size_of(stage);
        add_output_limits(forecast, at, found);
        add_mean_speed(at, found);
        if (section_.warm_within) {
            const auto warm = warm_time(course, section_.rate);
            add_limit(warm.value / *section_.warm_within - 1, by_share(warm.slope, at), 1 / *section_.warm_within,
                      found);
        }
        return found;
    }

    [[nodiscard]] double size_of(const Stage& stage) const { return stage.lower_rates ? 1 : size_; }

    static void add_limit(double value, std::vector<double> slope, double factor, design::Evaluation& found)
    {
        for (double& one : slope)
            one *= factor;
        found.limits.push_back(value);
        found.slopes.push_back(std::move(slope));
    }

    void add_output_limits(const Forecast& forecast, const design::Point& at, design::Evaluation& found) const
    {
        for (std::size_t l = 0; l < section_.limits.size(); ++l) {
            const auto& limit = section_.limits[l];
            const auto weights = calibration::interpolation(forecast.time, times_of(limit));
            const auto at_times = [&](const std::vector<double>& values) -> Eigen::VectorXd {
                return weights *
                       Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
            };
            const auto value = at_times(forecast.value[limited_[l]]);
            std::vector<Eigen::VectorXd> slopes;
            for (const auto& by : forecast.derivative)
                slopes.push_back(at_times(by[limited_[l]]));
            for (Eigen::Index t = 0; t < value.size(); ++t)
                for (const auto& [end, sign] : {std::pair{limit.most_value, 1.0}, std::pair{limit.least_value, -1.0}}) {
                    if (!end)
                        continue;
                    std::vector<double> slope;
                    for (const auto& of : slopes)
                        slope.push_back(of[t]);
                    add_limit(sign * (value[t] - *end) / size_of_limit(l), by_share(std::move(slope), at),
                              sign / size_of_limit(l), found);
                }
        }
    }

    [[nodiscard]] double size_of_limit(std::size_t limit) const
    {
        return model_.outputs()[limited_[limit]].kind == ForwardOutput::Kind::probe ? temperature_size : length_size;
    }

    [[nodiscard]] std::vector<double> times_of(const casefile::OptimiseLimit& limit) const
    {
        std::vector<double> times;
        for (std::size_t k = 1; k <= limit_times; ++k)
            times.push_back(limit.from + (model_.end() - limit.from) * static_cast<double>(k) / limit_times);
        return times;
    }

    void add_mean_speed(const design::Point& at, design::Evaluation& found) const
    {
        if (!section_.speed_profile || !section_.speed_profile->least_mean)
            return;
        const auto& profile = *section_.speed_profile;
        double mean = 0, begin = 0;
        std::vector<double> slope(at.size(), 0.0);
        for (std::size_t k = 0; k < profile.ends.size(); ++k) {
            const double share = (profile.ends[k] - begin) / profile.ends.back();
            mean += share * varied_.ranges[k].value_at(at[k]);
            slope[k] = -share * (profile.most - profile.least) / *profile.least_mean;
            begin = profile.ends[k];
        }
        add_limit(1 - mean / *profile.least_mean, std::move(slope), 1, found);
    }

    [[nodiscard]] design::Minimum minimise(const design::Point& from, const Stage& stage) const
    {
        const design::MinimiseProblem problem{
            at_size(), limits_, [&](const design::Point& at, bool wanted) { return evaluate(at, wanted, stage); },
            [&] { return observer_.cancelled(); }};
        design::MinimiseOptions how;
        how.method = section_.method() == casefile::Optimiser::ccsa     ? design::MinimiseMethod::ccsa
                     : section_.method() == casefile::Optimiser::cobyla ? design::MinimiseMethod::cobyla
                                                                        : design::MinimiseMethod::slsqp;
        how.most_evaluations = section_.evaluations;
        return design::minimise(problem, from, how);
    }

    [[nodiscard]] std::size_t at_size() const { return varied_.ranges.size(); }

    static void append(DesignStart& to, const design::Minimum& stage, const std::string& name)
    {
        to.minimum.steps.insert(to.minimum.steps.end(), stage.steps.begin(), stage.steps.end());
        to.stages.insert(to.stages.end(), stage.steps.size(), name);
    }

    static bool better(const design::Minimum& one, const design::Minimum& other)
    {
        return one.feasible != other.feasible ? one.feasible : one.value < other.value;
    }

    /// From a start to the objective's minimum.
    ///
    /// The time to warm jumps where another part of the course becomes the last one above the rate. Rates are therefore
    /// also lowered from a time on, and the time to warm is made least from there. That time lies half way between the
    /// best time to warm and one before which it could not be brought.
    [[nodiscard]] DesignStart search(const design::Point& start) const
    {
        DesignStart found{start, minimise(start, {}), {}};
        found.stages.assign(found.minimum.steps.size(), Stage().name());
        if (section_.objective() != Objective::warm_up)
            return found;
        auto from = found.minimum.at;
        double not_before = earliest * std::min(found.minimum.value * size_, model_.end());
        for (int round = 0; round < rounds && !observer_.cancelled(); ++round) {
            const Stage lower{true, 0.5 * (not_before + std::min(found.minimum.value * size_, model_.end()))};
            const auto lowered = minimise(from, lower);
            append(found, lowered, lower.name());
            from = lowered.at;
            auto again = minimise(from, {});
            append(found, again, Stage().name());
            const bool gained = again.feasible != found.minimum.feasible || again.value < gain * found.minimum.value;
            if (better(again, found.minimum) && gained) {
                again.steps = std::move(found.minimum.steps);
                found.minimum = std::move(again);
            } else {
                not_before = lower.from;
            }
        }
        return found;
    }

    void search_all()
    {
        const auto first = evaluate(start_, false, {});
        size_ = std::abs(first.value) > 0 ? std::abs(first.value) : 1;
        limits_ = first.limits.size();
        std::vector<design::Point> points{start_};
        if (section_.starts > 1)
            for (auto& point : design::sobol_points(at_size(), static_cast<std::size_t>(section_.starts) - 1,
                                                    static_cast<unsigned>(section_.seed)))
                points.push_back(std::move(point));
        result_.starts.resize(points.size());
        observer_.stage("searches");
        std::size_t done = 0;
        reduce::in_parallel(threads_, points.size(), [&](std::size_t k) {
            auto found = search(points[k]);
            found.minimum.value *= size_;
            for (std::size_t s = 0; s < found.minimum.steps.size(); ++s)
                found.minimum.steps[s].value *= found.stages[s] == Stage().name() ? size_ : 1;
            result_.starts[k] = std::move(found);
            const std::lock_guard lock(mutex_);
            ++done;
            observer_.progress(static_cast<double>(done) / static_cast<double>(points.size()),
                               fmt::format("{} of {} starts", done, points.size()));
        });
    }

    void choose()
    {
        std::vector<const design::Point*> different;
        for (std::size_t k = 0; k < result_.starts.size(); ++k) {
            const auto& minimum = result_.starts[k].minimum;
            if (better(minimum, result_.starts[result_.best].minimum))
                result_.best = k;
            const auto same = [&](const design::Point* other) {
                return std::ranges::equal(*other, minimum.at,
                                          [](double a, double b) { return std::abs(a - b) <= same_minimum; });
            };
            if (std::ranges::none_of(different, same))
                different.push_back(&minimum.at);
        }
        result_.minima = different.size();
        result_.feasible = result_.starts[result_.best].minimum.feasible;
    }

    [[nodiscard]] std::pair<DesignFigures, DesignCourse> figures_at(const design::Point& at) const
    {
        Observer silent;
        const auto theta = thetas_at(varied_.ranges, at);
        const auto forecast = model_.run(theta, false, silent);
        const auto course = gap_course(model_, forecast);
        auto figures = figures_of_course(course, section_);
        if (section_.objective() == Objective::ambient)
            figures.ambient = objective(course, theta, false).value;
        for (std::size_t l = 0; l < section_.limits.size(); ++l)
            figures.extremes.push_back(extreme(forecast.time, forecast.value[limited_[l]], section_.limits[l]));
        return {figures, {course.time, course.value}};
    }

public:
    static DesignFigures figures_of_course(const GapCourse& course, const casefile::OptimiseSection& section)
    {
        DesignFigures figures;
        figures.drift = drift_of(course, section.from).value;
        const auto start = std::ranges::lower_bound(course.time, section.from) - course.time.begin();
        for (auto row = static_cast<std::size_t>(start); row < course.time.size(); ++row)
            figures.largest_change = std::max(
                figures.largest_change, std::abs(course.value[row] - course.value[static_cast<std::size_t>(start)]));
        if (section.rate > 0)
            if (const double warm = warm_time(course, section.rate).value; warm < course.time.back())
                figures.warm = warm;
        return figures;
    }

    /// The value of a course that is nearest to its limit, or farthest beyond it.
    static double extreme(const std::vector<double>& time, const std::vector<double>& value,
                          const casefile::OptimiseLimit& limit)
    {
        double found = value.back(), nearest = -HUGE_VAL;
        for (std::size_t row = 0; row < time.size(); ++row) {
            if (time[row] < limit.from)
                continue;
            const double over = std::max(limit.most_value ? value[row] - *limit.most_value : -HUGE_VAL,
                                         limit.least_value ? *limit.least_value - value[row] : -HUGE_VAL);
            if (over > nearest) {
                nearest = over;
                found = value[row];
            }
        }
        return found;
    }

private:
    const casefile::OptimiseSection& section_;
    int threads_;
    Observer& observer_;
    std::vector<casefile::VariedKeys> variables_;
    casefile::Case base_, centred_;  ///< with its segment divided; the same with ranges at their centres
    VariedCase varied_;
    press::LoadsCache loads_;
    ForwardModel model_;
    std::vector<std::unique_ptr<ForwardModel>> ambient_;  ///< with a warmer and a colder room
    std::vector<std::size_t> limited_;                    ///< output of each limit
    design::Point start_;
    double size_ = 1;  ///< of the objective at the start
    std::size_t limits_ = 0;
    OptimiseResult result_;
    std::mutex mutex_;
};

}  // namespace

casefile::Case divided(casefile::Case input, const casefile::SpeedProfile& profile)
{
    const auto place = static_cast<std::size_t>(profile.segment);
    const auto whole = input.operation.at(place);
    std::vector<casefile::Segment> pieces;
    double begin = 0;
    for (const double end : profile.ends) {
        auto piece = whole;
        piece.name = fmt::format("{}_{}", whole.name.empty() ? "interval" : whole.name, pieces.size() + 1);
        piece.duration = end - begin;
        pieces.push_back(std::move(piece));
        begin = end;
    }
    input.operation[place].duration -= begin;
    input.operation.insert(input.operation.begin() + static_cast<std::ptrdiff_t>(place), pieces.begin(), pieces.end());
    return input;
}

std::optional<OptimiseResult> run_optimise(const casefile::Case& input, const ReducedPress& press,
                                           const casefile::OptimiseSection& section, int threads, Observer& observer)
{
    return Optimise(input, press, section, threads, observer).run();
}

FullDesign full_design(const casefile::Case& input, const press::RunResult& run,
                       const casefile::OptimiseSection& section)
{
    const auto& drift = *run.drift;
    GapCourse course;
    for (std::size_t row = 0; row < drift.time.size(); ++row)
        if (course.time.empty() || drift.time[row] > course.time.back()) {
            course.time.push_back(drift.time[row]);
            course.value.push_back(drift.gap.value[row]);
        }
    FullDesign full{Optimise::figures_of_course(course, section), {course.time, course.value}};
    for (const auto& limit : section.limits) {
        const auto* values = series_of(input, run, limit.output);
        full.figures.extremes.push_back(values ? Optimise::extreme(drift.time, *values, limit)
                                               : std::numeric_limits<double>::quiet_NaN());
    }
    return full;
}

}  // namespace deadpoint::twin
