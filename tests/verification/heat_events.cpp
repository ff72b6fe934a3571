#include "deadpoint/press/problem/heat.hpp"
#include "near.hpp"
#include "solved_case.hpp"

#include <cmath>
#include <string>

// What happens at a time: heat between two steps, jumps, courses that were measured every few seconds.

using namespace verification;

namespace {

constexpr double minute = 60, hour = 3600;
/// Heat of steps that add up, each with the rounding of its sums.
constexpr double summed = 1e-9;

/// Measured every 10 s over the run: a swing, a controller's cycle and noise.
casefile::Course logged(double mean, double swing, double noise)
{
    casefile::Course course;
    course.table.emplace();
    unsigned state = 1;
    for (int k = 0; k <= 1440; ++k) {
        state = state * 1664525u + 1013904223u;
        course.table->x.push_back(10.0 * k);
        course.table->y.push_back(mean + swing * std::sin(k / 900.0) + 0.3 * swing * std::sin(k / 10.5) +
                                  noise * (state / 4294967296.0 - 0.5));
    }
    return course;
}

double integral_of(const casefile::Table& table)
{
    double sum = 0;
    for (std::size_t i = 1; i < table.x.size(); ++i)
        sum += 0.5 * (table.x[i] - table.x[i - 1]) * (table.y[i] + table.y[i - 1]);
    return sum;
}

/// 120 degC on one face of a slab of 100 mm at 20 degC for a time, the others insulated: the middle by its series
/// (Carslaw and Jaeger, Conduction of Heat in Solids, sec. 3.4) [degC].
double slab_middle(double time)
{
    const double diffusivity = 50.0 / (7850 * 460), pi = 3.14159265358979;
    double share = 0;
    for (int n = 0; n < 50; ++n) {
        const double wave = (n + 0.5) * pi;
        share += 2 / wave * std::sin(wave / 2) * std::exp(-wave * wave * diffusivity * time / 0.01);
    }
    return 120 - 100 * share;
}

struct Warnings : deadpoint::Observer {
    void warn(std::string_view text) override { all += std::string(text) + "\n"; }
    std::string all;
};

}  // namespace

TEST_CASE("five minutes of 500 W between two steps warm the block")
{
    const auto solved = solve("pulse-source");
    CHECK(solved.history().energy.generated == near(500 * 300.0, summed));
    double peak = 0;
    for (const double kelvin : solved.history().probes[0].value)
        peak = std::max(peak, kelvin - zero_celsius);
    // One mass of 3611 J/K that loses 0.6 W/K. Its middle is warmer than its mean by up to h L / 2 k = 0.5 % of 40 K,
    // and the time steps add 0.1 K.
    CHECK(peak == near(20 + 500 / 0.6 * -std::expm1(-300.5 * 0.6 / 3611), 0, 0.3));
}

TEST_CASE("a face that jumps by table or by formula warms the slab as in closed form")
{
    for (const auto* name : {"step-table", "step-formula"}) {
        const auto solved = solve(name, {}, 0.2);
        // Cells of 10 mm: 0.1 K against the series.
        CHECK(solved.probe("middle", 15 * minute) == near(slab_middle(5 * minute), 0, 0.2));
        CHECK(solved.probe("middle", 9 * minute) == near(20, 0, 1e-6));
        CHECK(solved.probe("middle") == near(120, 0, 0.1));
    }
    CHECK(slab_middle(5 * minute) == near(87.70, 0, 0.01));
}

TEST_CASE("a jump by the same time twice is that of a ramp, and a formula in place jumps where it wants")
{
    auto input = read("step-table");
    input.surfaces.at("hot").temperature->table->x = {0, 600, 600};
    CHECK(solve(input, 0.2).probe("middle", 15 * minute) == near(slab_middle(5 * minute), 0, 0.2));
    // A front that moves over the face at 1 mm/s.
    const auto front = solve("step-formula", {"surfaces.hot.temperature_formula=1000*y < t - 600 ? 393.15 : 293.15"});
    CHECK(front.probe("middle") == near(120, 0, 0.1));
}

TEST_CASE("a formula that acts for minutes between two long steps is seen")
{
    // The run ends while some of the heat is still there, which the balance is relative to.
    const auto solved =
        solve("step-formula", {"surfaces.hot.temperature_formula=t > 7920 && t < 8220 ? 393.15 : 293.15",
                               "operation.0.duration=8400 s"});
    CHECK(solved.probe("middle", 8220) > 60);
}

TEST_CASE("dense tables of heat, flux and air cost few steps, and their energy is their integral")
{
    auto input = read("pulse-source");
    input.heat_sources.at("motor").power = logged(40, 20, 10);
    input.operation[0].ambient = logged(zero_celsius + 20, 3, 0.4);
    casefile::Surface flux;
    flux.parts = {"block"};
    flux.select = casefile::Surface::Select::plane;
    flux.axis = deadpoint::Axis::x;
    flux.position = 0;
    flux.heat_flux = logged(300, 100, 50);
    input.surfaces["plate"] = flux;
    const auto solved = solve(input);
    const auto& energy = solved.history().energy;
    CHECK(energy.generated == near(integral_of(*input.heat_sources.at("motor").power->table), summed));
    CHECK(energy.from_surfaces == near(0.01 * integral_of(*flux.heat_flux->table), summed));
    CHECK(solved.history().time.size() < 720);  // half of the 1440 points of each table
}

TEST_CASE("a break of 0 rpm is no change of the process force, a stroke without force is one")
{
    auto input = read("three-blocks");
    input.operation.assign(3, input.operation[0]);
    input.operation[0].force = input.operation[2].force = 4e5;
    input.operation[1].speed = 0;
    input.operation[1].force = 0;
    const auto warnings = [&] {
        Warnings result;
        deadpoint::full::Press press(input, 1);
        deadpoint::press::describe_heat(input, press.machine(result), result);
        return result.all;
    };
    CHECK(warnings().find("process force changes") == std::string::npos);
    input.operation[1].speed = input.operation[0].speed;
    CHECK(warnings().find("process force changes") != std::string::npos);
}
