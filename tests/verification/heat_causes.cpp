#include "deadpoint/exchange/heat_causes.hpp"

#include "busy_blocks.hpp"
#include "deadpoint/fem/model.hpp"
#include "deadpoint/full/run/run.hpp"
#include "deadpoint/press/problem/heat.hpp"
#include "deadpoint/press/translate/materials.hpp"
#include "near.hpp"

#include <cmath>
#include <numeric>

// Which heat has moved a functional of the temperatures: by running the time steps backward, against runs forward with
// one cause alone.

using namespace verification;
using deadpoint::HeatProblem;
using deadpoint::SurfaceCondition;

namespace {

struct Bench {
    explicit Bench(Case given)
        : input(std::move(given)), machine(deadpoint::full::prepare_machine(input, 1, silent)),
          model(machine, deadpoint::press::describe_materials(input, machine), input.numerics.order, silent)
    {
        // Any functional will do; this one changes its sign within every part.
        weights.name = "weights";
        weights.owned = model
                            .interpolate_field([](const deadpoint::Vec3& x) {
                                return std::sin(90 * x[0]) * std::cos(60 * x[1]) + 0.3 * x[2] / 0.05;
                            })
                            .owned;
    }

    HeatProblem problem()
    {
        auto result = deadpoint::press::describe_heat(input, machine, silent);
        result.solver_tolerance = 1e-13;
        return result;
    }
    /// The functional of the weights over a run.
    deadpoint::ThermalHistory run(const HeatProblem& problem)
    {
        model.assemble_heat(problem);
        return model.heat({weights}, input.machine.initial_temperature, -1, silent, {}, {});
    }

    deadpoint::Observer silent;
    Case input;
    deadpoint::Machine machine;
    deadpoint::fem::Model model;
    deadpoint::fem::Adjoint weights;
};

double sum(const std::vector<double>& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

double sum(const deadpoint::HeatCauses& causes)
{
    return sum(causes.friction) + sum(causes.oil) + sum(causes.surfaces) + sum(causes.body_heat) + causes.start;
}

// At the start, within each segment, at their ends and at the end.
void check_sums(Bench& bench, const HeatProblem& problem)
{
    const auto history = bench.run(problem);
    const auto& value = history.functionals[0].value;
    const std::size_t rows = value.size();
    double scale = 0;
    for (const std::size_t row : {std::size_t{0}, rows / 4, rows / 2, 3 * rows / 4, rows - 1}) {
        const auto causes = bench.model.heat_causes(bench.weights, row);
        scale = std::max(scale, std::abs(value[row]));
        CAPTURE(row);
        // What the linear solvers leave: 1e-8 of each solve of the weights.
        CHECK(std::abs(sum(causes) - value[row]) <= 1e-6 * std::abs(value[row]));
    }
    REQUIRE(scale > 1);
}

deadpoint::TimeCourse warming_room(double from)
{
    return [from](double time) { return from + 4 * std::sin(time / 700); };
}

}  // namespace

TEST_CASE(
    "causes add up: friction by viscosity, oil circuit, ambient, motor, held and heated surfaces, rest, a warm start")
{
    Bench bench(on_an_oil_circuit(busy_blocks()));
    auto problem = bench.problem();
    for (auto& segment : problem.segments) {
        segment.ambient = warming_room(zero_celsius + 24);
        if (segment.heat[0])
            segment.heat[0] = [](double film) {
                const double heat = 120 * std::exp(-0.02 * (film - zero_celsius - 20));
                return deadpoint::LawValue{heat, -0.02 * heat, true};
            };
    }
    problem.initial_temperature = [](int, const deadpoint::Vec3& x) { return zero_celsius + 22 + 30 * x[0]; };
    check_sums(bench, problem);
}

TEST_CASE("causes add up: bodies of different temperatures that radiate to each other in an enclosure")
{
    Bench bench(
        read("warm-box",
             {"bodies.inner.initial_temperature=150 degC", "surfaces.block_faces.film.emissivity=0.8",
              "surfaces.wall_inside.film.emissivity=0.4", "operation.0.duration=4 h", "numerics.max_step=1800 s"}));
    const auto problem = bench.problem();
    REQUIRE(problem.radiation.size() == 1);
    check_sums(bench, problem);
}

TEST_CASE("causes add up: a turning joint, heat into a part's volume by load zone")
{
    Bench bench(read("shaft-in-block"));
    auto problem = bench.problem();
    check_sums(bench, problem);
    for (auto* laws : {&problem.interfaces, &problem.segments[0].interfaces})
        for (auto& law : *laws) {
            law.heat_part = 0;
            law.load_zone = [](const deadpoint::Vec3& x) { return std::max(0.0, x[1]); };
        }
    problem.segments[0].zoned_heat = {15};
    check_sums(bench, problem);
}

TEST_CASE(
    "causes on few fields agree with those in all unknowns: a turning joint, heat into a part's volume by load zone")
{
    Bench bench(read("shaft-in-block"));
    auto problem = bench.problem();
    for (auto* laws : {&problem.interfaces, &problem.segments[0].interfaces})
        for (auto& law : *laws) {
            law.heat_part = 0;
            law.load_zone = [](const deadpoint::Vec3& x) { return std::max(0.0, x[1]); };
        }
    problem.segments[0].zoned_heat = {15};
    const std::size_t row = bench.run(problem).time.size() - 1;
    const auto exact = bench.model.heat_causes(bench.weights, row);
    bench.run(problem);
    const auto found = bench.model.heat_causes_on_basis(bench.weights, row);
    CHECK(exact.fields == 0);
    CHECK(found.fields >= 8);
    CHECK(found.fields <= 30);
    // Two more fields would change a cause by 1e-3 of it; 0.5 % of the sum is the smallest that counts.
    const double least = 5e-3 * std::abs(sum(exact));
    for (std::size_t i = 0; i < exact.friction.size(); ++i)
        CHECK(std::abs(found.friction[i] - exact.friction[i]) <= 2e-3 * std::max(std::abs(exact.friction[i]), least));
    for (std::size_t i = 0; i < exact.surfaces.size(); ++i)
        CHECK(std::abs(found.surfaces[i] - exact.surfaces[i]) <= 2e-3 * std::max(std::abs(exact.surfaces[i]), least));
}

namespace {

// The problem with nothing but what `keep` puts back, at the reference temperature.
HeatProblem silenced(HeatProblem problem, double reference)
{
    const auto at_reference = [reference](double) { return reference; };
    for (auto& segment : problem.segments) {
        for (auto& heat : segment.heat)
            heat = {};
        for (auto& power : segment.body_heat)
            power = {};
        segment.ambient = at_reference;
        for (auto& law : segment.interfaces)
            law.oil_temperature = reference;
    }
    for (auto& condition : problem.surfaces) {
        if (condition.kind == SurfaceCondition::Kind::temperature)
            condition.temperature = [reference](const deadpoint::Vec3&, double) { return reference; };
        if (condition.kind == SurfaceCondition::Kind::flux)
            condition.flux = [](double) { return 0.0; };
    }
    problem.initial_temperature = [reference](int, const deadpoint::Vec3&) { return reference; };
    return problem;
}

}  // namespace

TEST_CASE("each cause is what a run with it alone gives")
{
    auto input = busy_blocks();
    input.joints.at("first").oil_temperature = zero_celsius + 27;
    input.joints.at("second").interfaces[0].oil = 150;
    input.joints.at("second").oil_temperature = zero_celsius + 33;
    Bench bench(input);
    const double reference = input.machine.initial_temperature;
    auto all = bench.problem();
    all.fixed_step = 60;
    for (auto& segment : all.segments)
        segment.ambient = warming_room(zero_celsius + 24);
    // While the press stands, the joints part.
    for (auto& law : all.segments[1].interfaces)
        law.film_a *= 0.2;
    all.initial_temperature = [](int, const deadpoint::Vec3& x) { return zero_celsius + 22 + 30 * x[0]; };
    bench.run(all);
    const auto row = static_cast<std::size_t>(3 * (900 / 60 + 1) - 1);
    const auto causes = bench.model.heat_causes(bench.weights, row);
    const double scale = std::abs(sum(causes.friction));
    REQUIRE(scale > 1);

    const auto check = [&](const char* name, double share, const std::function<void(HeatProblem&)>& keep) {
        CAPTURE(name);
        auto alone = silenced(all, reference);
        keep(alone);
        const auto history = bench.run(alone);
        REQUIRE(history.time.size() == row + 1);
        REQUIRE(std::abs(share) > 1e-3 * scale);
        // What the linear solvers leave.
        CHECK(std::abs(share - history.functionals[0].value[row]) < 1e-7 * scale);
    };
    const auto areas = [&](std::size_t i) { return all.interfaces[i].heat_weight * bench.machine.interfaces[i].area; };
    for (std::size_t i = 0; i < 2; ++i)
        check("friction of a joint", causes.friction[i], [&](HeatProblem& alone) {
            const double heat = 50 * areas(i) / (areas(0) + areas(1));
            for (auto s : {0, 2})
                alone.segments[static_cast<std::size_t>(s)].heat[0] = [heat](double) {
                    return deadpoint::LawValue{heat, 0, true};
                };
            for (auto& segment : alone.segments)
                segment.interfaces[1 - i].source = -1;
        });
    for (std::size_t i = 0; i < 2; ++i)
        check("oil of a joint", causes.oil[i], [&](HeatProblem& alone) {
            for (std::size_t s = 0; s < 3; ++s)
                alone.segments[s].interfaces[i].oil_temperature = all.segments[s].interfaces[i].oil_temperature;
        });
    check("motor", causes.body_heat[0], [&](HeatProblem& alone) {
        for (std::size_t s = 0; s < 3; ++s)
            alone.segments[s].body_heat = all.segments[s].body_heat;
    });
    check("start", causes.start, [&](HeatProblem& alone) { alone.initial_temperature = all.initial_temperature; });
    for (std::size_t k = 0; k < all.surfaces.size(); ++k)
        check(all.surfaces[k].name.c_str(), causes.surfaces[k], [&](HeatProblem& alone) {
            if (all.surfaces[k].kind == SurfaceCondition::Kind::film)
                for (std::size_t s = 0; s < 3; ++s)
                    alone.segments[s].ambient = all.segments[s].ambient;
            else
                alone.surfaces[k] = all.surfaces[k];
        });
}

TEST_CASE("joints answer each other alike: heat of one in the film of the other")
{
    // Steady conduction is symmetric: what 50 W in one joint do to the mean film temperature of the other, 50 W there
    // do to the first's.
    const auto film = [](const char* heated, const char* idle, std::size_t watched) {
        const auto solved = solve("three-blocks", {std::string("friction.") + heated + ".load_part=50 W",
                                                   std::string("friction.") + idle + ".load_part=0 W"});
        return solved.history().source_temperature[watched].back() - zero_celsius - 20;
    };
    const double forth = film("one", "two", 1), back = film("two", "one", 0);
    CHECK(forth > 1);
    CHECK(forth == near(back, 1e-7));
}

namespace {

// The shipped starter press, coarse, for its dimension chain.
Case starter(const std::vector<std::string>& overrides) { return read("../../../cases/starter/case", overrides); }

std::vector<deadpoint::DriftCauses> causes_of(Case input)
{
    deadpoint::Observer silent;
    input.output.fields = false;
    const auto machine = deadpoint::full::prepare_machine(input, 3, silent);
    deadpoint::full::RunOptions options;
    options.causes = true;
    const auto result = deadpoint::full::run_case(input, machine, options, silent);
    REQUIRE(result.drift);
    if (!result.causes.empty())
        CHECK(result.causes.back().gap == result.drift->gap.value.back());
    return result.causes;
}

double strongest_joint(const deadpoint::DriftCauses& causes)
{
    double largest = 0;
    for (const auto& [name, value] : causes.joints)
        largest = std::max(largest, std::abs(value));
    return largest;
}

}  // namespace

TEST_CASE("causes of the gap: joints, oil and ambient of a press sum to E_SW")
{
    // Two hours of running in a room that is colder than the machine, then rest: the largest change is not at the end.
    auto input =
        starter({"surfaces.air_frame.film.emissivity=0", "surfaces.air_moving.film.emissivity=0",
                 "oil.journals=300 W/m^2/K", "joints.crank_bearing.oil_temperature=26 degC", "machine.ambient=18 degC",
                 "operation.0.duration=2 h", "numerics.time_tolerance=0.05 K", "numerics.solver_tolerance=1e-9"});
    input.operation.push_back(input.operation[0]);
    input.operation[1].speed = 0;
    const auto causes = causes_of(input);
    REQUIRE(causes.size() == 2);
    CHECK(causes[0].time > 3600);
    CHECK(causes[0].time < causes[1].time);
    CHECK(std::abs(causes[0].gap) > std::abs(causes[1].gap));
    for (const auto& at : causes) {
        CHECK(at.joints.size() == 4);
        CHECK(strongest_joint(at) > 1e-6);
        CHECK(std::abs(at.oil) > 1e-7);
        CHECK(std::abs(at.air) > 1e-7);
        CHECK(at.start == 0);
        CHECK(std::abs(at.remainder) < 1e-6 * std::abs(at.gap));
    }
}

TEST_CASE("causes of the gap: films that follow the temperature leave a remainder of their own")
{
    const auto causes = causes_of(starter({"operation.0.duration=1 h"}));
    REQUIRE(causes.size() == 1);
    // Radiation varies with the temperature over a surface; one coefficient per surface and time says most of it.
    CHECK(std::abs(causes[0].remainder) > 1e-5 * strongest_joint(causes[0]));
    CHECK(std::abs(causes[0].remainder) < 0.005 * strongest_joint(causes[0]));
    CHECK(causes_of(starter({"operation.0.duration=5 min", "output.causes=false"})).empty());
}
