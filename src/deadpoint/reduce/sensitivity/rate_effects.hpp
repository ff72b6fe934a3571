#pragma once

#include "deadpoint/reduce/sensitivity/heat_scalars.hpp"
#include "deadpoint/reduce/sensitivity/inner_layout.hpp"

#include <cstddef>
#include <utility>
#include <vector>

/// Internal to reduce/: what a scalar of the heat balance does to its rates.
namespace deadpoint::reduce {

class LinearisedHeat;
struct LinearisedState;

/// Derivative of the rates by one scalar, but for the matrix of conduction.
struct RateEffect {
    std::vector<std::pair<std::size_t, double>> watts;  ///< by functional
    std::vector<std::pair<InnerPlace, double>> inner;   ///< on the rates or equations of inner values
};

/// With the sum S = h_a + h_b + g of an interface, its shares s_x = x / S and its area A,
///   ds_x = (dx - s_x dS) / S
///   dH_r = H_r' (phi dF - phi^2 H_r dS / (A S^2)) + (1 + self H_r') H_r dshare / share
///   dQ = A dg (T_f - T_oil) + g A dT_f,    S dT_f = dh_a (T_a - T_f) + dh_b (T_b - T_f) + dg (T_oil - T_f)
/// and where phi itself changes, as the weights of a source's interfaces do,
///   dH_r = H_r' dphi (F + 2 phi H_r / (A S)),      dQ = g H_r dphi / S
/// where H_r' is the slope by the solids' part of the temperature of the source's contact layers, phi the share of the
/// source's heat that enters this one, and F = (h_a T_a + h_b T_b + g T_oil) / S.
RateEffect effect_of(std::size_t scalar, const LinearisedHeat& heat, const LinearisedState& at);

/// Derivatives of K's coefficients by a scalar: index of a term in PreparedTerms::each, and the change of its
/// coefficient. They hold throughout a segment. d(x y / S) = dx s_y + x ds_y.
std::vector<std::pair<std::size_t, double>> term_changes(std::size_t scalar, const LinearisedHeat& heat);

}  // namespace deadpoint::reduce
