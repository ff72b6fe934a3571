#pragma once

#include <string>

/// Internal to fem/: a temperature field as a file, from which another run can start.
///
/// The file (io/binary_file) holds a text that states mesh and elements, then the temperatures of
/// oil circuits, enclosures and unknowns; unknowns are numbered by their first appearance cell by
/// cell, which does not depend on the number of ranks.
namespace deadpoint::fem {

class Discretisation;
struct ThermalState;

/// Collective; written by the first rank.
/// @throws IoError on all ranks if the file cannot be written
void write_thermal_state(const std::string& file, const Discretisation& space, const ThermalState& state);

/// @param like  a state of the problem, for its numbers of oil circuits and enclosures
/// @throws IoError if the file cannot be read, was cut short or changed; InputError if it belongs to another mesh,
///         element order or numbers of oil circuits and enclosures; DomainError if a temperature in it is not above 0 K
ThermalState read_thermal_state(const std::string& file, const Discretisation& space, const ThermalState& like);

}  // namespace deadpoint::fem
