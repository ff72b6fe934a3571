#include "deadpoint/fem/estimate/pod.hpp"
#include "deadpoint/fem/model.hpp"
#include "deadpoint/full/fields/view_recorder.hpp"
#include "deadpoint/press/problem/heat.hpp"
#include "deadpoint/press/run/field_times.hpp"
#include "deadpoint/press/translate/materials.hpp"
#include "near.hpp"
#include "solved_case.hpp"

#include <cmath>
#include <numbers>

using namespace deadpoint;

namespace {

Observer silent;

struct Bar {
    Machine machine;
    fem::Model model;
    Bar()
        : machine(full::prepare_machine(verification::read("bar"), 1, silent)),
          model(machine, press::describe_materials(verification::read("bar"), machine), 1, silent)
    {
        model.support(-1);
    }
    [[nodiscard]] std::vector<RigidMotion> at_rest() const { return std::vector<RigidMotion>(machine.parts.size()); }
};

constexpr double start = 293.15;

/// A field that needs three modes: two shapes and, 1000 times weaker, a third.
double temperature(const Vec3& x, double t)
{
    return start + 40 * t * x[1] + 15 * t * t * std::cos(20 * x[0]) +
           0.02 * std::sin(std::numbers::pi * t) * x[2] / 0.05;
}

std::vector<float> snapshot(const fem::Field& field) { return {field.owned.begin(), field.owned.end()}; }

/// A temperature or displacement of a view at one of its times.
template <class Value>
Value sum_of(const press::ModalField<Value>& field, const press::ViewData& view, std::size_t vertex, std::size_t time)
{
    Value value = field.base[vertex];
    for (std::size_t k = 0; k < field.modes.size(); ++k)
        value = value + view.coefficients[k][time] * field.modes[k][vertex];
    return value;
}

}  // namespace

TEST_CASE("modes: fields of rank two need two modes, whatever the number of times")
{
    const Bar bar;
    std::vector<std::vector<float>> fields;
    for (const double t : {0.0, 0.1, 0.3, 0.6, 0.8, 1.0})
        fields.push_back(snapshot(bar.model.interpolate_field(
            [&](const Vec3& x) { return start + 40 * t * x[1] + 15 * t * t * std::cos(20 * x[0]); })));
    const auto modes = fem::pod(fields, 1e-5, 10);
    CHECK(modes.modes.size() == 2);
    // 40 K per metre at the top of the upper cap, 1.02 m up, and 15 K on the axis
    CHECK(modes.largest_rise == near(1.02 * 40 + 15, 1e-2));
    REQUIRE(modes.residual_energy.size() == 2);
    CHECK(modes.residual_energy[0] == near(1, 1e-5));
    CHECK(modes.residual_energy[1] > 0.01);  // neither shape is small beside the other
    CHECK(modes.residual_energy[1] < 0.7);
    CHECK(modes.error < 1e-4);  // float: 6e-8 of 330 K, a few times over
}

TEST_CASE("modes: what is left out stays below the tolerance, and the error told is the error made")
{
    const Bar bar;
    const std::vector<double> times{0.0, 0.2, 0.4, 0.6, 0.8, 1.0};
    std::vector<std::vector<float>> fields;
    for (const double t : times)
        fields.push_back(snapshot(bar.model.interpolate_field([&](const Vec3& x) { return temperature(x, t); })));
    for (const double tolerance : {0.3, 0.005, 1e-6}) {
        const auto modes = fem::pod(fields, tolerance, 10);
        CHECK(modes.error <= tolerance * modes.largest_rise);
        double largest = 0;
        for (std::size_t j = 0; j < times.size(); ++j)
            for (std::size_t i = 0; i < fields[j].size(); ++i) {
                double value = modes.base.owned[i];
                for (std::size_t k = 0; k < modes.modes.size(); ++k)
                    value += modes.coefficients[k][j] * modes.modes[k].owned[i];
                largest = std::max(largest, std::abs(value - static_cast<double>(fields[j][i])));
            }
        CHECK(largest == near(modes.error, 0.02, 0.02 * 1e-3));
    }
    CHECK(fem::pod(fields, 0.005, 10).modes.size() == 2);
    CHECK(fem::pod(fields, 1e-9, 1).modes.size() == 1);
}

TEST_CASE("modes: a field that does not change needs none")
{
    const Bar bar;
    const auto field = snapshot(bar.model.constant_field(300));
    const auto modes = fem::pod({field, field}, 0.005, 10);
    CHECK(modes.modes.empty());
    CHECK(modes.largest_rise == 0);
    CHECK(modes.base.owned.front() == near(300, 1e-5));
}

TEST_CASE("view: a bar that warms evenly grows by alpha dT x at every vertex and time")
{
    Bar bar;
    full::ViewRecorder recorder;
    for (const double t : {0.0, 1.0, 2.0, 4.0})
        recorder.add(t, bar.model.constant_field(start + 10 * t));
    const auto view =
        recorder.finish(bar.machine, bar.model, start, [&](const fem::Displacement&) { return bar.at_rest(); });
    CHECK(recorder.empty());
    CHECK(view.largest_rise == near(40, 1e-5));
    REQUIRE(view.coefficients.size() == 1);
    const auto& place = view.surface.positions;
    for (std::size_t j = 0; j < view.time.size(); ++j)
        for (std::size_t v = 0; v < place.size(); v += 17) {
            CHECK(sum_of(view.temperature, view, v, j) == near(start + 10 * view.time[j], 1e-7));
            const Vec3 grown = sum_of(view.displacement, view, v, j) - sum_of(view.displacement, view, 0, j);
            const Vec3 expected = 1.2e-5 * 10 * view.time[j] * (place[v] - place[0]);
            CHECK(norm(grown - expected) < 1e-6 * 1.2e-5 * 40);  // the solver's tolerance and the snapshots' floats
        }
}

TEST_CASE("view: the deformation from the modes is the one solved at that time, moved by the joints")
{
    Bar bar;
    full::ViewRecorder recorder;
    const std::vector<double> times{0.0, 0.25, 0.5, 1.0};
    for (const double t : times)
        recorder.add(t, bar.model.interpolate_field([&](const Vec3& x) { return temperature(x, t); }));
    // A closing motion that is linear in the deformation, as that of a linkage is.
    const auto close = [&](const fem::Displacement& u) {
        auto motions = bar.at_rest();
        const auto at_first = bar.model.at_corners({CellCorner{0, 0}}, u).front();
        for (auto& motion : motions)
            motion = {{3 * at_first[0], at_first[1]}, at_first[2], {0.1, 0.2}};
        return motions;
    };
    const auto view = recorder.finish(bar.machine, bar.model, start, close);
    CHECK(view.error <= full::view_tolerance * view.largest_rise);
    for (const std::size_t j : {std::size_t{1}, std::size_t{3}}) {
        const auto field = bar.model.interpolate_field([&](const Vec3& x) { return temperature(x, times[j]); });
        const auto u = bar.model.displacement(field, start);
        const auto direct = bar.model.at_corners(view.surface.vertices, u);
        const auto motion = close(u).front();
        for (std::size_t v = 0; v < direct.size(); v += 7) {
            const Vec3 expected = direct[v] + rigid_displacement(motion, view.surface.positions[v]);
            // What is left out is at most 0.5 % of 36 K over a length of 1 m, times four by the closing motion.
            CHECK(norm(sum_of(view.displacement, view, v, j) - expected) < 4 * 1.2e-5 * view.error * 1.04);
        }
    }
}

TEST_CASE("view times: from start to end, denser after each segment's start, never many")
{
    const auto segments = [](std::vector<double> durations) {
        std::vector<HeatSegment> result(durations.size());
        for (std::size_t i = 0; i < durations.size(); ++i)
            result[i].duration = durations[i];
        return result;
    };
    const auto one = press::view_times(segments({3600}));
    CHECK(one.size() == 37);
    CHECK(one[1] == near(3600.0 / (36 * 36), 1e-5));
    const auto three = press::view_times(segments({3600, 60, 7200}));
    CHECK(std::ranges::count(three, 3600) == 1);
    CHECK(std::ranges::count(three, 3660) == 1);
    CHECK(press::view_times(segments(std::vector<double>(200, 10.0))).size() == 37);
    for (const auto& times : {one, three}) {
        CHECK(times.front() == 0);
        CHECK(std::ranges::is_sorted(times, std::less_equal<>()));
    }
    CHECK(three.back() == 10860);
}
