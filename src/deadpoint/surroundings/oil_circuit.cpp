#include "deadpoint/surroundings/oil_circuit.hpp"

#include "deadpoint/error.hpp"

#include <cmath>
#include <fmt/format.h>

namespace deadpoint::surroundings {
namespace {

void require(bool holds, const char* what, double value, const char* help)
{
    if (!holds || !std::isfinite(value))
        throw InputError(fmt::format("oil circuit: {} is {}\n  help: {}", what, value, help));
}

}  // namespace

double mean_approach(double transfer_units)
{
    if (transfer_units == 0)
        return 1;
    return -std::expm1(-transfer_units) / transfer_units;
}

double mass_flow_of(double volume_flow, double density)
{
    require(volume_flow >= 0, "the volume flow [m3/s]", volume_flow, "give a flow of zero or more");
    require(density > 0, "the density [kg/m3]", density, "mineral oil has about 870 kg/m3");
    return volume_flow * density;
}

}  // namespace deadpoint::surroundings
