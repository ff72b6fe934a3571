#pragma once

#include "deadpoint/fem/algebra/petsc.hpp"

#include <cstdint>
#include <vector>

namespace deadpoint {
struct Material;
}

/// Internal to fem/: materials that depend on temperature.
namespace deadpoint::fem {

class Discretisation;
class HeatMatrices;

/// Interpolated coefficients (product approximation; Christie et al. 1981, Larsson, Thomee and
/// Zhang 1989): heat content and flux potential are known exactly at the unknowns and interpolated
/// between them as the temperature is. The matrices of the constant materials then act on them,
///   E = M h(T),   r = -K T - K_v theta(T),   tangent  M diag(h') + d (K + K_v diag(theta')),
/// so that a run integrates no cell again.
class MaterialMaps {
public:
    MaterialMaps(const Discretisation& space, const std::vector<Material>& materials, const HeatMatrices& matrices,
                 Vec pattern);

    [[nodiscard]] bool vary() const { return capacity_varies_ || conduction_varies_; }
    [[nodiscard]] bool conduction_varies() const { return conduction_varies_; }
    /// M h(T) [J].
    void store(Vec temperature, Vec stored) const;
    /// K T + K_v theta(T) [W].
    void conduct(Vec temperature, Vec conducted) const;
    /// Heat stored between two fields [J].
    [[nodiscard]] double stored_between(Vec from, Vec to) const;
    /// Add the tangents of conduction and storage, or with a null temperature the constants.
    void add_conduction_tangent(Mat matrix, Vec temperature) const;
    void add_capacity(Mat matrix, Vec temperature) const;
    /// Matrices that hold tangents, none of which is symmetric.
    void mark_tangents() const;
    /// Part of each of this rank's unknowns.
    [[nodiscard]] const std::vector<std::uint32_t>& part_of_unknown() const { return parts_; }

private:
    using Map = double (*)(const Material& material, double temperature);
    void map(Map of, Vec from, Vec to) const;
    [[nodiscard]] Vec heat_of(Vec temperature) const;
    void add_tangent(Mat matrix, Mat of, Mat scaled, Map slope, Vec temperature) const;

    const std::vector<Material>& materials_;
    const HeatMatrices& matrices_;
    std::vector<std::uint32_t> parts_;
    bool capacity_varies_ = false, conduction_varies_ = false;
    OwnedMat scaled_mass_, scaled_conduction_;
    OwnedVec mapped_, change_, capacities_;  ///< the last M 1 [J/K]
};

}  // namespace deadpoint::fem
