#pragma once

#include "deadpoint/fem/algebra/petsc.hpp"
#include "deadpoint/fem/conduction/multigrid/blocks.hpp"
#include "deadpoint/fem/conduction/multigrid/ghosts.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

/// Internal to fem/: sparse matrices in single precision.
namespace deadpoint::fem {

/// This rank's rows of a matrix of PETSc (AIJ, on one rank or many) in single precision. Columns are local: first this
/// rank's, then the ghosts, entries that other ranks own.
///
/// Eight rows make a slice: the first entry of each, then the second, and so on, filled up with zeros (SELL, Kreutzer
/// et al., SIAM J. Sci. Comput. 36, 2014). So the processor multiplies several rows at once and keeps up with the
/// memory.
class FloatMatrix {
public:
    explicit FloatMatrix(Mat matrix);

    /// Copies the values of a matrix of the same pattern.
    void take_values(Mat matrix);

    [[nodiscard]] std::size_t rows() const { return lengths_.size(); }
    [[nodiscard]] std::size_t entries() const;  ///< without the zeros that fill up
    [[nodiscard]] std::size_t ghosts() const { return ghosts_.count(); }
    [[nodiscard]] std::vector<float> inverse_diagonal() const;

    /// Fetches the ghosts of a vector or a block of vectors: this rank's entries, then room for ghosts(). Collective.
    template <class Value>
    void fetch(std::vector<Value>& vector) const
    {
        ghosts_.fetch(vector);
    }

    /// Calls take(row, sum of entry times vector) for each row; the ghosts must have been fetched.
    template <class Take>
    void multiply(const std::vector<float>& vector, const Take& take) const
    {
        const float* x = vector.data();
        std::array<float, slice> sums{};
        for (std::size_t first = 0; first < rows(); first += slice) {
            FloatBlock sum = 0;
            for (std::size_t k = starts_[first / slice]; k < starts_[first / slice + 1]; k += slice) {
                const PetscInt* place = places_.data() + k;
                const FloatBlock value(values_.data() + k, std::experimental::element_aligned);
                sum += value * FloatBlock([&](auto lane) { return x[place[lane]]; });
            }
            sum.copy_to(sums.data(), std::experimental::element_aligned);
            const std::size_t count = std::min(slice, rows() - first);
            for (std::size_t lane = 0; lane < count; ++lane)
                take(first + lane, sums[lane]);
        }
    }
    /// The same for a block of vectors.
    template <class Take>
    void multiply(const std::vector<FloatBlock>& vectors, const Take& take) const
    {
        for (std::size_t row = 0; row < rows(); ++row) {
            FloatBlock sum = 0;
            const std::size_t first = position(row, 0), end = first + slice * lengths_[row];
            for (std::size_t k = first; k < end; k += slice)
                sum += values_[k] * vectors[static_cast<std::size_t>(places_[k])];
            take(row, sum);
        }
    }

private:
    static constexpr std::size_t slice = lanes;

    /// Index of the k-th entry of a row.
    [[nodiscard]] std::size_t position(std::size_t row, std::size_t k) const
    {
        return starts_[row / slice] + k * slice + row % slice;
    }

    std::vector<std::size_t> lengths_;  ///< entries per row
    std::vector<std::size_t> starts_;   ///< per slice, and the end
    std::vector<PetscInt> places_;      ///< columns
    std::vector<float> values_;
    Ghosts ghosts_;
};

}  // namespace deadpoint::fem
