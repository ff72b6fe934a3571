/// Requirement: the message of a solve that failed names the key of the case whose quantity is out of all proportion.
#include "deadpoint/heat/largest_term.hpp"

#include "lumps.hpp"

#include <cmath>
#include <doctest/doctest.h>
#include <limits>

using namespace deadpoint;
using namespace deadpoint::heat;

namespace {

/// One of each: a joint of 150 W/K, friction of 300 W, a motor of 80 W, a film of 5 W/K, a flux of 100 W.
struct Everything {
    Everything()
    {
        InterfaceLaw law;
        law.film_a = 1000;
        law.film_b = 500;
        law.source = 0;
        problem.interfaces = {law};
        problem.sources = {{"pin", 1, {}, {}}};
        problem.body_heat = {{"motor", {0}, -1}};
        problem.surfaces = {lumps::film(10), lumps::film(0)};
        problem.surfaces[0].name = "front";
        problem.surfaces[1].name = "lamp";
        problem.surfaces[1].kind = SurfaceCondition::Kind::flux;
        problem.surfaces[1].flux = [](double time) { return 400 + time; };
        problem.segments = {lumps::segment(problem, 100, 290)};
        problem.segments[0].heat[0] = [](double) { return LawValue{300, 0, true}; };
        problem.segments[0].body_heat[0] = lumps::steady(80);
        geometry.layout = {1, 1, 2, 1, 0};
        geometry.interface_names = {"crank.pin"};
        geometry.interface_area = {0.1};
        geometry.surface_area = {0.5, 0.25};
        balance.source_heat = {300};
        balance.source_temperature = {310};
    }
    [[nodiscard]] std::string text(std::vector<Term> of_system = {}, double time = 0) const
    {
        JointBalance joints(problem, geometry);
        joints.enter(problem.segments[0]);
        return largest_term(problem, problem.segments[0], geometry, joints, balance, time, std::move(of_system));
    }
    HeatProblem problem;
    HeatGeometry geometry;
    HeatBalance balance;
};

}  // namespace

TEST_CASE("the largest of all terms is named by its table, its name, its value and its unit")
{
    Everything at;
    CHECK(at.text() == "the heat of friction.pin: 300 W");
    at.problem.interfaces[0].film_a = 1e6;
    CHECK(at.text() == "the conductance of joints.crank.pin: 1e+05 W/K");
    at.problem.interfaces[0].film_a = 1000;
    at.problem.segments[0].body_heat[0] = lumps::steady(-4000);
    CHECK(at.text() == "the power of heat_sources.motor: -4e+03 W");  // by its size, either sign
    at.problem.segments[0].body_heat[0] = {};
    at.problem.surfaces[0].coefficient = 2000;
    CHECK(at.text() == "the film of surfaces.front: 2e+03 W/m2/K");  // 1000 W/K over its area
}

TEST_CASE("a flux counts by its area, and at its time")
{
    Everything at;
    CHECK(at.text({}, 3600) == "the heat flux of surfaces.lamp: 4e+03 W/m2");  // 1000 W of 4000 W/m2
    at.geometry.surface_area[1] = 1e-3;
    CHECK(at.text({}, 3600) == "the heat of friction.pin: 300 W");
}

TEST_CASE("what a system brings along is weighed with the rest")
{
    const Everything at;
    CHECK(at.text({{"the heat capacity of parts.ram: 5e+04 J/K", 5e4}}) == "the heat capacity of parts.ram: 5e+04 J/K");
    CHECK(at.text({{"small", 1}}) == "the heat of friction.pin: 300 W");
}

TEST_CASE("a term that is not finite is the largest")
{
    Everything at;
    at.problem.segments[0].body_heat[0] = lumps::steady(std::nan(""));
    CHECK(at.text({{"huge", 1e200}}) == "the power of heat_sources.motor: nan W");
    at.problem.segments[0].body_heat[0] = lumps::steady(-std::numeric_limits<double>::infinity());
    CHECK(at.text({{"huge", 1e200}}) == "the power of heat_sources.motor: -inf W");
}

TEST_CASE("before the first balance there is no friction heat to name; without any term there is none")
{
    Everything at;
    at.balance = {};
    CHECK(at.text() == "the conductance of joints.crank.pin: 150 W/K");
    const HeatProblem empty;
    const HeatSegment segment;
    const HeatGeometry geometry;
    const JointBalance joints(empty, geometry);
    CHECK(largest_term(empty, segment, geometry, joints, {}, 0, {}) == "none");
}

TEST_CASE("numbers in messages have six digits")
{
    CHECK(short_text(1234567.0) == "1.23457e+06");
    CHECK(short_text(0.125) == "0.125");
    CHECK(short_text(300) == "300");
}
