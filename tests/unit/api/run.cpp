/// Requirement: results by name are those of the files, in SI units.
#include "../../scratch_folder.hpp"
#include "deadpoint/press/run/run_record.hpp"
#include "deadpoint/report/folder/read_result.hpp"
#include "near.hpp"
#include "starter.hpp"

#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>
#include <numbers>

using namespace deadpoint;

namespace {

constexpr double digits = 1e-7;  // the files have nine

class Stages : public Observer {
public:
    void stage(std::string_view name) override { names.emplace_back(name); }
    std::vector<std::string> names;
};

}  // namespace

TEST_CASE("a run's series by name equal what its files say")
{
    const ScratchFolder scratch;
    auto press = starter();
    const auto result = press.run({.folder = scratch.path / "results"});
    const auto files = report::read_result(scratch.path / "results");
    CHECK(result.folder == (scratch.path / "results").string());
    CHECK(result.case_hash == files.hash);
    for (const auto* file : {"report.html", "checkpoint.bin", "state.bin", "view.json", "fields.pvd"})
        CHECK_MESSAGE(std::filesystem::exists(scratch.path / "results" / file), file);
    CHECK(result.names(SeriesKind::probe) == files.probes);
    for (std::size_t row = 0; row < files.time.size(); ++row) {
        const double time = files.time[row];
        for (const auto& [probe, rises] : files.rises)
            CHECK(result.value(result.probe(probe), time) == near(result.initial_temperature + rises[row], digits));
        CHECK(std::abs(result.value(result.gap(), time) - files.chain.at("E_SW")[row]) < 1e-12);
        for (const auto& [joint, heat] : files.joint_heat)
            CHECK(result.value(result.joint_heat(joint), time) == near(heat[row], digits));
    }
    CHECK(result.probe("slide").unit == "K");
    CHECK(result.gap().unit == "m");
    CHECK(result.energy.mismatch < 1e-6);
    CHECK(result.time().back() == 600);
    CHECK_FALSE(result.interrupted);
}

TEST_CASE("parts sum to the gap, sources to the joints")
{
    auto press = starter();
    const auto result = press.run();
    CHECK(result.folder.empty());
    double gap = 0, joints = 0, sources = 0;
    for (const auto& part : result.names(SeriesKind::part))
        gap += result.at(SeriesKind::part, part, "gap").values.back();
    for (const auto& joint : result.names(SeriesKind::joint))
        joints += result.joint_heat(joint).values.back();
    for (const auto& source : result.names(SeriesKind::source))
        sources += result.at(SeriesKind::source, source, "heat").values.back();
    CHECK(gap == near(result.gap().values.back(), 1e-9));
    CHECK(joints == near(sources, 1e-12));
    CHECK(joints > 100);
}

TEST_CASE("both runs of a press have the warnings of reading and of its mesh, as its files do")
{
    const ScratchFolder scratch;
    auto press = starter({"bodies.slide.mass=1 t", "operation.0.duration=1 min"});
    const auto first = press.run({.folder = scratch.path / "first"}), second = press.run();
    CHECK(first.warnings == second.warnings);
    CHECK(std::ranges::count_if(first.warnings, [](const auto& text) {
              return text.find("bodies.slide.mass") != std::string::npos;
          }) == 1);
    CHECK(content(scratch.path / "first/summary.json").find("bodies.slide.mass") != std::string::npos);
}

TEST_CASE("a second run meshes nothing and gives the same")
{
    auto press = starter();
    Stages first, second;
    const auto one = press.run({}, &first);
    const auto other = press.run({}, &second);
    CHECK(std::ranges::count(first.names, "mesh") == 1);
    CHECK(std::ranges::count(second.names, "mesh") == 0);
    CHECK(std::ranges::count(second.names, "dimension chain") == 0);
    CHECK(other.gap().values.back() == near(one.gap().values.back(), 1e-9));
}

TEST_CASE("a name that is not there is told with the one that was meant")
{
    const RunResult result({0, 10}, {{SeriesKind::joint, "crank_pin", "heat", "W", {0, 8}},
                                     {SeriesKind::joint, "crank_pin", "temperature", "K", {300, 310}, {0, 2}}});
    CHECK(result.joint_heat("crank_pin").values.back() == 8);
    CHECK(result.find(SeriesKind::joint, "crank_pim", "heat") == nullptr);
    CHECK_THROWS_WITH_AS((void)result.joint_heat("crank_pim"),
                         "the result has no joint 'crank_pim'\n  help: did you mean 'crank_pin'?", InputError);
    CHECK_THROWS_WITH_AS((void)result.at(SeriesKind::joint, "crank_pin", "watts"),
                         "the result has no watts of joint 'crank_pin'\n  help: there are 'heat', 'temperature'",
                         InputError);
    CHECK_THROWS_WITH_AS((void)result.gap(), doctest::Contains("no dimension chain"), InputError);
}

TEST_CASE("values between the times: straight without rates, cubic with them, held beyond")
{
    const RunResult result({0, 10, 10, 20},
                           {{SeriesKind::joint, "pin", "heat", "W", {0, 8, 4, 4}},
                            {SeriesKind::joint, "pin", "temperature", "K", {0, 100, 100, 400}, {0, 20, 20, 40}}});
    const auto& heat = result.joint_heat("pin");
    CHECK(result.value(heat, 5) == 4);
    CHECK(result.value(heat, 10) == 4);  // after the jump
    CHECK(result.value(heat, 99) == 4);
    CHECK(result.value(heat, -1) == 0);
    for (const double time : {2.5, 5.0, 15.0})  // T = t^2 is exact for a cubic
        CHECK(result.value(result.joint_temperature("pin"), time) == near(time * time, 1e-5));
}

TEST_CASE("mesh, loads and heat tables of a press")
{
    auto press = starter();
    const auto mesh = press.mesh();
    CHECK(mesh.cells > 100);
    const auto loads = press.loads();
    CHECK(loads.segment == 0);
    CHECK(loads.speed == near(2 * std::numbers::pi, 1e-5));  // 60 rpm
    CHECK(loads.angle.size() == loads.time().size());
    const auto& height = loads.at(SeriesKind::slide, "slide", "height").values;
    CHECK(std::ranges::max(height) == near(loads.stroke, 1e-4));
    CHECK(std::ranges::min(height) == near(0, 0, 1.2e-5 * loads.stroke));
    CHECK(loads.at(SeriesKind::joint, "crank_pin", "force y").values.size() == loads.time().size());
    const auto tables = press.heat_tables();
    CHECK(tables.speed == near(loads.speed, 1e-5));
    REQUIRE(tables.joints.size() == 3);
    CHECK(tables.joints[0].heat.size() == tables.temperatures.size());
    CHECK(tables.conductances.size() > 3);
    CHECK(tables.films.size() > 3);
    CHECK_THROWS_WITH_AS((void)press.loads(7), doctest::Contains("there is no segment 7"), InputError);
}
