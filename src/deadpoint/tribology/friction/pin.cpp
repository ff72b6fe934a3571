#include "deadpoint/tribology/friction/pin.hpp"

#include "deadpoint/tribology/arguments.hpp"
#include "deadpoint/tribology/friction/duty.hpp"
#include "deadpoint/tribology/friction/heat_law.hpp"
#include "deadpoint/tribology/friction/lubricant.hpp"

#include <cmath>
#include <numbers>

namespace deadpoint::tribology {

double pin_load_heat(const Pin& pin, const Duty& duty)
{
    require_positive("radius of a pin [m]", pin.radius);
    require_not_negative("friction coefficient of a pin", pin.friction);
    return pin.radius * pin.friction * duty_mean(duty, 1, 1);
}

double pin_film_heat(const Pin& pin, const Duty& duty, double viscosity)
{
    require_positive("radius of a pin [m]", pin.radius);
    require_positive("length of a pin [m]", pin.length);
    require_positive("radial clearance of a pin [m]", pin.clearance);
    require_positive_state("dynamic viscosity of the oil [Pa s]", viscosity);
    return 2 * std::numbers::pi * viscosity * std::pow(pin.radius, 3) * pin.length * duty_mean(duty, 0, 2) /
           pin.clearance;
}

HeatLaw pin_heat(const Pin& pin, const Duty& duty, const Lubricant& lubricant)
{
    return film_heat(pin_load_heat(pin, duty), pin_film_heat(pin, duty, 1), lubricant);
}

HeatLaw pin_heat(const Pin& pin, const Duty& duty) { return constant_heat(pin_load_heat(pin, duty)); }

}  // namespace deadpoint::tribology
