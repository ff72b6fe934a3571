#pragma once

#include <istream>
#include <string>

namespace deadpoint::machine {

/// Compares the sections of a text Gmsh mesh file with the counts at their beginnings. With a wrong
/// count Gmsh would silently read into the next section, or skip data.
/// @param version  of the format: 2.x or 4.x
/// @return the error and its line; empty if there is none
std::string wrong_count(std::istream& mesh, double version);

}  // namespace deadpoint::machine
