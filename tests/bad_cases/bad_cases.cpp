/// Requirement: a broken case file gives every error with its place, the line and a remedy, and nothing else happens.
/// Each cases/NAME.toml is broken in the way its name says; cases/NAME.txt holds the message it must give.
#include "broken.hpp"
#include "deadpoint/casefile/files/read.hpp"
#include "deadpoint/error.hpp"

#include <doctest/doctest.h>
#include <filesystem>
#include <string>

namespace {

namespace fs = std::filesystem;

const fs::path folder = fs::path(DEADPOINT_SOURCE_DIR) / "tests/bad_cases/cases";

std::string message_of(const fs::path& path)
{
    try {
        deadpoint::casefile::read_case(path);
    } catch (const deadpoint::InputError& error) {
        return broken::replace_all(error.what(), folder.string() + "/", "");
    }
    return "no error";
}

}  // namespace

TEST_CASE("every broken case file is answered as its .txt says")
{
    const auto paths = broken::cases(folder);
    CHECK(paths.size() >= 60);
    for (const auto& path : paths) {
        CAPTURE(path.filename().string());
        const auto expected = broken::expected(path);
        REQUIRE_FALSE(expected.empty());
        const std::string message = message_of(path);
        CAPTURE(message);
        CHECK(broken::missing_line(message, expected) == "");
    }
}

TEST_CASE("the machine that the broken cases build upon is sound")
{
    const auto path = fs::path(DEADPOINT_TEST_DATA) / "casefile/sound.toml";
    const auto result = deadpoint::casefile::read_case(path);
    CHECK(result.warnings.empty());
    CHECK(result.value.parts.size() == 2);
}
