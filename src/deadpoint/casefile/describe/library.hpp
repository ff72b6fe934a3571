#pragma once

#include "deadpoint/casefile/describe/case.hpp"

#include <map>
#include <string>

namespace deadpoint::casefile {

class Visitor;

/// The shipped materials and lubricants, by the name that the key `library` of a case states.
struct Library {
    std::map<std::string, Material> materials;
    std::map<std::string, Lubricant> lubricants;
};
void describe(Visitor& v, Library& library);

/// The library of data/materials.toml and data/lubricants.toml.
const Library& shipped_library();

}  // namespace deadpoint::casefile
