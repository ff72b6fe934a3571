#include <cmath>
#include <cstdlib>
#include <doctest/doctest.h>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace {

std::vector<double> solve(const std::string& name, int ranks, const std::string& overrides)
{
    const auto file = std::filesystem::temp_directory_path() / ("deadpoint-ranks-" + std::to_string(ranks) + ".txt");
    std::filesystem::remove(file);
    const std::string command = std::string(DEADPOINT_MPIRUN) + " -n " + std::to_string(ranks) +
                                " --oversubscribe --bind-to none " + DEADPOINT_SOLVE + " " +
                                DEADPOINT_VERIFICATION_CASES + "/" + name + ".toml " + file.string() + " " + overrides;
    CAPTURE(command);
    REQUIRE(std::system(command.c_str()) == 0);
    std::ifstream result(file);
    std::vector<double> values;
    for (double value = 0; result >> value;)
        values.push_back(value);
    std::filesystem::remove(file);
    return values;
}

// Temperatures of one rank and of two, to 1e-6 of the largest rise above the start.
void check_agreement(const std::string& name, double start, const std::string& overrides = "")
{
    CAPTURE(name);
    const auto one = solve(name, 1, overrides), two = solve(name, 2, overrides);
    REQUIRE(one.size() == two.size());
    REQUIRE(one.size() > 3);
    CHECK(one[0] == 1);
    CHECK(two[0] == 2);
    CHECK(one[1] < 1e-6);
    CHECK(two[1] < 1e-6);
    double rise = 0;
    for (std::size_t i = 2; i < one.size(); ++i)
        rise = std::max(rise, std::abs(one[i] - start));
    REQUIRE(rise > 1);
    for (std::size_t i = 2; i < one.size(); ++i)
        CHECK(std::abs(one[i] - two[i]) < 1e-6 * rise);
}

}  // namespace

TEST_CASE("two ranks give what one gives: a turning joint with friction, oil and air")
{
    check_agreement("shaft-in-block", 293.15);
}

TEST_CASE("two ranks give what one gives: two sliding joints between parts")
{
    check_agreement("three-blocks", 293.15);
}

TEST_CASE("two ranks give what one gives: prescribed temperatures and a bond")
{
    check_agreement("bonded-blocks", 293.15);
}

TEST_CASE("two ranks give what one gives: radiation") { check_agreement("nafems-t2", 1000); }

TEST_CASE("two ranks give what one gives: elements of second order")
{
    check_agreement("two-slabs", 293.15,
                    "numerics.order=2 parts.steel_slab.size=\"1 mm\" parts.aluminium_slab.size=\"0.8 mm\"");
}

TEST_CASE("two ranks give what one gives: materials that follow the temperature, and a bond between them")
{
    check_agreement("hot-plates", 293.15, "operation.0.duration=\"20 min\"");
}

TEST_CASE("two ranks give what one gives: enclosed air")
{
    check_agreement("warm-box", 353.15,
                    "machine.initial_temperature=\"80 degC\" enclosures.box.temperature=\"30 degC\"");
}
