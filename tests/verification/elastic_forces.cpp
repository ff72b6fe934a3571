#include "deadpoint/fem/model.hpp"
#include "deadpoint/fem/tighten.hpp"
#include "deadpoint/full/frame/frame_state.hpp"
#include "deadpoint/full/run/run.hpp"
#include "deadpoint/press/problem/heat.hpp"
#include "deadpoint/press/translate/lookup.hpp"
#include "deadpoint/press/translate/materials.hpp"
#include "near.hpp"
#include "solved_case.hpp"

#include <cmath>

using namespace deadpoint;

namespace {

Observer silent;
constexpr double start = 293.15;
constexpr double length = 0.4, rod_area = 9e-4, tube_area = 0.012;
constexpr double rod_stiffness = 210e9 * rod_area / length, tube_stiffness = 70e9 * tube_area / length;

// Two rods and the tube between rigid plates: force in each rod when rods and tube warm by so much.
double two_springs(double rods, double tube)
{
    const double rod_growth = 1.2e-5 * rods * length, tube_growth = 2.3e-5 * tube * length;
    const double stretch =
        (2 * rod_stiffness * rod_growth + tube_stiffness * tube_growth) / (2 * rod_stiffness + tube_stiffness);
    return rod_stiffness * (stretch - rod_growth);
}

using Feet = casefile::Foundation::Kind;

struct Tube {
    casefile::Case input;
    Machine machine;
    fem::Model model;
    std::vector<ForceGauge> rods, bonds;

    explicit Tube(bool half = false, Feet kind = Feet::free)
        : input(verification::read("rods-in-tube", half ? std::vector<std::string>{"machine.half_model=true"}
                                                        : std::vector<std::string>{})),
          machine(full::prepare_machine(input, 1, silent)),
          model(machine, press::describe_materials(input, machine), 1, silent)
    {
        input.foundation->kind = kind;
        if (kind == Feet::elastic)
            input.foundation->vertical_stiffness = input.foundation->horizontal_stiffness = 1e10;
        model.support(full::describe_foundation(input, machine));
        for (const char* name : {"rod_left", "rod_right"})
            if (const int part = press::part_index(machine, name); part >= 0)
                rods.push_back({name, ForceGauge::Kind::rod, part, Axis::y});
        for (int b = 0; b < static_cast<int>(machine.bonds.size()); ++b)
            bonds.push_back({machine.bonds[b].name, ForceGauge::Kind::bond, b, Axis::y});
    }
    [[nodiscard]] fem::Field warm(double rod, double tube) const
    {
        return model.interpolate_field([=](const Vec3& x) {
            const bool in_rod = std::abs(x[0]) < 0.075 && std::abs(x[2]) < 0.02;
            return start + (in_rod ? rod : tube);
        });
    }
    /// Force across the bond of two parts, tension positive.
    double across(const std::string& part, const std::vector<double>& forces) const
    {
        double sum = 0;
        for (std::size_t b = 0; b < bonds.size(); ++b)
            if (bonds[b].name.find(part) != std::string::npos && bonds[b].name.find("plate_above") != std::string::npos)
                sum += forces[b];
        return sum;
    }
};

struct Listener : Observer {
    std::vector<std::string> warnings;
    void warn(std::string_view message) override { warnings.emplace_back(message); }
    [[nodiscard]] bool heard(const std::string& words) const
    {
        return std::ranges::any_of(warnings, [&](const auto& w) { return w.find(words) != std::string::npos; });
    }
};

}  // namespace

TEST_CASE("forces: warm rods in a tube lose what two springs say")
{
    for (const bool half : {false, true}) {
        CAPTURE(half);
        Tube tube(half);
        const auto adjoints = tube.model.adjoints(tube.rods);
        const auto across = tube.model.adjoints(tube.bonds);
        for (const auto& [rod, wall] : {std::pair{50.0, 0.0}, std::pair{0.0, 30.0}, std::pair{60.0, 20.0}}) {
            const auto field = tube.warm(rod, wall);
            const double expected = two_springs(rod, wall);
            // plates ten thousand times as stiff, not rigid: their give is below 1e-3
            for (const auto& adjoint : adjoints)
                CHECK(tube.model.apply(adjoint, field, start) == near(expected, 1e-3));
            std::vector<double> forces;
            for (const auto& adjoint : across)
                forces.push_back(tube.model.apply(adjoint, field, start));
            // what pulls at the rods presses on the tube, to the solver's tolerance
            const double rod_force = tube.across("rod_left", forces), tube_force = tube.across("tube", forces);
            CHECK(rod_force == near(tube.model.apply(adjoints[0], field, start), 1e-7));
            CHECK(tube_force == near(-2 * rod_force, 1e-6));
        }
    }
}

TEST_CASE("forces: rods get the preload that is stated, weights acting")
{
    for (const auto kind : {Feet::free, Feet::clamped, Feet::elastic}) {
        CAPTURE(casefile::name_of(kind));
        Tube tube(false, kind);
        const Vec3 gravity{0, -9.81, 0};
        const auto loads = fem::tighten(tube.model, tube.machine.parts.size(), tube.rods, {60e3, 45e3}, gravity);
        const auto u = tube.model.displacement(loads);
        const auto rods = tube.model.forces(tube.rods, loads, u);
        CHECK(rods[0] == near(60e3, 1e-8));
        CHECK(rods[1] == near(45e3, 1e-8));
        const auto bonds = tube.model.forces(tube.bonds, loads, u);
        // the plate above rests on the tube, with the upper half of the rods hanging in it
        const double plate = 1000 * 9.81 * 0.2 * 0.1 * 0.04, half_rod = 7850 * 9.81 * rod_area * length / 2;
        CHECK(tube.across("rod", bonds) == near(105e3 + 2 * half_rod, 1e-7));
        CHECK(tube.across("tube", bonds) == near(-105e3 - 2 * half_rod - plate, 1e-7));
        double weight = 0;
        for (const auto& part : tube.machine.parts)
            weight += 9.81 * part.volume *
                      press::describe_materials(tube.input, tube.machine)[&part - tube.machine.parts.data()].density;
        const auto feet = tube.model.forces({{"feet", ForceGauge::Kind::feet, 0, Axis::y}}, loads, u);
        CHECK(feet[0] == near(weight, 1e-7));
        // 60 kN on 900 mm2 in the mean; the plates tilt under unequal forces and bend the rods
        const auto stress = tube.model.stress({press::part_index(tube.machine, "rod_left")}, u, loads).front();
        double sum = 0, count = 0;
        for (std::size_t i = 0; i < stress.nodes.size(); ++i)
            if (std::abs(tube.machine.nodes[stress.nodes[i]][1] - 0.2) < 0.1) {
                sum += stress.stress[i][1];
                ++count;
            }
        CHECK(sum / count == near(60e3 / rod_area, 1e-3));
    }
}

TEST_CASE("forces: adjoint and direct deformation agree on every foundation")
{
    for (const auto kind : {Feet::free, Feet::clamped, Feet::elastic}) {
        CAPTURE(casefile::name_of(kind));
        Tube tube(false, kind);
        const auto field = tube.model.interpolate_field(
            [](const Vec3& x) { return start + 40 * x[1] + 200 * x[0] * x[1] + 10 * std::sin(20 * x[2]); });
        Functional height{"height", {}};
        for (const auto& point : tube.machine.bonds.front().points)
            height.points.push_back({point.face_a, point.position_a, {0.3, 1, -0.2}});
        const double direct = tube.model.evaluate({height}, tube.model.displacement(field, start))[0];
        const auto adjoint = tube.model.adjoints(std::vector<Functional>{height});
        // the same linear algebra, solved to 1e-10 of the load; what is left of it in a mean of 2 mm
        CHECK(tube.model.apply(adjoint[0], field, start) == near(direct, 1e-6));
    }
}

TEST_CASE("forces: very stiff pads clamp")
{
    const auto lift = [](const Foundation::Kind kind, double stiffness) {
        Tube tube;
        tube.model.support({press::surface_index(tube.machine, "feet"), kind, stiffness, stiffness});
        Functional side{"side", {}};
        for (const auto& point : tube.machine.bonds.front().points)
            side.points.push_back({point.face_a, point.position_a, {1, 0.5, 0}});
        const auto field = tube.warm(10, 40);
        return tube.model.evaluate({side}, tube.model.displacement(field, start))[0];
    };
    const double clamped = lift(Foundation::Kind::clamped, 0);
    // what the pads give is their softness against the tube's, 70 GPa / 0.4 m over 1e17 N/m3, and rounding
    CHECK(lift(Foundation::Kind::elastic, 1e17) == near(clamped, 1e-4));
}

TEST_CASE("forces: a run reports its rods, and warns when they come loose")
{
    auto input = verification::read("rods-in-tube");
    const auto machine = full::prepare_machine(input, 1, silent);
    const auto run = [&](double force, double share, double process) {
        input.preload.at("rods").force = force;
        input.preload.at("rods").process_share = share;
        input.operation[0].force = process;
        Listener listener;
        auto result = full::run_case(input, machine, {}, listener);
        return std::pair{std::move(result), listener};
    };
    const auto [held, quiet] = run(120e3, 0, 0);
    REQUIRE(held.frame);
    REQUIRE(held.frame->rods.size() == 2);
    REQUIRE(held.frame->bonds.size() == 2);
    const auto& rod = held.frame->rods[0];
    CHECK(rod.start == near(120e3, 1e-8));
    CHECK(rod.change.value.front() == near(0, 0, 1.2e-5));
    // The mean temperatures of the last step, by the two springs; parts of the tube are warmer than others, which bends
    // it
    const auto& means = held.thermal.part_means;
    const double expected = two_springs(means[press::part_index(machine, "rod_left")].value.back() - start,
                                        means[press::part_index(machine, "tube")].value.back() - start);
    CHECK(rod.change.value.back() == near(expected, 0.01));
    CHECK(rod.change.value.back() < -50e3);
    CHECK_FALSE(quiet.heard("preload"));
    CHECK(held.frame->bonds[0].openings.back().share == 0);
    // the stress at the end follows from the force that is left
    for (const auto& peak : held.frame->stress)
        if (peak.part == "rod_left" && peak.time == 3600)
            CHECK(peak.highest_principal == near((120e3 + rod.change.value.back()) / rod_area, 0.1));

    const auto [loose, loud] = run(20e3, 0, 0);
    CHECK(loose.frame->rods[0].change.value.back() == near(rod.change.value.back(), 1e-6));
    CHECK(loud.heard("rod 'rod_left' comes loose"));
    CHECK(loud.heard("would open"));
    CHECK(loud.heard("of its area"));
    CHECK(loose.frame->bonds[0].openings.back().share > 0.9);

    const auto [working, strained] = run(120e3, 0.5, 200e3);
    CHECK(strained.heard("less than the 100.0 kN"));
    CHECK_FALSE(strained.heard("would open"));
}

TEST_CASE("forces: weights change stress and support, never the drift")
{
    auto input =
        casefile::read_case(std::string(DEADPOINT_VERIFICATION_CASES) + "/../../../cases/starter/case.toml", {}).value;
    for (auto& segment : input.operation)
        segment.duration = 600;
    const auto machine = full::prepare_machine(input, 2.5, silent);
    const auto plain = full::run_case(input, machine, {}, silent);
    input.foundation.emplace();
    input.foundation->gravity = 9.81;
    const auto heavy = full::run_case(input, machine, {}, silent);
    REQUIRE(plain.drift);
    REQUIRE(heavy.drift);
    REQUIRE(plain.drift->time.size() == heavy.drift->time.size());
    double difference = 0;
    for (std::size_t i = 0; i < plain.drift->time.size(); ++i)
        difference = std::max(difference, std::abs(plain.drift->gap.value[i] - heavy.drift->gap.value[i]));
    // Weights do not enter the adjoints. Two runs differ by what their heat solver leaves, 1e-6 K of some kelvin; the
    // frame itself gives way by rho g H^2 / E, about a micrometre, 10^5 times as much.
    CHECK(difference < 1e-6 * std::abs(plain.drift->gap.value.back()));
    double weight = 0;
    for (const auto& part : machine.parts)
        if (part.body == "frame")
            weight += 9.81 * part.mass;
    CHECK(*heavy.frame->support_force == near(weight, 1e-7));
}
