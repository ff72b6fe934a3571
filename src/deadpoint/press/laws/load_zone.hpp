#pragma once

#include "deadpoint/core/vec.hpp"

#include <functional>
#include <string>

namespace deadpoint::press {
struct LoadsResult;
}

namespace deadpoint::casefile {
struct Case;
}

/// Distribution of the load part of a bearing's friction heat around its ring.
namespace deadpoint::press {

/// Relative density of a bearing's load heat over the position in its standing ring, mean 1 around the circumference:
///
///   sum over the turn of  F^1.33 |w| max(cos(psi - psi_F), 0)^2,   normalised,
///
/// with psi_F where the moving body presses against the ground. A half-ring load zone (no
/// clearance, no preload: Q ~ cos^1.5 on the balls) of friction proportional to Q^(4/3). Bearings
/// of one joint share their pooled zone.
///
/// @param joint  of kind revolute with the ground as one of its bodies
/// @param loads  of the operating point
std::function<double(const Vec3&)> load_zone(const casefile::Case& input, const std::string& joint,
                                             const LoadsResult& loads);

}  // namespace deadpoint::press
