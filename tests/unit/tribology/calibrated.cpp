#include "deadpoint/tribology/friction/calibrated.hpp"

#include "deadpoint/error.hpp"
#include "deadpoint/exchange/laws/friction.hpp"
#include "deadpoint/tribology/friction/duty.hpp"
#include "near.hpp"

#include <array>
#include <cmath>
#include <doctest/doctest.h>
#include <numbers>
#include <vector>

using namespace deadpoint;
using namespace deadpoint::tribology;

namespace {

constexpr double zero_celsius = 273.15;
constexpr double reference_speed = 200 * 2 * std::numbers::pi / 60;

ViscosityCurve oil()
{
    std::vector<double> temperature;
    for (int celsius = 20; celsius <= 70; celsius += 10)
        temperature.push_back(zero_celsius + celsius);
    return {temperature, {70e-6, 50e-6, 32.5e-6, 22.5e-6, 16e-6, 12e-6}};
}

CalibratedFriction law(FrictionKind kind, double load, double viscous)
{
    return {kind, load, viscous, kind == FrictionKind::rolling ? 2.0 / 3.0 : 1.0, reference_speed, 1.0};
}

struct Row {
    CalibratedFriction law;
    double tolerance;  ///< rounding of the row as printed [W]
    std::array<double, 6> printed;
};

/// Table 5 of Zheng et al. 2018: heat of the joints at 20, 30 .. 70 degC, and the laws it decomposes into. The rows of
/// joints 2-3 and 9-10 are printed in whole watts, that of the crankshaft to 0.01 W, the others to 0.0001 W.
std::vector<Row> table_5()
{
    constexpr auto rolling = FrictionKind::rolling;
    constexpr auto pin = FrictionKind::pin;
    constexpr auto guide = FrictionKind::guide;
    return {
        {law(rolling, 149.46406, 110.34433), 0.0032, {2023.66, 1647.07, 1273.22, 1028.90, 850.11, 727.83}},
        {law(pin, 119.29, 11.54435), 0.5, {927, 697, 494, 379, 304, 258}},
        {law(pin, 93.740893, 5.599682), 2e-4, {485.7186, 373.725, 275.7306, 219.7338, 183.3358, 160.937}},
        {law(pin, 98.784521, 5.5996831), 2e-4, {490.7624, 378.7686, 280.7742, 224.7774, 188.3794, 165.9808}},
        {law(pin, 71.843257, 2.1540476), 2e-4, {222.6266, 179.5456, 141.8498, 120.3094, 106.308, 97.6918}},
        {law(pin, 64.378193, 2.1540485), 2e-4, {215.1616, 172.0806, 134.3848, 112.8442, 98.843, 90.2268}},
        {law(pin, 88.519992, 5.599683), 2e-4, {480.4978, 368.5042, 270.5096, 214.5128, 178.115, 155.7162}},
        {law(pin, 201.19341, 7.2701457), 0.5, {710, 565, 437, 365, 318, 288}},
        {law(pin, 89.964143, 11.544352), 2e-4, {898.0688, 667.1818, 465.1556, 349.712, 274.6738, 228.4964}},
        {law(rolling, 3.0976624, 55.171904), 2e-4, {940.192, 751.8956, 564.9734, 442.8144, 353.4174, 292.2802}},
        {law(rolling, 1.0459568, 17.832486), 2e-4, {303.9306, 243.07, 182.6536, 143.1698, 114.2752, 94.5146}},
        {law(guide, 362.23, 0), 1e-9, {362.23, 362.23, 362.23, 362.23, 362.23, 362.23}},
        {law(guide, 276.8344, 0), 1e-9, {276.8344, 276.8344, 276.8344, 276.8344, 276.8344, 276.8344}},
        {law(guide, 158.2957, 0), 1e-9, {158.2957, 158.2957, 158.2957, 158.2957, 158.2957, 158.2957}},
    };
}

}  // namespace

TEST_CASE("viscosity: points are met, between them the logarithm is linear, beyond them it goes on and is flagged")
{
    const ViscosityCurve curve = oil();
    CHECK(curve(zero_celsius + 20).value == near(70e-6, 1e-14));
    CHECK(curve(zero_celsius + 70).value == near(12e-6, 1e-14));
    CHECK(curve(zero_celsius + 35).value == near(std::sqrt(50e-6 * 32.5e-6), 1e-14));
    CHECK(curve(zero_celsius + 80).value == near(12e-6 * 12.0 / 16.0, 1e-12));
    CHECK(curve(zero_celsius + 0).value == near(70e-6 * std::pow(1.4, 2), 1e-12));
    CHECK(curve(zero_celsius + 45).in_range);
    CHECK_FALSE(curve(zero_celsius + 80).in_range);
    CHECK_FALSE(curve(zero_celsius + 19.9).in_range);
}

TEST_CASE("heat: the rows of Table 5 as printed, and their totals")
{
    const ViscosityCurve curve = oil();
    const std::array<double, 6> totals{8495, 6841, 5318, 4398, 3767, 3357};
    for (int i = 0; i < 6; ++i) {
        const double temperature = zero_celsius + 20 + 10 * i;
        double total = 0;
        for (const Row& row : table_5()) {
            const double heat = calibrated_heat(row.law, &curve, reference_speed)(temperature).value;
            CHECK(std::abs(heat - row.printed[i]) < row.tolerance);
            total += heat;
        }
        CHECK(std::abs(total - totals[i]) < 1.5);  // two rows rounded to 0.5 W each, the total to 0.5 W
    }
}

TEST_CASE("heat: derivative agrees with central differences")
{
    const ViscosityCurve curve = oil();
    for (const double temperature : {280.0, 300.0, 321.0, 360.0}) {
        for (const Row& row : table_5()) {
            const HeatLaw heat = calibrated_heat(row.law, &curve, 1.7 * reference_speed);
            const double h = 1e-3;
            const double slope = (heat(temperature + h).value - heat(temperature - h).value) / (2 * h);
            CHECK(heat(temperature).slope == near(slope, 1e-7));
        }
    }
}

TEST_CASE("heat: the parts scale with speed by their kind, and a press at rest makes none")
{
    const ViscosityCurve curve = oil();
    const double temperature = zero_celsius + 40;  // 32.5 mm2/s
    const auto heat = [&](FrictionKind kind, double factor) {
        return calibrated_heat(law(kind, 100, 10), &curve, factor * reference_speed)(temperature).value;
    };
    CHECK(heat(FrictionKind::rolling, 2) == near(200 + 10 * std::pow(2, 5.0 / 3) * std::pow(32.5, 2.0 / 3), 1e-5));
    CHECK(heat(FrictionKind::pin, -2) == near(200 + 10 * 4 * 32.5, 1e-5));
    CHECK(calibrated_heat(law(FrictionKind::guide, 100, 0), nullptr, 0.5 * reference_speed)(temperature).value ==
          near(50, 1e-5));
    for (const auto kind : {FrictionKind::rolling, FrictionKind::pin, FrictionKind::guide})
        CHECK(heat(kind, 0) == 0.0);
}

TEST_CASE("heat: load scales the load part alone, by F^1.33 in rolling bearings and by F elsewhere")
{
    const ViscosityCurve curve = oil();
    const double temperature = zero_celsius + 40;  // 32.5 mm2/s
    const auto heat = [&](FrictionKind kind, double force) {
        const CalibratedFriction friction = law(kind, 100, 10);
        const DutyRatio ratio = speed_ratio(friction, 1.5 * reference_speed, force);
        return calibrated_heat(friction, curve, 1.5 * reference_speed, ratio)(temperature).value;
    };
    CHECK(heat(FrictionKind::rolling, 0.5) - heat(FrictionKind::rolling, 0) == near(150 * std::pow(0.5, 1.33), 1e-12));
    CHECK(heat(FrictionKind::pin, 0.5) - heat(FrictionKind::pin, 0) == near(75, 1e-12));
    CHECK(heat(FrictionKind::guide, 3) - heat(FrictionKind::guide, 0) == near(450, 1e-12));
}

TEST_CASE("heat: a duty at another speed and force is the same as their ratios, under either load measure")
{
    const Duty reference{{0.25, 0.5, 0.25}, {1e3, 4e3, 9e3}, {20, 5, 10}};
    Duty now = shared(reference, 1.5);
    for (double& speed : now.speed)
        speed *= 2;
    for (const auto kind : {FrictionKind::rolling, FrictionKind::pin, FrictionKind::guide})
        for (const auto measure : {LoadMeasure::mean, LoadMeasure::peak}) {
            const DutyRatio ratio = duty_ratio(kind, measured(now, measure), measured(reference, measure));
            const DutyRatio expected = speed_ratio(law(kind, 1, 1), 2 * reference_speed, 1.5);
            CHECK(ratio.load == near(expected.load, 1e-13));
            CHECK(ratio.viscous == near(expected.viscous, 1e-13));
        }
    // A history of another shape is not: the two measures part.
    now.force = {9e3, 4e3, 1e3};
    const auto by = [&](LoadMeasure measure) {
        return duty_ratio(FrictionKind::pin, measured(now, measure), measured(reference, measure)).load;
    };
    CHECK(by(LoadMeasure::mean) == near(2 * (180 + 40 + 10) / (20 + 40 + 90.0), 1e-13));
    CHECK(by(LoadMeasure::peak) == near(2, 1e-13));
    CHECK_THROWS_AS(duty_ratio(FrictionKind::pin, now, steady_duty(0, 1)), InputError);
    CHECK_THROWS_AS(duty_ratio(FrictionKind::pin, now, steady_duty(1, 0)), InputError);
}

TEST_CASE("heat: below nu n = 2000 mm2/s rpm a rolling joint's drag goes with speed, and with no viscosity")
{
    const ViscosityCurve curve = oil();
    const CalibratedFriction friction = law(FrictionKind::rolling, 0, 10);
    const auto heat = [&](double rpm_now, double celsius) {
        return calibrated_heat(friction, &curve, reference_speed * rpm_now / 200)(zero_celsius + celsius);
    };
    const double at_100 = 10 * 0.5 * 160 / std::pow(200, 2.0 / 3);
    CHECK(heat(100, 70).value == near(at_100, 1e-12));  // 1200
    CHECK(heat(100, 60).value == near(at_100, 1e-12));  // 1600
    CHECK(heat(100, 70).slope == 0.0);
    CHECK(heat(50, 70).value == near(at_100 / 2, 1e-12));
    // Branches meet within 0.8 %: 20 mm2/s at 100 rpm, between 50 and 60 degC.
    const double meeting = 50 + 10 * std::log(22.5 / 20) / std::log(22.5 / 16);
    CHECK(heat(100, meeting + 1e-6).value / heat(100, meeting - 1e-6).value == near(160 / 158.7401, 1e-6));
    // Another exponent is not Palmgren's law and has no branch.
    CalibratedFriction other = friction;
    other.exponent = 0.5;
    CHECK(calibrated_heat(other, &curve, reference_speed / 2)(zero_celsius + 70).slope < 0);
}

TEST_CASE("heat laws and viscosity curves that mean nothing are refused")
{
    const ViscosityCurve curve = oil();
    CHECK_THROWS_AS(ViscosityCurve({300}, {1e-5}), InputError);
    CHECK_THROWS_AS(ViscosityCurve({300, 290}, {1e-5, 2e-5}), InputError);
    CHECK_THROWS_AS(ViscosityCurve({300, 310}, {1e-5, 0}), InputError);
    CHECK_THROWS_AS(calibrated_heat(law(FrictionKind::pin, -1, 0), &curve, 1), InputError);
    CHECK_THROWS_AS(calibrated_heat(law(FrictionKind::pin, 1, 1), nullptr, 1), InputError);
    CHECK_THROWS_AS(calibrated_heat(law(FrictionKind::pin, 1, 1), curve, 1, {-1, 1}), InputError);
    CHECK_THROWS_AS(speed_ratio(law(FrictionKind::pin, 1, 1), 1, -1), InputError);
}
