#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace deadpoint {
struct Machine;
}

namespace deadpoint::report {

/// Writes the mesh in the form of CalculiX and Abaqus, in metres, for a second opinion by another program:
///  - all nodes, and per part the set of elements PART_name (C3D8 or C3D4);
///  - as element faces, per surface SURFACE_name, per interface the sides INTERFACE_name_A and _B that touch, and per
///    bonded pair BOND_name_A and _B; a face that belongs to it in part is listed as a whole;
///  - the faces on the symmetry plane as SYMMETRY.
/// Names have other characters than letters and digits replaced by '_'. Nodes and elements are numbered from 1, in
/// the order of the machine, as in mesh.vtu. Materials, ties and temperatures: write_calculix_deck().
///
/// @param comments  version and the like, put at the top
/// @throws IoError if the file cannot be written
void write_calculix_mesh(const std::filesystem::path& path, const Machine& machine,
                         const std::vector<std::string>& comments);

}  // namespace deadpoint::report
