#pragma once

#include "deadpoint/crankshaft/shaft/matrix.hpp"

/// The Timoshenko beam element of a spinning shaft.
namespace deadpoint::crankshaft {

/// A piece of shaft of constant cross-section between two nodes.
struct BeamElement {
    double length = 0;          ///< [m]
    double diameter = 0;        ///< [m]
    double bore = 0;            ///< [m]
    double density = 0;         ///< [kg/m3]
    double youngs_modulus = 0;  ///< [Pa]
    double poissons_ratio = 0;
    double shear_factor = 0.9;  ///< ks; 0: no shear deformation, Phi = 0 (Euler-Bernoulli)
    double axial_load = 0;      ///< tension positive [N]
};

/// 10 x 10 matrices of the unknowns [u v w ty tz] at the first and at the second node.
struct ElementMatrices {
    Matrix mass_translation;  ///< [kg]
    Matrix mass_rotation;     ///< rotary inertia of the cross-sections [kg]
    Matrix gyroscopic;        ///< skew; with J = 2 I
    Matrix stiffness;         ///< [N/m]
    Matrix axial_stiffness;   ///< of the axial load, K_P; tension positive [N/m]
};

/// Matrices of the beam in  M q'' + (C - omega G) q' + (K + K_P) q = F  in a stationary frame.
///
/// u is along the shaft, v and w across it (machine x and y), ty = -dw/ds and tz = dv/ds for a slender beam; the spin
/// omega is positive from v to w. The shape functions are those of the Timoshenko beam with Phi = 12 E I / (ks A G L^2)
/// (Przemieniecki; Nelson, J. Mech. Design 102 (1980) 793), the matrices Eq. 15 of Zheng et al. (2018) with these
/// corrections: G(8,5) has the sign that leaves a rigid translation without a moment; K_P is divided by (1+Phi)^2 and
/// tension stiffens; and there is no -omega^2 M_C, which counts the inertia of whirl a second time.
///
/// @throws InputError if a dimension or a modulus is not positive and finite, or the bore is not less than the diameter
ElementMatrices beam_matrices(const BeamElement& beam);

}  // namespace deadpoint::crankshaft
