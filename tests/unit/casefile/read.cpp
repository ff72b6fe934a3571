#include "deadpoint/casefile/files/read.hpp"

#include "../../scratch_folder.hpp"
#include "../messages.hpp"
#include "deadpoint/casefile/describe/library.hpp"
#include "deadpoint/casefile/files/shipped.hpp"
#include "deadpoint/casefile/files/write.hpp"
#include "deadpoint/casefile/reference/reference.hpp"
#include "deadpoint/error.hpp"
#include "near.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <doctest/doctest.h>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <random>
#include <sstream>

using namespace deadpoint;
using namespace deadpoint::casefile;
using messages::has;

namespace {

namespace fs = std::filesystem;

const fs::path data = fs::path(DEADPOINT_TEST_DATA) / "casefile";

/// A folder that is removed with its contents at the end of the test.
using Scratch = ScratchFolder;

std::string error_of(const fs::path& path, const std::vector<std::string>& overrides = {})
{
    return messages::error_of<InputError>([&] { read_case(path, overrides); });
}

}  // namespace

TEST_CASE("values of a case arrive in SI")
{
    const auto result = read_case(data / "press.toml");
    const Case& c = result.value;
    CHECK(c.machine.half_model);
    CHECK(c.machine.ambient == near(293.15, 1e-15));
    CHECK(c.materials.at("HT300").youngs_modulus == 135e9);
    CHECK(c.lubricants.at("oil").viscosity.x == std::vector{293.15, 303.15});
    CHECK(c.lubricants.at("oil").viscosity.y == std::vector{70e-6, 50e-6});
    CHECK(c.bodies.at("crank").mass == 217.617);
    CHECK(c.bodies.at("crank").centre_of_mass == Vec2{0, -0.01375});
    CHECK(c.bodies.at("frame").ground);
    CHECK(std::get<CalibratedFriction>(c.friction.at("crank_bearings").law).reference_speed ==
          near(20.943951023931955, 1e-15));
    const auto& joint = c.joints.at("crank_bearing");
    CHECK(joint.elements.at(0).position == -0.292);
    CHECK(std::get<ContactResistance>(joint.interfaces.at(0).conductance).value == 6.01e-6);
    CHECK(joint.interfaces.at(0).diameter == 0.17);
    CHECK(joint.interfaces.at(0).journal);
    CHECK(joint.interfaces.at(1).heat_share == 0.5);
    CHECK(joint.interfaces.at(1).stands_still);
    CHECK(c.oil.at("crank_bearings") == 346);
    CHECK(std::get<SideFilms>(c.joints.at("guide").interfaces.at(0).conductance).b == 3e5);
    CHECK(c.bodies.at("lever").mirror);
    CHECK(c.joints.at("guide").preload == 2000);
    CHECK(c.mechanism.slide_body == "slider");
    CHECK(c.mechanism.speed.x.at(1) == near(3.14159265358979, 1e-14));
    CHECK(c.crankshaft->model == Crankshaft::Model::rigid);
    CHECK(c.crankshaft->sections.at(1).length == 0.0254);
    CHECK(c.crankshaft->sections.at(1).bore == 0.02);
    CHECK(c.crankshaft->disks.at(0).eccentricity == 1e-4);
    CHECK(c.crankshaft->bearings.at(0).stiffness == casefile::Matrix2{{{5e8, 0}, {0, 5e8}}});  // one value for both
    CHECK(c.crankshaft->bearings.at(1).stiffness == casefile::Matrix2{{{5e8, 1e7}, {-1e7, 4e8}}});
    CHECK(c.crankshaft->bearings.at(1).damping[1][1] == 20);
    CHECK(c.crankshaft->bearings.at(1).support_stiffness.value()[0][0] == 1e9);
    CHECK(c.crankshaft->belt->pulley_diameter == 0.6);
    CHECK_FALSE(c.crankshaft->throw_unbalance);
    CHECK(c.process_force->over_height.x.at(1) == 0.002);
    CHECK(c.process_force->both_ways);
    CHECK(*c.process_force->to == near(4.97418836818384, 1e-14));  // 285 deg
    CHECK(c.operation.size() == 2);
    CHECK(c.operation.at(1).ambient->constant == 291.15);
    CHECK(c.surfaces.at("air").film->ambient->table->x == std::vector{0.0, 3600.0});
    CHECK(c.surfaces.at("gib").within->min[2] == -1000);  // not limited along z
    CHECK(c.chain->drift_rate_limit == near(1e-6 / 3600, 1e-15));
    CHECK(c.output.field_times == std::vector{1800.0, 3600.0, 7200.0});
    CHECK(c.reference->rises.at("P1") == 7.8);
    CHECK(result.files.size() == 2);
}

TEST_CASE("shapes keep their order and their form")
{
    const Case c = read_case(data / "press.toml").value;
    const auto& shapes = c.parts.at("plate").shapes;
    REQUIRE(shapes.size() == 4);
    CHECK(std::get<BoxShape>(shapes[0].form).max == Vec3{0.75, 0.5, -0.2345});
    CHECK(shapes[1].operation == Shape::Operation::cut);
    CHECK(std::get<CylinderShape>(shapes[1].form).diameter == 0.26);
    CHECK(std::get<OutlineShape>(shapes[2].form).holes.at(0).at(1) == Vec2{0.002, 0.301});
    CHECK(shapes[3].operation == Shape::Operation::imprint);
    const auto& shaft = std::get<ShaftShape>(c.parts.at("shaft").shapes.at(0).form);
    CHECK(shaft.from == -0.4856);
    CHECK(shaft.sections.at(1).offset == Vec2{0, -0.025});
    CHECK(fs::path(c.parts.at("slide").step).is_absolute());
}

TEST_CASE("the library fills what a material does not state itself")
{
    const Case c = read_case(data / "press.toml").value;
    const auto& shipped = shipped_library().materials.at("C45");
    CHECK(c.materials.at("steel").density == shipped.density);
    CHECK(c.materials.at("steel").expansion == 1.3e-5);
    CHECK(c.lubricants.at("shipped").viscosity.y == shipped_library().lubricants.at("ISO-VG-32").viscosity.y);
}

TEST_CASE("shipped values")
{
    const auto& library = shipped_library();
    for (const auto& [name, material] : library.materials) {
        CAPTURE(name);
        CHECK(material.source.size() > 10);
    }
    // ASTM D341 through 32 at 40 and 5.4 at 100 degC: 86.28 at 20, 11.19 at 70 degC (computed independently); five
    // significant digits are stored.
    const auto& oil = library.lubricants.at("ISO-VG-32").viscosity;
    const auto at = [&](double celsius) {
        for (std::size_t i = 0; i < oil.x.size(); ++i) {
            if (std::abs(oil.x[i] - celsius - 273.15) < 1e-9) {
                return oil.y[i] * 1e6;
            }
        }
        return 0.0;
    };
    CHECK(at(20) == near(86.28, 1e-4));
    CHECK(at(70) == near(11.19, 5e-4));
}

TEST_CASE("shipped materials lie within what solids of presses have")
{
    const auto& materials = shipped_library().materials;
    CHECK(materials.size() >= 30);
    for (const auto& [name, m] : materials) {
        CAPTURE(name);
        CHECK((m.density > 2500 && m.density < 9000));
        CHECK((m.conductivity > 10 && m.conductivity < 400));
        CHECK((m.specific_heat > 350 && m.specific_heat < 1000));
        CHECK((m.expansion > 9e-6 && m.expansion < 25e-6));
        CHECK((m.youngs_modulus > 60e9 && m.youngs_modulus < 220e9));
        CHECK((m.poissons_ratio > 0.2 && m.poissons_ratio < 0.36));
        // Heat by volume of metals near room temperature, after Dulong and Petit: 3 R by atom, 2.4 to 4.2 MJ/m3/K.
        CHECK((m.density * m.specific_heat > 2.4e6 && m.density * m.specific_heat < 4.4e6));
    }
}

TEST_CASE("shipped oils hold ISO 3448, get thinner with temperature, and have the viscosity index they state")
{
    const std::vector<int> classes{2,   3,   5,   7,   10,  15,  22,   32,   46,   68,
                                   100, 150, 220, 320, 460, 680, 1000, 1500, 2200, 3200};
    const auto& oils = shipped_library().lubricants;
    CHECK(oils.size() >= 20);
    const auto viscosity = [](const Table& table, double celsius) {
        const auto found =
            std::ranges::find_if(table.x, [&](double x) { return std::abs(x - celsius - 273.15) < 1e-9; });
        REQUIRE(found != table.x.end());
        return table.y[static_cast<std::size_t>(found - table.x.begin())] * 1e6;
    };
    for (const auto& [name, oil] : oils) {
        CAPTURE(name);
        const int stated = std::stoi(name.substr(name.rfind('-') + 1));
        CHECK(std::ranges::find(classes, stated) != classes.end());
        CHECK(viscosity(oil.viscosity, 40) == near(stated, 0.1));  // the class is its mid-point, 10 %
        CHECK(std::ranges::adjacent_find(oil.viscosity.y, std::less_equal<>()) == oil.viscosity.y.end());
        CHECK((oil.density > 820 && oil.density < 930));
    }
    // ASTM D2270 for Y = 7.82 mm2/s at 100 degC: H = 0.05794 Y^2 + 10.5156 Y - 28.240 = 57.54, N = lg(H / U) / lg Y.
    const auto& pao = oils.at("PAO-VG-46").viscosity;
    const double y = viscosity(pao, 100), u = viscosity(pao, 40);
    const double h = 0.05794 * y * y + 10.5156 * y - 28.24;
    const double n = std::log10(h / u) / std::log10(y);
    CHECK((std::pow(10, n) - 1) / 0.00715 + 100 == near(140, 0.005));
}

TEST_CASE("a resolved case reads back as the same case")
{
    const Scratch scratch;
    const Case first = read_case(data / "press.toml").value;
    const std::string text = write_case(first);
    // A resolved case names its files by their full paths.
    CHECK_THROWS_WITH_AS(read_case(scratch.file("resolved.toml", text)), doctest::Contains("--allow-outside"),
                         InputError);
    const Case second = read_case(scratch.file("resolved.toml", text), {}, FileAccess::anywhere).value;
    CHECK(write_case(second) == text);
    CHECK(case_hash(second) == case_hash(first));
    CHECK(std::get<CalibratedFriction>(second.friction.at("crank_bearings").law).exponent ==
          std::get<CalibratedFriction>(first.friction.at("crank_bearings").law).exponent);
    CHECK(second.machine.ambient == first.machine.ambient);
    CHECK(second.machine.description == first.machine.description);
    CHECK(second.parts.at("shaft").tetrahedra);
}

TEST_CASE("the hash tells cases apart, but not ways of writing them")
{
    const auto path = data / "sound.toml";
    const auto hash = case_hash(read_case(path).value);
    CHECK(case_hash(read_case(path, {"operation.0.duration=60 min"}).value) == hash);
    CHECK(case_hash(read_case(path, {"operation.0.duration=61 min"}).value) != hash);
}

TEST_CASE("overrides")
{
    const auto path = data / "press.toml";
    const Case c = read_case(path, {"operation.0.speed=400 rpm", "numerics.size = \"20 mm\"", "parts.shaft.size=8 mm",
                                    "numerics.order=1", "output.fields=true", "parts.plate.shapes.1.bore=10 mm",
                                    "probes.P2={ part = \"plate\", position = [\"0 mm\", \"1 mm\", \"0 mm\"] }",
                                    "output.field_times=[\"1 h\"]"})
                       .value;
    CHECK(c.operation.at(0).speed == near(41.88790204786391, 1e-15));
    CHECK(c.numerics.size == 0.02);
    CHECK(c.parts.at("shaft").size == 0.008);
    CHECK(c.numerics.order == 1);
    CHECK(c.output.fields);
    CHECK(std::get<CylinderShape>(c.parts.at("plate").shapes.at(1).form).bore == 0.01);
    CHECK(c.probes.at("P2").position[1] == 0.001);
    CHECK(c.output.field_times == std::vector{3600.0});

    CHECK(has(error_of(path, {"operation.7.speed=400 rpm"}), "'7' is not one of the 2 items"));
    CHECK(has(error_of(path, {"operation.2.speed=400 rpm"}),
              "to add one, give all of its keys: operation.2={duration=\"1 h\", speed=\"300 rpm\", force=\"0 N\"}"));
    const auto longer =
        read_case(path, {"operation.2={duration=\"1 h\", speed=\"300 rpm\", force=\"0 N\"}", "operation.2.force=5 N"})
            .value;
    REQUIRE(longer.operation.size() == 3);
    CHECK(longer.operation[2].duration == 3600);
    CHECK(longer.operation[2].force == 5);
    CHECK(has(error_of(path, {"operation.3={duration=\"1 h\", speed=\"300 rpm\", force=\"0 N\"}"}), "'3' is not one"));
    CHECK(has(error_of(path, {"numerics.size"}), "an override is written path=value"));
    CHECK(has(error_of(path, {"numerics.size.x=1"}), "inside a single value"));
    CHECK(has(error_of(path, {"numerics.sise=1 mm"}), "did you mean 'size'?"));
    CHECK(has(error_of(path, {"numerics.size=20 kg"}), "--set:1:15: error[unit-mismatch]: numerics.size"));
}

TEST_CASE("a case file that cannot be read is an error of input and output")
{
    CHECK_THROWS_AS(read_case(data / "nowhere.toml"), IoError);
    CHECK_THROWS_AS(read_case(data), IoError);
}

TEST_CASE("a byte order mark before the text changes nothing")
{
    const Scratch scratch;
    const std::string text = content(DEADPOINT_SOURCE_DIR "/cases/starter/case.toml");
    const auto marked = scratch.file("case.toml", "\xEF\xBB\xBF" + text);
    CHECK(read_case(marked).value.machine.name == "starter press");
}

TEST_CASE("what would fill memory or screen is refused or cut short")
{
    const Scratch scratch;
    const auto said = [&](const std::string& text) { return error_of(scratch.file("case.toml", text), {}); };
    std::string names = "format = 1\n[parts]\n";
    for (int i = 0; i <= 10'000; ++i)
        names += fmt::format("p{} = 1\n", i);
    CHECK(has(said(names), "a table of more than 10000 names"));
    std::string values = "x = [0";
    for (int i = 0; i < 1'000'000; ++i)
        values += ",0";
    CHECK(has(said(values + "]\n"), "there are too many values"));

    // Each mistake would quote the whole line.
    std::string line = "format = 1\nnumerics = { ";
    for (int i = 0; i < 5000; ++i)
        line += fmt::format("x{} = 1, ", i);
    const auto flood = said(line + "y = 1 }\n");
    CHECK(flood.size() < 500'000);
    CHECK(has(flood, "there is no key 'x1' here"));
    const std::string mark = "\n... and ";
    const auto at = flood.find(mark);
    REQUIRE(at != std::string::npos);
    const int more = std::atoi(flood.c_str() + at + mark.size());
    CHECK(more >= 5001 - 200);
    CHECK(has(flood, fmt::format(" more\n\n{} errors in the case file", more + 200)));

    const auto start = said("x = [" + std::string(3000, ' ') + "]\n[numerics]\nsize = \"1 kg\"\n");
    CHECK(has(start, "unknown-key"));
    const auto far = said("numerics = { " + std::string(3000, ' ') + "size = \"1 kg\" }\n");
    CHECK(has(far,
              "| " + std::string(300 - 7, ' ') + "size = \"1 kg\" }\n       | " + std::string(300, ' ') + "^^^^^^\n"));
}

TEST_CASE("a file that is included over and over is not read over and over")
{
    const Scratch scratch;
    (void)scratch.file("part.toml", "# " + std::string(5'000'000, 'x') + "\n");
    std::string text = "include = [";
    for (int i = 0; i < 20; ++i)
        text += "\"part.toml\", ";
    CHECK(has(error_of(scratch.file("case.toml", text + "]\n"), {}), "larger than 32 MiB"));
}

TEST_CASE("malformed texts end in a message, not in the parser")
{
    const Scratch scratch;
    for (const char* text : {"x = [}",
                             "[/a]",
                             "[",
                             "[]",
                             "[[",
                             "=",
                             "x",
                             "x =",
                             "x = \"",
                             "x = '''",
                             "x = \"\\",
                             "x = {",
                             "x = 1 2",
                             "x = 01",
                             "\xff",
                             "x = \"\xff\"",
                             "\xc3\xa9 = 1",
                             "x = \u201ca\u201d",
                             "a.b = 1\na = 2",
                             "[a]\n[a]",
                             "x = 1e",
                             "x = 0x",
                             "x = 1979-99-99",
                             "x = \"\\q\"",
                             "]",
                             "x = [1,,2]",
                             "x={a=1,}"}) {
        CAPTURE(text);
        CHECK(error_of(scratch.file("broken.toml", text)) != "");
    }
}

TEST_CASE("a body that nothing uses is a warning, not an error")
{
    const auto result = read_case(data / "sound.toml", {"bodies.spare.thermal_only=true"});
    REQUIRE(result.warnings.size() == 1);
    CHECK(has(result.warnings.at(0), "body 'spare' has no part and no joint"));
}

TEST_CASE("what a case states of its slide and its process force without effect is a warning with its place")
{
    const Scratch scratch;
    const std::string head =
        "format = 1\n[machine]\nname = \"linkage\"\n[bodies.frame]\nground = true\n[bodies.crank]\n"
        "mass = \"1 kg\"\n[joints.main]\nkind = \"revolute\"\nbodies = [\"crank\", \"frame\"]\n"
        "centre = [\"0 mm\", \"0 mm\"]\ndriver = true\n";
    const auto warnings = [&](const std::string& rest) {
        return read_case(scratch.file("case.toml", head + rest)).warnings;
    };
    const std::string runs = "[[operation]]\nspeed = \"60 rpm\"\n";
    const auto free = warnings(runs + "[mechanism]\nslide_body = \"crank\"\n");
    REQUIRE(free.size() == 1);
    CHECK(has(free[0], "no guide holds 'crank'"));
    CHECK(has(free[0], "case.toml:16"));
    const std::string works = runs + "force = \"1 kN\"\n";
    const auto elastic = warnings(works + "[process_force]\nkind = \"elastic\"\nfrom = \"200 deg\"\n");
    REQUIRE(elastic.size() == 1);
    CHECK(has(elastic[0], "'from' has no effect"));
    CHECK(has(elastic[0], "case.toml:18"));
    CHECK(warnings(works + "[process_force]\nkind = \"half_sine\"\nfrom = \"200 deg\"\n").empty());
    const auto idle = warnings(runs + "[process_force]\nkind = \"half_sine\"\n");
    REQUIRE(idle.size() == 1);
    CHECK(has(idle[0], "every segment of [[operation]] has a force of 0"));
}

TEST_CASE("a case for loads needs neither parts nor materials, surfaces or durations")
{
    const Scratch scratch;
    const std::string text =
        "format = 1\n[machine]\nname = \"linkage\"\n[bodies.frame]\nground = true\n[bodies.crank]\n"
        "mass = \"1 kg\"\n[joints.main]\nkind = \"revolute\"\nbodies = [\"crank\", \"frame\"]\n"
        "centre = [\"0 mm\", \"0 mm\"]\ndriver = true\n[[operation]]\nspeed = \"60 rpm\"\n";
    const auto result = read_case(scratch.file("case.toml", text));
    CHECK(result.warnings.empty());
    CHECK(result.value.parts.empty());
    CHECK(result.value.operation.at(0).duration == 0);
}

TEST_CASE("the starter case is sound and means the same when written back")
{
    const Scratch scratch;
    const auto result = read_case(scratch.file("case.toml", starter_case()));
    CHECK(result.warnings.empty());
    const std::string text = write_case(result.value);
    CHECK(write_case(read_case(scratch.file("resolved.toml", text)).value) == text);
}

TEST_CASE("laws of conductance and film and a daily course mean the same when written back")
{
    const Scratch scratch;
    const auto c = read_case(DEADPOINT_SOURCE_DIR "/cases/starter-by-laws/case.toml").value;
    CHECK(std::get<RoughContact>(c.joints.at("guide").interfaces.at(0).conductance).roughness == 1.1e-6);
    CHECK(std::get<RoundFilm>(c.surfaces.at("flywheel_rim").film->law).form == RoundFilm::Form::rotating_cylinder);
    const auto& daily = c.operation.at(0).ambient->daily;
    REQUIRE(daily);
    CHECK(daily->mean == 293.15);
    CHECK(daily->amplitude == 2);
    CHECK(daily->time_of_maximum == 6 * 3600);
    CHECK(daily->period == 86400);
    const std::string text = write_case(c);
    CHECK(write_case(read_case(scratch.file("resolved.toml", text)).value) == text);
}

TEST_CASE("docs/case-file.md is the reference page of this program")
{
    // To renew the page, run this test with DEADPOINT_RENEW_DOCS=1.
    const fs::path page = DEADPOINT_SOURCE_DIR "/docs/case-file.md";
    if (std::getenv("DEADPOINT_RENEW_DOCS") != nullptr) {
        std::ofstream(page) << reference_page();
    }
    std::ifstream stream(page);
    std::ostringstream text;
    text << stream.rdbuf();
    CHECK(text.str() == reference_page());
}
