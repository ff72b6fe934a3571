#include "deadpoint/fem/conduction/multigrid/conjugate_gradients.hpp"

#include "deadpoint/error.hpp"
#include "deadpoint/fem/conduction/multigrid/float_cycle.hpp"
#include "deadpoint/fem/conduction/multigrid/ghosts.hpp"
#include "deadpoint/fem/conduction/multigrid/local_rows.hpp"
#include "deadpoint/fem/conduction/multigrid/next_correction.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <optional>
#include <utility>
#include <vector>

namespace deadpoint::fem {
namespace {

using Block = std::vector<DoubleBlock>;
using PerVector = std::array<double, lanes>;

constexpr int most_iterations = 2000;
constexpr auto remedy = "look for a coefficient of the case that cannot be meant";

DoubleBlock to_block(const PerVector& values) { return {values.data(), std::experimental::element_aligned}; }

PerVector products(const Block& one, const Block& other, std::size_t rows)
{
    DoubleBlock sum = 0;
    for (std::size_t i = 0; i < rows; ++i)
        sum += one[i] * other[i];
    PerVector result{};
    sum.copy_to(result.data(), std::experimental::element_aligned);
    MPI_Allreduce(MPI_IN_PLACE, result.data(), lanes, MPI_DOUBLE, MPI_SUM, PETSC_COMM_WORLD);
    return result;
}

PerVector norms(const Block& block, std::size_t rows)
{
    auto result = products(block, block, rows);
    for (auto& value : result)
        value = std::sqrt(value);
    return result;
}

// 0 where a vector has nothing left.
PerVector ratios(const PerVector& above, const PerVector& below)
{
    PerVector result{};
    for (std::size_t k = 0; k < lanes; ++k)
        result[k] = below[k] != 0 ? above[k] / below[k] : 0;
    return result;
}

/// Products of a matrix with blocks, in double.
class Product {
public:
    explicit Product(Mat matrix) : local_(matrix), ghosts_(matrix, local_.ghosts), own_(local_.own)
    {
        if (local_.other)
            other_.emplace(local_.other);
    }
    [[nodiscard]] std::size_t rows() const { return own_.count; }
    [[nodiscard]] std::size_t ghosts() const { return ghosts_.count(); }
    void multiply(Block& in, Block& out) const
    {
        ghosts_.fetch(in);
        for (std::size_t row = 0; row < rows(); ++row) {
            out[row] = sum(own_, row, in.data());
            if (other_)
                out[row] += sum(*other_, row, in.data() + rows());
        }
    }

private:
    static DoubleBlock sum(const CompressedRows& matrix, std::size_t row, const DoubleBlock* in)
    {
        DoubleBlock sum = 0;
        for (PetscInt k = matrix.starts[row]; k < matrix.starts[row + 1]; ++k)
            sum += matrix.values[k] * in[matrix.columns[k]];
        return sum;
    }
    LocalRows local_;
    Ghosts ghosts_;
    CompressedRows own_;
    std::optional<CompressedRows> other_;
};

/// When to stop: as StageMatrix::test, for each vector.
class Progress {
public:
    explicit Progress(double relative) : relative_(relative) {}
    void corrected(const PerVector& correction)
    {
        correction_ = correction;
        for (std::size_t k = 0; k < lanes; ++k)
            size_[k] = std::max(size_[k], correction[k]);
    }
    void started(const PerVector& residual) { residual_ = residual; }
    /// @throws ConvergenceError if a residual is not finite
    [[nodiscard]] bool ends(const PerVector& residual, const char* what)
    {
        if (!std::ranges::all_of(residual, [](double value) { return std::isfinite(value); }))
            throw ConvergenceError(fmt::format("{} is not finite; {}", what, remedy));
        const auto before = std::exchange(residual_, residual);
        for (std::size_t k = 0; k < lanes; ++k)
            if (before[k] > 0 && next_correction(correction_[k], residual[k], before[k]) > relative_ * size_[k])
                return false;
        return true;
    }

private:
    double relative_;
    PerVector size_{}, correction_{}, residual_{};
};

// Returns the iterations.
int solve_block(const Product& matrix, FloatCycle& cycle, double relative, Block& residual, Block& solution,
                const char* what)
{
    const std::size_t rows = matrix.rows();
    Block correction(rows), direction(rows + matrix.ghosts(), 0), product(rows);
    std::fill(solution.begin(), solution.end(), DoubleBlock(0));
    Progress progress(relative);
    progress.started(norms(residual, rows));
    PerVector before{};
    for (int iteration = 1; iteration <= most_iterations; ++iteration) {
        cycle.apply(residual, correction);
        progress.corrected(norms(correction, rows));
        const auto now = products(residual, correction, rows);
        const DoubleBlock turn = to_block(ratios(now, before));
        for (std::size_t i = 0; i < rows; ++i)
            direction[i] = correction[i] + turn * direction[i];
        matrix.multiply(direction, product);
        const DoubleBlock step = to_block(ratios(now, products(direction, product, rows)));
        for (std::size_t i = 0; i < rows; ++i) {
            solution[i] += step * direction[i];
            residual[i] -= step * product[i];
        }
        before = now;
        if (progress.ends(norms(residual, rows), what))
            return iteration;
    }
    throw ConvergenceError(fmt::format("{} did not converge in {} iterations; {}", what, most_iterations, remedy));
}

}  // namespace

BlockSolution solve_together(Mat matrix, FloatCycle& cycle, const Eigen::MatrixXd& right, double relative,
                             const char* what)
{
    const Product product(matrix);
    BlockSolution result{Eigen::MatrixXd(right.rows(), right.cols()), 0};
    Block residual(product.rows()), solution(product.rows());
    for (Eigen::Index first = 0; first < right.cols(); first += lanes) {
        const Eigen::Index count = std::min<Eigen::Index>(lanes, right.cols() - first);
        for (Eigen::Index i = 0; i < right.rows(); ++i) {
            auto& row = residual[static_cast<std::size_t>(i)];
            row = 0;
            for (Eigen::Index k = 0; k < count; ++k)
                row[static_cast<std::size_t>(k)] = right(i, first + k);
        }
        result.iterations =
            std::max(result.iterations, solve_block(product, cycle, relative, residual, solution, what));
        for (Eigen::Index i = 0; i < right.rows(); ++i)
            for (Eigen::Index k = 0; k < count; ++k)
                result.columns(i, first + k) = solution[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)];
    }
    return result;
}

}  // namespace deadpoint::fem
