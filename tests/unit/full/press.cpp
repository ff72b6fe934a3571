#include "deadpoint/full/run/press.hpp"

#include "deadpoint/casefile/files/read.hpp"
#include "deadpoint/exchange/heat.hpp"
#include "deadpoint/observer.hpp"
#include "deadpoint/press/loads/loads.hpp"
#include "deadpoint/press/problem/heat_tables.hpp"
#include "deadpoint/press/result/histories.hpp"
#include "deadpoint/press/result/loads_result.hpp"
#include "near.hpp"

#include <algorithm>
#include <doctest/doctest.h>
#include <string>
#include <utility>
#include <vector>

using namespace deadpoint;

namespace {

class Stages : public Observer {
public:
    void stage(std::string_view name) override { names.emplace_back(name); }
    [[nodiscard]] auto count(const std::string& name) const { return std::ranges::count(names, name); }
    std::vector<std::string> names;
};

casefile::Case starter(const std::vector<std::string>& overrides = {})
{
    return casefile::read_case(std::string(DEADPOINT_SOURCE_DIR) + "/cases/starter/case.toml", overrides).value;
}

/// One joint of two interfaces of 1 and 3 m2 that share a source, and one without any.
struct TwoInterfaces {
    casefile::Case input;
    Machine machine;
    HeatProblem problem;
    ThermalHistory history;

    TwoInterfaces()
    {
        input.joints["bearing"].interfaces.resize(2);
        input.joints["pin"] = {};
        machine.interfaces.resize(2);
        machine.interfaces[0].area = 1;
        machine.interfaces[1].area = 3;
        problem.interfaces.resize(2);
        problem.interfaces[0].source = problem.interfaces[1].source = 0;
        problem.sources.resize(1);
        history.time = {0, 10};
        history.interface_a = {{{300, 310}, {1, 0}}, {{300, 330}, {2, 0}}};
        history.interface_b = {{{300, 312}, {1, 0}}, {{300, 334}, {2, 0}}};
        history.source_heat = {{40, 80}};
        history.source_temperature = {{300, 320}};
    }
};

}  // namespace

TEST_CASE("a press meshes once, however often it is asked, and again only for a case with another mesh")
{
    full::Press press(starter(), 3);
    Stages stages;
    const auto cells = press.machine(stages).cells.size();
    CHECK(press.machine(stages).cells.size() == cells);
    press.mesh(stages);
    (void)press.heat_tables(0, stages);
    CHECK(stages.count("mesh") == 1);
    CHECK(press.mesh_seconds() > 0);

    press.take(starter({"operation.0.duration=1 min", "machine.ambient=10 degC"}));
    CHECK(press.machine(stages).cells.size() == cells);
    CHECK(stages.count("mesh") == 1);
    CHECK(press.input().operation.at(0).duration == 60);

    press.take(starter({"numerics.size=80 mm"}));
    CHECK(press.machine(stages).cells.size() != cells);
    CHECK(stages.count("mesh") == 2);
}

TEST_CASE("loads of a press are meshed only where masses follow from parts")
{
    Stages stages;
    full::Press by_parts(starter(), 3);
    CHECK(by_parts.loads(0, stages).speed > 0);
    CHECK(stages.count("mesh") == (press::loads_need_machine(starter()) ? 1 : 0));
}

TEST_CASE("a press that is moved keeps its mesh")
{
    Stages stages;
    full::Press one(starter(), 3);
    const auto cells = one.machine(stages).cells.size();
    full::Press other(starter());
    other = std::move(one);
    CHECK(other.machine(stages).cells.size() == cells);
    CHECK(stages.count("mesh") == 1);
}

TEST_CASE("a joint's temperature is the area mean of its interfaces, its heat that of the whole press")
{
    const TwoInterfaces it;
    const auto named = press::name_histories(it.input, it.machine, it.problem, it.history, 2);
    REQUIRE(named.joints.size() == 1);  // the pin has no interface
    CHECK(named.joints[0].name == "bearing");
    const auto& bearing = named.joints[0].history;
    CHECK(bearing.temperature.value.back() == near((311.0 + 3 * 332) / 4, 1e-5));
    CHECK(bearing.temperature.rate.front() == near((1.0 + 3 * 2) / 4, 1e-5));
    CHECK(bearing.heat == std::vector<double>{80, 160});
    CHECK(press::find(named.joints, "bearing") == &bearing);
    CHECK(press::find(named.joints, "pin") == nullptr);
}

TEST_CASE("heat weights share a source among the interfaces of two joints")
{
    TwoInterfaces it;
    it.input.joints["bearing"].interfaces.resize(1);
    it.input.joints["pin"].interfaces.resize(1);
    it.problem.interfaces[1].heat_weight = 5;  // 1 to 15 by weighted area
    const auto named = press::name_histories(it.input, it.machine, it.problem, it.history, 1);
    CHECK(press::find(named.joints, "bearing")->heat.back() == near(5, 1e-5));
    CHECK(press::find(named.joints, "pin")->heat.back() == near(75, 1e-5));
}
