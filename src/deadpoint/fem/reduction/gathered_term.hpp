#pragma once

#include "deadpoint/fem/conduction/terms/sparse_term.hpp"

#include <Eigen/Sparse>
#include <utility>
#include <vector>

/// Internal to fem/: a term of the heat matrices with its rows of a basis.
namespace deadpoint::fem {

class BasisFields;

/// Terms to be summed, with factors.
using TermSum = std::vector<std::pair<double, const SparseTerm*>>;

/// A sum of terms on one rank: its entries, and the rows of the basis on all of its unknowns.
class GatheredTerm {
public:
    /// Collective. @param owner  the rank that has all of it afterwards; the others have nothing
    GatheredTerm(const Discretisation& space, const TermSum& sum, const BasisFields& fields, int owner);
    /// fields^T A fields columns, on the owner.
    [[nodiscard]] Eigen::MatrixXd product(const Eigen::MatrixXd& columns) const;
    /// A fields columns on the term's unknowns, on the owner.
    [[nodiscard]] Eigen::MatrixXd image(const Eigen::MatrixXd& columns) const;
    /// Unknowns of all ranks, ascending.
    [[nodiscard]] const std::vector<PetscInt>& unknowns() const { return unknowns_; }

private:
    std::vector<PetscInt> unknowns_;  ///< ascending
    Eigen::MatrixXd rows_;
    Eigen::SparseMatrix<double, Eigen::RowMajor> matrix_;
};

}  // namespace deadpoint::fem
