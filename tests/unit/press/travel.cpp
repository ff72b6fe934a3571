/// Travel of the slides of a case: its shares of time against closed forms.
#include "deadpoint/press/machine/travel.hpp"

#include "deadpoint/casefile/files/read.hpp"
#include "deadpoint/drift/chain.hpp"
#include "deadpoint/exchange/linkage.hpp"
#include "deadpoint/full/model/prepare.hpp"
#include "deadpoint/mechanism/bottom_dead_point.hpp"
#include "deadpoint/observer.hpp"
#include "deadpoint/press/machine/machine.hpp"
#include "deadpoint/press/translate/linkage.hpp"
#include "near.hpp"

#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>
#include <filesystem>
#include <numbers>

using namespace deadpoint;

namespace {

constexpr double pi = std::numbers::pi;
constexpr double throw_ = 0.03, rod = 0.2;

/// A slider-crank drawn at bottom dead point.
casefile::Case slider_crank()
{
    casefile::Case input;
    input.bodies["frame"].ground = true;
    for (const char* body : {"crank", "rod", "slide"})
        input.bodies[body] = {};
    using Kind = casefile::Joint::Kind;
    const auto joint = [](Kind kind, const char* a, const char* b, double y) {
        casefile::Joint result;
        result.kind = kind;
        result.bodies = {a, b};
        result.centre = {0, y};
        return result;
    };
    input.joints["bearing"] = joint(Kind::revolute, "crank", "frame", 0);
    input.joints["bearing"].driver = true;
    input.joints["pin"] = joint(Kind::revolute, "rod", "crank", -throw_);
    input.joints["wrist"] = joint(Kind::revolute, "rod", "slide", -throw_ - rod);
    auto& guide = input.joints["guide"] = joint(Kind::slide, "slide", "frame", -throw_ - rod);
    casefile::Interface face;
    face.name = "face";
    guide.interfaces = {face};
    input.mechanism.slide_body = "slide";
    casefile::Segment segment;
    segment.speed = 10;
    input.operation = {segment};
    return input;
}

/// Height of the slide above bottom dead point.
double height(double angle)
{
    return throw_ * (1 - std::cos(angle)) + rod - std::sqrt(rod * rod - std::pow(throw_ * std::sin(angle), 2));
}

struct Moments {
    double share = 0, mean = 0, variance = 0;
};
Moments moments(const Travel& travel)
{
    Moments m;
    for (const auto& stop : travel.stops) {
        m.share += stop.share;
        m.mean += stop.share * stop.offset[1];
    }
    for (const auto& stop : travel.stops)
        m.variance += stop.share * std::pow(stop.offset[1] - m.mean, 2);
    return m;
}

/// Mean and variance of the height by the midpoint rule, with the time a crank of the given speed takes.
template <typename Speed>
Moments exact(Speed speed)
{
    constexpr int count = 100000;
    Moments m;
    double square = 0;
    for (int i = 0; i < count; ++i) {
        const double angle = 2 * pi * (i + 0.5) / count, time = 1 / speed(angle);
        m.share += time;
        m.mean += time * height(angle);
        square += time * height(angle) * height(angle);
    }
    m.mean /= m.share;
    m.variance = square / m.share - m.mean * m.mean;
    return m;
}

}  // namespace

TEST_CASE("equal shares of time stand at their means")
{
    // 0..1 evenly, each position once, then with shares that do not fit the cuts
    std::vector<double> position, share;
    for (int i = 0; i < 400; ++i) {
        position.push_back((i * 7 % 400 + 0.5) / 400);
        share.push_back(1.0 / 400);
    }
    const auto stops = press::condensed(position, share, 8);
    REQUIRE(stops.size() == 8);
    for (int k = 0; k < 8; ++k) {
        CHECK(stops[k].position == near((k + 0.5) / 8, 1e-12));
        CHECK(stops[k].share == 0.125);
    }
    const auto two = press::condensed({1, 5, 3}, {0.25, 0.25, 0.5}, 2);
    CHECK(two[0].position == near(2, 1e-15));
    CHECK(two[1].position == near(4, 1e-15));
    const auto three = press::condensed({0, 3}, {0.5, 0.5}, 3);
    CHECK(three[0].position == 0);
    CHECK(three[1].position == near(1.5, 1e-12));
    CHECK(three[2].position == near(3, 1e-12));
}

TEST_CASE("a slider-crank travels its stroke, with the mean and variance of its height")
{
    const auto travels = press::describe_travel(slider_crank());
    REQUIRE(travels.size() == 1);
    const auto& travel = travels.at("guide");
    CHECK(travel.moving == "slide");
    CHECK(travel.standing == "frame");
    REQUIRE(travel.stops.size() == press::travel_stops + 2);
    CHECK(travel.stops.front().share == 0);
    CHECK(std::abs(travel.stops.front().offset[1]) < 1e-12);
    CHECK(travel.stops.back().offset[1] == near(2 * throw_, 1e-9));
    const auto found = moments(travel);
    CHECK(found.share == near(1, 1e-14));
    // The mean of the rod's height is a complete elliptic integral; 720 samples of an analytic course are exact.
    const double mean = throw_ + rod - 2 * rod / pi * std::comp_ellint_2(throw_ / rod);
    CHECK(found.mean == near(mean, 1e-9));
    const auto reference = exact([](double) { return 1.0; });
    CHECK(reference.mean == near(mean, 1e-9));
    // Eight stops lack 1.3 % of the variance of a harmonic motion, sixteen a quarter of that.
    CHECK(1 - found.variance / reference.variance == near(0.0128, 0.1));
    const auto fine = moments(press::describe_travel(slider_crank(), 16).at("guide"));
    CHECK(1 - fine.variance / reference.variance == near(0.0032, 0.1));
}

TEST_CASE("a press that dwells spends its time there")
{
    auto input = slider_crank();
    input.mechanism.speed.x = {0, 0.5 * pi, pi, 1.5 * pi};
    input.mechanism.speed.y = {0.4, 1.3, 1.7, 1.3};
    const auto speed = [&](double angle) {
        const auto i = static_cast<std::size_t>(angle / (0.5 * pi));
        const auto& y = input.mechanism.speed.y;
        return y[i] + (angle / (0.5 * pi) - static_cast<double>(i)) * (y[(i + 1) % 4] - y[i]);
    };
    const auto found = moments(press::describe_travel(input).at("guide"));
    const auto reference = exact(speed);
    CHECK(reference.mean < 0.8 * exact([](double) { return 1.0; }).mean);
    CHECK(found.mean == near(reference.mean, 1e-4));  // trapezoids of the time over 720 samples, with kinks
    CHECK(found.variance == near(reference.variance, 0.02));
}

TEST_CASE("only slides that move and are swept travel")
{
    auto input = slider_crank();
    input.joints["guide"].swept = false;
    CHECK(press::describe_travel(input).empty());
    input = slider_crank();
    input.operation[0].speed = 0;
    CHECK(press::describe_travel(input).empty());
    input = slider_crank();
    input.joints["bearing"].driver = false;
    CHECK(press::describe_travel(input).empty());
    input = slider_crank();
    input.joints["guide"].interfaces.clear();
    CHECK(press::describe_travel(input).empty());
    input = slider_crank();
    std::swap(input.joints["guide"].bodies[0], input.joints["guide"].bodies[1]);
    const auto frame_first = press::describe_travel(input).at("guide");
    CHECK(frame_first.moving == "frame");  // seen from the slide, the frame goes down
    CHECK(frame_first.stops.front().offset[1] == near(-2 * throw_, 1e-9));
}

TEST_CASE("the guides of the shipped press get their strokes")
{
    const auto input =
        casefile::read_case(std::filesystem::path(DEADPOINT_SOURCE_DIR) / "cases/jl75g-60/case.toml").value;
    const auto description = press::describe_machine(input);
    const auto ends = [&](const std::string& name) -> Vec2 {
        const auto found = std::ranges::find(description.interfaces, name, &InterfaceDescription::name);
        REQUIRE(found != description.interfaces.end());
        const auto& stops = found->travel.stops;
        return stops.empty() ? Vec2{} : Vec2{stops.front().offset[1], stops.back().offset[1]};
    };
    // Strokes of the oracle (tests/data/mechanism_oracle.json); 720 positions pass the far end by 1e-5 of it or less.
    constexpr double stroke = 0.021966472330578246;
    CHECK(ends("crank_pin.pin") == Vec2{});
    CHECK(std::abs(ends("guide_10.left")[0]) < 1e-9);
    CHECK(ends("guide_10.left")[1] == near(stroke, 1e-4));
    CHECK(ends("guide_12.left")[0] == near(-stroke, 1e-4));  // the balance slide goes down
    CHECK(std::abs(ends("guide_12.left")[1]) < 1e-9);
    CHECK(ends("guide_4.back")[1] == near(0.05, 1e-9));
}

TEST_CASE("centres of a guide are fitted where it is drawn, swept or not")
{
    const auto centres = [](const std::vector<std::string>& overrides) {
        const auto input =
            casefile::read_case(std::filesystem::path(DEADPOINT_SOURCE_DIR) / "cases/starter/case.toml", overrides)
                .value;
        Observer quiet;
        const auto machine = full::prepare_machine(input, 2, quiet);
        const auto linkage = press::describe_linkage(input);
        const auto chain = press::describe_chain(input, machine, linkage);
        const auto guide = std::ranges::find(linkage.joints, "guide", &LinkageJoint::name) - linkage.joints.begin();
        const auto joint = static_cast<int>(guide);
        return drift::joint_centres(machine, linkage, mechanism::bottom_dead_point(linkage), joint,
                                    chain.joints.at(static_cast<std::size_t>(guide)));
    };
    const auto swept = centres({}), drawn = centres({"joints.guide.swept=false"});
    for (const auto& [one, other] : {std::pair{swept.in_a, drawn.in_a}, std::pair{swept.in_b, drawn.in_b}})
        for (std::size_t c = 0; c < 2; ++c) {
            REQUIRE(one[c].points.size() == other[c].points.size());
            for (std::size_t i = 0; i < one[c].points.size(); ++i) {
                CHECK(one[c].points[i].face == other[c].points[i].face);
                CHECK(one[c].points[i].position == other[c].points[i].position);
                CHECK(one[c].points[i].weight == other[c].points[i].weight);
            }
        }
    CHECK(!swept.in_a[0].points.empty());
}
