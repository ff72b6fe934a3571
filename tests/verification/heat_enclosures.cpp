#include "../scratch_folder.hpp"
#include "deadpoint/fem/model.hpp"
#include "deadpoint/full/run/run.hpp"
#include "deadpoint/press/problem/heat.hpp"
#include "deadpoint/press/translate/materials.hpp"
#include "near.hpp"
#include "solved_case.hpp"

#include <cmath>

// Enclosed air as an unknown beside the field.

using namespace verification;

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

double air_at_end(const SolvedCase& solved) { return air(solved).temperature.value.back() - zero_celsius; }

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
                         "numerics.time_tolerance=1e-5 K"});
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
                            std::abs(air(solved).temperature.value[i] - zero_celsius - ambient - exact[1])});
    }
    CHECK(air_at_end(solved) - ambient > 0.1);
    // The errors of the steps stay near 1e-5 K together; the block is not quite of one temperature.
    CHECK(largest < 1e-4);
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
    CHECK(enclosed.history().energy.to_air == near(open.history().energy.to_air, 1e-4));
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
    face.film->law = casefile::FilmCoefficient{5};
    const auto solved = solve(input);
    const double wall = ambient + (power + windage) / outside;
    const double enclosed = wall + (power + windage) / wall_film;
    CHECK(solved.probe("wall") == near(wall, 1e-6));
    CHECK(air_at_end(solved) == near(enclosed, 1e-6));
    CHECK(solved.probe("block") == near(enclosed + power / block_film, 1e-6));
    CHECK(air(solved).from_surfaces.back() == near(-windage, 1e-5));
    CHECK(solved.history().to_air.back() == near(power + windage, 1e-6));
    // Rounding of k T at a hundred times the conductivity of copper, the same in each of many steps at rest.
    CHECK(solved.history().energy.mismatch() < 1e-7);
}

TEST_CASE("order in time: enclosed air and films that follow the temperatures on both sides")
{
    auto input = read("warm-box", {"machine.initial_temperature=80 degC", "operation.0.duration=1 h",
                                   "enclosures.box.temperature=30 degC"});
    auto& film = *input.surfaces.at("block_faces").film;
    film.law = casefile::PlateFilm{.length = 0.04};
    deadpoint::Observer silent;
    const auto machine = deadpoint::full::prepare_machine(input, 1, silent);
    const auto end_of = [&](double step) {
        deadpoint::fem::Model model(machine, deadpoint::press::describe_materials(input, machine), 1, silent);
        auto problem = deadpoint::press::describe_heat(input, machine, silent);
        problem.fixed_step = step;
        problem.solver_tolerance = 1e-13;
        model.assemble_heat(problem);
        const auto history = model.heat({}, 0, -1, silent, {}, {});
        CHECK(history.energy.mismatch() < 1e-8);
        return std::array<double, 2>{history.probes[0].value.back(), history.enclosures[0].temperature.value.back()};
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
    CHECK(half.result.symmetry_factor == 2);
    CHECK(air_at_end(half) == near(air_at_end(whole), 1e-6));
    CHECK(largest_difference(whole, half) < 2e-3);
    CHECK(2 * half.history().energy.to_air == near(whole.history().energy.to_air, 1e-4));
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
    const auto machine = deadpoint::full::prepare_machine(input, 1, silent);
    const auto whole = deadpoint::full::run_case(input, machine, {}, silent);
    input.operation[0].duration /= 2;
    (void)deadpoint::full::run_case(input, machine, verification::ending_in(file), silent);
    const auto rest = deadpoint::full::run_case(input, machine, verification::beginning_at(file), silent);
    const auto& air_of_rest = rest.thermal.enclosures[0].temperature.value;
    CHECK(air_of_rest.front() - zero_celsius > ambient + 1);
    CHECK(air_of_rest.front() < zero_celsius + 79);
    CHECK(air_of_rest.back() == near(whole.thermal.enclosures[0].temperature.value.back(), 1e-6));
}

namespace {

constexpr double stefan_boltzmann = 5.670374419e-8;
constexpr double wall_heat = 8960 * 385 * 1.6e-5;                        // [J/K]
constexpr double block_area = 6 * 0.04 * 0.04, wall_area = 0.04 * 0.04;  // of warm-box.toml [m2]

/// The box with hardly any air in the way: block and wall radiate to each other.
Case radiating()
{
    auto input = lumped({"enclosures.box.exchange=0 W/K"});
    for (const auto* surface : {"block_faces", "wall_inside"})
        input.surfaces.at(surface).film->law = casefile::FilmCoefficient{0};
    input.surfaces.at("block_faces").film->emissivity = 0.8;
    input.surfaces.at("wall_inside").film->emissivity = 0.3;
    return input;
}

void cool_outside(Case& input)
{
    auto& face = input.surfaces["wall_outside"];
    face = input.surfaces.at("wall_inside");
    face.position = 0.11;
    face.film->law = casefile::FilmCoefficient{5};
    face.film->emissivity = 0;
}

// Two surfaces: the larger one, which is the block here, sees the smaller one only by as much as that one's area.
constexpr double exchange_area = 1 / (0.2 / (0.8 * block_area) + 1 / wall_area + 0.7 / (0.3 * wall_area));

}  // namespace

TEST_CASE("radiation inside an enclosure: a lamp's power by the fourth powers of two surfaces")
{
    constexpr double power = 0.2, outside = 5;
    auto input = radiating();
    input.operation[0].duration = 20000 * 3600.0;
    input.heat_sources["lamp"] = {{"block"}, "", deadpoint::casefile::Course{power, {}, {}}, true};
    cool_outside(input);
    const auto solved = solve(input);
    const double wall = ambient + zero_celsius + power / (outside * wall_area);
    const double block = std::pow(std::pow(wall, 4) + power / (exchange_area * stefan_boltzmann), 0.25);
    CHECK(solved.probe("wall") + zero_celsius == near(wall, 1e-7));
    CHECK(solved.probe("block") + zero_celsius == near(block, 1e-7));
    CHECK(solved.history().energy.mismatch() < 1e-7);
    CHECK(solved.history().to_air.back() == near(power, 1e-6));
    CHECK(std::abs(air(solved).from_surfaces.back()) < 1e-9);  // radiation passes the air by
}

TEST_CASE("radiation inside an enclosure: a warm body and a wall that loses heat, by Runge and Kutta")
{
    auto input = radiating();
    input.bodies.at("inner").initial_temperature = zero_celsius + 180;
    input.numerics.time_tolerance = 1e-4;
    input.operation[0].duration = 4 * 3600;
    constexpr double outside = 5 * wall_area;
    cool_outside(input);
    const auto solved = solve(input);
    using Two = std::array<double, 2>;
    const auto rate = [](const Two& t) -> Two {
        const double heat = exchange_area * stefan_boltzmann * (std::pow(t[0], 4) - std::pow(t[1], 4));
        return {-heat / block_heat, (heat - outside * (t[1] - zero_celsius - ambient)) / wall_heat};
    };
    const auto moved = [](const Two& t, double by, const Two& k) -> Two {
        return {t[0] + by * k[0], t[1] + by * k[1]};
    };
    Two t{zero_celsius + 180, zero_celsius + 20};
    constexpr int steps = 2000;
    const double dt = input.operation[0].duration / steps;
    for (int i = 0; i < steps; ++i) {
        const Two a = rate(t), b = rate(moved(t, dt / 2, a)), c = rate(moved(t, dt / 2, b)), d = rate(moved(t, dt, c));
        for (std::size_t k = 0; k < 2; ++k)
            t[k] += dt / 6 * (a[k] + 2 * b[k] + 2 * c[k] + d[k]);
    }
    CHECK(t[0] < zero_celsius + 175);
    // The steps keep to 1e-4 K, and at a hundred times the conductivity of copper a body is of one temperature to 1e-3
    // K.
    CHECK(std::abs(solved.probe("block") + zero_celsius - t[0]) < 2e-3);
    CHECK(std::abs(solved.probe("wall") + zero_celsius - t[1]) < 2e-3);
}

TEST_CASE("radiation inside an enclosure: long steps converge, of second order")
{
    auto input = radiating();
    input.bodies.at("inner").initial_temperature = zero_celsius + 180;
    input.surfaces.at("block_faces").film->law = casefile::FilmCoefficient{2};
    input.operation[0].duration = 4 * 3600;
    cool_outside(input);
    deadpoint::Observer silent;
    const auto machine = deadpoint::full::prepare_machine(input, 1, silent);
    const auto end_of = [&](double step) {
        deadpoint::fem::Model model(machine, deadpoint::press::describe_materials(input, machine), 1, silent);
        auto problem = deadpoint::press::describe_heat(input, machine, silent);
        problem.fixed_step = step;
        problem.solver_tolerance = 1e-13;
        model.assemble_heat(problem);
        const auto history = model.heat({}, 0, -1, silent, {}, {});
        CHECK(history.energy.mismatch() < 1e-8);
        // Two stages of a step, each of some iterations of Newton with a nearly exact tangent.
        CHECK(history.linear_solves <= 2 * 7 * static_cast<int>(history.time.size() - 1));
        return history.probes[1].value.back();
    };
    const double coarse = end_of(1200), middle = end_of(600), fine = end_of(300);
    const double order = std::log2(std::abs(coarse - middle) / std::abs(middle - fine));
    MESSAGE("order in time " << order << ", last difference " << std::abs(middle - fine) << " K");
    CHECK(std::abs(order - 2) < 0.15);
}

TEST_CASE("bodies and parts begin at temperatures of their own")
{
    constexpr double power = 1e-2, time = 50 * 3600.0;
    auto input = lumped({"enclosures.box.exchange=0 W/K", "enclosures.box.heat_capacity=1e-3 J/K",
                         "bodies.inner.initial_temperature=90 degC", "parts.wall.initial_temperature=10 degC",
                         "bodies.outer.initial_temperature=55 degC"});
    input.operation[0].duration = time;
    input.heat_sources["lamp"] = {{"block"}, "", deadpoint::casefile::Course{power, {}, {}}, true};
    for (const auto* surface : {"block_faces", "wall_inside"})
        input.surfaces.at(surface).film->law = casefile::FilmCoefficient{5};
    const auto solved = solve(input);
    CHECK(solved.probe("block", 0) == near(90, 1e-12));
    CHECK(solved.probe("wall", 0) == near(10, 1e-12));  // the part's own, not its body's
    const double begin = 90 * block_heat + 10 * wall_heat;
    const double end = solved.probe("block") * block_heat + solved.probe("wall") * wall_heat;
    CHECK(solved.probe("block") - solved.probe("wall") < 1);
    CHECK(end == near(begin + power * time, 1e-5));  // the air takes 1e-3 J/K
}
