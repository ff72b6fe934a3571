#pragma once

#include "deadpoint/fem/discretisation.hpp"
#include "deadpoint/fem/model.hpp"
#include "deadpoint/fem/rigid_pieces.hpp"

#include <memory>

/// Internal to fem/: linear thermo-elasticity of all bodies at once; bodies do not touch each other here.
namespace deadpoint::fem {

class ElasticSolver {
public:
    ElasticSolver(const Discretisation& space, const std::vector<Material>& materials, int feet_surface);

    std::vector<Adjoint> adjoints(const std::vector<Functional>& functionals);
    Displacement displacement(const Field& temperature, double reference_temperature);
    std::vector<double> evaluate(const std::vector<Functional>& functionals, const Displacement& displacement);
    [[nodiscard]] int iterations() const { return iterations_; }

private:
    [[nodiscard]] std::vector<PetscInt> supported(int feet_surface) const;
    void assemble();
    void assemble_bonds();
    void set_near_null_space();
    /// Sum over the machine of the thermal stress's work: visit(unknown, part-wise weights) is built on this.
    template <class CellVisitor, class BondVisitor>
    void for_each_thermal_term(const CellVisitor& cell_visitor, const BondVisitor& bond_visitor) const;
    void load(const Functional& functional, Vec target) const;
    void clear_fixed(Vec vector) const;
    [[nodiscard]] double thermal_modulus(int part) const;  ///< E alpha / (1 - 2 nu) [Pa/K]

    const Discretisation& space_;
    const std::vector<Material>& materials_;
    OwnedMat matrix_;
    OwnedKsp solver_;
    OwnedVec solution_, rhs_, last_;
    std::unique_ptr<RigidPieces> pieces_;
    std::vector<PetscInt> fixed_;  ///< owned, global numbers
    int iterations_ = 0;
};

}  // namespace deadpoint::fem
