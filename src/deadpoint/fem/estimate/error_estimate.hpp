#pragma once

#include "deadpoint/exchange/laws/material.hpp"

#include <vector>

namespace deadpoint {
struct HeatProbe;
}

/// Internal to fem/: error estimates of functionals of temperature and deformation, by part.
namespace deadpoint::fem {

class Discretisation;
struct Displacement;
struct Field;

/// Error of the functional J(T) with the adjoint solution z, to be added to J, per adjoint solution
/// and part:
///
///     eta = sum over the part's cells of the integral of  k (G T - grad T) . (G z - grad z)         [unit of J]
///
/// With the discrete adjoint solution z_h, J(T) - J(T_h) = A(T - T_h, z - z_h) exactly for a
/// symmetric form A (Becker and Rannacher, Acta Numerica 10, 2001); the gradients of T and z are
/// replaced by recovered ones (Zienkiewicz and Zhu, Int. J. Numer. Meth. Eng. 33, 1992). G is a
/// polynomial of the elements' order per vertex, fitted to the gradients at the superconvergent
/// points of the cells around it (and their neighbours at the part's surface), blended within a
/// cell by the vertices' shape functions. Parts are recovered each by itself.
///
/// Not included: errors across a part that is a single cell thick, and facets in place of curved
/// faces.
///
/// @param temperature  [K]
/// @param duals        [unit of J / W]
std::vector<std::vector<double>> conduction_errors(const Discretisation& space, const std::vector<Material>& materials,
                                                   const Field& temperature, const std::vector<Field>& duals);

/// The same for functionals of the deformation [m]: the integral of (G e(u) - e(u)) : C : (G e(z) - e(z)) with the
/// strains e and the isotropic elasticity C.
///
/// @param displacement  [m]
/// @param duals         displacement under the functional's weights as forces [m/N]
std::vector<std::vector<double>> deformation_errors(const Discretisation& space, const std::vector<Material>& materials,
                                                    const Displacement& displacement,
                                                    const std::vector<Displacement>& duals);

/// Interpolation error of the temperature at a point of a cell, for elements of first order [K]:
///
///     1/2 sum over the cell's vertices v of  N_v(x) G T(x_v) . (x - x_v)
///
/// exact for a quadratic field with exact values at the vertices. The adjoint solution of a point,
/// a source in a single cell, is too sharp for its recovered gradient to show this part of the
/// error. 0 for elements of second order.
std::vector<double> interpolation_errors(const Discretisation& space, const Field& temperature,
                                         const std::vector<HeatProbe>& probes);

}  // namespace deadpoint::fem
