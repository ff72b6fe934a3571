#include "deadpoint/tribology/friction/heat_law.hpp"

#include "deadpoint/error.hpp"
#include "deadpoint/tribology/arguments.hpp"
#include "deadpoint/tribology/friction/lubricant.hpp"

#include <utility>

namespace deadpoint::tribology {

HeatLaw constant_heat(double power)
{
    require_not_negative("constant friction heat [W]", power);
    return [power](double) { return LawValue{power, 0, true}; };
}

HeatLaw film_heat(double load, double per_viscosity, const Lubricant& lubricant)
{
    return [load, per_viscosity, viscosity = dynamic_viscosity(lubricant)](double temperature) {
        const LawValue eta = viscosity(temperature);
        return LawValue{load + per_viscosity * eta.value, per_viscosity * eta.slope, eta.in_range};
    };
}

HeatLaw summed_heat(std::vector<HeatLaw> laws)
{
    for (const HeatLaw& law : laws)
        if (!law)
            throw InputError("sum of friction heat: one of the laws is empty\n  help: leave it out of the list");
    return [laws = std::move(laws)](double temperature) {
        LawValue sum;
        for (const HeatLaw& law : laws) {
            const LawValue part = law(temperature);
            sum.value += part.value;
            sum.slope += part.slope;
            sum.in_range = sum.in_range && part.in_range;
        }
        return sum;
    };
}

}  // namespace deadpoint::tribology
