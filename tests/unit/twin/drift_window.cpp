#include "deadpoint/twin/map/drift_window.hpp"

#include "deadpoint/error.hpp"
#include "near.hpp"

#include <algorithm>
#include <bit>
#include <doctest/doctest.h>
#include <numeric>
#include <random>

using namespace deadpoint;
using namespace deadpoint::twin;
using Steps = std::vector<std::size_t>;

namespace {

WindowAxis ordered(std::vector<double> numbers) { return {numbers.size(), numbers}; }
WindowAxis labels(std::size_t steps) { return {steps, {}}; }

std::vector<bool> cells(const std::string& text)
{
    std::vector<bool> inside;
    for (const char c : text) {
        if (c != ' ') {
            inside.push_back(c == 'x');
        }
    }
    return inside;
}

/// Every choice of steps that an axis allows.
std::vector<Steps> choices(const WindowAxis& axis)
{
    Steps order(axis.steps);
    std::iota(order.begin(), order.end(), std::size_t{0});
    if (!axis.numbers.empty()) {
        std::ranges::sort(order, {}, [&](std::size_t i) { return axis.numbers[i]; });
    }
    std::vector<Steps> result;
    for (unsigned bits = 1; bits < 1U << axis.steps; ++bits) {
        Steps chosen;
        for (std::size_t i = 0; i < axis.steps; ++i) {
            if ((bits >> i & 1U) != 0) {
                chosen.push_back(order[i]);
            }
        }
        // A row of ones, shifted: neighbours only.
        const unsigned row = bits >> std::countr_zero(bits);
        if (axis.numbers.empty() || (row & (row + 1)) == 0) {
            result.push_back(chosen);
        }
    }
    return result;
}

struct Naive {
    std::size_t points = 0;
    double share = 0;
};

/// Tries all boxes, without any shortcut.
Naive naive(const std::vector<WindowAxis>& axes, const std::vector<bool>& inside)
{
    Naive best;
    std::vector<std::vector<Steps>> all;
    for (const auto& axis : axes) {
        all.push_back(choices(axis));
    }
    std::vector<std::size_t> pick(axes.size(), 0);
    while (true) {
        std::size_t points = 0, wanted = 1;
        double share = 0;
        for (std::size_t a = 0; a < axes.size(); ++a) {
            const auto& chosen = all[a][pick[a]];
            wanted *= chosen.size();
            if (axes[a].numbers.empty()) {
                share += static_cast<double>(chosen.size()) / static_cast<double>(axes[a].steps);
            } else {
                const auto [low, high] = std::ranges::minmax(axes[a].numbers);
                share +=
                    high > low ? (axes[a].numbers[chosen.back()] - axes[a].numbers[chosen.front()]) / (high - low) : 1;
            }
        }
        for (std::size_t i = 0; i < inside.size(); ++i) {
            std::size_t rest = i;
            bool belongs = inside[i];
            for (std::size_t a = axes.size(); a-- > 0;) {
                belongs = belongs && std::ranges::find(all[a][pick[a]], rest % axes[a].steps) != all[a][pick[a]].end();
                rest /= axes[a].steps;
            }
            points += belongs ? 1 : 0;
        }
        share /= static_cast<double>(axes.size());
        if (points == wanted && (points > best.points || (points == best.points && share > best.share))) {
            best = {points, share};
        }
        std::size_t a = axes.size();
        while (a > 0 && ++pick[a - 1] == all[a - 1].size()) {
            pick[--a] = 0;
        }
        if (a == 0) {
            return best;
        }
    }
}

}  // namespace

TEST_CASE("one axis: the longest stretch, of two the wider, in the order of the numbers")
{
    const auto window = best_window({ordered({1, 2, 3, 4, 5})}, cells("xx.xx"));
    CHECK(window.points == 2);
    CHECK(window.steps[0] == Steps{0, 1});  // both are a quarter of the range wide; the first one stays
    CHECK(best_window({ordered({1, 2, 3, 4, 8})}, cells("xx.xx")).steps[0] == Steps{3, 4});
    CHECK(best_window({ordered({1, 2, 3, 4, 8})}, cells("xx.xx")).share == near(4.0 / 7, 1e-5));
    // Listed as 3, 1, 2: the steps of 1 and 2 are neighbours.
    const auto sorted = best_window({ordered({3, 1, 2})}, cells(".xx"));
    CHECK(sorted.steps[0] == Steps{1, 2});
    CHECK(best_window({ordered({2, 3, 1})}, cells("xx.")).steps[0] == Steps{0, 1});
    CHECK(best_window({ordered({2, 1, 3})}, cells(".xx")).points == 1);
}

TEST_CASE("steps without order need not be neighbours")
{
    CHECK(best_window({labels(4)}, cells("x.xx")).steps[0] == Steps{0, 2, 3});
    // Second axis: a labels axis on which both outer steps keep all three numbers.
    const auto window = best_window({labels(3), ordered({1, 2, 3})}, cells("xxx x.x xxx"));
    CHECK(window.points == 6);
    CHECK(window.steps[0] == Steps{0, 2});
    CHECK(window.steps[1] == Steps{0, 1, 2});
}

TEST_CASE("two axes: the largest box by hand")
{
    const auto window = best_window({ordered({1, 2, 3, 4}), ordered({10, 20, 30, 40})}, cells("xx.. xxx. .xxx .xxx"));
    CHECK(window.points == 6);
    CHECK(window.steps[0] == Steps{1, 2, 3});
    CHECK(window.steps[1] == Steps{1, 2});
    CHECK(window.share == near((2.0 / 3 + 1.0 / 3) / 2, 1e-5));
}

TEST_CASE("nothing fits, and everything fits")
{
    const auto none = best_window({ordered({1, 2}), labels(2)}, cells("...."));
    CHECK(none.points == 0);
    CHECK(none.steps.empty());
    const auto all = best_window({ordered({1, 2}), labels(2)}, cells("xxxx"));
    CHECK(all.points == 4);
    CHECK(all.share == 1);
    CHECK(best_window({}, {true}).points == 1);
    CHECK(best_window({}, {false}).points == 0);
    CHECK_THROWS_AS((void)best_window({labels(2)}, cells("x")), DomainError);
    CHECK_THROWS_AS((void)best_window({{2, {1.0}}}, cells("xx")), DomainError);
}

TEST_CASE("random grids: the search finds what trying all boxes finds")
{
    std::mt19937 random(20260611);
    const auto below = [&](std::size_t n) { return static_cast<std::size_t>(random() % n); };
    for (int trial = 0; trial < 400; ++trial) {
        std::vector<WindowAxis> axes;
        std::size_t places = 1;
        for (std::size_t a = 0; a < 1 + below(3); ++a) {
            WindowAxis axis;
            axis.steps = 1 + below(5);
            if (below(3) > 0) {
                for (std::size_t i = 0; i < axis.steps; ++i) {
                    axis.numbers.push_back(static_cast<double>(i * i));
                }
                std::ranges::shuffle(axis.numbers, random);
            }
            places *= axis.steps;
            axes.push_back(axis);
        }
        const std::size_t holes = below(6);
        std::vector<bool> inside(places, true);
        for (std::size_t i = 0; i < places; ++i) {
            inside[i] = below(6) >= holes;
        }
        const auto found = best_window(axes, inside);
        const auto expected = naive(axes, inside);
        REQUIRE(found.points == expected.points);
        CHECK(found.share == near(expected.share, 1e-12));
        // And it is what it says: so many places, all inside.
        std::size_t count = found.points == 0 ? 0 : 1;
        for (const auto& steps : found.steps) {
            count *= steps.size();
        }
        CHECK(count == found.points);
    }
}

TEST_CASE("a large study is searched in reasonable time; too many choices count labels as ordered")
{
    const std::vector<WindowAxis> many(4, labels(10));
    std::vector<bool> inside(10000, true);
    inside[0] = false;
    // Ordered as listed: the best box leaves out the first step of one axis.
    CHECK(best_window(many, inside).points == 9000);
    std::vector<double> numbers(21);
    std::iota(numbers.begin(), numbers.end(), 0);
    std::vector<bool> cube(21 * 21 * 21, true);
    cube[(10 * 21 + 10) * 21 + 10] = false;
    CHECK(best_window(std::vector<WindowAxis>(3, ordered(numbers)), cube).points == 10 * 21 * 21);
}

TEST_CASE("the window of a study: missing points are outside, both limits count")
{
    SweepStudy study;
    SweepAxis axis;
    axis.name = "v";
    axis.keys = {"v"};
    axis.values = {{"1"}, {"2"}, {"3"}, {"4"}};
    axis.labels = {"1", "2", "3", "4"};
    axis.numbers = {1, 2, 3, 4};
    study.sets = {{"s", {axis}}};
    std::vector<SweepPoint> points(4);
    for (std::size_t i = 0; i < 4; ++i) {
        points[i].places = {{0, {i}}};
    }
    std::vector<std::optional<PointDrift>> drift{PointDrift{9e-6, 1e-6}, PointDrift{10e-6, 5e-6},
                                                 PointDrift{11e-6, 1e-6}, PointDrift{1e-6, 1e-6}};
    CHECK_FALSE(best_window(study, 0, points, drift));
    study.limits.largest = 10e-6;
    CHECK(best_window(study, 0, points, drift)->steps[0] == Steps{0, 1});
    study.limits.final = 4e-6;
    CHECK(best_window(study, 0, points, drift)->steps[0] == Steps{0});
    study.limits.largest.reset();
    CHECK(best_window(study, 0, points, drift)->steps[0] == Steps{2, 3});
    drift[3].reset();
    CHECK(best_window(study, 0, points, drift)->points == 1);
}
