/// Requirement: what is wrong with a case and found only after reading it, on the mesh or by its laws, is shown like
/// what is found while reading: all of it at once, each with file, line, caret and remedy, in included files too.
#include "broken.hpp"

#include <cstdlib>
#include <doctest/doctest.h>
#include <random>
#include <sys/wait.h>

namespace {

namespace fs = std::filesystem;

const fs::path folder = fs::path(DEADPOINT_SOURCE_DIR) / "tests/bad_cases/later";

struct Outcome {
    int code = -1;
    std::string message;  ///< without the folder
};

/// Outcome of a subcommand with arguments in shell syntax.
Outcome deadpoint(const std::string& arguments)
{
    const auto file = fs::temp_directory_path() / ("deadpoint-later-" + std::to_string(std::random_device{}()));
    const int status =
        std::system((std::string(DEADPOINT_COMMAND) + " " + arguments + " >/dev/null 2>" + file.string()).c_str());
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    fs::remove(file);
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, broken::replace_all(text.str(), folder.string() + "/", "")};
}

}  // namespace

TEST_CASE("check answers every case that is wrong beyond its text as its .txt says")
{
    const auto paths = broken::cases(folder);
    CHECK(paths.size() >= 4);
    for (const auto& path : paths) {
        CAPTURE(path.filename().string());
        const auto expected = broken::expected(path);
        REQUIRE_FALSE(expected.empty());
        const auto outcome = deadpoint("check -q " + path.string());
        CAPTURE(outcome.message);
        CHECK(outcome.code == 2);
        CHECK(broken::missing_line(outcome.message, expected) == "");
    }
}

TEST_CASE("run refuses what check refuses, with the same words")
{
    const auto path = (folder / "laws.toml").string();
    const auto results = fs::temp_directory_path() / ("deadpoint-later-run-" + std::to_string(std::random_device{}()));
    const auto run = deadpoint("run -q " + path + " -o " + results.string());
    CHECK(run.code == 2);
    CHECK(broken::missing_line(run.message, broken::expected(path)) == "");
    CHECK_FALSE(fs::exists(results));
}

TEST_CASE("a value that an override states is shown in the override")
{
    const auto path = (folder / "on-the-mesh.toml").string();
    const auto outcome = deadpoint("check -q " + path + " --set 'probes.off.part=block' --set " +
                                   "'surfaces.warm.temperature_formula=1 - 300 * y / 0.1'");
    CHECK(outcome.code == 2);
    CAPTURE(outcome.message);
    CHECK(broken::missing_line(outcome.message,
                               "--set:1:35: error[inconsistent]: surfaces.warm.temperature_formula\n  gives -299 K...\n"
                               "     1 | surfaces.warm.temperature_formula=1 - 300 * y / 0.1\n"
                               "       |                                   ^^^^^^^^^^^^^^^^^") == "");
}

TEST_CASE("check refuses a press that is not drawn at bottom dead point")
{
    const auto outcome = deadpoint("check -q " DEADPOINT_SOURCE_DIR
                                   "/cases/starter/case.toml --size 3 --set 'mechanism.stroke_direction=[0, -1]'");
    CAPTURE(outcome.message);
    CHECK(outcome.code == 2);
    CHECK(broken::missing_line(outcome.message,
                               "error[inconsistent]: joints....\n  the case's joints are not placed at "
                               "bottom dead point...\n  help: give all coordinates at bottom dead "
                               "point; if they are, correct machine.gravity_direction...") == "");
}
