/// Requirement: a broken case file gives every error with its place, the line and a remedy, and nothing else happens.
/// Each cases/NAME.toml is broken in the way its name says; cases/NAME.txt holds the message it must give.
#include "deadpoint/casefile/files/read.hpp"
#include "deadpoint/core/error.hpp"

#include <algorithm>
#include <doctest/doctest.h>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

const fs::path folder = fs::path(DEADPOINT_SOURCE_DIR) / "tests/bad_cases/cases";

std::vector<fs::path> broken_cases()
{
    std::vector<fs::path> paths;
    for (const auto& entry : fs::directory_iterator(folder)) {
        if (entry.path().extension() == ".toml") {
            paths.push_back(entry.path());
        }
    }
    std::ranges::sort(paths);
    return paths;
}

std::string replace_all(std::string text, const std::string& from, const std::string& to)
{
    for (auto at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size())) {
        text.replace(at, from.size(), to);
    }
    return text;
}

std::string message_of(const fs::path& path)
{
    try {
        deadpoint::casefile::read_case(path);
    } catch (const deadpoint::InputError& error) {
        return replace_all(error.what(), folder.string() + "/", "");
    }
    return "no error";
}

/// Lines of `expected` that do not follow in `message` in this order; "..." at the end of a line stands for the rest.
std::string missing_line(const std::string& message, const std::string& expected)
{
    std::istringstream lines(expected);
    std::size_t from = 0;
    for (std::string line; std::getline(lines, line);) {
        const bool open = line.ends_with("...");
        const std::string wanted = open ? line.substr(0, line.size() - 3) : line + "\n";
        const auto found = (message + "\n").find(wanted, from);
        if (found == std::string::npos) {
            return line;
        }
        from = found + wanted.size();
    }
    return "";
}

}  // namespace

TEST_CASE("every broken case file is answered as its .txt says")
{
    const auto paths = broken_cases();
    CHECK(paths.size() >= 60);
    for (const auto& path : paths) {
        CAPTURE(path.filename().string());
        std::ifstream stream(fs::path(path).replace_extension(".txt"));
        std::ostringstream expected;
        expected << stream.rdbuf();
        REQUIRE_FALSE(expected.str().empty());
        const std::string message = message_of(path);
        CAPTURE(message);
        CHECK(missing_line(message, expected.str()) == "");
    }
}

TEST_CASE("the machine that the broken cases build upon is sound")
{
    const auto path = fs::path(DEADPOINT_TEST_DATA) / "casefile/sound.toml";
    const auto result = deadpoint::casefile::read_case(path);
    CHECK(result.warnings.empty());
    CHECK(result.value.parts.size() == 2);
}
