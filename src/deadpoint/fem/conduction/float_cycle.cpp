#include "deadpoint/fem/conduction/float_cycle.hpp"

#include "deadpoint/fem/algebra/vectors.hpp"

#include <algorithm>
#include <array>

namespace deadpoint::fem {
namespace {

// Share of the bound from which on a smoother reduces errors; coarser levels handle lower eigenvalues.
constexpr double smoothed_from = 0.05;
// Largest entry of a scaled residual: far above the smallest floating-point number, since corrections fade by many
// decades away from a local load.
constexpr double largest_entry = 1e10;

// Of two steps of Chebyshev's iteration on [from, to]: the first adds first D^-1 r; the second gives
// (1 - blend) x0 + blend x1 + second D^-1 r.
struct Chebyshev {
    explicit Chebyshev(double bound)
    {
        const double from = smoothed_from * bound, middle = (bound + from) / 2, half = (bound - from) / 2;
        const double sigma = middle / half;
        blend = 2 * sigma * sigma / (2 * sigma * sigma - 1);
        first = static_cast<float>(1 / middle);
        second = static_cast<float>(blend / middle);
    }
    double blend;
    float first, second;
};

void to_floats(Vec from, double factor, std::vector<float>& to)
{
    const ConstEntries values(from);
    PetscInt count = 0;
    DEADPOINT_PETSC(VecGetLocalSize(from, &count));
    for (PetscInt i = 0; i < count; ++i)
        to[static_cast<std::size_t>(i)] = static_cast<float>(factor * values[i]);
}

void to_doubles(const std::vector<float>& from, double factor, Vec to)
{
    Entries values(to);
    PetscInt count = 0;
    DEADPOINT_PETSC(VecGetLocalSize(to, &count));
    for (PetscInt i = 0; i < count; ++i)
        values[i] = factor * static_cast<double>(from[static_cast<std::size_t>(i)]);
}

}  // namespace

FloatCycle::Transfer::Transfer(Mat matrix) : matrix_(matrix)
{
    if (is_assembled(matrix))
        copy_.emplace(matrix);
    else
        DEADPOINT_PETSC(MatCreateVecs(matrix, in_.out(), out_.out()));
}

void FloatCycle::Transfer::multiply(std::vector<float>& in, std::vector<float>& out, bool adds)
{
    if (copy_) {
        copy_->fetch(in);
        if (adds)
            copy_->multiply(in, [&](std::size_t row, float sum) { out[row] += sum; });
        else
            copy_->multiply(in, [&](std::size_t row, float sum) { out[row] = sum; });
        return;
    }
    to_doubles(in, 1, in_);
    DEADPOINT_PETSC(MatMult(matrix_, in_, out_));
    const ConstEntries product(out_);
    PetscInt count = 0;
    DEADPOINT_PETSC(VecGetLocalSize(out_, &count));
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i)
        out[i] = static_cast<float>(product[i]) + (adds ? out[i] : 0.0F);
}

std::size_t FloatCycle::Transfer::entries() const
{
    if (copy_)
        return copy_->entries();
    return 0;
}

FloatCycle::FloatCycle(PC multigrid)
{
    PetscInt count = 0;
    DEADPOINT_PETSC(PCMGGetLevels(multigrid, &count));
    for (PetscInt level = count - 1; level > 0; --level) {
        KSP smoother = nullptr;
        Mat restriction = nullptr, interpolation = nullptr;
        DEADPOINT_PETSC(PCMGGetSmoother(multigrid, level, &smoother));
        DEADPOINT_PETSC(PCMGGetRestriction(multigrid, level, &restriction));
        DEADPOINT_PETSC(PCMGGetInterpolation(multigrid, level, &interpolation));
        const Mat matrix = matrix_of(smoother);
        levels_.push_back(
            {matrix, FloatMatrix(matrix), Transfer(restriction), Transfer(interpolation), {}, {}, {}, {}});
    }
    DEADPOINT_PETSC(PCMGGetCoarseSolve(multigrid, &coarsest_));
    DEADPOINT_PETSC(MatCreateVecs(matrix_of(coarsest_), coarsest_out_.out(), coarsest_in_.out()));
    std::size_t from_finer = 0;  // ghosts of the interpolation to the next finer level
    for (auto& level : levels_) {
        const std::size_t rows = level.matrix.rows();
        const std::size_t ghosts = std::max({level.matrix.ghosts(), level.restriction.ghosts(), from_finer});
        level.right.assign(rows, 0);
        level.solution.assign(rows + ghosts, 0);
        level.work.assign(rows + ghosts, 0);
        from_finer = level.interpolation.ghosts();
    }
    PetscInt rows = 0;
    DEADPOINT_PETSC(VecGetLocalSize(coarsest_in_, &rows));
    coarsest_right_.assign(static_cast<std::size_t>(rows), 0);
    coarsest_solution_.assign(static_cast<std::size_t>(rows) + from_finer, 0);
}

void FloatCycle::take_values(const std::vector<double>& bounds)
{
    auto bound = bounds.rbegin();
    for (auto& level : levels_) {
        level.matrix.take_values(level.source);
        level.inverse_diagonal = level.matrix.inverse_diagonal();
        level.bound = *bound++;
    }
}

// The solution follows from level.solution, or from zero, for level.right.
void FloatCycle::smooth(Level& level, bool from_zero) const
{
    const Chebyshev step(level.bound);
    auto& x = level.solution;
    auto& y = level.work;
    const auto &b = level.right, &scale = level.inverse_diagonal;
    const std::size_t rows = level.matrix.rows();
    if (from_zero) {
        for (std::size_t i = 0; i < rows; ++i) {
            x[i] = 0;
            y[i] = step.first * scale[i] * b[i];
        }
    } else {
        level.matrix.fetch(x);
        level.matrix.multiply(x, [&](std::size_t i, float sum) { y[i] = x[i] + step.first * scale[i] * (b[i] - sum); });
    }
    level.matrix.fetch(y);
    const auto blend = static_cast<float>(step.blend), rest = static_cast<float>(1 - step.blend);
    level.matrix.multiply(y, [&](std::size_t i, float sum) {
        x[i] = rest * x[i] + blend * y[i] + step.second * scale[i] * (b[i] - sum);
    });
}

void FloatCycle::cycle(std::size_t index)
{
    if (index == levels_.size()) {
        solve_coarsest();
        return;
    }
    auto& level = levels_[index];
    const bool last = index + 1 == levels_.size();
    auto& coarse_right = last ? coarsest_right_ : levels_[index + 1].right;
    auto& coarse_solution = last ? coarsest_solution_ : levels_[index + 1].solution;
    smooth(level, true);
    level.matrix.fetch(level.solution);
    level.matrix.multiply(level.solution, [&](std::size_t i, float sum) { level.work[i] = level.right[i] - sum; });
    level.restriction.multiply(level.work, coarse_right, false);
    cycle(index + 1);
    level.interpolation.multiply(coarse_solution, level.solution, true);
    smooth(level, false);
}

void FloatCycle::solve_coarsest()
{
    to_doubles(coarsest_right_, 1, coarsest_in_);
    DEADPOINT_PETSC(KSPSolve(coarsest_, coarsest_in_, coarsest_out_));
    to_floats(coarsest_out_, 1, coarsest_solution_);
}

void FloatCycle::apply(Vec residual, Vec correction)
{
    PetscReal largest = 0;
    DEADPOINT_PETSC(VecNorm(residual, NORM_INFINITY, &largest));
    if (!(largest > 0)) {  // also where a value is not a number, which the solver then finds
        DEADPOINT_PETSC(VecCopy(residual, correction));
        return;
    }
    const double factor = largest_entry / largest;
    auto& right = levels_.empty() ? coarsest_right_ : levels_.front().right;
    to_floats(residual, factor, right);
    cycle(0);
    to_doubles(levels_.empty() ? coarsest_solution_ : levels_.front().solution, 1 / factor, correction);
}

void FloatCycle::view(PetscViewer viewer) const
{
    for (auto level = levels_.rbegin(); level != levels_.rend(); ++level) {
        const std::array<double, 3> own{static_cast<double>(level->matrix.rows()),
                                        static_cast<double>(level->matrix.entries()),
                                        static_cast<double>(level->interpolation.entries())};
        std::array<double, 3> all{};
        MPI_Allreduce(own.data(), all.data(), 3, MPI_DOUBLE, MPI_SUM, PETSC_COMM_WORLD);
        DEADPOINT_PETSC(PetscViewerASCIIPrintf(viewer, "cycle level: rows=%.0f entries=%.0f interpolation=%.0f\n",
                                               all[0], all[1], all[2]));
    }
}

}  // namespace deadpoint::fem
