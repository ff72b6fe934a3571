/// Requirement: fields in files come back as they were, belong to their mesh, and a run that was stopped goes on bit by
/// bit.
#include "../../scratch_folder.hpp"
#include "bricks.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/exchange/machine.hpp"
#include "deadpoint/fem/conduction/checkpoint.hpp"
#include "deadpoint/fem/conduction/heat_solver.hpp"
#include "deadpoint/fem/conduction/thermal_state.hpp"
#include "deadpoint/fem/space/file_order.hpp"
#include "deadpoint/observer.hpp"

#include <doctest/doctest.h>
#include <filesystem>
#include <limits>
#include <set>

using namespace deadpoint;
using namespace deadpoint::fem;
using bricks::Brick;

namespace {

Machine blocks(double height = 1)
{
    return bricks::machine_of(
        {{{0, 0, 0}, {1, 1, height}, {2, 1, 1}, false, {}}, {{0, 0, 2}, {1, 1, 3}, {1, 2, 1}, true, {}}});
}

ThermalState warm(const Discretisation& space)
{
    return {{bricks::values_of(space, [](const Vec3& x) { return 300 + x[0] / 3 + x[1] * x[2] / 7; })},
            {310.1},
            {295.3, 296.7}};
}

}  // namespace

TEST_CASE("a file's order holds each unknown once, by its first cell, and a share comes back to its place")
{
    const bricks::Space both(blocks(), {1, 2});
    const auto order = order_of_file(both.space);
    CHECK(order.size() == static_cast<std::size_t>(both.space.total));
    CHECK(std::set<std::size_t>(order.begin(), order.end()).size() == order.size());
    const auto first = both.space.unknowns_of(0);
    for (std::size_t i = 0; i < first.size(); ++i)
        CHECK(order[i] == first[i]);
    const auto values = bricks::values_of(both.space, [](const Vec3& x) { return x[0] + 10 * x[1] + 100 * x[2]; });
    std::vector<double> in_file;
    for (const auto unknown : order)
        in_file.push_back(values[unknown]);
    CHECK(share_of_file(both.space, order, in_file) == values);
}

TEST_CASE("a mesh's text tells meshes, elements and numbers of unknowns apart")
{
    const bricks::Space one(blocks(), {1, 1}), again(blocks(), {1, 1}), moved(blocks(1.0001), {1, 1}),
        second(blocks(), {1, 2}), both(blocks(), {2, 2});
    CHECK(mesh_text(one.space) == mesh_text(again.space));
    std::set<std::string> texts;
    for (const auto* at : {&one, &moved, &second, &both})
        texts.insert(mesh_text(at->space));
    CHECK(texts.size() == 4);
    CHECK(mesh_text(second.space).find("order 12 unknowns ") != std::string::npos);
    CHECK(mesh_text(both.space).find("order 2 unknowns ") != std::string::npos);
    // A nanometre is none of its business.
    const bricks::Space nearly(blocks(1 + 1e-10), {1, 1});
    CHECK(mesh_text(nearly.space) == mesh_text(one.space));
}

TEST_CASE("a thermal state comes back from its file to the bit")
{
    const ScratchFolder folder;
    const auto file = (folder.path / "state").string();
    const bricks::Space both(blocks(), {1, 2});
    const auto state = warm(both.space);
    write_thermal_state(file, both.space, state);
    const auto read = read_thermal_state(file, both.space, state);
    CHECK(read.temperature.owned == state.temperature.owned);
    CHECK(read.sumps == state.sumps);
    CHECK(read.enclosures == state.enclosures);
}

TEST_CASE("a thermal state of another mesh or other circuits is refused, with what it is and what is wanted")
{
    const ScratchFolder folder;
    const auto file = (folder.path / "state").string();
    const bricks::Space both(blocks(), {1, 1}), other(blocks(1.2), {1, 1});
    const auto state = warm(both.space);
    write_thermal_state(file, both.space, state);
    CHECK_THROWS_WITH_AS(read_thermal_state(file, other.space, state),
                         doctest::Contains(mesh_text(other.space).c_str()), InputError);
    auto like = state;
    like.sumps.clear();
    CHECK_THROWS_AS(read_thermal_state(file, both.space, like), InputError);
    like = state;
    like.enclosures.push_back(300);
    CHECK_THROWS_AS(read_thermal_state(file, both.space, like), InputError);
    CHECK_THROWS_AS(read_thermal_state(file + ".none", both.space, state), IoError);
}

TEST_CASE("a thermal state that was cut, changed, or holds no temperature is refused")
{
    const ScratchFolder folder;
    const auto file = folder.path / "state";
    const bricks::Space both(blocks(), {1, 1});
    auto state = warm(both.space);
    write_thermal_state(file.string(), both.space, state);
    const auto whole = content(file);
    folder.file("state", whole.substr(0, whole.size() - 9));
    CHECK_THROWS_AS(read_thermal_state(file.string(), both.space, state), IoError);
    auto changed = whole;
    changed[changed.size() / 2] = static_cast<char>(changed[changed.size() / 2] ^ 1);
    folder.file("state", changed);
    CHECK_THROWS_AS(read_thermal_state(file.string(), both.space, state), IoError);
    for (const double wrong : {0.0, -3.0}) {
        state.temperature.owned[3] = wrong;
        write_thermal_state(file.string(), both.space, state);
        CHECK_THROWS_AS(read_thermal_state(file.string(), both.space, state), DomainError);
    }
    state.temperature.owned[3] = std::numeric_limits<double>::quiet_NaN();
    write_thermal_state(file.string(), both.space, state);
    CHECK_THROWS_AS(read_thermal_state(file.string(), both.space, state), IoError);  // no file has such a number
    CHECK_THROWS_AS(write_thermal_state((folder.path / "none" / "state").string(), both.space, warm(both.space)),
                    IoError);
}

namespace {

/// Blocks that radiate and exchange with enclosed air, with a motor; two segments of steps of 100 s.
struct Run {
    Run() : both(machine(), {1, 1}), materials(2, bricks::steel())
    {
        problem.body_heat = {{"motor", {0}, -1}};
        problem.enclosures = {{"cabin", 3000, 4, 295}};
        problem.surfaces.resize(2);
        for (int s = 0; s < 2; ++s) {
            problem.surfaces[s].surface = s;
            problem.surfaces[s].coefficient = 8;
        }
        problem.surfaces[0].emissivity = 0.7;
        problem.surfaces[1].enclosure = 0;
        problem.fixed_step = 100;
        problem.field_times = {150, 550};
        for (const double duration : {300.0, 400.0}) {
            HeatSegment segment;
            segment.duration = duration;
            segment.body_heat = {[](double time) { return 5e4 + 10 * time; }};
            segment.ambient = [](double) { return 290.0; };
            problem.segments.push_back(segment);
        }
        start = {{bricks::values_of(both.space, [](const Vec3& x) { return 300 + x[2]; })}, {}, {295}};
    }
    static Machine machine()
    {
        auto result = blocks();
        bricks::add_surface(result, 0, 2, true);
        bricks::add_surface(result, 0, 0, true);
        return result;
    }
    struct Result {
        ThermalHistory history;
        ThermalState end;
        std::vector<std::pair<double, Field>> fields;
    };
    Result go(Observer& observer, CheckpointPlan* plan) const
    {
        Result result;
        if (plan)
            plan->handed_on = [&] {
                std::vector<HandedField> handed;
                for (const auto& [time, field] : result.fields)
                    handed.push_back({time, std::span<const double>(field.owned)});
                return handed;
            };
        HeatSolver solver(both.space, materials, problem);
        solver.start_from(start);
        result.history = solver.run(
            {}, 293, {-1}, observer, {},
            [&](double time, const Field& field) { result.fields.emplace_back(time, field); }, plan);
        result.end = solver.state();
        return result;
    }
    bricks::Space both;
    std::vector<Material> materials;
    HeatProblem problem;
    ThermalState start;
};

RunMark mark(const std::string& hash) { return {hash, hash, {"one", "two"}, {300, 400}}; }

struct Stopping : Observer {
    explicit Stopping(int after_) : after(after_) {}
    [[nodiscard]] bool cancelled() const override { return ++asked > after; }
    int after;
    mutable int asked = 0;
};

}  // namespace

TEST_CASE("a run that goes on from its checkpoint is the whole run to the bit, in either segment")
{
    const ScratchFolder folder;
    const Run run;
    Observer silent;
    const auto whole = run.go(silent, nullptr);
    REQUIRE(whole.history.time.size() == 3 + 4 + 2);
    for (const int steps : {1, 3, 5}) {
        CAPTURE(steps);
        CheckpointPlan plan;
        plan.file = (folder.path / "checkpoint").string();
        plan.run = mark("1234");
        plan.interval = 1e9;  // when stopped, and not before
        Stopping stop(steps - 1);
        const auto part = run.go(stop, &plan);
        CHECK(part.history.interrupted);
        CHECK(part.history.time.back() == 100 * steps);
        plan.from = plan.file;
        const auto rest = run.go(silent, &plan);
        CHECK(rest.history.time == whole.history.time);
        CHECK(rest.history.part_means[0].value == whole.history.part_means[0].value);
        CHECK(rest.history.enclosures[0].temperature.value == whole.history.enclosures[0].temperature.value);
        CHECK(rest.history.energy.stored == whole.history.energy.stored);
        CHECK(rest.end.temperature.owned == whole.end.temperature.owned);
        REQUIRE(rest.fields.size() == 2);
        for (std::size_t k = 0; k < 2; ++k)
            CHECK(rest.fields[k].second.owned == whole.fields[k].second.owned);
    }
}

TEST_CASE("a checkpoint of another case or another start is refused")
{
    const ScratchFolder folder;
    Run run;
    CheckpointPlan plan;
    plan.file = (folder.path / "checkpoint").string();
    plan.run = mark("1234");
    plan.interval = 1e9;
    Stopping stop(1);
    run.go(stop, &plan);
    plan.from = plan.file;
    Observer silent;
    auto other = plan;
    other.run = mark("5678");
    CHECK_THROWS_WITH_AS(run.go(silent, &other), doctest::Contains("its hash is 1234, that of this one 5678"),
                         InputError);
    run.start.temperature.owned[2] += 1e-9;
    CHECK_THROWS_WITH_AS(run.go(silent, &plan), doctest::Contains("from other temperatures"), InputError);
}

TEST_CASE("a plan with an infinite interval writes nothing; one that cannot write warns and the run goes on")
{
    struct Warned : Observer {
        void warn(std::string_view text) override { texts.emplace_back(text); }
        std::vector<std::string> texts;
    };
    const ScratchFolder folder;
    const Run run;
    CheckpointPlan plan;
    plan.file = (folder.path / "checkpoint").string();
    plan.interval = std::numeric_limits<double>::infinity();
    Warned observer;
    run.go(observer, &plan);
    CHECK_FALSE(std::filesystem::exists(plan.file));
    CHECK(observer.texts.empty());
    plan.file = (folder.path / "none" / "checkpoint").string();
    plan.interval = 0;
    const auto result = run.go(observer, &plan);
    CHECK(result.history.time.back() == 700);
    CHECK(observer.texts.size() == 7);  // one a step
    CHECK(observer.texts.front().find("the run goes on without a new checkpoint") == 0);
}
