#pragma once

#include "deadpoint/exchange/machine.hpp"

#include <optional>
#include <vector>

namespace deadpoint {
class Mistakes;
}

namespace deadpoint::machine {

struct Assembly;

/// One side of a contact: faces, and the box they are clipped to.
struct Side {
    std::vector<std::uint32_t> faces;
    std::optional<BoxShape> within;
};

/// The contact of two sides, with integration points. `name` is not set; the parts are not set if
/// there are no points.
///
/// Faces of both sides are unrolled into the parameters of the surface of side a and clipped
/// against each other. If side a travels, this is repeated with its faces displaced to every stop;
/// weights and covered shares are then time means. A stop that lifts a surface off the other by
/// more than the gap has no contact there.
/// @param gap      largest distance that counts as contact [m]
/// @param covered  per face of the machine: the share of it in contact is added
/// @param travel   of side a against side b; empty: none
Contact find_contact(const Assembly& assembly, const Side& a, const Side& b, double gap, std::vector<double>& covered,
                     const std::vector<TravelStop>& travel = {});

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
