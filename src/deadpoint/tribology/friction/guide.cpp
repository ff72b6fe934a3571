#include "deadpoint/tribology/friction/guide.hpp"

#include "deadpoint/tribology/arguments.hpp"
#include "deadpoint/tribology/friction/duty.hpp"
#include "deadpoint/tribology/friction/heat_law.hpp"
#include "deadpoint/tribology/friction/lubricant.hpp"

namespace deadpoint::tribology {

double guide_load_heat(const Guide& guide, const Duty& duty)
{
    require_not_negative("friction coefficient of a guide", guide.friction);
    return guide.friction * duty_mean(duty, 1, 1);
}

double guide_film_heat(const Guide& guide, const Duty& duty, double viscosity)
{
    require_positive("film area of a guide [m2]", guide.area);
    require_positive("film thickness of a guide [m]", guide.thickness);
    require_positive_state("dynamic viscosity of the oil [Pa s]", viscosity);
    return viscosity * guide.area * duty_mean(duty, 0, 2) / guide.thickness;
}

HeatLaw guide_heat(const Guide& guide, const Duty& duty, const Lubricant& lubricant)
{
    return film_heat(guide_load_heat(guide, duty), guide_film_heat(guide, duty, 1), lubricant);
}

HeatLaw guide_heat(const Guide& guide, const Duty& duty) { return constant_heat(guide_load_heat(guide, duty)); }

}  // namespace deadpoint::tribology
