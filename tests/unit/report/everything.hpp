#pragma once

#include "deadpoint/casefile/files/read.hpp"
#include "deadpoint/casefile/studies/study_file.hpp"
#include "deadpoint/exchange/drift.hpp"
#include "deadpoint/exchange/gaps.hpp"
#include "deadpoint/full/run/run.hpp"
#include "deadpoint/press/compare/compare.hpp"
#include "deadpoint/press/loads/loads.hpp"
#include "deadpoint/press/problem/heat_tables.hpp"
#include "deadpoint/press/result/accuracy.hpp"
#include "deadpoint/press/result/frame_result.hpp"
#include "deadpoint/press/result/friction_summary.hpp"
#include "deadpoint/press/result/loads_result.hpp"
#include "deadpoint/press/result/run_result.hpp"
#include "deadpoint/press/result/view_data.hpp"
#include "deadpoint/press/run/run_record.hpp"
#include "deadpoint/report/design/optimise_files.hpp"
#include "deadpoint/report/design/sensitivity_files.hpp"
#include "deadpoint/report/sweep/sweep_files.hpp"
#include "deadpoint/report/tables/sweep_figures.hpp"
#include "deadpoint/twin/explore/optimise.hpp"
#include "deadpoint/twin/explore/sensitivity.hpp"

#include <filesystem>

/// Results in which everything happens that a case can ask for, made up.
namespace everything {

using namespace deadpoint;
using namespace deadpoint::report;

inline Series series(double last) { return {{0, last / 2, last}, {0, 0, 0}}; }
inline std::vector<double> values(double last) { return {0, last / 2, last}; }

inline DriftSeries drift()
{
    DriftSeries drift;
    drift.time = {0, 1800, 20000};
    for (auto* each : {&drift.bearing_to_ground, &drift.table_to_ground, &drift.crank_to_slide, &drift.clearance,
                       &drift.gap, &drift.play}) {
        *each = series(1e-5);
    }
    drift.by_part = {values(1e-5)};
    return drift;
}

inline DriftCauses causes()
{
    DriftCauses causes;
    causes.time = 20000;
    causes.joints = {{"pin", 1e-6}};
    causes.heat_sources = {{"motor", 1e-6}};
    causes.surfaces = {{"base", 1e-6}};
    return causes;
}

inline GapSeries gaps()
{
    GapSeries gaps;
    gaps.parallelism = Parallelism{{{"front left", -0.1, -0.1, series(1e-6)}}, series(1e-6), series(1e-6), {}};
    gaps.clearances.push_back({"pin", ClearanceSeries::Kind::bearing, series(1e-6), 8e-5, {}});
    gaps.left_out = {"guide: it has no faces"};
    gaps.force = series(1e3);
    return gaps;
}

inline press::FrictionSummary friction()
{
    press::FrictionSummary summary;
    press::FrictionHeat row;
    row.row = "pins";
    row.law = "calibrated";
    row.joints = {"pin"};
    row.heat = [](double) { return LawValue{100, 0, true}; };
    row.load_part = 40;
    row.load_ratio = 1;
    summary.rows = {row};
    summary.bearings = {{"left", 1, 1}};
    press::PowerBalance balance;
    balance.rated = 1000;
    balance.at = {{293.15, 150, 1250, 7, 1.25}};
    summary.balance = balance;
    return summary;
}

inline press::FrameResult frame()
{
    press::FrameResult frame;
    frame.support_force = 1e3;
    frame.rods = {{"rod", "rods", 1e5, series(1e3), 0}};
    frame.bonds = {{"rod|bed", "rods", 0.1, -1e5, series(1e3), {{0, 1e6, {}, 0.1}}}};
    press::StressPeak peak;
    peak.part = "bed";
    frame.stress = {peak};
    return frame;
}

inline press::AccuracyReport accuracy()
{
    press::AccuracyReport report;
    report.why_not = "accuracy_rounds";
    report.rounds = {{100, 1e-5, {}, 1e-6, 0, "bed", 1}, {200, 1e-5, 1e-6, 1e-6, 1, "bed", 1}};
    report.parts = {{"bed", 0.1, 0.05, 200, 1e-6, false}};
    return report;
}

inline press::ViewData view()
{
    press::ViewData view;
    view.surface.vertices = {{}, {}, {}};
    view.surface.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    view.surface.triangles = {{0, 1, 2}};
    view.surface.parts = {{0, 3, 0, 1, 0, 0, 0}};
    view.time = {0};
    view.temperature = {{293, 293, 293}, {{1, 1, 1}}};
    view.displacement = {{{}, {}, {}}, {{{}, {}, {}}}};
    view.coefficients = {{1}};
    return view;
}

inline ThermalHistory thermal()
{
    ThermalHistory history;
    history.time = {0, 1800, 20000};
    history.probes = {series(300)};
    history.to_air = history.to_oil = values(1);
    history.body_heat = {values(5)};
    history.oil = {{series(300), series(310), series(305), values(1), values(1)}};
    history.enclosures = {{series(300), values(1), values(1), values(1)}};
    history.energy.generated = 1;
    return history;
}

/// A run in which everything happens.
inline press::RunResult run_of_all(const casefile::Case& input)
{
    press::RunResult result;
    result.thermal = thermal();
    result.probes = {{"top", result.thermal.probes[0]}};
    result.parts = {{"bed", {result.thermal.part_means.empty() ? series(300) : result.thermal.part_means[0], 0, 0}}};
    result.body_heat = {{"motor", result.thermal.body_heat[0]}};
    result.oil = {{"main", result.thermal.oil[0]}};
    result.enclosures = {{"crank_case", result.thermal.enclosures[0]}};
    result.joints = {{"pin", {series(300), values(100)}}};
    result.friction = {friction()};
    result.loads = std::make_shared<const press::LoadsResult>(press::compute_loads(input, nullptr, 0));
    result.drift = drift();
    result.causes = {causes()};
    result.gaps = gaps();
    result.bonds = {{"motor|frame", values(100)}};
    result.compliance = press::PressCompliance{2e-9, {{"front left", 1e-9}}, 5e-11, -1e-10};
    result.adjoint_check = press::AdjointCheck{};
    result.frame = frame();
    result.view = view();
    result.accuracy = accuracy();
    result.reduced = press::ReducedResult{"press.rom",
                                          200,
                                          {{"anywhere in the box", 0.1, 5e-8}},
                                          press::StatedError{"this run", 0.01, 1e-9},
                                          press::StatedError{"this run, to a full run", 0.02, 2e-9},
                                          press::Certified{"reason", 2e-7, {{"A", 0.1}}},
                                          {"ambient: 25 to 25"}};
    result.sensitivities = press::Sensitivities{
        20000, true, {"top"}, {{"friction.pin", 1, "", 0.1, -2e-5, {5}}, {"ambient", 20, "degC", 1, 1e-6, {0.5}}}};
    result.timings = {{"mesh", 1}};
    return result;
}

inline casefile::Case case_of_all()
{
    auto input = casefile::read_case(std::filesystem::path(DEADPOINT_TEST_DATA) / "study/balanced-crank.toml",
                                     {"crankshaft.model=flexible", "joints.guide.guide_length=100 mm"})
                     .value;
    input.chain.emplace();
    input.probes["top"].part = "bed";
    input.reference = casefile::Reference{"a book", 3600, {{"top", 3}}, {"oil.pins"}};
    return input;
}

inline Machine machine_of_all()
{
    Machine machine;
    machine.parts.resize(1);
    machine.parts[0].name = "bed";
    machine.parts[0].body = "frame";
    return machine;
}

inline press::HeatTables heat_of_all()
{
    press::HeatTables tables;
    tables.segment = 0;
    tables.temperatures = {293.15};
    tables.joints = {{"pins", "pin", "oil", {"pin"}, {100}, {true}}};
    tables.friction = {friction()};
    tables.conductances = {{"pin", "0", "given", 1e6, true, 0.1, 100, 100, true, {"a note"}, "joints.pin"}};
    tables.films = {{"wall", "vertical", 1, 1, 293.15, {{0, 5, 5, 5, true}}, {{1, 5, 5, 5, true}}}};
    return tables;
}

inline press::RunRecord record()
{
    press::RunRecord run;
    run.machine = "press";
    run.hash = "0123";
    run.time = {0, 3600};
    run.probes = {"top"};
    run.rises["top"] = {0, 3};
    run.chain["E_SW"] = {0, 1e-5};
    run.joint_heat["pin"] = {100, 80};
    run.gap = press::GapFigures{1e-5, 1e-5, 1800};
    run.loads = {{"crankshaft.rigid.seats.B.peak_N", 1000}};
    return run;
}

inline SweepResult sweep_of_all()
{
    SweepResult result;
    twin::SweepAxis speed;
    speed.name = "speed";
    speed.keys = {"operation.0.speed"};
    speed.values = {{"100 rpm"}, {"200 rpm"}};
    speed.labels = {"100 rpm", "200 rpm"};
    speed.numbers = {10, 20};
    speed.dimension = Dimension::angular_velocity;
    result.study.name = "all";
    result.study.limits = {1e-3, 1e-3};
    result.study.sets = {{"speed", {speed}}};
    result.points = {{"slow", {"operation.0.speed=100 rpm"}, {{0, {0}}}}, {"fast", {}, {{0, {1}}}}};
    result.outcomes = {{twin::PointOutcome::State::done, "", 1}, {twin::PointOutcome::State::failed, "why", 1}};
    result.records = {record(), std::nullopt};
    result.reduced_model = "press.rom";
    return result;
}

inline press::Comparison comparison_of_all()
{
    press::Comparison all;
    all.values.push_back(
        {press::ValueKind::rises, "rises", "top at 1 h", Dimension::temperature_difference, 1, 2, 3.0, true, "a note"});
    all.groups.push_back({press::ValueKind::rises, "rises", Dimension::temperature_difference, true, {}, "top"});
    press::ComparedCurve curve;
    curve.name = "top";
    curve.time = curve.reference = curve.computed = curve.baseline = {0};
    curve.note = "a note";
    all.curves = {curve};
    all.verdicts.push_back({"it opens", "opens", press::Verdict::Outcome::holds, "it does", "a note"});
    all.baseline = "other";
    return all;
}

/// A study of sensitivity with what its report refers to.
struct SensitivityOfAll {
    casefile::StudyFile study;
    twin::SensitivityResult result;
    [[nodiscard]] SensitivityReport report() const { return {{study, "press", "0123", "press.rom", 2}, result}; }
};

inline SensitivityOfAll sensitivity_of_all()
{
    using twin::Figure;
    SensitivityOfAll all;
    all.study.name = "what matters";
    all.study.sensitivity.emplace();
    all.study.sensitivity->course_times = 1;
    all.study.sensitivity->parameters.resize(2);
    all.result.ranges.resize(2);
    all.result.ranges[0] = {"oil", twin::VariedRange::Kind::factor, 0.5, 2};
    all.result.ranges[1] = {"speed", twin::VariedRange::Kind::value, 10, 20, Dimension::angular_velocity, 14.14};
    all.result.outputs = {{twin::ForwardOutput::Kind::dimension, "E_SW", 0},
                          {twin::ForwardOutput::Kind::probe, "top", 0}};
    all.result.runs = 32;
    const design::SobolIndices indices{
        1e-5, 1e-12, 8, {{{0.3, 0.2, 0.4}, {0.4, 0.3, 0.5}}, {{0.6, 0.5, 0.7}, {0.7, 0.6, 0.8}}}};
    all.result.figures = {{{Figure::Kind::end, 0, 0}, indices, {}, {0.5, 0.8}},
                          {{Figure::Kind::at_time, 1, 1800}, indices, {}, {0.5, 0.8}},
                          {{Figure::Kind::warm, 0, 0}, indices, {}, {0.5, 0.8}}};
    all.result.course = {{{Figure::Kind::at_time, 0, 3600}, indices, {}, {}}};
    all.result.points = {{1.5, 15}};
    all.result.values = {{1e-6, 300, 7200}};
    return all;
}

inline SensitivityOfAll screening_of_all()
{
    auto all = sensitivity_of_all();
    all.study.sensitivity->method_name = "morris";
    for (auto* figures : {&all.result.figures, &all.result.course})
        for (auto& figure : *figures) {
            figure.sobol = {};
            figure.bound.clear();
            figure.morris = {{{2e-6, 1e-6, 3e-6}, -1e-6, 1e-6}, {{4e-6, 3e-6, 5e-6}, 4e-6, 0}};
        }
    return all;
}

/// A search for an optimum with what its report refers to.
struct OptimiseOfAll {
    casefile::StudyFile study;
    twin::OptimiseResult result;
    twin::FullDesign full;
    [[nodiscard]] OptimiseReport report() const { return {{study, "press", "0123", "press.rom", 2}, result, &full}; }
};

inline OptimiseOfAll optimise_of_all()
{
    OptimiseOfAll all;
    all.study.name = "best";
    auto& section = all.study.optimise.emplace();
    section.rate = 1e-6 / 3600;
    section.speed_profile = casefile::SpeedProfile{0, {600}, 10, 20, {}};
    section.limits = {{"top", "60 degC", "", 0, 333.15, {}}, {"E_SW", "", "-80 um", 0, {}, -8e-5}};
    all.result.ranges.resize(1);
    all.result.ranges[0] = {"speed 1", twin::VariedRange::Kind::value, 10, 20, Dimension::angular_velocity, 14.14};
    all.result.starts = {
        {{0.5}, {{0.7}, 3600, true, "the objective no longer changed", {{{0.7}, 3600, 0}}}, {"objective"}}};
    all.result.feasible = true;
    all.result.minima = 1;
    all.result.before = all.result.after = all.full.figures = {1e-6, 2e-6, 3600, 1e-7, {330, -7e-5}};
    all.result.course_before = all.result.course_after = all.full.course = {{0, 3600}, {0, 1e-6}};
    all.result.optimum = case_of_all();
    return all;
}

}  // namespace everything
