#include "deadpoint/report/page/named_things.hpp"

#include "deadpoint/casefile/describe/case.hpp"

#include <doctest/doctest.h>

using namespace deadpoint;
using report::NamedThing;
using Kind = report::NamedThing::Kind;

namespace {

casefile::Case small_case()
{
    casefile::Case input;
    for (const char* part : {"frame", "bush", "shaft"})
        input.parts[part] = {};
    input.bodies["crank"] = {};
    input.surfaces["table"] = {};
    input.probes["top"] = {};
    casefile::Interface bore;
    bore.name = "bore";
    input.joints["crank_pin"].interfaces = {bore};
    input.chain = casefile::Chain{};
    input.chain->table_surface = "table";
    input.heat_sources["motor"].parts = {"s*"};
    return input;
}

std::vector<NamedThing> things(const std::string& path, const std::string& message = {})
{
    Diagnostic found;
    found.path = path;
    found.message = message;
    return report::things_of(found, small_case());
}

}  // namespace

TEST_CASE("the path of a finding leads to what it is about")
{
    using List = std::vector<NamedThing>;
    CHECK(things("parts.bush.shapes.0.bore") == List{{Kind::part, "bush"}});
    CHECK(things("joints.crank_pin.centre") == List{{Kind::joint, "crank_pin"}});
    CHECK(things("joints.crank_pin.interfaces.0.a") == List{{Kind::interface, "crank_pin.bore"}});
    CHECK(things("joints.crank_pin.interfaces.bore.b") == List{{Kind::interface, "crank_pin.bore"}});
    CHECK(things("joints.crank_pin.interfaces.7.b") == List{{Kind::joint, "crank_pin"}});
    CHECK(things("probes.top.position") == List{{Kind::probe, "top"}});
    CHECK(things("chain.table_surface") == List{{Kind::surface, "table"}});
    CHECK(things("bodies.crank.mass") == List{{Kind::body, "crank"}});
    CHECK(things("heat_sources.motor.power") == List{{Kind::part, "shaft"}});
    CHECK(things("numerics.size").empty());
    CHECK(things("parts.unknown").empty());
}

TEST_CASE("a finding without a path is about what its message names")
{
    const auto found = things("numerics", "parts 'frame' and 'bush' overlap, see joints.crank_pin and 'nobody'");
    REQUIRE(found.size() == 3);
    CHECK(found[0] == NamedThing{Kind::joint, "crank_pin"});
    CHECK(found[1] == NamedThing{Kind::part, "frame"});
    CHECK(found[2] == NamedThing{Kind::part, "bush"});
    CHECK(things("", "interface 'crank_pin.bore': 80 %")[0] == NamedThing{Kind::interface, "crank_pin.bore"});
    CHECK(things("parts.shaft", "touches 'frame'") == std::vector<NamedThing>{{Kind::part, "shaft"}});
}

TEST_CASE("a warning as shown is taken apart again")
{
    const auto full =
        report::taken_apart("a/case.toml:12:5: warning[mass]: bodies.slide.mass\n  body 'slide' is light\n"
                            "    12 | mass = 3\n       | ^^^^\n  help: correct the mass");
    CHECK(full.severity == DiagnosticSeverity::warning);
    CHECK(full.place.file == "a/case.toml");
    CHECK(full.place.line == 12);
    CHECK(full.place.column == 5);
    CHECK(full.code == "mass");
    CHECK(full.path == "bodies.slide.mass");
    CHECK(full.message == "body 'slide' is light");
    CHECK(full.help == "correct the mass");
    const auto plain = report::taken_apart("part 'a' keeps its cells");
    CHECK(plain.message == "part 'a' keeps its cells");
    CHECK(plain.path.empty());
}
