#pragma once

#include "deadpoint/fem/space/petsc.hpp"

#include <cstddef>
#include <span>
#include <vector>

/// Internal to fem/: sparse matrices in single precision.
namespace deadpoint::fem {

/// This rank's rows of a matrix of PETSc (AIJ, on one rank or many) in single precision. Columns are local: first this
/// rank's, then the ghosts, entries that other ranks own.
class FloatMatrix {
public:
    explicit FloatMatrix(Mat matrix);

    /// Copies the values of a matrix of the same pattern.
    void take_values(Mat matrix);

    [[nodiscard]] std::size_t rows() const { return starts_.size() - 1; }
    [[nodiscard]] std::size_t columns() const { return columns_; }
    [[nodiscard]] std::size_t entries() const { return values_.size(); }
    [[nodiscard]] std::size_t ghosts() const { return ghosts_; }
    [[nodiscard]] std::vector<float> inverse_diagonal() const;

    /// Fetches the ghosts of a vector: columns() entries of this rank, then room for ghosts(). Collective.
    void fetch(std::vector<float>& vector) const;

    /// Calls take(row, sum of entry times vector) for each row; the ghosts must have been fetched.
    template <class Take>
    void multiply(const std::vector<float>& vector, const Take& take) const
    {
        const float* x = vector.data();
        const float* value = values_.data();
        const PetscInt* column = places_.data();
        for (std::size_t row = 0; row < rows(); ++row) {
            const float* end = values_.data() + starts_[row + 1];
            float sum = 0;
            for (; value != end; ++value, ++column)
                sum += *value * x[*column];
            take(row, sum);
        }
    }

private:
    struct Exchange {
        int rank = 0;
        std::vector<PetscInt> sent;  ///< local columns that this rank needs
        std::size_t first = 0;       ///< where what it sends begins among the ghosts
        std::size_t count = 0;
    };
    void find_exchanges(MPI_Comm communicator, Mat matrix, std::span<const PetscInt> ghosts);

    std::vector<PetscInt> starts_, places_;
    std::vector<float> values_;
    std::size_t columns_ = 0, ghosts_ = 0;
    std::vector<Exchange> exchanges_;
    MPI_Comm communicator_ = MPI_COMM_SELF;
};

/// True if a FloatMatrix can be made of it.
bool is_assembled(Mat matrix);

}  // namespace deadpoint::fem
