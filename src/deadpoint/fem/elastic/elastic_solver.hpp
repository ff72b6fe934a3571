#pragma once

#include "deadpoint/exchange/deformation.hpp"
#include "deadpoint/exchange/laws/material.hpp"
#include "deadpoint/fem/algebra/petsc.hpp"
#include "deadpoint/fem/algebra/shell_matrix.hpp"
#include "deadpoint/fem/elastic/factor_solver.hpp"
#include "deadpoint/fem/elastic/ties.hpp"

#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

/// Internal to fem/: linear thermo-elasticity of all bodies at once; bodies do not touch each other here.
namespace deadpoint::fem {

class Discretisation;
class RigidPieces;
struct Adjoint;
struct Displacement;
struct Field;
struct PointShape;

class ElasticSolver {
public:
    ElasticSolver(const Discretisation& space, const std::vector<Material>& materials, const Foundation& foundation);

    std::vector<Adjoint> adjoints(const std::vector<Functional>& functionals);
    /// Forces as functionals of the temperature alone, including its deformation and its thermal
    /// strain.
    std::vector<Adjoint> adjoints(const std::vector<ForceGauge>& gauges);
    /// @param rise  as Model::expansion_rise()
    Displacement displacement(const Field& rise);
    /// Several at once, which takes far less time each where a sparse factor fits into memory.
    std::vector<Displacement> displacements(const std::vector<Field>& rises);
    /// The deformation due to weights and initial strain.
    /// @throws InputError if the feet leave the machine free to move under its weight
    Displacement displacement(const RestLoads& loads);
    /// The displacement under a functional's weights as forces [m/N].
    Displacement dual(const Functional& functional);
    std::vector<double> evaluate(const std::vector<Functional>& functionals, const Displacement& displacement);
    /// Forces due to weights and initial strain.
    std::vector<double> forces(const std::vector<ForceGauge>& gauges, const RestLoads& loads,
                               const Displacement& displacement);
    [[nodiscard]] int iterations() const { return iterations_; }

private:
    /// A force as  stiffness . u - shape . (loads that strain without force), both by displacement unknown.
    struct Gauge {
        std::vector<double> shape;  ///< all ranks' unknowns; the virtual displacement on which the force does work
        bool with_weight = false;   ///< the weight of the nodes that `shape` moves is not part of the force
        double factor = 1;          ///< for a part that the symmetry plane cuts
    };
    void find_supports(const Foundation& foundation);
    void assemble();
    void choose_solver(PetscInt size);
    void make_factor();
    void set_near_null_space();
    void solve_free(const char* what);
    [[nodiscard]] OwnedMat free_columns(PetscInt count) const;
    /// @param load  sets rhs_ to the load of that number
    /// @param take  reads its displacement in solution_
    void solve_all(std::size_t count, const char* what, const std::function<void(std::size_t)>& load,
                   const std::function<void(std::size_t)>& take);
    void solve_block(std::size_t first, std::size_t last, const char* what,
                     const std::function<void(std::size_t)>& load, const std::function<void(std::size_t)>& take);
    void take_free_load();
    void require_equilibrium();
    [[nodiscard]] Displacement owned_solution() const;
    /// Calls visit(shape functions at a point of a pad, its stiffness with three rows per unknown).
    void
    for_each_pad(const std::function<void(const PointShape& shape, const std::vector<double>& stiffness)>& visit) const;
    void load(const Functional& functional, Vec target) const;
    void load_thermal(const Field& rise, Vec target) const;
    void load_initial_strain(const std::vector<Tensor6>& strain, Vec target) const;
    void load_weight(const Vec3& gravity, Vec target) const;
    /// Displacements on all ranks that are to become adjoints, a few at a time: each round visits all cells.
    struct Pending {
        std::vector<std::string> names;
        std::vector<std::vector<double>> displacements;
    };
    void add_adjoint(Pending& pending, const std::string& name, std::vector<double> displacement,
                     std::vector<Adjoint>& result) const;
    void finish_adjoints(Pending& pending, std::vector<Adjoint>& result) const;
    [[nodiscard]] std::vector<Adjoint> temperature_weights(const Pending& pending) const;
    void load_dual(const Functional& functional);
    void clear_fixed(Vec vector) const;
    [[nodiscard]] double thermal_modulus(int part) const;  ///< E alpha / (1 - 2 nu) [Pa/K], alpha the expansion_scale()

    [[nodiscard]] Gauge describe(const ForceGauge& gauge) const;
    [[nodiscard]] Gauge describe_rod(const ForceGauge& gauge) const;
    [[nodiscard]] Gauge describe_bond(int bond) const;
    [[nodiscard]] Gauge describe_feet() const;
    void pass_on(std::vector<double>& shape) const;
    /// target = K shape, without the pads.
    void stiffness_times(const std::vector<double>& shape, Vec target) const;
    [[nodiscard]] Functional pad_force() const;

    const Discretisation& space_;
    const std::vector<Material>& materials_;
    Foundation foundation_;
    Vec3 foot_normal_{0, -1, 0};  ///< out of the feet, along an axis
    Ties ties_;
    OwnedMat expansion_;  ///< from free to all displacements
    OwnedMat matrix_;     ///< of the free displacements; none once there is a factor
    OwnedKsp solver_;
    std::unique_ptr<SymmetricTriplets> upper_half_;  ///< of the matrix, with its factor
    std::unique_ptr<SparseFactor> factor_;           ///< where it fits into memory
    std::unique_ptr<ShellMatrix> operator_;          ///< multiplies with upper_half_
    FactorSolver factor_solver_;
    OwnedVec solution_, rhs_;  ///< all displacements
    OwnedVec free_solution_, free_rhs_;
    std::unique_ptr<RigidPieces> pieces_;
    std::vector<PetscInt> held_;   ///< unknowns without displacement, on all ranks
    std::vector<PetscInt> feet_;   ///< unknowns at the feet that are held or on pads, on all ranks
    std::vector<PetscInt> fixed_;  ///< this rank's, as global numbers of free displacements
    int iterations_ = 0;
};

}  // namespace deadpoint::fem
