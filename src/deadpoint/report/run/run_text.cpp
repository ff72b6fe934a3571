#include "deadpoint/report/run/run_text.hpp"

#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/core/units.hpp"
#include "deadpoint/exchange/drift.hpp"
#include "deadpoint/exchange/heat.hpp"
#include "deadpoint/press/result/histories.hpp"
#include "deadpoint/press/result/run_result.hpp"
#include "deadpoint/press/run/run_summary.hpp"
#include "deadpoint/report/heat/friction_text.hpp"
#include "deadpoint/report/loads/loads_files.hpp"
#include "deadpoint/report/run/accuracy_text.hpp"
#include "deadpoint/report/run/drift_causes_text.hpp"
#include "deadpoint/report/run/drift_summary_text.hpp"
#include "deadpoint/report/run/frame_files.hpp"
#include "deadpoint/report/run/gaps_files.hpp"
#include "deadpoint/report/run/heat_flows.hpp"
#include "deadpoint/report/run/reduce_text.hpp"
#include "deadpoint/report/run/sensitivities_text.hpp"
#include "deadpoint/report/tables/table.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numeric>

namespace deadpoint::report {
namespace {

using casefile::Case;
using press::RunResult;
using press::RunSummary;

std::string warm_up_line(const Case& input, const RunSummary& summary)
{
    const double limit = input.chain->drift_rate_limit;
    if (!(limit > 0))
        return {};
    const auto rate = significant(limit * 3600 * micrometre);
    if (summary.warm_up_time)
        return fmt::format("  warm after {}: from then on the gap drifts by less than {} um/h\n",
                           duration_text(*summary.warm_up_time), rate);
    return fmt::format("  not warm at the end: the gap still drifts by more than {} um/h\n", rate);
}

std::string sensitivities_text(const RunResult& result)
{
    return result.sensitivities ? sensitivities_line(*result.sensitivities) : std::string{};
}

std::string gap_text(const Case& input, const RunResult& result, const RunSummary& summary)
{
    if (!result.drift)
        return sensitivities_text(result);
    return fmt::format("  gap E_SW at the end: {:+.1f} um (+ opens); largest: {:+.1f} um after {}\n",
                       micrometre * summary.final_gap, micrometre * summary.largest_gap,
                       duration_text(summary.largest_gap_time)) +
           drift_causes_line(result.causes) + sensitivities_text(result) + warm_up_line(input, summary) +
           (result.compliance ? compliance_text(input, *result.compliance) : "") + "\n";
}

std::string probes_text(const Case& input, const RunResult& result, const RunSummary& summary)
{
    const bool compared = !summary.comparison.empty();
    TextTable table(compared ? std::vector<std::string>{"probe", "rise [K]", "published [K]", "95 % after"}
                             : std::vector<std::string>{"probe", "rise [K]", "95 % after"});
    for (std::size_t i = 0; i < result.probes.size(); ++i) {
        std::vector<std::string> row{
            result.probes[i].name, fmt::format("{:.2f}", press::rise_at(input, result, i, result.thermal.time.back()))};
        if (compared) {
            const auto found = input.reference->rises.find(result.probes[i].name);
            row.push_back(found == input.reference->rises.end() ? "" : fmt::format("{:.2f}", found->second));
        }
        row.push_back(duration_text(summary.time_to_95[i]));
        table.add_row(row);
    }
    std::string text = table.empty() ? "" : table.text();
    if (compared)
        text += fmt::format("  off by {:.2f} K rms; predicting no rise would be off by {:.2f} K ({})\n",
                            summary.rms_residual, summary.rms_null, input.reference->source);
    return text;
}

std::string parts_line(const RunResult& result)
{
    constexpr std::size_t shown = 4;
    std::string text = "  by part at the end:";
    const auto order = strongest_parts(*result.drift);
    for (std::size_t i = 0; i < std::min(shown, order.size()); ++i)
        text += fmt::format("{} {} {:+.1f}", i ? "," : "", result.parts[order[i]].name,
                            micrometre * result.drift->by_part[order[i]].back());
    return text + " um\n";
}

std::string course_text(const RunResult& result, const RunSummary& summary)
{
    if (!result.drift)
        return {};
    return "\n" + drift_summary_line(*summary.gap_course) + parts_line(result) +
           gaps_text(result.gaps, result.thermal.time);
}

std::string mesh_line(const RunResult& result)
{
    if (result.deformation_cells == 0 || result.deformation_cells == result.cells)
        return {};
    return fmt::format("  mesh: {} cells for the heat, {} cells of a separate mesh for the deformation\n", result.cells,
                       result.deformation_cells);
}

std::string energy_line(const Case& input, const RunResult& result)
{
    const auto& energy = result.thermal.energy;
    const auto whole = [&](double joules) { return megajoule * result.symmetry_factor * joules; };
    return fmt::format("  heat: {:.2f} MJ generated, {:.2f} to the air, {:.2f} to the oil, {:.2f} stored ({})\n",
                       whole(energy.generated + energy.from_surfaces), whole(energy.to_air), whole(energy.to_oil),
                       whole(energy.stored),
                       nothing_happens(result.thermal, input.numerics.time_tolerance)
                           ? "nothing happens"
                           : fmt::format("balance closes to {:.0e}", energy.mismatch()));
}

std::string further_text(const Case& input, const RunResult& result, const RunSummary& summary)
{
    std::string text = course_text(result, summary);
    if (result.loads)
        text += "\n  " + loads_line(*result.loads) + "\n";
    if (!result.friction.empty())
        text += friction_text(result.friction);
    if (result.frame)
        text += frame_text(*result.frame);
    return text + "\n" + heat_flows_text(result) + mesh_line(result) + energy_line(input, result);
}

}  // namespace

std::vector<std::size_t> strongest_parts(const DriftSeries& drift)
{
    std::vector<std::size_t> order(drift.by_part.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return std::abs(drift.by_part[a].back()) > std::abs(drift.by_part[b].back());
    });
    return order;
}

std::string run_text(const Case& input, const RunResult& result, Detail detail)
{
    const auto summary = press::summarise(input, result);
    std::string text = fmt::format("\n{}, after {}\n\n", input.machine.name, duration_text(result.thermal.time.back()));
    text += gap_text(input, result, summary) + probes_text(input, result, summary);
    if (detail == Detail::all)
        text += further_text(input, result, summary);
    if (result.reduced)
        text += "\n" + reduced_run_text(*result.reduced);
    if (result.accuracy)
        text += "\n" + accuracy_text(*result.accuracy);
    return text;
}

}  // namespace deadpoint::report
