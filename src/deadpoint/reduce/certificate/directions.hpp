#pragma once

#include <Eigen/Dense>
#include <vector>

/// Internal to reduce/, since it shows Eigen: which directions of a conduction matrix's terms a certificate keeps.
namespace deadpoint::reduce {

struct ResidualTask;
struct ResidualTerms;

/// Sets first, factors, highest and remainder of ResidualTerms.
///
/// A term A has the factor F of V^T A V, its columns orthogonal. Combinations F Q of those above `cut.kept` of the
/// largest are its f_j, with y_j = A V F (F^T F)^-1 Q: the principal directions of F^T x for typical states x. Of all
/// terms together the directions with the smallest heat, highest x (f_j . x)^2, go to the remainder, up to `cut.left`
/// of the sum.
/// @param factors  of each term, K_0 last; without columns where there is no such term
/// @return F (F^T F)^-1 Q of each term: the combinations of V whose products with A are its y_j
std::vector<Eigen::MatrixXd> choose_directions(const std::vector<Eigen::MatrixXd>& factors, const ResidualTask& task,
                                               ResidualTerms& result);

}  // namespace deadpoint::reduce
