#include "deadpoint/heat/largest_term.hpp"

#include "deadpoint/heat/balance.hpp"
#include "deadpoint/heat/joints.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace deadpoint::heat {

std::string short_text(double value) { return fmt::format("{:.6g}", value); }

std::string largest_term(const HeatProblem& problem, const HeatSegment& segment, const HeatGeometry& geometry,
                         const JointBalance& joints, const HeatBalance& balance, double time, std::vector<Term> terms)
{
    const auto add = [&](const char* table, const std::string& name, const char* meaning, double value,
                         const char* unit, double factor = 1) {
        terms.push_back({fmt::format("the {} of {}.{}: {:.3g} {}", meaning, table, name, value, unit), value * factor});
    };
    for (std::size_t i = 0; i < joints.laws().size(); ++i)
        add("joints", geometry.interface_names[i], "conductance", joints.film_sum(i) * joints.area(i), "W/K");
    for (std::size_t r = 0; r < problem.sources.size() && r < balance.source_heat.size(); ++r)
        if (segment.heat[r])
            add("friction", problem.sources[r].name, "heat", segment.heat[r](balance.source_temperature[r]).value, "W");
    for (std::size_t k = 0; k < problem.body_heat.size(); ++k)
        if (segment.body_heat[k])
            add("heat_sources", problem.body_heat[k].name, "power", segment.body_heat[k](time), "W");
    for (std::size_t i = 0; i < problem.surfaces.size(); ++i) {
        const auto& condition = problem.surfaces[i];
        if (condition.kind == SurfaceCondition::Kind::flux)
            add("surfaces", condition.name, "heat flux", condition.flux(time), "W/m2", geometry.surface_area[i]);
        else if (condition.kind == SurfaceCondition::Kind::film)
            add("surfaces", condition.name, "film", condition.coefficient, "W/m2/K", geometry.surface_area[i]);
    }
    const auto size = [](const Term& term) { return std::isfinite(term.size) ? std::abs(term.size) : 1e308; };
    return terms.empty() ? "none" : std::ranges::max_element(terms, {}, size)->text;
}

}  // namespace deadpoint::heat
