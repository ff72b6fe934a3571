#pragma once

#include "deadpoint/exchange/heat.hpp"
#include "deadpoint/exchange/material.hpp"
#include "deadpoint/fem/conduction/joint_terms.hpp"
#include "deadpoint/fem/space/discretisation.hpp"

#include <vector>

/// Internal to fem/: the matrices of heat conduction.
namespace deadpoint::fem {

/// The conduction matrix is affine,
///   K = K_solid + sum over joints of coefficients times their terms + sum over surfaces of h_f F_f,
/// and all of one pattern, with zeros where a matrix has nothing, so that matrices are added as they lie in memory.
/// Cells and contacts are integrated once; other laws of joints and films change coefficients only. Where all segments
/// have the same laws, K alone is kept; the first other law integrates K_solid once more and keeps it from then on.
class HeatMatrices {
public:
    HeatMatrices(const Discretisation& space, const std::vector<Material>& materials, const HeatProblem& problem);

    /// Whether the matrices serve another problem: the same surfaces by kind, and joints that turn as these do.
    [[nodiscard]] bool serve(const HeatProblem& problem) const;
    /// Takes the coefficients of its constant films.
    void adopt(const HeatProblem& problem);
    /// Makes K for these laws; returns whether it changed.
    bool set_laws(const std::vector<InterfaceLaw>& laws);

    [[nodiscard]] Mat mass() const { return mass_; }
    /// K without what follows the temperature.
    [[nodiscard]] Mat stiffness() const { return stiffness_; }
    /// Films that follow the temperature, filled elsewhere; none where no film does.
    [[nodiscard]] Mat films() const { return films_; }
    /// K_v, conduction of parts whose conductivity follows the temperature; none where no material has a table of it.
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
    Coefficients wanted_, present_;  ///< present_ empty: K is K_solid
    OwnedMat mass_, solid_, stiffness_, films_, conduction_;
    int integrations_ = 0;
};

}  // namespace deadpoint::fem
