/// Requirement: numbers of a case can be found by pattern and changed, as --set would change them.
#include "deadpoint/casefile/files/numbers.hpp"

#include "deadpoint/casefile/files/read.hpp"
#include "deadpoint/casefile/files/write.hpp"
#include "deadpoint/error.hpp"
#include "near.hpp"

#include <algorithm>
#include <doctest/doctest.h>

using namespace deadpoint;
using namespace deadpoint::casefile;

namespace {

Case starter(const std::vector<std::string>& overrides = {})
{
    return read_case(std::string(DEADPOINT_SOURCE_DIR) + "/cases/starter/case.toml", overrides).value;
}

CaseNumber number(const Case& input, const std::string& path)
{
    const auto all = numbers_of(input);
    const auto found = std::ranges::find(all, path, &CaseNumber::path);
    REQUIRE_MESSAGE(found != all.end(), path);
    return *found;
}

}  // namespace

TEST_CASE("every number has its path, the names of its list items, its value and its dimension")
{
    const auto input =
        starter({"oil.pins=300 W/m^2/K", "operation.0.ambient={ mean = \"20 degC\", amplitude = \"3 K\", "
                                         "time_of_maximum = \"6 h\" }"});
    const auto contact = number(input, "joints.crank_bearing.interfaces.1.conductance.resistance");
    CHECK(contact.by_name == "joints.crank_bearing.interfaces.back.conductance.resistance");
    CHECK(contact.value == 3e-4);
    CHECK(contact.dimension == Dimension::thermal_resistance);
    CHECK(number(input, "operation.0.force").by_name == "operation.warm-up.force");
    CHECK(number(input, "friction.pins.viscous_part").value == 0.4);
    CHECK(number(input, "oil.pins").value == 300);
    CHECK(number(input, "surfaces.air_frame.film.emissivity").most == 1);
    CHECK(number(input, "operation.0.ambient").value == near(293.15, 1e-12));
}

TEST_CASE("a changed number is what --set makes of it")
{
    auto changed = starter();
    change_numbers(changed, {{"friction.pins.viscous_part", {2, 0}}, {"machine.ambient", {1, 5}}, {"no.such", {9, 9}}});
    const auto set = starter({"friction.pins.viscous_part=0.8 W", "machine.ambient=25 degC"});
    CHECK(write_case(changed) == write_case(set));
}

TEST_CASE("a factor acts on a whole curve, a shift on the mean of a daily course alone")
{
    auto input =
        starter({"operation.0.ambient={ mean = \"20 degC\", amplitude = \"3 K\", time_of_maximum = \"6 h\" }",
                 "surfaces.feet={ parts = [\"bed\"], select = \"plane\", axis = \"y\", position = \"-1050 mm\", "
                 "heat_flux = { time = [\"0 h\", \"1 h\"], value = [\"10 W/m^2\", \"30 W/m^2\"] } }"});
    change_numbers(input, {{"operation.0.ambient", {1, 2}}, {"surfaces.feet.heat_flux", {3, 0}}});
    CHECK(input.operation[0].ambient->daily->mean == near(295.15, 1e-12));
    CHECK(input.operation[0].ambient->daily->amplitude == 3);
    CHECK(input.surfaces.at("feet").heat_flux->table->y == std::vector<double>{30, 90});
}

TEST_CASE("a number that leaves its range is refused with its key")
{
    auto input = starter();
    CHECK_THROWS_WITH_AS(change_numbers(input, {{"surfaces.air_frame.film.emissivity", {2, 0}}}),
                         doctest::Contains("surfaces.air_frame.film.emissivity: 1.2 lies outside"), InputError);
}

TEST_CASE("texts of values set the same case")
{
    auto changed = starter();
    std::map<std::string, NumberChange> changes;
    std::vector<std::string> paths;
    for (const auto* path : {"joints.guide.interfaces.0.conductance.resistance", "friction.gibs.load_part",
                             "operation.0.speed", "machine.ambient", "surfaces.air_moving.film.coefficient"}) {
        changes[path] = {1.0123456789, 0};
        paths.emplace_back(path);
    }
    change_numbers(changed, changes);
    std::vector<std::string> overrides;
    for (const auto& [path, text] : texts_of(changed, paths))
        overrides.push_back(path + "=" + text);
    CHECK(overrides.size() == paths.size());
    CHECK(case_hash(starter(overrides)) == case_hash(changed));
}
