#include "deadpoint/tribology/conductance/conductance.hpp"

#include "deadpoint/error.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <utility>

namespace deadpoint::tribology {
namespace {

void require(bool holds, const char* what, double value, const char* help)
{
    if (!holds || !std::isfinite(value))
        throw DomainError(fmt::format("contact conductance: {} is {}\n  help: {}", what, value, help));
}

void check_fluid(const GapFluid& fluid)
{
    require(fluid.conductivity >= 0, "the conductivity of the gap's fluid [W/m/K]", fluid.conductivity,
            "oil has about 0.14, air 0.026, a vacuum 0");
    require(fluid.jump >= 0, "the temperature jump of the gas [m]", fluid.jump, "give 0 for a liquid");
}

void flag(ContactConductance& result, std::string note)
{
    result.in_range = false;
    result.notes.push_back(std::move(note));
}

}  // namespace

double gas_jump(double mean_free_path, double accommodation1, double accommodation2, double heat_ratio, double prandtl)
{
    require(mean_free_path > 0, "the mean free path [m]", mean_free_path, "air at 20 C and 1 atm has 6.8e-8");
    for (const double a : {accommodation1, accommodation2})
        require(a > 0 && a <= 1, "a thermal accommodation coefficient", a, "it lies between 0 and 1");
    require(heat_ratio > 1, "the ratio of heat capacities", heat_ratio, "air has 1.4");
    require(prandtl > 0, "the Prandtl number", prandtl, "air has 0.7");
    const double alpha = (2 - accommodation1) / accommodation1 + (2 - accommodation2) / accommodation2;
    return alpha * 2 * heat_ratio / (prandtl * (1 + heat_ratio)) * mean_free_path;
}

double harmonic_conductivity(double k1, double k2)
{
    for (const double k : {k1, k2})
        require(k > 0, "a conductivity [W/m/K]", k, "give both solids a positive conductivity");
    return 2 * k1 * k2 / (k1 + k2);
}

double contact_modulus(double modulus1, double poisson1, double modulus2, double poisson2)
{
    for (const double e : {modulus1, modulus2})
        require(e > 0, "a modulus [Pa]", e, "give both solids a positive modulus");
    for (const double nu : {poisson1, poisson2})
        require(nu > -1 && nu <= 0.5, "a Poisson ratio", nu, "it lies between -1 and 0.5");
    return 1 / ((1 - poisson1 * poisson1) / modulus1 + (1 - poisson2 * poisson2) / modulus2);
}

ContactConductance direct_conductance(double conductance)
{
    require(conductance > 0, "the given value [W/m2/K]", conductance, "give a positive number");
    return {conductance, true, {}};
}

ContactConductance film_conductance(const GapFluid& fluid, double thickness)
{
    check_fluid(fluid);
    require(fluid.conductivity > 0, "the conductivity of the film [W/m/K]", fluid.conductivity, "oil has about 0.14");
    require(thickness > 0, "the film thickness [m]", thickness, "give a positive thickness");
    ContactConductance result{fluid.conductivity / (thickness + fluid.jump), true, {}};
    if (thickness < 1e-7 || thickness > 1e-3)
        flag(result,
             fmt::format("film thickness {:.3g} m is outside 1e-7..1e-3 m, where a still film is tested", thickness));
    return result;
}

ContactConductance journal_film_conductance(double oil_conductivity, double clearance, double eccentricity)
{
    require(eccentricity >= 0 && eccentricity < 1, "the relative eccentricity", eccentricity,
            "give a number from 0 to below 1");
    ContactConductance result = film_conductance({oil_conductivity, 0}, clearance);
    result.conductance /= std::sqrt((1 - eccentricity) * (1 + eccentricity));
    if (eccentricity > 0.98)
        flag(result, fmt::format("relative eccentricity {:.4g} above 0.98: the surfaces touch", eccentricity));
    return result;
}

double slope_of_roughness(double roughness)
{
    require(roughness > 0, "the roughness [m]", roughness, "give a positive root mean square height");
    return 0.076 * std::pow(roughness * 1e6, 0.52);
}

ContactConductance rough_conductance(const RoughContact& contact, const GapFluid& fluid, double pressure)
{
    check_fluid(fluid);
    require(contact.roughness > 0, "the roughness [m]", contact.roughness, "give a positive root mean square height");
    require(contact.slope > 0, "the slope of the roughness", contact.slope, "see slope_of_roughness()");
    require(contact.hardness > 0, "the hardness [Pa]", contact.hardness, "steel has about 2e9 Pa");
    require(pressure >= 0, "the pressure [Pa]", pressure, "give zero or more");
    require(pressure < contact.hardness, "the pressure [Pa]", pressure,
            "it must stay below the hardness of the softer solid");
    const double relative = pressure / contact.hardness;
    const double solid = harmonic_conductivity(contact.conductivity1, contact.conductivity2);
    const double gap = 1.53 * contact.roughness * std::pow(std::max(relative, 1e-5), -0.097);
    const double through_spots = 1.25 * solid * contact.slope / contact.roughness * std::pow(relative, 0.95);
    ContactConductance result{through_spots + fluid.conductivity / (gap + fluid.jump), true, {}};
    require(result.conductance > 0, "the result [W/m2/K]", result.conductance,
            "faces without pressure conduct only through a fluid");
    if (relative < 1e-5 || relative > 2e-2)
        flag(result, fmt::format("pressure over hardness {:.3g} is outside 1e-5..2e-2, where the law of Cooper, Mikic "
                                 "and Yovanovich is tested",
                                 relative));
    return result;
}

}  // namespace deadpoint::tribology
