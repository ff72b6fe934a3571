#pragma once

#include "deadpoint/machine/cad/cad_model.hpp"
#include "deadpoint/machine/geometry/foreign_mesh.hpp"

#include <optional>

namespace deadpoint::machine {

/// The solids of a STEP file, without a mesh. The file is read in a process that can do nothing else
/// (foreign_mesh.hpp).
/// @param part  begins error messages
/// @param unit  length of one unit of the file [m], where the user states one
/// @throws IoError if the file cannot be read, InputError if it is no STEP file or holds no solid
CadModel read_cad(const std::string& part, const std::string& path, std::optional<double> unit, const Waiting& waiting);

}  // namespace deadpoint::machine
