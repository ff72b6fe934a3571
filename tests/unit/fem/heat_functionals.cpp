/// Requirement: means, loads, probes and load zones of a heat problem are the integrals they are named after.
#include "deadpoint/fem/conduction/terms/heat_functionals.hpp"

#include "bricks.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/exchange/heat.hpp"
#include "deadpoint/exchange/machine.hpp"
#include "near.hpp"

#include <doctest/doctest.h>
#include <numeric>

using namespace deadpoint;
using namespace deadpoint::fem;

namespace {

/// Blocks of 2 and 1 m3 that meet at z = 1 over 2 x 1 m2; a surface on top and half of one at the front.
Machine blocks()
{
    auto machine = bricks::machine_of(
        {{{0, 0, 0}, {2, 1, 1}, {2, 1, 2}, false, {}}, {{0, 0, 1}, {2, 1, 1.5}, {3, 2, 1}, false, {}}});
    machine.interfaces = {bricks::contact(machine, 0, 1, 2)};
    machine.interfaces[0].name = "guide.face";
    bricks::add_surface(machine, 1, 2, true);
    bricks::add_surface(machine, 0, 1, false, 0.5);
    return machine;
}

HeatProblem problem()
{
    HeatProblem result;
    InterfaceLaw law;
    law.film_a = law.film_b = 100;
    law.source = 0;
    result.interfaces = {law};
    result.sources = {{"pin", 1, {}, {}}};
    result.body_heat = {{"motor", {0, 1}, -1}, {"lamp", {}, 0}};
    result.surfaces.resize(3);
    result.surfaces[0].surface = 0;
    result.surfaces[1].surface = 1;
    result.surfaces[2].surface = 0;
    result.surfaces[2].kind = SurfaceCondition::Kind::temperature;
    result.probes = {{"tip", 1, {0.3, 0.4, 1.2}}, {"root", 0, {1.9, 0.9, 0.1}}};
    return result;
}

double field(const Vec3& x) { return 300 + 2 * x[0] - 3 * x[1] + 8 * x[2]; }

struct Functionals {
    explicit Functionals(int order, HeatProblem input = problem())
        : both(blocks(), {order, order}), given(std::move(input)), functionals(both.space, given),
          temperature(bricks::vector_of(both.space, field))
    {}
    [[nodiscard]] double value(std::size_t functional) const
    {
        return functionals.evaluate(std::array{functional}, temperature)[0];
    }
    /// Sum of a functional's weights: the watts of its load.
    [[nodiscard]] double watts(std::size_t functional) const
    {
        const auto& weight = functionals[functional].weight;
        return std::accumulate(weight.begin(), weight.end(), 0.0);
    }
    [[nodiscard]] const heat::FunctionalLayout& layout() const { return functionals.geometry().layout; }
    bricks::Space both;
    HeatProblem given;
    HeatFunctionals functionals;
    OwnedVec temperature;
};

}  // namespace

TEST_CASE("means and integrals of a linear field, with elements of either order")
{
    for (const int order : {1, 2}) {
        const Functionals at(order);
        const auto& layout = at.layout();
        CHECK(layout.count() == 2 + 2 + 2 + 3 + 2 + 2);
        CHECK(at.functionals.part_volume()[0] == near(2, 1e-13));
        CHECK(at.functionals.part_volume()[1] == near(1, 1e-13));
        // A linear field's mean is its value in the middle.
        CHECK(at.value(layout.part(0)) == near(field({1, 0.5, 0.5}), 1e-13));
        CHECK(at.value(layout.part(1)) == near(field({1, 0.5, 1.25}), 1e-13));
        for (const bool side_b : {false, true})
            CHECK(at.value(layout.mean(0, side_b)) == near(field({1, 0.5, 1}), 1e-13));
        CHECK(at.value(layout.surface(0)) == near(2 * field({1, 0.5, 1.5}), 1e-13));
        CHECK(at.value(layout.surface(1)) == near(0.5 * 2 * field({1, 0, 0.5}), 1e-13));
        CHECK(at.value(layout.probe(0)) == near(field({0.3, 0.4, 1.2}), 1e-13));
        CHECK(at.value(layout.probe(1)) == near(field({1.9, 0.9, 0.1}), 1e-13));
        const auto& geometry = at.functionals.geometry();
        CHECK(geometry.surface_area[0] == near(2, 1e-13));
        CHECK(geometry.surface_area[1] == near(1, 1e-13));
        CHECK(geometry.surface_area[2] == 0);  // prescribed: it has no film to give heat
        CHECK(geometry.interface_area[0] == near(2, 1e-13));
        CHECK(geometry.interface_names[0] == "guide.face");
    }
}

TEST_CASE("a watt of each load is a watt")
{
    const Functionals at(2);
    const auto& layout = at.layout();
    for (const auto k : {layout.mean(0, false), layout.mean(0, true), layout.part(0), layout.part(1), layout.body(0),
                         layout.body(1), layout.probe(0)})
        CHECK(at.watts(k) == near(1, 1e-13));
    CHECK(at.watts(layout.surface(2)) == 0);
}

TEST_CASE("heat in parts is even over their volume, heat over a surface even over its area")
{
    const Functionals at(1);
    const double middle = (2 * field({1, 0.5, 0.5}) + field({1, 0.5, 1.25})) / 3;
    CHECK(at.value(at.layout().body(0)) == near(middle, 1e-13));
    CHECK(at.value(at.layout().body(1)) == near(field({1, 0.5, 1.5}), 1e-13));
}

TEST_CASE("loads are the transposed of values")
{
    const Functionals at(1);
    std::vector<double> watts(at.layout().count());
    for (std::size_t k = 0; k < watts.size(); ++k)
        watts[k] = 3.0 + static_cast<double>(k * k);
    auto load =
        bricks::vector_of(at.both.space, std::vector<double>(static_cast<std::size_t>(at.both.space.total), 0.0));
    at.functionals.add_loads(watts, load);
    double expected = 0;
    for (std::size_t k = 0; k < watts.size(); ++k)
        expected += watts[k] * at.value(k);
    CHECK(bricks::dense(load).dot(bricks::dense(at.temperature)) == near(expected, 1e-13));
}

TEST_CASE("probes of another problem replace those there were")
{
    Functionals at(1);
    auto other = at.given;
    other.probes = {{"middle", 0, {1, 0.5, 0.5}}};
    at.functionals.adopt(other);
    CHECK(at.layout().probes == 1);
    CHECK(at.layout().count() == 12);
    CHECK(at.value(at.layout().probe(0)) == near(field({1, 0.5, 0.5}), 1e-13));
}

TEST_CASE("a load zone moves heat about without adding any: over a film on both sides alike")
{
    Functionals at(2);
    at.given.interfaces[0].load_zone = [](const Vec3& x) { return x[0]; };  // twice as dense as its mean at x = 2
    at.functionals.set_zones(at.given.interfaces);
    for (const bool side_b : {false, true}) {
        const auto zone = at.layout().zone(0, side_b);
        CHECK(std::abs(at.watts(zone)) < 1e-13);
        // Centre of load of a triangle over 0..2 at 4/3, against 1: 2 K/m x 1/3 m.
        CHECK(at.value(zone) == near(2 / 3.0, 1e-10));
    }
    // Without a zone there is none, also after there was one.
    at.functionals.set_zones(problem().interfaces);
    CHECK(at.functionals[at.layout().zone(0, false)].local.empty());
}

TEST_CASE("in a part's volume the zone is side a's, with the density of every point")
{
    Functionals at(1);
    auto& law = at.given.interfaces[0];
    law.heat_part = 0;
    law.load_zone = [](const Vec3& x) { return x[2] < 0.5 ? 0.0 : 1.0; };  // the upper layer of cells
    at.functionals.set_zones(at.given.interfaces);
    CHECK(std::abs(at.watts(at.layout().zone(0, false))) < 1e-13);
    CHECK(at.value(at.layout().zone(0, false)) == near(8 * 0.25, 1e-10));  // 0.75 against 0.5
    CHECK(at.functionals[at.layout().zone(0, true)].local.empty());
}

TEST_CASE("a load zone that covers nothing is refused by its interface's name")
{
    Functionals at(1);
    at.given.interfaces[0].load_zone = [](const Vec3&) { return 0.0; };
    CHECK_THROWS_WITH_AS(at.functionals.set_zones(at.given.interfaces), doctest::Contains("'guide.face'"), DomainError);
    at.given.interfaces[0].load_zone = [](const Vec3& x) { return 1 / (x[0] - x[0]); };
    CHECK_THROWS_AS(at.functionals.set_zones(at.given.interfaces), DomainError);
}

TEST_CASE("heat without a part or surface to go to is refused by name")
{
    auto input = problem();
    input.body_heat.push_back({"clutch", {}, -1});
    const bricks::Space both(blocks(), {1, 1});
    CHECK_THROWS_WITH_AS(HeatFunctionals(both.space, input), doctest::Contains("heat_sources.clutch"), InputError);
}

TEST_CASE("shape functions that vanish at a point are left out, and its value stays")
{
    const bricks::Space part(bricks::Brick{}, 1);
    PointShape shape;
    part.space.evaluate(bricks::side(part.machine, 0, 2, true)[0], {0.25, 0.5, 1}, false, shape);
    const auto few = without_zeros(shape);
    CHECK(shape.count == 8);
    CHECK(few.count == 4);
    const auto values = bricks::values_of(part.space, field);
    CHECK(value_at(few, values.data()) == near(field({0.25, 0.5, 1}), 1e-14));
    CHECK(value_at(shape, values.data()) == near(value_at(few, values.data()), 1e-14));
}
