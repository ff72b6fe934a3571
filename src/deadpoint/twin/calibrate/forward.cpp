#include "deadpoint/twin/calibrate/forward.hpp"

#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/core/stopwatch.hpp"
#include "deadpoint/drift/chain.hpp"
#include "deadpoint/drift/play.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/exchange/drift.hpp"
#include "deadpoint/observer.hpp"
#include "deadpoint/press/drift/chain_series.hpp"
#include "deadpoint/press/drift/crank_play.hpp"
#include "deadpoint/press/loads/loads_cache.hpp"
#include "deadpoint/press/problem/run_laws.hpp"
#include "deadpoint/press/result/run_result.hpp"
#include "deadpoint/reduce/parallel/in_parallel.hpp"
#include "deadpoint/reduce/sensitivity/sensitivity.hpp"
#include "deadpoint/twin/map/point_observer.hpp"
#include "deadpoint/twin/model/reduced_press.hpp"
#include "deadpoint/twin/run/box_check.hpp"
#include "deadpoint/twin/run/films_by_part.hpp"
#include "deadpoint/twin/run/run_reduced.hpp"

#include <array>
#include <fmt/format.h>
#include <utility>

namespace deadpoint::twin {
namespace {

constexpr double half_step = 1e-3;  // of theta, between the problems that give a direction

constexpr std::array<std::string_view, 5> dimension_names{"E_SW", "E_BG", "E_WG", "E_CS", "E_BC"};

/// A sum of observed functionals, and of what the crank's play takes of its bearings' growths.
struct Combination {
    std::vector<std::pair<std::size_t, double>> rows;
    double taken = 0;  ///< factor on the mean of BearingPlay::taken()
};

// As drift_series(), by the number of the dimension.
Combination dimension_parts(std::size_t dimension, const press::ChainFigures& figures)
{
    using namespace drift;
    const double play = figures.travel_by_play, along = figures.pressed_along_stroke;
    switch (dimension) {
    case 0:
        return {{{gap, 1}}, play};
    case 1:
        return {{{bearing_to_ground, 1}}, 0};
    case 2:
        return {{{table_to_ground, 1}}, 0};
    case 3:
        return {{{bearing_to_ground, 1}, {slide_height, -1}}, along - play};
    default:
        return {{}, -along};
    }
}

Combination parts_of(const ForwardOutput& output, const ReducedChain& chain)
{
    if (output.kind == ForwardOutput::Kind::corner)
        return {{{chain.first_gap + output.index, 1}}, chain.figures.travel_by_play};
    return dimension_parts(output.index, chain.figures);
}

std::vector<double> zeros(std::size_t count) { return std::vector<double>(count, 0.0); }

}  // namespace

std::vector<ForwardOutput> forward_outputs(const casefile::Case& input, const ReducedPress& press)
{
    using Kind = ForwardOutput::Kind;
    std::vector<ForwardOutput> result;
    for (const auto& [name, probe] : input.probes)
        result.push_back({Kind::probe, name, result.size()});
    if (!press.chain || !input.chain)
        return result;
    for (std::size_t k = 0; k < dimension_names.size(); ++k)
        result.push_back({Kind::dimension, std::string(dimension_names[k]), k});
    for (std::size_t k = 0; k < press.chain->gaps.corners.size(); ++k)
        result.push_back({Kind::corner, "corner " + press.chain->gaps.corners[k].name, k});
    return result;
}

struct ForwardModel::Parts {
    casefile::Case input;
    const ReducedPress* press = nullptr;
    std::vector<CaseParameter> parameters;
    ForwardOptions options;
    std::vector<ForwardOutput> outputs;
    std::unique_ptr<press::LoadsCache> own_loads;

    [[nodiscard]] press::LoadsCache& loads() const { return options.loads ? *options.loads : *own_loads; }
    [[nodiscard]] SplitProblem split(const std::vector<double>& theta, Observer& observer) const
    {
        const auto at = with_parameters(input, parameters, theta);
        auto result = split_by_part(press::heat_with(at, press->machine, loads(), observer), press->machine);
        result.problem.field_times.clear();
        result.problem.fixed_step = options.fixed_step;
        return result;
    }
    [[nodiscard]] HeatProblem problem(const std::vector<double>& theta, Observer& observer) const
    {
        return split(theta, observer).problem;
    }
    [[nodiscard]] reduce::Direction direction(std::vector<double> theta, std::size_t parameter) const
    {
        Observer silent;
        auto more = theta;
        theta[parameter] -= half_step;
        more[parameter] += half_step;
        return reduce::direction_between(problem(theta, silent), problem(more, silent), 2 * half_step);
    }
    [[nodiscard]] std::vector<reduce::Output> recorded() const;
    void add_values(const reduce::RecordedRun& run, const drift::BearingPlay& play, Forecast& result) const;
    void add_derivatives(const reduce::RecordedRun& run, const drift::BearingPlay& play,
                         const std::vector<double>& theta, const Observer& asked, Forecast& result) const;
};

namespace {

void stop_if(const Observer& asked)
{
    if (asked.cancelled())
        throw Stopped{};
}

}  // namespace

// Probes, then all functionals of the chain and its gaps.
std::vector<reduce::Output> ForwardModel::Parts::recorded() const
{
    std::vector<reduce::Output> result;
    for (std::size_t k = 0; k < input.probes.size(); ++k)
        result.push_back({reduce::Output::Kind::probe, k});
    if (!press->chain || !input.chain)
        return result;
    const auto& chain = *press->chain;
    const std::size_t count =
        std::max<std::size_t>(static_cast<std::size_t>(drift::dimension_count + chain.figures.bearings),
                              chain.gaps.corners.empty() ? 0 : chain.first_gap + chain.gaps.corners.size());
    for (std::size_t k = 0; k < count; ++k)
        result.push_back({reduce::Output::Kind::observed, k});
    return result;
}

void ForwardModel::Parts::add_values(const reduce::RecordedRun& run, const drift::BearingPlay& play,
                                     Forecast& result) const
{
    const auto& history = run.history;
    result.time = history.time;
    for (const auto& output : outputs) {
        if (output.kind == ForwardOutput::Kind::probe) {
            result.value.push_back(history.probes[output.index].value);
            continue;
        }
        const auto& figures = press->chain->figures;
        const auto parts = parts_of(output, *press->chain);
        auto values = zeros(history.time.size());
        for (std::size_t row = 0; row < values.size(); ++row) {
            for (const auto& [functional, factor] : parts.rows)
                values[row] += factor * history.functionals[functional].value[row];
            for (int b = 0; b < figures.bearings; ++b)
                values[row] += parts.taken / figures.bearings *
                               play.taken(history.functionals[drift::dimension_count + b].value[row]);
        }
        result.value.push_back(std::move(values));
    }
}

void ForwardModel::Parts::add_derivatives(const reduce::RecordedRun& run, const drift::BearingPlay& play,
                                          const std::vector<double>& theta, const Observer& asked,
                                          Forecast& result) const
{
    std::vector<reduce::Direction> directions(parameters.size());
    reduce::in_parallel(options.threads, parameters.size(), [&](std::size_t k) {
        stop_if(asked);
        directions[k] = direction(theta, k);
    });
    const auto found = reduce::forward(run, directions, recorded());
    const auto& history = run.history;
    const std::size_t first = input.probes.size();
    for (const auto& by : found) {
        auto& of_parameter = result.derivative.emplace_back();
        for (const auto& output : outputs) {
            if (output.kind == ForwardOutput::Kind::probe) {
                of_parameter.push_back(by[output.index]);
                continue;
            }
            const auto& figures = press->chain->figures;
            const auto parts = parts_of(output, *press->chain);
            auto values = zeros(history.time.size());
            for (std::size_t row = 0; row < values.size(); ++row) {
                for (const auto& [functional, factor] : parts.rows)
                    values[row] += factor * by[first + functional][row];
                for (int b = 0; b < figures.bearings; ++b) {
                    const auto growth = static_cast<std::size_t>(drift::dimension_count + b);
                    values[row] += parts.taken / figures.bearings * play.slope(history.functionals[growth].value[row]) *
                                   by[first + growth][row];
                }
            }
            of_parameter.push_back(std::move(values));
        }
    }
}

ForwardModel::ForwardModel(casefile::Case input, const ReducedPress& press, std::vector<CaseParameter> parameters,
                           ForwardOptions options)
    : parts_(std::make_unique<Parts>())
{
    parts_->outputs = forward_outputs(input, press);
    parts_->input = std::move(input);
    parts_->press = &press;
    parts_->parameters = std::move(parameters);
    parts_->options = options;
    parts_->own_loads = std::make_unique<press::LoadsCache>(2 * parts_->parameters.size() + 2);
    require_fit(parts_->input, press);
    for (const auto& parameter : parts_->parameters) {
        std::vector<double> theta(1, half_step);
        const auto changed = with_parameters(parts_->input, {parameter}, theta);
        if (const auto found = misfits(changed, press); !found.empty())
            throw InputError(fmt::format("the parameter '{}' changes what a reduced model cannot change: {}\n  help: "
                                         "calibrate friction, oil, conductances, films or the operation",
                                         parameter.name, found.front()));
    }
}
ForwardModel::~ForwardModel() = default;
ForwardModel::ForwardModel(ForwardModel&&) noexcept = default;

const std::vector<ForwardOutput>& ForwardModel::outputs() const { return parts_->outputs; }
const std::vector<CaseParameter>& ForwardModel::parameters() const { return parts_->parameters; }
const casefile::Case& ForwardModel::input() const { return parts_->input; }

double ForwardModel::end() const
{
    double sum = 0;
    for (const auto& segment : parts_->input.operation)
        sum += segment.duration;
    return sum;
}

double ForwardModel::start_of(const ForwardOutput& output) const
{
    return output.kind == ForwardOutput::Kind::probe ? parts_->input.machine.initial_temperature : 0;
}

Forecast ForwardModel::run(const std::vector<double>& theta, bool derivatives, Observer& observer, double coarser) const
{
    PointObserver silent(observer);
    auto problem = parts_->problem(theta, observer);
    problem.fixed_step *= coarser;
    const auto run =
        reduce::record_run(parts_->press->terms, std::move(problem), parts_->input.machine.initial_temperature, silent);
    stop_if(observer);
    const auto play = parts_->input.chain ? press::crank_play(parts_->input) : drift::BearingPlay{};
    Forecast result;
    parts_->add_values(run, play, result);
    if (derivatives)
        parts_->add_derivatives(run, play, theta, observer, result);
    return result;
}

std::vector<std::string> ForwardModel::outside(const std::vector<double>& theta) const
{
    Observer silent;
    return outside_of(parts_->press->box, parts_->split(theta, silent), parts_->press->reference);
}

}  // namespace deadpoint::twin
