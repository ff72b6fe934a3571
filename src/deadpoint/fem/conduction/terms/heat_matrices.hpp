#pragma once

#include "deadpoint/fem/conduction/terms/joint_terms.hpp"

#include <vector>

namespace deadpoint {
struct HeatProblem;
struct InterfaceLaw;
struct Material;
}  // namespace deadpoint

/// Internal to fem/: the matrices of heat conduction.
namespace deadpoint::fem {

class Discretisation;

/// The conduction matrix is affine,
///   K = K_solid + sum over joints of coefficients times their terms + sum over surfaces of h_f F_f,
/// All matrices share one sparsity pattern, with explicit zeros, so that sums of matrices are sums
/// of their value arrays. Cells and contacts are integrated once; other laws of joints and
/// convection change coefficients only. If all segments have the same laws, only K is kept. The
/// first other law integrates K_solid once more and keeps it.
class HeatMatrices {
public:
    HeatMatrices(const Discretisation& space, const std::vector<Material>& materials, const HeatProblem& problem);

    /// True if the matrices can be used for another problem with the same surfaces by kind and the
    /// same turning joints.
    [[nodiscard]] bool serve(const HeatProblem& problem) const;
    /// Adopts its constant convection coefficients.
    void adopt(const HeatProblem& problem);
    /// Builds K for these laws; returns true if it changed.
    bool set_laws(const std::vector<InterfaceLaw>& laws);

    [[nodiscard]] Mat mass() const { return mass_; }
    /// K_solid; integrates it if it was not kept.
    [[nodiscard]] Mat solid();
    [[nodiscard]] const std::vector<JointTerm>& joint_terms() const { return joints_.terms(); }
    /// F_f per surface condition; empty where its coefficient depends on temperature.
    [[nodiscard]] const std::vector<SparseTerm>& film_terms() const { return film_terms_; }
    /// K without terms that depend on temperature.
    [[nodiscard]] Mat stiffness() const { return stiffness_; }
    /// Convection terms that depend on temperature, filled elsewhere; null if there are none.
    [[nodiscard]] Mat films() const { return films_; }
    /// K_v, conduction of parts whose conductivity depends on temperature; null if no material has
    /// such a table.
    [[nodiscard]] Mat conduction() const { return conduction_; }
    /// How often cells have been integrated.
    [[nodiscard]] int integrations() const { return integrations_; }

private:
    struct Coefficients {
        std::vector<JointCoefficients> joints;
        std::vector<double> films;
        bool operator==(const Coefficients&) const = default;
    };
    void create_pattern();
    void create_matrices(bool some_films_follow);
    void integrate_solid(Mat stiffness, Mat mass, Mat variable);
    void assemble_cells(Mat mass, Mat stiffness, Mat variable) const;
    void assemble_bonds(Mat stiffness, Mat variable) const;
    void keep_solid();

    const Discretisation& space_;
    const std::vector<Material>& materials_;
    JointTerms joints_;
    std::vector<SparseTerm> film_terms_;
    Coefficients wanted_, present_;
    bool is_solid_ = true;  ///< K is K_solid
    OwnedMat mass_, solid_, stiffness_, films_, conduction_;
    int integrations_ = 0;
};

}  // namespace deadpoint::fem
