#include "../scratch_folder.hpp"
#include "deadpoint/core/hash.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/fem/model.hpp"
#include "deadpoint/full/run/run.hpp"
#include "deadpoint/press/problem/heat.hpp"
#include "deadpoint/press/translate/materials.hpp"
#include "near.hpp"
#include "solved_case.hpp"

#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sys/stat.h>

// What the operation does to a machine besides friction: oil on its way, motors, warm rings, pauses, a later start.

using namespace verification;

namespace {

// Both joints of three-blocks on one circuit of 0.01 kg/s, 19 W/K.
Case on_one_circuit(double flow = 0.01)
{
    auto input = read("three-blocks", {"friction.two.load_part=80 W"});
    input.lubricants["oil"].density = 1000;
    for (auto* joint : {"first", "second"})
        input.joints.at(joint).interfaces[0].oil = 4000;
    deadpoint::casefile::OilCircuit circuit;
    circuit.joints = {"first", "second"};
    circuit.flow = flow / 1000;
    circuit.lubricant = "oil";
    circuit.inlet_temperature = zero_celsius + 35;
    input.oil_circuits["main"] = circuit;
    return input;
}

Case in_still_air(Case input)
{
    input.surfaces.at("air").film->law = casefile::FilmCoefficient{0};
    return input;
}

const deadpoint::OilHistory& circuit(const SolvedCase& solved) { return solved.history().oil.at(0); }

}  // namespace

TEST_CASE("a cooled circuit agrees with the exchanger formulas at the joints' temperatures")
{
    const auto solved = solve(on_one_circuit());
    // Each joint is an exchanger with one side at constant temperature (Kays and London, Compact Heat Exchangers):
    // the oil closes the share 1 - exp(-N) of its distance to the film, N = h A / (m c).
    const double flow = 0.01 * 1900, inlet = zero_celsius + 35;
    double oil = inlet;
    for (std::size_t i = 0; i < 2; ++i) {
        const double units = 4000 * solved.machine.interfaces[i].area / flow;
        oil += (1 - std::exp(-units)) * (solved.history().source_temperature[i].back() - oil);
    }
    const double heat = flow * (oil - inlet);
    // Oil and films agree to a thousandth of the step's tolerance of 0.01 K, times h A of 13 W/K.
    CHECK(circuit(solved).heat.back() == near(heat, 1e-5));
    CHECK(circuit(solved).outlet.value.back() == near(oil, 1e-7));
    CHECK(circuit(solved).cooler.back() == near(heat, 1e-5));
    CHECK(circuit(solved).heat.back() > 20);
    CHECK(solved.history().to_oil.back() == near(circuit(solved).heat.back(), 1e-5));
    CHECK(solved.history().to_air.back() + solved.history().to_oil.back() == near(130, 1e-5));
}

TEST_CASE("oil takes all heat of joints in still air, and warms the later joint")
{
    const auto both = solve(in_still_air(on_one_circuit()));
    // 130 W over 19 W/K
    CHECK(circuit(both).outlet.value.back() - circuit(both).inlet.value.back() == near(130.0 / 19, 1e-6));
    auto alone = in_still_air(on_one_circuit());
    std::get<casefile::CalibratedFriction>(alone.friction.at("one").law).load_part = 0;
    const auto second = solve(alone);
    // Without heat in the first joint the oil reaches the second one cooler by about 50 W / 19 W/K.
    CHECK(both.history().source_temperature[1].back() - second.history().source_temperature[1].back() > 1.5);
}

TEST_CASE("much oil is as good as oil of constant temperature")
{
    const auto much = solve(on_one_circuit(1e6));
    auto constant = on_one_circuit();
    constant.oil_circuits.clear();
    for (auto* joint : {"first", "second"})
        constant.joints.at(joint).oil_temperature = zero_celsius + 35;
    // The oil warms by 130 W / 1.9e9 W/K.
    CHECK(largest_difference(solve(constant), much) < 1e-6);
}

TEST_CASE("a sump warms with its own time constant to where it loses what the joints give")
{
    auto input = in_still_air(on_one_circuit(0.1));
    auto& oil = input.oil_circuits.at("main");
    oil.inlet_temperature.reset();
    oil.sump_volume = 10;  // 1.9e7 J/K, three hundred times that of the blocks
    oil.sump_loss = 20;
    const double constant = 10 * 1000 * 1900.0 / 20;  // s
    input.operation[0].duration = 3 * constant;
    input.numerics.max_step = constant / 10;
    const auto solved = solve(input);
    const auto& history = solved.history();
    for (std::size_t i = 1; i < history.time.size(); ++i) {
        const double exact = 130.0 / 20 * (1 - std::exp(-history.time[i] / constant));
        // The blocks keep part of the heat at first: their 6e4 J/K by a few kelvins, over 20 W/K and the sump's 1.9e7.
        CHECK(std::abs(circuit(solved).sump.value[i] - zero_celsius - 20 - exact) < 0.005 * 130 / 20);
    }
    // What the joints gave is in the sump or lost from it: trapezoids of smooth curves.
    double lost = 0;
    for (std::size_t i = 1; i < history.time.size(); ++i)
        lost += 0.5 * 20 * (history.time[i] - history.time[i - 1]) *
                (circuit(solved).sump.value[i] + circuit(solved).sump.value[i - 1] - 2 * (zero_celsius + 20));
    const double kept = 1.9e7 * (circuit(solved).sump.value.back() - zero_celsius - 20);
    CHECK(kept + lost == near(history.energy.to_oil, 2e-3));
}

TEST_CASE("a sump without volume follows at once")
{
    auto input = on_one_circuit();
    auto& oil = input.oil_circuits.at("main");
    oil.inlet_temperature.reset();
    oil.sump_loss = 5;
    const auto solved = solve(input);
    CHECK(5 * (circuit(solved).sump.value.back() - zero_celsius - 20) == near(circuit(solved).heat.back(), 1e-5));
    CHECK(circuit(solved).inlet.value.back() == circuit(solved).sump.value.back());
}

TEST_CASE("oil stands while the press does, unless it is told to flow")
{
    auto input = on_one_circuit();
    input.operation[0].duration = 3600;
    input.operation.push_back(input.operation[0]);
    input.operation[1].speed = 0;
    const auto stopped = solve(input);
    CHECK(circuit(stopped).heat.back() == 0);
    CHECK(stopped.history().to_oil.back() == 0);
    CHECK(stopped.history().source_heat[0].back() == 0);
    input.oil_circuits.at("main").at_rest = true;
    CHECK(circuit(solve(input)).heat.back() != 0);
}

namespace {

// The middle block alone, in still air: 60 x 40 x 40 mm of bronze.
constexpr double middle_capacity = 0.06 * 0.04 * 0.04 * 8800 * 380;

Case with_motor(double power)
{
    auto input = in_still_air(read("three-blocks", {"friction.one.load_part=0 W"}));
    for (auto* joint : {"first", "second"}) {
        auto& interface = input.joints.at(joint).interfaces[0];
        interface.conductance = casefile::SideFilms{1e-9, 1e-9};
        interface.oil = 0;
    }
    deadpoint::casefile::HeatInput motor;
    motor.parts = {"middle*"};
    motor.power = deadpoint::casefile::Course{power, {}, {}};
    input.heat_sources["motor"] = motor;
    input.operation[0].duration = 1000;
    input.operation.push_back(input.operation[0]);
    input.operation[1].speed = 0;
    return input;
}

double middle_rise(const SolvedCase& solved, double time)
{
    for (std::size_t p = 0; p < solved.machine.parts.size(); ++p)
        if (solved.machine.parts[p].name == "middle_block")
            return deadpoint::interpolate(solved.history().time, solved.history().part_means[p], time) - zero_celsius -
                   20;
    FAIL("no such part");
    return 0;
}

}  // namespace

TEST_CASE("a motor warms its part by its power over the heat capacity, while the press runs")
{
    const auto solved = solve(with_motor(40));
    // The films of 1e-9 W/m2/K let 1e-9 of it out.
    CHECK(middle_rise(solved, 1000) == near(40 * 1000 / middle_capacity, 1e-7));
    CHECK(middle_rise(solved, 2000) == near(40 * 1000 / middle_capacity, 1e-7));
    CHECK(solved.history().body_heat[0].back() == 0);
    auto input = with_motor(40);
    input.heat_sources.at("motor").at_rest = true;
    CHECK(middle_rise(solve(input), 2000) == near(40 * 2000 / middle_capacity, 1e-7));
}

TEST_CASE("heat on a surface equals a flux of the same power, beside a film on the same surface")
{
    auto input = with_motor(40);
    auto& source = input.heat_sources.at("motor");
    source.parts.clear();
    source.surface = "top";
    auto& top = input.surfaces["top"];
    top.parts = {"middle_block"};
    top.select = casefile::Surface::Select::plane;
    top.axis = deadpoint::Axis::y;
    top.position = 0.05;
    const auto heated = solve(input);
    auto fluxed = input;
    fluxed.heat_sources.clear();
    fluxed.operation.pop_back();
    fluxed.surfaces.at("top").heat_flux = deadpoint::casefile::Course{40 / (0.06 * 0.04), {}, {}};
    // The still air of `exposed` must not go from the named faces that carry no condition.
    CHECK(middle_rise(heated, 1000) == near(middle_rise(solve(fluxed), 1000), 1e-9));
}

TEST_CASE("friction heat can go into the volume of a part")
{
    auto input = with_motor(0);
    input.heat_sources.clear();
    std::get<casefile::CalibratedFriction>(input.friction.at("one").law).load_part = 25;
    input.joints.at("first").interfaces[0].heat_into = "middle_block";
    const auto solved = solve(input);
    CHECK(middle_rise(solved, 1000) == near(25 * 1000 / middle_capacity, 1e-7));
    // and the joint is as warm as the part in the mean
    const auto& history = solved.history();
    CHECK(history.source_temperature[0].back() - zero_celsius - 20 == near(middle_rise(solved, 2000), 1e-9));
}

namespace {

struct Prepared {
    Case input;
    deadpoint::Machine machine;
    deadpoint::HeatProblem problem;
};

Prepared prepare(Case input)
{
    deadpoint::Observer silent;
    auto machine = deadpoint::full::prepare_machine(input, 1, silent);
    auto problem = deadpoint::press::describe_heat(input, machine, silent);
    return {std::move(input), std::move(machine), std::move(problem)};
}

deadpoint::ThermalHistory history_of(const Prepared& it)
{
    deadpoint::Observer silent;
    deadpoint::fem::Model model(it.machine, deadpoint::press::describe_materials(it.input, it.machine), 1, silent);
    model.assemble_heat(it.problem);
    return model.heat({}, zero_celsius + 20, -1, silent, {}, {});
}

}  // namespace

TEST_CASE("a load zone moves heat about without adding any")
{
    auto input = read("shaft-in-block", {"friction.bearing.viscous_part=0 W", "joints.bearing.turns_fully=false"});
    input.probes["above"] = {"block", {0, 0.05, 0.02}, ""};
    input.probes["below"] = {"block", {0, -0.035, 0.02}, ""};
    auto it = prepare(input);
    const auto even = history_of(it);
    for (auto& segment : it.problem.segments)
        for (auto& law : segment.interfaces)
            law.load_zone = [](const deadpoint::Vec3& x) { return x[1] > 0 ? 1.0 : 0.0; };
    const auto above = history_of(it);
    it.problem.segments[0].zoned_heat = {0.0};
    const auto none = history_of(it);

    const auto probe = [&](const deadpoint::ThermalHistory& h, const std::string& name) {
        for (std::size_t i = 0; i < it.problem.probes.size(); ++i)
            if (it.problem.probes[i].name == name)
                return h.probes[i].value.back();
        FAIL("no such probe");
        return 0.0;
    };
    CHECK(above.energy.generated == near(20 * 3600, 1e-12));
    CHECK(above.energy.mismatch() < 1e-6);
    CHECK(probe(above, "above") - probe(even, "above") > 0.1);
    CHECK(probe(above, "below") - probe(even, "below") < -0.1);
    // No load part, no zone: the same steps to the last digit.
    CHECK(probe(none, "above") == near(probe(even, "above"), 1e-12));
    // Linear: twice the zoned heat shifts twice as much. The steps differ, each within the case's 0.002 K.
    it.problem.segments[0].zoned_heat = {40.0};
    CHECK(probe(history_of(it), "above") - probe(even, "above") ==
          near(2 * (probe(above, "above") - probe(even, "above")), 0.02));
}

TEST_CASE("rings of different temperature change their heat")
{
    auto it = prepare(read("three-blocks"));
    it.problem.sources[0].inner_rings = {{0, false}};
    it.problem.sources[0].outer_rings = {{0, true}, {1, true}};
    it.problem.segments[0].ring_heat = {[](double difference) { return 0.7 * difference; }, {}};
    const auto history = history_of(it);
    const double area_0 = it.machine.interfaces[0].area, area_1 = it.machine.interfaces[1].area;
    const double outer = (area_0 * history.interface_b[0].value.back() + area_1 * history.interface_b[1].value.back()) /
                         (area_0 + area_1);
    const double difference = history.interface_a[0].value.back() - outer;
    CHECK(difference > 2);
    // A stage leaves the heat within 1e-5 of its law.
    CHECK(history.source_heat[0].back() == near(50 + 0.7 * difference, 2e-5));
    CHECK(history.energy.mismatch() < 1e-6);
}

namespace {

deadpoint::press::RunResult run(const Case& input, const deadpoint::full::RunOptions& options)
{
    deadpoint::Observer silent;
    const auto machine = deadpoint::full::prepare_machine(input, 1, silent);
    return deadpoint::full::run_case(input, machine, options, silent);
}

/// The same state with another last temperature [K], its length and checksum as they belong.
void write_with_last_value(const std::filesystem::path& file, std::string bytes, double value)
{
    const std::size_t at = bytes.size() - 3 * sizeof(double);  // before length and checksum
    std::memcpy(bytes.data() + at, &value, sizeof(value));
    deadpoint::StableHash hash;
    hash.add(std::string_view(bytes).substr(0, bytes.size() - sizeof(std::uint64_t)));
    const auto checksum = hash.value();
    std::memcpy(bytes.data() + bytes.size() - sizeof(checksum), &checksum, sizeof(checksum));
    std::ofstream(file, std::ios::binary) << bytes;
}

}  // namespace

TEST_CASE("a run goes on from a saved state")
{
    auto input = on_one_circuit();
    input.oil_circuits.at("main").inlet_temperature.reset();
    input.oil_circuits.at("main").sump_volume = 0.02;
    input.operation[0].duration = 3000;
    auto whole = input;
    whole.operation[0].duration = 6000;
    const ScratchFolder folder;
    const auto file = folder.path / "state.bin";
    const auto first = run(input, verification::ending_in(file));
    const auto second = run(input, verification::beginning_at(file));
    const auto both = run(whole, {});

    CHECK(second.thermal.interface_a[0].value.front() == near(first.thermal.interface_a[0].value.back(), 1e-14));
    CHECK(second.thermal.oil[0].sump.value.front() == first.thermal.oil[0].sump.value.back());
    CHECK(first.thermal.oil[0].sump.value.back() > zero_celsius + 20.5);
    // Other steps, each within 0.01 K.
    for (std::size_t i = 0; i < 2; ++i)
        CHECK(std::abs(second.thermal.interface_a[i].value.back() - both.thermal.interface_a[i].value.back()) < 0.03);
    CHECK(std::abs(second.thermal.oil[0].sump.value.back() - both.thermal.oil[0].sump.value.back()) < 0.03);

    SUBCASE("but not on another mesh")
    {
        auto other = input;
        other.parts.at("left_block").size = 0.01;
        CHECK_THROWS_WITH_AS(run(other, verification::beginning_at(file)), doctest::Contains("belongs to another mesh"),
                             deadpoint::InputError);
    }
    SUBCASE("nor from a file that is cut short, is something else, or is not there")
    {
        std::filesystem::resize_file(file, std::filesystem::file_size(file) - 4);
        CHECK_THROWS_WITH_AS(run(input, verification::beginning_at(file)), doctest::Contains("is cut short"),
                             deadpoint::IoError);
        std::ofstream(file) << "something else\n";
        CHECK_THROWS_WITH_AS(run(input, verification::beginning_at(file)), doctest::Contains("does not begin with"),
                             deadpoint::IoError);
        std::filesystem::remove(file);
        CHECK_THROWS_AS(run(input, verification::beginning_at(file)), deadpoint::IoError);
        REQUIRE(mkfifo(file.c_str(), 0600) == 0);
        CHECK_THROWS_WITH_AS(run(input, verification::beginning_at(file)), doctest::Contains("it is not a file"),
                             deadpoint::IoError);
    }
    SUBCASE("nor from one in which a bit was flipped, or that holds a temperature below absolute zero")
    {
        auto bytes = content(file);
        bytes[bytes.size() / 2] ^= 1;
        std::ofstream(file, std::ios::binary) << bytes;
        CHECK_THROWS_WITH_AS(run(input, verification::beginning_at(file)),
                             doctest::Contains("its checksum does not fit"), deadpoint::IoError);
        bytes[bytes.size() / 2] ^= 1;
        write_with_last_value(file, bytes, -1);
        CHECK_THROWS_WITH_AS(run(input, verification::beginning_at(file)), doctest::Contains("a temperature of -1 K"),
                             deadpoint::DomainError);
        write_with_last_value(file, bytes, 300);
        CHECK_NOTHROW(run(input, verification::beginning_at(file)));
    }
}

TEST_CASE("segments with films of their own conduct by them")
{
    auto it = prepare(read("three-blocks"));
    it.problem.segments[0].duration = 2000;
    auto tight = it.problem.segments[0];
    for (auto& law : tight.interfaces) {
        law.film_a *= 50;
        law.film_b *= 50;
    }
    auto loose = it;
    it.problem.segments.push_back(tight);
    loose.problem.segments.push_back(loose.problem.segments[0]);
    const auto changed = history_of(it), kept = history_of(loose);
    const auto drop = [](const deadpoint::ThermalHistory& h) {
        return std::abs(h.interface_a[1].value.back() - h.interface_b[1].value.back());
    };
    CHECK(drop(kept) > 5 * drop(changed));
    CHECK(changed.energy.mismatch() < 1e-6);
    // The steady state knows nothing of the segment before.
    it.problem.segments[1].duration = 3.6e7;
    auto only_tight = it;
    only_tight.problem.segments.erase(only_tight.problem.segments.begin());
    CHECK(drop(history_of(it)) == near(drop(history_of(only_tight)), 1e-6));
}
