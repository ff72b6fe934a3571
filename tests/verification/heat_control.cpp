#include "deadpoint/error.hpp"
#include "deadpoint/full/run/run.hpp"
#include "deadpoint/heat/tr_bdf2.hpp"
#include "near.hpp"
#include "solved_case.hpp"

#include <algorithm>
#include <cmath>

// What the control of the time steps promises, and what a run says of its steps, its balance and its failures.

using namespace verification;
using deadpoint::Series;

namespace {

/// Three blocks on a circuit with 2 l of oil in an open sump: two hours warm, then six at rest.
Case with_sump(double tolerance)
{
    auto input = read("three-blocks", {"surfaces.air.film.coefficient=60 W/m^2/K", "friction.one.load_part=100 W"});
    input.lubricants["oil"].density = 870;
    for (auto* joint : {"first", "second"})
        input.joints.at(joint).interfaces[0].oil = 4000;
    deadpoint::casefile::OilCircuit circuit;
    circuit.joints = {"first", "second"};
    circuit.flow = 1e-5;
    circuit.lubricant = "oil";
    circuit.sump_volume = 2e-3;
    circuit.sump_loss = 1;  // C / loss = 3306 s
    input.oil_circuits["main"] = circuit;
    input.operation[0].duration = 7200;
    input.operation.push_back(input.operation[0]);
    input.operation[1].duration = 6 * 3600;
    input.operation[1].speed = 0;
    input.numerics.time_tolerance = tolerance;
    input.numerics.max_step = 1800;
    return input;
}

/// A block of 80 degC in a box of still air that begins at the room's temperature.
Case in_a_box(double tolerance)
{
    auto input = read("warm-box", {"machine.initial_temperature=80 degC", "enclosures.box.temperature=20 degC",
                                   "enclosures.box.heat_capacity=400 J/K", "enclosures.box.exchange=0.2 W/K"});
    input.operation[0].duration = 8 * 3600;
    input.numerics.time_tolerance = tolerance;
    input.numerics.max_step = 1800;
    return input;
}

using Course = std::function<const Series&(const deadpoint::ThermalHistory&)>;

/// Largest difference at the steps and each minute between them [K].
double largest_error(const deadpoint::ThermalHistory& run, const deadpoint::ThermalHistory& fine, const Course& course)
{
    auto times = run.time;
    for (double time = 0; time < run.time.back(); time += 60)
        times.push_back(time);
    double largest = 0;
    for (const double time : times)
        largest = std::max(
            largest, std::abs(interpolate(run.time, course(run), time) - interpolate(fine.time, course(fine), time)));
    return largest;
}

void check_tolerances(Case (*at_tolerance)(double), const Course& course)
{
    const auto fine = solve(at_tolerance(2e-6));
    for (const double tolerance : {0.1, 0.05, 0.02, 0.01, 1e-3, 1e-4}) {
        const auto solved = solve(at_tolerance(tolerance));
        const double error = largest_error(solved.history(), fine.history(), course);
        MESSAGE("tolerance " << tolerance << " K: " << error << " K off, " << solved.history().time.size() - 1
                             << " steps, " << solved.history().rejected_steps << " rejected");
        CHECK(error < tolerance);
    }
}

/// Keeps what a run warns of.
class Listener : public deadpoint::Observer {
public:
    void warn(std::string_view text) override { warnings += std::string(text) + "\n"; }
    std::string warnings;
};

std::string warnings_of(const Case& input)
{
    Listener listener;
    const auto machine = deadpoint::full::prepare_machine(input, 1, listener);
    (void)deadpoint::full::run_case(input, machine, {}, listener);
    return listener.warnings;
}

}  // namespace

TEST_CASE("what a step may err by falls with the power 3/2 of the time tolerance, below the default")
{
    CHECK(deadpoint::heat::step_tolerance(0.05) == near(0.05, 1e-5));
    CHECK(deadpoint::heat::step_tolerance(0.02) == near(0.02, 1e-5));
    CHECK(deadpoint::heat::step_tolerance(0.005) == near(0.005 / 2, 1e-5));
    CHECK(deadpoint::heat::step_tolerance(0.0002) == near(0.0002 / 10, 1e-5));
    for (const double tolerance : {0.3, 0.02, 0.004, 1e-5})
        CHECK(deadpoint::heat::time_tolerance_of(deadpoint::heat::step_tolerance(tolerance)) == near(tolerance, 1e-5));
}

TEST_CASE("a sump keeps to the time tolerance, between the steps too")
{
    check_tolerances(with_sump, [](const auto& history) -> const Series& { return history.oil[0].sump; });
}

TEST_CASE("enclosed air keeps to the time tolerance, between the steps too")
{
    check_tolerances(in_a_box, [](const auto& history) -> const Series& { return history.enclosures[0].temperature; });
}

TEST_CASE("a sump that cools by itself follows its exponential")
{
    auto input = with_sump(0.01);
    input.operation.erase(input.operation.begin());
    input.oil_circuits.at("main").sump_temperature = zero_celsius + 60;
    const auto solved = solve(input);
    const auto& time = solved.history().time;
    const double constant = 870 * 1900 * 2e-3;  // s
    for (double at = 0; at < time.back(); at += 60) {
        const double exact = zero_celsius + 20 + 40 * std::exp(-at / constant);
        CHECK(std::abs(interpolate(time, solved.history().oil[0].sump, at) - exact) < 0.01);
    }
}

TEST_CASE("a machine at rest in air of its own temperature: its balance is nothing to warn of")
{
    auto input = read("three-blocks", {"operation.0.speed=0 rpm", "operation.0.duration=10 h",
                                       "numerics.max_step=1800 s", "numerics.solver_tolerance=1e-6"});
    CHECK(warnings_of(input).find("energy balance") == std::string::npos);
    // Nor where it hardly warms; its 2.5 kJ/K take 1e-6 K of each solve.
    input.machine.ambient += 1e-3;
    CHECK(warnings_of(input).find("energy balance") == std::string::npos);
}

TEST_CASE("steps that stay short are warned of while the run goes on")
{
    // A wave of 2 s through the surface, over a year; the steps cannot be longer. The run is stopped after a while.
    class Stopper : public Listener {
    public:
        void progress(double, std::string_view) override { ++steps_; }
        [[nodiscard]] bool cancelled() const override { return steps_ > 1100; }

    private:
        int steps_ = 0;
    } stopper;
    auto input = read("wall-in-air");
    input.numerics.time_tolerance = 1e-3;
    input.numerics.initial_step = 0.5;
    input.numerics.max_step = 3600;
    input.operation[0].duration = 365 * 86400.0;
    for (auto& [name, surface] : input.surfaces)
        if (surface.film) {
            surface.film.reset();
            surface.temperature_formula = "293.15 + 10*sin(pi*t)";
        }
    const auto machine = deadpoint::full::prepare_machine(input, 1, stopper);
    (void)deadpoint::full::run_case(input, machine, {}, stopper);
    CHECK(stopper.warnings.find("after 1000 time steps the run is at t = ") != std::string::npos);
    CHECK(stopper.warnings.find("more follow") != std::string::npos);
}

TEST_CASE("a solve that meets a value that is not finite names the quantity")
{
    const auto failure = [](const std::string& change) {
        try {
            solve(read("three-blocks", {change}));
        } catch (const deadpoint::Error& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    const auto heat = failure("friction.one.load_part=1e300 W");
    CHECK(heat.find("friction.one") != std::string::npos);
    CHECK(heat.find("1e+300 W") != std::string::npos);
    CHECK(heat.find("reason -") == std::string::npos);
    const auto film = failure("surfaces.air.film.coefficient=1e300 W/m^2/K");
    CAPTURE(film);
    CHECK(film.find("surfaces.air") != std::string::npos);
    CHECK(film.find("1e+300 W/m2/K") != std::string::npos);
}
