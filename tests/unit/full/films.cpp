/// Requirement: interfaces and surfaces that name a law get the library's values for what the case says.
#include "../messages.hpp"
#include "deadpoint/casefile/files/read.hpp"
#include "deadpoint/exchange/heat.hpp"
#include "deadpoint/full/model/prepare.hpp"
#include "deadpoint/observer.hpp"
#include "deadpoint/press/laws/conductance.hpp"
#include "deadpoint/press/laws/film.hpp"
#include "deadpoint/press/loads/loads.hpp"
#include "deadpoint/press/problem/heat.hpp"
#include "deadpoint/press/problem/heat_tables.hpp"
#include "deadpoint/press/result/loads_result.hpp"
#include "deadpoint/surroundings/paper_film.hpp"
#include "deadpoint/tribology/conductance/bearing_conductance.hpp"
#include "deadpoint/tribology/conductance/conductance.hpp"
#include "deadpoint/tribology/conductance/fractal_contact.hpp"
#include "near.hpp"

#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>
#include <numbers>

using namespace deadpoint;
using messages::error_of;
using messages::has;

namespace {

constexpr double pi = std::numbers::pi;
constexpr double exact = 1e-12;  // the same formula on the same numbers

/// The case with laws, its mesh and its loads; made once.
struct Press {
    casefile::Case input;
    Machine machine;
    press::LoadsResult loads;
};

const Press& made_press()
{
    static const Press made = [] {
        Press p;
        p.input = casefile::read_case(DEADPOINT_SOURCE_DIR "/cases/starter-by-laws/case.toml").value;
        Observer quiet;
        p.machine = full::prepare_machine(p.input, 1.5, quiet);
        p.loads = press::compute_loads(p.input, &p.machine, 0);
        return p;
    }();
    return made;
}

/// Conductance of an interface of the press, the first of its joint changed.
press::InterfaceConductance
conductance(const std::string& joint, const std::optional<casefile::Conductance>& changed = {}, bool with_loads = true)
{
    auto input = made_press().input;
    if (changed)
        input.joints.at(joint).interfaces.at(0).conductance = *changed;
    if (!with_loads)  // or the guide would ask for them
        for (auto& interface : input.joints.at("guide").interfaces)
            std::get<casefile::RoughContact>(interface.conductance).surfaces.pressure = 1e5;
    const auto all =
        press::interface_conductances(input, made_press().machine, with_loads ? &made_press().loads : nullptr, 2 * pi);
    return *std::ranges::find(all, joint, &press::InterfaceConductance::joint);
}

press::SurfaceFilm film_of(const std::string& surface)
{
    return press::surface_film(*made_press().input.surfaces.at(surface).film, made_press().machine, surface,
                               &made_press().loads);
}

casefile::FractalContact fractal()
{
    casefile::FractalContact c;
    c.fractal_dimension = 1.5;
    c.fractal_roughness = 1e-10;
    c.sample_length = 1e-3;
    c.separation = 2e-6;
    c.surfaces.hardness = 2.2e9;
    c.surfaces.fluid_conductivity = 0.14;
    return c;
}

}  // namespace

TEST_CASE("oil films of journals follow their clearance, half of the resistance on either side")
{
    const auto c = conductance("crank_bearing");
    CHECK(c.law == "oil_film");
    CHECK(c.film_a == near(2 * 0.14 / (40e-6 * 0.8), exact));  // sqrt(1 - 0.6^2) = 0.8
    CHECK(c.film_b == c.film_a);
    CHECK(c.resistance() == near(40e-6 * 0.8 / 0.14, exact));
    CHECK_FALSE(c.pressure);
}

TEST_CASE("rough contact takes conductivities from the parts and the pressure from the guide's load")
{
    const auto c = conductance("guide");
    // 2 kN presses each of the two faces; they are covered wholly, 200 mm by 250 mm each.
    REQUIRE(c.pressure);
    CHECK(*c.pressure == near(4000 / (2 * 0.2 * 0.25), 0.2));  // side force of the rod on top
    CHECK(*c.pressure >= 40e3 * (1 - 1e-9));
    CHECK(c.pressure_from_loads);
    const tribology::RoughContact iron{1.1e-6, tribology::slope_of_roughness(1.1e-6), 2.2e9, 48.5, 48.5};
    CHECK(c.film_a == near(2 * tribology::rough_conductance(iron, {0.14, 0}, *c.pressure).conductance, exact));
}

TEST_CASE("fractal contact in a bearing is pressed by its mean load over the area of both seats")
{
    const auto given = fractal();
    const auto c = conductance("crank_bearing", given);
    const auto& history = made_press().loads.history;
    const auto driver = static_cast<std::size_t>(made_press().loads.linkage.driver);
    double mean = 0;  // the positions are evenly spaced in time
    for (const auto& force : history.joints[driver].force)
        mean += norm(force) / static_cast<double>(history.time.size());
    CHECK(*c.pressure == near(mean / (2 * pi * 0.08 * 0.06), 1e-6));  // areas are those of true cylinders
    tribology::FractalContact contact{1.5, 1e-10, 1e-3, 2e-6, 2.2e9, 0, 59, 42};
    contact.modulus = tribology::contact_modulus(115e9, 0.34, 210e9, 0.29);
    CHECK(c.film_a == near(2 * tribology::fractal_conductance(contact, {0.14, 0}, *c.pressure).conductance, 1e-9));
}

TEST_CASE("a stated pressure goes before the loads, and without either the law is refused")
{
    auto given = fractal();
    CHECK(has(error_of([&] { conductance("crank_bearing", given, false); }), "joints.crank_bearing.interfaces.front"));
    CHECK(has(error_of([&] { conductance("crank_bearing", given, false); }), "add pressure"));
    given.surfaces.pressure = 1e6;
    const auto c = conductance("crank_bearing", given);
    CHECK(*c.pressure == 1e6);
    CHECK_FALSE(c.pressure_from_loads);
    CHECK(c.film_a == conductance("crank_bearing", given, false).film_a);
}

TEST_CASE("rolling elements conduct by their spots, faster when they roll")
{
    casefile::RollingElements c;
    c.loaded_elements = 9;
    c.element_diameter = 0.02;
    c.pitch_diameter = 0.1;
    c.inner_spot = Vec2{2e-3, 2e-4};
    c.outer_spot = Vec2{2e-3, 3e-4};
    const auto turning = conductance("crank_bearing", c);
    tribology::BearingPath path;
    path.elements.assign(9, {{2e-3, 2e-4}, {2e-3, 3e-4}});
    path.element_diameter = 0.02;
    path.element = path.ring = {59, 8800, 377};  // CuSn8, side a
    path.rolling_speed = 2 * pi * 0.1 / 4 * (1 - 0.04);
    CHECK(turning.film_a == near(2 * tribology::bearing_conductance(path).per_area(turning.area).conductance, 1e-9));
    c.pitch_diameter.reset();
    CHECK(conductance("crank_bearing", c).film_a < turning.film_a);
    c.inner_spot = Vec2{2e-3, -1e-3};
    CHECK(has(error_of([&] { conductance("crank_bearing", c); }), "joints.crank_bearing.interfaces.front: "));
}

TEST_CASE("walls, plates, cylinders and disks take their lengths from the case or the geometry")
{
    const auto upright = film_of("air_uprights");
    CHECK(upright.air.natural_length == 0.7);
    const surroundings::AirSurface wall{surroundings::NaturalFlow::vertical, 0.7};
    CHECK(upright.law_at(1)(293.15)(305).value == surroundings::film_law(wall, 293.15)(305).value);
    CHECK(film_of("air_bed").air.natural_length == near(0.15, 1e-9));
    const auto rim = film_of("flywheel_rim");
    CHECK(rim.air.forced_length == near(0.4, 1e-9));
    CHECK(rim.speed_at(2 * pi) == 2 * pi);
    CHECK(rim.speed_at(-3) == 3);
    CHECK(rim.law_at(2 * pi)(293.15)(300).value > 1.5 * rim.law_at(0)(293.15)(300).value);
    CHECK(film_of("flywheel_faces").air.forced_length == near(0.4, 1e-9));  // not of the polygon in it
    CHECK(film_of("table_top").air.natural == surroundings::NaturalFlow::facing_up);
    casefile::Film film;
    film.law = casefile::PlateFilm{};
    const auto message =
        error_of([&] { press::surface_film(film, made_press().machine, "air_uprights", &made_press().loads); });
    CHECK(has(message, "surfaces.air_uprights.film"));
    CHECK(has(message, "add length"));
}

TEST_CASE("what moves has the root mean square speed of its faces")
{
    const auto& history = made_press().loads.history;
    double square = 0;
    for (const double speed : history.slide_speed)
        square += speed * speed / static_cast<double>(history.slide_speed.size());
    const auto slide = film_of("air_slide");
    CHECK(slide.speed_at(2 * pi) == near(std::sqrt(square), 1e-9));  // it does not turn
    CHECK(slide.speed_at(pi) == near(std::sqrt(square) / 2, 1e-9));
    CHECK(slide.speed_at(0) == 0);
    // The flywheel's rim turns about the axis: omega R, less what the chords of the mesh cut off.
    const auto& surfaces = made_press().machine.surfaces;
    const auto& rim = *std::ranges::find(surfaces, std::string("flywheel_rim"), &MeshSurface::name);
    CHECK(press::rms_speed(made_press().machine, rim, made_press().loads) == near(2 * pi * 0.2, 0.02));
    const auto& frame = *std::ranges::find(surfaces, std::string("air_bed"), &MeshSurface::name);
    CHECK(has(error_of([&] { press::rms_speed(made_press().machine, frame, made_press().loads); }), "does not move"));
    casefile::Film film;
    auto& moving = film.law.emplace<casefile::MovingFilm>();
    CHECK(has(error_of([&] { press::surface_film(film, made_press().machine, "air_slide", nullptr); }), "add speed"));
    moving.speed = 0.3;
    const auto given = press::surface_film(film, made_press().machine, "air_slide", nullptr);
    CHECK(given.speed_at(1) == 0.3);
    CHECK(given.speed_at(0) == 0);
}

TEST_CASE("the paper's constants and enclosed air")
{
    casefile::Film film;
    film.law = casefile::PaperFilm{casefile::PaperFilm::Of::crankshaft};
    CHECK(*press::surface_film(film, made_press().machine, "air_bed", nullptr).constant == 9.7);
    film.law = casefile::PaperFilm{casefile::PaperFilm::Of::frame};
    CHECK(*press::surface_film(film, made_press().machine, "air_bed", nullptr).constant == 5);
    film.law = casefile::EnclosedFilm{{}, 2};
    const auto closed = press::surface_film(film, made_press().machine, "air_bed", nullptr);
    const double open = surroundings::film_law(closed.air, 293.15)(303.15).value;
    CHECK(closed.law_at(1)(293.15)(303.15).value == near(open / (1 + open * closed.area / 2), exact));
}

TEST_CASE("the paper's correlations as printed, with its Table 7")
{
    casefile::Film film;
    film.law = casefile::PlateFilm{casefile::PlateFilm::Facing::sideways, true, 2};
    const auto wall = press::surface_film(film, made_press().machine, "air_bed", nullptr);
    // 0.13 Ra^(1/3), Ra = 9.80665 0.0262.. 8 K (2 m)^3 / nu^2 0.707 with Table 7 at 24 degC; figures of the model page
    const auto at = wall.law_at(1)(293.15)(301.15);
    CHECK(
        at.value ==
        near(surroundings::compare_natural_film(surroundings::NaturalFlow::vertical, 2, 301.15, 293.15).paper, exact));
    CHECK(at.value == near(5.56, 0.01));
    CHECK(at.slope > 0);
    CHECK(wall.law_at(1)(293.15)(285.15).value == near(at.value, exact));  // colder counts as warmer
    CHECK(wall.law_at(1)(293.15)(293.15).value == 0);
    film.law = casefile::RoundFilm{casefile::RoundFilm::Form::rotating_cylinder, true, 0.17};
    const auto shaft = press::surface_film(film, made_press().machine, "air_crankshaft", nullptr);
    CHECK(shaft.law_at(20.94)(293.15)(303.15).value ==
          near(surroundings::compare_rotating_film(20.94, 0.17, 298.15).paper, exact));
    CHECK(shaft.law_at(0)(293.15)(303.15).value > 0);
}

TEST_CASE("half a plate has the length of the whole one")
{
    auto input = casefile::read_case(DEADPOINT_TEST_DATA "/study/blocks.toml").value;
    casefile::Surface top;
    top.parts = {"middle"};
    top.select = casefile::Surface::Select::plane;
    top.axis = Axis::y;
    top.position = 0.3;
    input.surfaces["top"] = top;
    Observer quiet;
    const auto machine = full::prepare_machine(input, 1, quiet);
    REQUIRE(machine.half_model);
    CHECK(machine.surfaces.at(0).area == near(0.01, 1e-9));
    CHECK(*machine.surfaces.at(0).figures.area_over_perimeter == near(0.2 * 0.1 / 0.6, 1e-9));
}

TEST_CASE("the heat problem takes conductances and film laws, one per segment")
{
    auto input = made_press().input;
    input.operation.push_back(input.operation.front());
    input.operation.back().speed = 0;
    Observer quiet;
    const auto problem = press::describe_heat(input, made_press().machine, quiet, &made_press().loads);
    const auto conductances = press::interface_conductances(input, made_press().machine, &made_press().loads, 2 * pi);
    for (std::size_t i = 0; i < conductances.size(); ++i) {
        CHECK(problem.interfaces[i].film_a == conductances[i].film_a);
        CHECK(problem.interfaces[i].film_b == conductances[i].film_b);
    }
    const auto rim = std::ranges::find(problem.surfaces, std::string("flywheel_rim"), &SurfaceCondition::name);
    REQUIRE(rim->laws.size() == 2);
    CHECK(rim->laws[0](293.15)(300).value == film_of("flywheel_rim").law_at(2 * pi)(293.15)(300).value);
    CHECK(rim->laws[1](293.15)(300).value == film_of("flywheel_rim").law_at(0)(293.15)(300).value);
    CHECK(rim->emissivity == 0.6);  // radiation is the solver's own
    // 20 degC in the mean, 2 K more at 6 h and less at 18 h, in either segment alike
    for (const auto& segment : problem.segments) {
        CHECK(segment.ambient(6 * 3600) == near(295.15, exact));
        CHECK(segment.ambient(18 * 3600) == near(291.15, exact));
    }
}

TEST_CASE("a stated film coefficient grows with the speed of each segment")
{
    auto input = made_press().input;
    input.operation.push_back(input.operation[0]);
    input.operation[0].speed = 2 * pi;
    input.operation[1].speed = 0;
    auto& film = *input.surfaces.at("air_bed").film;
    film.law = casefile::FilmCoefficient{8};
    film.with_speed = SpeedGrowth{0.8, pi, 0.5};
    Observer quiet;
    const auto problem = press::describe_heat(input, made_press().machine, quiet, &made_press().loads);
    const auto bed = std::ranges::find(problem.surfaces, std::string("air_bed"), &SurfaceCondition::name);
    REQUIRE(bed->laws.size() >= 2);
    CHECK(bed->laws[0](293.15)(300).value == near(8 * (0.5 + 0.5 * std::pow(2, 0.8)), exact));
    CHECK(bed->laws[0](293.15)(300).slope == 0);
    CHECK(bed->laws[1](293.15)(300).value == 4);
    const auto tables = press::heat_tables(input, &made_press().machine, &made_press().loads, 0);
    const auto shown = std::ranges::find(tables.films, std::string("air_bed"), &press::FilmTable::surface);
    CHECK(shown->at_rest[0].convection == 4);
    REQUIRE(!shown->running.empty());
    CHECK(shown->running[0].convection == near(8 * (0.5 + 0.5 * std::pow(2, 0.8)), exact));
}

TEST_CASE("the tables show what the run takes")
{
    const auto tables = press::heat_tables(made_press().input, &made_press().machine, &made_press().loads, 0);
    Observer quiet;
    const auto problem = press::describe_heat(made_press().input, made_press().machine, quiet, &made_press().loads);
    REQUIRE(tables.joints.size() == problem.sources.size());
    REQUIRE(tables.temperatures.size() == 6);
    for (std::size_t r = 0; r < tables.joints.size(); ++r) {
        CHECK(tables.joints[r].row == problem.sources[r].name);
        for (std::size_t i = 0; i < 6; ++i)
            CHECK(problem.segments[0].heat[r](tables.temperatures[i]).value ==
                  near(tables.joints[r].heat[i], 1e-9));  // the run takes the law as a table, to 1e-10
    }
    CHECK(tables.conductances.size() == problem.interfaces.size());
    const auto rim = std::ranges::find(tables.films, std::string("flywheel_rim"), &press::FilmTable::surface);
    REQUIRE(rim->running.size() == 3);
    const double ambient = 293.15 + 2 * std::cos(2 * pi * 6 / 24);  // at the start
    CHECK(rim->ambient == near(ambient, exact));
    CHECK(rim->running[1].rise == 10);
    CHECK(rim->running[1].convection ==
          near(film_of("flywheel_rim").law_at(2 * pi)(ambient)(ambient + 10).value, 1e-9));
    // eps sigma (Ts^2 + Ta^2)(Ts + Ta)
    CHECK(rim->at_rest[2].radiation ==
          near(0.6 * 5.670374419e-8 * (std::pow(ambient + 20, 2) + ambient * ambient) * (2 * ambient + 20), 1e-9));
    const auto bed = std::ranges::find(tables.films, std::string("air_bed"), &press::FilmTable::surface);
    CHECK(bed->running.empty());
    CHECK(tables.warnings.empty());
    CHECK(has(error_of([] { press::heat_tables(made_press().input, nullptr, nullptr, 4); }), "no segment 4"));
}

TEST_CASE("a conductance outside its tested range is warned about once, by name")
{
    struct Listener : Observer {
        std::vector<std::string> heard;
        void warn(std::string_view text) override { heard.emplace_back(text); }
    } listener;
    auto input = made_press().input;
    std::get<casefile::OilFilm>(input.joints.at("wrist_pin").interfaces.at(0).conductance).eccentricity = 0.99;
    press::describe_heat(input, made_press().machine, listener, &made_press().loads);
    REQUIRE(listener.heard.size() == 1);
    CHECK(has(listener.heard[0], "joints.wrist_pin.interfaces.pin: "));
    CHECK(has(listener.heard[0], "'oil_film'"));
}
