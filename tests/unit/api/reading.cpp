/// Requirement: a program that reads a case learns what is wrong with it as data, as much at once as can be found.
#include "../../scratch_folder.hpp"
#include "starter.hpp"

#include <algorithm>
#include <doctest/doctest.h>

using namespace deadpoint;

namespace {

constexpr const char* broken = R"(format = 1
[machine]
name = "broken"
ambient = "20 kg"
[bodies.frame]
gruond = true
[probes.tip]
part = "nowhere"
position = ["0 mm", "0 mm", "0 mm"]
)";

const Diagnostic* at(const std::vector<Diagnostic>& found, const std::string& path)
{
    const auto entry = std::ranges::find(found, path, &Diagnostic::path);
    return entry == found.end() ? nullptr : &*entry;
}

}  // namespace

TEST_CASE("mistakes of a case are data: path, place, code, message, help")
{
    const ScratchFolder folder;
    const auto found = Press::check(folder.file("case.toml", broken));
    const auto* unit = at(found, "machine.ambient");
    REQUIRE(unit);
    CHECK(unit->severity == DiagnosticSeverity::error);
    CHECK(unit->code == "unit-mismatch");
    CHECK(unit->place.file.ends_with("case.toml"));
    CHECK(unit->place.line == 4);
    CHECK(unit->place.column == 11);
    CHECK(unit->message.find("mass") != std::string::npos);
    const auto* key = at(found, "bodies.frame.gruond");
    REQUIRE(key);
    CHECK(key->place.line == 6);
    CHECK(key->help.find("ground") != std::string::npos);
    const auto* name = at(found, "probes.tip.part");
    REQUIRE(name);
    CHECK(name->place.line == 8);
}

TEST_CASE("a case with mistakes is no press: the error holds the same list, and shows it")
{
    const ScratchFolder folder;
    const auto file = folder.file("case.toml", broken);
    const auto found = Press::check(file);
    try {
        (void)Press::read(file);
        FAIL("no error");
    } catch (const CaseError& error) {
        CHECK(error.kind() == ErrorKind::input);
        CHECK(error.diagnostics().size() == found.size());
        const std::string text = error.what();
        CHECK(text.find("case.toml:4:11: error[unit-mismatch]: machine.ambient") != std::string::npos);
        CHECK(text.find("^") != std::string::npos);
    }
}

TEST_CASE("a check has the warnings of reading, of the mesh and of the loads, each once")
{
    const auto found = Press::check(
        starter_file(), {.overrides = {"bodies.slide.mass=1 t", "output.history_interval=5 h"}, .size_scale = 3});
    const auto warnings = [&](const std::string& path) {
        return std::ranges::count_if(found, [&](const Diagnostic& one) {
            return one.path == path && one.severity == DiagnosticSeverity::warning && !one.message.empty();
        });
    };
    CHECK(warnings("output.history_interval") == 1);
    CHECK(warnings("bodies.slide.mass") == 1);
}

TEST_CASE("a sound case has no diagnostics; overrides and the scale of cells are checked too")
{
    CHECK(Press::check(starter_file()).empty());
    CHECK(at(Press::check(starter_file(), {.overrides = {"machine.ambient=warm"}}), "machine.ambient"));
    CHECK_THROWS_AS(Press::read(starter_file(), {.size_scale = 0}), InputError);
    CHECK_THROWS_AS(Press::read("/no/such/case.toml"), IoError);
    const auto press = starter({"machine.name=other"});
    CHECK(press.name() == "other");
    CHECK(press.warnings().empty());
    CHECK(press.case_text().find("name = \"other\"") != std::string::npos);
}
