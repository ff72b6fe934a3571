/// Requirement: a ball joint moves as a pin does, and rubs and conducts on its spherical seat.
#include "deadpoint/casefile/files/read.hpp"
#include "deadpoint/exchange/cycle.hpp"
#include "deadpoint/exchange/heat.hpp"
#include "deadpoint/exchange/linkage.hpp"
#include "deadpoint/exchange/machine.hpp"
#include "deadpoint/full/model/prepare.hpp"
#include "deadpoint/observer.hpp"
#include "deadpoint/press/drift/chain_model.hpp"
#include "deadpoint/press/laws/conductance.hpp"
#include "deadpoint/press/laws/friction.hpp"
#include "deadpoint/press/loads/loads.hpp"
#include "deadpoint/press/problem/heat.hpp"
#include "deadpoint/press/result/friction_summary.hpp"
#include "deadpoint/press/result/loads_result.hpp"
#include "near.hpp"

#include <algorithm>
#include <doctest/doctest.h>
#include <numbers>

using namespace deadpoint;

namespace {

constexpr double pi = std::numbers::pi;

/// A press whose wrist rubs by a law of its own.
casefile::Case made_press(const std::vector<std::string>& overrides = {})
{
    auto input = casefile::read_case(DEADPOINT_SOURCE_DIR "/cases/starter-by-laws/case.toml", overrides).value;
    casefile::PinFriction coulomb;
    coulomb.coefficient = 0.05;
    input.friction["wrist"] = input.friction.at("pins");
    input.friction["wrist"].law = coulomb;
    input.joints.at("wrist_pin").friction = "wrist";
    return input;
}

casefile::Case with_ball()
{
    auto input = made_press();
    auto& joint = input.joints.at("wrist_pin");
    joint.kind = casefile::Joint::Kind::ball;
    joint.ball = casefile::BallSeat{0.08, 0, pi / 2};
    joint.elements.clear();
    joint.interfaces[0].conductance = casefile::WholeConductance{5000};
    joint.interfaces[0].oil = 200;
    return input;
}

const Machine& machine()
{
    static const Machine built = [] {
        Observer quiet;
        return full::prepare_machine(made_press(), 3, quiet);
    }();
    return built;
}

std::size_t wrist()
{
    const auto& all = machine().interfaces;
    return static_cast<std::size_t>(std::ranges::find(all, "wrist_pin.pin", &Contact::name) - all.begin());
}

}  // namespace

TEST_CASE("a press with a ball for a pin moves and is loaded alike")
{
    const auto pin = press::compute_loads(made_press(), &machine(), 0),
               ball = press::compute_loads(with_ball(), &machine(), 0);
    REQUIRE(pin.history.joints.size() == ball.history.joints.size());
    for (std::size_t j = 0; j < pin.history.joints.size(); ++j)
        for (std::size_t i = 0; i < pin.history.time.size(); i += 60)
            CHECK(norm(pin.history.joints[j].force[i] - ball.history.joints[j].force[i]) == 0);
}

TEST_CASE("a half ball rubs like a pin of 4 / pi of its diameter")
{
    auto pin = made_press();
    std::get<casefile::PinFriction>(pin.friction.at("wrist").law).diameter = 0.08 * 4 / pi;
    press::FrictionLaws of_pin(pin, &machine(), nullptr);
    const auto ball = with_ball();
    press::FrictionLaws of_ball(ball, &machine(), nullptr);
    const double heat = of_pin.heat("wrist", pin.operation.front()).heat(300).value;
    CHECK(heat > 1);
    CHECK(of_ball.heat("wrist", ball.operation.front()).heat(300).value == near(heat, 1e-12));
}

TEST_CASE("a half ball conducts over 2 pi R^2, and is pressed on it")
{
    auto input = with_ball();
    const auto loads = press::compute_loads(input, &machine(), 0);
    const double seat = 2 * pi * 0.04 * 0.04, drawn = machine().interfaces[wrist()].area;
    const auto known = press::interface_conductances(input, machine(), &loads, loads.speed)[wrist()];
    CHECK(1 / known.resistance() * drawn == near(5000 * seat, 1e-12));
    Observer quiet;
    const auto problem = press::describe_heat(input, machine(), quiet, &loads);
    CHECK(problem.interfaces[wrist()].oil * drawn == near(200 * seat, 1e-12));
    casefile::RoughContact rough;
    rough.surfaces.hardness = 2e9;
    rough.surfaces.fluid_conductivity = 0.14;
    rough.roughness = 1e-6;
    input.joints.at("wrist_pin").interfaces[0].conductance = rough;
    const auto on_ball = press::interface_conductances(input, machine(), &loads, loads.speed)[wrist()];
    input.joints.at("wrist_pin").kind = casefile::Joint::Kind::revolute;
    input.joints.at("wrist_pin").ball.reset();
    const auto on_pin = press::interface_conductances(input, machine(), &loads, loads.speed)[wrist()];
    CHECK(*on_ball.pressure * seat == near(*on_pin.pressure * drawn, 1e-12));  // one force
}

TEST_CASE("a ball passes no tilt on")
{
    const press::ChainModel pins(made_press(), machine()), ball(with_ball(), machine());
    for (std::size_t j = 0; j < pins.linkage.joints.size(); ++j) {
        CHECK(pins.description.joints[j].passes_tilt);
        CHECK(ball.description.joints[j].passes_tilt == (ball.linkage.joints[j].name != "wrist_pin"));
        CHECK(ball.linkage.joints[j].kind == pins.linkage.joints[j].kind);
    }
}
