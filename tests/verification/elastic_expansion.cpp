#include "deadpoint/exchange/face_points.hpp"
#include "deadpoint/exchange/laws/material.hpp"
#include "deadpoint/fem/estimate/pod.hpp"
#include "deadpoint/fem/model.hpp"
#include "deadpoint/full/fields/view_recorder.hpp"
#include "deadpoint/press/problem/heat.hpp"
#include "deadpoint/press/translate/lookup.hpp"
#include "deadpoint/press/translate/materials.hpp"
#include "near.hpp"
#include "solved_case.hpp"

#include <cmath>

// Expansion that follows the temperature. The bar of bar.toml is 1.04 m long.

using namespace deadpoint;

namespace {

Observer silent;

constexpr double reference = verification::zero_celsius + 20;
constexpr double length = 1.04;

/// One dilatation curve, eps = a (T - 20 degC) + b (T - 20 degC)^2, as either kind of table; both are exact, since one
/// coefficient is linear where the other is.
constexpr double first = 1.1e-5, second = 6e-9;
double strain(double temperature)
{
    return first * (temperature - reference) + second * std::pow(temperature - reference, 2);
}

casefile::Case with_table(const std::string& kind)
{
    auto input = verification::read("bar");
    const double slope = kind == "mean" ? second : 2 * second;
    auto& steel = input.materials.at("steel");
    steel.expansion_table = {{reference - 50, reference + 150}, {first - 50 * slope, first + 150 * slope}};
    using Kind = casefile::Material::Expansion;
    steel.expansion_kind = kind == "mean" ? Kind::mean : Kind::instantaneous;
    if (kind == "mean")
        steel.expansion_reference = reference;
    return input;
}

Functional mean_height(const Machine& machine, const std::string& surface, double sign)
{
    Functional result{"height", {}};
    double area = 0;
    for (const auto& entry : machine.surfaces[press::surface_index(machine, surface)].faces)
        for (const auto& point : face_points(machine, machine.faces[entry.face])) {
            result.points.push_back({entry.face, point.position, {0, sign * point.weight, 0}});
            area += point.weight;
        }
    for (auto& point : result.points)
        point.weight[1] /= area;
    return result;
}

struct Bar {
    casefile::Case input;
    Machine machine;
    fem::Model model;
    Functional stretch;

    explicit Bar(const casefile::Case& c)
        : input(c), machine(full::prepare_machine(input, 1, silent)),
          model(machine, press::describe_materials(input, machine), 1, silent), stretch(mean_height(machine, "top", 1))
    {
        const auto bottom = mean_height(machine, "bottom", -1);
        stretch.points.insert(stretch.points.end(), bottom.points.begin(), bottom.points.end());
        model.support(-1);
    }
    double direct(const fem::Field& field, double start)
    {
        return model.evaluate({stretch}, model.displacement(field, start)).front();
    }
};

fem::Field along_bar(const fem::Model& model)
{
    return model.interpolate_field([](const Vec3& x) { return reference + 10 + 90 * x[1] * x[1]; });
}

}  // namespace

TEST_CASE("a free bar whose expansion follows the temperature, by mean and by instantaneous coefficients")
{
    for (const char* kind : {"mean", "instantaneous"}) {
        CAPTURE(kind);
        Bar bar(with_table(kind));
        const auto warm = bar.model.constant_field(reference + 80);
        // Even strain is in the finite-element space: only rounding remains. It counts from where the run starts.
        CHECK(bar.direct(warm, reference) == near(strain(reference + 80) * length, 1e-9));
        CHECK(bar.direct(warm, reference + 20) ==
              near((strain(reference + 80) - strain(reference + 20)) * length, 1e-9));
        CHECK(std::abs(bar.direct(warm, reference + 80)) < 1e-12);
    }
}

TEST_CASE("both kinds of one dilatation curve bend a bar alike, and adjoints give what the deformation gives")
{
    constexpr double start = reference + 20;
    Bar by_mean(with_table("mean")), by_slope(with_table("instantaneous"));
    const auto field = along_bar(by_mean.model);
    const double u = by_mean.direct(field, start);
    CHECK(by_slope.direct(field, start) == near(u, 1e-9));
    const auto adjoint = by_mean.model.adjoints({by_mean.stretch}).front();
    CHECK(by_mean.model.apply(adjoint, field, start) == near(u, 1e-9));
    // The mean height of the ends is the integral of the strain over the volume by the section (Betti), exactly; the
    // strain is interpolated between nodes 31 mm apart at most.
    double whole = 0;
    constexpr int parts = 10000;
    for (int i = 0; i < parts; ++i) {
        const double y = -0.02 + length * (i + 0.5) / parts;
        whole += (strain(reference + 10 + 90 * y * y) - strain(start)) * length / parts;
    }
    CHECK(u == near(whole, 2e-3));

    const auto secant = by_mean.model.secant(adjoint, field, start);
    double sum = 0;
    for (std::size_t i = 0; i < secant.owned.size(); ++i)
        sum += secant.owned[i] * (field.owned[i] - start);
    CHECK(sum == near(u, 1e-9));
    CHECK_FALSE(by_mean.model.expands_linearly());
    CHECK(Bar(verification::read("bar")).model.expands_linearly());
}

TEST_CASE("a table of one coefficient gives the constant's deformation")
{
    auto input = verification::read("bar");
    Bar plain(input);
    input.materials.at("steel").expansion_table = {{250, 400}, {1.2e-5, 1.2e-5}};
    input.materials.at("steel").expansion_kind = casefile::Material::Expansion::instantaneous;
    Bar table(input);
    const auto field = along_bar(plain.model);
    CHECK(table.direct(field, 300) == near(plain.direct(field, 300), 1e-12));
    CHECK(table.model.apply(table.model.adjoints({table.stretch}).front(), field, 300) ==
          near(plain.model.apply(plain.model.adjoints({plain.stretch}).front(), field, 300), 1e-12));
}

TEST_CASE("a run that starts at 40 degC: the history's functional, its rate and its split by part")
{
    auto input = with_table("mean");
    input.machine.initial_temperature = reference + 20;
    input.heat_sources["heater"] = {{"lower"}, "", casefile::Course{400, {}, {}}, true};
    Bar bar(input);
    auto problem = press::describe_heat(input, bar.machine, silent);
    const auto adjoints = bar.model.adjoints({bar.stretch});
    bar.model.assemble_heat(problem);
    double at_end = 0;
    const auto history = bar.model.heat(adjoints, reference + 20, 0, silent, {}, {});
    problem.field_times = {3600};
    bar.model.assemble_heat(problem);
    (void)bar.model.heat(adjoints, reference + 20, 0, silent, {},
                         [&](double, const fem::Field& field) { at_end = bar.direct(field, reference + 20); });
    const auto& series = history.functionals[0];
    CHECK(series.value.front() == 0);
    CHECK(series.value.back() == near(at_end, 1e-8));
    CHECK(at_end > 1e-5);
    double sum = 0;
    for (const auto& part : history.contributions)
        sum += part.back();
    CHECK(sum == near(series.value.back(), 1e-12));
    const auto i = history.time.size() - 2;
    const double secant = (series.value[i + 1] - series.value[i]) / (history.time[i + 1] - history.time[i]);
    // The mean of both ends' rates, to second order in the step.
    CHECK(0.5 * (series.rate[i] + series.rate[i + 1]) == near(secant, 1e-2));
}

TEST_CASE("the page's deformation by modes, where it does not follow the temperature linearly")
{
    Bar bar(with_table("instantaneous"));
    full::ViewRecorder recorder;
    const std::vector<double> times{0, 0.3, 0.6, 1};
    const auto field = [&](double t) {
        return bar.model.interpolate_field([&](const Vec3& x) { return reference + 100 * t * x[1] + 20 * t * t; });
    };
    for (const double t : times)
        recorder.add(t, field(t));
    const auto none = [&](const fem::Displacement&) { return std::vector<RigidMotion>(bar.machine.parts.size()); };
    const auto view = recorder.finish(bar.machine, bar.model, reference, none);
    const auto direct = bar.model.at_corners(view.surface.vertices, bar.model.displacement(field(1), reference));
    double largest = 0;
    for (std::size_t v = 0; v < direct.size(); ++v) {
        auto u = view.displacement.base[v];
        double t = view.temperature.base[v];
        for (std::size_t k = 0; k < view.displacement.modes.size(); ++k)
            u = u + view.coefficients[k][3] * view.displacement.modes[k][v];
        for (std::size_t k = 0; k < view.temperature.modes.size(); ++k)
            t += view.coefficients[k][3] * view.temperature.modes[k][v];
        largest = std::max(largest, norm(u - direct[v]));
        CHECK(t == near(reference + 100 * view.surface.positions[v][1] + 20, 1e-4));
    }
    // The modes that are solved leave out 2.5 % of the rise at most.
    CHECK(largest < full::view_deformation_tolerance * strain(reference + 120) * length);
}
