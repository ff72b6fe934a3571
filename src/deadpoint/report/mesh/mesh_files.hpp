#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace deadpoint {
struct Machine;
}

namespace deadpoint::report {

/// Distinct names of the bodies, in the order in which the machine's parts first name them; a body's place in it is
/// its number in all files.
std::vector<std::string> body_names(const Machine& machine);

/// Number of the body of each part.
std::vector<std::int32_t> body_of_part(const Machine& machine);

/// Writes the files of the mesh into an existing folder:
///  - mesh.vtu: all cells, with the numbers of their part and body;
///  - surfaces.vtu: all exterior faces, with part, body, surface, interface, exposed share (0..1) and whether they lie
///    on the symmetry plane; -1 means none; a face in several surfaces carries the smallest of them;
///  - names.csv: what the numbers mean.
///
/// @param comments  version and the like, put into each file
/// @throws IoError if a file cannot be written
void write_mesh_files(const std::filesystem::path& folder, const Machine& machine,
                      const std::vector<std::string>& comments);

}  // namespace deadpoint::report
