#pragma once

#include "deadpoint/machine/part_mesh.hpp"

#include <functional>
#include <string>

namespace deadpoint::machine {

/// Runs `make`, which reads a STEP or mesh file with the libraries of others, in a child process with at most half of
/// the machine's memory and half an hour, and takes the mesh over. Needs a GmshSession.
/// @throws what `make` throws of our errors; InputError naming part and file if the child crashes, hangs or needs too
/// much
PartMesh mesh_foreign_file(const std::string& part, const std::string& path, const std::function<PartMesh()>& make);

}  // namespace deadpoint::machine
