#pragma once

#include "deadpoint/core/vec.hpp"
#include "deadpoint/crankshaft/shaft/matrix.hpp"
#include "deadpoint/crankshaft/shaft/shaft.hpp"

#include <span>
#include <string>
#include <vector>

/// The shaft on its bearings as a system of linear equations of motion.
namespace deadpoint::crankshaft {

/// Unknowns and properties of a bearing.
struct BearingSeat {
    std::string name;
    int node = 0;
    int housing = -1;  ///< first of the housing's two unknowns (x, y); -1: the housing is rigid
    Matrix2 stiffness{};
    Matrix2 damping{};
};

/// M q'' + (C - omega G) q' + K q = F, with K including the stiffness of the axial load.
///
/// Four unknowns per node, [x y ty tz] with ty = -dy/ds and tz = dx/ds for a slender shaft, then
/// two per elastic housing. The axial displacement is left out, since it is not coupled to the
/// lateral ones.
struct ShaftSystem {
    std::vector<double> nodes;  ///< s, ascending [m]
    Matrix mass;
    Matrix gyroscopic;
    Matrix stiffness;          ///< bending and restoring
    Matrix bending;            ///< stiffness of the beams, which no rigid motion of the shaft strains
    Matrix restoring;          ///< stiffness of bearings, supports and axial load
    Matrix damping;            ///< of bearings and supports, without modal damping
    double modal_damping = 0;  ///< ratio, of every mode of the resting shaft, used by the forced responses
    std::vector<BearingSeat> bearings;

    [[nodiscard]] int size() const { return mass.rows; }
};

/// Number of the first unknown of a node.
constexpr int first_unknown(int node) { return 4 * node; }
/// The node at a position. @throws InputError if there is none
int node_at(const ShaftSystem& system, double position);

/// Assembles beams, disks, bearings and housings. Nodes are the ends of sections and every position
/// of a disk, a bearing, an unbalance, or `more_positions`, where a section is cut in two (places
/// within 1e-6 of the shaft's length are one).
///
/// @param more_positions  further nodes [m]
/// @throws InputError as check_shaft, or if a position lies beyond the shaft
ShaftSystem assemble(const Shaft& shaft, std::span<const double> more_positions = {});

/// Work-equivalent load of a force at a position, or spread evenly over `width` about it, per unit of force: n x 2 for
/// the directions x and y. Needs nodes at the position, or at both ends of the spread.
/// @throws InputError if such a node is missing
Matrix force_pattern(const ShaftSystem& system, double position, double width = 0);

/// Load of an acceleration a [m/s2] of shaft, disks and housings, as weight is: M times a rigid translation [N].
std::vector<double> weight_pattern(const ShaftSystem& system, const Vec2& acceleration);

/// Displacement under a constant load, K q = F (a turning shaft at rest in this frame has no other terms) [m, rad].
/// @throws InputError if the bearings do not hold the shaft, or it buckles
std::vector<double> static_displacement(const ShaftSystem& system, std::span<const double> load);

/// Force on every bearing by the shaft, K_b (q_shaft - q_housing), without its damping [N].
std::vector<Vec2> bearing_forces(const ShaftSystem& system, std::span<const double> displacement);

}  // namespace deadpoint::crankshaft
