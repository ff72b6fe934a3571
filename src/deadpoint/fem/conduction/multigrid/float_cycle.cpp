#include "deadpoint/fem/conduction/multigrid/float_cycle.hpp"

#include "deadpoint/fem/algebra/vectors.hpp"
#include "deadpoint/fem/conduction/multigrid/local_rows.hpp"

#include <algorithm>
#include <array>
#include <type_traits>

namespace deadpoint::fem {
namespace {

// Share of the bound from which on a smoother reduces errors; coarser levels handle lower eigenvalues.
constexpr double smoothed_from = 0.05;
// Largest entry of a scaled residual: far above the smallest floating-point number, since corrections fade by many
// decades away from a local load.
constexpr double largest_entry = 1e10;

// Factors of two steps of Chebyshev's iteration on [from, to]: the first adds first D^-1 r; the second gives
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

template <class Value>
constexpr std::size_t vectors_of = std::is_same_v<Value, float> ? 1 : lanes;

float part(float value, std::size_t) { return value; }
float part(const FloatBlock& value, std::size_t lane) { return value[lane]; }
void set_part(float& value, std::size_t, float part) { value = part; }
void set_part(FloatBlock& value, std::size_t lane, float part) { value[lane] = part; }

std::size_t local_size(Vec vector)
{
    PetscInt count = 0;
    DEADPOINT_PETSC(VecGetLocalSize(vector, &count));
    return static_cast<std::size_t>(count);
}

// To and from one vector of a block.
template <class Value>
void to_floats(Vec from, double factor, std::size_t lane, std::vector<Value>& to)
{
    const ConstEntries values(from);
    const std::size_t count = local_size(from);
    for (std::size_t i = 0; i < count; ++i)
        set_part(to[i], lane, static_cast<float>(factor * values[i]));
}

template <class Value>
void to_doubles(const std::vector<Value>& from, double factor, std::size_t lane, Vec to)
{
    Entries values(to);
    const std::size_t count = local_size(to);
    for (std::size_t i = 0; i < count; ++i)
        values[i] = factor * static_cast<double>(part(from[i], lane));
}

// Factors that bring the largest entry of each vector to largest_entry; 1 where all are zero.
DoubleBlock scales_of(const std::vector<DoubleBlock>& vectors)
{
    DoubleBlock largest = 0;
    for (const auto& row : vectors)
        largest = std::experimental::max(largest, abs(row));
    std::array<double, lanes> values{};
    largest.copy_to(values.data(), std::experimental::element_aligned);
    MPI_Allreduce(MPI_IN_PLACE, values.data(), lanes, MPI_DOUBLE, MPI_MAX, PETSC_COMM_WORLD);
    for (auto& value : values)
        value = value > 0 ? largest_entry / value : 1;
    return DoubleBlock(values.data(), std::experimental::element_aligned);
}

}  // namespace

FloatCycle::Transfer::Transfer(Mat matrix, Vec to) : matrix_(matrix)
{
    // PETSc's own hierarchies have one matrix for both ways.
    PetscInt rows = 0, wanted = 0;
    DEADPOINT_PETSC(MatGetSize(matrix, &rows, nullptr));
    DEADPOINT_PETSC(VecGetSize(to, &wanted));
    if (rows != wanted) {
        DEADPOINT_PETSC(MatTranspose(matrix, MAT_INITIAL_MATRIX, transposed_.out()));
        matrix_ = transposed_;
    }
    if (is_assembled(matrix_))
        copy_.emplace(matrix_);
    else
        DEADPOINT_PETSC(MatCreateVecs(matrix_, in_.out(), out_.out()));
}

template <class Value>
void FloatCycle::Transfer::multiply(std::vector<Value>& in, std::vector<Value>& out, bool adds)
{
    if (copy_) {
        copy_->fetch(in);
        if (adds)
            copy_->multiply(in, [&](std::size_t row, const Value& sum) { out[row] += sum; });
        else
            copy_->multiply(in, [&](std::size_t row, const Value& sum) { out[row] = sum; });
        return;
    }
    const std::size_t count = local_size(out_);
    for (std::size_t lane = 0; lane < vectors_of<Value>; ++lane) {
        to_doubles(in, 1, lane, in_);
        DEADPOINT_PETSC(MatMult(matrix_, in_, out_));
        const ConstEntries product(out_);
        for (std::size_t i = 0; i < count; ++i)
            set_part(out[i], lane, static_cast<float>(product[i]) + (adds ? part(out[i], lane) : 0.0F));
    }
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
        KSP smoother = nullptr, coarser = nullptr;
        Mat restriction = nullptr, interpolation = nullptr;
        DEADPOINT_PETSC(PCMGGetSmoother(multigrid, level, &smoother));
        DEADPOINT_PETSC(PCMGGetSmoother(multigrid, level - 1, &coarser));
        DEADPOINT_PETSC(PCMGGetRestriction(multigrid, level, &restriction));
        DEADPOINT_PETSC(PCMGGetInterpolation(multigrid, level, &interpolation));
        const Mat matrix = matrix_of(smoother);
        OwnedVec fine, coarse;
        DEADPOINT_PETSC(MatCreateVecs(matrix, fine.out(), nullptr));
        DEADPOINT_PETSC(MatCreateVecs(matrix_of(coarser), coarse.out(), nullptr));
        levels_.push_back(
            {matrix, FloatMatrix(matrix), Transfer(restriction, coarse), Transfer(interpolation, fine), {}});
    }
    DEADPOINT_PETSC(PCMGGetCoarseSolve(multigrid, &coarsest_));
    DEADPOINT_PETSC(MatCreateVecs(matrix_of(coarsest_), coarsest_out_.out(), coarsest_in_.out()));
    stack_ = new_stack<float>();
}

template <class Value>
FloatCycle::Stack<Value> FloatCycle::new_stack() const
{
    Stack<Value> stack;
    std::size_t from_finer = 0;  // ghosts of the interpolation to the next finer level
    for (const auto& level : levels_) {
        const std::size_t rows = level.matrix.rows();
        const std::size_t ghosts = std::max({level.matrix.ghosts(), level.restriction.ghosts(), from_finer});
        stack.push_back(
            {std::vector<Value>(rows, 0), std::vector<Value>(rows + ghosts, 0), std::vector<Value>(rows + ghosts, 0)});
        from_finer = level.interpolation.ghosts();
    }
    const std::size_t rows = local_size(coarsest_in_);
    stack.push_back({std::vector<Value>(rows, 0), std::vector<Value>(rows + from_finer, 0), {}});
    return stack;
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

// The solution follows from vectors.solution, or from zero, for vectors.right.
template <class Value>
void FloatCycle::smooth(const Level& level, Vectors<Value>& vectors, bool from_zero) const
{
    const Chebyshev step(level.bound);
    auto& x = vectors.solution;
    auto& y = vectors.work;
    const auto& b = vectors.right;
    const auto& scale = level.inverse_diagonal;
    const std::size_t rows = level.matrix.rows();
    const float first = step.first, second = step.second;
    const auto blend = static_cast<float>(step.blend), rest = static_cast<float>(1 - step.blend);
    if (from_zero) {
        for (std::size_t i = 0; i < rows; ++i) {
            x[i] = 0;
            y[i] = first * scale[i] * b[i];
        }
    } else {
        level.matrix.fetch(x);
        level.matrix.multiply(x,
                              [&](std::size_t i, const Value& sum) { y[i] = x[i] + first * scale[i] * (b[i] - sum); });
    }
    level.matrix.fetch(y);
    level.matrix.multiply(y, [&](std::size_t i, const Value& sum) {
        x[i] = rest * x[i] + blend * y[i] + second * scale[i] * (b[i] - sum);
    });
}

template <class Value>
void FloatCycle::cycle(Stack<Value>& stack, std::size_t index)
{
    auto& vectors = stack[index];
    if (index == levels_.size()) {
        solve_coarsest(vectors);
        return;
    }
    auto& level = levels_[index];
    auto& coarse = stack[index + 1];
    smooth(level, vectors, true);
    level.matrix.fetch(vectors.solution);
    level.matrix.multiply(vectors.solution,
                          [&](std::size_t i, const Value& sum) { vectors.work[i] = vectors.right[i] - sum; });
    level.restriction.multiply(vectors.work, coarse.right, false);
    cycle(stack, index + 1);
    level.interpolation.multiply(coarse.solution, vectors.solution, true);
    smooth(level, vectors, false);
}

template <class Value>
void FloatCycle::solve_coarsest(Vectors<Value>& vectors)
{
    for (std::size_t lane = 0; lane < vectors_of<Value>; ++lane) {
        to_doubles(vectors.right, 1, lane, coarsest_in_);
        DEADPOINT_PETSC(KSPSolve(coarsest_, coarsest_in_, coarsest_out_));
        to_floats(coarsest_out_, 1, lane, vectors.solution);
    }
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
    to_floats(residual, factor, 0, stack_.front().right);
    cycle(stack_, 0);
    to_doubles(stack_.front().solution, 1 / factor, 0, correction);
}

void FloatCycle::apply(const std::vector<DoubleBlock>& residuals, std::vector<DoubleBlock>& corrections)
{
    using std::experimental::static_simd_cast;
    if (block_stack_.empty())
        block_stack_ = new_stack<FloatBlock>();
    auto& finest = block_stack_.front();
    const DoubleBlock scales = scales_of(residuals);
    for (std::size_t i = 0; i < finest.right.size(); ++i)
        finest.right[i] = static_simd_cast<FloatBlock>(scales * residuals[i]);
    cycle(block_stack_, 0);
    for (std::size_t i = 0; i < finest.right.size(); ++i)
        corrections[i] = static_simd_cast<DoubleBlock>(finest.solution[i]) / scales;
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
