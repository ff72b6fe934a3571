#include "deadpoint/casefile/check/directions.hpp"

#include "../../turned_case.hpp"
#include "deadpoint/casefile/files/read.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/mechanism/process_force.hpp"
#include "deadpoint/press/loads/loads.hpp"
#include "deadpoint/press/result/loads_result.hpp"
#include "near.hpp"

#include <doctest/doctest.h>
#include <filesystem>
#include <fmt/format.h>

// Presses that lie or lean.

using namespace deadpoint;

namespace {

constexpr double degree = std::numbers::pi / 180;

casefile::Case slider_crank(const std::vector<std::string>& overrides = {})
{
    auto input = casefile::read_case(
                     std::filesystem::path(DEADPOINT_SOURCE_DIR) / "tests/data/study/balanced-crank.toml", overrides)
                     .value;
    input.mechanism.positions = 72;
    return input;
}

std::size_t joint_named(const press::LoadsResult& loads, const std::string& name)
{
    for (std::size_t j = 0; j < loads.linkage.joints.size(); ++j)
        if (loads.linkage.joints[j].name == name)
            return j;
    throw std::logic_error(name);
}

}  // namespace

TEST_CASE("a press turned in the plane with its gravity moves and carries as it did")
{
    auto upright = slider_crank();
    upright.process_force.emplace().kind = casefile::ProcessForce::Kind::half_sine;
    upright.process_force->offset = 0.02;
    upright.crankshaft->model = casefile::Crankshaft::Model::flexible;
    upright.crankshaft->belt.emplace();
    upright.crankshaft->belt->force = 400;
    upright.crankshaft->belt->position = 0.25;
    const auto expected = press::compute_loads(upright, nullptr, 0);
    for (const double angle : {30.0, 90.0, 180.0, -117.0}) {
        CAPTURE(angle);
        const auto found = press::compute_loads(turned(upright, angle * degree), nullptr, 0);
        const double exact = 1e-7;
        CHECK(found.stroke.stroke == near(expected.stroke.stroke, exact));
        CHECK(found.drive.rms_torque == near(expected.drive.rms_torque, exact));
        const double largest = 2e4;
        for (std::size_t i = 0; i < found.history.height.size(); ++i) {
            CHECK(found.history.height[i] == near(expected.history.height[i], exact, exact * 0.08));
            CHECK(found.history.process_force[i] == near(expected.history.process_force[i], exact, exact * largest));
            for (std::size_t j = 0; j < found.linkage.joints.size(); ++j) {
                const Vec2 wanted = rotated(expected.history.joints[j].force[i], angle * degree);
                CHECK(norm(found.history.joints[j].force[i] - wanted) < exact * largest);
                CHECK(std::abs(found.history.joints[j].moment[i] - expected.history.joints[j].moment[i]) <
                      exact * largest * 0.3);
            }
        }
        CHECK(found.guides[0].mean_normal == near(expected.guides[0].mean_normal, exact));
        for (std::size_t b = 0; b < 2; ++b)
            CHECK(found.crankshaft->cycle().bearings[b].peak ==
                  near(expected.crankshaft->cycle().bearings[b].peak, exact));
        REQUIRE(found.warnings.size() == expected.warnings.size());
        for (std::size_t w = 0; w < found.warnings.size(); ++w)
            CHECK(found.warnings[w].text == expected.warnings[w].text);
    }
}

TEST_CASE("a horizontal press: its guide carries the weight of the slide across it, and the process force none of it")
{
    // The upright press turned on its side, its table on the left, while gravity stays.
    auto lying = turned(slider_crank(), -90 * degree);
    lying.machine.gravity_direction = {0, -1, 0};
    lying.mechanism.stroke_direction = Vec2{1, 0};
    lying.process_force.emplace().kind = casefile::ProcessForce::Kind::half_sine;
    const double slide_mass = *lying.bodies.at("slide").mass;
    lying.bodies.at("rod").mass = 1e-9;  // [kg], so that the rod pulls along itself
    lying.bodies.at("rod").inertia = 1e-12;
    const auto loads = press::compute_loads(lying, nullptr, 0);
    const auto& guide = loads.history.joints[joint_named(loads, "guide")];
    const auto& wrist = loads.history.joints[joint_named(loads, "wrist")];  // slide first
    // at bottom dead point the rod lies in line with the guide
    CHECK(loads.history.process_force[0] == near(20e3, 1e-5));
    CHECK(guide.force[0][1] == near(9.81 * slide_mass, 1e-7));
    for (std::size_t i = 0; i < guide.force.size(); ++i) {
        CHECK(std::abs(guide.force[i][0]) < 1e-6);
        CHECK(guide.force[i][1] + wrist.force[i][1] == near(9.81 * slide_mass, 1e-7));
        const double along = wrist.force[i][0] + loads.history.process_force[i];
        CHECK(along == near(slide_mass * loads.history.slide_acceleration[i], 1e-7, 1e-7 * 1e4));
    }
}

TEST_CASE("an inclined slide: the process presses along it and not on its guide")
{
    // 30 deg off gravity: the guide carries that share of the slide's weight at bottom dead point, whatever the process
    auto leaning = turned(slider_crank(), 30 * degree);
    leaning.machine.gravity_direction = {0, -1, 0};
    leaning.bodies.at("rod").mass = 1e-9;
    leaning.bodies.at("rod").inertia = 1e-12;
    leaning.process_force.emplace().kind = casefile::ProcessForce::Kind::half_sine;
    const auto loads = press::compute_loads(leaning, nullptr, 0);
    CHECK(loads.history.process_force[0] == near(20e3, 1e-5));
    CHECK(norm(loads.history.joints[joint_named(loads, "guide")].force[0]) ==
          near(9.81 * *leaning.bodies.at("slide").mass * std::sin(30 * degree), 1e-7));
}

TEST_CASE("the stroke points against gravity along its guide, or as stated")
{
    auto input = slider_crank();
    CHECK(casefile::stroke_direction(input) == Vec2{0, 1});
    input.joints.at("guide").direction = {0, -3};
    CHECK(casefile::stroke_direction(input) == Vec2{0, 1});
    input.machine.gravity_direction = {0, 2, 0};
    CHECK(casefile::stroke_direction(input) == Vec2{0, -1});
    CHECK(casefile::plane_gravity(input)[1] == near(9.81, 1e-5));
    input.machine.gravity_direction = {0, 0, -1};
    CHECK(norm(casefile::plane_gravity(input)) == 0);
    CHECK_THROWS_WITH_AS((void)casefile::stroke_direction(input), doctest::Contains("stroke_direction = [0, -1]"),
                         InputError);
    input.mechanism.stroke_direction = Vec2{0, 5};
    CHECK(casefile::stroke_direction(input) == Vec2{0, 1});
    input.joints.erase("guide");
    input.mechanism.stroke_direction.reset();
    input.machine.gravity_direction = {3, 4, 0};
    CHECK(norm(casefile::stroke_direction(input) - Vec2{-0.6, -0.8}) < 1e-15);
}

TEST_CASE("walls of a press that lies need their height stated")
{
    auto input = slider_crank();
    input.surfaces["wall"].film.emplace().law = casefile::PlateFilm{};
    CHECK(casefile::check_directions(input).empty());
    input.machine.gravity_direction = {0, 1, 0};
    CHECK(casefile::check_directions(input).empty());
    input.machine.gravity_direction = {-1, -1, 0};
    const auto findings = casefile::check_directions(input);
    REQUIRE(findings.size() == 1);
    CHECK(findings[0].warning);
    CHECK(findings[0].path == "surfaces.wall.film");
    std::get<casefile::PlateFilm>(input.surfaces["wall"].film->law).length = 0.5;
    CHECK(casefile::check_directions(input).empty());
}

TEST_CASE("a half model and mirror images keep stroke and gravity in their plane")
{
    auto input = slider_crank();
    input.machine.half_model = true;
    CHECK(casefile::check_directions(input).empty());
    input.machine.gravity_direction = {0.1, -1, 0};
    CHECK(casefile::check_directions(input).at(0).path == "machine.gravity_direction");
    input.machine.gravity_direction = {0, -1, 0};
    input.joints.at("guide").direction = {1, 1};
    CHECK(casefile::check_directions(input).at(0).message.find("plane of symmetry") != std::string::npos);
}
