#pragma once

#include "deadpoint/fem/discretisation.hpp"
#include "deadpoint/fem/model.hpp"
#include "deadpoint/fem/rigid_pieces.hpp"
#include "deadpoint/fem/ties.hpp"

#include <memory>

/// Internal to fem/: linear thermo-elasticity of all bodies at once; bodies do not touch each other here.
namespace deadpoint::fem {

class ElasticSolver {
public:
    ElasticSolver(const Discretisation& space, const std::vector<Material>& materials, int feet_surface);

    std::vector<Adjoint> adjoints(const std::vector<Functional>& functionals);
    /// The displacement under a functional's weights as forces [m/N].
    Displacement dual(const Functional& functional);
    Displacement displacement(const Field& temperature, double reference_temperature);
    std::vector<double> evaluate(const std::vector<Functional>& functionals, const Displacement& displacement);
    [[nodiscard]] int iterations() const { return iterations_; }

private:
    [[nodiscard]] std::vector<PetscInt> supported(int feet_surface) const;
    void assemble();
    void keep_upper_half();
    void choose_solver(PetscInt size);
    void set_near_null_space();
    void solve_free(const char* what);
    /// Calls visit(shape functions, unknowns, thermal modulus of the part) for each cell of this rank.
    template <class Visitor>
    void for_each_cell(const Visitor& visit) const;
    void load(const Functional& functional, Vec target) const;
    void solve_dual(const Functional& functional);
    [[nodiscard]] Displacement owned_solution() const;
    void clear_fixed(Vec vector) const;
    [[nodiscard]] double thermal_modulus(int part) const;  ///< E alpha / (1 - 2 nu) [Pa/K]

    const Discretisation& space_;
    const std::vector<Material>& materials_;
    Ties ties_;
    OwnedMat expansion_;  ///< from free to all displacements
    OwnedMat matrix_;     ///< of the free displacements
    OwnedKsp solver_;
    OwnedVec solution_, rhs_;  ///< all displacements
    OwnedVec free_solution_, free_rhs_;
    std::unique_ptr<RigidPieces> pieces_;
    std::vector<PetscInt> fixed_;  ///< this rank's, as global numbers of free displacements
    int iterations_ = 0;
};

}  // namespace deadpoint::fem
