#include "../record.hpp"
#include "../scratch_folder.hpp"
#include "near.hpp"
#include "solved_case.hpp"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <sstream>
#include <tuple>

// What must not change the answer, and limits that are known exactly.

using namespace verification;

namespace {

constexpr const char* shaft_in_block = "shaft-in-block";

// All conductances and heat sources of a case times `factor`.
Case with_conduction_times(Case input, double factor)
{
    for (auto& [name, material] : input.materials)
        material.conductivity *= factor;
    for (auto& [name, law] : input.friction) {
        auto& calibrated = std::get<casefile::CalibratedFriction>(law.law);
        calibrated.load_part *= factor;
        calibrated.viscous_part *= factor;
    }
    for (auto& [name, joint] : input.joints)
        for (auto& interface : joint.interfaces) {
            if (auto* sides = std::get_if<casefile::SideFilms>(&interface.conductance))
                *sides = {sides->a * factor, sides->b * factor};
            interface.oil *= factor;
        }
    for (auto& [name, surface] : input.surfaces)
        if (surface.film)
            *std::get<casefile::FilmCoefficient>(surface.film->law).value *= factor;
    return input;
}

std::string text_of(const std::string& name)
{
    std::ifstream file(std::string(DEADPOINT_VERIFICATION_CASES) + "/" + name + ".toml");
    std::ostringstream text;
    text << file.rdbuf();
    REQUIRE(text.str().size() > 100);
    return text.str();
}

Case read_text(const std::string& text)
{
    const ScratchFolder folder;
    return deadpoint::casefile::read_case(folder.file("case.toml", text)).value;
}

// The tables of a case file in reverse order.
std::string reversed(const std::string& text)
{
    std::vector<std::string> tables{""};
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        if (!line.empty() && line.front() == '[')
            tables.emplace_back();
        tables.back() += line + "\n";
    }
    std::string result = tables.front();
    for (std::size_t i = tables.size() - 1; i > 0; --i)
        result += tables[i];
    return result;
}

// Every length in mm written in inches instead.
std::string in_inches(const std::string& text)
{
    const std::regex length("\"(-?[0-9.]+) mm\"");
    std::string result;
    auto from = text.cbegin();
    for (std::sregex_iterator match(text.begin(), text.end(), length), end; match != end; ++match) {
        std::ostringstream inches;
        inches.precision(17);
        inches << '"' << std::stod((*match)[1]) / 25.4 << " in\"";
        result.append(from, (*match)[0].first);
        result += inches.str();
        from = (*match)[0].second;
    }
    result.append(from, text.cend());
    return result;
}

}  // namespace

TEST_CASE("only ratios count: twice every conductivity, capacity, film and heat")
{
    const auto base = solve(shaft_in_block);
    REQUIRE(largest_rise(base) > 5);
    REQUIRE(base.history().to_oil.back() > 1);
    auto twice = with_conduction_times(base.input, 2);
    for (auto& [name, material] : twice.materials)
        material.specific_heat *= 2;
    // Doubling is exact in floating point; the linear solver stops at 1e-11 K.
    record({"twice k, c, films, oil and heat: largest change", "invariance", "K", 0, 1e-7, "solver tolerance"},
           largest_difference(base, solve(twice)));
}

TEST_CASE("only ratios count: without the capacity, the same curve at half the time")
{
    const auto base = solve(shaft_in_block);
    auto fast = with_conduction_times(base.input, 2);
    fast.operation.front().duration /= 2;
    fast.numerics.initial_step /= 2;
    fast.numerics.max_step /= 2;
    record({"twice k, films, oil and heat: the same at half the time", "invariance", "K", 0, 1e-7, "solver tolerance"},
           largest_difference(base, solve(fast), 0.5));
}

TEST_CASE("the order of the case file does not matter")
{
    const auto text = text_of(shaft_in_block);
    const auto other = reversed(text);
    REQUIRE(other != text);
    // The same to the last digits that sums in memory of other alignment may change.
    record({"tables of the case file in reverse order: largest change", "invariance", "K", 0, 1e-9, "rounding"},
           largest_difference(solve(shaft_in_block), solve(read_text(other))));
}

TEST_CASE("inches give the same as millimetres")
{
    const auto other = in_inches(text_of(shaft_in_block));
    REQUIRE(other.find(" mm\"") == std::string::npos);
    const auto base = solve(shaft_in_block), inches = solve(read_text(other));
    REQUIRE(base.machine.nodes.size() == inches.machine.nodes.size());
    // Lengths differ in their last digit only.
    record({"lengths in inches: largest change", "invariance", "K", 0, 1e-7, "lengths differ in their last digit"},
           largest_difference(base, inches));
}

TEST_CASE("inches give the same drift as millimetres")
{
    constexpr const char* starter = "../../../cases/starter/case";
    const auto run = [](const std::string& text) {
        auto input = read_text(text);
        input.operation.front().duration = 300;
        input.numerics.time_tolerance = 0.5;
        input.numerics.solver_tolerance = 1e-11;
        input.output.fields = false;
        return solve(input, 3);
    };
    const auto text = text_of(starter);
    const auto base = run(text), inches = run(in_inches(text));
    CHECK(base.machine.cells.size() == inches.machine.cells.size());
    const auto& gap = base.result.drift.value().gap.value;
    const auto& other = inches.result.drift.value().gap.value;
    REQUIRE(gap.size() == other.size());
    REQUIRE(std::abs(gap.back()) > 1e-7);
    double largest = 0;
    for (std::size_t i = 0; i < gap.size(); ++i)
        largest = std::max(largest, 1e6 * std::abs(gap[i] - other[i]));
    CHECK(largest < 1e-7);
}

namespace {

using deadpoint::operator+;

using Place = std::function<deadpoint::Vec3(const deadpoint::Vec3&)>;

/// A machine of boxes and of cylinders along z, its joints about z too, with every place taken elsewhere.
Case with_places(Case input, const Place& moved)
{
    for (auto& [name, part] : input.parts)
        for (auto& shape : part.shapes)
            if (auto* box = std::get_if<deadpoint::BoxShape>(&shape.form)) {
                const auto a = moved(box->min), b = moved(box->max);
                for (std::size_t i = 0; i < 3; ++i)
                    std::tie(box->min[i], box->max[i]) = std::minmax(a[i], b[i]);
            } else {
                auto& round = std::get<deadpoint::CylinderShape>(shape.form);
                const auto from = moved({round.centre[0], round.centre[1], round.from});
                round.to = moved({round.centre[0], round.centre[1], round.to})[2];
                round.centre = {from[0], from[1]};
                round.from = from[2];
            }
    for (auto& [name, joint] : input.joints) {
        const auto centre = moved({joint.centre[0], joint.centre[1], 0});
        joint.centre = {centre[0], centre[1]};
    }
    for (auto& [name, probe] : input.probes)
        probe.position = moved(probe.position);
    return input;
}

}  // namespace

TEST_CASE("a machine elsewhere, or turned by 90 degrees, keeps its temperatures")
{
    const auto base = solve(shaft_in_block);
    const std::map<std::string, Place> places{{"moved by more than a metre",
                                               [](const deadpoint::Vec3& x) {
                                                   return x + deadpoint::Vec3{1.2345678, -0.7654321, 2.1};
                                               }},
                                              {"turned by 90 degrees",
                                               [](const deadpoint::Vec3& x) {
                                                   return deadpoint::Vec3{-x[1], x[0], x[2]};
                                               }},
                                              {"turned by 180 degrees", [](const deadpoint::Vec3& x) {
                                                   return deadpoint::Vec3{-x[0], -x[1], x[2]};
                                               }}};
    for (const auto& [what, moved] : places) {
        CAPTURE(what);
        const auto other = solve(with_places(base.input, moved));
        CHECK(other.machine.cells.size() == base.machine.cells.size());
        // within what the solver leaves of its residual
        CHECK(largest_difference(base, other) < 1e-7);
    }
}

TEST_CASE("the names of parts, and so their order, do not matter")
{
    auto text = text_of(shaft_in_block);
    // "block" comes before "shaft"; as "yoke" it comes after.
    text = std::regex_replace(text, std::regex("parts\\.block"), "parts.yoke");
    text = std::regex_replace(text, std::regex("a = \"block\""), "a = \"yoke\"");
    text = std::regex_replace(text, std::regex("part = \"block\""), "part = \"yoke\"");
    const auto base = solve(shaft_in_block), other = solve(read_text(text));
    CHECK(other.machine.parts.back().name == "yoke");
    CHECK(largest_difference(base, other) < 1e-7);
}

TEST_CASE("a segment of operation cut in two gives the same")
{
    const auto base = solve(shaft_in_block);
    auto cut = base.input;
    cut.operation.push_back(cut.operation.front());
    cut.operation[0].duration *= 0.4;
    cut.operation[1].duration *= 0.6;
    const auto solved = solve(cut);
    CHECK(solved.history().time.back() == near(3600, 1e-12));
    // The steps are others; each may err by the 0.002 K of the case, and errors of steps fade.
    record({"one segment cut in two: largest change", "invariance", "K", 0, 0.02, "ten steps of 0.002 K"},
           largest_difference(base, solved));
    CHECK(largest_difference(base, solved) > 0);
}

TEST_CASE("the sides of an interface swapped give the same")
{
    const std::string path = "joints.bearing.interfaces.0.";
    const auto base = solve(shaft_in_block);
    const auto swapped =
        solve(shaft_in_block, {path + "a=shaft", path + "b=block", path + "conductance.side_a=2000 W/m^2/K",
                               path + "conductance.side_b=3000 W/m^2/K", "surfaces.shaft_seat.parts=[\"shaft\"]",
                               "surfaces.shaft_seat.select=cylinder", "surfaces.shaft_seat.axis=z",
                               "surfaces.shaft_seat.centre=[\"0 mm\", \"0 mm\"]", "surfaces.shaft_seat.diameter=50 mm",
                               path + "a=shaft_seat", "surfaces.shaft_seat.within.z=[\"0 mm\", \"40 mm\"]"});
    // The chord heights and the axial strips of the other mesh: 1 % of the rise.
    CHECK(std::abs(base.side_a() - swapped.side_b()) < 0.01 * largest_rise(base));
    CHECK(std::abs(base.side_b() - swapped.side_a()) < 0.01 * largest_rise(base));
    CHECK(swapped.machine.interfaces[0].area == near(base.machine.interfaces[0].area, 1e-9));
}

TEST_CASE("joint heat is exact on any mesh")
{
    for (const double scale : {0.7, 1.0, 1.6}) {
        // 20 W without a viscous part for an hour, whatever the faceted area
        const auto solved = solve(shaft_in_block, {"friction.bearing.viscous_part=0 W"}, scale);
        record({"heat of a joint, cells times " + std::to_string(scale).substr(0, 3), "20 W for an hour", "J",
                20 * 3600, 1e-12 * 20 * 3600, "exact on any mesh; rounding"},
               solved.history().energy.generated);
        CHECK(solved.history().source_heat[0].back() == near(20, 1e-12));
    }
}

TEST_CASE("joint heat follows the viscosity at the film temperature")
{
    const auto solved = solve(shaft_in_block);
    // log-linear viscosity of the case between 20 and 40 degC; 20 W + 2 W nu
    for (std::size_t i = 0; i < solved.history().time.size(); ++i) {
        const double film = solved.history().source_temperature[0][i] - zero_celsius;
        if (film < 20 || film > 40)
            continue;
        const double viscosity = 80 * std::pow(30.0 / 80, (film - 20) / 20);
        // A stage uses the tangent of the law, which may differ from it by 1e-5.
        CHECK(solved.history().source_heat[0][i] == near(20 + 2 * viscosity, 3e-5));
    }
    // Generated heat is the integral of the recorded heat: trapezoids against the integrator's own weights.
    double sum = 0;
    const auto& time = solved.history().time;
    for (std::size_t i = 0; i + 1 < time.size(); ++i)
        sum += 0.5 * (time[i + 1] - time[i]) *
               (solved.history().source_heat[0][i] + solved.history().source_heat[0][i + 1]);
    CHECK(solved.history().energy.generated == near(sum, 0.01));
    CHECK(solved.history().source_heat[0].front() > 1.2 * solved.history().source_heat[0].back());
}

TEST_CASE("nothing gets colder than it started or hotter than the rubbing surfaces")
{
    const auto solved = solve(shaft_in_block, {"machine.ambient=20 degC", "joints.bearing.oil_temperature=20 degC"});
    for (std::size_t i = 0; i < solved.history().time.size(); ++i)
        for (const auto& series : solved.history().part_means) {
            CHECK(series.value[i] > 20 + zero_celsius - 1e-6);
            CHECK(series.value[i] < solved.history().source_temperature[0][i] + 1e-6);
        }
}

namespace {

void check_linear_field(const std::vector<std::string>& overrides, const std::string& elements)
{
    const auto exact = [](double x, double y, double z) { return 300 + 100 * x - 250 * y + 70 * z - zero_celsius; };
    const auto solved = solve("bonded-blocks", overrides);
    REQUIRE(solved.machine.bonds.size() == 1);
    CHECK(solved.machine.bonds[0].area == near(0.035 * 0.04, 1e-9));
    double worst = 0;
    worst = std::max(worst, std::abs(solved.probe("lower") - exact(0.031, 0.033, 0.017)));
    worst = std::max(worst, std::abs(solved.probe("upper") - exact(0.023, 0.044, 0.021)));
    worst = std::max(worst, std::abs(solved.probe("bond") - exact(0.027, 0.040, 0.019)));
    record({"linear field through a bond of meshes that do not match, " + elements, "patch test", "K", 0, 1e-10,
            "exact; solver"},
           worst);
}

}  // namespace

TEST_CASE("a linear field passes a bond between meshes that do not match")
{
    check_linear_field({}, "hexahedra");
    check_linear_field({"numerics.order=2"}, "second order");
}

TEST_CASE("a linear field passes a bond between hexahedra and tetrahedra")
{
    check_linear_field({"parts.upper.tetrahedra=true"}, "hexahedra and tetrahedra");
    check_linear_field({"parts.lower.tetrahedra=true", "parts.upper.tetrahedra=true"}, "tetrahedra");
}

TEST_CASE("a linear field passes a bond between elements of first and second order")
{
    check_linear_field({"parts.upper.order=2"}, "first and second order");
    check_linear_field({"parts.lower.order=2", "parts.lower.tetrahedra=true"},
                       "first order on tetrahedra of second order");
}

TEST_CASE("a small Biot number gives the exponential")
{
    const auto solved = solve("cooling-block");
    // Biot number h (V / A) / k = 8e-7; rho c V / (h A) = 8960 * 385 * 0.02 / (6 * 0.1) s
    const double constant = 8960.0 * 385 * 0.02 / (6 * 0.1);
    for (const double hours : {5.0, 15.0, 31.0, 50.0})
        record({"Biot number of 8e-7: temperature after " + std::to_string(std::lround(hours)) + " h", "exponential",
                "degC", 20 + 60 * std::exp(-hours * 3600 / constant), 0.005, "tolerance of the steps"},
               solved.probe("corner", hours * 3600));
}

TEST_CASE("steady responses of two joints are reciprocal")
{
    const auto first = solve("three-blocks", {"friction.one.load_part=50 W", "friction.two.load_part=0 W"});
    const auto second = solve("three-blocks", {"friction.one.load_part=0 W", "friction.two.load_part=50 W"});
    const double two_by_one = first.history().source_temperature[1].back() - zero_celsius - 20;
    const double one_by_two = second.history().source_temperature[0].back() - zero_celsius - 20;
    CHECK(two_by_one > 1);
    // The system is symmetric; what is left is the approach to the steady state.
    record({"steady responses of two joints to each other's heat", "reciprocity", "K", two_by_one, 1e-6 * two_by_one,
            "approach to the steady state"},
           one_by_two);
    // Steady: what is generated leaves.
    CHECK(first.history().to_air.back() + first.history().to_oil.back() == near(50, 1e-7));
}

TEST_CASE("a machine turned in space keeps its temperatures")
{
    const auto base = read("three-blocks");
    const auto one = solve(base);
    for (const auto& axes : {std::array<std::size_t, 3>{1, 2, 0}, {2, 0, 1}, {0, 2, 1}}) {
        const auto turned = solve(with_axes(base, axes));
        REQUIRE(turned.machine.nodes.size() == one.machine.nodes.size());
        record({"machine turned in space: largest change", "invariance", "K", 0, 1e-6, "solver tolerance"},
               largest_difference(one, turned));
    }
}

TEST_CASE("half a symmetric machine stands for the whole")
{
    const auto whole = solve(shaft_in_block, {}, 0.7);
    const auto half = solve(shaft_in_block, {"machine.half_model=true"}, 0.7);
    CHECK(half.machine.interfaces[0].area == near(0.5 * whole.machine.interfaces[0].area, 1e-9));
    // Two different meshes of the same machine.
    CHECK(largest_difference(whole, half) < 0.01 * largest_rise(whole));
    CHECK(half.result.symmetry_factor * half.history().energy.generated ==
          near(whole.history().energy.generated, 0.005));
    CHECK(half.result.symmetry_factor * half.history().energy.to_air == near(whole.history().energy.to_air, 0.02));
}

TEST_CASE("half a symmetric machine of equal meshes is exact")
{
    // The bars of the contact case, laid along y and cut along their middle.
    auto bars = with_axes(read("two-slabs"), {1, 2, 0});
    for (auto& [name, part] : bars.parts) {
        auto& box = std::get<deadpoint::BoxShape>(part.shapes.front().form);
        box.min[0] = -0.001;
        box.max[0] = 0.001;
    }
    const auto whole = solve(bars);
    bars.machine.half_model = true;
    const auto half = solve(bars);
    CHECK(2 * half.result.cells == whole.result.cells);
    CHECK(largest_difference(whole, half) < 1e-7);
}

TEST_CASE("a turning joint smears what does not turn with it, and loses no heat")
{
    // Air on one side of the block only: its bore is no longer uniform.
    const std::vector<std::string> one_sided{"surfaces.air.select=plane", "surfaces.air.axis=y",
                                             "surfaces.air.position=60 mm",
                                             "surfaces.air.film.coefficient=500 W/m^2/K"};
    auto still_overrides = one_sided;
    still_overrides.push_back("joints.bearing.turns_fully=false");
    const auto turning = solve(shaft_in_block, one_sided), still = solve(shaft_in_block, still_overrides);
    // Same heat balance (checked in every run), but another field.
    CHECK(std::abs(turning.probe("block") - still.probe("block")) > 1e-3);
    CHECK(std::abs(turning.side_b() - still.side_b()) < 0.05 * largest_rise(still));
}
