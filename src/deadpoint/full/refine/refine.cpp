#include "deadpoint/full/refine/refine.hpp"

#include "deadpoint/core/stopwatch.hpp"
#include "deadpoint/core/units.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/full/refine/estimate.hpp"
#include "deadpoint/full/run/press.hpp"
#include "deadpoint/full/run/run.hpp"
#include "deadpoint/heat/tr_bdf2.hpp"
#include "deadpoint/observer.hpp"
#include "deadpoint/press/problem/heat.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <map>
#include <memory>
#include <string>

namespace deadpoint::full {
namespace {

using casefile::Accuracy;

constexpr double least_factor = 0.5;     // smallest factor on a part's size in one round
constexpr double aim = 0.5;              // target as a share of the tolerance, so that the change also falls below it
constexpr double confirming_step = 0.6;  // factor of the estimate in the confirming round
constexpr double blind_step = 0.8;       // factor of all sizes if the estimate shows nothing to refine
constexpr double share_of_time = 0.25;   // share of the tolerance by which halving the time steps may change the result
constexpr int time_rounds = 4;
constexpr int compared_times = 400;

std::vector<const Series*> figures(const press::RunResult& result, Accuracy::Of of)
{
    std::vector<const Series*> series;
    if (of == Accuracy::Of::gap)
        series.push_back(&result.drift->gap);
    else
        for (const auto& probe : result.probes)
            series.push_back(&probe.history);
    return series;
}

// Largest change of a figure over the time that both runs cover.
double largest_change(const press::RunResult& one, const press::RunResult& other, Accuracy::Of of)
{
    const auto first = figures(one, of), second = figures(other, of);
    const double end = std::min(one.thermal.time.back(), other.thermal.time.back());
    double largest = 0;
    for (std::size_t i = 0; i < first.size(); ++i)
        for (int k = 1; k <= compared_times; ++k) {
            const double time = end * k / compared_times;
            largest = std::max(largest, std::abs(interpolate(one.thermal.time, *first[i], time) -
                                                 interpolate(other.thermal.time, *second[i], time)));
        }
    return largest;
}

double final_value(const casefile::Case& input, const press::RunResult& result, Accuracy::Of of)
{
    if (of == Accuracy::Of::gap)
        return result.drift->gap.value.back();
    double largest = 0;
    for (const auto* series : figures(result, of)) {
        const double rise = series->value.back() - input.machine.initial_temperature;
        largest = std::abs(rise) > std::abs(largest) ? rise : largest;
    }
    return largest;
}

// The error of functionals falls with twice the order of the elements where the fields are smooth; at re-entrant
// corners, which all machines have, more slowly.
double convergence_order(int element_order) { return element_order == 1 ? 2 : 3; }

class Refinement {
public:
    Refinement(const casefile::Case& input, double size_scale, Observer& observer)
        : input_(input), observer_(observer), wanted_(*casefile::wanted_accuracy(input)), press_(input)
    {
        report_.wanted = wanted_;
        for (auto& [name, part] : input_.parts) {
            part.size = size_scale * part.size.value_or(input.numerics.size);
            first_size_[name] = *part.size;
        }
        input_.numerics.accuracy.clear();
    }

    RefinedRun run(const OptionsOfLast& options)
    {
        solve(false);
        settle_time_steps();
        while (!finished())
            refine();
        if (options && !result_.thermal.interrupted)
            result_ = press_.run(options(input_), observer_);
        press_.drop_model();
        finish_report();
        result_.timings.insert(result_.timings.begin(), {"refinement", spent_});
        result_.accuracy = std::move(report_);
        return {std::make_unique<Press>(std::move(press_)), std::move(result_)};
    }

private:
    press::RunResult light_run()
    {
        RunOptions options;
        options.kept_times = estimate_times(input_);
        options.on_finish = [this](const RunContext& inside) { estimate_ = estimate_error(inside, wanted_.of); };
        return press_.run(options, observer_);
    }

    // Meshes and runs the case as it stands, and adds a round.
    void solve(bool compare)
    {
        const auto start = Clock::now();
        press_.take(input_);
        auto result = light_run();
        press::AccuracyRound round;
        round.cells = result.cells;
        round.value = final_value(input_, result, wanted_.of);
        if (compare)
            round.change = largest_change(result_, result, wanted_.of);
        round.estimate = estimate_.total;
        round.refined = refined_parts_;
        if (!estimate_.by_part.empty())
            round.worst_part = machine().parts[worst_part()].name;
        round.seconds = seconds_since(start);
        report_.rounds.push_back(round);
        result_ = std::move(result);
    }

    const Machine& machine() { return press_.machine(observer_); }

    [[nodiscard]] std::size_t worst_part() const
    {
        return static_cast<std::size_t>(std::ranges::max_element(estimate_.by_part) - estimate_.by_part.begin());
    }

    // Halves the steps until the result changes little. The error of the steps hardly depends on the mesh, so the first
    // mesh is used.
    void settle_time_steps()
    {
        const auto start = Clock::now();
        for (int i = 0; i < time_rounds && !result_.thermal.interrupted; ++i) {
            auto half = input_;
            constexpr double of_third_order = 8;
            half.numerics.time_tolerance =
                heat::time_tolerance_of(heat::step_tolerance(half.numerics.time_tolerance) / of_third_order);
            half.numerics.max_step /= 2;
            half.numerics.initial_step /= 2;
            observer_.stage("accuracy: again with halved time steps");
            press_.take(half);
            auto result = press_.run({}, observer_);
            report_.time_change = largest_change(result_, result, wanted_.of);
            if (report_.time_change <= share_of_time * wanted_.tolerance)
                break;
            input_ = std::move(half);
            result_ = std::move(result);
        }
        press_.take(input_);
        report_.time_seconds = seconds_since(start);
    }

    [[nodiscard]] double estimated() const { return report_.rounds.back().estimate + report_.time_change; }

    // Returns whether there is nothing more to do, and the reason.
    bool finished()
    {
        const auto& round = report_.rounds.back();
        if (result_.thermal.interrupted) {
            report_.why_not = "interrupted";
            return true;
        }
        if (round.change && *round.change <= wanted_.tolerance && estimated() <= wanted_.tolerance) {
            report_.reached = true;
            return true;
        }
        if (report_.time_change >= wanted_.tolerance)
            report_.why_not = "the error of the time steps is too large; lower numerics.time_tolerance and max_step";
        else if (static_cast<int>(report_.rounds.size()) >= input_.numerics.accuracy_rounds)
            report_.why_not = "as many meshes as numerics.accuracy_rounds allows";
        else if (plan_sizes(); refined_parts_ == 0)
            report_.why_not = static_cast<double>(round.cells) > 0.8 * input_.numerics.accuracy_cells
                                  ? "as many cells as numerics.accuracy_cells allows"
                                  : "no part is left to refine; meshes from files stay as they are";
        return !report_.why_not.empty();
    }

    // Computes new sizes, and the number of parts that become finer.
    void plan_sizes()
    {
        std::vector<PartError> parts;
        const auto orders = press::describe_orders(input_, machine());
        double sum = 0;
        for (std::size_t p = 0; p < machine().parts.size(); ++p) {
            const auto& part = machine().parts[p];
            sum += estimate_.by_part[p];
            parts.push_back({estimate_.by_part[p], static_cast<double>(part.cell_count), convergence_order(orders[p]),
                             !input_.parts.at(part.name).mesh.empty()});
        }
        const double allowed = wanted_.tolerance - report_.time_change;
        const double target = estimate_.total > allowed ? aim * allowed : confirming_step * estimate_.total;
        // the largest errors of the parts can occur at different times
        const double scale = estimate_.total > 0 ? sum / estimate_.total : 1;
        factors_ = size_factors(parts, scale * target, least_factor, input_.numerics.accuracy_cells);
        count_refined();
        if (refined_parts_ == 0 && estimate_.total <= allowed && report_.rounds.size() == 1) {
            for (std::size_t p = 0; p < parts.size(); ++p)
                factors_[p] = parts[p].fixed ? 1 : blind_step;
            count_refined();
        }
    }

    void count_refined()
    {
        refined_parts_ = static_cast<int>(std::ranges::count_if(factors_, [](double f) { return f < 1; }));
    }

    void refine()
    {
        for (std::size_t p = 0; p < factors_.size(); ++p)
            if (double& size = *input_.parts.at(machine().parts[p].name).size; factors_[p] < 1)
                size = std::stod(fmt::format("{:.3g}", size * factors_[p]));  // a number to put into a case file
        observer_.stage(fmt::format("accuracy: {}; mesh {}, with {} parts finer", standing(), report_.rounds.size() + 1,
                                    refined_parts_));
        solve(true);
    }

    // Describes what the last mesh has reached.
    [[nodiscard]] std::string standing() const
    {
        const bool gap = wanted_.of == Accuracy::Of::gap;
        const auto shown = [&](double value) {
            return fmt::format("{:.2g} {}", gap ? micrometre * value : value, gap ? "um" : "K");
        };
        const auto& round = report_.rounds.back();
        return fmt::format("{} cells, estimate {}{}, wanted {}", round.cells, shown(estimated()),
                           round.change ? ", change " + shown(*round.change) : "", shown(wanted_.tolerance));
    }

    void finish_report()
    {
        report_.time_tolerance = input_.numerics.time_tolerance;
        report_.max_step = input_.numerics.max_step;
        for (std::size_t p = 0; p < machine().parts.size(); ++p) {
            const auto& part = machine().parts[p];
            const auto& description = input_.parts.at(part.name);
            report_.parts.push_back({part.name, first_size_.at(part.name), *description.size, part.cell_count,
                                     estimate_.by_part.empty() ? 0 : estimate_.by_part[p], !description.mesh.empty()});
        }
        for (const auto& round : report_.rounds)
            spent_ += round.seconds;
        spent_ += report_.time_seconds;
        report_.seconds = seconds_since(start_);
    }

    casefile::Case input_;
    Observer& observer_;
    Accuracy wanted_;
    Press press_;
    press::AccuracyReport report_;
    std::map<std::string, double> first_size_;
    press::RunResult result_;
    ErrorEstimate estimate_;
    std::vector<double> factors_;
    int refined_parts_ = 0;
    double spent_ = 0;
    Clock::time_point start_ = Clock::now();
};

}  // namespace

RefinedRun run_to_accuracy(const casefile::Case& input, double size_scale, const OptionsOfLast& options,
                           Observer& observer)
{
    if (!casefile::wanted_accuracy(input))
        throw InputError("the case asks for no accuracy; state numerics.accuracy, like \"0.1 K\" or \"0.2 um\"");
    if (options && !options(input).start_from.empty())
        throw InputError("a run that continues another uses its mesh and cannot refine it; leave out "
                         "--accuracy (numerics.accuracy), or --from");
    return Refinement(input, size_scale, observer).run(options);
}

}  // namespace deadpoint::full
