/// Requirement: a mistake found after reading is shown with file, line and caret, like one found while reading.
#include "deadpoint/casefile/files/case_source.hpp"

#include "../../scratch_folder.hpp"
#include "../messages.hpp"
#include "deadpoint/casefile/files/read.hpp"
#include "deadpoint/casefile/syntax/document.hpp"
#include "deadpoint/core/mistakes.hpp"

#include <doctest/doctest.h>
#include <fstream>
#include <sstream>

using namespace deadpoint;
using namespace deadpoint::casefile;

namespace {

/// The sound machine of the tests, of which the parts lie in a file of their own.
class TwoFiles {
public:
    TwoFiles()
    {
        const auto text = content(DEADPOINT_TEST_DATA "/casefile/sound.toml");
        const auto begin = text.find("[parts.");
        const auto end = text.find("\n[", text.rfind("[parts.") + 1);
        REQUIRE(begin != std::string::npos);
        (void)folder_.file("parts.toml", "# parts\n" + text.substr(begin, end - begin));
        path_ = folder_.file("case.toml", "include = [\"parts.toml\"]\n" + text.substr(0, begin) + text.substr(end));
    }
    void change() const { std::ofstream(path_, std::ios::app) << "# a line more\n"; }
    [[nodiscard]] Case read(const std::vector<std::string>& overrides = {}) const
    {
        return read_case(path_, overrides).value;
    }

private:
    ScratchFolder folder_;
    std::string path_;
};

std::vector<deadpoint::Diagnostic> found_in(const Case& input, const Mistakes& mistakes)
{
    try {
        with_places(input, [&] { mistakes.raise(); });
    } catch (const CaseError& error) {
        return error.diagnostics();
    }
    return {};
}

}  // namespace

TEST_CASE("mistakes found later have their places, in included files and overrides too")
{
    const TwoFiles files;
    const auto input = files.read({"operation.0.speed=400 rpm"});
    const auto part = input.parts.begin()->first;
    Mistakes mistakes;
    mistakes.add("parts." + part, "it is flat");
    mistakes.add("operation.0.speed", "it is fast", "go slower");
    mistakes.add("machine.name", "it is odd");
    const auto found = found_in(input, mistakes);
    REQUIRE(found.size() == 3);
    CHECK(found[0].place.file.ends_with("parts.toml"));
    CHECK(found[0].place.line == 2);
    CHECK(found[0].place.column == 8);
    CHECK(found[1].place.file == "--set");
    CHECK(found[1].place.column == 19);
    CHECK(found[1].help == "go slower");
    CHECK(found[2].place.file.ends_with("case.toml"));

    const auto text = messages::error_of<CaseError>([&] { with_places(input, [&] { mistakes.raise(); }); });
    CHECK(messages::has(text, "parts.toml:2:8: error[inconsistent]: parts." + part +
                                  "\n  it is flat\n     2 | [parts." + part + "]\n       |        " +
                                  std::string(part.size(), '^') + "\n"));
    CHECK(messages::has(text, "--set:1:19: error[inconsistent]: operation.0.speed\n"));
    CHECK(messages::has(text, "  help: go slower\n"));
    CHECK(text.ends_with("3 errors in the case"));
}

TEST_CASE("a key that is not stated is shown at the nearest one above it; items of lists go by name too")
{
    const std::string text = "format = 1\n[joints.crank]\nbodies = [\"a\", \"b\"]\n[[joints.crank.interfaces]]\nname = "
                             "\"left\"\n[[joints.crank.interfaces]]\nname = \"right\"\nb = \"pin\"\n";
    Diagnostics none;
    const auto root = parse_toml(text, none.sources.add("case.toml", text), none);
    const auto line = [&](const std::string& path) { return place_of(root, path).line; };
    CHECK(line("joints.crank.bodies.1") == 3);
    CHECK(line("joints.crank.interfaces.1.b") == 8);
    CHECK(line("joints.crank.interfaces.right.b") == 8);
    CHECK(line("joints.crank.interfaces.right.a") == line("joints.crank.interfaces.1"));
    CHECK(line("joints.crank.interfaces.left") < line("joints.crank.interfaces.right"));
    CHECK(line("joints.crank.interfaces.middle") == line("joints.crank.interfaces"));
    CHECK(line("joints.crank.centre") == 2);
    CHECK(line("nowhere.at.all") == 1);
}

TEST_CASE("places are found once, and only in files that are what they were")
{
    const TwoFiles files;
    const auto input = files.read();
    const auto once = placed(mistake("machine.name", "it is odd"), input);
    const auto twice = placed(once, input);
    CHECK(std::string(once.what()) == twice.what());
    CHECK(twice.diagnostics().size() == 1);
    files.change();
    const auto late = placed(mistake("machine.name", "it is odd"), input);
    CHECK(std::string(late.what()) == "machine.name: it is odd");  // the places are no longer those that were read
    const auto unplaced = placed(mistake("machine.name", "it is odd"), Case{});
    CHECK(std::string(unplaced.what()) == "machine.name: it is odd");
    CHECK(unplaced.diagnostics().front().place.file.empty());
}

TEST_CASE("values out of range stay what they are when they get their places")
{
    const TwoFiles files;
    const auto input = files.read();
    const auto cold = [] { about("machine.ambient", [] { throw DomainError("too cold"); }); };
    CHECK_THROWS_AS(with_places(input, cold), CaseDomainError);
}

TEST_CASE("a default that was converted from SI units is printed without the digits which that leaves behind")
{
    const auto page = content(DEADPOINT_SOURCE_DIR "/docs/case-file.md");
    CHECK(messages::has(page, "`\"-95 degC\"`"));
    CHECK_FALSE(messages::has(page, "99999999"));
}
