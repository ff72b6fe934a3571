#include "deadpoint/report/run/drift_summary_text.hpp"

#include "deadpoint/core/units.hpp"
#include "deadpoint/press/run/run_summary.hpp"
#include "deadpoint/report/tables/table.hpp"

#include <fmt/format.h>

namespace deadpoint::report {
namespace {

using Json = nlohmann::ordered_json;

Json stretch_json(const press::StretchSummary& stretch, const std::string& unit, double factor)
{
    return {{"change_" + unit, factor * stretch.change},
            {"range_" + unit, factor * stretch.range},
            {"span_s", stretch.span},
            {"run_was_shorter", stretch.cut_short}};
}

Json course_json(const press::CourseSummary& course, const std::string& unit, double factor)
{
    return {{"first_hour", stretch_json(course.first_hour, unit, factor)},
            {"four_hours", stretch_json(course.four_hours, unit, factor)},
            {"range_" + unit, factor * course.range},
            {"largest_rate_" + unit + "_per_h", hour * factor * course.largest_rate},
            {"largest_rate_from_s", course.largest_rate_from},
            {"rate_window_s", course.window}};
}

}  // namespace

nlohmann::ordered_json drift_summary_json(const std::vector<std::string>& probes, const press::RunSummary& summary)
{
    Json json;
    json["terms"] =
        "first_hour and four_hours with the drive running correspond to the distortion by a rotating spindle "
        "of ISO 230-3, range at standstill under a changing ambient to its environmental temperature "
        "variation error (ETVE)";
    if (summary.gap_course) {
        json["E_SW"] = course_json(*summary.gap_course, "um", micrometre);
        json["E_SW"]["steady_from_s"] = summary.warm_up_time ? Json(*summary.warm_up_time) : Json(nullptr);
    }
    for (std::size_t i = 0; i < probes.size(); ++i) {
        json["probes"][probes[i]] = course_json(summary.probe_courses[i], "K", 1);
        json["probes"][probes[i]]["within_5_percent_of_end_from_s"] = summary.time_to_95[i];
    }
    return json;
}

std::string drift_summary_line(const press::CourseSummary& gap)
{
    const auto change = [](const press::StretchSummary& stretch, const char* name) {
        const auto value = fmt::format("{:+.1f} um", micrometre * stretch.change);
        return stretch.cut_short ? fmt::format("{} over the run of {}", value, duration_text(stretch.span))
                                 : fmt::format("{} {}", value, name);
    };
    std::string text = "  change " + change(gap.first_hour, "in the first hour");
    if (!gap.first_hour.cut_short)
        text += ", " + change(gap.four_hours, "over four hours");
    return text + fmt::format("; fastest {:+.1f} um/h over {} from {}; range {:.1f} um\n",
                              hour * micrometre * gap.largest_rate, duration_text(gap.window),
                              duration_text(gap.largest_rate_from), micrometre * gap.range);
}

}  // namespace deadpoint::report
