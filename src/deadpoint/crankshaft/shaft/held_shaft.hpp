#pragma once

#include "deadpoint/crankshaft/shaft/eigen_views.hpp"

/// Stiffness of a shaft whose bearings may be softer than it by any factor; only for the sources of this folder.
namespace deadpoint::crankshaft {

struct ShaftSystem;

/// The stiffness in bending relative to the first node, and in the shaft's four rigid motions. In the unknowns of the
/// nodes, a stiffness k of the bearings would be lost in the rounding of the beams' 12 EI / L^3 where it is 1e-16 of
/// them, and rigid frequencies would lose the digits that separate the two. Here the beams have no entries in rigid
/// motions at all. Bearings that are not soft would lose digits in turn: T is 1 then.
struct HeldShaft {
    Eigen::MatrixXd motions;    ///< T, unknowns x coordinates: q = T y
    Eigen::MatrixXd stiffness;  ///< T^T K T, with the skew part of K
};

HeldShaft held_shaft(const ShaftSystem& system);

/// L of the symmetric part of that stiffness, L L^T.
/// @throws InputError if it is not positive definite
Eigen::LLT<Eigen::MatrixXd> factor_of(const HeldShaft& held);

}  // namespace deadpoint::crankshaft
