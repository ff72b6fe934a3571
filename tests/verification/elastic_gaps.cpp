#include "deadpoint/drift/chain.hpp"
#include "deadpoint/fem/model.hpp"
#include "deadpoint/press/drift/chain_model.hpp"
#include "deadpoint/press/drift/gap_model.hpp"
#include "deadpoint/press/problem/heat.hpp"
#include "deadpoint/press/translate/lookup.hpp"
#include "deadpoint/press/translate/materials.hpp"
#include "near.hpp"
#include "solved_case.hpp"

#include <cmath>
#include <fmt/format.h>
#include <functional>
#include <map>

using namespace deadpoint;

namespace {

Observer silent;
constexpr double start = 293.15;

const std::string cases = std::string(DEADPOINT_VERIFICATION_CASES) + "/../../../cases/";

// A shipped press with its chain and gaps, ready for temperature fields.
struct Press {
    casefile::Case input;
    Machine machine;
    press::ChainModel chain;
    press::GapModel gaps;
    fem::Model model;
    std::vector<fem::Adjoint> adjoints;

    Press(const std::string& file, double size, int order, const std::vector<std::string>& overrides)
        : input(casefile::read_case(cases + file, overrides).value),
          machine(full::prepare_machine(input, size, silent)), chain(input, machine),
          gaps(press::describe_gaps(input, machine, chain)),
          model(machine, press::describe_materials(input, machine), order, silent)
    {
        model.support(press::surface_index(machine, input.chain->ground_surface));
        adjoints = model.adjoints(gaps.functionals);
    }

    // Values of all gap functionals by the names of corners and clearances.
    std::map<std::string, double> values(const fem::Field& field)
    {
        std::map<std::string, double> result;
        for (const auto& adjoint : adjoints)
            result[adjoint.name] = model.apply(adjoint, field, start);
        return result;
    }
};

// An expansion that does not show.
constexpr double little = 1e-15;
std::vector<std::string> expansions(const std::map<std::string, double>& stated)
{
    std::vector<std::string> overrides;
    for (const auto& [name, value] : stated)
        overrides.push_back(fmt::format("materials.{}.expansion={} 1/K", name, value));
    return overrides;
}

double displaced(const Machine& machine, const Functional& functional, const std::string& body,
                 const std::function<Vec3(const Vec3&)>& displacement)
{
    double sum = 0;
    for (const auto& point : functional.points)
        if (body.empty() || machine.parts[machine.faces[point.face].part].body == body)
            sum += dot(point.weight, displacement(point.position));
    return sum;
}

}  // namespace

TEST_CASE("corners and clearances do not feel how bodies stand")
{
    for (const char* file : {"starter/case.toml", "knuckle-joint/case.toml"}) {
        CAPTURE(file);
        const auto input = casefile::read_case(cases + file).value;
        const auto machine = full::prepare_machine(input, 2, silent);
        const press::ChainModel chain(input, machine);
        const auto gaps = press::describe_gaps(input, machine, chain);
        REQUIRE(gaps.corners.size() == (machine.half_model ? 2 : 4));
        for (int motion = 0; motion < 6; ++motion) {
            // Half models: only what keeps the plane x = 0.
            if (machine.half_model && (motion == 0 || motion == 4 || motion == 5))
                continue;
            CAPTURE(motion);
            Vec3 shift{}, turn{};
            (motion < 3 ? shift[motion] : turn[motion - 3]) = 1;
            const auto rigid = [&](const Vec3& x) { return shift + cross(turn, x); };
            for (const auto& functional : gaps.functionals) {
                CAPTURE(functional.name);
                // A shift by 1 m or a turn by 1 rad: joints close again, whichever body is moved, and all together keep
                // the gap. 1e-6: joint centres of the case files are rounded to 0.1 um, in levers of some 0.1 m.
                for (const auto& body : chain.linkage.bodies)
                    if (body != chain.linkage.bodies[chain.linkage.ground]) {
                        CAPTURE(body);
                        CHECK(std::abs(displaced(machine, functional, body, rigid)) < 1e-6);
                    }
                CHECK(std::abs(displaced(machine, functional, "", rigid)) < 1e-6);
            }
        }
    }
}

TEST_CASE("bodies of unlike expansion that warm evenly: clearances by d (alpha - alpha) dT, corners by E_SW")
{
    const double frame = 1.0e-5, steel = 1.4e-5, slide = 1.8e-5, rise = 10;
    auto overrides = expansions({{"cast_iron", frame}, {"bronze", frame}, {"steel", steel}});
    overrides.push_back("parts.slide.material=warm_iron");
    overrides.push_back("materials.warm_iron.library=GJL-250");
    overrides.push_back(fmt::format("materials.warm_iron.expansion={} 1/K", slide));
    Press press("starter/case.toml", 2, 1, overrides);
    const auto values = press.values(press.model.constant_field(start + rise));
    // A uniform expansion is a linear displacement, which elements, ties and fits reproduce up to the solver; facets of
    // the cylinders scale with them.
    const double exact = 1e-6;
    CHECK(values.at("clearance guide") == near(0.300 * (frame - slide) * rise, exact));
    CHECK(values.at("clearance wrist_pin") == near(0.060 * (steel - slide) * rise, exact));
    CHECK(values.at("clearance crank_bearing front") == near(0.080 * (frame - steel) * rise, exact));
    // the flywheel of cast iron on the same shaft strains it there
    CHECK(values.at("clearance crank_bearing back") == near(0.080 * (frame - steel) * rise, 0.01));
    CHECK(std::abs(values.at("clearance crank_pin")) < 1e-6 * 0.090 * steel * rise);
    // seat 1.05 m above the feet, crank throw and rod of steel, slide from pin to face, table 0.15 m above the feet;
    // the crank's play comes on top, metre for metre of what its bearings grow on the radius
    const double gap = rise * (frame * 1.05 - steel * 0.340 - slide * 0.360 - frame * 0.15);
    for (const char* corner : {"front left", "front right", "back left", "back right"})
        CHECK(values.at(std::string("gap ") + corner) == near(gap, 3e-4));  // the same
    CHECK(press.chain.travel_by_play == near(1, 1e-9));
    const auto growths = press.model.adjoints({press.chain.dimensions[drift::dimension_count]});
    CHECK(press.model.apply(growths[0], press.model.constant_field(start + rise), start) ==
          near(0.5 * 0.080 * (frame - steel) * rise, exact));
}

TEST_CASE("one expansion for all: clearances stay, the corners of the half press follow alpha dT L")
{
    Press press(
        "jl75g-60/case.toml", 5, 1,
        expansions({{"40Cr", 1.1e-5}, {"45", 1.1e-5}, {"HT200", 1.1e-5}, {"HT300", 1.1e-5}, {"QT600-3", 1.1e-5}}));
    const auto values = press.values(press.model.constant_field(start + 10));
    // Bores and shafts of one diameter: their clearance is 0 and stays 0; coordinates are rounded to 0.1 um.
    int clearances = 0;
    for (const auto& [name, value] : values)
        if (name.starts_with("clearance")) {
            CAPTURE(name);
            CHECK(std::abs(value) < 1e-10);
            ++clearances;
        }
    CHECK(clearances == 18);  // twelve pins, four bearings with their rings, guides 4 and 10; guide 12 has one face
    CHECK(values.at("gap front right") == near(1.1e-4 * 0.3, 1e-5));
    CHECK(values.at("gap back right") == near(1.1e-4 * 0.3, 1e-5));
}

TEST_CASE("a slide warmer at the back tilts about its pin by alpha g times the distance to its face")
{
    const double alpha = 1.2e-5, gradient = 50;
    auto overrides = expansions({{"cast_iron", little}, {"bronze", little}, {"steel", little}});
    overrides.push_back("parts.slide.material=warm_iron");
    overrides.push_back("materials.warm_iron.library=GJL-250");
    overrides.push_back(fmt::format("materials.warm_iron.expansion={} 1/K", alpha));
    overrides.push_back("chain.clearances=false");
    Press press("starter/case.toml", 2.5, 2, overrides);
    // T = g z expands a free body without stress: u_y = alpha g y z. The pin at y = -0.34 keeps its axis, so the face
    // at y = -0.7 tilts by alpha g (y_face - y_pin). Quadratic elements hold that displacement; 1e-4 for facets of the
    // pin.
    const auto along_z =
        press.values(press.model.interpolate_field([&](const Vec3& x) { return start + gradient * x[2]; }));
    for (const char* side : {"left", "right"}) {
        const double slope =
            (along_z.at(std::string("gap back ") + side) - along_z.at(std::string("gap front ") + side)) / 0.2;
        CHECK(slope == near(alpha * gradient * (-0.7 + 0.34), 1e-4));
    }
    // The operator stands at z < 0 (front = "-z") and has x > 0 on the left.
    // T = g x: the guide's faces, at x = +-0.15 with their middle at y = -0.575, keep their direction instead.
    const auto along_x =
        press.values(press.model.interpolate_field([&](const Vec3& x) { return start + gradient * x[0]; }));
    for (const char* side : {"front", "back"}) {
        const double slope =
            (along_x.at(std::string("gap ") + side + " left") - along_x.at(std::string("gap ") + side + " right")) /
            0.3;
        CHECK(slope == near(alpha * gradient * (-0.7 + 0.575), 1e-4));
    }
}

TEST_CASE("a frame warmer at the back hands its tilt down by crank and rod to the slide")
{
    const double alpha = 1.2e-5, gradient = 50;
    auto overrides = expansions({{"cast_iron", alpha}, {"bronze", alpha}, {"steel", little}});
    overrides.push_back("parts.slide.material=still");
    overrides.push_back("materials.still.library=GJL-250");
    overrides.push_back(fmt::format("materials.still.expansion={} 1/K", little));
    overrides.push_back("chain.clearances=false");
    Press press("starter/case.toml", 2.5, 2, overrides);
    const auto values =
        press.values(press.model.interpolate_field([&](const Vec3& x) { return start + gradient * x[2]; }));
    // u_y = alpha g (y - y_feet) z is free of stress and keeps the feet; seats at y = 0 and the table at y = -0.9
    // differ by alpha g 0.9 z. The flywheel and the crank's supports are rigid here, so the slide follows the seats'
    // axis.
    for (const char* side : {"left", "right"}) {
        const double slope =
            (values.at(std::string("gap back ") + side) - values.at(std::string("gap front ") + side)) / 0.2;
        CHECK(slope == near(alpha * gradient * 0.9, 1e-4));
    }
}
