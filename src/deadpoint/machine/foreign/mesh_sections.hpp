#pragma once

#include <istream>
#include <string>

namespace deadpoint::machine {

/// Holds the sections of a Gmsh mesh file in text against the counts that they begin with, from which Gmsh would read
/// on into the next section, or leave out what is there beyond them, without a word.
/// @param version  of the format: 2.x or 4.x
/// @return what is wrong and in which line; empty if all is well
std::string wrong_count(std::istream& mesh, double version);

}  // namespace deadpoint::machine
