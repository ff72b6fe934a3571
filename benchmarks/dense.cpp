#include "../tests/unit/heat/lumps.hpp"
#include "deadpoint/exchange/heat.hpp"
#include "deadpoint/exchange/laws/laws.hpp"
#include "deadpoint/exchange/machine.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <vector>

// A warm-up on the dense system: 40 states, 14 joints whose heat falls with their temperature, one film to the air,
// 72 steps. Prints the median of 200 runs [ms].

namespace {

constexpr int states = 40, joints = 14, steps = 72, runs = 200;

deadpoint::HeatProblem problem()
{
    deadpoint::HeatProblem result;
    for (int i = 0; i < joints; ++i) {
        deadpoint::InterfaceLaw law;
        law.film_a = 500 + 10 * i;
        law.film_b = 400;
        law.oil = 50;
        law.oil_temperature = 300;
        law.source = i;
        result.interfaces.push_back(law);
        result.sources.push_back({"row " + std::to_string(i), 1, {}, {}});
    }
    result.surfaces = {lumps::film(10)};
    result.segments = {lumps::segment(result, 3 * 3600.0, 293)};
    for (auto& heat : result.segments[0].heat)
        heat = [](double t) {
            const double watts = 200 * std::exp(-0.02 * (t - 293));
            return deadpoint::LawValue{watts, -0.02 * watts, true};
        };
    result.fixed_step = 3 * 3600.0 / steps;
    return result;
}

lumps::Machine machine()
{
    lumps::Machine result;
    for (int k = 0; k < states; ++k)
        result.capacity.push_back(1e4 * (1 + k % 7));
    for (int k = 0; k + 1 < states; ++k)
        result.links.emplace_back(k, k + 1, 5 + k % 3);
    for (int i = 0; i < joints; ++i)
        result.interfaces.emplace_back(2 * i, 2 * i + 3, 0.05);
    result.surfaces = {{states - 1, 2.0}};
    result.probes = {0, 10, 20};
    return result;
}

}  // namespace

int main()
{
    const auto heat = problem();
    const auto built = machine();
    std::vector<double> milliseconds;
    std::size_t taken = 0;
    for (int r = 0; r < runs; ++r) {
        lumps::Run run(built, heat, 293);
        const auto begin = std::chrono::steady_clock::now();
        taken = run.go().time.size() - 1;
        milliseconds.push_back(
            std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count());
    }
    std::ranges::sort(milliseconds);
    std::printf("%zu steps, %d joints, %d states: %.2f ms (fastest %.2f ms)\n", taken, joints, states,
                milliseconds[runs / 2], milliseconds.front());
}
