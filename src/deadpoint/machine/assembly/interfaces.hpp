#pragma once

#include <vector>

namespace deadpoint {
struct Contact;
struct InterfaceDescription;
}  // namespace deadpoint

namespace deadpoint {
class Mistakes;
}

namespace deadpoint::machine {

struct Assembly;

/// All interfaces of a description, in its order.
/// @param covered  per face of the machine: its share in contact is added
/// @param mistakes  gets every interface whose selectors match nothing, that joins other than two parts, of which less
///                  than `least_coverage` is covered as drawn, or whose surface does not lie along its travel; the
///                  result is without them
std::vector<Contact> find_interfaces(const Assembly& assembly, const std::vector<InterfaceDescription>& descriptions,
                                     std::vector<double>& covered, Mistakes& mistakes);

}  // namespace deadpoint::machine
