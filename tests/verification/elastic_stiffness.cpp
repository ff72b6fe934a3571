/// Requirement: the static opening of a press under its process force follows from the stiffness of its parts.
#include "deadpoint/drift/chain.hpp"
#include "deadpoint/exchange/machine.hpp"
#include "deadpoint/fem/model.hpp"
#include "deadpoint/full/frame/press_compliance.hpp"
#include "deadpoint/press/drift/chain_model.hpp"
#include "deadpoint/press/drift/gap_model.hpp"
#include "deadpoint/press/translate/lookup.hpp"
#include "deadpoint/press/translate/materials.hpp"
#include "near.hpp"
#include "solved_case.hpp"

#include <cmath>

using namespace deadpoint;

namespace {

Observer silent;

casefile::Case starter()
{
    return casefile::read_case(DEADPOINT_VERIFICATION_CASES "/../../../cases/starter/case.toml").value;
}

press::PressCompliance compliance_of(const casefile::Case& input)
{
    const auto machine = full::prepare_machine(input, 2, silent);
    const press::ChainModel chain(input, machine);
    const auto gaps = press::describe_gaps(input, machine, chain);
    fem::Model model(machine, press::describe_materials(input, machine), 1, silent);
    model.support(press::surface_index(machine, input.chain->ground_surface));
    return full::press_compliance(model, chain, gaps, machine.half_model);
}

const press::PressCompliance& of_starter()
{
    static const auto result = compliance_of(starter());
    return result;
}

}  // namespace

TEST_CASE("a symmetric press opens without a tilt to the left or right, and its corners by as much in the mean")
{
    const auto& press = of_starter();
    CHECK(press.opening > 0);
    REQUIRE(press.corners.size() == 4);
    // Mirror images in x; the meshes of the links are not, by a thousandth of the opening over the slide's 0.3 m.
    CHECK(std::abs(press.left_right) * 0.3 < 2e-3 * press.opening);
    CHECK(press.corners[0].opening == near(press.corners[1].opening, 2e-3));
    // The press is softer than the shank of its rod alone: 60 x 90 mm2, 170 mm between its eyes.
    CHECK(press.stiffness() < 210e9 * 0.06 * 0.09 / 0.17);
    CHECK(press.stiffness() > 1e7);
}

TEST_CASE("the opening is the sum of those of the materials, each inverse to its modulus")
{
    const auto& whole = of_starter();
    auto input = starter();
    for (auto& [name, material] : input.materials)
        material.youngs_modulus *= 2;
    const auto stiffer = compliance_of(input);
    CHECK(stiffer.opening == near(whole.opening / 2, 1e-7));
    CHECK(stiffer.front_back == near(whole.front_back / 2, 1e-5));
    // Bodies are in series: 1 / c is what remains when all others are stiff. Moduli differ by body here.
    double sum = 0;
    for (const auto& [body, ignored] : starter().bodies) {
        auto one = starter();
        for (auto& [name, part] : one.parts) {
            if (part.body == body)
                continue;
            auto hard = one.materials.at(part.material);
            hard.youngs_modulus *= 1e6;
            one.materials["hard_" + part.material] = hard;
            part.material = "hard_" + part.material;
        }
        sum += compliance_of(one).opening;
    }
    CHECK(sum == near(whole.opening, 1e-5));  // what is hard still gives way by 1e-6
}

TEST_CASE("half a press opens as the whole one")
{
    auto input = starter();
    input.machine.half_model = true;
    auto& guide = input.joints.at("guide");
    std::erase_if(guide.interfaces, [](const auto& interface) { return interface.name == "right"; });
    for (const auto* surface : {"gib_right_face", "slide_right"})
        input.surfaces.erase(surface);
    const auto half = compliance_of(input);
    // Another mesh: cells at the cut are shared out anew.
    CHECK(half.opening == near(of_starter().opening, 0.03));
    CHECK(half.left_right == 0);
    CHECK(half.corners.size() == 4);
}
