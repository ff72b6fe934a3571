/// Requirement: a problem split by part is the same problem; the box of a reduced model names what is free, and a case
/// outside of it is told so.
#include "../../scratch_folder.hpp"
#include "deadpoint/casefile/files/read.hpp"
#include "deadpoint/exchange/heat.hpp"
#include "deadpoint/exchange/machine.hpp"
#include "deadpoint/full/model/prepare.hpp"
#include "deadpoint/heat/films.hpp"
#include "deadpoint/observer.hpp"
#include "deadpoint/press/loads/loads.hpp"
#include "deadpoint/press/problem/heat.hpp"
#include "deadpoint/press/result/loads_result.hpp"
#include "deadpoint/twin/model/reduced_press.hpp"
#include "deadpoint/twin/run/box_check.hpp"
#include "deadpoint/twin/run/films_by_part.hpp"
#include "deadpoint/twin/run/free_coefficients.hpp"
#include "deadpoint/twin/run/operating_points.hpp"
#include "deadpoint/twin/run/run_reduced.hpp"
#include "near.hpp"

#include <algorithm>
#include <doctest/doctest.h>
#include <filesystem>

using namespace deadpoint;

namespace {

casefile::Case made_press(const std::vector<std::string>& overrides = {})
{
    return casefile::read_case(DEADPOINT_SOURCE_DIR "/cases/starter-by-laws/case.toml", overrides).value;
}

const Machine& machine()
{
    static const Machine built = [] {
        Observer quiet;
        return full::prepare_machine(made_press(), 3, quiet);
    }();
    return built;
}

HeatProblem problem(const std::vector<std::string>& overrides = {})
{
    Observer quiet;
    const auto input = made_press(overrides);
    const auto loads = press::compute_loads(input, &machine(), 0);
    return press::describe_heat(input, machine(), quiet, &loads);
}

twin::SplitProblem nominal(const std::vector<std::string>& overrides = {})
{
    auto split = twin::split_by_part(problem(overrides), machine());
    split.problem = twin::with_nominal_films(split.problem, 293.15);
    return split;
}

twin::SplitProblem nominal_of(const casefile::Case& input)
{
    Observer quiet;
    const auto loads = press::compute_loads(input, &machine(), press::first_running_segment(input));
    auto split = twin::split_by_part(press::describe_heat(input, machine(), quiet, &loads), machine());
    split.problem = twin::with_nominal_films(split.problem, 293.15);
    return split;
}

/// Before or after the operation.
casefile::Case with_break(bool first)
{
    auto input = made_press();
    auto rest = input.operation.front();
    rest.speed = 0;
    input.operation.insert(first ? input.operation.begin() : input.operation.end(), rest);
    return input;
}

}  // namespace

TEST_CASE("the pieces of a surface have its area, its law and one part each")
{
    const auto whole = problem();
    const auto split = twin::split_by_part(whole, machine());
    REQUIRE(split.problem.surfaces.size() == split.whole.size());
    CHECK(split.problem.surfaces.size() > whole.surfaces.size());
    std::vector<double> area;
    for (const auto& piece : split.problem.surfaces) {
        const auto& shares = machine().surfaces[static_cast<std::size_t>(piece.surface)].figures.parts;
        const auto found = std::ranges::find(shares, static_cast<std::uint32_t>(piece.part), &SurfaceShare::part);
        REQUIRE(found != shares.end());
        area.push_back(found->area);
    }
    const auto sums = twin::summed(split, area, whole.surfaces.size());
    for (std::size_t s = 0; s < sums.size(); ++s)
        CHECK(sums[s] == near(machine().surfaces[static_cast<std::size_t>(whole.surfaces[s].surface)].area, 1e-5));
}

TEST_CASE("pieces exchange as much radiation as the surfaces they make up")
{
    auto whole = problem();
    whole.radiation = {{{0, 1}, {0.5, 1.5, 1.5, 0.25}}};
    const auto split = twin::split_by_part(whole, machine());
    REQUIRE(split.problem.radiation.size() == 1);
    const auto& room = split.problem.radiation[0];
    const std::size_t count = room.surfaces.size();
    REQUIRE(room.exchange.size() == count * count);
    std::vector<double> sums(4, 0.0);
    for (std::size_t p = 0; p < count; ++p)
        for (std::size_t q = 0; q < count; ++q) {
            const auto i = split.whole[static_cast<std::size_t>(room.surfaces[p])];
            const auto j = split.whole[static_cast<std::size_t>(room.surfaces[q])];
            sums[2 * i + j] += room.exchange[p * count + q];
            CHECK(room.exchange[p * count + q] == near(room.exchange[q * count + p], 1e-5));
        }
    for (std::size_t k = 0; k < 4; ++k)
        CHECK(sums[k] == near(whole.radiation[0].exchange[k], 1e-5));
}

TEST_CASE("a nominal film gives off the heat of its law at 20 K above the start")
{
    const auto stated = twin::split_by_part(problem(), machine()).problem;
    const auto constant = nominal().problem;
    bool some = false;
    for (std::size_t s = 0; s < stated.surfaces.size(); ++s) {
        const auto& condition = stated.surfaces[s];
        if (!heat::follows_temperature(condition))
            continue;
        some = true;
        const auto law = condition.laws.front()(293.15)(313.15);
        const double radiation =
            condition.emissivity * heat::stefan_boltzmann * (std::pow(313.15, 4) - std::pow(293.15, 4));
        CHECK(20 * constant.surfaces[s].coefficient == near(20 * law.value + radiation, 1e-5));
        CHECK(!heat::follows_temperature(constant.surfaces[s]));
    }
    CHECK(some);
}

TEST_CASE("the box names every coefficient once, and the case lies in it")
{
    const auto split = nominal();
    const auto box = twin::free_coefficients(split, machine(), {}, 293.15);
    const auto films = std::ranges::count(box, reduce::FreeCoefficient::Kind::film, &reduce::FreeCoefficient::kind);
    const auto sides = std::ranges::count(box, reduce::FreeCoefficient::Kind::side, &reduce::FreeCoefficient::kind);
    CHECK(films == static_cast<long>(split.problem.surfaces.size()));
    CHECK(sides == 2 * static_cast<long>(split.problem.interfaces.size()));
    for (const auto& one : box)
        CHECK(std::ranges::count(box, one.name, &reduce::FreeCoefficient::name) == 1);
    CHECK(twin::outside_of(box, split, 293.15).empty());
    twin::FreeRanges together;
    together.by_piece = false;
    CHECK(twin::free_coefficients(split, machine(), together, 293.15).size() < box.size());
    twin::FreeRanges held;
    held.film = held.side = held.oil = held.heat = {1, 1};
    const auto of_held = twin::free_coefficients(split, machine(), held, 293.15);
    CHECK(std::ranges::count_if(of_held, [](const auto& one) { return one.from < one.to; }) == 2);  // temperatures
    CHECK(twin::outside_of(of_held, split, 293.15).empty());
    auto other = split;
    other.problem.surfaces[0].coefficient *= 1.01;
    CHECK(twin::outside_of(of_held, other, 293.15).size() == 1);
}

TEST_CASE("what lies outside the box is named with its value and its range")
{
    const auto split = nominal();
    const auto box = twin::free_coefficients(split, machine(), {}, 293.15);
    auto changed = split;
    changed.problem.surfaces[0].coefficient *= 7;
    changed.problem.interfaces[0].film_a *= 0.05;
    for (auto& segment : changed.problem.segments)
        segment.interfaces = changed.problem.interfaces;
    const auto found = twin::outside_of(box, changed, 293.15);
    REQUIRE(found.size() == 2);
    CHECK(found[0].find(": 7 to 7, trained 0.2 to 5 times") != std::string::npos);
    CHECK(found[1].find(": 0.05 to 0.05, trained 0.1 to 10 times") != std::string::npos);
    auto hot = split;
    for (auto& source : hot.problem.sources)
        source.share *= 4;
    CHECK(twin::outside_of(box, hot, 293.15).size() == hot.problem.sources.size());
    auto other_friction = split;  // a case may have other friction laws, which a model does not know
    other_friction.problem.sources.clear();
    CHECK(twin::outside_of(box, other_friction, 293.15).empty());
    const auto warm = twin::outside_of(box, nominal({"operation.0.ambient=45 degC"}), 293.15);
    REQUIRE(warm.size() == 1);
    CHECK(warm[0] == "ambient: 25 to 25, trained -10 to 10 K");
}

TEST_CASE("breaks are inside of the range, and friction outside of it is named, also where a case begins at rest")
{
    const auto running = nominal();
    const auto box = twin::free_coefficients(running, machine(), {}, 293.15);
    const auto names_friction = [](const std::vector<std::string>& texts) {
        return std::ranges::count_if(texts, [](const auto& text) { return text.starts_with("friction."); });
    };
    for (const bool first : {false, true}) {
        auto split = nominal_of(with_break(first));
        const auto own = twin::free_coefficients(split, machine(), {}, 293.15);
        CHECK(names_friction(twin::outside_of(box, split, 293.15)) == 0);
        CHECK(twin::outside_of(own, split, 293.15).empty());
        for (std::size_t k = 0; k < own.size(); ++k)
            if (own[k].kind == reduce::FreeCoefficient::Kind::heat ||
                own[k].kind == reduce::FreeCoefficient::Kind::oil) {
                CAPTURE(own[k].name);
                CHECK(own[k].base.front() == near(box[k].base.front(), 1e-12));  // of the segment that runs
            }
        for (auto& source : split.problem.sources)
            source.share *= 6;
        for (const auto& of : {box, own})
            CHECK(names_friction(twin::outside_of(of, split, 293.15)) == std::ssize(split.problem.sources));
    }
}

TEST_CASE("the range of friction holds all running segments of the reduced case, and no other friction law")
{
    auto input = made_press();
    input.operation.push_back(input.operation.front());
    input.operation.back().speed *= 0.2;
    const auto split = nominal_of(input);
    const auto box = twin::free_coefficients(split, machine(), {}, 293.15);
    CHECK_FALSE(twin::outside_of(box, split, 293.15).empty());
    CHECK(twin::outside_of(twin::with_heat_of(box, split, {}, 293.15), split, 293.15).empty());
    auto other = nominal();
    other.problem.sources[0].name = "other";
    const auto found = twin::outside_of(twin::free_coefficients(nominal(), machine(), {}, 293.15), other, 293.15);
    REQUIRE(found.size() == 1);
    CHECK(found[0] == "friction.other: the reduced case has no such friction law");
}

TEST_CASE("members of a coefficient are found by name in a case with other friction laws")
{
    const auto split = nominal();
    auto problem = split.problem;
    std::ranges::reverse(problem.sources);
    for (const auto& coefficient : twin::free_coefficients(split, machine(), {}, 293.15)) {
        if (coefficient.kind != reduce::FreeCoefficient::Kind::heat)
            continue;
        const auto here = twin::in_problem(coefficient, problem);
        REQUIRE(here.members.size() == 1);
        CHECK(twin::heat_name(problem.sources[here.members[0]]) == coefficient.name);
        auto foreign = coefficient;
        foreign.members = {1000};  // as in a file of another program
        CHECK(twin::in_problem(foreign, problem).members == here.members);
    }
    problem.sources.clear();
    auto unknown = twin::free_coefficients(split, machine(), {}, 293.15);
    for (auto& coefficient : unknown)
        if (coefficient.kind == reduce::FreeCoefficient::Kind::heat)
            CHECK(twin::in_problem(coefficient, problem).members.empty());
}

TEST_CASE("what the reduced case has not is named without a number")
{
    const auto split = nominal();
    auto box = twin::free_coefficients(split, machine(), {}, 293.15);
    std::erase_if(box, [](const auto& one) { return one.kind != reduce::FreeCoefficient::Kind::heat; });
    box.resize(1);
    box[0].base = {0};
    auto alone = split;
    const auto found = twin::outside_of(box, alone, 293.15);
    REQUIRE_FALSE(found.empty());
    CHECK(found[0] == box[0].name + ": there is none in the reduced case");
}

TEST_CASE("the air that a film states for itself counts, from its own of the reduced case")
{
    const auto split = nominal();
    const auto room = twin::free_coefficients(split, machine(), {}, 293.15);
    auto warm = split;
    warm.problem.surfaces[1].ambient = [](double) { return 293.15 + 25; };
    const auto found = twin::outside_of(room, warm, 293.15);
    REQUIRE(found.size() == 1);
    CHECK(found[0] == "ambient: 0 to 25, trained -10 to 10 K");
    const auto own = twin::free_coefficients(warm, machine(), {}, 293.15);
    CHECK(twin::outside_of(own, warm, 293.15).empty());
}

TEST_CASE("oil of any joint counts in any segment, where it carries heat away")
{
    auto split = nominal();
    auto& problem = split.problem;
    problem.oil.clear();  // whose temperature would count instead
    problem.interfaces[1].oil = 100;
    problem.segments.front().interfaces = problem.interfaces;
    const auto box = twin::free_coefficients(split, machine(), {}, 293.15);
    problem.segments.push_back(problem.segments.front());
    auto laws = problem.interfaces;
    laws[1].oil_temperature += 30;
    laws[0].oil_temperature += 90;
    laws[0].oil = 0;  // its oil carries nothing
    problem.segments.back().interfaces = laws;
    const auto found = twin::outside_of(box, split, 293.15);
    REQUIRE(found.size() == 1);
    CHECK(found[0] == "oil temperature: 0 to 30, trained -10 to 20 K");
}

TEST_CASE("laws of convection count in each segment, and the box is as wide as those of the reduced case")
{
    auto split = twin::split_by_part(problem(), machine());
    for (auto& surface : split.problem.surfaces)
        surface.emissivity = 0;  // convection alone
    const auto one = twin::free_coefficients(split, machine(), {}, 293.15);
    CHECK(twin::outside_of(one, split, 293.15).empty());
    auto& problem = split.problem;
    problem.segments.push_back(problem.segments.front());
    std::size_t by_law = 0;
    for (auto& surface : problem.surfaces)
        if (!surface.laws.empty()) {
            const auto law = surface.laws.front();
            surface.laws.push_back(FilmLawAt([law](double ambient) {
                return FilmLaw([of = law(ambient)](double temperature) {
                    const auto value = of(temperature);
                    return LawValue{9 * value.value, 9 * value.slope, value.in_range};
                });
            }));
            ++by_law;
        }
    REQUIRE(by_law > 0);
    CHECK(twin::outside_of(one, split, 293.15).size() == by_law);
    const auto both = twin::free_coefficients(split, machine(), {}, 293.15);
    CHECK(twin::outside_of(both, split, 293.15).empty());
    const auto widest = std::ranges::max_element(
        both, {}, [](const auto& c) { return c.kind == reduce::FreeCoefficient::Kind::film ? c.to : 0.0; });
    CHECK(widest->to == near(45, 1e-5));  // nine times five
}

TEST_CASE("a range of speeds brings their friction heat, and the box is as wide as that")
{
    twin::FreeRanges ranges;
    ranges.film = ranges.side = ranges.oil = ranges.heat = {1, 1};
    const Observer observer;
    CHECK(twin::other_operation(made_press(), machine(), ranges, observer).empty());
    ranges.speed = {0.5, 1};
    const auto split = nominal();
    const auto others = twin::other_operation(made_press(), machine(), ranges, observer);
    REQUIRE(others.size() == 24);  // four corners and twenty drawn
    const auto slow = nominal({"operation.0.speed=30 rpm"});
    const auto points = twin::with_heat_of(split.problem, others);
    REQUIRE(points.size() == 25);
    for (std::size_t source = 0; source < split.problem.sources.size(); ++source) {
        const auto heat = [&](const HeatProblem& of) { return of.segments[0].heat[source](300).value; };
        CHECK(heat(points[1]) == near(heat(slow.problem), 1e-12));
        CHECK(heat(points[1]) < 0.6 * heat(points[0]));  // of Coulomb friction half, of viscous a quarter
    }
    const auto box = twin::free_coefficients(split, machine(), ranges, 293.15, others);
    CHECK_FALSE(twin::outside_of(box, slow, 293.15).empty());
    CHECK(twin::outside_of(twin::with_heat_of(box, split, others, 293.15), slow, 293.15).empty());
}

TEST_CASE("only what a model cannot change makes a case another press")
{
    twin::ReducedPress built;
    built.fixed_part = twin::fixed_part(made_press());
    CHECK(twin::misfits(made_press(), built).empty());
    for (const auto* change : {"operation.0.speed=71 rpm", "machine.ambient=25 degC", "output.fields=false",
                               "numerics.time_tolerance=0.01 K", "chain.press_stiffness=1e9 N/m"})
        CHECK_MESSAGE(twin::misfits(made_press({change}), built).empty(), change);
    const auto found = twin::misfits(made_press({"parts.bed.material=steel"}), built);
    REQUIRE(found.size() == 2);
    CHECK(found[0] == "only in this case: [parts.bed] material = \"steel\"");
    CHECK(found[1] == "only in the model: [parts.bed] material = \"cast_iron\"");
}

TEST_CASE("a model made before the program knew a key has its default")
{
    twin::ReducedPress built;
    built.fixed_part = twin::fixed_part(made_press());
    const auto place = built.fixed_part.find("seam_tolerance = ");
    REQUIRE(place != std::string::npos);
    built.fixed_part.erase(place, built.fixed_part.find('\n', place) + 1 - place);
    CHECK(twin::misfits(made_press(), built).empty());
    const auto found = twin::misfits(made_press({"numerics.seam_tolerance=0.02 mm"}), built);
    REQUIRE(found.size() == 1);
    CHECK(found[0].starts_with("only in this case: [numerics] seam_tolerance = "));
}

TEST_CASE("a drawing is told by its content, wherever it lies")
{
    const ScratchFolder folder;
    std::filesystem::create_directories(folder.path / "one");
    std::filesystem::create_directories(folder.path / "two");
    const auto case_with = [&](const std::string& name, const std::string& text) {
        auto input = made_press();
        input.parts.begin()->second.step = folder.file(name, text).string();
        return twin::fixed_part(input);
    };
    const auto first = case_with("one/bed.step", "ISO-10303-21; a");
    CHECK(case_with("two/bed.step", "ISO-10303-21; a") == first);
    CHECK(case_with("one/bed.step", "ISO-10303-21; b") != first);
    CHECK(first.find("bed.step with content ") != std::string::npos);
}
