#pragma once

#include "deadpoint/fem/model.hpp"

#include <vector>

namespace deadpoint::fem {

/// The initial strain of rods that gives them the wanted forces, weights acting: each rod is shortened by what its nuts
/// are turned. One solve per rod with a unit of shortening gives all forces, and a linear system the shortenings.
///
/// @param rods     gauges of rods, each of another part
/// @param forces   wanted in each [N]
/// @param gravity  on what stands on the feet [m/s2]
/// @throws InputError where a rod is not bonded at two ends, or tightening does not stretch it
RestLoads tighten(Model& model, std::size_t part_count, const std::vector<ForceGauge>& rods,
                  const std::vector<double>& forces, const Vec3& gravity);

}  // namespace deadpoint::fem
