/// Requirement: points of a study share what they have in common, and each has the numbers of its own run.
#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/casefile/files/case_base.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/exchange/drift.hpp"
#include "deadpoint/press/result/run_result.hpp"
#include "deadpoint/twin/map/reduced_sweep.hpp"
#include "deadpoint/twin/run/run_reduced.hpp"
#include "starter_press.hpp"

#include <map>

using namespace deadpoint;
using namespace deadpoint::press;
using namespace deadpoint::twin;
using namespace deadpoint::full;

namespace {

// Changes of all that a reduced press lets free; the last two points fail.
const std::vector<std::vector<std::string>> changes{{},
                                                    {"machine.ambient=25 degC"},
                                                    {"oil.pins=400 W/m^2/K"},
                                                    {"friction.pins.scale=1.5"},
                                                    {"friction.pins.scale=1.5", "friction.gibs.load_part=20 W"},
                                                    {"surfaces.air_frame.film.coefficient=9 W/m^2/K"},
                                                    {"operation.0.speed=50 rpm", "operation.0.force=50 kN"},
                                                    {"operation.0.speed=50 rpm", "friction.journals.scale=0.5"},
                                                    {"friction.pins.reference_force=100 kN"},
                                                    {"operation.0.force=50 kN", "friction.pins.reference_force=100 kN"},
                                                    {},
                                                    {"materials.steel.density=7000 kg/m^3"},
                                                    {"operation.0.speed=50 kN"}};

/// The numbers of a run that a study may show.
std::vector<double> numbers_of(const RunResult& run)
{
    std::vector<double> result = run.thermal.time;
    const auto add = [&](const std::vector<double>& values) {
        result.insert(result.end(), values.begin(), values.end());
    };
    for (const auto& [name, probe] : run.probes)
        add(probe.value);
    for (const auto& [name, joint] : run.joints)
        add(joint.heat);
    add(run.drift->gap.value);
    return result;
}

}  // namespace

TEST_CASE("a point of a study has the numbers of a run by itself, bit by bit")
{
    const std::string file = DEADPOINT_SOURCE_DIR "/cases/starter/case.toml";
    const casefile::CaseBase base(file, casefile::FileAccess::below);
    std::vector<SweepPoint> points;
    std::vector<std::size_t> pending;
    for (const auto& change : changes) {
        pending.push_back(points.size());
        points.push_back({"", starter_press::settings(change), {}});
    }
    std::map<std::size_t, std::vector<double>> found;
    std::map<std::size_t, EndedPoint> ended;
    ReducedSweep sweep;
    sweep.read = [&](const SweepPoint& point) { return base.with(point.overrides); };
    sweep.record = [&](std::size_t point, const casefile::Case&, const RunResult& run) {
        found[point] = numbers_of(run);  // one thread
        return RunRecord{};
    };
    sweep.take = [&](std::size_t point, EndedPoint one) { ended.emplace(point, std::move(one)); };
    Observer quiet;
    run_points_reduced(points, pending, starter_press::press(), sweep, quiet);
    REQUIRE(ended.size() == points.size());
    for (std::size_t k = 0; k < points.size(); ++k) {
        CAPTURE(changes[k]);
        try {
            const auto alone = run_reduced(casefile::read_case(file, points[k].overrides).value, starter_press::press(),
                                           {}, ReducedDetail::figures, quiet);
            CHECK(ended.at(k).outcome.state == PointOutcome::State::done);
            CHECK(found.at(k) == numbers_of(alone));
        } catch (const Error& error) {
            CHECK(ended.at(k).outcome.state == PointOutcome::State::failed);
            CHECK(ended.at(k).outcome.reason == error.what());
        }
    }
}
