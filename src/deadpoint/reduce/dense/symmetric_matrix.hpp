#pragma once

#include <Eigen/Dense>
#include <cstddef>
#include <vector>

/// Internal to reduce/, since it shows Eigen.
namespace deadpoint::reduce {

/// Numbers that lie as the kernels want them: aligned, and filled up with zeros.
class PaddedNumbers {
public:
    PaddedNumbers() = default;
    explicit PaddedNumbers(std::ptrdiff_t count);  ///< at least so many, all zero
    [[nodiscard]] std::ptrdiff_t count() const;
    [[nodiscard]] double* data();
    [[nodiscard]] const double* data() const;

private:
    struct alignas(64) Eight {
        double numbers[8];
    };
    std::vector<Eight> eights_;
};

/// A symmetric matrix in panels of its lower half (see kernels.hpp): about n^2/2 numbers.
class SymmetricMatrix {
public:
    SymmetricMatrix() = default;  ///< without rows
    /// @param matrix  of which only the lower half is read
    explicit SymmetricMatrix(const Eigen::MatrixXd& matrix);

    [[nodiscard]] Eigen::Index rows() const { return rows_; }
    [[nodiscard]] Eigen::Index padded_rows() const;
    [[nodiscard]] double* panels() { return numbers_.data(); }
    [[nodiscard]] const double* panels() const { return numbers_.data(); }
    [[nodiscard]] Eigen::MatrixXd lower() const;  ///< the upper half is zero

    struct Term {
        double coefficient = 0;
        const SymmetricMatrix* matrix = nullptr;
        bool operator==(const Term&) const = default;
    };
    /// This matrix + the sum of terms, all of the same size.
    [[nodiscard]] SymmetricMatrix plus(const std::vector<Term>& terms) const;
    /// Sum of the products of all entries.
    [[nodiscard]] double product(const SymmetricMatrix& other) const;
    [[nodiscard]] Eigen::VectorXd times(const Eigen::VectorXd& vector) const;

private:
    Eigen::Index rows_ = 0;
    PaddedNumbers numbers_;
};

}  // namespace deadpoint::reduce
