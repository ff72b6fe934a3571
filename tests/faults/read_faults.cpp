/// Requirement: a file that cannot be read to its end is an error with its name, wherever it breaks off. Nothing that
/// was in it is lost without a word.
#include "command.hpp"

#include <doctest/doctest.h>
#include <utility>
#include <vector>

namespace {

const std::string two_blocks = DEADPOINT_TEST_DATA "/cli/two-blocks.toml";

/// Two plates, the second one in an include that sounds complete without it: long comments stand in front of it, so
/// that no piece of the file that a reader takes at once holds both.
std::string case_with_include(const ScratchFolder& folder)
{
    const std::string plate = "body = \"frame\"\nmaterial = \"steel\"\nshapes = [{ add = \"box\", x = [\"0 mm\", "
                              "\"100 mm\"], y = [\"{} mm\", \"{} mm\"], z = [\"0 mm\", \"100 mm\"] }]\n";
    std::string first = plate, second = plate;
    first.replace(first.find("{}"), 2, "0").replace(first.find("{}"), 2, "20");
    second.replace(second.find("{}"), 2, "20").replace(second.find("{}"), 2, "40");
    std::string padding;
    while (padding.size() < 40'000)
        padding += "# more of the same\n";
    (void)folder.file("parts.toml", "[parts.lower]\n" + first + padding + "[parts.upper]\n" + second);
    return folder
        .file("case.toml", "format = 1\ninclude = [\"parts.toml\"]\n[machine]\nname = \"plates\"\n[materials.steel]\n"
                           "library = \"C45\"\n[bodies.frame]\nground = true\n[[operation]]\nduration = \"1 min\"\n"
                           "speed = \"0 rpm\"\n")
        .string();
}

}  // namespace

TEST_CASE("an include that breaks off is exit code 5 with its name, not a machine with a part less")
{
    const ScratchFolder folder;
    const auto file = case_with_include(folder);
    const auto whole = run("", "check " + file);
    REQUIRE(whole.code == 0);
    REQUIRE(has(whole.text, "upper"));
    const auto parts = folder.path / "parts.toml";
    const auto text = content(parts);
    const std::vector<std::pair<std::string, const char*>> faults{
        {"read:1:5", "Input/output error"},
        {"read:2:5", "Input/output error"},
        {fmt::format("read:1:truncate -s 8192 {}", parts.string()), "8192 bytes came of"},
        {fmt::format("read:1:truncate -s 0 {}", parts.string()), "0 bytes came of"},
        {fmt::format("read:1:echo >> {}", parts.string()), "bytes came of"}};
    for (const auto& [fault, reason] : faults) {
        CAPTURE(fault);
        (void)folder.file("parts.toml", text);
        const auto outcome = run(failing(parts, fault), "check " + file);
        CHECK(outcome.code == 5);
        CHECK(has(outcome.text, "parts.toml"));
        CHECK(has(outcome.text, reason));
    }
}

TEST_CASE("a state that breaks off is exit code 5 with its name")
{
    const ScratchFolder folder;
    const auto target = (folder.path / "result").string();
    REQUIRE(run("", fmt::format("run -q {} -o {}", two_blocks, target)).code == 0);
    // The first two reads see whether it is as listed; then the solver reads it.
    for (const char* fault : {"read:1:5", "read:2:5", "read:3:5", "read:4:5"}) {
        CAPTURE(fault);
        const auto outcome = run(failing(target + "/state.bin", fault),
                                 fmt::format("run -q {} --from {} -o {}", two_blocks, target, target + "2"));
        CHECK(outcome.code == 5);
        CHECK(has(outcome.text, "state.bin"));
        CHECK_FALSE(fs::exists(target + "2"));
    }
}

TEST_CASE("results of two runs that were put together, cut or edited are exit code 2 with the name of the file")
{
    const ScratchFolder folder;
    const auto one = (folder.path / "one").string(), other = (folder.path / "other").string();
    REQUIRE(run("", fmt::format("run -q {} -o {}", two_blocks, one)).code == 0);
    REQUIRE(run("", fmt::format("run -q {} -o {} --set \"machine.ambient=25 degC\"", two_blocks, other)).code == 0);
    const auto refused = [&](const std::string& line, const char* name) {
        const auto outcome = run("", line);
        CAPTURE(line);
        CAPTURE(outcome.text);
        CHECK(outcome.code == 2);
        CHECK(has(outcome.text, name));
    };
    for (const char* name : {"history.csv", "summary.json", "case.toml", "state.bin"}) {
        const auto mixed = (folder.path / "mixed").string();
        fs::remove_all(mixed);
        fs::copy(one, mixed, fs::copy_options::recursive);
        fs::copy_file(fs::path(other) / name, fs::path(mixed) / name, fs::copy_options::overwrite_existing);
        if (name == std::string("state.bin")) {
            refused(fmt::format("run -q {} --from {} -o {}", two_blocks, mixed, mixed + "2"), name);
        } else {
            refused("report " + mixed, name);
        }
        if (name == std::string("history.csv") || name == std::string("summary.json")) {
            refused("view " + mixed, name);
        }
    }
    const auto history = fs::path(one) / "history.csv";
    fs::resize_file(history, fs::file_size(history) / 2);
    refused("report " + one, "history.csv");
}

TEST_CASE("an edited page of results is not opened, and an edited case is not compared")
{
    const ScratchFolder folder;
    const auto results = folder.path / "results";
    REQUIRE(run("", fmt::format("run -q {} -o {}", two_blocks, results.string())).code == 0);
    const auto page = content(results / "report.html"), text = content(results / "case.toml");
    (void)folder.file("results/report.html", page + "<p>mine</p>");
    const auto view = run("BROWSER=true", "view " + results.string());
    CHECK(view.code == 5);
    CHECK(has(view.text, "report.html' exists and is not as deadpoint wrote it"));
    CHECK(run("", "report " + results.string()).code == 5);
    CHECK(run("", "report --force " + results.string()).code == 0);
    CHECK(run("BROWSER=true", "view " + results.string()).code == 0);
    (void)folder.file("results/case.toml", text + "\n# mine\n");
    const auto reference = folder.file("m.toml", "format = 1\nname = \"m\"\nsource = \"s\"\n[points.p]\nset = "
                                                 "[\"machine.ambient=20 degC\"]\n[[rises]]\npoint = \"p\"\ntime = \"7 "
                                                 "min\"\nvalues = { top = \"0.1 K\" }\n");
    const auto compare = run("", fmt::format("compare {} {} --point p", results.string(), reference.string()));
    CHECK(compare.code == 2);
    CHECK(has(compare.text, "case.toml' was changed since deadpoint wrote it"));
}
