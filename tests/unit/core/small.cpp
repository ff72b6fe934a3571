#include "deadpoint/core/hash.hpp"
#include "deadpoint/core/names/pattern.hpp"
#include "deadpoint/core/names/suggest.hpp"
#include "deadpoint/core/table.hpp"
#include "deadpoint/core/version.hpp"
#include "deadpoint/error.hpp"
#include "near.hpp"

#include <array>
#include <cmath>
#include <doctest/doctest.h>
#include <fstream>
#include <limits>
#include <sstream>

using namespace deadpoint;

TEST_CASE("FNV-1a reference values")
{
    // Published test vectors of the hash (64 bit).
    CHECK(stable_hash("") == "cbf29ce484222325");
    CHECK(stable_hash("a") == "af63dc4c8601ec8c");
    CHECK(stable_hash("foobar") == "85944171f73967e8");
}

TEST_CASE("edit distance and suggestions")
{
    CHECK(edit_distance("", "abc") == 3);
    CHECK(edit_distance("kitten", "sitting") == 3);
    CHECK(edit_distance("frame", "farme") == 1);  // a swap counts once
    CHECK(edit_distance("Frame", "frame") == 0);
    CHECK(closest_name("viscosty", {"density", "viscosity"}) == "viscosity");
    CHECK(closest_name("colour", {"part", "position"}) == "");
    CHECK(closest_name("P2", {"P1", "P17"}) == "P1");
    CHECK(closest_name("x", {}) == "");
    // Two names of a file may be as long as the file; no table of all their letters is made.
    const std::string endless(1'000'000, 'a');
    CHECK(closest_name(endless, {endless + "b"}) == "");
    CHECK(closest_name("aaa", {endless, "aab"}) == "aab");
}

TEST_CASE("name patterns")
{
    CHECK(matches("column_*", "column_left"));
    CHECK(matches("*", ""));
    CHECK(matches("*_x_*", "a_x_b"));
    CHECK(matches("a*b*c", "aXbYbZc"));
    CHECK(matches("**b**", "ab"));
    CHECK_FALSE(matches("column_*", "colum_left"));
    CHECK_FALSE(matches("upper_*", "lower_plate"));
    CHECK_FALSE(matches("pin", "pin_2"));
    CHECK_FALSE(matches("", "a"));
    CHECK_FALSE(matches("a*b", "abc"));
    // Takes time without end where every star is tried at every place.
    std::string stars;
    for (int i = 0; i < 40; ++i)
        stars += "a*";
    CHECK_FALSE(matches(stars + "b", std::string(400, 'a')));
}

TEST_CASE("linear curves and their derivative")
{
    const std::array x{0.0, 1.0, 3.0};
    const std::array y{10.0, 20.0, 0.0};
    CHECK(interpolate_linear(x, y, 0.25).value == near(12.5, 1e-15));
    CHECK(interpolate_linear(x, y, 0.25).derivative == 10);
    CHECK(interpolate_linear(x, y, 1.0).value == 20);
    CHECK(interpolate_linear(x, y, 1.0).derivative == -10);  // of the right side
    CHECK(interpolate_linear(x, y, 3.0).value == 0);
    CHECK_FALSE(interpolate_linear(x, y, 3.0).outside);
    CHECK(interpolate_linear(x, y, -1).value == 10);
    CHECK(interpolate_linear(x, y, -1).derivative == 0);
    CHECK(interpolate_linear(x, y, -1).outside);
    CHECK(interpolate_linear(x, y, 4).outside);
}

TEST_CASE("curves that mean nothing are refused")
{
    const std::array y2{1.0, 2.0};
    CHECK_THROWS_AS(interpolate_linear(std::array{0.0, 0.0}, y2, 0), DomainError);
    CHECK_THROWS_AS(interpolate_linear(std::array{1.0, 0.0}, y2, 0), DomainError);
    CHECK_THROWS_AS(interpolate_linear(std::array{0.0}, y2, 0), DomainError);
    CHECK_THROWS_AS(interpolate_linear(std::span<const double>(), std::span<const double>(), 0), DomainError);
    CHECK_THROWS_AS(interpolate_linear(std::array{0.0, 1.0}, y2, std::numeric_limits<double>::quiet_NaN()),
                    DomainError);
}

TEST_CASE("the version in the header is that of the project")
{
    std::ifstream stream(DEADPOINT_SOURCE_DIR "/CMakeLists.txt");
    std::ostringstream text;
    text << stream.rdbuf();
    CHECK(text.str().find("VERSION " + std::string(version) + " LANGUAGES") != std::string::npos);
}
