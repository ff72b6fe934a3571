/// Loads of a case: translation of its bodies, balance of every shipped case, and the crankshaft under the linkage.
#include "deadpoint/press/loads/loads.hpp"

#include "../mechanism/balance.hpp"
#include "../messages.hpp"
#include "deadpoint/casefile/files/read.hpp"
#include "deadpoint/crankshaft/modes.hpp"
#include "deadpoint/crankshaft/shaft/system.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/full/model/prepare.hpp"
#include "deadpoint/mechanism/bottom_dead_point.hpp"
#include "deadpoint/observer.hpp"
#include "deadpoint/press/loads/body_masses.hpp"
#include "deadpoint/press/result/loads_result.hpp"
#include "deadpoint/press/translate/linkage.hpp"
#include "deadpoint/press/translate/loads.hpp"
#include "near.hpp"

#include <algorithm>
#include <doctest/doctest.h>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <optional>
#include <sstream>

using namespace deadpoint;
using messages::has;

namespace {

namespace fs = std::filesystem;

constexpr double pi = std::numbers::pi;
const fs::path cases = fs::path(DEADPOINT_SOURCE_DIR) / "cases";
const fs::path data = fs::path(DEADPOINT_TEST_DATA) / "study";

casefile::Case read(const fs::path& path, const std::vector<std::string>& overrides = {})
{
    return casefile::read_case(path, overrides).value;
}

press::LoadsResult loads_of(const casefile::Case& input, int segment = 0)
{
    Observer quiet;
    std::optional<Machine> machine;
    if (press::loads_need_machine(input))
        machine = full::prepare_machine(input, 1.5, quiet);
    return press::compute_loads(input, machine ? &*machine : nullptr, segment);
}

std::string error_of(const casefile::Case& input, int segment = 0)
{
    return messages::error_of<InputError>([&] { loads_of(input, segment); });
}

/// Case files, in contrast to the files they include.
std::vector<fs::path> shipped_cases()
{
    std::vector<fs::path> paths;
    for (const auto& entry : fs::recursive_directory_iterator(cases)) {
        if (entry.path().extension() != ".toml")
            continue;
        std::ifstream stream(entry.path());
        std::ostringstream text;
        text << stream.rdbuf();
        // A press that only rests has no loads.
        if (has(text.str(), "\nformat = 1") && has(text.str(), "\n[machine]") &&
            !has(text.str(), "\nspeed = \"0 rpm\"\n"))
            paths.push_back(entry.path());
    }
    std::ranges::sort(paths);
    return paths;
}

std::size_t joint_of(const press::LoadsResult& loads, const std::string& name)
{
    for (std::size_t j = 0; j < loads.linkage.joints.size(); ++j)
        if (loads.linkage.joints[j].name == name)
            return j;
    throw InputError("no joint " + name);
}

double peak(const std::vector<Vec2>& forces)
{
    double largest = 0;
    for (const auto& force : forces)
        largest = std::max(largest, norm(force));
    return largest;
}

}  // namespace

TEST_CASE("forces, moments and power balance in every shipped case")
{
    const auto paths = shipped_cases();
    CHECK(paths.size() >= 9);
    for (const auto& path : paths) {
        CAPTURE(path.string());
        const auto loads = loads_of(read(path));
        balance::require_balanced(loads.linkage, loads.request, loads.history);
        CHECK(loads.stroke.stroke > 0.01);
        CHECK(std::abs(loads.stroke.bottom_dead_point) < 1e-3);
    }
}

TEST_CASE("the two readings of the shipped press have the strokes and pin forces of the reference")
{
    // Independent multibody computation (tests/data/mechanism_oracle.json): 200 rpm. The coordinates of the cases are
    // rounded to 0.1 um, of which the toggle makes up to 1e-4 of the forces.
    struct Row {
        const char* file;
        double stroke, no_load, at_bottom;
    };
    for (const auto& row :
         {Row{"case.toml", 21.966472e-3, 14597.9, -21930}, Row{"l5a-230.toml", 30.049e-3, 32590, -34110}}) {
        CAPTURE(row.file);
        const auto input = read(cases / "jl75g-60" / row.file);
        const auto loads = loads_of(input);
        CHECK(loads.stroke.stroke == near(row.stroke, 1e-4));
        CHECK(loads.linkage.bodies.size() == 19);  // twelve, and seven images
        CHECK(loads.freed_guides == std::vector<std::string>{"guide_10"});
        const auto pin = joint_of(loads, "crank_pin");
        CHECK(-loads.history.joints[pin].force.front()[1] == near(-row.at_bottom, 5e-4));
        auto unloaded = input;
        unloaded.operation[0].force = 0;
        CHECK(peak(loads_of(unloaded).history.joints[pin].force) == near(row.no_load, 5e-4));
    }
}

TEST_CASE("the rigid crankshaft carries what the driver's joint carries")
{
    // The shaft has the mass, the weight and the unbalance of the crank's body, so that its bearings together must take
    // the reaction of the frame, at the mechanism's positions (every fourth sample of the crankshaft; between them the
    // pin's force is linear, there it is exact).
    const auto loads = loads_of(read(data / "balanced-crank.toml"));
    REQUIRE(loads.crankshaft);
    const auto& shaft = *loads.crankshaft;
    const auto& driver = loads.history.joints[joint_of(loads, "main")];
    const std::size_t stride = shaft.rigid.time.size() / loads.history.time.size();
    REQUIRE(stride * loads.history.time.size() == shaft.rigid.time.size());
    double worst = 0;
    for (std::size_t i = 0; i < loads.history.time.size(); ++i) {
        Vec2 sum{};
        for (const auto& bearing : shaft.rigid.bearings)
            sum = sum + bearing.force[i * stride];
        worst = std::max(worst, norm(sum + driver.force[i]));  // the driver's body_a is the crank
    }
    CHECK(worst < 1e-6 * peak(driver.force));  // density and disk meet the mass to 1e-8
    CHECK(shaft.shaft.unbalances.at(0).magnitude == near(40 * std::hypot(1e-3, 7e-3), 1e-5));
    CHECK(loads.crankshaft->seats.size() == 2);
}

TEST_CASE("the flexible crankshaft agrees with the rigid one in the mean")
{
    const auto loads = loads_of(read(data / "balanced-crank.toml", {"crankshaft.model=flexible"}));
    const auto& shaft = *loads.crankshaft;
    REQUIRE(shaft.flexible);
    for (std::size_t b = 0; b < 2; ++b)  // statics does not know stiffness where there are two bearings
        for (std::size_t i = 0; i < 2; ++i)
            CHECK(shaft.flexible->bearings[b].mean[i] == near(shaft.rigid.bearings[b].mean[i], 1e-6, 1e-6 * 1000));
    CHECK(shaft.modes.size() >= 4);
    CHECK(loads.process_force == "elastic");
}

TEST_CASE("the course of the force follows the crankshaft unless stated")
{
    auto input = read(data / "balanced-crank.toml");
    CHECK(press::process_force_kind(input) == casefile::ProcessForce::Kind::rectangular);
    input.crankshaft->model = casefile::Crankshaft::Model::flexible;
    CHECK(press::process_force_kind(input) == casefile::ProcessForce::Kind::elastic);
    input.crankshaft.reset();
    CHECK(press::process_force_kind(input) == casefile::ProcessForce::Kind::elastic);
    input.process_force.emplace().kind = casefile::ProcessForce::Kind::half_sine;
    CHECK(press::process_force_kind(input) == casefile::ProcessForce::Kind::half_sine);
}

TEST_CASE("crank angles of the case count from the x axis")
{
    auto input = read(data / "balanced-crank.toml");
    auto& process = input.process_force.emplace();
    const double bottom = 1.5 * pi;
    for (const auto kind : {casefile::ProcessForce::Kind::rectangular, casefile::ProcessForce::Kind::half_sine}) {
        CAPTURE(casefile::name_of(kind));
        process.kind = kind;
        const auto law = press::describe_process_force(input, 100, bottom);
        CHECK(law(0, 0, 0) == near(100, 1e-5));  // 270 deg, the middle of 255..285
        CHECK(law(-16 * pi / 180, 0, 0) == 0);
        CHECK(law(16 * pi / 180, 0, 0) == 0);
    }
    process.kind = casefile::ProcessForce::Kind::angle_table;
    process.over_angle = {{bottom - 0.2, bottom, bottom + 0.1}, {0, 1, 0}};
    CHECK(press::describe_process_force(input, 100, bottom)(-0.1, 0, 0) == near(50, 1e-5));
    process.kind = casefile::ProcessForce::Kind::travel_table;
    process.over_height = {{0, 0.002}, {1, 0}};
    CHECK(press::describe_process_force(input, 100, bottom)(-0.1, 0.001, -1) == near(50, 1e-5));
    CHECK(press::describe_process_force(input, 100, bottom)(0.1, 0.001, 1) == 0);
    process.both_ways = true;
    CHECK(press::describe_process_force(input, 100, bottom)(0.1, 0.001, 1) == near(50, 1e-5));
    process.kind = casefile::ProcessForce::Kind::none;
    CHECK(press::describe_process_force(input, 100, bottom)(0, 0, 0) == 0);
}

TEST_CASE("the tip of a steep force is in the loads, the crankshaft's too")
{
    auto input = read(data / "balanced-crank.toml");
    auto& process = input.process_force.emplace();
    process.kind = casefile::ProcessForce::Kind::travel_table;
    process.over_height = {{1.97e-3, 2.03e-3, 2.09e-3}, {0, 1, 0}};  // of a slide that moves 0.1 mm per position there
    const auto loads = loads_of(input);
    const double peak = *std::ranges::max_element(loads.history.process_force);
    CHECK(peak <= loads.force);
    CHECK(peak >= 0.998 * loads.force);  // none of up to 2880 positions lies nearer than 0.12 % to this tip
    CHECK(loads.history.process_force.size() == static_cast<std::size_t>(loads.request.positions));
    // Its samples are a multiple of the positions, so that the bearings carry the peak of the pin too.
    CHECK(loads.crankshaft->rigid.time.size() % loads.history.time.size() == 0);
}

TEST_CASE("an eccentric force shows as a moment in the guide")
{
    auto input = read(data / "balanced-crank.toml");
    input.process_force.emplace().kind = casefile::ProcessForce::Kind::elastic;
    const auto central = loads_of(input);
    input.process_force->offset = 0.03;
    const auto eccentric = loads_of(input);
    const auto guide = joint_of(central, "guide");
    // At bottom dead point 20 kN act 30 mm to the right of the guide's centre: 600 N m on the slide, held by the frame.
    CHECK(eccentric.history.joints[guide].moment[0] - central.history.joints[guide].moment[0] == near(-600, 1e-9));
    CHECK(eccentric.guides.at(0).mean_normal >= 2 * 500);  // both faces are preloaded by 500 N
}

TEST_CASE("a speed that varies over the turn")
{
    auto input = read(data / "balanced-crank.toml");
    input.mechanism.speed = {{0, pi}, {1, 0.5}};
    const auto loads = loads_of(input);
    const auto& history = loads.history;
    const double speed = input.operation[0].speed;
    const std::size_t half = history.speed.size() / 2;
    CHECK(history.speed[0] == near(speed, 1e-5));
    CHECK(history.speed[half] == near(0.5 * speed, 1e-5));
    CHECK(history.speed[half / 2] == near(0.75 * speed, 1e-5));
    // Time over half a turn with a speed linear in the angle: pi ln 2 / (w - w / 2).
    CHECK(history.time[half] == near(2 * pi * std::log(2.0) / speed, 1e-9));
    CHECK(history.period == near(4 * pi * std::log(2.0) / speed, 1e-9));
    balance::require_balanced(loads.linkage, loads.request, loads.history);
}

TEST_CASE("masses of meshed parts are exact; what exists twice counts once, what is cut counts whole")
{
    Observer quiet;
    const auto input = read(data / "blocks.toml");
    const auto machine = full::prepare_machine(input, 1, quiet);
    const auto middle = press::mass_of_parts(input, machine, "middle");
    const double mass = 7850 * 0.2 * 0.3 * 0.1;
    CHECK(middle.mass == near(mass, 1e-12));
    CHECK(middle.centre[0] == 0);
    CHECK(middle.centre[1] == near(0.15, 1e-12));
    CHECK(middle.inertia == near(mass * (0.2 * 0.2 + 0.3 * 0.3) / 12, 1e-12));
    const auto side = press::mass_of_parts(input, machine, "side");  // of tetrahedra and hexahedra
    const double side_mass = 7850 * 0.1 * 0.25 * 0.1;
    CHECK(side.mass == near(side_mass, 1e-12));
    CHECK(side.centre[0] == near(-0.25, 1e-12));
    CHECK(side.centre[1] == near(0.125, 1e-12));
    CHECK(side.inertia == near(side_mass * (0.1 * 0.1 + 0.25 * 0.25) / 12, 1e-12));
    CHECK(press::mass_of_parts(input, machine, "nobody").mass == 0);
}

TEST_CASE("stated masses hold, the rest follows")
{
    auto input = read(data / "balanced-crank.toml");
    input.bodies.at("rod").inertia.reset();
    const auto linkage = press::describe_linkage(input);
    CHECK_FALSE(press::masses_need_parts(input, linkage));
    const auto masses = press::describe_masses(input, linkage, nullptr);
    const auto rod = static_cast<std::size_t>(std::ranges::find(linkage.bodies, "rod") - linkage.bodies.begin());
    CHECK(masses.values[rod].mass == 12);
    CHECK(masses.values[rod].inertia == near(12 * 0.3 * 0.3 / 12, 1e-5));  // a rod of 300 mm
    CHECK(has(masses.origins[rod], "slender rod"));
}

TEST_CASE("what is missing or wrong is named with its remedy")
{
    const auto input = read(data / "balanced-crank.toml");
    auto wrong = input;
    wrong.mechanism.slide_body.clear();
    CHECK(has(error_of(wrong), "add slide_body to [mechanism]"));
    wrong = input;
    wrong.bodies.at("rod").mass.reset();
    CHECK(has(error_of(wrong), "bodies.rod: the loads need its mass"));
    wrong = input;
    wrong.bodies.at("slide").centre_of_mass.reset();
    CHECK(has(error_of(wrong), "bodies.slide: the loads need its centre of mass"));
    CHECK(has(error_of(input, 1), "stands still in segment 1"));
    CHECK(has(error_of(input, 2), "there is no segment 2"));
    // A rod shorter than the crank cannot follow it around.
    wrong = input;
    wrong.joints.at("wrist").centre = {0, -0.07};
    const auto open = error_of(wrong);
    CHECK(has(open, "cannot close"));
    CHECK(has(open, "deg"));
    // Two guides for one slide.
    wrong = input;
    wrong.joints["guide_2"] = wrong.joints.at("guide");
    wrong.joints.at("guide_2").centre = {0.1, -0.4};
    CHECK(has(error_of(wrong), "guide_2"));
    // A wrist that slides nowhere is free.
    wrong = input;
    wrong.joints.erase("guide");
    CHECK(error_of(wrong) != "");
    // Without any damping there is no periodic motion.
    wrong = input;
    wrong.crankshaft->model = casefile::Crankshaft::Model::flexible;
    wrong.crankshaft->modal_damping = 0;
    CHECK(has(error_of(wrong), "damp"));
}

TEST_CASE("a guide that symmetry relieves is warned about, a preload settles it")
{
    auto input = read(cases / "jl75g-60/no-load.toml");
    const auto warned = [](const press::LoadsResult& loads) {
        return std::ranges::any_of(loads.warnings,
                                   [](const auto& w) { return has(w.text, "guide 'guide_10' carries no force"); });
    };
    CHECK(warned(loads_of(input)));
    input.joints.at("guide_10").preload = 1000;
    const auto preloaded = loads_of(input);
    CHECK_FALSE(warned(preloaded));
    for (const auto& guide : preloaded.guides)
        if (preloaded.linkage.joints[static_cast<std::size_t>(guide.joint)].name == "guide_10")
            CHECK(guide.mean_normal == near(2000, 1e-5));
}

TEST_CASE("belt pull by power, and a rectangular pulse on a flexible shaft")
{
    auto input = read(data / "balanced-crank.toml");
    auto& belt = input.crankshaft->belt.emplace();
    belt.power = 3000;
    belt.pulley_diameter = 0.4;
    CHECK(press::belt_force(input, 10) == near(3000 / (10 * 0.2), 1e-5));
    belt.force = 700;
    CHECK(press::belt_force(input, 10) == 700);
    belt.angle = pi;
    const auto pulled = loads_of(input);
    CHECK(pulled.crankshaft->loads.steady.at(0).force[0] == near(-700, 1e-5));
    input.crankshaft->model = casefile::Crankshaft::Model::flexible;
    input.process_force.emplace().kind = casefile::ProcessForce::Kind::rectangular;
    const auto loads = loads_of(input);
    CHECK(std::ranges::any_of(loads.warnings, [](const auto& w) {
        return has(w.text, "the steps of a rectangular process force double the peak");
    }));
}

TEST_CASE("natural frequencies do not hang on how many sections a shaft is written in")
{
    // 600 mm of 120 mm diameter: as one section and as forty-eight; pieces of half a diameter leave less than 0.1 %.
    crankshaft::Shaft shaft;
    shaft.youngs_modulus = 210e9;
    shaft.poissons_ratio = 0.3;
    for (const double position : {0.05, 0.55}) {
        auto& bearing = shaft.bearings.emplace_back();
        bearing.position = position;
        bearing.stiffness = {{{1e9, 0}, {0, 1e9}}};
    }
    const auto lowest = [&](int sections) {
        shaft.sections.assign(static_cast<std::size_t>(sections), {0.6 / sections, 0.12, 0, 7850});
        shaft.sections = press::slender_pieces(shaft.sections);
        return crankshaft::modes(crankshaft::assemble(shaft), 0, 4);
    };
    const auto coarse = lowest(1), fine = lowest(48);
    for (std::size_t m = 0; m < fine.size(); ++m)
        CHECK(coarse[m].frequency == near(fine[m].frequency, 1e-3));
}

TEST_CASE("a force whose window misses bottom dead point is warned about; one that is not stated sits about it")
{
    auto input = read(cases / "jl75g-60" / "l5a-230.toml");
    input.crankshaft->model = casefile::Crankshaft::Model::rigid;
    input.process_force.reset();
    CHECK_FALSE(press::misplaced_force(input, 0.3));
    const auto law = press::describe_process_force(input, 1000, 0.3);
    CHECK(law(0, 0, 0) == near(1000, 1e-5));
    CHECK(law(0.3, 0, 0) == 0);
    input.process_force.emplace();
    input.process_force->kind = casefile::ProcessForce::Kind::rectangular;
    CHECK_FALSE(press::misplaced_force(input, 0.3));
    CHECK(press::describe_process_force(input, 1000, 0.3)(0, 0, 0) == near(1000, 1e-5));
    input.process_force->from = 255 * pi / 180;
    input.process_force->to = 285 * pi / 180;
    CHECK_FALSE(press::misplaced_force(input, 1.5 * pi));
    const auto warning = press::misplaced_force(input, 0);
    REQUIRE(warning);
    CHECK(has(*warning, "acts at -105.0 to -75.0 deg after bottom dead point"));
}

TEST_CASE("a crank pin that is not on the shaft is named by its keys")
{
    auto input = read(cases / "jl75g-60" / "l5a-230.toml");
    input.crankshaft->pin_position = 1.3;
    CHECK(has(error_of(input), "crankshaft.pin_position: the crank pin"));
    input.crankshaft->pin_position = 0;
    input.crankshaft->pin_width = 6;
    CHECK(has(error_of(input), "crankshaft.pin_position: the crank pin"));
}

TEST_CASE("a case says how many critical speeds it wants, and shear factors for the shaft or its sections")
{
    const auto path = data / "balanced-crank.toml";
    const auto critical = [&](const std::vector<std::string>& overrides) {
        return loads_of(read(path, overrides)).crankshaft->critical_speeds;
    };
    const auto four = critical({});
    CHECK(four.size() == 4);
    const auto seven = critical({"crankshaft.critical_speeds=7"});
    REQUIRE(seven.size() == 7);
    for (std::size_t i = 0; i < 4; ++i)
        CHECK(seven[i].speed == near(four[i].speed, 1e-12));
    CHECK(seven[6].speed > seven[3].speed);

    // Without shear deformation a shaft is stiffer; a factor of its only section counts like that of the shaft.
    const auto bending = critical({"crankshaft.shear_factor=0"});
    CHECK(bending[0].speed > 1.005 * four[0].speed);
    auto by_section = read(path);
    by_section.crankshaft->sections[0].shear_factor = 0;
    CHECK(loads_of(by_section).crankshaft->critical_speeds[0].speed == bending[0].speed);
    by_section.crankshaft->sections[0].shear_factor = 0.5;
    CHECK(loads_of(by_section).crankshaft->critical_speeds[0].speed < four[0].speed);
}
