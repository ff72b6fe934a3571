#include "deadpoint/study/pipeline/run_warnings.hpp"

#include "deadpoint/exchange/heat.hpp"
#include "deadpoint/observer.hpp"

#include <fmt/format.h>

namespace deadpoint::study {

void warn_about(const ThermalHistory& history, const HeatProblem& problem, Observer& observer)
{
    if (history.law_out_of_range)
        observer.warn("a friction law was used at temperatures outside the range of its lubricant; see the joint "
                      "temperatures in history.csv and extend the viscosity table");
    for (std::size_t i = 0; i < problem.surfaces.size(); ++i)
        if (history.film_out_of_range[i])
            observer.warn(fmt::format("surfaces.{}: its film law was used outside its tested range; 'deadpoint heat' "
                                      "shows where it is",
                                      problem.surfaces[i].name));
    if (history.energy.mismatch() > 1e-6 && !nothing_happens(history, problem.time_tolerance))
        observer.warn(fmt::format("the energy balance closes to {:.1e} only; lower numerics.solver_tolerance",
                                  history.energy.mismatch()));
}

}  // namespace deadpoint::study
