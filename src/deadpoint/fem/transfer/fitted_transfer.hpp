#pragma once

#include "deadpoint/fem/algebra/petsc.hpp"

#include <vector>

/// Internal to fem/: temperatures for the deformation's mesh.
namespace deadpoint::fem {

class Discretisation;

class Transfer;

/// The field on a coarse mesh that fits a fine field best: T_c with the least  sum of w_i ((Q
/// T_c)_i - T_i)^2  over the fine mesh's unknowns, where Q are the coarse shape functions at their
/// places and w_i [m3] their shares of volume.
///
/// Each part therefore keeps its mean temperature and, over any few cells, its heat; values at the
/// coarse nodes alone do not. Starting from the values I T at these nodes,
///
///   T_c = I T + (Q^T W Q + s V)^-1 Q^T W (T - Q I T)
///
/// V are the volumes of the coarse unknowns. With s = 1e-3, I T remains where no fine unknown lies
/// in a coarse cell. Linear fields pass exactly, T = Q I T. Both meshes and both transfers outlive
/// this; all functions collective.
class FittedTransfer {
public:
    /// @param values  I, from the fine mesh to the coarse one
    /// @param back    Q, from the coarse mesh to the fine one
    FittedTransfer(const Discretisation& fine, const Discretisation& coarse, const Transfer& values,
                   const Transfer& back);

    /// P T: this rank's values on the coarse mesh.
    [[nodiscard]] std::vector<double> apply(const std::vector<double>& owned) const;
    /// P^T w: weights on the fine mesh with w . (P T) = (P^T w) . T.
    [[nodiscard]] std::vector<double> apply_transposed(const std::vector<double>& owned) const;

private:
    void assemble(const Discretisation& coarse);
    /// (Q^T W Q + s V)^-1 rhs
    [[nodiscard]] std::vector<double> solve_normal(const std::vector<double>& rhs) const;

    const Transfer& values_;
    const Transfer& back_;
    std::vector<double> weight_;  ///< W, per owned fine unknown [m3]
    OwnedMat matrix_;
    OwnedKsp solver_;
    OwnedVec rhs_, solution_;
};

}  // namespace deadpoint::fem
