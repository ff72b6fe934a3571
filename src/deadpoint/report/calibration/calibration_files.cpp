#include "deadpoint/report/calibration/calibration_files.hpp"

#include "deadpoint/core/units.hpp"
#include "deadpoint/core/version.hpp"
#include "deadpoint/io/write_file.hpp"
#include "deadpoint/report/calibration/calibration_json.hpp"
#include "deadpoint/report/folder/json_file.hpp"
#include "deadpoint/report/folder/result_files.hpp"
#include "deadpoint/report/schema/calibration_columns.hpp"
#include "deadpoint/report/tables/csv.hpp"
#include "deadpoint/twin/calibrate/calibration_result.hpp"
#include "deadpoint/twin/map/sweep_plan.hpp"

#include <cmath>
#include <fmt/format.h>
#include <functional>

namespace deadpoint::report {
namespace {

namespace columns = schema::calibration;
using Json = nlohmann::ordered_json;
using twin::Calibration;
using twin::CalibrationPlan;
using twin::FittedCurve;
using twin::FittedParameter;
using twin::KnownCombination;

const char* kind_of(const FittedParameter& p)
{
    switch (p.kind) {
    case FittedParameter::Kind::factor:
        return "factor";
    case FittedParameter::Kind::shift:
        return "shift";
    case FittedParameter::Kind::bias:
        return "bias";
    case FittedParameter::Kind::alternative:
        return "alternative";
    default:
        return "lag";
    }
}

/// Lengths are written in micrometres.
std::string unit_of(const FittedParameter& p) { return p.unit == "m" ? "um" : p.unit; }
double scale_of(const FittedParameter& p) { return p.unit == "m" ? micrometre : 1; }
double scale_of(bool of_gap) { return of_gap ? micrometre : 1; }
const char* unit_of(bool of_gap) { return of_gap ? "um" : "K"; }

template <class Result>
std::vector<std::string> head(const Result& result)
{
    std::vector<std::string> lines{fmt::format("deadpoint {}", version), fmt::format("calibration {}", result.name),
                                   fmt::format("case {} ({})", result.case_name, result.case_hash)};
    for (const auto& warning : result.warnings)
        lines.push_back("warning: " + warning);
    return lines;
}

template <class Item, class Of>
auto listed(const std::vector<Item>& items, const Of& of)
{
    std::vector<std::decay_t<std::invoke_result_t<Of, const Item&>>> result;
    for (const auto& item : items)
        result.push_back(std::invoke(of, item));
    return result;
}

// ---------------------------------------------------------------- tables

std::vector<CsvColumn> parameter_table(const std::vector<FittedParameter>& all)
{
    const auto number = [&](const schema::Column& column, double FittedParameter::*member) {
        return csv_column(column, listed(all, [&](const FittedParameter& p) { return scale_of(p) * p.*member; }));
    };
    const auto plain = [&](const schema::Column& column, double FittedParameter::*member) {
        return csv_column(column, listed(all, [&](const FittedParameter& p) { return p.*member; }));
    };
    return {csv_column(columns::parameter, listed(all, [](const auto& p) { return p.name; })),
            csv_column(columns::kind, listed(all, [](const auto& p) { return std::string(kind_of(p)); })),
            csv_column(columns::unit, listed(all, [](const auto& p) { return unit_of(p); })),
            number(columns::estimate, &FittedParameter::estimate),
            number(columns::lower, &FittedParameter::lower),
            number(columns::upper, &FittedParameter::upper),
            number(columns::prior_lower, &FittedParameter::prior_lower),
            number(columns::prior_upper, &FittedParameter::prior_upper),
            plain(columns::shrinkage, &FittedParameter::shrinkage),
            csv_column(columns::known, listed(all, [](const auto& p) { return std::string(words_of(p.known)); })),
            plain(columns::expected, &FittedParameter::expected),
            plain(columns::influence, &FittedParameter::influence)};
}

std::vector<CsvColumn> combination_table(const std::vector<KnownCombination>& all,
                                         const std::vector<FittedParameter>& parameters)
{
    std::vector<CsvColumn> table{
        csv_column(columns::combination, listed(all, [](const auto& c) { return c.words; })),
        csv_column(columns::singular_value, listed(all, [](const auto& c) { return c.singular_value; })),
        csv_column(columns::known, listed(all, [](const auto& c) { return std::string(words_of(c.known)); }))};
    for (std::size_t k = 0; k < parameters.size(); ++k)
        table.push_back(csv_column(columns::weight, listed(all, [&](const auto& c) { return c.direction[k]; }),
                                   parameters[k].name));
    return table;
}

std::vector<CsvColumn> correlation_table(const Calibration& result)
{
    std::vector<CsvColumn> table{
        csv_column(columns::parameter, listed(result.parameters, [](const auto& p) { return p.name; }))};
    for (std::size_t k = 0; k < result.parameters.size(); ++k)
        table.push_back(csv_column(columns::correlation, result.correlation[k], result.parameters[k].name));
    return table;
}

std::vector<CsvColumn> residual_table(const Calibration& result)
{
    std::vector<std::string> run, quantity, unit, held_out;
    std::vector<double> time, measured, predicted, before, lower, upper;
    for (const auto& curve : result.curves)
        for (std::size_t k = 0; k < curve.time.size(); ++k) {
            const double scale = scale_of(curve.of_gap);
            run.push_back(curve.run);
            quantity.push_back(curve.output);
            unit.emplace_back(unit_of(curve.of_gap));
            held_out.emplace_back(curve.hold_out ? "yes" : "no");
            time.push_back(curve.time[k]);
            measured.push_back(scale * curve.measured[k]);
            predicted.push_back(scale * curve.predicted[k]);
            before.push_back(scale * curve.before[k]);
            lower.push_back(scale * curve.lower[k]);
            upper.push_back(scale * curve.upper[k]);
        }
    return {csv_column(columns::run, run),
            csv_column(columns::quantity, quantity),
            csv_column(columns::unit, unit),
            csv_column(columns::held_out, held_out),
            csv_column(columns::time, time),
            csv_column(columns::measured, measured),
            csv_column(columns::predicted, predicted),
            csv_column(columns::before, before),
            csv_column(columns::band_lower, lower),
            csv_column(columns::band_upper, upper)};
}

std::vector<CsvColumn> prediction_table(const twin::PredictedRun& run)
{
    std::vector<CsvColumn> table{csv_column(columns::time, run.time)};
    for (const auto& curve : run.curves) {
        const auto add = [&](const schema::Column& column, const std::vector<double>& values) {
            const auto shown =
                listed(values, [&](double value) { return curve.of_gap ? micrometre * value : value - zero_celsius; });
            table.push_back(csv_column(column, shown, curve.output, curve.of_gap ? "um" : "degC"));
        };
        add(columns::prediction, curve.value);
        add(columns::prediction_lower, curve.lower);
        add(columns::prediction_upper, curve.upper);
        add(columns::prediction_before, curve.before);
    }
    return table;
}

std::vector<CsvColumn> posterior_table(const Calibration& result)
{
    std::vector<CsvColumn> table;
    for (std::size_t k = 0; k < result.parameters.size(); ++k) {
        const auto& p = result.parameters[k];
        table.push_back(csv_column(
            columns::draw, listed(result.samples->values, [&](const auto& row) { return scale_of(p) * row[k]; }),
            p.name, unit_of(p)));
    }
    return table;
}

// ---------------------------------------------------------------- JSON

Json parameter_json(const FittedParameter& p)
{
    const double scale = scale_of(p);
    Json json{{"name", p.name},
              {"kind", kind_of(p)},
              {"unit", unit_of(p)},
              {"estimate", scale * p.estimate},
              {"lower", scale * p.lower},
              {"upper", scale * p.upper},
              {"open_below", p.open_below},
              {"open_above", p.open_above},
              {"by_profile", p.by_profile},
              {"prior_lower", scale * p.prior_lower},
              {"prior_upper", scale * p.prior_upper},
              {"at_limit", p.at_limit},
              {"shrinkage", p.shrinkage},
              {"known", words_of(p.known)},
              {"expected_shrinkage", p.expected},
              {"influence", p.influence}};
    json["keys"] = Json::array();
    for (const auto& value : p.values)
        json["keys"].push_back({{"key", value.key}, {"before", value.before}, {"after", value.after}});
    Json values = Json::array(), cost = Json::array();
    for (const auto& [value, above] : p.profile) {
        values.push_back(scale * value);
        cost.push_back(above);
    }
    json["profile"] = {{"values", values}, {"rise", cost}};
    return json;
}

Json combination_json(const std::vector<KnownCombination>& combinations)
{
    Json json = Json::array();
    for (const auto& c : combinations)
        json.push_back({{"words", c.words},
                        {"singular_value", c.singular_value},
                        {"known", words_of(c.known)},
                        {"weights", c.direction}});
    return json;
}

Json curve_json(const FittedCurve& curve)
{
    const double scale = scale_of(curve.of_gap);
    return {{"run", curve.run},
            {"quantity", curve.output},
            {"column", curve.column},
            {"unit", unit_of(curve.of_gap)},
            {"held_out", curve.hold_out},
            {"values", curve.time.size()},
            {"rms", scale * curve.rms},
            {"bias", scale * curve.bias},
            {"rms_of_case", scale * curve.rms_before},
            {"rms_of_no_change", scale * curve.rms_nothing},
            {"rms_of_mean", curve.rms_mean ? Json(scale * *curve.rms_mean) : Json(nullptr)},
            {"inside_band", curve.inside},
            {"chi_square", curve.chi_square},
            {"lag_one", curve.lag_one},
            {"probability", curve.probability},
            {"correlation_time_s", curve.correlation_time},
            {"model_error", scale * curve.model_error}};
}

template <class Result>
Json head_json(const Result& result)
{
    Json json{{"version", version}, {"case", {{"name", result.case_name}, {"hash", result.case_hash}}}};
    json["calibration"] = {{"name", result.name}, {"note", result.note}};
    json["reduced_model"] = result.reduced_file;
    json["level"] = result.level;
    json["warnings"] = result.warnings;
    json["notes"] = result.notes;
    json["conclusions"] = conclusions(result);
    json["parameters"] = Json::array();
    for (const auto& p : result.parameters)
        json["parameters"].push_back(parameter_json(p));
    return json;
}

Json fit_json(const Calibration& result)
{
    Json minima = Json::array();
    for (const auto& [above, values] : result.other_minima)
        minima.push_back({{"cost_above", above}, {"values", values}});
    return {{"converged", result.converged},    {"model_runs", result.evaluations},  {"seconds", result.seconds},
            {"starts", result.starts},          {"cost_before", result.cost_before}, {"cost", result.cost},
            {"other_minima", std::move(minima)}};
}

std::vector<CsvColumn> candidate_table(const CalibrationPlan& plan)
{
    const auto& all = plan.candidates;
    return {csv_column(columns::candidate, listed(all, [](const auto& c) { return c.name; })),
            csv_column(columns::information, listed(all, [](const auto& c) { return c.information; })),
            csv_column(columns::most_about, listed(all, [](const auto& c) { return c.most_about; })),
            csv_column(columns::remaining,
                       listed(all, [](const auto& c) { return c.deviation_after / c.deviation_before; }))};
}

// ---------------------------------------------------------------- the case

std::string toml_text(const std::string& text)
{
    if (text.find('\'') == std::string::npos)
        return "'" + text + "'";
    std::string result = "\"";
    for (const char c : text)
        result += c == '"' || c == '\\' ? std::string{'\\', c} : std::string{c};
    return result + "\"";
}

void write_case_values(const std::filesystem::path& path, const Calibration& result)
{
    std::string text = fmt::format("# Values that the calibration '{}' found for {} (case hash {}), deadpoint {}.\n"
                                   "# Add this file to the `include` of the case; its values replace those of the "
                                   "case.\n",
                                   result.name, result.case_name, result.case_hash, version);
    for (const auto& warning : result.warnings)
        text += "# warning: " + warning + "\n";
    text += "replace = [\n";
    for (const auto& setting : result.settings)
        text += "    " + toml_text(setting) + ",\n";
    text += "]\n";
    write_file(path, [&](std::ostream& out) { out << text; });
}

}  // namespace

Json calibration_json(const Calibration& result)
{
    Json json = head_json(result);
    json["fit"] = fit_json(result);
    json["model"] = {{"differs", result.model_differs},
                     {"probability", result.model_probability},
                     {"reduced_error_K", result.reduced_temperature},
                     {"reduced_error_um", micrometre * result.reduced_gap},
                     {"step_error_K", result.step_temperature},
                     {"step_error_um", micrometre * result.step_gap},
                     {"outside", result.outside}};
    json["combinations"] = combination_json(result.after);
    json["combinations_before"] = combination_json(result.before);
    json["correlation"] = result.correlation;
    json["curves"] = Json::array();
    for (const auto& curve : result.curves)
        json["curves"].push_back(curve_json(curve));
    json["full_run"] = result.full_run ? Json{{"difference_K", result.full_run->first},
                                              {"difference_um", micrometre * result.full_run->second}}
                                       : Json(nullptr);
    json["samples"] = result.samples ? Json{{"count", result.samples->values.size()},
                                            {"accepted", result.samples->accepted},
                                            {"surrogate_error", result.samples->surrogate_error},
                                            {"intervals", result.samples->intervals}}
                                     : Json(nullptr);
    return json;
}

Json plan_json(const CalibrationPlan& plan)
{
    Json json = head_json(plan);
    json["runs"] = plan.runs;
    json["values"] = plan.values;
    json["combinations"] = combination_json(plan.combinations);
    json["candidates"] = Json::array();
    for (const auto& gain : plan.candidates)
        json["candidates"].push_back({{"name", gain.name},
                                      {"information_nat", gain.information},
                                      {"most_about", gain.most_about},
                                      {"deviation_before", gain.deviation_before},
                                      {"deviation_after", gain.deviation_after}});
    return json;
}

void write_calibration_files(const std::filesystem::path& folder, const Calibration& result)
{
    const auto comments = head(result);
    write_case_values(folder / "calibrated.toml", result);
    write_json(folder / "calibration.json", calibration_json(result));
    write_table(folder / "parameters.csv", comments, parameter_table(result.parameters));
    write_table(folder / "combinations.csv", comments, combination_table(result.after, result.parameters));
    write_table(folder / "correlation.csv", comments, correlation_table(result));
    write_table(folder / "residuals.csv", comments, residual_table(result));
    for (const auto& run : result.predictions)
        write_table(folder / fmt::format("prediction_{}.csv", twin::folder_safe(run.name)), comments,
                    prediction_table(run));
    if (result.samples)
        write_table(folder / "posterior.csv", comments, posterior_table(result));
}

void write_plan_files(const std::filesystem::path& folder, const CalibrationPlan& plan)
{
    const auto comments = head(plan);
    write_json(folder / "plan.json", plan_json(plan));
    write_table(folder / "parameters.csv", comments, parameter_table(plan.parameters));
    write_table(folder / "combinations.csv", comments, combination_table(plan.combinations, plan.parameters));
    write_table(folder / "candidates.csv", comments, candidate_table(plan));
}

}  // namespace deadpoint::report
