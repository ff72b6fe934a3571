#include "deadpoint/study.hpp"

#include "deadpoint/api/full/press_parts.hpp"
#include "deadpoint/api/twin/diagnostics.hpp"
#include "deadpoint/api/twin/listener.hpp"
#include "deadpoint/api/twin/results.hpp"
#include "deadpoint/casefile/files/read.hpp"
#include "deadpoint/casefile/studies/reference_file.hpp"
#include "deadpoint/casefile/syntax/file_access.hpp"
#include "deadpoint/core/quantity.hpp"
#include "deadpoint/full/refine/refine.hpp"
#include "deadpoint/full/run/press.hpp"
#include "deadpoint/full/run/run.hpp"
#include "deadpoint/full/sweep/sweep.hpp"
#include "deadpoint/press/compare/compare.hpp"
#include "deadpoint/press/result/run_result.hpp"
#include "deadpoint/press/run/run_record.hpp"
#include "deadpoint/report/compare/compare_files.hpp"
#include "deadpoint/report/folder/read_result.hpp"
#include "deadpoint/twin/map/point_observer.hpp"
#include "deadpoint/twin/map/sweep_plan.hpp"

#include <numeric>
#include <utility>

namespace deadpoint {
namespace {

twin::SweepStudy study_of(const Press::Implementation& parts, const std::vector<SweepAxis>& axes)
{
    twin::SweepStudy study;
    study.name = "sweep";
    study.base = parts.file.string();
    study.overrides = parts.options.overrides;
    study.files = access_of(parts.options);
    twin::SweepSet set{"sweep", {}};
    for (const auto& axis : axes) {
        if (axis.values.empty())
            throw InputError("the axis '" + axis.key + "' of a sweep has no value");
        twin::SweepAxis one{axis.key, {axis.key}, {}, axis.values, {}, Dimension::none};
        for (const auto& value : axis.values)
            one.values.push_back({value});
        set.axes.push_back(std::move(one));
    }
    study.sets.push_back(std::move(set));
    return study;
}

/// The settings of a point, axis by axis.
std::vector<std::pair<std::string, std::string>> settings_of(const twin::SweepPoint& point,
                                                             const std::vector<SweepAxis>& axes)
{
    std::vector<std::pair<std::string, std::string>> settings;
    const auto& steps = point.places.front().steps;
    for (std::size_t a = 0; a < axes.size(); ++a)
        settings.emplace_back(axes[a].key, axes[a].values[steps[a]]);
    return settings;
}

casefile::Case case_of(const Press::Implementation& parts, const std::vector<std::string>& overrides)
{
    auto input = casefile::read_case(parts.file, overrides, access_of(parts.options)).value;
    full::scale_sizes(input, parts.options.size_scale);
    return input;
}

/// Numbers 0 to count - 1.
std::vector<std::size_t> all_of(std::size_t count)
{
    std::vector<std::size_t> result(count);
    std::iota(result.begin(), result.end(), std::size_t{0});
    return result;
}

Refinement refinement_of(const Press::Implementation& parts, full::RefinedRun run, std::vector<std::string> warnings)
{
    Refinement result{Press(nullptr), {}, false, {}, {}};
    const auto& report = *run.result.accuracy;
    result.reached = report.reached;
    result.why_not = report.why_not;
    for (const auto& round : report.rounds)
        result.rounds.push_back({round.cells, round.value, round.change, round.estimate});
    result.result = public_run(run.press->input(), run.result, std::move(warnings), {});
    result.press = Press(std::make_unique<Press::Implementation>(Press::Implementation{
        std::move(*run.press), parts.file, parts.options, parts.warnings, parts.reading, parts.inputs}));
    return result;
}

ComparedClaim::Outcome outcome_of(press::Verdict::Outcome outcome)
{
    using From = press::Verdict::Outcome;
    using To = ComparedClaim::Outcome;
    return outcome == From::holds ? To::holds : outcome == From::fails ? To::fails : To::unchecked;
}

}  // namespace

std::vector<SweepRun> sweep(const Press& press, const std::vector<SweepAxis>& axes, Observer* observer)
{
    require_session();
    ObserverOrNone to(observer);
    const auto& parts = press.implementation();
    const auto study = study_of(parts, axes);
    const auto points = twin::sweep_points(study, [](const auto&, const auto&) { return false; });
    std::vector<casefile::Case> cases;
    std::vector<SweepRun> runs;
    for (const auto& point : points) {
        cases.push_back(case_of(parts, point.overrides));
        runs.push_back({point.name, settings_of(point, axes), std::nullopt, {}});
    }
    const auto action = [&](const twin::SweepPoint& point, full::Press& shared) {
        twin::PointObserver quiet(to.get());
        const auto result = shared.run({}, quiet);
        runs[static_cast<std::size_t>(&point - points.data())].result =
            public_run(shared.input(), result, quiet.warnings, {});
    };
    const auto outcomes = full::run_points(points, cases, all_of(points.size()), {1, {}, {}}, action, to.get());
    for (std::size_t p = 0; p < runs.size(); ++p)
        runs[p].error = outcomes[p].reason;
    return runs;
}

Refinement refine(const Press& press, const std::string& accuracy, Observer* observer)
{
    require_session();
    ObserverOrNone to(observer);
    const auto& parts = press.implementation();
    auto overrides = parts.options.overrides;
    if (!accuracy.empty())
        overrides.push_back("numerics.accuracy=\"" + accuracy + "\"");
    const auto input = casefile::read_case(parts.file, overrides, access_of(parts.options)).value;
    Listener listener(to.get());
    auto run = full::run_to_accuracy(input, parts.options.size_scale, {}, listener);
    return refinement_of(parts, std::move(run), std::move(listener.warnings));
}

Comparison compare(const std::filesystem::path& results, const std::filesystem::path& reference,
                   const std::string& point)
{
    const auto run = report::read_result(results);
    const auto contents = press::contents(run);
    const auto file = casefile::read_reference(reference, point, &contents);
    const auto found = press::compare(run, file, point);
    Comparison comparison{{}, {}, found.warnings, report::compare_text(run, found)};
    for (const auto& value : found.values)
        comparison.values.push_back({value.name, std::string(dimension_info(value.dimension).si_unit), value.computed,
                                     value.reference, value.calibrated});
    for (const auto& verdict : found.verdicts)
        comparison.claims.push_back({verdict.text, outcome_of(verdict.outcome), verdict.evidence});
    return comparison;
}

}  // namespace deadpoint
