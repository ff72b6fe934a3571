#pragma once

/// Coefficients of circulating oil; heat/oil marches it from joint to joint.
namespace deadpoint::surroundings {

/// Mass flow from volume flow [m3/s] and density [kg/m3].
/// @throws InputError if one is negative or not finite, or the density is zero
double mass_flow_of(double volume_flow, double density);

/// Factor on the coefficient, relative to the arriving oil, due to the oil's warming within a
/// joint: (1 - exp(-N)) / N with N = h A / (m c), as in a heat exchanger with one side at constant
/// temperature (Kays and London, Compact Heat Exchangers); 1 at N = 0, 0 at infinite N.
double mean_approach(double transfer_units);

}  // namespace deadpoint::surroundings
