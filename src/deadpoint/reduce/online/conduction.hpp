#pragma once

#include "deadpoint/reduce/dense/symmetric_matrix.hpp"
#include "deadpoint/reduce/dense/tridiagonal.hpp"

#include <cstddef>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <utility>
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

/// Index of a term of PreparedTerms and its coefficient in a sum.
using TermWeights = std::vector<std::pair<std::size_t, double>>;

/// The matrices of the last sums, so that runs and segments with the same coefficients share one: most runs that differ
/// in operation or in media only. Several threads may ask.
class Conductions {
public:
    /// @param sum  computes the matrix where it is not there
    std::shared_ptr<const Conduction> get(const TermWeights& weights, const std::function<SymmetricMatrix()>& sum);

    /// Number of matrices that are kept.
    [[nodiscard]] std::size_t count();

private:
    struct Entry {
        TermWeights weights;
        std::shared_ptr<const Conduction> conduction;
    };
    [[nodiscard]] std::shared_ptr<const Conduction> find(const TermWeights& weights);

    std::mutex mutex_;
    std::deque<Entry> entries_;  ///< the last used first
};

}  // namespace deadpoint::reduce
