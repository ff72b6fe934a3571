#include "../scratch_folder.hpp"

#include <cmath>
#include <cstdlib>
#include <doctest/doctest.h>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace {

std::vector<double> numbers(const std::filesystem::path& file)
{
    std::ifstream in(file);
    std::vector<double> values;
    for (double value = 0; in >> value;)
        values.push_back(value);
    return values;
}

void run_on(int ranks, const std::string& line)
{
    const std::string command =
        std::string(DEADPOINT_MPIRUN) + " -n " + std::to_string(ranks) + " --oversubscribe --bind-to none " + line;
    CAPTURE(command);
    REQUIRE(std::system(command.c_str()) == 0);
}

// @param ending  of the file to read: "" for temperatures, ".causes"
std::vector<double> solve(const std::string& name, int ranks, const std::string& overrides,
                          const std::string& ending = "")
{
    const ScratchFolder folder;
    const auto file = folder.path / "figures.txt";
    run_on(ranks, std::string(DEADPOINT_SOLVE) + " " + DEADPOINT_VERIFICATION_CASES + "/" + name + ".toml " +
                      file.string() + " " + overrides);
    return numbers(file.string() + ending);
}

// Figures of a reduced starter press.
// @param largest_factor  unknowns up to which factors solve for fields; multigrid does beyond
std::vector<double> reduced(int ranks, const std::string& largest_factor = "1000000")
{
    const ScratchFolder folder;
    const auto file = folder.path / "figures.txt";
    run_on(ranks, std::string(DEADPOINT_REDUCE) + " " + DEADPOINT_VERIFICATION_CASES +
                      "/../../../cases/starter/case.toml " + file.string() + " 3 " + largest_factor);
    return numbers(file);
}

// The one of one rank, with factors; several tests compare theirs with it.
const std::vector<double>& reduced_on_one()
{
    static const auto figures = reduced(1);
    return figures;
}

// Temperatures and gap of one rank and of several, to 1e-6 of the largest rise above the start.
void check_agreement(const std::string& name, double start, const std::string& overrides = "",
                     const std::vector<int>& others = {2})
{
    constexpr std::size_t gap = 2, difference = 3, temperatures = 4;
    CAPTURE(name);
    const auto one = solve(name, 1, overrides);
    REQUIRE(one.size() > temperatures);
    CHECK(one[0] == 1);
    CHECK(one[1] < 1e-6);
    double rise = 0;
    for (std::size_t i = temperatures; i < one.size(); ++i)
        rise = std::max(rise, std::abs(one[i] - start));
    REQUIRE(rise > 1);
    for (const int ranks : others) {
        const auto other = solve(name, ranks, overrides);
        REQUIRE(one.size() == other.size());
        CHECK(other[0] == ranks);
        CHECK(other[1] < 1e-6);
        CHECK(std::abs(one[gap] - other[gap]) <= 1e-6 * std::abs(one[gap]));
        CHECK(std::abs(other[difference]) <= 1e-7 * std::abs(one[gap]));  // the solver's tolerance
        for (std::size_t i = temperatures; i < one.size(); ++i)
            CHECK(std::abs(one[i] - other[i]) < 1e-6 * rise);
    }
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

TEST_CASE("two ranks give what one gives: a bond with a conductance") { check_agreement("bolted-bars", 293.15); }

TEST_CASE("two ranks give what one gives: radiation") { check_agreement("nafems-t2", 1000); }

TEST_CASE("two ranks give what one gives: preloaded rods, weights and stress")
{
    check_agreement("rods-in-tube", 293.15);
}

TEST_CASE("two ranks give what one gives: elements of first and second order")
{
    check_agreement("two-slabs", 293.15,
                    "parts.steel_slab.order=2 parts.steel_slab.size=\"1 mm\" parts.aluminium_slab.size=\"0.8 mm\"");
}

TEST_CASE("two ranks give what one gives: which heat has moved the gap")
{
    std::string overrides = "numerics.size=\"150 mm\" output.fields=false \"operation.0.duration=2 min\" "
                            "\"numerics.time_tolerance=1 K\" oil.journals=\"300 W/m^2/K\" "
                            "\"joints.crank_bearing.oil_temperature=26 degC\" numerics.solver_tolerance=1e-9";
    for (const auto* part : {"bed", "upright_left", "upright_right", "crown_top"})
        overrides += std::string(" parts.") + part + ".size=\"150 mm\"";
    for (const auto* part : {"crankshaft", "connecting_rod", "bush_front", "bush_back"})
        overrides += std::string(" parts.") + part + ".size=\"60 mm\"";
    const auto one = solve("../../../cases/starter/case", 1, overrides, ".causes"),
               two = solve("../../../cases/starter/case", 2, overrides, ".causes");
    REQUIRE(one.size() == 7);
    REQUIRE(two.size() == one.size());
    // Steps are the same; what differs are the linear solves.
    for (std::size_t i = 0; i < one.size(); ++i)
        CHECK(std::abs(one[i] - two[i]) < 1e-5);
    CHECK(std::abs(one[0]) > 0.01);
    CHECK(std::abs(one[4]) > 1e-4);
}

TEST_CASE("one, two and three ranks give one gap, with a coarser mesh for the deformation")
{
    check_agreement("../../../cases/starter/case", 293.15,
                    "operation.0.duration=\"10 min\" numerics.size=\"60 mm\" numerics.deformation_size=1.4 "
                    "numerics.solver_tolerance=1e-8",
                    {2, 3});
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

TEST_CASE("two ranks refine to the same meshes")
{
    check_agreement("hot-patch", 293.15, "numerics.accuracy=\"0.5 K\" numerics.solver_tolerance=1e-9");
}

TEST_CASE("two ranks build the reduced press of one")
{
    constexpr std::size_t large_states = 1, small_states = 2, gap = 3, errors = 4;
    const auto& one = reduced_on_one();
    const auto two = reduced(2);
    REQUIRE(one.size() == errors + 2 * (3 + 1));
    REQUIRE(two.size() == one.size());
    CHECK(two[0] == 2);
    CHECK(two[large_states] == one[large_states]);
    CHECK(two[small_states] == one[small_states]);
    CHECK(std::abs(one[gap]) > 10);
    // Rounding decides which directions of a term are cut at 1e-5 and 1e-3 of the largest: 2e-4 was found.
    CHECK(std::abs(two[gap] - one[gap]) < 1e-3);
    for (std::size_t i = errors; i < one.size(); ++i)
        CHECK(std::abs(two[i] - one[i]) < 1e-3);
}

TEST_CASE("multigrid gives two ranks the reduced press that factors give one")
{
    constexpr std::size_t gap = 3, errors = 4;
    const auto& factors = reduced_on_one();
    const auto multigrid = reduced(2, "0");
    REQUIRE(multigrid.size() == factors.size());
    CHECK(multigrid[0] == 2);
    // Fields are solved for to 1e-4: 7e-5 um was found, and 3e-3 K in the errors, by the same coefficients.
    CHECK(std::abs(multigrid[gap] - factors[gap]) < 1e-3);
    for (std::size_t i = errors; i < factors.size(); ++i)
        CHECK(std::abs(multigrid[i] - factors[i]) < 1e-2);
}

TEST_CASE("a checkpoint of two ranks is gone on from by one, two and three")
{
    const ScratchFolder folder;
    const auto file = (folder.path / "checkpoint").string();
    const auto kept = file + ".kept";
    const std::string name = "warm-box",
                      overrides = "machine.initial_temperature=\"80 degC\" enclosures.box.temperature=\"30 degC\"";
    const auto whole = solve(name, 2, overrides);
    solve(name, 2, overrides + " --stop=6 --checkpoint=" + kept);
    for (const int ranks : {1, 2, 3}) {
        CAPTURE(ranks);
        std::filesystem::copy_file(kept, file, std::filesystem::copy_options::overwrite_existing);
        const auto resumed = solve(name, ranks, overrides + " --resume --checkpoint=" + file);
        REQUIRE(resumed.size() == whole.size());
        CHECK(resumed[0] == ranks);
        for (std::size_t i = 1; i < whole.size(); ++i)
            if (ranks == 2)
                CHECK(resumed[i] == whole[i]);
            else  // to the solver's tolerance, over a rise of 60 K
                CHECK(std::abs(resumed[i] - whole[i]) < 60e-6);
    }
}
