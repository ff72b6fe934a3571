/// Requirement: a case with free parameters is a function from their values to curves, with exact derivatives.
#include "deadpoint/twin/calibrate/forward.hpp"

#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/exchange/drift.hpp"
#include "deadpoint/press/result/run_result.hpp"
#include "deadpoint/twin/run/run_reduced.hpp"
#include "near.hpp"
#include "starter_press.hpp"

#include <algorithm>
#include <cmath>

using namespace deadpoint;
using namespace deadpoint::press;
using namespace deadpoint::twin;
using namespace deadpoint::full;
using Kind = CaseParameter::Kind;

namespace {

std::vector<CaseParameter> parameters()
{
    std::vector<CaseParameter> result{{"oil", {"oil.*"}, Kind::factor},
                                      {"friction", {"friction.*.viscous_part", "friction.*.load_part"}, Kind::factor},
                                      {"contact", {"joints.*.interfaces.*.resistance"}, Kind::factor},
                                      {"air", {"surfaces.air_*.film.coefficient"}, Kind::factor},
                                      {"speed", {"operation.*.speed"}, Kind::factor},
                                      {"room", {"machine.ambient"}, Kind::shift}};
    for (auto& parameter : result)
        parameter.keys = keys_of(starter_press::input(), parameter.keys, parameter.name);
    return result;
}

double size_of(const std::vector<double>& values)
{
    double largest = 0;
    for (const double value : values)
        largest = std::max(largest, std::abs(value));
    return largest;
}

/// Compares derivatives with central differences of fourth order, of all outputs by all parameters.
void check_derivatives(const std::vector<std::string>& settings, double step, double tolerance)
{
    Observer quiet;
    const auto all = parameters();
    const ForwardModel model(starter_press::input(settings), starter_press::press(), all, {step, 2, nullptr});
    const std::vector<double> theta{0.1, 0.05, -0.1, 0.2, 0.02, 0.5};
    const auto found = model.run(theta, true, quiet);
    REQUIRE(found.derivative.size() == all.size());
    for (std::size_t k = 0; k < all.size(); ++k) {
        const auto at = [&](double by) {
            auto moved = theta;
            moved[k] += by;
            return model.run(moved, false, quiet).value;
        };
        const double h = 4e-3;
        const auto more = at(h), less = at(-h), much_more = at(2 * h), much_less = at(-2 * h);
        for (std::size_t o = 0; o < model.outputs().size(); ++o) {
            std::vector<double> difference, error;
            for (std::size_t row = 0; row < found.time.size(); ++row) {
                difference.push_back((8 * (more[o][row] - less[o][row]) - (much_more[o][row] - much_less[o][row])) /
                                     (12 * h));
                error.push_back(found.derivative[k][o][row] - difference.back());
            }
            CHECK_MESSAGE(size_of(error) <= tolerance * size_of(difference),
                          all[k].name << ", " << model.outputs()[o].name << ": " << size_of(error) << " of "
                                      << size_of(difference));
        }
    }
}

}  // namespace

TEST_CASE("a pattern names keys by number or name, and a wrong one is told the nearest key")
{
    const auto input = starter_press::input();
    CHECK(keys_of(input, {"joints.crank_bearing.interfaces.back.conductance.resistance"}, "p") ==
          std::vector<std::string>{"joints.crank_bearing.interfaces.1.conductance.resistance"});
    CHECK(keys_of(input, {"oil.*", "oil.pins"}, "p") == std::vector<std::string>{"oil.pins"});
    CHECK_THROWS_WITH_AS(keys_of(input, {"oil.pin"}, "parameters.0"), doctest::Contains("'oil.pins'"), InputError);
}

TEST_CASE("settings of parameters make the case that they describe")
{
    const auto all = parameters();
    const std::vector<double> theta{0.3, -0.2, 0.5, 0.1, 0.05, 2};
    const auto direct = with_parameters(starter_press::input(), all, theta);
    const auto read = starter_press::input(settings_of(starter_press::input(), all, theta));
    CHECK(direct.oil.at("pins") == near(300 * std::exp(0.3), 1e-14));
    CHECK(direct.machine.ambient == near(295.15, 1e-14));
    CHECK(casefile::case_hash(direct) == casefile::case_hash(read));
}

TEST_CASE("curves are those of a reduced run, dimensions and corners included")
{
    Observer quiet;
    const ForwardModel model(starter_press::input(), starter_press::press(), {});
    const auto found = model.run({}, false, quiet);
    const auto run = run_reduced(starter_press::input(), starter_press::press(), {}, ReducedDetail::figures, quiet);
    const auto same = [&](const std::string& name, const std::vector<double>& expected, double tolerance) {
        const auto place = std::ranges::find(model.outputs(), name, &ForwardOutput::name);
        REQUIRE(place != model.outputs().end());
        const auto& values = found.value[static_cast<std::size_t>(place - model.outputs().begin())];
        REQUIRE(values.size() == expected.size());
        for (std::size_t row = 0; row < values.size(); ++row)
            CHECK(values[row] == near(expected[row], tolerance, tolerance));
    };
    CHECK(found.time == run.thermal.time);
    // The same numbers, but for the order of sums.
    same("slide", run.thermal.probes[1].value, 1e-12);
    same("E_SW", run.drift->gap.value, 1e-16);
    same("E_BG", run.drift->bearing_to_ground.value, 1e-16);
    same("E_WG", run.drift->table_to_ground.value, 1e-16);
    same("E_CS", run.drift->crank_to_slide.value, 1e-16);
    same("E_BC", run.drift->clearance.value, 1e-16);
    REQUIRE(!run.gaps.parallelism->corners.empty());
    const auto& corner = run.gaps.parallelism->corners.front();
    same("corner " + corner.name, corner.gap.value, 1e-16);
}

TEST_CASE("derivatives by every kind of parameter are those of whole runs with the same steps")
{
    // Without curved laws a stage is solved to rounding. h: the error h^4 of the differences is below 1e-8 of the
    // value; the rounding of a run, 1e-11 K, over h is 1e-8 K.
    check_derivatives({"friction.journals.viscous_part=0 W", "friction.pins.viscous_part=0 W",
                       "friction.gibs.viscous_part=0 W", "surfaces.air_frame.film.emissivity=0",
                       "surfaces.air_moving.film.emissivity=0"},
                      120, 1e-6);
}

TEST_CASE("derivatives where viscosity and radiation follow the temperature are right to Newton's tolerance")
{
    // Newton's method leaves up to 1e-5 of the heat of a stage (docs/reduced.md, Sensitivities), so that the
    // differences of runs scatter by several times that.
    check_derivatives({}, 10, 3e-4);
}

TEST_CASE("a parameter that a reduced model cannot change is refused")
{
    CHECK_THROWS_WITH_AS(ForwardModel(starter_press::input(), starter_press::press(),
                                      {{"steel", {"materials.steel.conductivity"}, Kind::factor}}),
                         doctest::Contains("'steel' changes what a reduced model cannot change"), InputError);
}
