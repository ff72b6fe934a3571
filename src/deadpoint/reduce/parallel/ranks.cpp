#include "deadpoint/reduce/parallel/ranks.hpp"

#include "deadpoint/reduce/online/dense_terms.hpp"

namespace deadpoint::reduce {
namespace {

template <class Matrix>
void share_as(const Ranks& ranks, Matrix& matrix)
{
    Eigen::MatrixXd copy = matrix;
    ranks.share(copy, 0);
    matrix = copy;
}

}  // namespace

Eigen::MatrixXd on_first(const Ranks& ranks, const std::function<Eigen::MatrixXd()>& compute)
{
    Eigen::MatrixXd result;
    if (ranks.rank() == 0)
        result = compute();
    ranks.share(result, 0);
    return result;
}

void share(const Ranks& ranks, DenseTerms& terms)
{
    if (ranks.count() == 1)
        return;
    const auto& layout = terms.geometry.layout;
    terms.joints.resize(layout.interfaces);
    terms.films.resize(layout.surfaces);
    ranks.share(terms.solid, 0);
    for (auto& joint : terms.joints)
        for (auto* term : {&joint.aa, &joint.bb, &joint.between, &joint.turning})
            ranks.share(term->factor, 0);
    for (auto& film : terms.films)
        ranks.share(film.factor, 0);
    share_as(ranks, terms.functionals);
    share_as(ranks, terms.observed);
    share_as(ranks, terms.uniform);
    ranks.share(terms.parts, 0);
}

bool any(const Ranks& ranks, bool flag)
{
    Eigen::MatrixXd flags = Eigen::MatrixXd::Constant(1, 1, flag ? 1 : 0);
    ranks.sum(flags);
    return flags(0, 0) > 0;
}

}  // namespace deadpoint::reduce
