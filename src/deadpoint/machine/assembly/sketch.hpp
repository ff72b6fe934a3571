#pragma once

#include "deadpoint/diagnostic.hpp"
#include "deadpoint/exchange/machine.hpp"

#include <vector>

namespace deadpoint {
class MeshedParts;
class Observer;
}  // namespace deadpoint

/// What can be drawn of a machine that may still be wrong.
namespace deadpoint::machine {

struct Sketch {
    Machine machine;                         ///< without the parts, interfaces and surfaces at fault
    std::vector<InterfaceFaces> interfaces;  ///< in the order of the description, all of them
    std::vector<Diagnostic> missing;         ///< why things are not there
};

/// The faces of a contact that touch, as drawn, ascending.
InterfaceFaces faces_of(const Contact& contact);

/// As build_machine(), but goes on past mistakes: every part that can be meshed is, and of those all interfaces, bonds
/// and surfaces that can be found. Nothing is thrown for mistakes of the description; they are in Sketch::missing.
Sketch sketch_machine(const MachineDescription& description, Observer& observer, MeshedParts* kept = nullptr);

}  // namespace deadpoint::machine
