#include "deadpoint/reduce/certificate/residual_terms.hpp"

#include "deadpoint/exchange/heat.hpp"
#include "deadpoint/reduce/online/dense_terms.hpp"

#include <algorithm>

namespace deadpoint::reduce {
namespace {

constexpr double coefficient_rounding = 1e-9;   // relative, of coefficients
constexpr Eigen::Index largest_correction = 8;  // vectors of a term that make K larger than K'

void add_interface(const InterfaceLaw& law, std::vector<double>& sum)
{
    const double a = law.film_a, b = law.film_b, oil = law.oil, all = a + b + oil;
    const double coupled = a * b / all;
    sum.insert(sum.end(), {a * oil / all, b * oil / all, law.turns_fully ? 0 : coupled, law.turns_fully ? coupled : 0});
}

}  // namespace

Eigen::Index ResidualTerms::corrections(std::size_t term) const
{
    return term + 1 == terms() ? 0 : std::min(largest_correction, kept(term));
}

UniformLoads uniform_loads(const DenseTerms& terms)
{
    const auto& [layout, names, interface_area, surface_area] = terms.geometry;
    UniformLoads result{terms.uniform, {}};
    const auto functional = [](std::size_t index) { return static_cast<Eigen::Index>(index); };
    for (std::size_t i = 0; i < layout.interfaces; ++i) {
        result.of_term.emplace_back(functional(layout.mean(i, false)), interface_area[i]);
        result.of_term.emplace_back(functional(layout.mean(i, true)), interface_area[i]);
        result.of_term.insert(result.of_term.end(), 2, {0, 0.0});
    }
    for (std::size_t s = 0; s < layout.surfaces; ++s)
        result.of_term.emplace_back(functional(layout.surface(s)), 1);
    result.of_term.emplace_back(0, 0.0);
    return result;
}

std::vector<double> coefficients_of(const HeatProblem& problem, const HeatSegment& segment)
{
    std::vector<double> result;
    for (const auto& law : segment.interfaces.empty() ? problem.interfaces : segment.interfaces)
        add_interface(law, result);
    for (const auto& condition : problem.surfaces)
        result.push_back(condition.kind == SurfaceCondition::Kind::film ? condition.coefficient : 0);
    result.push_back(1);
    return result;
}

bool covers(const ResidualTerms& terms, const std::vector<double>& coefficients)
{
    for (std::size_t q = 0; q < terms.lowest.size(); ++q)
        if (!(coefficients[q] >= (1 - coefficient_rounding) * terms.lowest[q]) ||
            (coefficients[q] > 0 && terms.highest[q] == 0))
            return false;
    return true;
}

void set_products(ResidualTerms& terms)
{
    std::vector<Eigen::Index> columns;
    for (std::size_t q = 0; q < terms.terms(); ++q)
        for (Eigen::Index k = 0; k < terms.corrections(q); ++k)
            columns.push_back(terms.first_of_term(q) + k);
    const Eigen::MatrixXd first = terms.root(Eigen::all, columns);
    terms.products = transposed_product(first, first);
}

ResidualNorm::ResidualNorm(const ResidualTerms& terms, const UniformLoads& loads,
                           const std::vector<double>& coefficients)
    : terms_(&terms), loads_(&loads), coefficients_(coefficients)
{
    std::vector<Eigen::Index> chosen, vectors;  // places in products, and among all vectors
    std::vector<double> inverse;
    Eigen::Index place = 0;
    for (std::size_t q = 0; q < terms.terms(); ++q) {
        const double difference = coefficients[q] - terms.lowest[q];
        if (coefficients[q] > 0)
            remainder_factor_ = std::max(remainder_factor_, coefficients[q] / terms.highest[q]);
        for (Eigen::Index k = 0; k < terms.corrections(q); ++k, ++place)
            if (difference > coefficient_rounding * coefficients[q]) {
                chosen.push_back(place);
                vectors.push_back(terms.first_of_term(q) + k);
                inverse.push_back(1 / difference);
            }
    }
    directions_ = terms.root(Eigen::all, vectors);
    Eigen::MatrixXd sum = terms.products(chosen, chosen);
    sum.diagonal() += Eigen::Map<const Eigen::VectorXd>(inverse.data(), sum.rows());
    correction_.compute(sum);
}

Eigen::VectorXd ResidualNorm::squares(const Eigen::MatrixXd& columns) const
{
    const Eigen::MatrixXd seen = upper_product(terms_->root, columns);
    const Eigen::MatrixXd along = correction_.matrixL().solve(transposed_product(directions_, seen));
    return (seen.colwise().squaredNorm() - along.colwise().squaredNorm()).cwiseMax(0.0).transpose();
}

Eigen::MatrixXd ResidualNorm::products(const Eigen::MatrixXd& columns) const
{
    const Eigen::MatrixXd seen = upper_product(terms_->root, columns);
    const Eigen::MatrixXd along = correction_.matrixL().solve(transposed_product(directions_, seen));
    return seen.transpose() * seen - along.transpose() * along;
}

Eigen::RowVectorXd ResidualNorm::means(const Eigen::MatrixXd& states) const
{
    return loads_->uniform.transpose() * states / loads_->uniform.squaredNorm();
}

Eigen::MatrixXd ResidualNorm::deviations(const Eigen::MatrixXd& states) const
{
    return states - loads_->uniform * means(states);
}

Eigen::MatrixXd ResidualNorm::conducted(const Eigen::MatrixXd& states) const
{
    const auto mean = means(states);
    const Eigen::MatrixXd seen = transposed_product(terms_->factors, deviations(states));
    Eigen::MatrixXd result = Eigen::MatrixXd::Zero(terms_->count(), states.cols());
    for (std::size_t q = 0; q < terms_->terms(); ++q) {
        if (coefficients_[q] == 0)
            continue;
        result.middleRows(terms_->first_of_term(q), terms_->kept(q)) =
            coefficients_[q] * seen.middleRows(terms_->first[q], terms_->kept(q));
        const auto& [functional, factor] = loads_->of_term[q];
        result.row(terms_->first_functional() + functional) += coefficients_[q] * factor * mean;
    }
    return result;
}

Eigen::VectorXd ResidualNorm::remainder_squares(const Eigen::MatrixXd& states) const
{
    return remainder_factor_ * (terms_->remainder * deviations(states)).colwise().squaredNorm().transpose();
}

Eigen::MatrixXd ResidualNorm::conducted_on_states(const Eigen::MatrixXd& states,
                                                  const Eigen::MatrixXd& functionals) const
{
    const auto mean = means(states);
    const Eigen::Index of_solid = terms_->first[terms_->terms() - 1];
    Eigen::MatrixXd seen = transposed_product(terms_->factors, deviations(states)).topRows(of_solid);
    Eigen::MatrixXd loads = Eigen::MatrixXd::Zero(functionals.rows(), states.cols());
    for (std::size_t q = 0; q + 1 < terms_->terms(); ++q) {
        seen.middleRows(terms_->first[q], terms_->kept(q)) *= coefficients_[q];
        const auto& [functional, factor] = loads_->of_term[q];
        loads.row(functional) += coefficients_[q] * factor * mean;
    }
    return terms_->factors.leftCols(of_solid) * seen + functionals.transpose() * loads;
}

}  // namespace deadpoint::reduce
