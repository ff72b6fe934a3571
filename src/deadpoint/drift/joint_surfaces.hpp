#pragma once

#include <vector>

/// Surfaces that carry a joint.
namespace deadpoint::drift {

/// A side of a contact: the surface of one part there.
struct ContactSide {
    int contact = 0;  ///< index into Machine::interfaces
    bool side_b = false;
};

/// The surfaces that carry a joint in each of its two bodies.
struct JointSurfaces {
    std::vector<ContactSide> in_a;
    std::vector<ContactSide> in_b;
    bool passes_tilt = true;  ///< false for a ball joint, drawn as a pin
};

}  // namespace deadpoint::drift
