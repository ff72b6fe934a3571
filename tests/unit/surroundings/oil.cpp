#include "deadpoint/core/error.hpp"
#include "deadpoint/surroundings/oil_circuit.hpp"

#include <cmath>
#include <doctest/doctest.h>
#include <numeric>
#include <vector>

using namespace deadpoint;
using namespace deadpoint::surroundings;

namespace {

OilCircuit five_joints()
{
    return {.inlet_temperature = 303.15,
            .mass_flow = mass_flow_of(20.0 / 60000, 870),  // 20 l/min
            .heat_capacity = 1900,
            .conductance = {120, 45, 0, 300, 80},
            .sump = {}};
}

const std::vector<double> films{318.4, 311.2, 325.0, 307.9, 300.1};

double sum(const std::vector<double>& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

}  // namespace

TEST_CASE("oil: one joint is a heat exchanger with one side at constant temperature")
{
    const OilCircuit circuit{
        .inlet_temperature = 300, .mass_flow = 0.1, .heat_capacity = 2000, .conductance = {100}, .sump = {}};
    const OilState state = OilLine(circuit).at({320});
    const double outlet = 320 - 20 * std::exp(-0.5);  // h A / (m c) = 0.5
    CHECK(state.outlet[0] == doctest::Approx(outlet).epsilon(1e-14));
    CHECK(state.heat[0] == doctest::Approx(200 * (outlet - 300)).epsilon(1e-13));
    // The mean oil temperature of the film law gives the same heat: logarithmic mean difference.
    CHECK(100 * (320 - state.mean[0]) == doctest::Approx(state.heat[0]).epsilon(1e-13));
    CHECK(320 - state.mean[0] == doctest::Approx((20 - (320 - outlet)) / 0.5).epsilon(1e-12));
}

TEST_CASE("oil: energy closes, the oil warms along its way")
{
    const OilCircuit circuit = five_joints();
    const OilState state = OilLine(circuit).at(films);
    const double flow = circuit.mass_flow * circuit.heat_capacity;
    CHECK(state.total_heat == doctest::Approx(sum(state.heat)).epsilon(1e-15));
    CHECK(state.total_heat == doctest::Approx(flow * (state.return_temperature - 303.15)).epsilon(1e-12));
    CHECK(state.cooler_power == doctest::Approx(flow * (state.return_temperature - 303.15)).epsilon(1e-12));
    CHECK(state.sump_loss == 0);
    CHECK(state.inlet[0] == 303.15);
    for (std::size_t i = 0; i < 5; ++i) {
        CHECK(state.heat[i] == doctest::Approx(flow * (state.outlet[i] - state.inlet[i])).epsilon(1e-11));
        if (i > 0)
            CHECK(state.inlet[i] == state.outlet[i - 1]);
        CHECK((state.outlet[i] - state.inlet[i]) * (films[i] - state.inlet[i]) >= 0);
        CHECK(std::abs(films[i] - state.outlet[i]) <= std::abs(films[i] - state.inlet[i]));
    }
    CHECK(state.heat[2] == 0);
    CHECK(state.heat[4] < 0);  // a joint colder than the oil is warmed by it
}

TEST_CASE("oil: heat and mean temperature are linear in the film temperatures, with the stated matrix")
{
    OilCircuit circuit = five_joints();
    for (const bool cooler : {true, false}) {
        circuit.sump = {.cooler = cooler, .loss = 25, .ambient = 293.15};
        const OilLine line(circuit);
        const OilState state = line.at(films);
        const std::vector<double> heat = line.heat()(films);
        const std::vector<double> mean = line.mean_oil()(films);
        for (std::size_t i = 0; i < 5; ++i) {
            CHECK(std::abs(heat[i] - state.heat[i]) < 1e-9);  // offset and product are each about 1e5 W
            CHECK(mean[i] == doctest::Approx(state.mean[i]).epsilon(1e-14));
        }
        for (std::size_t j = 0; j < 5; ++j) {
            std::vector<double> warmer = films;
            warmer[j] += 1;  // linear, so a whole kelvin is exact
            const OilState after = line.at(warmer);
            for (std::size_t i = 0; i < 5; ++i) {
                const double entry = line.heat().matrix[i * 5 + j];
                CHECK(std::abs(entry - (after.heat[i] - state.heat[i])) < 1e-9);
                if (i != j)
                    CHECK(entry <= 0);
                if (cooler && j > i)
                    CHECK(entry == 0);
            }
        }
    }
}

TEST_CASE("oil: limits of no flow, of endless flow, and of equal temperatures")
{
    OilCircuit circuit = five_joints();
    circuit.mass_flow = 0;
    const OilState still = OilLine(circuit).at(films);
    for (std::size_t i = 0; i < 5; ++i)
        CHECK(still.heat[i] == 0);
    CHECK(still.cooler_power == 0);

    circuit.mass_flow = 1e9;
    const OilState endless = OilLine(circuit).at(films);
    for (std::size_t i = 0; i < 5; ++i) {
        CHECK(endless.mean[i] == doctest::Approx(303.15).epsilon(1e-9));
        CHECK(endless.heat[i] == doctest::Approx(circuit.conductance[i] * (films[i] - 303.15)).epsilon(1e-9));
    }

    // Little flow: the oil leaves the first joint at its temperature, and the heat grows in proportion to the flow.
    circuit.mass_flow = 1e-6;
    const OilState slow = OilLine(circuit).at(films);
    CHECK(slow.outlet[0] == doctest::Approx(films[0]).epsilon(1e-14));
    CHECK(slow.heat[0] == doctest::Approx(1e-6 * 1900 * (films[0] - 303.15)).epsilon(1e-12));

    const OilState equal = OilLine(five_joints()).at(std::vector<double>(5, 303.15));
    CHECK(equal.total_heat == 0);
    CHECK(equal.return_temperature == 303.15);
}

TEST_CASE("oil: the sump loses heat; without a cooler it fixes the inlet")
{
    OilCircuit circuit = five_joints();
    const double flow = circuit.mass_flow * circuit.heat_capacity;
    circuit.sump = {.cooler = true, .loss = 25, .ambient = 293.15};
    const OilState cooled = OilLine(circuit).at(films);
    CHECK(cooled.total_heat == doctest::Approx(cooled.sump_loss + cooled.cooler_power).epsilon(1e-14));
    const double sump = cooled.return_temperature - cooled.sump_loss / flow;
    CHECK(cooled.sump_loss == doctest::Approx(25 * (sump - 293.15)).epsilon(1e-12));
    CHECK(cooled.cooler_power == doctest::Approx(flow * (sump - 303.15)).epsilon(1e-10));

    circuit.sump.cooler = false;
    const OilState free = OilLine(circuit).at(films);
    CHECK(free.cooler_power == 0);
    CHECK(free.sump_loss == doctest::Approx(25 * (free.inlet_temperature - 293.15)).epsilon(1e-13));
    CHECK(free.total_heat == doctest::Approx(free.sump_loss).epsilon(1e-11));
    CHECK(free.total_heat == doctest::Approx(flow * (free.return_temperature - free.inlet_temperature)).epsilon(1e-11));

    circuit.sump.loss = 0;  // nothing leaves: the oil carries heat from warm to cold joints only
    const OilState closed = OilLine(circuit).at(films);
    CHECK(std::abs(closed.total_heat) < 1e-9);
    CHECK(closed.return_temperature == doctest::Approx(closed.inlet_temperature).epsilon(1e-14));
}

TEST_CASE("oil: nonsense is refused")
{
    OilCircuit circuit = five_joints();
    CHECK_THROWS_AS((void)OilLine(circuit).at({300, 300}), InputError);
    CHECK_THROWS_WITH_AS((void)OilLine(circuit).heat()({300, 300}), doctest::Contains("2 temperatures for 5 joints"),
                         InputError);
    CHECK_THROWS_AS((void)OilLine(circuit).at({300, 300, std::nan(""), 300, 300}), DomainError);
    CHECK_THROWS_AS((void)mass_flow_of(-1, 870), InputError);
    circuit.conductance[3] = -1;
    CHECK_THROWS_WITH_AS(OilLine{circuit}, doctest::Contains("joint 4"), InputError);
    circuit = five_joints();
    circuit.heat_capacity = 0;
    CHECK_THROWS_AS(OilLine{circuit}, InputError);
    circuit = five_joints();
    circuit.mass_flow = 0;
    circuit.sump = {.cooler = false, .loss = 0, .ambient = 293.15};
    CHECK_THROWS_WITH_AS(OilLine{circuit}, doctest::Contains("nothing fixes"), InputError);
}
