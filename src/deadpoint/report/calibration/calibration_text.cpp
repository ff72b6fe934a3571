#include "deadpoint/core/units.hpp"
#include "deadpoint/report/calibration/calibration_files.hpp"
#include "deadpoint/report/tables/table.hpp"
#include "deadpoint/twin/calibrate/calibration_result.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace deadpoint::report {
namespace {

using twin::Calibration;
using twin::CalibrationPlan;
using twin::FittedCurve;
using twin::FittedParameter;
using twin::Knowledge;
using twin::KnownCombination;

bool is_length(const FittedParameter& p) { return p.unit == "m"; }

/// A value in the unit that people read, without it.
std::string number(const FittedParameter& p, double value)
{
    return significant(value * (is_length(p) ? micrometre : 1), 3);
}

std::string shown_unit_of(const FittedParameter& p) { return p.unit.empty() ? "factor" : is_length(p) ? "um" : p.unit; }

std::string interval(const FittedParameter& p)
{
    return fmt::format("{}{} to {}{}", p.open_below ? "below " : "", number(p, p.lower), p.open_above ? "above " : "",
                       number(p, p.upper));
}

bool is_alternative(const FittedParameter& p) { return p.kind == FittedParameter::Kind::alternative; }

/// How the verbs of a sentence about combinations go.
struct Verbs {
    const char *subject, *determine, *leave;
};

/// What combinations are determined, and which are not.
void add_combinations(const std::vector<KnownCombination>& combinations, const Verbs& verbs,
                      std::vector<std::string>& lines)
{
    std::vector<std::string> known, unknown;
    for (const auto& combination : combinations)
        (combination.known == Knowledge::prior ? unknown : known).push_back(combination.words);
    if (known.empty())
        lines.push_back(fmt::format("{} {} no combination of the unknowns.", verbs.subject, verbs.determine));
    else
        lines.push_back(fmt::format("{} {} {} of {} combinations of the unknowns: {}.", verbs.subject, verbs.determine,
                                    known.size(), combinations.size(), fmt::join(known, "; ")));
    if (!unknown.empty())
        lines.push_back(fmt::format("The data {} {}: {} (x: the product, /: the ratio of factors).", verbs.leave,
                                    unknown.size() == 1 ? "one as it was assumed" : "these as they were assumed",
                                    fmt::join(unknown, "; ")));
}

void add_parameters(const std::vector<FittedParameter>& parameters, std::vector<std::string>& lines)
{
    const auto add = [&](Knowledge known, const char* words) {
        std::vector<std::string> names;
        for (const auto& p : parameters)
            if (!is_alternative(p) && p.known == known)
                names.push_back(p.name);
        if (!names.empty())
            lines.push_back(fmt::format("{}: {}.", words, fmt::join(names, ", ")));
    };
    add(Knowledge::data, "Known by the data");
    add(Knowledge::if_model_right, "Fixed by these data only if the model were right, which they contradict");
    add(Knowledge::prior, "Prior only, that is as uncertain as before");
}

/// Which shares of the alternatives' differences the data ask for.
void add_alternatives(const std::vector<FittedParameter>& parameters, std::vector<std::string>& lines)
{
    std::vector<std::string> open;
    for (const auto& p : parameters) {
        if (!is_alternative(p))
            continue;
        if (p.lower <= 0 && p.upper >= 0)
            open.push_back(fmt::format("{} ({})", p.name, interval(p)));
        else
            lines.push_back(fmt::format("The data ask for {} ({}) times the error that '{}' allows for: that model, or "
                                        "one like it, lies nearer to the press.",
                                        number(p, p.estimate), interval(p), p.name));
    }
    if (!open.empty())
        lines.push_back(fmt::format("Model errors that were allowed for, and of which the data need none: {}.",
                                    fmt::join(open, ", ")));
}

double shown(const FittedCurve& curve, double value) { return value * (curve.of_gap ? micrometre : 1); }

std::string curve_unit(const FittedCurve& curve) { return curve.of_gap ? "um" : "K"; }

void add_model(const Calibration& result, std::vector<std::string>& lines)
{
    if (!result.model_differs) {
        lines.push_back(fmt::format("The residuals are like the stated errors (probability {:.2g} by chance): the data "
                                    "do not contradict the model.",
                                    result.model_probability));
        return;
    }
    std::vector<std::string> worst;
    for (const auto& curve : result.curves)
        if (!curve.hold_out && curve.model_error > 0)
            worst.push_back(fmt::format("{} in {} ({} {})", curve.output, curve.run,
                                        significant(shown(curve, curve.model_error), 2), curve_unit(curve)));
    lines.push_back(
        fmt::format("The model does not explain the data within the stated errors (probability {:.1g}). {}.",
                    result.model_probability,
                    worst.empty() ? "No slow model error was found, so that the stated noise is too small"
                                  : fmt::format("A model error was added: {}", fmt::join(worst, ", "))));
}

void add_held_out(const Calibration& result, std::vector<std::string>& lines)
{
    for (const bool gap : {false, true}) {
        double square = 0, before = 0, nothing = 0, inside = 0, count = 0;
        for (const auto& curve : result.curves) {
            if (!curve.hold_out || curve.of_gap != gap)
                continue;
            const auto n = static_cast<double>(curve.time.size());
            square += n * curve.rms * curve.rms;
            before += n * curve.rms_before * curve.rms_before;
            nothing += n * curve.rms_nothing * curve.rms_nothing;
            inside += n * curve.inside;
            count += n;
        }
        if (count == 0)
            continue;
        const double scale = gap ? micrometre : 1;
        lines.push_back(fmt::format(
            "Held-out {}: {} {} rms, {} with the unchanged case, {} if nothing changed; {:.0f} % of {} values lie in "
            "the "
            "{:.0f} % band.",
            gap ? "dimensions" : "temperatures", significant(scale * std::sqrt(square / count), 3), gap ? "um" : "K",
            significant(scale * std::sqrt(before / count), 3), significant(scale * std::sqrt(nothing / count), 3),
            100 * inside / count, count, 100 * result.level));
    }
}

std::string parameter_table(const Calibration& result)
{
    TextTable table({"unknown", "value", "unit", fmt::format("{:.0f} % interval", 100 * result.level), "before",
                     result.model_differs ? "if the model were right" : "by the data"});
    for (const auto& p : result.parameters)
        table.add_row({p.name, number(p, p.estimate), shown_unit_of(p), interval(p),
                       fmt::format("{} to {}", number(p, p.prior_lower), number(p, p.prior_upper)),
                       fmt::format("{:.0f} %", 100 * p.shrinkage)});
    return table.text();
}

std::string curve_table(const Calibration& result)
{
    TextTable table({"run", "quantity", "values", "unit", "rms", "case as it was", "no change", "mean of runs", ""});
    table.align_left(1);
    for (const auto& curve : result.curves)
        table.add_row({curve.run, curve.output, std::to_string(curve.time.size()), curve_unit(curve),
                       significant(shown(curve, curve.rms), 3), significant(shown(curve, curve.rms_before), 3),
                       significant(shown(curve, curve.rms_nothing), 3),
                       curve.rms_mean ? significant(shown(curve, *curve.rms_mean), 3) : "-",
                       curve.hold_out ? "held out" : "fitted"});
    return table.text();
}

}  // namespace

std::string_view words_of(Knowledge known)
{
    switch (known) {
    case Knowledge::prior:
        return "prior only";
    case Knowledge::partly:
        return "in part";
    case Knowledge::data:
        return "by the data";
    default:
        return "only if the model were right";
    }
}

std::vector<std::string> conclusions(const Calibration& result)
{
    std::vector<std::string> lines;
    add_parameters(result.parameters, lines);
    add_alternatives(result.parameters, lines);
    add_combinations(result.after,
                     result.model_differs ? Verbs{"If the model were right, the data", "would determine", "would leave"}
                                          : Verbs{"The data", "determine", "leave"},
                     lines);
    add_model(result, lines);
    add_held_out(result, lines);
    return lines;
}

std::vector<std::string> conclusions(const CalibrationPlan& plan)
{
    std::vector<std::string> lines;
    add_parameters(plan.parameters, lines);
    add_combinations(plan.combinations, {"The data", "will determine", "will leave"}, lines);
    if (!plan.candidates.empty()) {
        const auto& best = plan.candidates.front();
        lines.push_back(fmt::format("Most would be gained by '{}' ({:.2f} nat), which tells most about '{}': its "
                                    "standard deviation falls to {:.0f} %.",
                                    best.name, best.information, best.most_about,
                                    100 * best.deviation_after / best.deviation_before));
    }
    return lines;
}

std::string calibration_text(const Calibration& result)
{
    std::size_t values = 0;
    for (const auto& curve : result.curves)
        values += curve.hold_out ? 0 : curve.time.size();
    auto text =
        fmt::format("calibration '{}' of {}: {} unknowns, {} values fitted\n{} runs of the model with "
                    "derivatives in {}, cost {} before and {} after\n\n",
                    result.name, result.case_name, result.parameters.size(), values, result.evaluations,
                    duration_text(result.seconds), significant(result.cost_before, 3), significant(result.cost, 3));
    text += parameter_table(result) + "\n" + curve_table(result) + "\n";
    for (const auto& line : conclusions(result))
        text += line + "\n";
    if (result.full_run)
        text +=
            fmt::format("A full run of the calibrated case differs by at most {} K and {} um from the reduced one.\n",
                        significant(result.full_run->first, 2), significant(micrometre * result.full_run->second, 2));
    return text;
}

std::string calibration_text(const CalibrationPlan& plan)
{
    auto text = fmt::format("plan of the calibration '{}' of {}: {} unknowns, {} runs with {} values\n\n", plan.name,
                            plan.case_name, plan.parameters.size(), plan.runs, plan.values);
    TextTable table({"unknown", "unit", "known before to", "then to", "by the data"});
    for (const auto& p : plan.parameters)
        table.add_row({p.name, shown_unit_of(p),
                       fmt::format("{} to {}", number(p, p.prior_lower), number(p, p.prior_upper)), interval(p),
                       fmt::format("{:.0f} %", 100 * p.shrinkage)});
    text += table.text() + "\n";
    if (!plan.candidates.empty()) {
        TextTable gains({"candidate", "information [nat]", "most about", "its standard deviation"});
        gains.align_left(2);
        for (const auto& gain : plan.candidates)
            gains.add_row({gain.name, significant(gain.information, 3), gain.most_about,
                           fmt::format("{:.0f} %", 100 * gain.deviation_after / gain.deviation_before)});
        text += gains.text() + "\n";
    }
    for (const auto& line : conclusions(plan))
        text += line + "\n";
    return text;
}

}  // namespace deadpoint::report
