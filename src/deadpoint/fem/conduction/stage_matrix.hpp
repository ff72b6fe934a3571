#pragma once

#include "deadpoint/fem/space/discretisation.hpp"
#include "deadpoint/heat/system.hpp"

#include <memory>
#include <vector>

/// Internal to fem/: the linear system of a stage and its solver.
namespace deadpoint::fem {

class CoarseMatrices;
class FilmPoints;
class FloatCycle;
class HeatMatrices;
class MaterialMaps;
class PrescribedTemperatures;
class ShellMatrix;

/// y = (M + factor (K + K_films)) x less terms of low rank, solved by conjugate gradients (BiCGStab
/// if materials depend on temperature), preconditioned by algebraic multigrid of the assembled
/// part, a cycle in single precision.
class StageMatrix {
public:
    /// All arguments outlive this. @param longest  stage that will be asked for [s]
    StageMatrix(const Discretisation& space, const HeatMatrices& matrices, const MaterialMaps& maps,
                const PrescribedTemperatures& prescribed, const FilmPoints& films, double longest);

    ~StageMatrix();

    /// Call it if the laws have changed, or if longer stages follow: aggregates and interpolation
    /// are built again. Until then it takes no memory for them.
    void reset(double longest);
    /// Builds aggregates and interpolation if they do not exist.
    void prepare();
    /// The matrix must be built again, but not the aggregates.
    void forget() { factor_ = -1; }
    /// Load b_r of each source, without prescribed unknowns.
    void set_source_loads(std::vector<SparseFunctional> loads) { source_loads_ = std::move(loads); }

    [[nodiscard]] double factor() const { return factor_; }
    /// Builds the matrix for a factor [s], with tangents of materials at a temperature if one is
    /// given.
    /// @return true if the preconditioner was built from it
    bool combine(double factor, Vec temperature);
    [[nodiscard]] Mat assembled() const { return system_; }
    /// The preconditioner, after combine().
    [[nodiscard]] FloatCycle& cycle() { return *cycle_; }
    /// Temperature from which the preconditioner was built, if it depends on temperature; else
    /// null.
    [[nodiscard]] Vec preconditioner_temperature() const { return origin_; }
    /// The same, to be filled before the preconditioner is made again.
    Vec prepare_preconditioner_temperature(Vec pattern);

    /// Solves; returns the iterations. @throws ConvergenceError, NotFinite
    int solve(Vec right, Vec solution, const heat::LowRank<OwnedVec>& low_rank, heat::SolveTolerance tolerance,
              const char* what);
    /// The same without terms of low rank, from the guess in `solution`.
    /// @param relative  tolerance as a share of the solution's norm
    int solve_from_guess(Vec right, Vec solution, double relative, const char* what);

private:
    void create_solver();
    void choose_test();
    void create_multigrid();
    void renew_cycle(const std::vector<double>& bounds);
    static PetscErrorCode apply_cycle(PC shell, Vec in, Vec out) noexcept;
    static PetscErrorCode view_cycle(PC shell, PetscViewer viewer) noexcept;
    static PetscErrorCode test(KSP, PetscInt iteration, PetscReal residual, KSPConvergedReason* reason,
                               void* stage) noexcept;
    int solve(Vec right, Vec solution, double size, heat::SolveTolerance tolerance, const char* what);
    void fill(double factor, Mat films, Vec temperature);
    void multiply(Vec in, Vec out) const;
    [[nodiscard]] bool follows_temperature() const;

    const Discretisation& space_;
    const HeatMatrices& matrices_;
    const MaterialMaps& maps_;
    const PrescribedTemperatures& prescribed_;
    const FilmPoints& films_;
    double longest_;
    OwnedMat system_;
    std::unique_ptr<ShellMatrix> shell_;
    OwnedKsp solver_;
    OwnedPc multigrid_;                       ///< the hierarchy; its own cycle is not used
    std::unique_ptr<FloatCycle> cycle_;       ///< null: to be built
    std::unique_ptr<CoarseMatrices> coarse_;  ///< if the system does not depend on temperature; null: to be built
    double factor_ = -1;
    double multigrid_factor_ = -1;  ///< for which the multigrid hierarchy was built
    OwnedVec origin_;               ///< temperature from which it was built, if the matrix depends on it
    std::vector<SparseFunctional> source_loads_;
    /// State of the solve under way.
    struct Progress {
        double relative = 0;    ///< tolerance of a correction's norm, as a share of `size`
        double absolute = 0;    ///< the same itself; the larger one counts
        double size = 0;        ///< of the guess or the largest correction
        double correction = 0;  ///< norm of the last one
        double residual = 0;    ///< norm of the residual before it
        double first_residual = 0;
    };
    const heat::LowRank<OwnedVec>* low_rank_ = nullptr;
    Progress progress_;
    bool predicts_ = false;  ///< uses test()
};

}  // namespace deadpoint::fem
