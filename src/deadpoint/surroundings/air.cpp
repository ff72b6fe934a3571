#include "deadpoint/surroundings/air.hpp"

#include "deadpoint/error.hpp"
#include "deadpoint/surroundings/forms.hpp"

#include <cmath>
#include <fmt/format.h>

namespace deadpoint::surroundings {

AirProperties air_properties(double temperature)
{
    if (!(temperature >= 150 && temperature <= 1000))
        throw DomainError(fmt::format("air at {} K is outside 150..1000 K, where its properties are known\n"
                                      "  help: check the ambient temperature and the heat of the joints",
                                      temperature));
    const auto air = detail::air_form(temperature);
    return {.temperature = temperature,
            .conductivity = air.conductivity,
            .viscosity = air.viscosity,
            .density = air.density,
            .heat_capacity = detail::air_heat_capacity,
            .kinematic_viscosity = air.kinematic_viscosity,
            .diffusivity = air.diffusivity,
            .prandtl = air.prandtl,
            .expansion = air.expansion,
            .in_range = temperature >= 250 && temperature <= 400};
}

double grashof(double difference, double length, const AirProperties& film)
{
    if (!(length > 0) || !std::isfinite(length) || !std::isfinite(difference))
        throw DomainError(fmt::format("Grashof number of a surface of length {} m at {} K above ambient\n"
                                      "  help: give a positive length and finite temperatures",
                                      length, difference));
    const double nu = film.kinematic_viscosity;
    return gravity * film.expansion * std::abs(difference) * length * length * length / (nu * nu);
}

double rayleigh(double difference, double length, const AirProperties& film)
{
    return grashof(difference, length, film) * film.prandtl;
}

}  // namespace deadpoint::surroundings
