/// Requirement: prescribed temperatures, materials over temperature and the stages' solves are those of dense matrices.
#include "deadpoint/fem/conduction/heat_system.hpp"

#include "bricks.hpp"
#include "deadpoint/exchange/machine.hpp"
#include "deadpoint/fem/conduction/terms/prescribed.hpp"
#include "near.hpp"

#include <doctest/doctest.h>
#include <numeric>

using namespace deadpoint;
using namespace deadpoint::fem;
using bricks::column;
using bricks::dense;
using bricks::vector_of;

namespace {

TimeCourse steady(double value)
{
    return [value](double) { return value; };
}

/// Two blocks with a joint that rubs; a film on top of the upper one; the lower one's bottom is surface 1.
Machine blocks()
{
    auto machine = bricks::machine_of(
        {{{0, 0, 0}, {0.2, 0.1, 0.1}, {2, 1, 2}, false, {}}, {{0, 0, 0.1}, {0.2, 0.1, 0.2}, {3, 1, 1}, false, {}}});
    machine.interfaces = {bricks::contact(machine, 0, 1, 2)};
    bricks::add_surface(machine, 1, 2, true);
    bricks::add_surface(machine, 0, 2, false);
    return machine;
}

HeatProblem problem(bool prescribed)
{
    HeatProblem result;
    InterfaceLaw law;
    law.film_a = 700;
    law.film_b = 300;
    law.oil = 50;
    law.source = 0;
    result.interfaces = {law};
    result.sources = {{"pin", 1, {}, {}}};
    result.surfaces.resize(prescribed ? 2 : 1);
    result.surfaces[0].surface = 0;
    result.surfaces[0].coefficient = 25;
    if (prescribed) {
        result.surfaces[1].surface = 1;
        result.surfaces[1].kind = SurfaceCondition::Kind::temperature;
        result.surfaces[1].temperature = [](const Vec3& x, double time) { return 300 + 10 * x[0] + time; };
    }
    HeatSegment segment;
    segment.duration = 1000;
    segment.heat.resize(1);
    segment.ambient = steady(290);
    result.segments = {segment};
    return result;
}

struct Blocks {
    explicit Blocks(bool prescribed, Material material = bricks::steel())
        : both(blocks(), {1, 1}), given(problem(prescribed)), materials(2, std::move(material)),
          system(both.space, materials, given)
    {
        const auto& layout = system.geometry().layout;
        loads = {{{layout.mean(0, false), 0.7}, {layout.mean(0, true), 0.3}}};
        system.set_laws(given.interfaces, loads);
    }
    [[nodiscard]] Eigen::VectorXd zeros() const { return Eigen::VectorXd::Zero(both.space.total); }
    [[nodiscard]] OwnedVec vector(const Eigen::VectorXd& values) const
    {
        return vector_of(both.space, {values.begin(), values.end()});
    }
    /// A matrix by its products.
    template <class Product>
    Eigen::MatrixXd matrix_of(const Product& product) const
    {
        Eigen::MatrixXd result(both.space.total, both.space.total);
        auto out = system.make_vector();
        for (Eigen::Index k = 0; k < result.cols(); ++k) {
            product(vector(Eigen::VectorXd::Unit(both.space.total, k)), out);
            result.col(k) = dense(out);
        }
        return result;
    }
    bricks::Space both;
    HeatProblem given;
    std::vector<Material> materials;
    HeatSystem system;
    std::vector<heat::Loads> loads;
};

double uneven(const Vec3& x) { return 320 + 200 * x[0] - 300 * x[1] * x[2]; }

}  // namespace

TEST_CASE("prescribed unknowns are those of the surface's nodes, each at its own place and time")
{
    const bricks::Space both(blocks(), {1, 2});
    const auto given = problem(true);
    const PrescribedTemperatures prescribed(both.space, given);
    CHECK(prescribed.some());
    CHECK(prescribed.unknowns().size() == 3 * 2);
    auto temperature = vector_of(both.space, uneven);
    prescribed.impose(7, temperature);
    const auto places = both.space.support_points();
    const auto values = dense(temperature);
    for (std::size_t i = 0; i < places.size(); ++i) {
        const double expected = places[i][2] < 1e-9 ? 307 + 10 * places[i][0] : uneven(places[i]);
        CHECK(values[static_cast<Eigen::Index>(i)] == near(expected, 1e-14));
    }
    // Their sum: three pairs at x = 0, 0.1, 0.2.
    CHECK(prescribed.total(temperature) == near(6 * 307 + 10 * 2 * 0.3, 1e-14));
    prescribed.clear(temperature);
    CHECK(prescribed.total(temperature) == 0);
    CHECK(dense(temperature).sum() < values.sum() - 1800);
}

TEST_CASE("faces whose centre a condition does not hold are not prescribed, and of two conditions the later one holds")
{
    auto machine = blocks();
    machine.surfaces[1].faces[0].central = false;
    const bricks::Space both(machine, {1, 1});
    auto given = problem(true);
    CHECK(PrescribedTemperatures(both.space, given).unknowns().size() == 4);
    auto twice = machine;
    twice.surfaces[1].faces[0].central = true;
    const bricks::Space other(twice, {1, 1});
    given.surfaces.push_back(given.surfaces[1]);
    given.surfaces[2].temperature = [](const Vec3&, double) { return 99.0; };
    const PrescribedTemperatures later(other.space, given);
    auto temperature = vector_of(other.space, uneven);
    later.impose(0, temperature);
    CHECK(later.total(temperature) == near(6 * 99, 1e-14));
}

TEST_CASE("a functional without prescribed unknowns is zero there and itself elsewhere")
{
    const bricks::Space both(blocks(), {1, 1});
    const auto given = problem(true);
    const PrescribedTemperatures prescribed(both.space, given);
    std::vector<std::pair<PetscInt, double>> entries;
    for (PetscInt i = 0; i < both.space.total; ++i)
        entries.emplace_back(i, 1.0 + i);
    const auto all = both.space.functional(entries), rest = prescribed.without(all);
    for (std::size_t i = 0; i < all.weight.size(); ++i) {
        const bool given_there = std::ranges::count(prescribed.unknowns(), all.local[i]) > 0;
        CHECK(rest.weight[i] == (given_there ? 0 : all.weight[i]));
    }
}

TEST_CASE("shares of prescribed temperatures, and of the start, sum over their unknowns")
{
    const bricks::Space both(blocks(), {1, 1});
    const auto given = problem(true);
    const PrescribedTemperatures prescribed(both.space, given);
    const auto one = vector_of(both.space, [](const Vec3&) { return 1.0; });
    const auto left = vector_of(both.space, [](const Vec3&) { return 0.25; });
    const auto shares = prescribed.shares(one, left, 7, 290);
    REQUIRE(shares.size() == 2);
    CHECK(shares[0] == 0);
    CHECK(shares[1] == near(0.75 * (6 * 17 + 6), 1e-13));
    const auto start = vector_of(both.space, [](const Vec3& x) { return x[2] < 1e-9 ? 350.0 : 295.0; });
    const auto of_start = prescribed.start_shares(one, start, 290);
    CHECK(of_start[0] == 0);
    CHECK(of_start[1] == near(6 * 60, 1e-14));
    CHECK(of_start[2] == near((both.space.total - 6) * 5, 1e-14));
    const auto without = problem(false);
    const PrescribedTemperatures none(both.space, without);
    CHECK_FALSE(none.some());
    CHECK(none.start_shares(one, start, 290)[1] == near(6 * 60 + (both.space.total - 6) * 5, 1e-14));
}

TEST_CASE("vector operations of the system are those of dense vectors")
{
    const Blocks at(false);
    const auto& system = at.system;
    const Eigen::VectorXd a = column(at.both.space, uneven),
                          b = column(at.both.space, [](const Vec3&x) { return x[0] - 1; });
    const auto of_a = at.vector(a), of_b = at.vector(b);
    auto sum = system.make_vector();
    CHECK(dense(sum).norm() == 0);
    system.combine({{2, &of_a}, {-3, &of_b}}, sum);
    CHECK((dense(sum) - (2 * a - 3 * b)).norm() < 1e-12);
    system.add(0.5, of_b, sum);
    CHECK((dense(sum) - (2 * a - 2.5 * b)).norm() < 1e-12);
    system.combine({}, sum);
    CHECK(dense(sum).norm() == 0);
    system.copy(of_a, sum);
    CHECK(dense(sum) == a);
    CHECK(system.dot(of_a, of_b) == near(a.dot(b), 1e-14));
    CHECK(system.total(of_a) == near(a.sum(), 1e-14));
    CHECK(system.largest(of_b) == b.lpNorm<Eigen::Infinity>());
    CHECK(system.is_finite(of_a));
    Entries(sum).data()[2] = std::nan("");
    CHECK_FALSE(system.is_finite(sum));
    CHECK(system.any(true));
    CHECK_FALSE(system.any(false));
    std::vector<double> lowest(2, 1e300), highest(2, -1e300);
    system.widen(of_a, lowest, highest);
    CHECK(lowest[0] == near(320 - 300 * 0.01, 1e-14));  // at y = z = 0.1, x = 0
    CHECK(highest[1] == near(360, 1e-14));
    system.widen(of_b, lowest, highest);
    CHECK(highest[1] == near(360, 1e-14));
    CHECK(lowest[1] == -1);
}

TEST_CASE(
    "a stage's matrix is M + factor K, and a solve with slopes of sources that of the dense matrix less their terms")
{
    Blocks at(false);
    const auto nothing = at.system.make_vector();
    const auto mass = at.matrix_of([&](const OwnedVec& in, OwnedVec& out) { at.system.apply_mass(in, out); });
    const auto stiffness = at.matrix_of([&](const OwnedVec& in, OwnedVec& out) { at.system.conduct(in, out); });
    CHECK(at.system.is_linear());
    Eigen::VectorXd load = at.zeros(), other = column(at.both.space, [](const Vec3&x) { return 30 * x[1]; });
    for (const auto& [functional, share] : at.loads[0]) {
        auto vector = at.system.make_vector();
        std::vector<double> watts(at.system.geometry().layout.count(), 0.0);
        watts[functional] = share;
        at.system.add_loads(watts, vector);
        load += dense(vector);
    }
    CHECK(load.sum() == near(1, 1e-13));
    const Eigen::VectorXd right = column(at.both.space, [](const Vec3& x) { return 100 * x[0] - 7 * x[2]; });
    for (const double factor : {0.3, 40.0, 900.0}) {
        CHECK(at.system.build(factor, nothing, {}));
        CHECK_FALSE(at.system.build(factor, nothing, {}));  // it is there
        const Eigen::MatrixXd stage = mass + factor * stiffness;
        const auto product = at.matrix_of([&](const OwnedVec& in, OwnedVec& out) { at.system.apply_stage(in, out); });
        CHECK((product - stage).norm() < 1e-14 * stage.norm());
        const auto of_other = at.vector(other);
        heat::LowRank<OwnedVec> low_rank{{-12}, {{0.4, &of_other}}};
        auto solution = at.system.make_vector();
        at.system.solve(at.vector(right), solution, low_rank, {1e-12, 0}, "a test");
        const Eigen::MatrixXd whole = stage + factor * 12 * load * load.transpose() - 0.4 * other * other.transpose();
        const Eigen::VectorXd expected = whole.partialPivLu().solve(right);
        CHECK((dense(solution) - expected).norm() < 1e-9 * expected.norm());  // residual to 1e-12, condition 1e3
    }
}

TEST_CASE("with prescribed temperatures a solve leaves their unknowns at the right-hand side and solves the rest")
{
    Blocks at(true);
    const auto nothing = at.system.make_vector();
    const auto mass = at.matrix_of([&](const OwnedVec& in, OwnedVec& out) { at.system.apply_mass(in, out); });
    const auto stiffness = at.matrix_of([&](const OwnedVec& in, OwnedVec& out) { at.system.conduct(in, out); });
    CHECK_FALSE(at.system.is_linear());
    CHECK_FALSE(at.system.follows_temperature());
    const double factor = 60;
    at.system.build(factor, nothing, {});
    auto right = vector_of(at.both.space, uneven);
    at.system.clear_prescribed(right);
    auto solution = at.system.make_vector();
    at.system.solve(right, solution, {}, {1e-12, 0}, "a test");
    const auto places = at.both.space.support_points();
    Eigen::MatrixXd stage = mass + factor * stiffness;
    for (std::size_t i = 0; i < places.size(); ++i)
        if (places[i][2] < 1e-9) {
            const auto row = static_cast<Eigen::Index>(i);
            stage.row(row).setZero();
            stage.col(row).setZero();
            stage(row, row) = 1;
        }
    const Eigen::VectorXd expected = stage.partialPivLu().solve(dense(right));
    CHECK((dense(solution) - expected).norm() < 1e-9 * expected.norm());
    CHECK(at.system.total_prescribed(solution) == 0);
}

TEST_CASE("the adjoint's solve is that of M + factor K, from a guess; at the solution it takes no iteration")
{
    Blocks at(false);
    at.system.begin_adjoint();
    const auto right = vector_of(at.both.space, uneven);
    auto solution = at.system.make_vector();
    CHECK(at.system.solve_adjoint(80, right, solution) > 0);
    auto product = at.system.make_vector(), conducted = at.system.make_vector();
    at.system.apply_mass(solution, product);
    at.system.apply_stiffness(solution, conducted);
    at.system.add(80, conducted, product);
    CHECK((dense(product) - dense(right)).norm() < 1e-6 * dense(right).norm());
    CHECK(at.system.solve_adjoint(80, right, solution) <= 1);
}

TEST_CASE("functionals of a deformation: weights times the rise, as a value, as a slope, and by part")
{
    Blocks at(false);
    std::vector<Adjoint> adjoints(2);
    for (std::size_t k = 0; k < 2; ++k)
        adjoints[k].owned = bricks::values_of(at.both.space, [k](const Vec3& x) { return 1 + x[k]; });
    at.system.observe_with({&adjoints, 293, Attribution{1}});
    const auto temperature = vector_of(at.both.space, uneven);
    const auto values = at.system.observe(temperature, temperature, false);
    REQUIRE(values.size() == 2 + 2);
    const Eigen::VectorXd rise = column(at.both.space, uneven).array() - 293;
    CHECK(values[0] == near(bricks::column(adjoints[0].owned).dot(rise), 1e-13));
    CHECK(values[2] + values[3] == near(values[1], 1e-13));
    const auto slopes = at.system.observe(temperature, temperature, true);
    CHECK(slopes[0] == near(bricks::column(adjoints[0].owned).dot(column(at.both.space, uneven)), 1e-13));
    at.system.observe_with({});
    CHECK(at.system.observe(temperature, temperature, false).empty());
}

namespace {

/// Capacity and conductivity that rise with the temperature.
Material varying()
{
    auto material = bricks::steel();
    material.specific_heat_table = LinearCurve({280, 380}, {500, 700});
    material.conductivity_table = LinearCurve({280, 380}, {45, 25});
    return material;
}

}  // namespace

TEST_CASE("heat stored between two even temperatures is the integral of the capacity")
{
    const Blocks at(false, varying());
    const auto from = vector_of(at.both.space, [](const Vec3&) { return 290.0; });
    const auto to = vector_of(at.both.space, [](const Vec3&) { return 350.0; });
    // c = 500 + 2 (T - 280): its mean over 290..350 is 580.
    const double expected = 7800 * 0.2 * 0.1 * 0.2 * 580 * 60;
    CHECK(at.system.stored_between(from, to) == near(expected, 1e-12));
    CHECK(at.system.stored_between(to, from) == near(-expected, 1e-12));
    auto before = at.system.make_vector(), after = at.system.make_vector();
    at.system.store(from, before);
    at.system.store(to, after);
    CHECK(dense(after).sum() - dense(before).sum() == near(expected, 1e-12));
}

TEST_CASE("conduction follows the transform of Kirchhoff: the flux of a field whose transform is linear")
{
    const Blocks at(false, varying());
    // theta with d theta / dT = k / k_0 = 1 - (T - 280) / 225, so T - 280 = 225 (1 - sqrt(1 - 2 (theta - 280) / 225)).
    const auto field = [](const Vec3& x) { return 280 + 225 * (1 - std::sqrt(1 - 2 * (40 * x[0] + 5) / 225)); };
    auto conducted = at.system.make_vector();
    at.system.conduct(vector_of(at.both.space, field), conducted);
    const auto places = at.both.space.support_points();
    const auto values = dense(conducted);
    // Joint and film add to it; between both ends of one part, at the bottom, nothing else does.
    for (std::size_t i = 0; i < places.size(); ++i)
        if (places[i][2] < 1e-9 && std::abs(places[i][0] - 0.1) < 1e-9)
            CHECK(std::abs(values[static_cast<Eigen::Index>(i)]) < 1e-11);
    auto still = problem(false);
    still.surfaces.clear();
    still.interfaces[0].film_b = still.interfaces[0].oil = 0;
    still.interfaces[0].film_a = 1;  // conducts nothing: all of it ends at b
    still.segments[0].interfaces = still.interfaces;
    HeatSystem alone(at.both.space, at.materials, still);
    alone.set_laws(still.interfaces, {});
    alone.conduct(vector_of(at.both.space, field), conducted);
    const auto pure = dense(conducted);
    double in = 0, out = 0;
    for (std::size_t i = 0; i < places.size(); ++i)
        (places[i][0] < 0.05 ? in : places[i][0] > 0.15 ? out : in) += pure[static_cast<Eigen::Index>(i)];
    CHECK(out == near(45 * 40 * 0.1 * 0.2, 1e-10));  // k_0 times the slope of theta times 0.02 m2
    CHECK(in == near(-out, 1e-10));
}

TEST_CASE("the tangent of a stage is the derivative of M h(T) + factor (K T + K_v theta(T))")
{
    Blocks at(false, varying());
    CHECK(at.system.follows_temperature());
    const Eigen::VectorXd temperature = column(at.both.space, uneven);
    const Eigen::VectorXd direction =
        column(at.both.space, [](const Vec3& x) { return 1 - 3 * x[0] + 20 * x[1] * x[2]; });
    const double factor = 70;
    at.system.build(factor, at.vector(temperature), {});
    auto product = at.system.make_vector();
    at.system.apply_stage(at.vector(direction), product);
    const auto value = [&](const Eigen::VectorXd& t) {
        auto stored = at.system.make_vector(), conducted = at.system.make_vector();
        at.system.store(at.vector(t), stored);
        at.system.conduct(at.vector(t), conducted);
        return Eigen::VectorXd(dense(stored) + factor * dense(conducted));
    };
    constexpr double h = 1e-2;
    const Eigen::VectorXd by_difference =
        (value(temperature + h * direction) - value(temperature - h * direction)) / (2 * h);
    CHECK((dense(product) - by_difference).norm() < 1e-8 * by_difference.norm());  // straight tables: rounding alone
}
