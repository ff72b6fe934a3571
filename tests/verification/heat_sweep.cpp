#include "deadpoint/error.hpp"
#include "deadpoint/full/sweep/sweep.hpp"
#include "deadpoint/twin/map/sweep_plan.hpp"
#include "solved_case.hpp"

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <unistd.h>

// Many runs on one prepared model give what single runs give, side by side or in turn, whatever becomes of one of them.

using namespace verification;
using deadpoint::full::Press;
using deadpoint::twin::PointOutcome;
using deadpoint::twin::SweepPoint;
namespace fs = std::filesystem;

namespace {

class Scratch {
public:
    Scratch() : path(fs::temp_directory_path() / ("deadpoint-sweep-" + std::to_string(getpid())))
    {
        fs::create_directories(path);
    }
    ~Scratch() { fs::remove_all(path); }
    fs::path path;
};

/// The final temperatures of a run, with all digits.
std::string digest(const deadpoint::press::RunResult& result)
{
    std::ostringstream text;
    text << std::setprecision(17);
    for (const auto& series : result.thermal.part_means)
        text << series.value.back() << '\n';
    return text.str();
}

/// Whether a point left the temperatures of a single run. Sums in memory of other alignment differ in the last digits.
bool agrees(const fs::path& path, const Case& input)
{
    std::ifstream stream(path);
    const auto alone = solve(input);
    for (const auto& series : alone.history().part_means) {
        double value = 0;
        if (!(stream >> value) || std::abs(value - series.value.back()) > 1e-10)
            return false;
    }
    return true;
}

struct Study {
    std::vector<SweepPoint> points;
    std::vector<Case> cases;
    std::vector<std::size_t> all;

    void add(const std::string& name, const std::vector<std::string>& overrides)
    {
        all.push_back(points.size());
        points.push_back({name, overrides, {}});
        cases.push_back(read("shaft-in-block", overrides));
        cases.back().operation[0].duration = 60;
    }
};

Study four_loads()
{
    Study study;
    for (const char* watts : {"20", "30", "40", "50"})
        study.add(watts, {std::string("friction.bearing.load_part=") + watts + " W"});
    return study;
}

void write_digest(const fs::path& folder, const SweepPoint& point, Press& press)
{
    deadpoint::Observer silent;
    std::ofstream(folder / point.name) << digest(press.run({}, silent));
}

class Listener : public deadpoint::Observer {
public:
    void stage(std::string_view name) override { stages.emplace_back(name); }
    [[nodiscard]] bool cancelled() const override { return stop; }
    std::vector<std::string> stages;
    bool stop = false;
};

/// Runs all points; each leaves its digest in the folder, after `before`.
std::vector<PointOutcome> outcomes_of(const Study& study, int workers, const Scratch& scratch, Listener& listener,
                                      const std::function<void(const SweepPoint&)>& before = {})
{
    return deadpoint::full::run_points(
        study.points, study.cases, study.all, {workers, {}, {}},
        [&](const SweepPoint& point, Press& press) {
            if (before)
                before(point);
            write_digest(scratch.path, point, press);
        },
        listener);
}

}  // namespace

TEST_CASE("points give what single runs give, and the machine is meshed once")
{
    for (const int workers : {1, 3}) {
        CAPTURE(workers);
        const Scratch scratch;
        const auto study = four_loads();
        Listener listener;
        const auto outcomes = outcomes_of(study, workers, scratch, listener);
        CHECK(std::ranges::count(listener.stages, "mesh") == 1);
        for (std::size_t p = 0; p < study.points.size(); ++p) {
            CHECK(outcomes[p].state == PointOutcome::State::done);
            CHECK(outcomes[p].seconds > 0);
            CHECK(agrees(scratch.path / study.points[p].name, study.cases[p]));
        }
    }
}

TEST_CASE("points that change the mesh or the films get their own")
{
    const Scratch scratch;
    auto study = four_loads();
    study.add("finer", {"numerics.size=12 mm", "parts.block.size=12 mm"});
    study.add("tighter", {"joints.bearing.interfaces.0.conductance.side_a=9000 W/m^2/K"});
    study.add("cooler", {"machine.ambient=10 degC"});
    Listener listener;
    const auto outcomes = outcomes_of(study, 2, scratch, listener);
    for (const auto p : {4u, 5u, 6u}) {
        CAPTURE(study.points[p].name);
        CHECK(outcomes[p].state == PointOutcome::State::done);
        CHECK(agrees(scratch.path / study.points[p].name, study.cases[p]));
    }
}

TEST_CASE("a point that fails leaves the others alone, and says why")
{
    for (const int workers : {1, 2}) {
        CAPTURE(workers);
        const Scratch scratch;
        auto study = four_loads();
        study.cases[1].numerics.time_tolerance = 1e-30;  // the time step collapses
        Listener listener;
        const auto outcomes = outcomes_of(study, workers, scratch, listener);
        CHECK(outcomes[1].state == PointOutcome::State::failed);
        CHECK(outcomes[1].reason.find("the time step collapsed") != std::string::npos);
        for (const auto p : {0u, 2u, 3u})
            CHECK(outcomes[p].state == PointOutcome::State::done);
    }
}

TEST_CASE("a process that dies is a failed point")
{
    const Scratch scratch;
    const auto study = four_loads();
    Listener listener;
    const auto outcomes = outcomes_of(study, 2, scratch, listener, [](const SweepPoint& point) {
        if (point.name == "30")
            std::raise(SIGKILL);
    });
    CHECK(outcomes[1].state == PointOutcome::State::failed);
    CHECK(outcomes[1].reason.find("signal 9") != std::string::npos);
    CHECK(outcomes[3].state == PointOutcome::State::done);
}

TEST_CASE("a cancelled study begins no further point")
{
    const Scratch scratch;
    const auto study = four_loads();
    Listener listener;
    const auto outcomes =
        outcomes_of(study, 1, scratch, listener, [&](const SweepPoint& point) { listener.stop = point.name == "30"; });
    CHECK(outcomes[0].state == PointOutcome::State::done);
    CHECK(outcomes[1].state == PointOutcome::State::left);
    CHECK(outcomes[2].state == PointOutcome::State::left);
    CHECK(!fs::exists(scratch.path / "40"));
}

TEST_CASE("a prepared press that takes another case computes what a new press computes for it")
{
    const auto starter = [](std::vector<std::string> changes) {
        changes.emplace_back("operation.0.duration=5 min");
        return casefile::read_case(std::string(DEADPOINT_VERIFICATION_CASES) + "/../../../cases/starter/case.toml",
                                   changes)
            .value;
    };
    deadpoint::Observer silent;
    Press kept(starter({}), 5);
    kept.prepare(silent);
    for (const auto* change :
         {"surfaces.air_frame.film.coefficient=9 W/m^2/K", "surfaces.air_frame.film.emissivity=0.2",
          "joints.crank_pin.interfaces.0.conductance.resistance=1e-4 m^2 K/W",
          "joints.crank_pin.interfaces.0.heat_into=connecting_rod", "joints.crank_bearing.interfaces.0.heat_share=3",
          "probes.slide.position=[\"0 mm\", \"-580 mm\", \"-100 mm\"]", "machine.initial_temperature=30 degC",
          "joints.crank_bearing.clearance=20 um", "lubricants.oil.library=ISO-VG-150"}) {
        CAPTURE(change);
        kept.take(starter({change}));
        Listener listener;
        const auto taken = kept.run({}, listener);
        CHECK(std::ranges::count(listener.stages, "mesh") == 0);
        const auto made = Press(starter({change}), 5).run({}, silent);
        REQUIRE(taken.thermal.probes.size() == made.thermal.probes.size());
        // The conduction matrix is summed from its terms, or integrated with them: the last digits differ.
        for (std::size_t p = 0; p < made.thermal.probes.size(); ++p)
            CHECK(std::abs(taken.thermal.probes[p].value.back() - made.thermal.probes[p].value.back()) < 1e-6);
        CHECK(std::abs(taken.drift->gap.value.back() - made.drift->gap.value.back()) < 1e-12);
    }
}
