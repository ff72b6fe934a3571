#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace deadpoint {
struct Machine;
}
namespace deadpoint::casefile {
struct Case;
}

namespace deadpoint::report {

/// Writes the thermal deformation of the machine for CalculiX, beside the mesh of write_calculix_mesh(), which it
/// includes: `ccx deformation` in their folder computes it.
///
///  - materials of the case by part: elasticity, expansion (of a table its first value), density, conductivity and
///    specific heat, in SI units;
///  - bonds as ties, the side with the smaller faces tied to the other one;
///  - supports without force: the feet (`chain.ground_surface`) along the axis that they face and two nodes in their
///    plane; of every other body three nodes, which hold its rigid motions only; the plane of symmetry;
///  - a temperature at each node.
///
/// Bodies are not connected: joints carry no thermal deformation, and a foundation, preload and weights are not in it.
/// Nodes have the numbers of the array "node" of mesh.vtu and of the fields.
///
/// @param temperatures  of all nodes [degC]
/// @param mesh          name of the included file
/// @throws IoError if the file cannot be written
void write_calculix_deck(const std::filesystem::path& path, const Machine& machine, const casefile::Case& input,
                         std::span<const double> temperatures, const std::string& mesh,
                         const std::vector<std::string>& comments);

/// Names of sets in a deck: other characters than letters and digits replaced by '_'.
std::string calculix_name(const std::string& prefix, std::string name);

}  // namespace deadpoint::report
