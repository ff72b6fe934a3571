#pragma once

#include "deadpoint/fem/conduction/coarse_matrices.hpp"
#include "deadpoint/fem/conduction/film_points.hpp"
#include "deadpoint/fem/conduction/heat_functionals.hpp"
#include "deadpoint/fem/conduction/heat_matrices.hpp"
#include "deadpoint/fem/conduction/material_maps.hpp"
#include "deadpoint/fem/space/shell_matrix.hpp"
#include "deadpoint/heat/system.hpp"

#include <memory>
#include <vector>

/// Internal to fem/: the linear system of a stage and its solver.
namespace deadpoint::fem {

/// y = (M + factor (K + K_films)) x less terms of low rank, solved by conjugate gradients (BiCGStab where materials
/// follow the temperature), preconditioned by algebraic multigrid of the assembled part.
class StageMatrix {
public:
    /// All arguments outlive this. @param longest  stage that will be asked for [s]
    StageMatrix(const Discretisation& space, const HeatMatrices& matrices, const MaterialMaps& maps,
                const PrescribedTemperatures& prescribed, const FilmPoints& films, double longest);

    /// The laws have changed, or longer stages will be asked for: aggregates and interpolation are made anew.
    void reset(double longest);
    /// Makes aggregates and interpolation, unless that was done.
    void prepare();
    /// The matrix has to be made anew, but not the aggregates.
    void forget() { factor_ = -1; }
    /// Load b_r of each source, without prescribed unknowns.
    void set_source_loads(std::vector<SparseFunctional> loads) { source_loads_ = std::move(loads); }

    [[nodiscard]] double factor() const { return factor_; }
    /// Makes the matrix for a factor [s], with tangents of materials at a temperature if one is given.
    /// @return whether the preconditioner was made of it
    bool combine(double factor, Vec temperature);
    [[nodiscard]] Mat assembled() const { return system_; }
    /// Makes the preconditioner ready, as its first use would.
    void set_up(Vec any, Vec work);
    /// Of what the preconditioner was made where it follows the temperature; else null.
    [[nodiscard]] Vec preconditioner_temperature() const { return origin_; }
    /// The same, to be filled before the preconditioner is made again.
    Vec prepare_preconditioner_temperature(Vec pattern);

    /// Solves; returns the iterations. @throws ConvergenceError, NotFinite
    int solve(Vec right, Vec solution, const heat::LowRank<OwnedVec>& low_rank, heat::SolveTolerance tolerance,
              const char* what);
    /// The same without terms of low rank, from the guess in `solution`.
    int solve_from_guess(Vec right, Vec solution, double relative, const char* what);

private:
    void create_solver();
    void fill(double factor, Mat films, Vec temperature);
    void multiply(Vec in, Vec out) const;
    [[nodiscard]] bool follows_temperature() const { return films_.some() || maps_.vary(); }

    const Discretisation& space_;
    const HeatMatrices& matrices_;
    const MaterialMaps& maps_;
    const PrescribedTemperatures& prescribed_;
    const FilmPoints& films_;
    double longest_;
    OwnedMat system_;
    std::unique_ptr<ShellMatrix> shell_;
    OwnedKsp solver_;
    std::unique_ptr<CoarseMatrices> coarse_;  ///< where the system does not follow the temperature; null: to be built
    double factor_ = -1;
    double multigrid_factor_ = -1;  ///< for which the multigrid hierarchy was built
    OwnedVec origin_;               ///< temperature of which it was built, where the matrix follows it
    std::vector<SparseFunctional> source_loads_;
    const heat::LowRank<OwnedVec>* low_rank_ = nullptr;  ///< of the solve under way
};

}  // namespace deadpoint::fem
