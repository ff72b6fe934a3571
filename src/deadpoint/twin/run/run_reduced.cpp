#include "deadpoint/twin/run/run_reduced.hpp"

#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/casefile/syntax/case_bytes.hpp"
#include "deadpoint/core/stopwatch.hpp"
#include "deadpoint/drift/chain.hpp"
#include "deadpoint/drift/play.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/exchange/heat_causes.hpp"
#include "deadpoint/heat/films.hpp"
#include "deadpoint/heat/functionals.hpp"
#include "deadpoint/mechanism/bottom_dead_point.hpp"
#include "deadpoint/observer.hpp"
#include "deadpoint/press/drift/chain_series.hpp"
#include "deadpoint/press/drift/crank_play.hpp"
#include "deadpoint/press/drift/drift_causes.hpp"
#include "deadpoint/press/drift/frame_courses.hpp"
#include "deadpoint/press/problem/run_laws.hpp"
#include "deadpoint/press/result/run_result.hpp"
#include "deadpoint/press/run/field_times.hpp"
#include "deadpoint/press/run/run_warnings.hpp"
#include "deadpoint/press/translate/linkage.hpp"
#include "deadpoint/reduce/certificate/certificate.hpp"
#include "deadpoint/reduce/offline/difference.hpp"
#include "deadpoint/reduce/online/dense_terms.hpp"
#include "deadpoint/reduce/online/reduced_run.hpp"
#include "deadpoint/reduce/online/terms_file.hpp"
#include "deadpoint/twin/model/reduced_press.hpp"
#include "deadpoint/twin/model/sound_press.hpp"
#include "deadpoint/twin/run/box_check.hpp"
#include "deadpoint/twin/run/films_by_part.hpp"
#include "deadpoint/twin/run/reduced_states.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numeric>
#include <optional>
#include <set>
#include <sstream>

namespace deadpoint::twin {
namespace {

// Lines of a case, each with the table in which it stands.
std::vector<std::string> lines_of(const std::string& text)
{
    std::vector<std::string> lines;
    std::istringstream in(text);
    std::string table;
    for (std::string line; std::getline(in, line);)
        if (line.starts_with("["))
            lines.push_back(table = line);
        else if (!line.empty())
            lines.push_back(table + " " + line);
    return lines;
}

void require_same(const ReducedPress& press, const ReducedPress& large)
{
    if (!is_same_press(press, large))
        throw InputError(fmt::format("the large model '{}' belongs to another reduced press (case hash {}, that of the "
                                     "small one {})\n  help: make both again with 'deadpoint reduce', or remove that "
                                     "file",
                                     press.large_file, large.case_hash, press.case_hash));
}

// With E_SW, the play of the crank's bearings included, in place of the functional without it.
ThermalHistory with_gap(ThermalHistory history, const std::optional<DriftSeries>& drift)
{
    if (drift)
        history.functionals[drift::gap] = drift->gap;
    return history;
}

press::StatedError stated(const std::string& of, const ThermalHistory& run, const std::optional<DriftSeries>& drift,
                          const ThermalHistory& other, const std::optional<DriftSeries>& other_drift)
{
    const auto found = reduce::difference(with_gap(run, drift), with_gap(other, other_drift),
                                          drift ? static_cast<std::size_t>(drift::gap) : SIZE_MAX);
    return {of, found.temperature, found.gap};
}

/// E_SW after the last step of a run as a sum of functionals, and the growth of each bearing's play, whose limit makes
/// E_SW no such sum.
struct GapOutputs {
    GapOutputs(const press::ChainFigures& figures, const drift::BearingPlay& play_, const ThermalHistory& history,
               std::size_t first_observed)
        : play(play_)
    {
        for (const double growth : play_growths(figures, history, history.time.size() - 1))
            slopes.push_back(play.slope(growth));
        gap.push_back({first_observed + drift::gap, 1});
        const auto factors = press::play_factors(figures, slopes);
        for (std::size_t b = 0; b < slopes.size(); ++b) {
            growths.push_back({{first_observed + drift::dimension_count + b, 1}});
            gap.push_back({growths[b].front().functional, factors[b]});
        }
        per_growth = std::abs(press::play_factors(figures, {1.0}).front());
    }

    /// What the limit of a bearing's play may add to the bound of `gap`. The play that counts has a slope of 0 to 1,
    /// and the same one on both sides of an error unless the limit lies between.
    [[nodiscard]] double by_limit(std::size_t bearing, double growth, double bound) const
    {
        const bool sure =
            play.kind != drift::BearingPlay::Kind::limited ||
            (play.slope(growth - bound) == slopes[bearing] && play.slope(growth + bound) == slopes[bearing]);
        return sure ? 0 : per_growth * bound;
    }

    drift::BearingPlay play;
    std::vector<double> slopes;  ///< of the play that counts, by the growth, per bearing
    heat::Loads gap;
    std::vector<heat::Loads> growths;
    double per_growth = 0;  ///< |change of E_SW| by the growth of one bearing, where all of it counts
};

/// One run on a reduced model.
class ReducedCaseRun {
public:
    ReducedCaseRun(const casefile::Case& input, const ReducedPress& press, ReducedDetail detail, Observer& observer,
                   press::LoadsCache* loads)
        : input_(input), press_(press), detail_(detail), observer_(observer), watch_(observer), loads_(loads),
          problem_(
              press::run_laws(input, press.machine,
                              detail == ReducedDetail::all ? press::Vibration::computed : press::Vibration::left_out,
                              watch_, result_, observer, loads)),
          split_(split_by_part(problem_, press.machine))
    {
        split_.problem.field_times.clear();
        press::warn_of_loads(input, press.machine, result_, observer);
    }

    press::RunResult run(const LargeModel& large, ReducedStates* states)
    {
        reduce::ReducedHooks hooks;
        if (states) {
            states->model = reduce::mark_of(press_.terms->terms);
            states->count = press_.states;
            split_.problem.field_times = press::FieldTimes(problem_, true).all;
            hooks.on_field = [&](double time, const reduce::States& at) {
                states->states.push_back({time, {at.begin(), at.end()}});
            };
        }
        watch_.start("time steps");
        reduce::ReducedRun run(press_.terms, split_.problem, press_.adjoints, reference());
        result_.thermal = run.go(hooks, observer_);
        merge_surfaces();
        follow_gap(run);
        estimate(large);
        watch_.stop();
        finish(states != nullptr);
        return std::move(result_);
    }

private:
    /// Temperature without deformation [K].
    [[nodiscard]] double reference() const { return input_.machine.initial_temperature; }

    void merge_surfaces()
    {
        std::vector<bool> outside(problem_.surfaces.size(), false);
        for (std::size_t k = 0; k < split_.whole.size(); ++k)
            if (result_.thermal.film_out_of_range[k])
                outside[split_.whole[k]] = true;
        result_.thermal.film_out_of_range = outside;
    }

    void follow_gap(reduce::ReducedRun& run)
    {
        if (!press_.chain || !input_.chain)
            return;
        const auto& chain = *press_.chain;
        const auto play = press::crank_play(input_);
        const auto linkage = press::describe_linkage(input_);
        result_.sensitivity = loads_ ? loads_->turns().bottom(linkage) : mechanism::bottom_dead_point(linkage);
        result_.drift = press::drift_series(chain.figures, play, result_.thermal);
        if (detail_ == ReducedDetail::all && input_.output.causes && !result_.thermal.interrupted)
            result_.causes = press::drift_causes(input_, problem_, *result_.drift,
                                                 [&](std::size_t row) { return causes_at(run, play, row); });
        result_.gaps =
            press::gap_series(input_, chain.gaps, result_.thermal, static_cast<int>(chain.first_gap), *result_.drift);
    }

    // Causes of E_SW with the share of the play that counts at a row, surface by surface of the case.
    HeatCauses causes_at(reduce::ReducedRun& run, const drift::BearingPlay& play, std::size_t row) const
    {
        const auto& figures = press_.chain->figures;
        const auto& observed = press_.terms->terms.observed;
        const auto factors =
            press::play_factors(figures, press::play_shares(play, play_growths(figures, result_.thermal, row)));
        reduce::States weights = observed.row(drift::gap).transpose();
        for (std::size_t b = 0; b < factors.size(); ++b)
            weights += factors[b] * observed.row(drift::dimension_count + static_cast<Eigen::Index>(b)).transpose();
        auto causes = run.causes(weights, row);
        causes.surfaces = summed(split_, causes.surfaces, problem_.surfaces.size());
        return causes;
    }

    void estimate(const LargeModel& large)
    {
        auto& reduced = result_.reduced.emplace();
        reduced.states = press_.states;
        reduced.errors = press_.errors;
        reduced.outside = outside_of(press_.box, split_, press_.reference);
        for (const auto& text : reduced.outside)
            observer_.warn(fmt::format("outside the range of the reduced model: {}", text));
        if (!large.press || result_.thermal.interrupted)
            return;
        watch_.start("estimate");
        reduce::ReducedRun run(large.press->terms, split_.problem, large.press->adjoints, reference());
        const auto& history = run.go({}, observer_);
        const auto drift =
            press_.chain ? std::optional(press::drift_series(press_.chain->figures, press::crank_play(input_), history))
                         : std::nullopt;
        reduced.estimate = stated(estimate_text(), result_.thermal, result_.drift, history, drift);
        if (large.residual)
            reduced.certified = certified(large, history, drift);
    }

    // The large model too takes laws of convection at mean temperatures, so it does not see what that changes.
    [[nodiscard]] std::string estimate_text() const
    {
        const std::string text = "this run, to the large model";
        return std::ranges::any_of(problem_.surfaces, heat::follows_temperature)
                   ? text + ", which like this one takes laws of convection at mean temperatures"
                   : text;
    }

    // Bounds of the large model, and the difference to it at the end.
    press::Certified certified(const LargeModel& large, const ThermalHistory& history,
                               const std::optional<DriftSeries>& drift)
    {
        watch_.start("certificate");
        const auto& terms = large.press->terms->terms;
        const auto& layout = terms.geometry.layout;
        std::vector<heat::Loads> outputs;
        for (std::size_t k = 0; k < layout.probes; ++k)
            outputs.push_back({{layout.probe(k), 1}});
        std::optional<GapOutputs> gap;
        if (drift) {
            gap.emplace(press_.chain->figures, press::crank_play(input_), history, layout.count());
            outputs.insert(outputs.end(), gap->growths.begin(), gap->growths.end());
            outputs.push_back(gap->gap);
        }
        const auto found = reduce::certify(large.press->terms, *large.residual, split_.problem, history.time, outputs);
        press::Certified result{found.refused, {}, {}};
        if (!found.refused.empty())
            return result;
        const auto off = [](const Series& one, const Series& other) {
            return std::abs(one.value.back() - other.value.back());
        };
        for (std::size_t k = 0; k < layout.probes; ++k)
            result.probes.emplace_back(problem_.probes[k].name,
                                       found.bounds[k] + off(result_.thermal.probes[k], history.probes[k]));
        if (!drift)
            return result;
        double bound = found.bounds.back() + off(result_.drift->gap, drift->gap);
        for (std::size_t b = 0; b < gap->growths.size(); ++b) {
            const auto row = terms.observed.row(static_cast<Eigen::Index>(drift::dimension_count + b));
            const double growth = found.values[layout.probes + b] - reference() * row.dot(terms.uniform);
            bound += gap->by_limit(b, growth, found.bounds[layout.probes + b]);
        }
        result.gap = bound;
        return result;
    }

    void finish(bool fields_follow)
    {
        if (press_.frame) {
            result_.frame = press_.frame;
            press::read_courses(result_.thermal, press_.first_frame, *result_.frame);
            if (!fields_follow)
                press::warn_about_frame(input_, result_.thermal, *result_.frame, observer_);
        }
        static_cast<press::Histories&>(result_) =
            press::name_histories(input_, press_.machine, problem_, result_.thermal, result_.symmetry_factor);
        result_.cells = static_cast<long long>(press_.cells);
        result_.heat_unknowns = static_cast<long long>(press_.unknowns);
        result_.timings = watch_.times();
        press::finish_run(input_, press_.machine, problem_, press_.chain ? &press_.chain->figures : nullptr, result_,
                          observer_);
    }

    const casefile::Case& input_;
    const ReducedPress& press_;
    ReducedDetail detail_;
    Observer& observer_;
    press::RunResult result_;
    Stopwatch watch_;
    press::LoadsCache* loads_;
    HeatProblem problem_;
    SplitProblem split_;
};

}  // namespace

std::vector<std::string> misfits(const casefile::Case& input, const ReducedPress& press)
{
    if (fixed_part(input) == press.fixed_part)
        return {};
    const auto own = lines_of(fixed_part(input)), built = lines_of(press.fixed_part);
    const std::multiset<std::string> of_case(own.begin(), own.end()), of_model(built.begin(), built.end());
    if (of_case == of_model)
        return {"the same lines in another order"};
    // A key that the program learned later is missing in the model, and has its default there.
    const auto defaults = lines_of(fixed_part({}));
    std::vector<std::string> result;
    const auto add = [&](const auto& these, const auto& others, const char* where) {
        std::vector<std::string> only;
        std::ranges::set_difference(these, others, std::back_inserter(only));
        for (const auto& line : only)
            if (std::ranges::find(defaults, line) == defaults.end())
                result.push_back(where + line);
    };
    add(of_case, of_model, "only in this case: ");
    add(of_model, of_case, "only in the model: ");
    return result;
}

namespace {

void refuse(std::vector<std::string> found, const ReducedPress& press)
{
    constexpr std::size_t shown = 4;
    if (found.empty())
        return;
    const auto count = found.size();
    found.resize(std::min(count, shown));
    throw InputError(
        fmt::format("this case is not the press that was reduced (case '{}'); it differs in what a reduced "
                    "model cannot change:\n    {}{}\n  help: reduce this case: deadpoint reduce CASE -o "
                    "FILE",
                    press.name, fmt::join(found, "\n    "), count > shown ? "\n    ..." : ""));
}

// The fixed part of the case is that of the model, so whatever else differs is a flaw of the model's file.
void require_sound(const casefile::Case& input, const ReducedPress& press)
{
    if (const auto flaw = flaw_for(input, press); !flaw.empty())
        throw IoError(fmt::format("the reduced press of the case '{}' is broken: {}\n  help: make it again with "
                                  "'deadpoint reduce CASE -o FILE'",
                                  press.name, flaw));
}

}  // namespace

void require_fit(const casefile::Case& input, const ReducedPress& press)
{
    refuse(misfits(input, press), press);
    require_sound(input, press);
}

press::RunResult run_reduced(const casefile::Case& input, const ReducedPress& press, const LargeModel& large,
                             ReducedDetail detail, Observer& observer, ReducedStates* states, SharedParts* shared)
{
    if (shared)
        refuse(*shared->misfits.get(casefile::case_bytes(fixed_case(input)),
                                    [&] {
                                        auto found = misfits(input, press);
                                        if (found.empty())
                                            require_sound(input, press);
                                        return found;
                                    }),
               press);
    else
        require_fit(input, press);
    if (large.press)
        require_same(press, *large.press);
    return ReducedCaseRun(input, press, detail, observer, shared ? &shared->loads : nullptr).run(large, states);
}

press::StatedError difference_to_full(const press::RunResult& reduced, const press::RunResult& full)
{
    return stated("this run, to a full run", reduced.thermal, reduced.drift, full.thermal, full.drift);
}

}  // namespace deadpoint::twin
