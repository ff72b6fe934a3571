#pragma once

#include "deadpoint/core/vec.hpp"
#include "deadpoint/crankshaft/response/periodic_load.hpp"
#include "deadpoint/crankshaft/shaft/shaft.hpp"
#include "deadpoint/exchange/cycle.hpp"
#include "deadpoint/exchange/warning.hpp"

#include <array>
#include <string>
#include <vector>

/// Loads of the crankshaft's bearings over one turn: the rigid (traditional) and the flexible (improved) model.
namespace deadpoint::crankshaft {

struct PeriodicSettings;

struct ShaftLoads;

/// Bearing loads of one turn. Bearings in the order of Shaft::bearings.
struct ShaftCycle {
    double speed = 0;          ///< mean spin, positive from x to y [rad/s]
    std::vector<double> time;  ///< evenly spaced from ShaftLoads::time's first [s]
    std::vector<BearingCycle> bearings;
    std::vector<Vec2> pin_deflection;      ///< of the axis at the pin [m]; zero when rigid
    std::vector<double> stiffness_factor;  ///< per bearing: stiffness used over stiffness given (load dependence)
    std::vector<Warning> warnings;         ///< of this analysis, beside shaft_warnings
};

/// Statistics of one bearing's force. Means are over time: the samples are evenly spaced over a whole period.
/// @throws DomainError if there is no sample or one is not finite
BearingCycle summarise(std::string name, std::vector<Vec2> force);

/// Which of the two seats a bearing belongs to: 0 for those below the pin along s, 1 for those beyond it; when all are
/// on one side of the pin, the widest gap between bearings divides them. @throws InputError as check_shaft
std::vector<int> seats_of(const Shaft& shaft, double pin_position);

/// Force of each seat, the sum over its bearings (B and E of the paper); named after them.
std::array<BearingCycle, 2> seat_cycles(const ShaftCycle& cycle, const std::vector<int>& seats);

/// Reactions of a rigid shaft: Eq. 2 of Zheng et al. (2018) with the weight of the crank and the unbalance it omits.
///
/// Moments about the mean positions of the two seats (seats_of) give each seat's force, shared equally by its bearings.
/// With two bearings that is exact; with more a stiff shaft would also load the bearings of a seat unequally. Loads:
/// pin force, weight of sections and disks, steady forces, and unbalance U (theta'^2 e_r - theta'' e_t).
/// @throws InputError as check_shaft, or if the loads are incomplete, not finite, or beyond the shaft
ShaftCycle rigid_cycle(const Shaft& shaft, const ShaftLoads& loads);

/// Reactions of the flexible shaft, from the periodic response to the same loads; see periodic_response.
///
/// The gyroscopic terms use the mean speed. Weight is that of shaft, disks and housings: with three
/// bearings or more, a housing that sinks on its support under its own weight relieves its bearing.
/// A bearing with an exponent n of F = K d^n other than 1 has the stiffness (F / F_ref)^((n-1)/n)
/// times the given one, with F the magnitude of its mean force (not below 1 % of F_ref, with a
/// warning), iterated to 1e-10. The force on a bearing includes its damping.
/// @throws as rigid_cycle and periodic_response; ConvergenceError if the load-dependent stiffness does not settle
ShaftCycle flexible_cycle(const Shaft& shaft, const ShaftLoads& loads, const PeriodicSettings& settings = {});

/// Static sag and bearing forces under weight, the steady forces and the mean pin force.
struct StaticState {
    std::vector<double> nodes;        ///< s [m]
    std::vector<Vec2> deflection;     ///< of the axis [m]
    std::vector<Vec2> bearing_force;  ///< on the bearing by the shaft [N]
};
StaticState static_state(const Shaft& shaft, const ShaftLoads& loads);

/// The shaft with the stiffness of its bearings at their mean load in this cycle, for modes() and
/// campbell().
Shaft with_stiffness(Shaft shaft, const ShaftCycle& cycle);

}  // namespace deadpoint::crankshaft
