/// Requirement: the right-hand side of the heat balance is the sum of its parts, watt by watt.
#include "deadpoint/heat/sources.hpp"

#include "lumps.hpp"
#include "near.hpp"

#include <cmath>
#include <doctest/doctest.h>

using namespace deadpoint;
using namespace deadpoint::heat;

namespace {

/// Lumps 0 and 1 with a joint of 0.1 m2 that rubs, an oil circuit past it, a motor in lump 2, a film of lump 2 to the
/// room, one of lump 1 to enclosed air, and one of lump 0 that radiates to the room.
HeatProblem everything()
{
    HeatProblem problem;
    InterfaceLaw law;
    law.film_a = 700;
    law.film_b = 500;
    law.oil = 150;
    law.oil_temperature = 300;
    law.source = 0;
    problem.interfaces = {law};
    problem.sources = {{"pin", 1, {}, {}}};
    problem.body_heat = {{"motor", {2}, -1}};
    problem.oil = {{"main", {{0}}, false, 0, 2e4, 15, 305}};
    problem.enclosures = {{"cabin", 3000, 4, 295}};
    problem.surfaces = {lumps::film(12), lumps::film(7), lumps::film(0)};
    problem.surfaces[1].enclosure = 0;
    problem.surfaces[2].emissivity = 0.8;
    problem.segments = {lumps::segment(problem, 1000, 290)};
    problem.segments[0].oil_flow = {60};
    problem.segments[0].heat[0] = [](double t) { return LawValue{500 - 3 * (t - 290), -3, true}; };
    problem.segments[0].body_heat[0] = lumps::steady(80);
    problem.segments[0].enclosure_power = {lumps::steady(25)};
    return problem;
}

lumps::Machine machine() { return {{2e4, 5e4, 3e4}, {{1, 2, 25}}, {{0, 1, 0.1}}, {{2, 0.5}, {1, 0.4}, {0, 0.2}}, {0}}; }

struct Sources {
    explicit Sources(HeatProblem input = everything())
        : problem(std::move(input)), system(lumps::terms_of(machine(), problem), problem), sources(system, problem)
    {
        sources.oil.set_sumps({305});
        sources.air.start_from({298});
        sources.enter(problem.segments[0]);
    }
    HeatProblem problem;
    lumps::DenseSystem system;
    HeatSources<lumps::DenseSystem> sources;
    Eigen::VectorXd temperature = lumps::states_of(machine(), Eigen::Vector3d(330, 320, 310));
};

}  // namespace

TEST_CASE("watts into the lumps: what is made less what the air and the oil take, whatever the matrix conducts")
{
    Sources at;
    const auto rate = at.sources.at(0, at.temperature);
    Eigen::VectorXd conducted(3);
    at.system.conduct(at.temperature, conducted);
    const auto& balance = rate.balance;
    // Heat into enclosed air is no heat of the room's, and the air's power is none of the lumps'.
    const double lost = balance.to_air - balance.air[0].to_room + balance.air[0].from_surfaces + balance.to_oil;
    const double made = balance.generated - balance.air[0].power;
    CHECK(lumps::watts_of(machine(), rate.watts - conducted).sum() == near(made - lost, 1e-12));
    CHECK(made == near(balance.source_heat[0] + 80, 1e-14));
}

TEST_CASE("each scalar of the balance by its own formula")
{
    Sources at;
    const auto balance = at.sources.at(0, at.temperature).balance;
    CHECK(balance.body_heat[0] == 80);
    CHECK(balance.air[0].temperature == 298);
    CHECK(balance.air[0].power == 25);
    CHECK(balance.air[0].to_room == near(4 * (298 - 290.0), 1e-15));
    CHECK(balance.air[0].from_surfaces == near(7 * 0.4 * (320 - 298), 1e-14));
    const double radiated = 0.8 * stefan_boltzmann * 0.2 * (std::pow(330.0, 4) - std::pow(290.0, 4));
    CHECK(balance.to_air == near(12 * 0.5 * 20 + 32 + radiated, 1e-13));
    // tau = film without heat + H / (A S), H = law(tau): a straight law, solved on paper.
    const double film = (700 * 330.0 + 500 * 320.0 + 150 * 300.0) / 1350, self = 1 / 135.0;
    const double heat = (500 - 3 * (film - 290)) / (1 + 3 * self);
    CHECK(balance.source_heat[0] == near(heat, 1e-11));
    CHECK(balance.to_oil == near(15 * (film + self * heat - 300), 1e-11));
}

TEST_CASE("the slope of the sources by a lump's temperature is the film's and the law's together")
{
    Sources at;
    const auto base = at.sources.at(0, at.temperature);
    constexpr double h = 1e-3;
    auto moved = at.temperature;
    moved[1] += h * lumps::roots(machine())[1];
    const auto next = at.sources.at(0, moved);
    // b_1 b^T slope: the source's heat follows lump 1 by its side's share and falls to the lumps by shares.
    const double share_a = 700 / 1350.0, share_b = 500 / 1350.0;
    const Eigen::Vector3d expected = Eigen::Vector3d(share_a, share_b, 0) * base.balance.source_slope[0] * share_b;
    CHECK((lumps::watts_of(machine(), next.watts - base.watts) / h - expected).norm() < 1e-6 * expected.norm());
}

TEST_CASE("corrections of the joint's heat go to both sides")
{
    Sources at;
    auto rate = at.sources.at(0, at.temperature);
    const Eigen::VectorXd before = rate.watts;
    at.sources.correct(rate, {40});
    const Eigen::VectorXd change = lumps::watts_of(machine(), rate.watts - before);
    CHECK(change[0] == near(40 * 700 / 1350.0, 1e-11));
    CHECK(change[1] == near(40 * 500 / 1350.0, 1e-11));
    CHECK(std::abs(change[2]) < 1e-11);
}

TEST_CASE("at a segment's start oil and joints agree: the oil's heat is what the films give")
{
    Sources at;
    const auto rate = at.sources.equilibrate_oil(0, at.temperature);
    const auto& oil = rate.balance.oil[0];
    CHECK(oil.inlet == 305);
    CHECK(at.sources.joints.oil_temperature()[0] == 305);
    CHECK(oil.heat == near(rate.balance.to_oil, 1e-9));  // settled to 1e-9 K
    CHECK(oil.outlet - oil.inlet == near(oil.heat / 60, 1e-12));
}

TEST_CASE("oil whose warming makes more heat than it carries off does not settle, and the error says where to look")
{
    // Both joints of the circuit share a source whose heat rises by 20 W/K; the oil hardly flows.
    auto problem = everything();
    problem.interfaces.push_back(problem.interfaces[0]);
    problem.oil[0].joints = {{0}, {1}};
    problem.segments[0].oil_flow = {0.01};
    problem.segments[0].heat[0] = [](double t) { return LawValue{500 + 20 * (t - 290), 20, true}; };
    auto lumps = machine();
    lumps.interfaces.emplace_back(1, 2, 0.1);
    lumps::DenseSystem system(lumps::terms_of(lumps, problem), problem);
    HeatSources<lumps::DenseSystem> sources(system, problem);
    sources.oil.set_sumps({305});
    sources.air.start_from({298});
    sources.enter(problem.segments[0]);
    const Eigen::VectorXd temperature = lumps::states_of(machine(), Eigen::Vector3d(330, 320, 310));
    CHECK_THROWS_WITH_AS(sources.equilibrate_oil(7, temperature), doctest::Contains("at t = 7"), ConvergenceError);
    // As much oil as the joint has else carries the heat off.
    problem.segments[0].oil_flow = {60};
    CHECK_NOTHROW(sources.equilibrate_oil(7, temperature));
}

TEST_CASE("without oil nothing has to agree")
{
    auto problem = everything();
    problem.oil.clear();
    problem.segments[0].oil_flow.clear();
    Sources at(problem);
    const auto rate = at.sources.equilibrate_oil(0, at.temperature);
    CHECK(rate.balance.oil.empty());
    CHECK(rate.watts == at.sources.at(0, at.temperature).watts);
}

TEST_CASE("the largest change of the oil, of either sign")
{
    Sources at;
    at.sources.joints.set_oil({300});
    CHECK(at.sources.oil_change({298.5}) == 1.5);
    CHECK(at.sources.oil_change({302}) == 2);
    CHECK(at.sources.oil_change({}) == 0);
    // Oil without a temperature has not settled.
    CHECK(std::isinf(at.sources.oil_change({std::nan("")})));
}

TEST_CASE("loads of enclosed air are the slopes of its films by the air's temperature")
{
    auto problem = everything();
    problem.surfaces[2].enclosure = 0;  // a second film to the same air, by a law
    problem.surfaces[2].emissivity = 0;
    problem.surfaces[2].laws.emplace_back([](double air) -> FilmLaw {
        return [air](double t) { return LawValue{5 + 0.1 * (t - air), 0.1, true}; };
    });
    Sources at(problem);
    at.sources.build_air_loads(0, 50, at.temperature);
    const Eigen::VectorXd load = lumps::watts_of(machine(), at.sources.air.load(0));
    CHECK(load[0] == near(0.2 * (5 + 2 * 0.1 * (330 - 298)), 1e-13));  // d(h rise) / d(rise)
    CHECK(load[1] == near(0.4 * 7, 1e-15));
    CHECK(load[2] == 0);
}

TEST_CASE("a function that a segment does not give is no heat")
{
    auto problem = everything();
    problem.segments[0].body_heat[0] = {};
    problem.segments[0].enclosure_power = {};
    problem.segments[0].heat[0] = {};
    Sources at(problem);
    const auto balance = at.sources.at(0, at.temperature).balance;
    CHECK(balance.generated == 0);
    CHECK(balance.body_heat[0] == 0);
    CHECK(balance.air[0].power == 0);
}

TEST_CASE("sources know which segment they are in")
{
    auto problem = everything();
    problem.segments.push_back(problem.segments[0]);
    problem.segments[1].interfaces = problem.interfaces;
    problem.segments[1].interfaces[0].film_a = 1;
    Sources at(problem);
    CHECK(at.sources.segment_index() == 0);
    at.sources.enter(at.problem.segments[1]);
    CHECK(at.sources.segment_index() == 1);
    CHECK(&at.sources.segment() == &at.problem.segments[1]);
    Eigen::VectorXd conducted(3);
    at.system.conduct(lumps::states_of(machine(), Eigen::Vector3d(1, 0, 0)), conducted);
    conducted = lumps::watts_of(machine(), conducted);
    // c_aa = h_a (S - h_a) / S with h_a = 1, S = 651: the segment's laws reach the matrix.
    CHECK(conducted[0] == near(0.1 * 650 / 651.0, 1e-14));
}
