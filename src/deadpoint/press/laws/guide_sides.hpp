#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace deadpoint {
struct Machine;
}
namespace deadpoint::casefile {
struct Case;
}

/// Which faces of a guide are pressed, and how much.
namespace deadpoint::press {

struct LoadsResult;

/// Loads of a slide's faces by side. An interface pushes the slide along its normal or against it; its side is the sign
/// of that push across the direction of travel.
struct GuideSides {
    std::vector<int> of_interface;  ///< per interface of the joint: 1, -1, or 0 for a face that carries no side force
    double load_plus = 0;           ///< mean of the normal force of side 1 over the turn [N]
    double load_minus = 0;
    double heat_plus = 0;  ///< share of mean(N |v|) that side 1 has; the other has the rest

    [[nodiscard]] double load(int side) const { return side > 0 ? load_plus : load_minus; }
    [[nodiscard]] double heat(int side) const { return side > 0 ? heat_plus : 1 - heat_plus; }
};

/// None for a joint that is no slide, has not both sides, or stands for itself and its image: in a half model, and for
/// a body that exists twice.
/// @param first  index of the joint's first interface in Machine::interfaces
std::optional<GuideSides> guide_sides(const casefile::Case& input, const Machine& machine, const LoadsResult& loads,
                                      const std::string& joint, std::size_t first);

/// Factors on the heat per area of a guide's interfaces, for the law "guide". Coulomb's friction is shared by the
/// normal forces of the two sides, the shear of the oil film by area:
///
///   factor = 1 + part (share A / A_side - 1),    A = sum of heat_share times area of both sides, A_side of one of them
///
/// so that the joint as a whole keeps its heat.
/// @param part  of the heat that follows the load, 0 to 1
std::vector<double> side_factors(const casefile::Case& input, const Machine& machine, const GuideSides& sides,
                                 const std::string& joint, std::size_t first, double part);

}  // namespace deadpoint::press
