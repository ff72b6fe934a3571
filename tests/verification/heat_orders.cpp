#include "../record.hpp"
#include "deadpoint/fem/model.hpp"
#include "deadpoint/press/problem/heat.hpp"
#include "deadpoint/press/translate/materials.hpp"
#include "solved_case.hpp"

#include <cmath>

// Observed orders of convergence.

using namespace verification;

namespace {

// Van der Corput's sequence: points that fill 0..1 evenly without falling into step with any mesh.
double spread(unsigned i, unsigned base)
{
    double value = 0, digit = 1;
    for (; i > 0; i /= base) {
        digit /= base;
        value += digit * (i % base);
    }
    return value;
}

struct CubeError {
    double size;  ///< edge of a cube of a cell's mean volume [m]
    double error;
};

// Root mean square error inside the cube of cube.toml against its source-free field.
CubeError cube_error(int order, bool tetrahedra, int cells)
{
    constexpr unsigned count = 1500;
    auto input = read("cube", {"numerics.order=" + std::to_string(order),
                               std::string("parts.cube.tetrahedra=") + (tetrahedra ? "true" : "false")});
    input.numerics.size = 0.1 / cells;
    std::vector<deadpoint::Vec3> points;
    for (unsigned i = 1; i <= count; ++i)
        points.push_back({0.1 * spread(i, 2), 0.1 * spread(i, 3), 0.1 * spread(i, 5)});
    for (std::size_t i = 0; i < points.size(); ++i)
        input.probes[std::to_string(10000 + i)] = {"cube", points[i], ""};
    const auto solved = solve(input);
    double sum = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const auto& x = points[i];
        const double exact = 20 + 20 * std::exp(std::sqrt(2.0) * 10 * x[0]) * std::sin(10 * x[1]) * std::sin(10 * x[2]);
        sum += std::pow(solved.history().probes[i].value.back() - zero_celsius - exact, 2);
    }
    return {0.1 / std::cbrt(static_cast<double>(solved.result.cells)), std::sqrt(sum / count)};
}

double observed_order(double coarse, double fine, double ratio) { return std::log(coarse / fine) / std::log(ratio); }

// Temperatures at the end of a run of fixed steps.
std::vector<double> with_fixed_step(const Case& input, const deadpoint::Machine& machine, double step)
{
    deadpoint::Observer silent;
    deadpoint::fem::Model model(machine, deadpoint::press::describe_materials(input, machine), input.numerics.order,
                                silent);
    auto problem = deadpoint::press::describe_heat(input, machine, silent);
    problem.fixed_step = step;
    problem.solver_tolerance = 1e-13;
    model.assemble_heat(problem);
    const auto history = model.heat({}, input.machine.initial_temperature, -1, silent, {}, {});
    CHECK(history.energy.mismatch() < 1e-6);
    std::vector<double> values;
    for (const auto* group : {&history.probes, &history.interface_a, &history.interface_b})
        for (const auto& series : *group)
            values.push_back(series.value.back());
    return values;
}

// Order of the time integration by three runs, each with half the step of the one before.
void check_time_order(const Case& input, double step, const std::string& what)
{
    deadpoint::Observer silent;
    const auto machine = deadpoint::full::prepare_machine(input, 1, silent);
    const auto coarse = with_fixed_step(input, machine, step), middle = with_fixed_step(input, machine, step / 2),
               fine = with_fixed_step(input, machine, step / 4);
    double before = 0, after = 0;
    for (std::size_t i = 0; i < fine.size(); ++i) {
        const double first = std::abs(coarse[i] - middle[i]), second = std::abs(middle[i] - fine[i]);
        const double order = observed_order(first, second, 2);
        MESSAGE("order in time " << order << ", last difference " << second << " K");
        CHECK(std::abs(order - 2) < 0.1);
        before = std::max(before, first);
        after = std::max(after, second);
    }
    record_order(
        {"order in time, " + what, "TR-BDF2", "", 2, 0.1, "0.1 asked; largest difference among probes and joints"}, "K",
        {{2, before}, {1, after}});
}

}  // namespace

TEST_CASE("order in time: two slabs after a jump")
{
    auto input = read("two-slabs", {"parts.steel_slab.size=2 mm", "parts.aluminium_slab.size=2 mm"});
    input.operation.resize(1);
    input.operation[0].duration = 80;
    check_time_order(input, 1.0, "two slabs after a jump");
}

TEST_CASE("order in time: a wall temperature that changes all the time")
{
    auto input = read("nafems-t3", {"numerics.size=4 mm"});
    check_time_order(input, 0.5, "a wall temperature that changes all the time");
}

TEST_CASE("order in time: heat that depends on the temperature it makes")
{
    auto input = read("shaft-in-block", {"numerics.size=20 mm", "parts.block.size=20 mm", "parts.shaft.size=14 mm"});
    input.lubricants["oil"].viscosity = {{273.15, 373.15}, {300e-6, 3e-6}};  // smooth: no corner in the table
    input.operation[0].duration = 1600;
    check_time_order(input, 40, "heat that depends on the temperature it makes");
}

TEST_CASE("order in space: a field without sources in a cube")
{
    struct Target {
        int order;
        bool tetrahedra;
        int coarse, fine;
    };
    // Hexahedra halve exactly; unstructured tetrahedra of two sizes are not alike, and their order is coarser.
    for (const auto& target : {Target{1, false, 8, 16}, {2, false, 4, 8}, {1, true, 7, 13}, {2, true, 5, 9}}) {
        const auto coarse = cube_error(target.order, target.tetrahedra, target.coarse);
        const auto fine = cube_error(target.order, target.tetrahedra, target.fine);
        const double order = observed_order(coarse.error, fine.error, coarse.size / fine.size);
        MESSAGE(std::string(target.tetrahedra ? "tetrahedra" : "hexahedra")
                << " of order " << target.order << ": errors " << coarse.error << ", " << fine.error << " K, order "
                << order);
        CHECK(std::abs(order - (target.order + 1)) < (target.tetrahedra ? 0.3 : 0.1));
    }
}
