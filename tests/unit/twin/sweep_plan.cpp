#include "deadpoint/twin/map/sweep_plan.hpp"

#include "deadpoint/casefile/studies/study_file.hpp"
#include "deadpoint/error.hpp"
#include "near.hpp"

#include <doctest/doctest.h>
#include <filesystem>
#include <numbers>
#include <set>

using namespace deadpoint;
using namespace deadpoint::twin;

namespace {

SweepAxis axis(const std::string& name, const std::string& key, const std::vector<std::string>& values)
{
    SweepAxis a;
    a.name = name;
    a.keys = {key};
    a.labels = values;
    for (const auto& value : values) {
        a.values.push_back({value});
    }
    return a;
}

SweepStudy with_sets(std::vector<SweepSet> sets)
{
    SweepStudy s;
    s.name = "a study";
    s.overrides = {"numerics.size=40 mm"};
    s.sets = std::move(sets);
    return s;
}

/// The base case runs at 200 rpm and 300 kN.
bool is_base(const std::string& key, const std::string& value)
{
    return (key == "speed" && casefile::plain_setting(value) == casefile::plain_setting("200 rpm")) ||
           (key == "force" && casefile::plain_setting(value) == casefile::plain_setting("300 kN"));
}

std::vector<std::string> names(const std::vector<SweepPoint>& points)
{
    std::vector<std::string> result;
    for (const auto& point : points) {
        result.push_back(point.name);
    }
    return result;
}

const SweepAxis speeds = axis("speed", "speed", {"200 rpm", "300 rpm"});
const SweepAxis forces = axis("force", "force", {"0 kN", "300 kN"});

}  // namespace

TEST_CASE("each distinct run is computed once, and knows all its places")
{
    const auto points = sweep_points(
        with_sets({{"speed", {speeds}}, {"force", {forces}}, {"both", {speeds, forces}}, {"as is", {}}}), is_base);
    CHECK(names(points) == std::vector<std::string>{"base", "speed=300_rpm", "force=0_kN", "speed=300_rpm,force=0_kN"});
    // speed 200 rpm, force 300 kN, both together, and the set without axes.
    REQUIRE(points[0].places.size() == 4);
    CHECK(points[0].overrides == std::vector<std::string>{"numerics.size=40 mm"});
    CHECK(points[0].places[2].set == 2);
    CHECK(points[0].places[2].steps == std::vector<std::size_t>{0, 1});
    CHECK(points[0].places[3].steps.empty());
    CHECK(points[1].places.size() == 2);
    CHECK(points[3].places.size() == 1);
    CHECK(points[3].overrides == std::vector<std::string>{"numerics.size=40 mm", "speed=300 rpm", "force=0 kN"});
}

TEST_CASE("the last axis changes fastest, and a value counts however it is written")
{
    auto odd = axis("v", "speed", {"200.0  rpm", "3e2 rpm"});
    const auto points = sweep_points(
        with_sets({{"a", {axis("x", "x", {"1", "2"}), axis("y", "y", {"1", "2"})}}, {"b", {speeds}}, {"c", {odd}}}),
        is_base);
    CHECK(names(points) ==
          std::vector<std::string>{"x=1,y=1", "x=1,y=2", "x=2,y=1", "x=2,y=2", "base", "speed=300_rpm"});
    CHECK(points[4].places.size() == 2);
    CHECK(points[5].places.size() == 2);
}

TEST_CASE("keys that change together: only what differs from the base case is set")
{
    SweepAxis pair;
    pair.name = "pair";
    pair.keys = {"speed", "force"};
    pair.values = {{"200 rpm", "100 kN"}, {"200 rpm", "300 kN"}};
    pair.labels = {"half", "full"};
    const auto points = sweep_points(with_sets({{"p", {pair}}, {"f", {axis("force", "force", {"100 kN"})}}}), is_base);
    CHECK(names(points) == std::vector<std::string>{"pair=half", "base"});
    CHECK(points[0].places.size() == 2);
    CHECK(points[0].overrides.back() == "force=100 kN");
}

TEST_CASE("names of folders are safe, and differ also where letters do not count")
{
    const auto points = sweep_points(
        with_sets({{"a", {axis("o/\\ il", "k", {"../x", "a b", "a  b", "A b", "\u00e4\u00f6", "\u00fc"})}}}), is_base);
    std::set<std::string> unique;
    for (const auto& point : points) {
        CHECK(point.name.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789._-+=,") ==
              std::string::npos);
        std::string lower;
        for (const char c : point.name) {
            lower += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
        }
        CHECK(unique.insert(lower).second);
    }
    CHECK(points.size() == 6);
    CHECK(points[0].name == "o_il=.._x");
    CHECK(points[1].name == "o_il=a_b");
    CHECK(points[2].name.starts_with("o_il=a_b-"));
    const std::string longer(300, 'x');
    const auto two = sweep_points(with_sets({{"a", {axis("n", "k", {longer + "1", longer + "2"})}}}), is_base);
    CHECK(two[0].name.size() < 120);
    CHECK(two[0].name != two[1].name);
}

TEST_CASE("sets that make no sense are refused")
{
    CHECK_THROWS_WITH_AS((void)sweep_points(with_sets({{"a", {speeds, axis("v", "speed", {"1"})}}}), is_base),
                         doctest::Contains("varies 'speed' twice"), InputError);
    CHECK_THROWS_WITH_AS((void)sweep_points(with_sets({{"a", {speeds, axis("speed", "k", {"1"})}}}), is_base),
                         doctest::Contains("another axis of the set has this name"), InputError);
    CHECK_THROWS_WITH_AS((void)sweep_points(with_sets({{"a", {axis("v", "k", {})}}}), is_base),
                         doctest::Contains("it has no step"), InputError);
    CHECK_THROWS_WITH_AS((void)sweep_points(with_sets({{"a", {}}, {"a", {}}}), is_base),
                         doctest::Contains("two sets are called 'a'"), InputError);
    auto short_labels = speeds;
    short_labels.labels.pop_back();
    CHECK_THROWS_AS((void)sweep_points(with_sets({{"a", {short_labels}}}), is_base), InputError);
}

TEST_CASE("axes get numbers in SI where all their steps are quantities of one dimension")
{
    casefile::StudyFile file;
    const auto numbers_of = [&](const std::vector<std::vector<std::string>>& values) {
        casefile::StudyAxis a;
        a.keys.resize(values.front().size());
        a.values = values;
        a.labels.resize(values.size());
        file.sets = {{"s", {a}}};
        return translate_study(file).sets[0].axes[0];
    };
    const auto speed = numbers_of({{"60 rpm"}, {"1 rad/s"}});
    CHECK(speed.dimension == Dimension::angular_velocity);
    CHECK(speed.numbers[0] == near(2 * std::numbers::pi, 1e-14));
    CHECK(speed.numbers[1] == 1);
    CHECK(numbers_of({{"5e7 N/m", "5e7 N/m"}, {"1e8 N/m", "1e8 N/m"}}).numbers == std::vector<double>{5e7, 1e8});
    CHECK(numbers_of({{"5e7 N/m", "5e7 N/m"}, {"1e8 N/m", "2e8 N/m"}}).numbers.empty());
    const auto plain = numbers_of({{"0.1"}, {"0.2"}});
    CHECK(plain.numbers == std::vector<double>{0.1, 0.2});
    CHECK(plain.dimension == Dimension::none);
    CHECK(numbers_of({{"rigid"}, {"flexible"}}).numbers.empty());
    CHECK(numbers_of({{"1 mm"}, {"1 kN"}}).numbers.empty());
    const auto warm = numbers_of({{"20 degC"}, {"25 degC"}});
    CHECK(warm.dimension == Dimension::temperature);
    CHECK(warm.numbers[0] == near(293.15, 1e-5));
    CHECK(numbers_of({{"3 K"}, {"5 K"}}).dimension == Dimension::temperature_difference);
}

TEST_CASE("the shipped study of the paper has twelve distinct runs, the base case in all four sets")
{
    const auto s = translate_study(casefile::read_study(DEADPOINT_SOURCE_DIR "/cases/jl75g-60/paper-study.toml"));
    const auto points = sweep_points(s, base_values(s));
    // 4 + 5 + 4 + 2 places; the base case is one of each set: 3 + 4 + 3 + 1 others.
    CHECK(points.size() == 12);
    CHECK(points[0].name == "base");
    CHECK(points[0].places.size() == 4);
    CHECK(points[0].overrides.empty());
    std::set<std::string> all;
    for (const auto& point : points) {
        all.insert(point.name);
    }
    CHECK(all.contains("speed=400_rpm"));
    CHECK(all.contains("force=0_kN"));
    CHECK(all.contains("stiffness=5e7_N_m"));
    CHECK(all.contains("model=traditional"));
}
