#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace deadpoint {

/// A symmetric tensor of stress [Pa] (tension positive) or strain [-]: xx, yy, zz, xy, yz, zx.
using Tensor6 = std::array<double, 6>;

/// Equivalent stress after von Mises [Pa].
double von_mises(const Tensor6& stress);
/// Principal stresses, the largest first [Pa].
std::array<double, 3> principal(const Tensor6& stress);
/// Stress across a plane, n . sigma n, for a unit normal n [Pa].
double normal_stress(const Tensor6& stress, const std::array<double, 3>& normal);

/// Stress at the nodes of one part.
struct PartStress {
    int part = -1;
    std::vector<std::uint32_t> nodes;  ///< index into Machine::nodes
    std::vector<Tensor6> stress;       ///< at those nodes [Pa]
};

}  // namespace deadpoint
