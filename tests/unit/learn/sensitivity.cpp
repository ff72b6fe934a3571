/// Requirement: indices of a press are those of its runs, whatever the method; derivatives and bounds fit them.
#include "deadpoint/twin/explore/sensitivity.hpp"

#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/error.hpp"
#include "near.hpp"
#include "starter_press.hpp"

#include <algorithm>
#include <cmath>

using namespace deadpoint;
using namespace deadpoint::press;
using namespace deadpoint::twin;
using namespace deadpoint::full;
using casefile::VariedKeys;

namespace {

VariedKeys factor(const std::string& name, const std::string& pattern, double by)
{
    VariedKeys keys;
    keys.name = name;
    keys.keys = keys_of(starter_press::input(), {pattern}, name);
    keys.low = 1 / by;
    keys.high = by;
    return keys;
}

VariedKeys ambient(double by)
{
    VariedKeys keys{"room", {"machine.ambient"}, 0, "", "", "", VariedKeys::Kind::shift, -by, by};
    keys.dimension = Dimension::temperature;
    return keys;
}

VariedKeys speed(double low, double high)
{
    VariedKeys keys{"speed", {"operation.0.speed"}, 0, "", "", "", VariedKeys::Kind::value, low, high};
    keys.dimension = Dimension::angular_velocity;
    return keys;
}

casefile::SensitivitySection section(std::vector<VariedKeys> parameters)
{
    casefile::SensitivitySection result;
    result.parameters = std::move(parameters);
    result.outputs = {"E_SW", "slide"};
    result.points = 32;
    result.course_times = 2;
    return result;
}

SensitivityResult run(const casefile::SensitivitySection& wanted)
{
    Observer quiet;
    auto found = run_sensitivity(starter_press::input(), starter_press::press(), wanted, 2, quiet);
    REQUIRE(found.has_value());
    return std::move(*found);
}

}  // namespace

TEST_CASE("a range of values starts from its centre, and every share is a value of the case")
{
    auto input = starter_press::input();
    const auto varied = varied_case(input, {speed(4, 9), ambient(2), factor("oil", "oil.pins", 3)});
    CHECK(input.operation[0].speed == near(6, 1e-5));  // geometric mean
    const auto theta = thetas_at(varied.ranges, {1, 0.25, 0});
    const auto at = with_parameters(input, varied.parameters, theta);
    CHECK(at.operation[0].speed == near(9, 1e-14));
    CHECK(at.machine.ambient == near(input.machine.ambient - 1, 1e-14));
    CHECK(at.oil.at("pins") == near(100, 1e-14));
    for (std::size_t k = 0; k < 3; ++k) {
        const double h = 1e-6;
        CHECK(varied.ranges[k].theta_slope(0.3) ==
              near((varied.ranges[k].theta_at(0.3 + h) - varied.ranges[k].theta_at(0.3 - h)) / (2 * h), 1e-8));
    }
}

TEST_CASE("figures at times, at the end and times to warm have the derivatives of their differences")
{
    Observer quiet;
    const auto input = starter_press::input({"friction.journals.viscous_part=0 W", "friction.pins.viscous_part=0 W",
                                             "friction.gibs.viscous_part=0 W", "surfaces.air_frame.film.emissivity=0",
                                             "surfaces.air_moving.film.emissivity=0"});
    const std::vector<CaseParameter> parameters{{"oil", {"oil.pins"}, CaseParameter::Kind::factor}};
    const ForwardModel model(input, starter_press::press(), parameters, {30, 1, nullptr});
    const auto slide = static_cast<std::size_t>(std::ranges::find(model.outputs(), "slide", &ForwardOutput::name) -
                                                model.outputs().begin());
    const std::vector<Figure> figures{
        {Figure::Kind::at_time, slide, 1000}, {Figure::Kind::end, slide, 0}, {Figure::Kind::warm, slide, 0}};
    const auto at = [&](double theta) { return figures_of(model, model.run({theta}, false, quiet), figures); };
    const auto slopes = figure_slopes(model, model.run({0.1}, true, quiet), figures);
    const double h = 2e-3;
    const auto more = at(0.1 + h), less = at(0.1 - h);
    // The error of the differences is h^2 of the value; a kink of the straight pieces between rows of 30 s is missed.
    for (std::size_t f = 0; f < figures.size(); ++f)
        CHECK(slopes[0][f] == near((more[f] - less[f]) / (2 * h), 1e-4));
    CHECK(at(0.1)[2] > 1000);
    CHECK(at(0.1)[2] < 3600);
}

TEST_CASE("the room explains a temperature that nothing else heats, and shares add up without interaction")
{
    auto wanted =
        section({ambient(3), factor("oil", "oil.pins", 1.5), factor("friction", "friction.*.load_part", 1.3)});
    wanted.points = 128;
    const auto found = run(wanted);
    CHECK(found.runs == 128 * 5);
    CHECK(found.failed == 0);
    REQUIRE(found.figures.size() == 4);
    REQUIRE(found.course.size() == 4);
    for (const auto& figure : found.figures) {
        double first = 0, total = 0;
        for (const auto& index : figure.sobol.inputs) {
            first += index.first.value;
            total += index.total.value;
        }
        if (figure.figure.kind == Figure::Kind::warm)
            continue;
        // Nearly a sum of three terms: interactions of some hundredths of the spread; 128 points give 0.05.
        CHECK(first == near(1, 0.07));
        CHECK(total == near(1, 0.07));
    }
    // The course at the end is the figure at the end.
    CHECK(found.course[1].sobol.inputs[0].total.value == near(found.figures[0].sobol.inputs[0].total.value, 1e-5));
}

TEST_CASE("Sobol' indices of a nearly linear figure are the squares of its derivatives, and Morris ranks alike")
{
    Observer quiet;
    // Narrow ranges: theta uniform, f = f0 + g u, S = g^2 / sum g^2 but for some hundredths.
    auto wanted = section({factor("oil", "oil.pins", 1.1), factor("friction", "friction.*.load_part", 1.1),
                           factor("contact", "joints.*.interfaces.*.resistance", 1.1)});
    wanted.points = 128;
    wanted.gradients = 4;
    const auto found = run(wanted);
    auto input = starter_press::input();
    const auto varied = varied_case(input, wanted.parameters);
    const ForwardModel model(input, starter_press::press(), varied.parameters);
    const auto end = std::ranges::find(found.figures, Figure::Kind::end,
                                       [](const FigureSensitivity& one) { return one.figure.kind; });
    const auto slopes = figure_slopes(model, model.run({0, 0, 0}, true, quiet), {end->figure});
    double sum = 0;
    for (const auto& of : slopes)
        sum += of[0] * of[0];
    for (std::size_t k = 0; k < 3; ++k) {
        const double share = slopes[k][0] * slopes[k][0] / sum;
        CHECK(end->sobol.inputs[k].total.value == near(share, 0.05, 0.05));
        CHECK(end->sobol.inputs[k].first.value == near(share, 0.05, 0.05));
        // 12 / pi^2 of the index for a straight line, from 4 points.
        CHECK(end->bound[k] == near(1.2159 * end->sobol.inputs[k].total.value, 0.03, 0.03));
    }
    wanted.method_name = "morris";
    wanted.gradients = 0;
    wanted.trajectories = 4;
    const auto screened = run(wanted);
    CHECK(screened.runs == 16);
    for (std::size_t k = 0; k < 3; ++k) {
        const auto& effect = screened.figures[0].morris[k];
        CHECK(std::abs(effect.mean) == near(std::abs(slopes[k][0]) * 2 * std::log(1.1), 0.05));
    }
}

TEST_CASE("what the model cannot change, and outputs that it has not, are refused before anything runs")
{
    CHECK_THROWS_WITH_AS(run(section({factor("steel", "materials.steel.conductivity", 2)})),
                         doctest::Contains("'steel' changes what a reduced model cannot change"), InputError);
    auto wanted = section({ambient(1)});
    wanted.outputs = {"corner nowhere"};
    CHECK_THROWS_WITH_AS(run(wanted), doctest::Contains("its outputs are"), InputError);
    wanted = section({ambient(1)});
    wanted.points = 65536;
    wanted.course_times = 1000;
    CHECK_THROWS_WITH_AS(run(wanted), doctest::Contains("take fewer points"), InputError);
}

TEST_CASE("samples hold the values of the ranges, and a cancelled study gives nothing")
{
    auto wanted = section({speed(5, 6), ambient(2)});
    wanted.method_name = "morris";
    wanted.trajectories = 2;
    wanted.samples = true;
    const auto found = run(wanted);
    REQUIRE(found.points.size() == 6);
    for (const auto& point : found.points) {
        CHECK(point[0] >= 5);
        CHECK(point[0] <= 6);
        CHECK(std::abs(point[1]) <= 2);
    }
    CHECK(found.values[0].size() == found.figures.size());

    struct Cancelled : Observer {
        [[nodiscard]] bool cancelled() const override { return true; }
    } stopped;
    CHECK_FALSE(run_sensitivity(starter_press::input(), starter_press::press(), wanted, 1, stopped).has_value());
}
