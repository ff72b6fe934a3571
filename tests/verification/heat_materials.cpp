#include "deadpoint/fem/model.hpp"
#include "deadpoint/full/run/run.hpp"
#include "deadpoint/press/problem/heat.hpp"
#include "deadpoint/press/translate/materials.hpp"
#include "near.hpp"
#include "solved_case.hpp"

#include <cmath>

// Conductivity and heat capacity that follow the temperature.

using namespace verification;
using deadpoint::dot;
using deadpoint::casefile::Table;

namespace {

/// A property that rises from `value` at `start` by the share `slope` per kelvin, as a table of two points.
Table line(double value, double start, double slope)
{
    const double from = start - 60, to = start + 200;
    return {{from, to}, {value * (1 + slope * (from - start)), value * (1 + slope * (to - start))}};
}

/// Where the integral of k0 (1 + slope (T - start)) from start has the value k0 theta.
double inverse(double theta, double slope) { return (std::sqrt(1 + 2 * slope * theta) - 1) / slope; }

deadpoint::casefile::Course constant(double value) { return {value, {}, {}}; }

/// With c = c0 (1 + b u) and k = k0 (1 + b u / 2), u = T - T0, any direction a with |a| = a:
///   rho c dT/dt = div(k grad T)   holds for   u = A exp(-a . x + a^2 k0 / (rho c0) t),
/// since then k grad u = -a k0 (u + b u^2 / 2) and div of it is a^2 k0 (u + b u^2) = a^2 k0 u (1 + b u).
struct Wave {
    double amplitude = 20;        ///< [K]
    deadpoint::Vec3 direction{};  ///< [1/m]
    double slope = 0.01;          ///< b [1/K]
    double diffusivity = 0;       ///< k0 / (rho c0) [m2/s]
    static constexpr double start = zero_celsius + 20;

    [[nodiscard]] double at(const deadpoint::Vec3& x, double time) const
    {
        const double square = dot(direction, direction);
        return start + amplitude * std::exp(-dot(direction, x) + square * diffusivity * time);
    }
};

/// Gives the only material of a case the wave's tables; prescribed temperatures then follow it.
Wave make_wave(Case& input, const deadpoint::Vec3& direction)
{
    auto& metal = input.materials.begin()->second;
    Wave wave{20, direction, 0.01, metal.conductivity / (metal.density * metal.specific_heat)};
    metal.conductivity_table = line(metal.conductivity, Wave::start, wave.slope / 2);
    metal.specific_heat_table = line(metal.specific_heat, Wave::start, wave.slope);
    input.machine.initial_temperature = Wave::start;
    return wave;
}

struct WaveRun {
    double error = 0;  ///< root mean square at the probes at the end [K]
    double mismatch = 0;
    int solves = 0;
    std::size_t steps = 0;
    double size = 0;
    std::vector<double> values;
};

WaveRun run_wave(const Case& input, const Wave& wave, double fixed_step)
{
    deadpoint::Observer silent;
    const auto machine = deadpoint::full::prepare_machine(input, 1, silent);
    deadpoint::fem::Model model(machine, deadpoint::press::describe_materials(input, machine), input.numerics.order,
                                silent);
    auto problem = deadpoint::press::describe_heat(input, machine, silent);
    problem.fixed_step = fixed_step;
    problem.solver_tolerance = 1e-12;
    problem.initial_temperature = [&](int, const deadpoint::Vec3& x) { return wave.at(x, 0); };
    for (auto& condition : problem.surfaces)
        condition.temperature = [&](const deadpoint::Vec3& x, double time) { return wave.at(x, time); };
    model.assemble_heat(problem);
    const auto history = model.heat({}, Wave::start, -1, silent, {}, {});
    WaveRun run{0, history.energy.mismatch(), history.linear_solves, history.time.size() - 1, 0, {}};
    run.size = std::cbrt(machine.parts[0].volume / static_cast<double>(machine.cells.size()));
    for (std::size_t i = 0; i < problem.probes.size(); ++i) {
        run.values.push_back(history.probes[i].value.back());
        run.error += std::pow(run.values.back() - wave.at(problem.probes[i].position, history.time.back()), 2);
    }
    run.error = std::sqrt(run.error / static_cast<double>(problem.probes.size()));
    return run;
}

double observed_order(double coarse, double fine, double ratio) { return std::log(coarse / fine) / std::log(ratio); }

}  // namespace

TEST_CASE("a slab whose conductivity follows the temperature: the transform of Kirchhoff, at every node")
{
    auto input =
        read("nafems-t3", {"operation.0.duration=100 h", "numerics.max_step=100 h", "numerics.size=5 mm",
                           "surfaces.driven.temperature_formula=\"393.15\"", "numerics.solver_tolerance=1e-12"});
    constexpr double slope = 0.004, start = zero_celsius;
    input.materials.at("metal").conductivity_table = line(35, start, slope);
    const auto solved = solve(input);
    const double whole = 120 + slope / 2 * 120 * 120;  // theta of 120 K [K]
    for (const double share : {0.2, 0.4, 0.6, 0.8}) {
        const auto name = "x" + std::to_string(static_cast<int>(100 * share));
        // Exact at the nodes, where the probes are: what remains is the solver's tolerance.
        CHECK(solved.probe(name) == near(inverse(share * whole, slope), 1e-7));
    }
    CHECK(solved.history().energy.mismatch() < 1e-8);
}

TEST_CASE("a bond between a material that follows the temperature and one that does not")
{
    auto input = read("bar", {"operation.0.duration=1000 h", "numerics.max_step=1000 h", "numerics.order=2",
                              "numerics.solver_tolerance=1e-12"});
    constexpr double slope = 0.004, start = zero_celsius + 20, held = 20, hot = 140;
    input.materials["other"] = input.materials.at("steel");
    input.materials.at("other").conductivity = 20;
    input.parts.at("lower").material = "other";
    input.materials.at("steel").conductivity_table = line(45, start, slope);
    input.surfaces.at("bottom").temperature = constant(zero_celsius + held);
    input.surfaces.at("top").temperature = constant(zero_celsius + hot);
    for (const char* side : {"lower", "upper"})
        input.probes[side] = {side, {0.05, 0.45, 0.04}, ""};
    const auto solved = solve(input);
    // Cap and upper block follow the temperature, the lower block does not: q 0.02 = 45 theta(T1), 20 (T2 - T1) = q
    // 0.45, q 0.57 = 45 (theta(120) - theta(T2)), temperatures above 20 degC.
    const auto theta = [](double u) { return u + slope / 2 * u * u; };
    const auto bond = [&](double q) { return inverse(q * 0.02 / 45, slope) + q * 0.45 / 20; };
    double low = 0, high = 1e5;
    for (int i = 0; i < 200; ++i) {
        const double q = 0.5 * (low + high);
        (q * 0.57 < 45 * (theta(hot - held) - theta(bond(q))) ? low : high) = q;
    }
    // The profile within a cell is no polynomial; second-order elements of 30 mm follow it to 1e-4 K.
    CHECK(solved.probe("lower") - held == near(bond(low), 2e-6));
    CHECK(solved.probe("upper") - held == near(bond(low), 2e-6));
    CHECK(solved.history().energy.mismatch() < 1e-8);
}

TEST_CASE("heat into a block whose capacity follows the temperature is all there")
{
    auto input = read("cooling-block", {"operation.0.duration=1 h", "machine.initial_temperature=20 degC",
                                        "surfaces.air.film.coefficient=0 W/m^2/K", "numerics.solver_tolerance=1e-12"});
    constexpr double slope = 0.003, power = 1;
    input.materials.at("copper").specific_heat_table = line(385, zero_celsius + 20, slope);
    input.heat_sources["heater"] = {{"block"}, "", constant(power), true};
    const auto solved = solve(input);
    const double rise = inverse(power * 3600 / (8960 * 8e-6 * 385), slope);
    CHECK(rise > 50);  // as much as a press ever warms
    // The heat stored is exact; 1 W does not make the block uneven.
    CHECK(solved.history().part_means[0].value.back() - Wave::start == near(rise, 1e-5));
    CHECK(solved.history().energy.stored == near(power * 3600, 1e-8));
    CHECK(solved.history().energy.mismatch() < 1e-8);
}

TEST_CASE("order in time: conductivity and capacity that follow the temperature")
{
    auto input = read("nafems-t3", {"operation.0.duration=240 s", "numerics.size=10 mm"});
    const auto wave = make_wave(input, {20, 0, 0});
    const auto coarse = run_wave(input, wave, 24), middle = run_wave(input, wave, 12), fine = run_wave(input, wave, 6);
    for (std::size_t i = 0; i < fine.values.size(); ++i) {
        const double order = observed_order(std::abs(coarse.values[i] - middle.values[i]),
                                            std::abs(middle.values[i] - fine.values[i]), 2);
        MESSAGE("order in time " << order << ", last difference " << std::abs(middle.values[i] - fine.values[i])
                                 << " K; solves per stage " << 0.5 * fine.solves / static_cast<double>(fine.steps));
        CHECK(std::abs(order - 2) < 0.1);
    }
    CHECK(fine.mismatch < 1e-8);
}

TEST_CASE("order in space: conductivity and capacity that follow the temperature")
{
    struct Target {
        int order;
        bool tetrahedra;
        int coarse, fine;
    };
    for (const auto& target : {Target{1, false, 6, 12}, {2, false, 3, 6}, {1, true, 5, 10}}) {
        const auto error_of = [&](int cells) {
            auto input = read("cube", {"numerics.order=" + std::to_string(target.order), "operation.0.duration=60 s",
                                       std::string("parts.cube.tetrahedra=") + (target.tetrahedra ? "true" : "false")});
            input.numerics.size = 0.1 / cells;
            for (int i = 1; i < 200; ++i)  // spread evenly by the golden ratio and the plastic number
                input.probes[std::to_string(1000 + i)] = {
                    "cube",
                    {0.1 * std::fmod(0.618 * i, 1), 0.1 * std::fmod(0.755 * i, 1), 0.1 * std::fmod(0.57 * i, 1)},
                    ""};
            const auto wave = make_wave(input, {18, -12, 9});
            return run_wave(input, wave, 6);
        };
        const auto coarse = error_of(target.coarse), fine = error_of(target.fine);
        const double order = observed_order(coarse.error, fine.error, coarse.size / fine.size);
        MESSAGE(std::string(target.tetrahedra ? "tetrahedra" : "hexahedra")
                << " of order " << target.order << ": errors " << coarse.error << ", " << fine.error << " K, order "
                << order);
        // Tetrahedral meshes of two sizes are not alike, as in heat_orders.cpp.
        CHECK(std::abs(order - (target.order + 1)) < (target.tetrahedra ? 0.3 : 0.1));
        CHECK(fine.mismatch < 1e-8);
    }
}

TEST_CASE("tables of one value give what the constant gives, with joints, friction, oil and films")
{
    for (const char* name : {"shaft-in-block", "bonded-blocks", "wall-in-air"}) {
        CAPTURE(name);
        auto input = read(name, {"numerics.solver_tolerance=1e-11"});
        const auto plain = solve(input);
        for (auto& [key, material] : input.materials) {
            material.conductivity_table = {{200, 300, 500}, std::vector<double>(3, material.conductivity)};
            material.specific_heat_table = {{250, 400}, std::vector<double>(2, material.specific_heat)};
        }
        const auto tables = solve(input);
        // The same equations by another solver, but for the iterations' tolerance of 1e-7 K.
        CHECK(largest_difference(plain, tables) < 1e-6);
        CHECK(tables.history().energy.mismatch() < 2 * plain.history().energy.mismatch() + 1e-9);
    }
}

TEST_CASE("hot plates: the balance closes, and a table that ends too early is warned of by name")
{
    struct Listener : deadpoint::Observer {
        std::vector<std::string> warnings;
        void warn(std::string_view text) override
        {
            if (text.starts_with("materials.")) {  // not that 250 degC are too much for a press
                warnings.emplace_back(text);
            }
        }
    };
    auto input = read("hot-plates");
    const auto solved = solve(input);
    CHECK(solved.history().energy.mismatch() < 1e-8);
    CHECK(solved.probe("lower") > 100);
    input.materials.at("first").conductivity_table = {{zero_celsius, zero_celsius + 60}, {60, 52}};
    Listener listener;
    const auto machine = deadpoint::full::prepare_machine(input, 1, listener);
    const auto early = deadpoint::full::run_case(input, machine, {}, listener);
    REQUIRE(listener.warnings.size() == 1);
    CHECK(listener.warnings[0].find("materials.first.conductivity was used from 20.0 to ") == 0);
    CHECK(listener.warnings[0].find("but its table holds from 0.0 to 60.0 degC") != std::string::npos);
    CHECK(early.thermal.part_lowest[0] == near(zero_celsius + 20, 1e-5));
    CHECK(early.thermal.part_highest[0] > early.thermal.probes[0].value.back());
}
