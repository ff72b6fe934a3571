#include "../scratch_folder.hpp"
#include "deadpoint/fem/model.hpp"
#include "deadpoint/study/translate_heat.hpp"
#include "solved_case.hpp"

#include <cmath>

// Enclosed air as an unknown beside the field.

using namespace verification;
using doctest::Approx;

namespace {

constexpr double block_heat = 8960 * 385 * 6.4e-5;  // of the block of warm-box.toml [J/K]
constexpr double block_film = 2 * 6 * 0.04 * 0.04;  // to the air [W/K]
constexpr double wall_film = 1 * 0.04 * 0.04;       // from the air [W/K]
constexpr double ambient = 20;                      // [degC]

/// The box with bodies of one temperature each.
Case lumped(const std::vector<std::string>& overrides = {})
{
    std::vector<std::string> all{"materials.copper.conductivity=4e4 W/m/K", "numerics.solver_tolerance=1e-13"};
    all.insert(all.end(), overrides.begin(), overrides.end());
    return read("warm-box", all);
}

void insulate_wall(Case& input)
{
    input.surfaces.at("wall_inside").film.reset();
    input.enclosures.at("box").surfaces = {"block_faces"};
}

const deadpoint::EnclosureHistory& air(const SolvedCase& solved) { return solved.history().enclosures.at(0); }

double air_at_end(const SolvedCase& solved) { return air(solved).temperature.back() - zero_celsius; }

/// y' = -m y for two unknowns with positive real eigenvalues: the sum of two exponentials through y(0) and y'(0).
std::array<double, 2> two_exponentials(const std::array<std::array<double, 2>, 2>& m, const std::array<double, 2>& y,
                                       double time)
{
    const double trace = m[0][0] + m[1][1], determinant = m[0][0] * m[1][1] - m[0][1] * m[1][0];
    const double root = std::sqrt(trace * trace / 4 - determinant);
    const double fast = trace / 2 + root, slow = trace / 2 - root;
    std::array<double, 2> result{};
    for (std::size_t i = 0; i < 2; ++i) {
        const double rate = -(m[i][0] * y[0] + m[i][1] * y[1]);
        const double of_slow = (rate + fast * y[i]) / (fast - slow);
        result[i] = of_slow * std::exp(-slow * time) + (y[i] - of_slow) * std::exp(-fast * time);
    }
    return result;
}

}  // namespace

TEST_CASE("a hot block and the air around it: two exponentials")
{
    auto input = lumped({"machine.initial_temperature=80 degC", "enclosures.box.temperature=20 degC",
                         "numerics.time_tolerance=1e-6 K"});
    insulate_wall(input);
    const auto solved = solve(input);
    const double capacity = 40, exchange = 0.02;
    const std::array<std::array<double, 2>, 2> m{{{block_film / block_heat, -block_film / block_heat},
                                                  {-block_film / capacity, (block_film + exchange) / capacity}}};
    const auto& time = solved.history().time;
    double largest = 0;
    for (std::size_t i = 1; i < time.size(); i += time.size() / 20) {
        const auto exact = two_exponentials(m, {60, 0}, time[i]);
        largest = std::max({largest, std::abs(solved.probe("block", time[i]) - ambient - exact[0]),
                            std::abs(air(solved).temperature[i] - zero_celsius - ambient - exact[1])});
    }
    CHECK(air_at_end(solved) - ambient > 0.1);
    // Steps of 1e-6 K each, some hundreds of them.
    CHECK(largest < 2e-4);
    CHECK(solved.history().energy.mismatch() < 1e-8);
}

TEST_CASE("air that exchanges much with the room is the room")
{
    auto input = lumped({"machine.initial_temperature=80 degC", "enclosures.box.exchange=1e5 W/K",
                         "operation.0.duration=5 h", "enclosures.box.temperature=20 degC"});
    const auto enclosed = solve(input);
    input.enclosures.clear();
    const auto open = solve(input);
    CHECK(open.probe("block") - ambient > 1);
    // The same equations but for 1 W over 1e5 W/K; the steps may differ by their tolerance.
    CHECK(largest_difference(open, enclosed) < 2e-3);
    CHECK(enclosed.history().energy.mismatch() < 1e-8);
    CHECK(enclosed.history().energy.to_air == Approx(open.history().energy.to_air).epsilon(1e-4));
}

TEST_CASE("a sealed box at rest passes on what it makes: temperatures by the balance")
{
    auto input = lumped({"enclosures.box.exchange=0 W/K", "operation.0.duration=5000 h", "numerics.max_step=20 h"});
    constexpr double power = 0.05, outside = 5 * 0.04 * 0.04, windage = 0.02;
    input.heat_sources["lamp"] = {{"block"}, "", deadpoint::casefile::Course{power, {}, {}}, true};
    input.enclosures.at("box").power = deadpoint::casefile::Course{windage, {}, {}};
    input.enclosures.at("box").at_rest = true;
    auto& face = input.surfaces["wall_outside"];
    face = input.surfaces.at("wall_inside");
    face.position = 0.11;
    face.film->coefficient = 5;
    const auto solved = solve(input);
    const double wall = ambient + (power + windage) / outside;
    const double enclosed = wall + (power + windage) / wall_film;
    CHECK(solved.probe("wall") == Approx(wall).epsilon(1e-6));
    CHECK(air_at_end(solved) == Approx(enclosed).epsilon(1e-6));
    CHECK(solved.probe("block") == Approx(enclosed + power / block_film).epsilon(1e-6));
    CHECK(air(solved).from_surfaces.back() == Approx(-windage).epsilon(1e-5));
    CHECK(solved.history().to_air.back() == Approx(power + windage).epsilon(1e-6));
    // Rounding of k T at a hundred times the conductivity of copper, the same in each of many steps at rest.
    CHECK(solved.history().energy.mismatch() < 1e-7);
}

TEST_CASE("order in time: enclosed air and films that follow the temperatures on both sides")
{
    auto input = read("warm-box", {"machine.initial_temperature=80 degC", "operation.0.duration=1 h",
                                   "enclosures.box.temperature=30 degC"});
    auto& film = *input.surfaces.at("block_faces").film;
    film.coefficient.reset();
    film.law = "vertical";
    film.length = 0.04;
    deadpoint::Observer silent;
    const auto machine = deadpoint::study::prepare_machine(input, 1, silent);
    const auto end_of = [&](double step) {
        deadpoint::fem::Model model(machine, deadpoint::study::describe_materials(input, machine), 1, silent);
        auto problem = deadpoint::study::describe_heat(input, machine, silent);
        problem.fixed_step = step;
        problem.solver_tolerance = 1e-13;
        model.assemble_heat(problem);
        const auto history = model.heat({}, 0, -1, silent, {}, {});
        CHECK(history.energy.mismatch() < 1e-8);
        return std::array<double, 2>{history.probes[0].value.back(), history.enclosures[0].temperature.back()};
    };
    const auto coarse = end_of(240), middle = end_of(120), fine = end_of(60);
    for (std::size_t i = 0; i < 2; ++i) {
        const double order = std::log2(std::abs(coarse[i] - middle[i]) / std::abs(middle[i] - fine[i]));
        MESSAGE("order in time " << order << ", last difference " << std::abs(middle[i] - fine[i]) << " K");
        CHECK(std::abs(order - 2) < 0.1);
    }
}

TEST_CASE("half of a box is half of its air")
{
    const auto whole = solve(lumped({"machine.initial_temperature=80 degC"}));
    const auto half = solve(lumped({"machine.initial_temperature=80 degC", "machine.half_model=true"}));
    CHECK(half.result.whole == 2);
    CHECK(air_at_end(half) == Approx(air_at_end(whole)).epsilon(1e-6));
    CHECK(largest_difference(whole, half) < 2e-3);
    CHECK(2 * half.history().energy.to_air == Approx(whole.history().energy.to_air).epsilon(1e-4));
}

TEST_CASE("changes of air per hour and a volume say the same as a capacity and an exchange")
{
    auto input = lumped({"machine.initial_temperature=80 degC"});
    auto& box = input.enclosures.at("box");
    box = {box.surfaces, 0.05, {}, {}, 2.5, {}, {}, false};
    const auto by_changes = solve(input);
    box = {box.surfaces, {}, 1.2 * 1006 * 0.05, 1.2 * 1006 * 0.05 * 2.5 / 3600, {}, {}, {}, false};
    const auto by_values = solve(input);
    CHECK(air_at_end(by_changes) - ambient > 0.5);
    CHECK(largest_difference(by_changes, by_values) < 1e-5);  // the values may differ by rounding
}

TEST_CASE("a run goes on from the air where the last one ended")
{
    const ScratchFolder folder;
    const auto file = (folder.path / "state.bin").string();
    deadpoint::Observer silent;
    auto input = lumped({"machine.initial_temperature=80 degC", "numerics.time_tolerance=1e-5 K"});
    const auto machine = deadpoint::study::prepare_machine(input, 1, silent);
    const auto whole = deadpoint::study::run_case(input, machine, {}, silent);
    input.operation[0].duration /= 2;
    (void)deadpoint::study::run_case(input, machine, {.start_from = {}, .state_file = file, .field_folder = {}},
                                     silent);
    const auto rest =
        deadpoint::study::run_case(input, machine, {.start_from = file, .state_file = {}, .field_folder = {}}, silent);
    const auto& air_of_rest = rest.thermal.enclosures[0].temperature;
    CHECK(air_of_rest.front() - zero_celsius > ambient + 1);
    CHECK(air_of_rest.front() < zero_celsius + 79);
    CHECK(air_of_rest.back() == Approx(whole.thermal.enclosures[0].temperature.back()).epsilon(1e-6));
}
