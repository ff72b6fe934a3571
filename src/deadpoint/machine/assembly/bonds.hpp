#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace deadpoint {
struct Contact;
struct MachineDescription;
class Mistakes;
}  // namespace deadpoint

namespace deadpoint::machine {

struct Assembly;

/// All bonds between touching parts of one body, perfect unless a bond of the description states how heat passes.
/// @param joined    pairs of parts (lower index first) that an interface joins, not to be bonded
/// @param covered   per face of the machine: the share of it in contact is added
/// @param mistakes  pairs of stated bonds that find no bond, or one that another has
/// @throws InputError for pairs that are not of the form "a|b"
std::vector<Contact> find_bonds(const Assembly& assembly, const MachineDescription& description,
                                const std::vector<std::array<std::uint32_t, 2>>& joined, std::vector<double>& covered,
                                Mistakes& mistakes);

/// Those of them that conduct as an interface does: neither perfect nor open.
std::vector<Contact> conducting_bonds(const std::vector<Contact>& bonds, const MachineDescription& description);

}  // namespace deadpoint::machine
