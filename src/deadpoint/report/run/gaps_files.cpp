#include "deadpoint/report/run/gaps_files.hpp"

#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/core/units.hpp"
#include "deadpoint/exchange/gaps.hpp"
#include "deadpoint/exchange/heat.hpp"
#include "deadpoint/exchange/named_axes.hpp"
#include "deadpoint/press/result/press_compliance.hpp"
#include "deadpoint/report/schema/columns.hpp"
#include "deadpoint/report/tables/table.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace deadpoint::report {
namespace {

using Json = nlohmann::ordered_json;

struct Extreme {
    double value = 0;
    double time = 0;
};

// Between the steps the cubic hardly leaves their range, so the value of the step nearest the extreme is stated.
Extreme largest(const std::vector<double>& time, const Series& series)
{
    const auto at = std::ranges::max_element(series.value, {}, [](double v) { return std::abs(v); });
    return {*at, time[static_cast<std::size_t>(at - series.value.begin())]};
}

Extreme smallest(const std::vector<double>& time, const Series& series)
{
    const auto at = std::ranges::min_element(series.value);
    return {*at, time[static_cast<std::size_t>(at - series.value.begin())]};
}

Json course_json(const std::vector<double>& time, const Series& series, double factor, const std::string& unit)
{
    const auto most = largest(time, series);
    return {{"largest_" + unit, factor * most.value},
            {"time_of_largest_s", most.time},
            {"final_" + unit, factor * series.value.back()}};
}

Json clearance_json(const std::vector<double>& time, const ClearanceSeries& clearance)
{
    const auto least = smallest(time, clearance.change);
    Json json{{"name", clearance.name},
              {"kind", clearance.kind == ClearanceSeries::Kind::guide ? "guide" : "bearing"},
              {"final_change_um", micrometre * clearance.change.value.back()},
              {"least_change_um", micrometre * least.value},
              {"time_of_least_s", least.time}};
    if (clearance.initial) {
        json["initial_um"] = micrometre * *clearance.initial;
        json["least_um"] = micrometre * (*clearance.initial + least.value);
        json["final_um"] = micrometre * (*clearance.initial + clearance.change.value.back());
        json["used_up_s"] = clearance.used_up ? Json(*clearance.used_up) : Json(nullptr);
    }
    return json;
}

std::string clearances_text(const std::vector<ClearanceSeries>& clearances, const std::vector<double>& time)
{
    constexpr std::size_t shown = 3;
    std::vector<const ClearanceSeries*> order;
    for (const auto& clearance : clearances)
        order.push_back(&clearance);
    std::ranges::stable_sort(order, {}, [](const auto* c) { return c->change.value.back(); });
    std::string text = "  clearances that close most at the end:";
    for (std::size_t i = 0; i < std::min(shown, order.size()); ++i) {
        const auto& c = *order[i];
        text += fmt::format("{} {} {:+.1f}", i ? "," : "", c.name, micrometre * c.change.value.back());
        if (c.initial)
            text += fmt::format(" (least {:.1f} of {:.1f})", micrometre * (*c.initial + smallest(time, c.change).value),
                                micrometre * *c.initial);
    }
    return text + " um\n";
}

constexpr double per_kilonewton = 1e3 * micrometre;  // from m/N to um/kN, and from 1/N to um/m per kN
constexpr double kilonewton_per_millimetre = 1e-6;   // from N/m

double largest_force(const casefile::Case& input)
{
    double largest = 0;
    for (const auto& segment : input.operation)
        largest = std::max(largest, segment.force);
    return largest;
}

}  // namespace

std::vector<CsvColumn> gap_columns(const GapSeries& gaps, const SeriesSampler& sample)
{
    std::vector<CsvColumn> columns;
    if (gaps.parallelism) {
        for (const auto& corner : gaps.parallelism->corners)
            columns.push_back(csv_column(schema::gaps::corner, sample(corner.gap, micrometre, 0), corner.name));
        columns.push_back(csv_column(schema::gaps::left_right, sample(gaps.parallelism->left_right, micrometre, 0)));
        columns.push_back(csv_column(schema::gaps::front_back, sample(gaps.parallelism->front_back, micrometre, 0)));
    }
    for (const auto& clearance : gaps.clearances)
        columns.push_back(csv_column(schema::gaps::clearance, sample(clearance.change, micrometre, 0), clearance.name));
    if (gaps.force)
        columns.push_back(csv_column(schema::gaps::force, sample(*gaps.force, kilonewton, 0)));
    return columns;
}

nlohmann::ordered_json gaps_json(const GapSeries& gaps, const std::vector<double>& time)
{
    Json json;
    if (gaps.parallelism) {
        auto& parallel = json["parallelism"];
        parallel["terms"] =
            "gap between slide and table at the slide's corners, change since the start; a slope is positive where the "
            "gap opens more to the right or to the back";
        const auto& viewer = gaps.parallelism->viewer;
        parallel["directions"] =
            fmt::format("front is {}, left is {}", side_name(viewer.front), side_name(viewer.left));
        for (const auto& corner : gaps.parallelism->corners) {
            auto entry = course_json(time, corner.gap, micrometre, "um");
            entry["x_mm"] = 1e3 * corner.x;
            entry["z_mm"] = 1e3 * corner.z;
            parallel["corners"][corner.name] = std::move(entry);
        }
        parallel["left_to_right"] = course_json(time, gaps.parallelism->left_right, micrometre, "um_per_m");
        parallel["front_to_back"] = course_json(time, gaps.parallelism->front_back, micrometre, "um_per_m");
    }
    if (!gaps.clearances.empty()) {
        json["clearance_terms"] =
            "change since the start, below zero closes; of a bearing on the diameter, rings included, "
            "of a guide both faces together";
        for (const auto& clearance : gaps.clearances)
            json["clearances"].push_back(clearance_json(time, clearance));
    }
    if (!gaps.left_out.empty())
        json["left_out"] = gaps.left_out;
    if (gaps.force) {
        json["force"] = course_json(time, *gaps.force, kilonewton, "kN");
        json["force"]["press_stiffness_N_per_m"] = gaps.press_stiffness;
    }
    return json;
}

std::string gaps_text(const GapSeries& gaps, const std::vector<double>& time)
{
    std::string text;
    if (gaps.parallelism)
        text +=
            fmt::format("  slide against table at the end: left to right {:+.1f} um/m, front to back {:+.1f} um/m\n",
                        micrometre * gaps.parallelism->left_right.value.back(),
                        micrometre * gaps.parallelism->front_back.value.back());
    if (!gaps.clearances.empty())
        text += clearances_text(gaps.clearances, time);
    if (gaps.force) {
        const auto most = largest(time, *gaps.force);
        text += fmt::format("  force at a fixed die height: {:+.1f} kN at most, after {}, {:+.1f} kN at the end\n",
                            kilonewton * most.value, duration_text(most.time), kilonewton * gaps.force->value.back());
    }
    return text;
}

nlohmann::ordered_json compliance_json(const casefile::Case& input, const press::PressCompliance& compliance)
{
    nlohmann::ordered_json json;
    json["terms"] =
        "elastic opening of the gap under the process force at bottom dead point, apart from heat; frame, "
        "table, slide, links and crankshaft as solids, without clearances, oil films, rolling elements, tool "
        "and foundation";
    json["opening_um_per_kN"] = per_kilonewton * compliance.opening;
    json["stiffness_kN_per_mm"] = kilonewton_per_millimetre * compliance.stiffness();
    for (const auto& corner : compliance.corners)
        json["corners_um_per_kN"][corner.name] = per_kilonewton * corner.opening;
    if (!compliance.corners.empty()) {
        json["left_to_right_um_per_m_per_kN"] = per_kilonewton * compliance.left_right;
        json["front_to_back_um_per_m_per_kN"] = per_kilonewton * compliance.front_back;
    }
    for (const auto& segment : input.operation)
        if (segment.force > 0)
            json["segments"].push_back({{"name", segment.name},
                                        {"force_N", segment.force},
                                        {"opening_um", micrometre * compliance.opening * segment.force}});
    return json;
}

std::string compliance_text(const casefile::Case& input, const press::PressCompliance& compliance)
{
    std::string text =
        fmt::format("  static, apart from heat: {:.3g} um/kN open the gap, {:.4g} kN/mm of solid parts alone\n",
                    per_kilonewton * compliance.opening, kilonewton_per_millimetre * compliance.stiffness());
    const bool stiff = std::max(input.numerics.order, input.numerics.deformation_order) < 2;
    const std::string note =
        stiff ? "    elements of first order bend too little: numerics.deformation_order = 2 finds more\n" : "";
    const double force = largest_force(input);
    if (!(force > 0))
        return text + note;
    text += fmt::format("    at {:.4g} kN: {:.1f} um", 1e-3 * force, micrometre * compliance.opening * force);
    if (!compliance.corners.empty())
        text += fmt::format(", left to right {:+.1f} um/m, front to back {:+.1f} um/m",
                            micrometre * compliance.left_right * force, micrometre * compliance.front_back * force);
    return text + "\n" + note;
}

}  // namespace deadpoint::report
