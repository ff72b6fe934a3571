#include "deadpoint/tribology/friction/ball_bearing.hpp"
#include "deadpoint/tribology/friction/calibrated.hpp"
#include "deadpoint/tribology/friction/duty.hpp"
#include "deadpoint/tribology/friction/heat_law.hpp"
#include "deadpoint/tribology/friction/pin.hpp"
#include "deadpoint/tribology/friction/rolling_bearing.hpp"
#include "deadpoint/tribology/friction/skf.hpp"

#include <cmath>
#include <doctest/doctest.h>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>

// Every friction figure of an independent program. The reference is written with ten digits, so that 1e-9 is one unit
// or so in the last of them.

using namespace deadpoint;
using namespace deadpoint::tribology;
using nlohmann::json;

namespace {

constexpr double zero_celsius = 273.15;
constexpr double rpm = 2 * std::numbers::pi / 60;
constexpr double degree = std::numbers::pi / 180;
constexpr double exact = 1e-9;

const json& oracle()
{
    static const json data = [] {
        std::ifstream file(std::string(DEADPOINT_TEST_DATA) + "/heat_oracle_friction.json");
        return json::parse(file);
    }();
    return data;
}

double number(const json& entry, const char* key) { return entry.at(key).get<double>(); }

bool close(double value, double expected, double tolerance = exact)
{
    return std::abs(value - expected) <= tolerance * std::abs(expected);
}

ViscosityCurve table_oil()
{
    auto temperature = oracle()["viscosity"]["knots_C"].get<std::vector<double>>();
    for (double& value : temperature)
        value += zero_celsius;
    return {temperature, oracle()["viscosity"]["knots_m2s"].get<std::vector<double>>()};
}

ViscosityLaw walther_of(const char* name)
{
    const json& line = oracle()["viscosity"][name];
    return walther_viscosity({number(line, "A"), number(line, "B"), {}});
}

PalmgrenBearing angular_contact(const json& entry, bool pair, double angle)
{
    const auto type = pair ? BearingType::angular_contact_ball_pair : BearingType::angular_contact_ball;
    return palmgren_bearing(type, OilSupply::bath, angle, entry.value("dm", 0.2), entry.value("C0", 1e5),
                            StaticTable::zheng_2018);
}

}  // namespace

TEST_CASE("oracle: viscosity by table and by the Walther lines")
{
    const ViscosityCurve table = table_oil();
    const ViscosityLaw all = walther_of("walther_all");
    const Walther line = walther_through({zero_celsius + 40, 32e-6}, {zero_celsius + 100, 5.4e-6});
    const json& given = oracle()["viscosity"]["walther_vg32"];
    CHECK(close(line.a, number(given, "A"), 1e-13));
    CHECK(close(line.b, number(given, "B"), 1e-13));
    const ViscosityLaw vg32 = walther_viscosity(line);
    for (const json& entry : oracle()["viscosity"]["cases"]) {
        const double temperature = zero_celsius + number(entry, "T");
        CHECK(close(table(temperature).value, number(entry, "table")));
        CHECK(close(vg32(temperature).value, number(entry, "vg32")));
        // The reference kept more digits of a and b than it prints; they stand in a double exponential.
        CHECK(close(all(temperature).value, number(entry, "walther_all"), 2e-6));
    }
}

TEST_CASE("oracle: viscous torque of rolling bearings on both branches")
{
    for (const char* set : {"palmgren_M0", "palmgren_branch"})
        for (const json& entry : oracle()[set]) {
            const double n = number(entry, "n_rpm");
            const ViscousTorque drag =
                palmgren_viscous_torque(number(entry, "f0"), number(entry, "dm"), number(entry, "nu"), n * rpm);
            CHECK(close(drag.torque, number(entry, "M0")));
            CHECK(drag.low_branch == (n * number(entry, "nu") * 1e6 < 2000));
        }
}

TEST_CASE("oracle: equivalent loads and load torque")
{
    for (const json& entry : oracle()["acbb_loads"]) {
        const auto bearing = angular_contact(entry, entry["pair"].get<bool>(), number(entry, "alpha") * degree);
        const EquivalentLoads loads = equivalent_loads(bearing, number(entry, "Fr"), number(entry, "Fa"));
        CHECK(close(loads.torque_load, number(entry, "P1")));
        CHECK(close(loads.static_load, number(entry, "P0")));
    }
    for (const json& entry : oracle()["palmgren_M1"]) {
        const auto bearing = angular_contact(entry, true, 25 * degree);
        const double torque = palmgren_load_torque(bearing, {number(entry, "P0"), number(entry, "P1")});
        CHECK(close(torque, number(entry, "M1")));
    }
}

TEST_CASE("oracle: heat of the crankshaft's bearings")
{
    const ViscosityCurve oil = table_oil();
    for (const json& entry : oracle()["bearing_heat"]) {
        auto bearing = angular_contact(entry, true, 25 * degree);
        bearing.lubrication_factor = number(entry, "f0");
        const Duty duty = steady_duty(number(entry, "Fr"), number(entry, "n_rpm") * rpm);
        const double celsius = number(entry, "nu") == 3.25e-5 ? 40 : 70;
        const double heat = palmgren_heat(bearing, duty, number(entry, "Fa"), oil)(zero_celsius + celsius).value;
        CHECK(close(number(entry, "n_bearings") * heat, number(entry, "H")));
    }
    for (const json& entry : oracle()["crank_row_equivalents"]) {
        const json& row = oracle()["table5_laws"]["beam1-crank2"];
        const double speed = number(entry, "n_rpm") * rpm;
        const double per_factor = palmgren_viscous_torque(1, number(entry, "dm"), 32.5e-6, speed).torque * speed;
        const double factor = number(row, "c1") * std::pow(32.5, 2.0 / 3.0) / (number(entry, "N") * per_factor);
        // The reference turns N mm and rpm into W by 1.047e-4 in place of pi/30000.
        CHECK(close(factor * std::numbers::pi / 30000 / 1.047e-4, number(entry, "f0")));
    }
}

TEST_CASE("physics of the crankshaft's row: four pairs of 170 x 260 mm under 18 kN at 200 rpm")
{
    const PalmgrenBearing bearing =
        palmgren_bearing(BearingType::angular_contact_ball_pair, OilSupply::bath, 25 * degree, 0.215, 220e3);
    const HeatLaw one = palmgren_heat(bearing, steady_duty(18e3, 200 * rpm), 0, table_oil());
    const HeatLaw row = summed_heat({one, one, one, one});
    // Independent figures, in whole watts.
    CHECK(std::abs(row(zero_celsius + 20).value - 456) < 0.5);
    CHECK(std::abs(row(zero_celsius + 40).value - 330) < 0.5);
    CHECK(std::abs(row(zero_celsius + 70).value - 239) < 0.5);
}

TEST_CASE("oracle: spin")
{
    for (const json& entry : oracle()["spin"]) {
        const double moment =
            spin_moment(number(entry, "mu"), number(entry, "Q"), number(entry, "a"), number(entry, "b"));
        if (entry.contains("Ms"))
            CHECK(close(moment, number(entry, "Ms")));
        if (entry.contains("H"))
            CHECK(close(spin_power(moment, entry["Z"].get<int>(), number(entry, "omega"), number(entry, "alpha_rad")),
                        number(entry, "H")));
    }
}

TEST_CASE("oracle: the model of SKF")
{
    for (const json& entry : oracle()["skf"]) {
        const double d = number(entry, "d");
        const double D = number(entry, "D");
        const SkfBearing bearing = entry["kind"] == "acbb" ? skf_angular_contact(d, D) : skf_cylindrical_roller(d, D);
        const SkfTorque torque = skf_torque(bearing, number(entry, "n_rpm") * rpm, number(entry, "nu"),
                                            number(entry, "Fr"), number(entry, "Fa"));
        CHECK(close(torque.rolling, number(entry, "Mrr")));
        CHECK(close(torque.sliding, number(entry, "Msl")));
        CHECK(close(torque.inlet_heating, number(entry, "phi_ish")));
        CHECK(close(torque.replenishment, number(entry, "phi_rs")));
        CHECK(close(torque.boundary_share, number(entry, "phi_bl")));
        CHECK(close(torque.total, number(entry, "M")));
    }
}

TEST_CASE("oracle: pins")
{
    for (const json& entry : oracle()["pin"]) {
        const Pin pin{number(entry, "d") / 2, number(entry, "L"), number(entry, "c"), number(entry, "mu")};
        const Duty duty = steady_duty(number(entry, "F"), number(entry, "omega"));
        CHECK(close(pin_load_heat(pin, duty), number(entry, "H_load")));
        CHECK(close(pin_film_heat(pin, duty, number(entry, "rho") * number(entry, "nu")), number(entry, "H_visc")));
    }
}

TEST_CASE("oracle: the calibrated laws at other speeds, loads and temperatures, low branch included")
{
    const ViscosityCurve oil = table_oil();
    for (const json& entry : oracle()["table5_joint_heat"]) {
        const std::string joint = entry["joint"];
        CalibratedFriction law;
        law.reference_speed = 200 * rpm;
        if (oracle()["table5_laws"].contains(joint)) {
            const json& row = oracle()["table5_laws"][joint];
            law.load_part = number(row, "c0");
            law.viscous_part = number(row, "c1");
            law.exponent = number(row, "p");
            law.kind = law.exponent < 1 ? FrictionKind::rolling : FrictionKind::pin;
        } else {
            law.kind = FrictionKind::guide;
            law.load_part = joint == "slider10-beam1" ? 362.23 : (joint == "slider12-beam1" ? 276.8344 : 158.2957);
        }
        const double speed = number(entry, "n_rpm") * rpm;
        const DutyRatio ratio = speed_ratio(law, speed, number(entry, "load_ratio"));
        const double heat = calibrated_heat(law, oil, speed, ratio)(zero_celsius + number(entry, "T")).value;
        CHECK_MESSAGE(close(heat, number(entry, "H")), joint << " " << heat << " " << number(entry, "H"));
    }
}

TEST_CASE("published: Palmgren's law at 3000 rpm, 30 mm2/s, mean diameter 160 mm")
{
    const double speed = 3000 * rpm;
    const double drag = palmgren_viscous_torque(4, 0.160, 30e-6, speed).torque;
    PalmgrenBearing bearing;  // f1 P1 = 20 N
    bearing.mean_diameter = 0.160;
    bearing.load_factor = 1;
    const double load = palmgren_load_torque(bearing, {0, 20});
    CHECK(std::abs(load - 3.200) < 1e-12);
    CHECK(std::abs(drag - 3.290397) < 5e-7);                   // last digit printed
    CHECK(std::abs((load + drag) * speed - 2039.018) < 5e-4);  // last digit printed
}
