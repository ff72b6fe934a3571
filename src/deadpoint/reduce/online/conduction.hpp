#pragma once

#include "deadpoint/reduce/dense/symmetric_matrix.hpp"
#include "deadpoint/reduce/dense/tridiagonal.hpp"

#include <deque>
#include <memory>
#include <mutex>
#include <vector>

/// Internal to reduce/, since it shows Eigen.
namespace deadpoint::reduce {

/// A conduction matrix K with its tridiagonal form, made when first asked for.
class Conduction {
public:
    explicit Conduction(SymmetricMatrix matrix) : matrix_(std::move(matrix)) {}
    [[nodiscard]] const SymmetricMatrix& matrix() const { return matrix_; }
    [[nodiscard]] std::shared_ptr<const TridiagonalForm> form() const;

private:
    SymmetricMatrix matrix_;
    mutable std::once_flag once_;
    mutable std::shared_ptr<const TridiagonalForm> form_;
};

/// The matrices of the last sums, so that runs and segments with the same coefficients share one: most runs that differ
/// in operation or in media only. Several threads may ask.
class Conductions {
public:
    /// start + the sum of terms.
    std::shared_ptr<const Conduction> sum(const SymmetricMatrix& start,
                                          const std::vector<SymmetricMatrix::Term>& terms);

private:
    struct Entry {
        std::vector<SymmetricMatrix::Term> terms;
        std::shared_ptr<const Conduction> conduction;
    };
    [[nodiscard]] std::shared_ptr<const Conduction> find(const std::vector<SymmetricMatrix::Term>& terms);

    std::mutex mutex_;
    std::deque<Entry> entries_;  ///< the last used first
};

}  // namespace deadpoint::reduce
