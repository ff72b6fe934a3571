#pragma once

#include "deadpoint/twin/map/drift_window.hpp"

#include <cstddef>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

/// Charts of one set of a study. Of a set with several axes the curves vary the first one and keep
/// the others at their first steps; the map shows all of two axes.
namespace deadpoint::report {

struct Chart;
struct SweepResult;

/// Points whose course over time is drawn by sweep_drift_chart() in any set. It needs points and study only.
std::set<std::size_t> points_over_time(const SweepResult& result);

/// E_SW over time, one curve per run; eight at most.
Chart sweep_drift_chart(const SweepResult& result, std::size_t set);

/// Rises at the end over the first axis, one curve per probe.
Chart sweep_rise_chart(const SweepResult& result, std::size_t set);

/// Largest |E_SW| and that at the end over the first axis, with the limits.
Chart sweep_limit_chart(const SweepResult& result, std::size_t set);

/// Largest |E_SW| and that at the end for every place of a set of two axes, with the window outlined, as an SVG
/// document.
/// @throws DomainError if the set has not two axes
std::string sweep_map(const SweepResult& result, std::size_t set, const std::optional<twin::DriftWindow>& window);

/// Writes <set>-drift.svg, <set>-rises.svg, <set>-limits.svg and, for two axes, <set>-map.svg;
/// charts without values are left out.
/// @param comments  for the head of each file
/// @throws IoError if a file cannot be written
void write_sweep_charts(const std::filesystem::path& folder, const SweepResult& result,
                        const std::vector<std::string>& comments);

}  // namespace deadpoint::report
