#pragma once

#include "deadpoint/fem/space/discretisation.hpp"
#include "deadpoint/heat/system.hpp"

#include <memory>
#include <vector>

/// Internal to fem/: the linear system of a stage and its solver.
namespace deadpoint::fem {

class CoarseMatrices;
class FilmPoints;
class HeatMatrices;
class MaterialMaps;
class PrescribedTemperatures;
class ShellMatrix;

/// y = (M + factor (K + K_films)) x less terms of low rank, solved by conjugate gradients (BiCGStab
/// if materials depend on temperature), preconditioned by algebraic multigrid of the assembled
/// part.
class StageMatrix {
public:
    /// All arguments outlive this. @param longest  stage that will be asked for [s]
    StageMatrix(const Discretisation& space, const HeatMatrices& matrices, const MaterialMaps& maps,
                const PrescribedTemperatures& prescribed, const FilmPoints& films, double longest);

    ~StageMatrix();

    /// Call it if the laws have changed, or if longer stages follow: aggregates and interpolation
    /// are built again.
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
    /// Makes the preconditioner ready, as its first use would.
    void set_up(Vec any, Vec work);
    /// Temperature from which the preconditioner was built, if it depends on temperature; else
    /// null.
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
    std::unique_ptr<CoarseMatrices> coarse_;  ///< if the system does not depend on temperature; null: to be built
    double factor_ = -1;
    double multigrid_factor_ = -1;  ///< for which the multigrid hierarchy was built
    OwnedVec origin_;               ///< temperature from which it was built, if the matrix depends on it
    std::vector<SparseFunctional> source_loads_;
    const heat::LowRank<OwnedVec>* low_rank_ = nullptr;  ///< of the solve under way
};

}  // namespace deadpoint::fem
