#pragma once

#include "deadpoint/diagnostic.hpp"

#include <string>
#include <vector>

namespace deadpoint::casefile {
struct Case;
}

/// Which things of a machine a mistake or warning is about.
namespace deadpoint::report {

/// Something that a picture of the machine shows.
struct NamedThing {
    enum class Kind { part, body, joint, interface, surface, probe };
    Kind kind = Kind::part;
    std::string name;  ///< of an interface: "joint.interface"

    bool operator==(const NamedThing&) const = default;
};

/// The things that the path of a diagnostic leads to; where it leads to none, those that its message names: in quotes
/// ('frame') or by their keys (parts.frame). In the order in which they are named, each once.
std::vector<NamedThing> things_of(const Diagnostic& found, const casefile::Case& input);

/// A warning as the library shows it, taken apart again: place, code, path, message and help as far as it has them.
Diagnostic taken_apart(const std::string& warning);

}  // namespace deadpoint::report
