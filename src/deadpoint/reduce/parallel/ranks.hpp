#pragma once

#include <Eigen/Dense>
#include <functional>

namespace deadpoint::reduce {

struct DenseTerms;

/// The processes that build a model together; this class itself stands for a single one. Every member but rank() and
/// count() is collective, and its result is equal bit by bit on all ranks.
class Ranks {
public:
    virtual ~Ranks() = default;
    [[nodiscard]] virtual int rank() const { return 0; }
    [[nodiscard]] virtual int count() const { return 1; }
    /// Sums matrices of one size over the ranks, in place.
    virtual void sum(Eigen::MatrixXd& matrix) const { (void)matrix; }
    /// Replaces a matrix by that of one rank, which may have another size.
    virtual void share(Eigen::MatrixXd& matrix, int from) const
    {
        (void)matrix;
        (void)from;
    }
};

/// What the first rank computes, on all of them: decompositions of equal matrices need not be equal on unlike
/// processors. Collective.
Eigen::MatrixXd on_first(const Ranks& ranks, const std::function<Eigen::MatrixXd()>& compute);

/// Replaces the matrices of terms by those of the first rank. All ranks have the geometry. Collective.
void share(const Ranks& ranks, DenseTerms& terms);

/// True on all ranks if it is on one. Collective.
bool any(const Ranks& ranks, bool flag);

}  // namespace deadpoint::reduce
