#include "deadpoint/twin/run/run_sensitivities.hpp"

#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/core/stopwatch.hpp"
#include "deadpoint/core/units.hpp"
#include "deadpoint/drift/chain.hpp"
#include "deadpoint/drift/play.hpp"
#include "deadpoint/observer.hpp"
#include "deadpoint/press/drift/chain_series.hpp"
#include "deadpoint/press/drift/crank_play.hpp"
#include "deadpoint/press/problem/run_laws.hpp"
#include "deadpoint/press/result/run_result.hpp"
#include "deadpoint/reduce/sensitivity/sensitivity.hpp"
#include "deadpoint/twin/model/reduced_press.hpp"
#include "deadpoint/twin/run/films_by_part.hpp"
#include "deadpoint/twin/run/free_coefficients.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace deadpoint::twin {
namespace {

using Kind = reduce::FreeCoefficient::Kind;

constexpr double load_step = 0.01;  // of speed and force
constexpr double tenth = 0.1;

HeatProblem heat_problem(const casefile::Case& input, const Machine& machine, Observer& observer)
{
    press::RunResult unused;
    Stopwatch watch(observer);
    auto problem =
        split_by_part(press::run_laws(input, machine, press::Vibration::left_out, watch, unused, observer), machine)
            .problem;
    problem.field_times.clear();
    return problem;
}

/// A way to change a problem, and how it is shown.
struct Studied {
    press::Sensitivity shown;
    reduce::Direction direction;
    double per_unit = 1;  ///< the direction's coefficient per unit of the value
};

double running_value(const casefile::Case& input, double casefile::Segment::*member)
{
    for (const auto& segment : input.operation)
        if (segment.*member > 0)
            return segment.*member;
    return 0;
}

// One value for all segments that have one, else a factor on all of them.
bool is_one_value(const casefile::Case& input, double casefile::Segment::*member)
{
    const double value = running_value(input, member);
    return std::ranges::all_of(input.operation, [&](const casefile::Segment& segment) {
        return segment.*member == 0 || segment.*member == value;
    });
}

class SensitivityRun {
public:
    SensitivityRun(const casefile::Case& input, const ReducedPress& press, Observer& observer)
        : input_(input), press_(press), observer_(observer), problem_(heat_problem(input, press.machine, silent_))
    {}

    press::Sensitivities get()
    {
        for (const auto& coefficient : press_.box)
            if (const auto here = in_problem(coefficient, problem_); !here.members.empty())
                add(here);
        add_operation("operation.speed", &casefile::Segment::speed, "rpm", 30 / std::numbers::pi);
        add_operation("operation.force", &casefile::Segment::force, "kN", 1e-3);
        const auto run = reduce::record_run(press_.terms, problem_, press_.reference, observer_);
        return evaluated(run);
    }

private:
    // Coefficients of one value are shown with it, others as a factor.
    void add(const reduce::FreeCoefficient& coefficient)
    {
        Studied studied{{coefficient.name, 1, "", tenth, 0, {}}, relative_direction(problem_, coefficient), 1};
        if (coefficient.kind == Kind::ambient || coefficient.kind == Kind::oil_temperature) {
            const double kelvin = coefficient.kind == Kind::ambient ? problem_.segments.front().ambient(0)
                                                                    : problem_.interfaces.front().oil_temperature;
            studied.shown.value = kelvin - zero_celsius;
            studied.shown.unit = "degC";
            studied.shown.change = 1;
        } else if (coefficient.kind != Kind::heat) {
            show_value(values_of(coefficient), studied);
        }
        studied_.push_back(std::move(studied));
    }

    [[nodiscard]] std::vector<double> values_of(const reduce::FreeCoefficient& coefficient) const
    {
        std::vector<double> values;
        for (std::size_t k = 0; k < coefficient.members.size(); ++k) {
            const double base = coefficient.base[k];
            const auto factor = value_of(coefficient, k, problem_, 0, press_.reference);
            values.push_back(factor && std::isfinite(*factor) ? *factor * base : 0);
        }
        return values;
    }

    static void show_value(const std::vector<double>& values, Studied& studied)
    {
        const double value = values.front();
        const bool same = std::ranges::all_of(
            values, [&](double other) { return std::abs(other - value) <= 1e-9 * std::abs(value); });
        if (!same)
            return;
        studied.shown.value = value;
        studied.shown.unit = "W/m2/K";
        studied.shown.change = tenth * value;
        studied.per_unit = value > 0 ? 1 / value : 1;
    }

    // @param shown  of one SI unit in `unit`
    void add_operation(const std::string& name, double casefile::Segment::*member, const std::string& unit,
                       double shown)
    {
        const double value = running_value(input_, member);
        if (!(value > 0))
            return;
        const auto with = [&](double factor) {
            auto changed = input_;
            for (auto& segment : changed.operation)
                segment.*member *= factor;
            return heat_problem(changed, press_.machine, silent_);
        };
        Studied studied{{name, 1, "", tenth, 0, {}},
                        reduce::direction_between(with(1 - load_step), with(1 + load_step), 2 * load_step),
                        1};
        if (is_one_value(input_, member)) {
            studied.shown.value = shown * value;
            studied.shown.unit = unit;
            studied.shown.change = tenth * studied.shown.value;
            studied.per_unit = 1 / studied.shown.value;
        }
        studied_.push_back(std::move(studied));
    }

    // E_SW first, if there is a chain: its row and the growths of the play, with their weights in E_SW at the end.
    [[nodiscard]] std::vector<double> gap_weights(const ThermalHistory& history) const
    {
        if (!press_.chain || !input_.chain)
            return {};
        const auto& figures = press_.chain->figures;
        const auto growths = play_growths(figures, history, history.time.size() - 1);
        auto weights = press::play_factors(figures, press::play_shares(press::crank_play(input_), growths));
        weights.insert(weights.begin(), 1.0);
        return weights;
    }

    [[nodiscard]] press::Sensitivities evaluated(const reduce::RecordedRun& run) const
    {
        const auto weights = gap_weights(run.history);
        std::vector<reduce::Output> outputs;
        for (std::size_t k = 0; k < weights.size(); ++k)
            outputs.push_back(
                {reduce::Output::Kind::observed,
                 static_cast<std::size_t>(k == 0 ? drift::gap : drift::dimension_count) + (k == 0 ? 0 : k - 1)});
        for (std::size_t k = 0; k < problem_.probes.size(); ++k)
            outputs.push_back({reduce::Output::Kind::probe, k});
        std::vector<reduce::Direction> directions;
        for (const auto& one : studied_)
            directions.push_back(one.direction);
        const auto found = reduce::forward(run, directions, outputs);
        press::Sensitivities result{run.history.time.back(), !weights.empty(), {}, {}};
        for (const auto& probe : problem_.probes)
            result.probes.push_back(probe.name);
        for (std::size_t k = 0; k < studied_.size(); ++k) {
            auto shown = studied_[k].shown;
            for (std::size_t o = 0; o < outputs.size(); ++o) {
                const double derivative = studied_[k].per_unit * found[k][o].back();
                if (o < weights.size())
                    shown.gap += weights[o] * derivative;
                else
                    shown.temperature.push_back(derivative);
            }
            result.of.push_back(std::move(shown));
        }
        return result;
    }

    const casefile::Case& input_;
    const ReducedPress& press_;
    Observer& observer_;
    Observer silent_;
    HeatProblem problem_;
    std::vector<Studied> studied_;
};

double strength(const press::Sensitivity& of, bool has_gap)
{
    if (has_gap)
        return std::abs(of.change * of.gap);
    double largest = 0;
    for (const double temperature : of.temperature)
        largest = std::max(largest, std::abs(of.change * temperature));
    return largest;
}

}  // namespace

press::Sensitivities run_sensitivities(const casefile::Case& input, const ReducedPress& press, Observer& observer)
{
    auto result = SensitivityRun(input, press, observer).get();
    std::ranges::stable_sort(result.of, std::ranges::greater{},
                             [&](const press::Sensitivity& of) { return strength(of, result.has_gap); });
    return result;
}

}  // namespace deadpoint::twin
