#include "../turned_case.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/fem/model.hpp"
#include "deadpoint/full/frame/frame_state.hpp"
#include "deadpoint/mechanism/planar_motion.hpp"
#include "deadpoint/press/drift/chain_model.hpp"
#include "deadpoint/press/drift/gap_model.hpp"
#include "deadpoint/press/loads/loads.hpp"
#include "deadpoint/press/problem/heat.hpp"
#include "deadpoint/press/result/loads_result.hpp"
#include "deadpoint/press/translate/materials.hpp"
#include "near.hpp"
#include "solved_case.hpp"

#include <cmath>
#include <map>

// The starter press turned in the plane, with gravity and all: stroke, forces and gap are those of the upright one.

using namespace deadpoint;

namespace {

Observer silent;

struct Figures {
    double stroke = 0, guide = 0, bearing = 0, support = 0;
    std::map<std::string, double> lengths;  ///< dimensions, corners and clearances [m]
};

// Figures of a press whose temperature falls with the distance from the crank, warmer in front and on one side.
Figures figures_of(const casefile::Case& input, const Machine& machine, double angle)
{
    const auto temperature = [&](const Vec3& place) {
        const Vec3 x = rotated(place, -angle);
        return 293.15 + 20 * std::exp(-std::abs(x[1] + 0.1) / 0.4) + 6 * x[0] - 5 * x[2];
    };
    const auto loads = press::compute_loads(input, &machine, 0);
    Figures figures{loads.stroke.stroke, loads.guides[0].mean_normal, 0, 0, {}};
    for (std::size_t j = 0; j < loads.linkage.joints.size(); ++j)
        if (loads.linkage.joints[j].name == "crank_bearing")
            for (const auto& force : loads.history.joints[j].force)
                figures.bearing = std::max(figures.bearing, norm(force));
    const press::ChainModel chain(input, machine);
    const auto gaps = press::describe_gaps(input, machine, chain);
    fem::Model model(machine, press::describe_materials(input, machine), 1, silent);
    model.support(full::describe_foundation(input, machine));
    auto wanted = chain.dimensions;
    wanted.insert(wanted.end(), gaps.functionals.begin(), gaps.functionals.end());
    for (std::size_t bearing = drift::dimension_count; bearing < chain.dimensions.size(); ++bearing)
        wanted[bearing].name += " " + std::to_string(bearing);
    wanted.push_back(press::gap_functional(chain, std::vector<double>(static_cast<std::size_t>(chain.bearings()), 1)));
    const auto values = model.evaluate(wanted, model.displacement(model.interpolate_field(temperature), 293.15));
    for (std::size_t i = 0; i < wanted.size(); ++i)
        figures.lengths[wanted[i].name] = values[i];
    return figures;
}

void check_turned(casefile::Foundation::Kind foundation, double degrees)
{
    CAPTURE(degrees);
    const double angle = degrees * std::numbers::pi / 180;
    auto input =
        casefile::read_case(std::string(DEADPOINT_VERIFICATION_CASES) + "/../../../cases/starter/case.toml").value;
    input.mechanism.positions = 72;
    input.foundation.emplace().kind = foundation;
    const auto machine = full::prepare_machine(input, 2.5, silent);
    const auto upright = figures_of(input, machine, 0);
    const auto found = figures_of(turned(input, angle), turned(machine, angle), angle);
    const double exact = 1e-7;
    CHECK(found.stroke == near(upright.stroke, exact));
    CHECK(found.guide == near(upright.guide, exact));
    CHECK(found.bearing == near(upright.bearing, exact));
    REQUIRE(found.lengths.size() == upright.lengths.size());
    for (const auto& [name, length] : upright.lengths) {
        CAPTURE(name);
        CHECK(std::abs(found.lengths.at(name) - length) < exact * std::abs(upright.lengths.at("E_SW")));
    }
}

}  // namespace

TEST_CASE("a press that lies has stroke, forces, gap, corners and clearances of the upright one")
{
    check_turned(casefile::Foundation::Kind::free, 90);
    check_turned(casefile::Foundation::Kind::clamped, 30);
}

TEST_CASE("feet that look along no axis must be clamped")
{
    auto input =
        casefile::read_case(std::string(DEADPOINT_VERIFICATION_CASES) + "/../../../cases/starter/case.toml").value;
    const auto machine = turned(full::prepare_machine(input, 4, silent), 0.5);
    fem::Model model(machine, press::describe_materials(input, machine), 1, silent);
    model.support(full::describe_foundation(input, machine));
    CHECK_THROWS_WITH_AS((void)model.displacement(model.constant_field(300), 293.15),
                         doctest::Contains("kind = \"clamped\""), InputError);
}
