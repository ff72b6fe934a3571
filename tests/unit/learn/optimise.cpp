/// Requirement: objectives have the derivatives of their differences, and a search finds what a scan finds.
#include "deadpoint/twin/explore/optimise.hpp"

#include "deadpoint/error.hpp"
#include "deadpoint/twin/explore/objectives.hpp"
#include "near.hpp"
#include "starter_press.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

using namespace deadpoint;
using namespace deadpoint::press;
using namespace deadpoint::twin;
using namespace deadpoint::full;

namespace {

/// Laws that do not follow the temperature, so that a stage is solved to rounding.
casefile::Case smooth_press(std::vector<std::string> more = {})
{
    more.insert(more.end(), {"friction.journals.viscous_part=0 W", "friction.pins.viscous_part=0 W",
                             "friction.gibs.viscous_part=0 W", "surfaces.air_frame.film.emissivity=0",
                             "surfaces.air_moving.film.emissivity=0"});
    return starter_press::input(std::move(more));
}

/// E(t) = A (1 - exp(-t / tau)) with derivatives by A and tau, every minute over two hours.
GapCourse exponential(double amplitude, double tau)
{
    GapCourse course;
    course.derivative.resize(2);
    for (double t = 0; t <= 7200; t += 60) {
        course.time.push_back(t);
        course.value.push_back(amplitude * (1 - std::exp(-t / tau)));
        course.derivative[0].push_back(1 - std::exp(-t / tau));
        course.derivative[1].push_back(-amplitude * t / (tau * tau) * std::exp(-t / tau));
    }
    return course;
}

casefile::VariedKeys varied(const std::string& name, const std::string& key, double low, double high,
                            Dimension dimension)
{
    casefile::VariedKeys keys;
    keys.name = name;
    keys.keys = {key};
    keys.kind = casefile::VariedKeys::Kind::value;
    keys.low = low;
    keys.high = high;
    keys.dimension = dimension;
    return keys;
}

void check_slopes(const Judged& found, const std::function<double(std::size_t, double)>& at, double step,
                  double tolerance)
{
    for (std::size_t k = 0; k < found.slope.size(); ++k) {
        // Central differences of fourth order.
        const double difference =
            (8 * (at(k, step) - at(k, -step)) - (at(k, 2 * step) - at(k, -2 * step))) / (12 * step);
        CHECK_MESSAGE(found.slope[k] == near(difference, tolerance), "variable " << k);
    }
}

}  // namespace

TEST_CASE("objectives of an exponential are those worked out by hand, with their derivatives")
{
    const double a = 5e-5, tau = 1800, rate = 1e-6 / 3600 * 5;
    const auto course = exponential(a, tau);
    // |dE/dt| = a / tau exp(-t / tau) = rate; the steps of a minute shift it by (60 s)^2 / 24 tau = 0.08 s.
    CHECK(warm_time(course, rate).value == near(tau * std::log(a / tau / rate), 2e-4));
    // Over 0..T: E^2 has the mean a^2 (1 - 2 tau/T (1 - e) + tau/2T (1 - e^2)), e = exp(-T / tau).
    const double t = 7200, e = std::exp(-t / tau);
    const double mean = a * a * (1 - 2 * tau / t * (1 - e) + tau / (2 * t) * (1 - e * e));
    CHECK(drift_of(course, 0).value == near(std::sqrt(mean), 1e-3));
    CHECK(ambient_effect(exponential(3 * a, tau), exponential(a, tau), 2, 0).value ==
          near(drift_of(course, 0).value / 2, 1e-12));
    const auto shifted = [&](std::size_t k, double by) {
        return exponential(k == 0 ? a * (1 + by) : a, k == 1 ? tau * (1 + by) : tau);
    };
    const std::vector<std::function<Judged(const GapCourse&)>> objectives{
        [&](const GapCourse& c) { return warm_time(c, rate); }, [](const GapCourse& c) { return drift_of(c, 1000); },
        [&](const GapCourse& c) { return largest_rate(c, rate, 3000); },
        [&](const GapCourse& c) { return warm_time(c, rate / 100); }};  // not reached
    for (const auto& objective : objectives) {
        auto found = objective(course);
        found.slope[0] *= a;
        found.slope[1] *= tau;
        check_slopes(
            found, [&](std::size_t k, double by) { return objective(shifted(k, by)).value; }, 1e-4, 1e-6);
    }
    CHECK(warm_time(course, rate / 100).value > 7200);
    CHECK(warm_time(course, 1).value == 0);
}

TEST_CASE("objectives of a press have the derivatives of whole runs with the same steps to 1e-6")
{
    Observer quiet;
    const auto input = divided(smooth_press(), {0, {600, 1500}, 4, 9, {}});
    const std::vector<CaseParameter> parameters{{"first", {"operation.0.speed"}, CaseParameter::Kind::factor},
                                                {"second", {"operation.1.speed"}, CaseParameter::Kind::factor},
                                                {"oil", {"oil.pins"}, CaseParameter::Kind::factor}};
    const auto course_of = [&](double ambient, const std::vector<double>& theta, bool derivatives) {
        auto changed = input;
        changed.machine.ambient += ambient;
        const ForwardModel model(changed, starter_press::press(), parameters, {60, 1, nullptr});
        return gap_course(model, model.run(theta, derivatives, quiet));
    };
    const std::vector<double> theta{0.05, -0.03, 0.1};
    const auto first = course_of(0, theta, false);
    // A rate that is reached late, half way between the middles of two steps: times to warm have a kink at each middle,
    // from which the differences stay away.
    const auto late = static_cast<std::size_t>(0.8 * static_cast<double>(first.time.size()));
    const double rate =
        std::abs(first.value[late + 1] - first.value[late - 1]) / (first.time[late + 1] - first.time[late - 1]);
    using Objective = std::function<Judged(const std::vector<double>&, bool)>;
    const std::vector<std::pair<const char*, Objective>> objectives{
        {"warm-up", [&](const auto& at, bool d) { return warm_time(course_of(0, at, d), rate); }},
        {"drift", [&](const auto& at, bool d) { return drift_of(course_of(0, at, d), 1200); }},
        {"ambient",
         [&](const auto& at, bool d) { return ambient_effect(course_of(2, at, d), course_of(-2, at, d), 2, 1200); }},
        {"rates", [&](const auto& at, bool d) { return largest_rate(course_of(0, at, d), rate, 1800); }}};
    for (const auto& [name, objective] : objectives) {
        CAPTURE(name);
        const auto found = objective(theta, true);
        REQUIRE(found.slope.size() == 3);
        double largest = 0;
        for (const double slope : found.slope)
            largest = std::max(largest, std::abs(slope));
        for (std::size_t k = 0; k < 3; ++k) {
            const auto at = [&](double by) {
                auto moved = theta;
                moved[k] += by;
                return objective(moved, false).value;
            };
            const double h = std::string(name) == "warm-up" ? 1e-3 : 4e-3;
            const double difference = (8 * (at(h) - at(-h)) - (at(2 * h) - at(-2 * h))) / (12 * h);
            // The ambient does not move what speeds do: those derivatives are zero but for rounding.
            CHECK_MESSAGE(std::abs(found.slope[k] - difference) <=
                              1e-6 * std::max(largest, 1e-3 * std::abs(found.value)),
                          "variable " << k << ": " << found.slope[k] << ", " << difference);
        }
    }
}

TEST_CASE("a divided segment takes as long as before, and its pieces start as it did")
{
    const auto input = starter_press::input();
    const auto pieces = divided(input, {0, {600, 1500}, 4, 9, {}}).operation;
    REQUIRE(pieces.size() == 3);
    CHECK(pieces[0].duration == 600);
    CHECK(pieces[1].duration == 900);
    CHECK(pieces[2].duration == near(2100, 1e-5));
    CHECK(pieces[1].speed == input.operation[0].speed);
    CHECK(pieces[1].force == input.operation[0].force);
}

TEST_CASE("a search finds the optimum that a scan finds, from all starts, under limits")
{
    Observer quiet;
    casefile::OptimiseSection section;
    section.objective_name = "drift";
    section.from = 1200;
    section.starts = 2;
    section.variables = {varied("speed", "operation.0.speed", 4, 9, Dimension::angular_velocity)};
    // Less speed, less heat, less drift: the limit of a probe from below stops it.
    const auto limited = [&](double least) {
        section.limits = {{"slide", "", "", 3000, {}, least}};
        return *run_optimise(smooth_press(), starter_press::press(), section, 1, quiet);
    };
    section.limits.clear();
    const auto free = *run_optimise(smooth_press(), starter_press::press(), section, 1, quiet);
    CHECK(free.feasible);
    CHECK(free.minima == 1);
    CHECK(free.optimum.operation[0].speed == near(4, 1e-6));
    CHECK(free.after.drift < free.before.drift);
    CHECK(free.starts[free.best].minimum.value == near(free.after.drift, 1e-9));

    // The same drift by a run of the case at the optimum.
    const ForwardModel model(free.optimum, starter_press::press(), {}, {section.step, 1, nullptr});
    CHECK(drift_of(gap_course(model, model.run({}, false, quiet)), 1200).value == near(free.after.drift, 1e-9));

    const auto slide = static_cast<std::size_t>(std::ranges::find(model.outputs(), "slide", &ForwardOutput::name) -
                                                model.outputs().begin());
    auto half = smooth_press({"operation.0.speed=6 rad/s"});
    const ForwardModel at_six(half, starter_press::press(), {}, {section.step, 1, nullptr});
    const auto course = at_six.run({}, false, quiet);
    double least = 1e9;
    for (std::size_t row = 0; row < course.time.size(); ++row)
        if (course.time[row] >= 3000)
            least = std::min(least, course.value[slide][row]);
    const auto kept = limited(least);
    CHECK(kept.feasible);
    // The limit holds at 40 times from 3000 s on, of which the first is 15 s later, where the probe is warmer by 0.002
    // K.
    CHECK(kept.optimum.operation[0].speed == near(6, 0.01));
    CHECK(kept.after.extremes[0] == near(least, 1e-4));
    CHECK_FALSE(limited(400).feasible);
}

TEST_CASE("a profile with a least mean speed keeps it, and a warm-up gets no longer than it was")
{
    Observer quiet;
    casefile::OptimiseSection section;
    section.objective_name = "warm-up";
    section.rate = 2e-5 / 3600;
    section.starts = 1;
    section.evaluations = 15;
    section.speed_profile = casefile::SpeedProfile{0, {600, 1200}, 3, 9, 5};
    const auto found = *run_optimise(smooth_press(), starter_press::press(), section, 1, quiet);
    CHECK(found.feasible);
    CHECK(found.starts[0].minimum.steps.size() == found.starts[0].stages.size());
    const auto& operation = found.optimum.operation;
    CHECK((operation[0].speed + operation[1].speed) / 2 >= 5 * (1 - 1e-3));
    CHECK(operation[2].speed == smooth_press().operation[0].speed);
    REQUIRE(found.after.warm);
    CHECK(*found.after.warm <= found.before.warm.value_or(3600) + 1);
}
