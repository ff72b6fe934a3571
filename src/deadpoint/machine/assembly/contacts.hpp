#pragma once

#include "deadpoint/exchange/machine.hpp"

#include <optional>
#include <vector>

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

}  // namespace deadpoint::machine
