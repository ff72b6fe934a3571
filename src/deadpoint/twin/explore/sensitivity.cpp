#include "deadpoint/twin/explore/sensitivity.hpp"

#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/core/mistakes.hpp"
#include "deadpoint/core/names/pattern.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/observer.hpp"
#include "deadpoint/reduce/parallel/in_parallel.hpp"
#include "deadpoint/twin/calibrate/forward.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <limits>
#include <mutex>
#include <set>

namespace deadpoint::twin {
namespace {

constexpr double missing = std::numeric_limits<double>::quiet_NaN();
constexpr double most_values = 1e8;  // of all figures at all points, 8 bytes each
constexpr double most_failed = 0.1;  // share of the points
constexpr design::Bootstrap figure_bands{300, 0.9, 1};
constexpr design::Bootstrap course_bands{100, 0.9, 1};

std::vector<std::size_t> chosen_outputs(const std::vector<ForwardOutput>& all, std::vector<std::string> wanted)
{
    std::vector<std::size_t> result;
    for (std::size_t k = 0; k < all.size(); ++k) {
        const bool by_default = all[k].name == "E_SW" || all[k].kind == ForwardOutput::Kind::probe;
        const bool named =
            std::ranges::any_of(wanted, [&](const std::string& pattern) { return matches(pattern, all[k].name); });
        if (wanted.empty() ? by_default : named)
            result.push_back(k);
    }
    if (!result.empty())
        return result;
    std::vector<std::string> names;
    for (const auto& output : all)
        names.push_back(output.name);
    throw InputError(fmt::format("the model has no output {}\n  help: its outputs are {}", fmt::join(wanted, ", "),
                                 fmt::join(names, ", ")));
}

std::vector<Figure> figures_for(const std::vector<std::size_t>& outputs, const std::vector<double>& times)
{
    std::vector<Figure> result;
    for (const auto output : outputs) {
        for (const double time : times)
            result.push_back({Figure::Kind::at_time, output, time});
        result.push_back({Figure::Kind::end, output, 0});
        result.push_back({Figure::Kind::warm, output, 0});
    }
    return result;
}

std::vector<Figure> course_for(const std::vector<std::size_t>& outputs, int count, double end)
{
    std::vector<Figure> result;
    for (const auto output : outputs)
        for (int k = 1; k <= count; ++k)
            result.push_back({Figure::Kind::at_time, output, end * k / count});
    return result;
}

/// Runs points of a study, some at a time.
class Study {
public:
    Study(casefile::Case input, const ReducedPress& press, const casefile::SensitivitySection& section, int threads,
          Observer& observer)
        : section_(section), threads_(threads), observer_(observer), varied_(varied_case(input, section.parameters)),
          model_(std::move(input), press, varied_.parameters)
    {
        result_.ranges = varied_.ranges;
        result_.outputs = model_.outputs();
        result_.chosen = chosen_outputs(model_.outputs(), section.outputs);
        figures_ = figures_for(result_.chosen, section.times);
        own_ = figures_.size();
        const auto course = course_for(result_.chosen, section.course_times, model_.end());
        figures_.insert(figures_.end(), course.begin(), course.end());
    }

    std::optional<SensitivityResult> run()
    {
        find_outside();
        const bool done = section_.method() == casefile::SensitivityMethod::sobol ? run_sobol() : run_morris();
        if (!done)
            return std::nullopt;
        return std::move(result_);
    }

private:
    /// Both ends of each range, the others at their middle.
    void find_outside()
    {
        std::set<std::string> said;
        const std::vector<double> middle(varied_.ranges.size(), 0.5);
        for (std::size_t k = 0; k < middle.size(); ++k)
            for (const double end : {0.0, 1.0}) {
                auto shares = middle;
                shares[k] = end;
                for (const auto& text : model_.outside(thetas_at(varied_.ranges, shares)))
                    if (said.insert(text).second)
                        result_.outside.push_back(
                            fmt::format("{} at an end of its range: {}", varied_.ranges[k].name, text));
            }
    }

    void require_room(std::size_t points) const
    {
        const double count = static_cast<double>(points) * static_cast<double>(figures_.size());
        if (count > most_values)
            throw InputError(
                fmt::format("the design has {} points of {} figures, {:.1g} numbers in all; at most {:.0g} "
                            "are kept\n  help: take fewer points, fewer outputs or fewer course_times",
                            points, figures_.size(), count, most_values));
    }

    void compute(const design::Point& shares, double* values)
    {
        Observer silent;
        try {
            const auto forecast = model_.run(thetas_at(varied_.ranges, shares), false, silent);
            const auto found = figures_of(model_, forecast, figures_);
            for (std::size_t f = 0; f < found.size(); ++f)
                values[f] = found[f];
        } catch (const Error& error) {
            std::fill_n(values, figures_.size(), missing);
            const std::lock_guard lock(mutex_);
            if (result_.failed++ == 0)
                result_.failure = error.what();
        }
    }

    /// Values of all figures at all points, figure by figure; nothing if the user stopped it.
    template <class Design>
    std::optional<std::vector<std::vector<double>>> values_at(const Design& design)
    {
        require_room(design.size());
        const auto count = figures_.size();
        std::vector<double> all(design.size() * count);
        observer_.stage("points");
        std::size_t done = 0;
        reduce::in_parallel(threads_, design.size(), [&](std::size_t turn) {
            if (observer_.cancelled())
                return;
            const auto point = design.in_turn(turn);
            compute(design.point(point), &all[point * count]);
            const std::lock_guard lock(mutex_);
            ++done;
            observer_.progress(static_cast<double>(done) / static_cast<double>(design.size()),
                               fmt::format("{} of {} runs", done, design.size()));
        });
        if (observer_.cancelled())
            return std::nullopt;
        result_.runs = design.size();
        require_enough();
        keep_samples(design, all);
        std::vector<std::vector<double>> by_figure(count, std::vector<double>(design.size()));
        for (std::size_t point = 0; point < design.size(); ++point)
            for (std::size_t f = 0; f < count; ++f)
                by_figure[f][point] = all[point * count + f];
        return by_figure;
    }

    void require_enough() const
    {
        if (static_cast<double>(result_.failed) > most_failed * static_cast<double>(result_.runs))
            throw ConvergenceError(fmt::format("{} of {} runs failed, the first because: {}\n  help: make the ranges "
                                               "narrower",
                                               result_.failed, result_.runs, result_.failure));
    }

    template <class Design>
    void keep_samples(const Design& design, const std::vector<double>& all)
    {
        if (!section_.samples)
            return;
        for (std::size_t point = 0; point < design.size(); ++point) {
            const auto shares = design.point(point);
            auto& values = result_.points.emplace_back();
            for (std::size_t k = 0; k < shares.size(); ++k)
                values.push_back(varied_.ranges[k].value_at(shares[k]));
            const auto first = all.begin() + static_cast<std::ptrdiff_t>(point * figures_.size());
            result_.values.emplace_back(first, first + static_cast<std::ptrdiff_t>(own_));
        }
    }

    void give(std::size_t figure, FigureSensitivity found)
    {
        (figure < own_ ? result_.figures : result_.course)[figure < own_ ? figure : figure - own_] = std::move(found);
    }

    template <class Analyse>
    void analyse(Analyse&& analyse_one)
    {
        result_.figures.resize(own_);
        result_.course.resize(figures_.size() - own_);
        reduce::in_parallel(threads_, figures_.size(), [&](std::size_t f) { give(f, analyse_one(f)); });
    }

    bool run_sobol()
    {
        const auto inputs = varied_.ranges.size();
        const auto values = values_at(design::SobolDesign(inputs, static_cast<std::size_t>(section_.points),
                                                          static_cast<unsigned>(section_.seed)));
        if (!values)
            return false;
        analyse([&](std::size_t f) {
            const auto& bands = f < own_ ? figure_bands : course_bands;
            return FigureSensitivity{figures_[f], design::sobol_indices((*values)[f], inputs, bands), {}, {}};
        });
        return section_.gradients == 0 || add_bounds();
    }

    bool run_morris()
    {
        const design::MorrisDesign design(varied_.ranges.size(), static_cast<std::size_t>(section_.trajectories),
                                          static_cast<unsigned>(section_.seed));
        const auto values = values_at(design);
        if (!values)
            return false;
        analyse([&](std::size_t f) {
            const auto& bands = f < own_ ? figure_bands : course_bands;
            return FigureSensitivity{figures_[f], {}, design::morris_effects((*values)[f], design, bands), {}};
        });
        return true;
    }

    /// Bounds of the total indices from derivatives at further points.
    bool add_bounds()
    {
        const auto inputs = varied_.ranges.size();
        const auto points = design::sobol_points(inputs, static_cast<std::size_t>(section_.gradients),
                                                 static_cast<unsigned>(section_.seed) + 1);
        const std::vector<Figure> own(figures_.begin(), figures_.begin() + static_cast<std::ptrdiff_t>(own_));
        std::vector<std::vector<std::vector<double>>> slopes(points.size());
        observer_.stage("derivatives");
        reduce::in_parallel(threads_, points.size(), [&](std::size_t p) {
            if (observer_.cancelled())
                return;
            Observer silent;
            slopes[p] = figure_slopes(model_, model_.run(thetas_at(varied_.ranges, points[p]), true, silent), own);
            for (std::size_t k = 0; k < inputs; ++k)
                for (double& slope : slopes[p][k])
                    slope *= varied_.ranges[k].theta_slope(points[p][k]);
        });
        if (observer_.cancelled())
            return false;
        for (std::size_t f = 0; f < own_; ++f)
            for (std::size_t k = 0; k < inputs; ++k) {
                std::vector<double> of_figure;
                for (const auto& at_point : slopes)
                    of_figure.push_back(at_point[k][f]);
                result_.figures[f].bound.push_back(
                    design::total_index_bound(of_figure, result_.figures[f].sobol.variance));
            }
        return true;
    }

    const casefile::SensitivitySection& section_;
    int threads_;
    Observer& observer_;
    VariedCase varied_;
    ForwardModel model_;
    std::vector<Figure> figures_;  ///< those asked for, then those over time
    std::size_t own_ = 0;          ///< number of those asked for
    SensitivityResult result_;
    std::mutex mutex_;
};

}  // namespace

std::optional<SensitivityResult> run_sensitivity(casefile::Case input, const ReducedPress& press,
                                                 const casefile::SensitivitySection& section, int threads,
                                                 Observer& observer)
{
    return Study(std::move(input), press, section, threads, observer).run();
}

}  // namespace deadpoint::twin
