#include "../scratch_folder.hpp"
#include "busy_blocks.hpp"
#include "deadpoint/core/hash.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/full/run/run.hpp"

#include <algorithm>
#include <cstring>
#include <limits>

// A run that is stopped and resumed from its checkpoint is the run without a pause, bit by bit: all that a step starts
// from is kept, and the multigrid hierarchy, which outlasts its step, is built again from what it was built of.

using namespace verification;
using deadpoint::full::RunOptions;
using deadpoint::press::RunResult;

namespace {

struct Killed {};

/// Dies after some steps, before their last one is kept, as a kill would have it; counts them.
class Killer : public deadpoint::Observer {
public:
    explicit Killer(int after = std::numeric_limits<int>::max()) : left_(after) {}
    void progress(double, std::string_view) override
    {
        ++steps;
        if (--left_ == 0)
            throw Killed{};
    }
    int steps = 0;

private:
    int left_;
};

/// Asks for a stop after some steps.
class Stopper : public deadpoint::Observer {
public:
    explicit Stopper(int steps) : left_(steps) {}
    void progress(double, std::string_view) override { --left_; }
    [[nodiscard]] bool cancelled() const override { return left_ <= 0; }

private:
    int left_;
};

struct Press {
    explicit Press(Case given, double size_scale = 1)
        : input(std::move(given)), machine(deadpoint::full::prepare_machine(input, size_scale, silent))
    {
        options.view = true;
        options.causes = true;
        options.checkpoint_file = (folder.path / "run.checkpoint").string();
        options.checkpoint_interval = 0;
    }
    RunResult run(bool resume, deadpoint::Observer& observer)
    {
        options.resume_from = resume ? options.checkpoint_file : std::string{};
        return deadpoint::full::run_case(input, machine, options, observer);
    }
    RunResult resumed() { return run(true, silent); }
    /// Whether the run lived long enough to be killed after so many further steps.
    bool dies(bool resume, int after)
    {
        Killer killer(after);
        try {
            run(resume, killer);
        } catch (const Killed&) {
            return true;
        }
        return false;
    }
    void stop_after(int steps)
    {
        Stopper stopper(steps);
        run(false, stopper);
    }
    std::string refusal()
    {
        try {
            resumed();
        } catch (const deadpoint::Error& error) {
            return error.what();
        }
        return {};
    }

    deadpoint::Observer silent;
    ScratchFolder folder;
    Case input;
    deadpoint::Machine machine;
    RunOptions options;
};

using Columns = std::vector<std::vector<double>>;

/// Every number of a history.
Columns columns(const deadpoint::ThermalHistory& history)
{
    Columns all{history.time, history.to_air, history.to_oil, history.part_lowest, history.part_highest};
    for (const auto* group :
         {&history.probes, &history.interface_a, &history.interface_b, &history.part_means, &history.functionals})
        for (const auto& series : *group) {
            all.push_back(series.value);
            all.push_back(series.rate);
        }
    for (const auto* group :
         {&history.source_heat, &history.source_temperature, &history.body_heat, &history.contributions})
        all.insert(all.end(), group->begin(), group->end());
    for (const auto& oil : history.oil)
        all.insert(all.end(), {oil.inlet.value, oil.inlet.rate, oil.outlet.value, oil.outlet.rate, oil.sump.value,
                               oil.sump.rate, oil.heat, oil.cooler});
    for (const auto& air : history.enclosures)
        all.insert(all.end(), {air.temperature.value, air.temperature.rate, air.from_surfaces, air.power, air.to_room});
    const auto& energy = history.energy;
    all.push_back({energy.generated, energy.to_air, energy.to_oil, energy.from_surfaces, energy.stored});
    all.push_back({static_cast<double>(history.rejected_steps), static_cast<double>(history.linear_iterations),
                   static_cast<double>(history.linear_solves), history.law_out_of_range ? 1.0 : 0.0});
    return all;
}

/// The causes of the gap, which the run makes of what the steps have left.
Columns causes(const RunResult& result)
{
    Columns all;
    for (const auto& at : result.causes) {
        all.push_back({at.time, at.gap, at.oil, at.air, at.start, at.remainder});
        for (const auto* group : {&at.joints, &at.heat_sources, &at.surfaces})
            for (const auto& [name, value] : *group)
                all.push_back({value});
    }
    return all;
}

/// The causes and the view.
Columns afterwards(const RunResult& result)
{
    auto all = causes(result);
    REQUIRE(result.view);
    all.push_back(result.view->time);
    all.push_back(result.view->temperature.base);
    all.insert(all.end(), result.view->temperature.modes.begin(), result.view->temperature.modes.end());
    all.insert(all.end(), result.view->coefficients.begin(), result.view->coefficients.end());
    if (const auto& check = result.adjoint_check)
        all.push_back({check->time, check->by_adjoint, check->by_deformation});
    return all;
}

void check_same(const RunResult& one, const RunResult& other)
{
    CHECK(columns(one.thermal) == columns(other.thermal));
    CHECK(one.thermal.film_out_of_range == other.thermal.film_out_of_range);
    CHECK_FALSE(other.thermal.interrupted);
    CHECK(afterwards(one) == afterwards(other));
}

/// Kills a run again and again, at first after each step, then after every few.
int check_killed(Press& press)
{
    Killer counter;
    auto plain = press.options;
    plain.checkpoint_file.clear();
    const auto whole = deadpoint::full::run_case(press.input, press.machine, plain, counter);
    const auto steps = static_cast<int>(whole.thermal.time.size() - press.input.operation.size());
    CHECK(counter.steps == steps);
    int kills = 0;
    for (int after = 2; press.dies(kills > 0, after); after += 1 + steps / 12)
        ++kills;
    CHECK(kills > 2);
    check_same(whole, press.resumed());
    return kills;
}

/// Length and checksum that fit the bytes, as somebody would write them who means harm.
std::string stamped(std::string bytes)
{
    bytes.resize(bytes.size() - sizeof(std::uint64_t));
    deadpoint::StableHash hash;
    hash.add(bytes);
    const auto checksum = hash.value();
    return bytes.append(reinterpret_cast<const char*>(&checksum), sizeof checksum);
}

}  // namespace

TEST_CASE("resumed is the same: three segments with other films, friction, a motor, an oil circuit with a sump")
{
    Press press(on_an_oil_circuit(busy_blocks()));
    const auto result = check_killed(press);
    CHECK(result > 3);
}

TEST_CASE("resumed is the same: enclosed air")
{
    Press press(read("warm-box", {"machine.initial_temperature=80 degC", "enclosures.box.temperature=30 degC"}));
    check_killed(press);
}

TEST_CASE("resumed is the same: radiation in enclosed air that a law of its own describes, and a second segment")
{
    auto input =
        read("warm-box", {"surfaces.block_faces.film.emissivity=0", "surfaces.room.parts=[\"wall\"]",
                          "surfaces.room.select=plane", "surfaces.room.axis=y", "surfaces.room.position=110 mm",
                          "surfaces.room.film.coefficient=4 W/m^2/K", "surfaces.room.film.emissivity=0.9",
                          "machine.initial_temperature=80 degC", "enclosures.box.temperature=30 degC"});
    input.operation.push_back(input.operation[0]);
    Press press(input);
    check_killed(press);
}

TEST_CASE("resumed is the same: materials that follow the temperature")
{
    Press press(read("hot-plates", {"operation.0.duration=20 min"}));
    check_killed(press);
}

TEST_CASE("resumed is the same: a press with its dimension chain, causes and fields to write")
{
    Press press(read("../../../cases/starter/case",
                     {"operation.0.duration=20 min", "output.field_times=[\"3 min\", \"11 min\"]",
                      "numerics.time_tolerance=0.05 K"}),
                4);
    press.options.field_folder = press.folder.path.string();
    check_killed(press);
}

namespace {

/// A finished run of `shorter`, prolonged to the operation of `input`, has the history of one run of `input`.
void check_prolonged(const Case& shorter, const Case& input, double size_scale = 1)
{
    Press first(shorter, size_scale), whole(input, size_scale);
    const auto kept = (first.folder.path / "kept").string();
    first.options.checkpoint_file.clear();
    first.options.kept_checkpoint = kept;
    const auto beginning = first.run(false, first.silent);
    whole.options.checkpoint_file.clear();
    const auto at_once = whole.run(false, whole.silent);
    REQUIRE(beginning.thermal.time.size() < at_once.thermal.time.size());
    whole.options.resume_from = kept;
    Killer counter;
    const auto prolonged = deadpoint::full::run_case(input, whole.machine, whole.options, counter);
    CHECK(counter.steps < static_cast<int>(at_once.thermal.time.size()) / 2);  // so it was continued
    CHECK(columns(at_once.thermal) == columns(prolonged.thermal));
    CHECK(causes(at_once) == causes(prolonged));
    const auto& seen = prolonged.view->time;  // more fields than in one run: both ends are among them
    CHECK(std::is_sorted(seen.begin(), seen.end()));
    CHECK(seen.front() == 0);
    CHECK(seen.back() == prolonged.thermal.time.back());
    CHECK(std::ranges::count_if(seen, [&](double t) { return t < beginning.thermal.time.back(); }) > 20);
}

Case with_duration(Case input, double duration)
{
    input.operation.back().duration = duration;
    return input;
}

}  // namespace

TEST_CASE("a finished run whose last segment is longer now continues to the history of one run")
{
    // Both runs are longer than the longest step, so the multigrid hierarchy is the same to the last bit.
    auto blocks = busy_blocks();
    blocks.numerics.max_step = 200;
    check_prolonged(with_duration(blocks, 0.55 * blocks.operation.back().duration), blocks);
    auto box = read("warm-box", {"machine.initial_temperature=80 degC", "enclosures.box.temperature=30 degC"});
    box.numerics.max_step = 0.1 * box.operation.back().duration;
    check_prolonged(with_duration(box, 0.6 * box.operation.back().duration), box);
}

TEST_CASE("a finished run with further segments continues to the history of one run")
{
    const auto blocks = on_an_oil_circuit(busy_blocks());
    auto shorter = blocks;
    shorter.operation.pop_back();
    check_prolonged(shorter, blocks);
}

TEST_CASE("a run with a sump, whose steps follow the length of the segment, is prolonged within its time tolerance")
{
    const auto blocks = on_an_oil_circuit(busy_blocks());
    const auto shorter = with_duration(blocks, 0.55 * blocks.operation.back().duration);
    Press first(shorter), whole(blocks);
    first.options.kept_checkpoint = (first.folder.path / "kept").string();
    first.run(false, first.silent);
    const auto at_once = whole.run(false, whole.silent).thermal;
    whole.options.resume_from = first.options.kept_checkpoint;
    const auto prolonged = deadpoint::full::run_case(blocks, whole.machine, whole.options, whole.silent).thermal;
    REQUIRE(prolonged.time.back() == at_once.time.back());
    for (std::size_t i = 0; i < at_once.part_means.size(); ++i)
        CHECK(std::abs(prolonged.part_means[i].value.back() - at_once.part_means[i].value.back()) <
              blocks.numerics.time_tolerance);
    CHECK(std::abs(prolonged.oil[0].sump.value.back() - at_once.oil[0].sump.value.back()) <
          blocks.numerics.time_tolerance);
    CHECK(prolonged.energy.mismatch() < 1e-6);  // of one balance over the whole time
}

TEST_CASE("a finished run of a press is prolonged with its chain, causes and fields")
{
    const std::vector<std::string> changes{"output.field_times=[\"3 min\", \"11 min\"]",
                                           "numerics.time_tolerance=0.05 K", "numerics.max_step=3 min"};
    const auto input = read("../../../cases/starter/case", changes);
    check_prolonged(with_duration(input, 900), with_duration(input, 2400), 4);

    Press first(with_duration(input, 900), 4), longer(with_duration(input, 2400), 4);
    first.options.kept_checkpoint = longer.options.resume_from = (first.folder.path / "kept").string();
    first.run(false, first.silent);
    longer.options.field_folder = longer.folder.path.string();
    std::vector<double> written;
    for (const auto& [time, file] :
         deadpoint::full::run_case(longer.input, longer.machine, longer.options, longer.silent).fields)
        written.push_back(time);
    CHECK(written == std::vector<double>{180, 660, 900, 2400});
    longer.input.output.field_times = {240, 1200};
    CHECK_THROWS_WITH_AS(deadpoint::full::run_case(longer.input, longer.machine, longer.options, longer.silent),
                         doctest::Contains("the field of 0.07 h was not kept"), deadpoint::InputError);
}

TEST_CASE("an operation that differs before the time reached is refused, one that differs after it is not")
{
    const auto blocks = busy_blocks();
    Press press(blocks);
    press.stop_after(8);
    const auto bytes = content(press.options.checkpoint_file);
    const auto refused = [&](const Case& changed) {
        Press other(changed);
        other.options.checkpoint_file = other.folder.file("given", bytes).string();
        return other.refusal();
    };
    auto changed = blocks;
    changed.operation[0].speed *= 2;
    CHECK(refused(changed).find("another case") != std::string::npos);  // its loads place the guides
    changed = blocks;
    changed.operation[0].duration = 1;  // the run has gone further
    CHECK(refused(changed).find("operation.0.duration was 900 s and is 1 s now") != std::string::npos);
    changed = blocks;
    changed.operation.back().duration *= 3;
    CHECK(refused(changed).empty());
    changed.operation.push_back(changed.operation.front());
    CHECK(refused(changed).empty());
}

TEST_CASE("a run that was asked to stop goes on as if it had not been")
{
    Press press(read("warm-box", {"machine.initial_temperature=80 degC"}));
    const auto whole = press.run(false, press.silent);
    press.options.checkpoint_interval = 1e6;  // stopping writes one nevertheless
    std::filesystem::remove(press.options.checkpoint_file);
    press.stop_after(4);
    check_same(whole, press.resumed());
}

TEST_CASE("a checkpoint of another version, case, mesh or start is refused with what to do")
{
    Press press(read("warm-box", {"machine.initial_temperature=80 degC"}));
    press.stop_after(3);
    const auto bytes = content(press.options.checkpoint_file);
    const auto check = [&](Press& other, const std::string& what) {
        other.options.checkpoint_file = press.folder.file("given", bytes).string();
        const auto message = other.refusal();
        CAPTURE(message);
        CHECK(message.find(what) != std::string::npos);
        CHECK(message.find("given'") != std::string::npos);
        CHECK(message.find("without --resume") != std::string::npos);
    };
    Press warmer(read("warm-box", {"machine.initial_temperature=81 degC"}));
    check(warmer, "of another case");
    Press finer(press.input, 0.5);
    check(finer, "belongs to another mesh");
    Press later(press.input);
    later.options.start_from = (press.folder.path / "state.bin").string();
    {
        auto stated = press.options;
        stated.checkpoint_file.clear();
        stated.state_file = later.options.start_from;
        deadpoint::full::run_case(press.input, press.machine, stated, press.silent);
    }
    check(later, "from other temperatures");

    auto of_later = bytes;
    const auto version = of_later.find("0.1.0");
    REQUIRE(version != std::string::npos);
    of_later.replace(version, 5, "9.9.9");
    press.options.checkpoint_file = press.folder.file("given", stamped(of_later)).string();
    CHECK(press.refusal().find("of version 9.9.9") != std::string::npos);
    press.options.checkpoint_file = press.folder.file("given", of_later).string();
    CHECK(press.refusal().find("is broken") != std::string::npos);
    press.options.checkpoint_file = press.folder.file("given", bytes).string();
    CHECK(press.refusal().empty());
}

TEST_CASE("whatever stands in a checkpoint whose checksum fits, the run ends with a value or an error of ours")
{
    Press press(read("warm-box", {"machine.initial_temperature=80 degC", "operation.0.duration=1 h"}));
    press.options.view = press.options.causes = false;
    press.stop_after(3);
    const auto bytes = content(press.options.checkpoint_file);
    int refused = 0, tried = 0;
    // Counts and indices come first; the fields, two thirds of the file, are all numbers.
    for (std::size_t at = 120; at + 32 < bytes.size() / 3; at += 29)
        for (const std::uint64_t value : {std::uint64_t{0}, std::uint64_t{3}, ~std::uint64_t{0}}) {
            auto changed = bytes;
            std::memcpy(changed.data() + at, &value, sizeof value);
            press.options.checkpoint_file = press.folder.file("changed", stamped(changed)).string();
            ++tried;
            Stopper soon(1);
            try {
                press.run(true, soon);
            } catch (const deadpoint::Error&) {
                ++refused;
            }
        }
    CHECK(tried > 100);
    CHECK(refused > 10);
}
