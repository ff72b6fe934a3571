#pragma once

#include "deadpoint/press/run/run_record.hpp"
#include "deadpoint/twin/map/drift_window.hpp"
#include "deadpoint/twin/map/sweep_plan.hpp"

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

/// A study with the results of its runs, and the figures for all tables and charts.
namespace deadpoint::report {

/// One entry per point in outcomes and records; a record is there if the run of the point is.
struct SweepResult {
    twin::SweepStudy study;
    std::vector<twin::SweepPoint> points;
    std::vector<twin::PointOutcome> outcomes;
    std::vector<std::optional<press::RunRecord>> records;
    std::string reduced_model;  ///< file of the reduced model that computed it; then no point has a folder
};

/// Drift of a run over its time; lengths in [m], in the sign of E_SW.
struct SweepDrift {
    double largest = 0;  ///< where |E_SW| is largest
    double largest_time = 0;
    double final = 0;
    std::optional<press::GapFigures> gap;
};

/// Figures of a run for the tables.
struct SweepFigures {
    std::optional<SweepDrift> drift;               ///< without a dimension chain: none
    std::map<std::string, double> rises;           ///< by probe, at the end [K]
    std::optional<double> joint_heat;              ///< of all joints, at the end [W]
    std::map<std::string, double> bearing_forces;  ///< peaks, by model and seat: "flexible B" [N]
};
SweepFigures sweep_figures(const press::RunRecord& run);

/// The same for all points; nothing where there is no record, or that of an interrupted run.
/// @throws DomainError if there is not one outcome and one record or gap per point
std::vector<std::optional<SweepFigures>> sweep_figures(const SweepResult& result);

/// Magnitudes of the drift, to compare with limits.
std::optional<twin::PointDrift> magnitudes(const SweepFigures& figures);

/// The best window of each set; nothing if the study has no limits.
std::vector<std::optional<twin::DriftWindow>> sweep_windows(const SweepResult& result);

/// Numbers of an axis in one unit: that of its values if they share it, else the preferred one of their dimension.
struct AxisNumbers {
    std::string unit;
    std::vector<double> values;  ///< per step; empty where the axis has no numbers
};
AxisNumbers axis_numbers(const twin::SweepAxis& axis);

/// Point at each place of a set, the last axis changing fastest.
std::vector<std::size_t> points_of_set(const SweepResult& result, std::size_t set);

/// Steps of a place by its index in that order.
std::vector<std::size_t> steps_at(const twin::SweepSet& set, std::size_t index);

/// Labels of a place, "300 rpm, 100 kN"; "base case" for a set without axes.
std::string place_label(const twin::SweepSet& set, const std::vector<std::size_t>& steps);

const char* state_name(twin::PointOutcome::State state);

/// The range of each axis in a window, in words: "speed 200 rpm to 400 rpm".
std::string window_text(const twin::SweepSet& set, const std::optional<twin::DriftWindow>& window);

/// The limits in words: "largest |E_SW| up to 10 um".
std::string limits_text(const twin::DriftLimits& limits);

}  // namespace deadpoint::report
