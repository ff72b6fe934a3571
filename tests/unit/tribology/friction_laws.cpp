#include "deadpoint/error.hpp"
#include "deadpoint/exchange/laws/friction.hpp"
#include "deadpoint/tribology/friction/ball_bearing.hpp"
#include "deadpoint/tribology/friction/calibrated.hpp"
#include "deadpoint/tribology/friction/duty.hpp"
#include "deadpoint/tribology/friction/guide.hpp"
#include "deadpoint/tribology/friction/heat_law.hpp"
#include "deadpoint/tribology/friction/pin.hpp"
#include "deadpoint/tribology/friction/rolling_bearing.hpp"
#include "deadpoint/tribology/friction/skf.hpp"
#include "near.hpp"

#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>
#include <functional>
#include <numbers>
#include <string>
#include <tuple>
#include <vector>

// What must hold for every friction law, and the single laws' own rules.

using namespace deadpoint;
using namespace deadpoint::tribology;

namespace {

constexpr double pi = std::numbers::pi;
constexpr double rpm = 2 * pi / 60;
constexpr double degree = pi / 180;
constexpr double branch_step = 160 / 158.74010519682 - 1;  // of Palmgren's viscous torque at nu n = 2000

/// A joint that swings: force and speed vary over the turn, the times are uneven.
Duty swing(double force, double speed)
{
    Duty duty;
    std::vector<double> time;
    constexpr int count = 180;
    for (int i = 0; i < count; ++i) {
        const double u = static_cast<double>(i) / count;
        time.push_back(0.3 * (u + 0.1 * std::sin(2 * pi * u) / (2 * pi)));
        duty.force.push_back(force * (1.2 + std::cos(2 * pi * u)));
        duty.speed.push_back(std::abs(speed * std::sin(2 * pi * u + 0.3)));
    }
    duty.weight = turn_weights(time, 0.3);
    return duty;
}

PalmgrenBearing crank_bearing(BearingType type)
{
    return palmgren_bearing(type, OilSupply::bath, 25 * degree, 0.215, 220e3);
}

BallBearing crank_balls()
{
    BallBearing bearing;
    bearing.balls = 20;
    bearing.rows = 2;
    bearing.ball_diameter = 0.024;
    bearing.pitch_diameter = 0.215;
    bearing.contact_angle = 25 * degree;
    return bearing;
}

struct Law {
    std::string name;
    std::function<HeatLaw(const Duty&)> heat;
    double speed_exponent_low;   ///< of the load part
    double speed_exponent_high;  ///< of the viscous part
    bool falls;                  ///< with temperature
    double step = 0;             ///< largest relative step upwards
};

std::vector<Law> laws()
{
    const Lubricant oil = iso_vg_oil(68);
    const auto palmgren = [oil](BearingType type) {
        return [type, oil](const Duty& duty) { return palmgren_heat(crank_bearing(type), duty, 1e3, oil.viscosity); };
    };
    const Pin pin{0.07, 0.14, 40e-6, 0.01};
    const Guide guide{0.05, 0.2, 30e-6};
    const auto calibrated = [oil](FrictionKind kind) {
        return [kind, oil](const Duty& duty) {
            const CalibratedFriction law{kind, 100, 8, kind == FrictionKind::rolling ? 2.0 / 3 : 1, 200 * rpm, 1};
            const double crank_speed = 200 * rpm * std::ranges::max(duty.speed) / 20;
            const DutyRatio ratio = duty_ratio(kind, duty, swing(9e3, 20));
            return calibrated_heat(law, oil.viscosity, crank_speed, ratio);
        };
    };
    constexpr double drag = rolling_drag_exponent;
    std::vector<Law> all{
        {"pin", [=](const Duty& duty) { return pin_heat(pin, duty, oil); }, 1, 2, true},
        {"dry pin", [=](const Duty& duty) { return pin_heat(pin, duty); }, 1, 1, true},
        {"guide", [=](const Duty& duty) { return guide_heat(guide, duty, oil); }, 1, 2, true},
        {"dry guide", [=](const Duty& duty) { return guide_heat(guide, duty); }, 1, 1, true},
        {"calibrated rolling", calibrated(FrictionKind::rolling), 1, drag, true, branch_step},
        {"calibrated pin", calibrated(FrictionKind::pin), 1, 2, true},
        {"calibrated guide", calibrated(FrictionKind::guide), 1, 2, true},
        {"SKF balls",
         [=](const Duty& duty) { return skf_heat(skf_angular_contact(0.17, 0.26), duty, 1e3, oil.viscosity); }, 0, 3,
         false},
        {"SKF rollers",
         [=](const Duty& duty) { return skf_heat(skf_cylindrical_roller(0.17, 0.26), duty, 1e3, oil.viscosity); }, 0, 3,
         false},
    };
    for (const auto type : {BearingType::deep_groove_ball, BearingType::angular_contact_ball,
                            BearingType::angular_contact_ball_pair, BearingType::cylindrical_roller,
                            BearingType::needle_roller, BearingType::tapered_roller, BearingType::spherical_roller})
        all.push_back(
            {"Palmgren " + std::to_string(static_cast<int>(type)), palmgren(type), 1, drag, true, branch_step});
    all.push_back({"angular contact pair with spin",
                   [=](const Duty& duty) {
                       return summed_heat({palmgren(BearingType::angular_contact_ball_pair)(duty),
                                           constant_heat(spin_heat(crank_balls(), 0.06, {}, duty))});
                   },
                   1, drag, true, branch_step});
    return all;
}

/// A law split in the part of the load and that of the oil, and the powers that its documentation states.
struct Powers {
    std::string name;
    std::function<HeatLaw(const Duty&, const Lubricant&)> heat;
    double load;       ///< of the load in the load part
    double speed;      ///< of the speed in the viscous part
    double viscosity;  ///< of the viscosity in the viscous part
};

std::vector<Powers> powers()
{
    const Pin pin{0.07, 0.14, 40e-6, 0.01};
    const Guide guide{0.05, 0.2, 30e-6};
    std::vector<Powers> all{
        {"pin", [=](const Duty& duty, const Lubricant& oil) { return pin_heat(pin, duty, oil); }, 1, 2, 1},
        {"guide", [=](const Duty& duty, const Lubricant& oil) { return guide_heat(guide, duty, oil); }, 1, 2, 1},
        {"spin",
         [](const Duty& duty, const Lubricant&) { return constant_heat(spin_heat(crank_balls(), 0.06, {}, duty)); },
         4.0 / 3, 0, 0},
    };
    const auto add = [&](const char* name, BearingType type, double load) {
        all.push_back({name,
                       [type](const Duty& duty, const Lubricant& oil) {
                           return palmgren_heat(crank_bearing(type), duty, 0, oil.viscosity);
                       },
                       load, rolling_drag_exponent, 2.0 / 3});
    };
    add("deep groove balls", BearingType::deep_groove_ball, 1.55);
    add("angular contact balls", BearingType::angular_contact_ball, 1.33);
    add("pair of angular contact balls", BearingType::angular_contact_ball_pair, 1.33);
    add("cylindrical rollers", BearingType::cylindrical_roller, 1);
    add("needles", BearingType::needle_roller, 1);
    add("tapered rollers", BearingType::tapered_roller, 1);
    add("spherical rollers", BearingType::spherical_roller, 1);
    for (const auto& [name, kind, load, speed, p] :
         {std::tuple{"calibrated rolling", FrictionKind::rolling, 1.33, rolling_drag_exponent, 2.0 / 3},
          std::tuple{"calibrated pin", FrictionKind::pin, 1.0, 2.0, 1.0},
          std::tuple{"calibrated guide", FrictionKind::guide, 1.0, 2.0, 1.0}})
        all.push_back({name,
                       [kind = kind, p = p](const Duty& duty, const Lubricant& oil) {
                           const CalibratedFriction law{kind, 100, 8, p, 200 * rpm, 1};
                           return calibrated_heat(law, oil.viscosity, 200 * rpm * std::ranges::max(duty.speed) / 20,
                                                  duty_ratio(kind, duty, steady_duty(9e3, 20)));
                       },
                       load, speed, p});
    return all;
}

}  // namespace

TEST_CASE("friction laws: heat is positive, falls with temperature where it must, and without steps but the stated one")
{
    for (const Law& law : laws()) {
        CAPTURE(law.name);
        for (const Duty& duty : {steady_duty(9e3, 20), swing(9e3, 20), steady_duty(9e3, 100)}) {
            const HeatLaw heat = law.heat(duty);
            double before = heat(260).value;
            for (double temperature = 260.1; temperature < 420; temperature += 0.1) {
                const LawValue now = heat(temperature);
                CHECK_FALSE(now.value < 0);
                CHECK(std::isfinite(now.value));
                if (law.falls)
                    CHECK(now.slope <= 0);
                // No jump up beyond the stated step, none down beyond what the slope explains.
                if (law.falls)
                    CHECK(now.value <= before * (1 + law.step + 1e-12));
                CHECK(std::abs(now.value - before) <=
                      before * (law.step + 1e-12) +
                          0.12 * std::max(std::abs(now.slope), std::abs(heat(temperature - 0.1).slope)));
                before = now.value;
            }
        }
    }
}

TEST_CASE("friction laws: the derivative is that of the heat")
{
    constexpr double h = 1e-3;
    for (const Law& law : laws()) {
        CAPTURE(law.name);
        const HeatLaw heat = law.heat(steady_duty(9e3, 30));
        for (const double temperature : {270.0, 293.0, 311.0, 333.0}) {
            const double slope = (heat(temperature + h).value - heat(temperature - h).value) / (2 * h);
            // Differences of values of some 1000 W carry rounding of 1e-10 W/K and a third derivative of 1e-6.
            CHECK(std::abs(heat(temperature).slope - slope) < 1e-6 * std::abs(slope) + 1e-7);
        }
    }
}

TEST_CASE("friction laws: heat grows with speed between the powers of its parts, with load, and ends at rest")
{
    for (const Law& law : laws()) {
        CAPTURE(law.name);
        for (const double temperature : {290.0, 320.0, 350.0}) {
            const double heat = law.heat(swing(9e3, 20))(temperature).value;
            const double faster = law.heat(swing(9e3, 40))(temperature).value;
            CHECK(faster > heat);
            CHECK(faster >= heat * std::pow(2, law.speed_exponent_low) * (1 - branch_step));
            CHECK(faster <= heat * std::pow(2, law.speed_exponent_high) * (1 + branch_step));
            CHECK(law.heat(swing(18e3, 20))(temperature).value > heat);
            CHECK(law.heat(steady_duty(9e3, 0))(temperature).value == 0.0);
        }
    }
}

TEST_CASE("friction laws: the parts of load and oil scale with load, speed and viscosity by the stated powers")
{
    constexpr double thin = 60e-6;  // at 20 rad/s well above nu n = 2000 mm2/s rpm
    const auto oil = [](double viscosity) {
        return Lubricant{[viscosity](double) {
                             return LawValue{viscosity, 0, true};
                         },
                         [](double) {
                             return LawValue{870, 0, true};
                         }};
    };
    for (const Powers& law : powers()) {
        CAPTURE(law.name);
        const auto heat = [&](double force, double speed, double viscosity) {
            return law.heat(steady_duty(force, speed), oil(viscosity))(300).value;
        };
        const double viscous = heat(0, 20, thin);
        const double load = heat(9e3, 20, thin) - viscous;
        CHECK(load > 0);
        CHECK((heat(18e3, 20, thin) - viscous) / load == near(std::pow(2, law.load), 1e-9));
        CHECK((heat(9e3, 40, thin) - heat(0, 40, thin)) / load == near(2, 1e-9));
        CHECK(heat(9e3, 40, thin) - heat(9e3, 20, thin) - load == near(viscous * (std::pow(2, law.speed) - 1), 1e-9));
        CHECK(heat(0, 20, 2 * thin) == near(viscous * std::pow(2, law.viscosity), 1e-12));
    }
}

TEST_CASE("friction laws: a steady duty cut into uneven pieces is the same duty")
{
    Duty pieces;
    pieces.weight = {0.1, 0.5, 0.15, 0.25};
    pieces.force.assign(4, 9e3);
    pieces.speed.assign(4, 20);
    for (const Law& law : laws()) {
        CAPTURE(law.name);
        CHECK(law.heat(pieces)(310).value == near(law.heat(steady_duty(9e3, 20))(310).value, 1e-13));
    }
}

TEST_CASE("friction laws: the peak measure is never below the mean")
{
    for (const Law& law : laws()) {
        CAPTURE(law.name);
        const Duty duty = swing(9e3, 20);
        CHECK(law.heat(measured(duty, LoadMeasure::peak))(310).value > law.heat(duty)(310).value);
    }
}

TEST_CASE("Palmgren: the torque steps up by 0.8 % at nu n = 2000, and is flat below")
{
    const double just_above = palmgren_viscous_torque(6.5, 0.215, 10.0001e-6, 200 * rpm).torque;
    const ViscousTorque just_below = palmgren_viscous_torque(6.5, 0.215, 9.9999e-6, 200 * rpm);
    CHECK(just_below.torque / just_above - 1 == near(branch_step, 2e-3));
    CHECK(just_below.low_branch);
    CHECK(just_below.slope == 0.0);
    CHECK(just_below.torque == near(palmgren_viscous_torque(6.5, 0.215, 1e-6, 0).torque, 1e-15));
    CHECK_THROWS_AS(palmgren_viscous_torque(6.5, 0.215, 0, 1), DomainError);
}

TEST_CASE("Palmgren: a swinging bearing is on both branches, each instant on its own")
{
    const Duty duty = swing(9e3, 20);
    const PalmgrenBearing bearing = crank_bearing(BearingType::angular_contact_ball_pair);
    constexpr double nu = 30e-6;
    const HeatLaw heat = palmgren_heat(bearing, duty, 0, [](double) { return LawValue{nu, -1e-6, true}; });
    double expected = 0;
    double slope = 0;
    double on_low_branch = 0;
    for (std::size_t i = 0; i < duty.weight.size(); ++i) {
        const ViscousTorque drag = palmgren_viscous_torque(bearing.lubrication_factor, 0.215, nu, duty.speed[i]);
        on_low_branch += drag.low_branch ? duty.weight[i] : 0;
        const double load = palmgren_load_torque(bearing, equivalent_loads(bearing, duty.force[i], 0));
        expected += duty.weight[i] * duty.speed[i] * (drag.torque + load);
        slope += duty.weight[i] * duty.speed[i] * drag.slope * -1e-6;
    }
    CHECK(heat(300).value == near(expected, 1e-12));
    CHECK(heat(300).slope == near(slope, 1e-12));
    // 200 rpm sin: below 2000/30 = 66.7 rpm for the share 2/pi asin(66.7/191) of the time; weights and sampling: 2 %.
    const double share = 2 / pi * std::asin(2000.0 / 30 * rpm / 20);
    CHECK(on_low_branch == near(share, 0.05));
}

TEST_CASE("Palmgren: load part goes as F^1.33 under pure radial load, over the turn and at the peak")
{
    const PalmgrenBearing bearing = crank_bearing(BearingType::angular_contact_ball_pair);
    const auto load_part = [&](const Duty& duty) {
        PalmgrenBearing dry = bearing;
        dry.lubrication_factor = 0;
        return palmgren_heat(dry, duty, 0, iso_vg_oil(32).viscosity)(300).value;
    };
    const Duty duty = swing(9e3, 20);
    const double expected = 0.001 * 0.215 * std::pow(220e3, -0.33) * duty_mean(duty, 1.33, 1);
    CHECK(load_part(duty) == near(expected, 1e-12));
    CHECK(load_part(swing(18e3, 20)) == near(std::pow(2, 1.33) * expected, 1e-12));
}

TEST_CASE("static factors: ISO 76 between its angles, the pair doubled, and the table of Zheng et al.")
{
    using enum BearingType;
    CHECK(static_factors(angular_contact_ball, 15 * degree).axial == near(0.46, 1e-5));
    CHECK(static_factors(angular_contact_ball, 15 * degree, StaticTable::zheng_2018).axial == near(0.47, 1e-5));
    CHECK(static_factors(angular_contact_ball, 22.5 * degree).axial == near(0.40, 1e-5));
    CHECK(static_factors(angular_contact_ball, 42.5 * degree).axial == near(0.24, 1e-5));
    CHECK(static_factors(angular_contact_ball_pair, 25 * degree).axial == near(0.76, 1e-5));
    CHECK(static_factors(angular_contact_ball_pair, 25 * degree).radial == 1.0);
    CHECK(static_factors(angular_contact_ball, 40 * degree, StaticTable::zheng_2018).axial == near(0.26, 1e-5));
    CHECK_THROWS_AS(static_factors(angular_contact_ball, 50 * degree), InputError);
    CHECK_THROWS_AS(static_factors(angular_contact_ball, 12 * degree, StaticTable::zheng_2018), InputError);
    CHECK_THROWS_AS(static_factors(tapered_roller, 0), InputError);
}

TEST_CASE("lubrication factors: mist halves and jet doubles the oil bath's")
{
    CHECK(lubrication_factor(BearingType::angular_contact_ball_pair, OilSupply::bath) == 6.5);
    CHECK(lubrication_factor(BearingType::angular_contact_ball_pair, OilSupply::jet) == 13.0);
    CHECK(lubrication_factor(BearingType::deep_groove_ball, OilSupply::mist) == 1.0);
}

TEST_CASE("SKF: heat rises with temperature in mixed lubrication, where Palmgren's falls")
{
    const ViscosityLaw oil = iso_vg_oil(32).viscosity;
    const HeatLaw heat = skf_heat(skf_angular_contact(0.17, 0.26), steady_duty(18e3, 200 * rpm), 0, oil);
    CHECK(heat(273.15 + 70).slope > 0);
    CHECK(heat(273.15 + 70).value > heat(273.15 + 20).value);
    CHECK_THROWS_AS(skf_angular_contact(0.26, 0.17), InputError);
    CHECK_THROWS_AS(skf_heat(skf_angular_contact(0.17, 0.26), steady_duty(1, 1), 0, {}), InputError);
}

TEST_CASE("pins: link that only swings makes far less film heat than one at crank speed")
{
    // Swing by w sin: mean(w^2) = w^2/2, against crank speed throughout.
    const Pin pin{0.07, 0.14, 40e-6, 0.002};
    Duty small = swing(80e3, 1);
    CHECK(pin_film_heat(pin, small, 0.03) / pin_film_heat(pin, steady_duty(80e3, 21), 0.03) ==
          near(duty_mean(small, 0, 2) / 441, 1e-13));
    CHECK_THROWS_AS(pin_film_heat({0.07, 0.14, 0, 0.002}, small, 0.03), InputError);
    CHECK_THROWS_AS(pin_load_heat({0.07, 0.14, 4e-5, -0.1}, small), InputError);
    CHECK_THROWS_AS(pin_film_heat(pin, small, 0), DomainError);
}

TEST_CASE("guides: friction follows the faces' force at every instant, the film shears with the square of speed")
{
    const Duty duty = swing(2e3, 0.5);
    CHECK(guide_load_heat({0.05, 0, 0}, duty) == near(0.05 * duty_mean(duty, 1, 1), 1e-13));
    CHECK(guide_load_heat({0.05, 0, 0}, swing(0, 0.5)) == 0.0);  // no side force by symmetry: no heat
    CHECK(guide_film_heat({0.05, 0.2, 20e-6}, duty, 0.03) == near(0.03 * 0.2 * duty_mean(duty, 0, 2) / 20e-6, 1e-13));
    CHECK_THROWS_AS(guide_film_heat({0.05, 0, 20e-6}, duty, 0.03), InputError);
    CHECK_THROWS_AS(guide_load_heat({-0.05, 0, 0}, duty), InputError);
}

TEST_CASE("sums: bearings on one seat add up, and one out of range flags all")
{
    const HeatLaw flagged = [](double) { return LawValue{2, -1, false}; };
    const LawValue sum = summed_heat({constant_heat(3), flagged})(300);
    CHECK(sum.value == 5.0);
    CHECK(sum.slope == -1.0);
    CHECK_FALSE(sum.in_range);
    CHECK(summed_heat({})(300).value == 0.0);
    CHECK_THROWS_AS(summed_heat({HeatLaw{}}), InputError);
    CHECK_THROWS_AS(constant_heat(-1), InputError);
}
