#include "deadpoint/casefile/files/read.hpp"
#include "deadpoint/exchange/laws/material.hpp"
#include "deadpoint/exchange/machine.hpp"
#include "deadpoint/fem/algebra/session.hpp"
#include "deadpoint/fem/conduction/heat_system.hpp"
#include "deadpoint/fem/space/discretisation.hpp"
#include "deadpoint/full/model/prepare.hpp"
#include "deadpoint/heat/sources.hpp"
#include "deadpoint/observer.hpp"
#include "deadpoint/press/problem/heat.hpp"
#include "deadpoint/press/translate/materials.hpp"

#include <chrono>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

// A press in ten segments, each at another speed: contact, oil and convection coefficients grow with its square root.
// Prints how long each segment takes to become the matrices, and how often cells have been integrated.

namespace {

using namespace deadpoint;

double seconds_of(const auto& work)
{
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

HeatSegment at_speed(const HeatProblem& problem, double ratio)
{
    auto segment = problem.segments.front();
    segment.interfaces = problem.interfaces;
    for (auto& law : segment.interfaces) {
        law.film_a *= std::sqrt(ratio);
        law.film_b *= std::sqrt(ratio);
        law.oil *= std::sqrt(ratio);
    }
    return segment;
}

/// What one integration of cells and bonds takes: a system made for one speed meets its first other speed.
void print_integration(const fem::Discretisation& space, const std::vector<Material>& materials,
                       const HeatProblem& ten_speeds)
{
    auto problem = ten_speeds;
    problem.segments = {ten_speeds.segments.front()};
    fem::HeatSystem system(space, materials, problem);
    heat::HeatSources<fem::HeatSystem> sources(system, problem);
    sources.enter(problem.segments.front());
    const double seconds = seconds_of([&] { sources.enter(ten_speeds.segments.back()); });
    std::printf("with an integration of all cells: %6.3f s\n", seconds);
}

}  // namespace

int main(int argc, char** argv)
{
    fem::Session session(argc, argv);
    const std::string path = argc > 1 ? argv[1] : "cases/jl75g-60/case.toml";
    const auto input = casefile::read_case(path, {}, casefile::FileAccess::anywhere).value;
    Observer quiet;
    const auto machine = full::prepare_machine(input, 1, quiet);
    auto problem = press::describe_heat(input, machine, quiet);
    const auto first = problem.segments.front();
    problem.segments.clear();
    for (int k = 0; k < 10; ++k) {
        problem.segments.push_back(first);
        problem.segments.back() = at_speed(problem, 1 + 0.5 * k);
    }
    const fem::Discretisation space(machine, press::describe_orders(input, machine));
    const auto materials = press::describe_materials(input, machine);
    std::printf("%zu cells, %lld unknowns\n", machine.cells.size(), static_cast<long long>(space.total));
    print_integration(space, materials, problem);
    fem::HeatSystem system(space, materials, problem);
    heat::HeatSources<fem::HeatSystem> sources(system, problem);
    for (std::size_t k = 0; k < problem.segments.size(); ++k) {
        const double seconds = seconds_of([&] { sources.enter(problem.segments[k]); });
        std::printf("segment %2zu: %6.3f s, cells integrated %d times so far\n", k + 1, seconds, system.integrations());
    }
    return 0;
}
