#pragma once

#include "deadpoint/core/vec.hpp"

#include <vector>

namespace deadpoint {
struct ForceGauge;
struct RestLoads;
}  // namespace deadpoint

namespace deadpoint::fem {

class Model;

/// The initial strain of rods that gives them the wanted forces under the weights: the nuts shorten
/// each rod. One solve per rod with a unit of shortening gives all forces; a linear system gives
/// the shortenings.
///
/// @param rods     gauges of rods, each of another part
/// @param forces   wanted in each [N]
/// @param gravity on the parts that stand on the feet [m/s2]
/// @throws InputError if a rod is not bonded at two ends, or tightening does not stretch it
RestLoads tighten(Model& model, std::size_t part_count, const std::vector<ForceGauge>& rods,
                  const std::vector<double>& forces, const Vec3& gravity);

}  // namespace deadpoint::fem
