#include "deadpoint/fem/conduction/heat_solver.hpp"

#include <algorithm>

// What a watt anywhere does to functionals of the temperature.

namespace deadpoint::fem {

std::vector<Field> HeatSolver::duals(double time, const Field& temperature, const std::vector<Adjoint>& weights)
{
    auto now = state();
    now.temperature = temperature;
    start_from(now);
    double end = 0;
    const auto running = std::ranges::find_if(problem_->segments, [&](const HeatSegment& segment) {
        end += segment.duration;
        return time <= end * (1 + 1e-9);
    });
    begin_segment(running == problem_->segments.end() ? problem_->segments.back() : *running, time);
    time_ = time;
    build_system(time, now_);
    shell_slopes_ = rate_now_.source_slope;
    set_tolerance(1e-8, 0);
    std::vector<Field> result;
    for (const auto& weight : weights) {
        double* load = nullptr;
        DEADPOINT_PETSC(VecGetArray(work_, &load));
        for (std::size_t i = 0; i < weight.owned.size(); ++i)
            load[i] = time * weight.owned[i];
        DEADPOINT_PETSC(VecRestoreArray(work_, &load));
        clear_prescribed(work_);
        solve_system(work_, work2_, "the dual of the temperature field");
        const double* values = nullptr;
        DEADPOINT_PETSC(VecGetArrayRead(work2_, &values));
        result.push_back({{values, values + weight.owned.size()}});
        DEADPOINT_PETSC(VecRestoreArrayRead(work2_, &values));
    }
    return result;
}

}  // namespace deadpoint::fem
