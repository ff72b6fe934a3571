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

UniformLoads uniform_loads(const DenseTerms& terms, const ResidualTerms& residual)
{
    const auto& [layout, names, interface_area, surface_area] = terms.geometry;
    UniformLoads result{terms.uniform, transposed_product(residual.factors, terms.uniform), {}};
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

// A row of the root is contiguous, and a column of the directions: a few rows at a time.
void set_directions(ResidualTerms& terms)
{
    constexpr Eigen::Index at_a_time = 16;
    std::vector<Eigen::Index> columns;
    for (std::size_t q = 0; q < terms.terms(); ++q)
        for (Eigen::Index k = 0; k < terms.corrections(q); ++k)
            columns.push_back(terms.first_of_term(q) + k);
    const Eigen::Index rows = terms.root.rows();
    terms.directions.resize(rows, static_cast<Eigen::Index>(columns.size()));
    for (Eigen::Index first = 0; first < rows; first += at_a_time) {
        const Eigen::Index count = std::min(at_a_time, rows - first);
        terms.directions.middleRows(first, count) = terms.root.middleRows(first, count)(Eigen::all, columns);
    }
}

void set_products(ResidualTerms& terms)
{
    set_directions(terms);
    terms.products = transposed_product(terms.directions, terms.directions);
}

SeenByTerms SeenByTerms::columns(Eigen::Index first, Eigen::Index count) const
{
    return {means.segment(first, count), deviations.middleCols(first, count), factors.middleCols(first, count)};
}

SeenByTerms seen_by_terms(const ResidualTerms& terms, const UniformLoads& loads, const Eigen::MatrixXd& states)
{
    SeenByTerms seen;
    seen.means = loads.uniform.transpose() * states / loads.uniform.squaredNorm();
    seen.deviations = states - loads.uniform * seen.means;
    seen.factors = transposed_product(terms.factors, seen.deviations);
    return seen;
}

ResidualNorm::ResidualNorm(const ResidualTerms& terms, const UniformLoads& loads,
                           const std::vector<double>& coefficients)
    : terms_(&terms), loads_(&loads), coefficients_(coefficients)
{
    std::vector<double> inverse;
    Eigen::Index place = 0;
    for (std::size_t q = 0; q < terms.terms(); ++q) {
        const double difference = coefficients[q] - terms.lowest[q];
        if (coefficients[q] > 0)
            remainder_factor_ = std::max(remainder_factor_, coefficients[q] / terms.highest[q]);
        for (Eigen::Index k = 0; k < terms.corrections(q); ++k, ++place)
            if (difference > coefficient_rounding * coefficients[q]) {
                chosen_.push_back(place);
                inverse.push_back(1 / difference);
            }
    }
    Eigen::MatrixXd sum = terms.products(chosen_, chosen_);
    sum.diagonal() += Eigen::Map<const Eigen::VectorXd>(inverse.data(), sum.rows());
    correction_.compute(sum);
}

Eigen::MatrixXd ResidualNorm::along_corrections(const Eigen::MatrixXd& rooted) const
{
    const Eigen::MatrixXd along = transposed_product(terms_->directions, rooted)(chosen_, Eigen::all);
    return correction_.matrixL().solve(along);
}

Eigen::VectorXd ResidualNorm::squares(const Eigen::MatrixXd& rooted) const
{
    const auto along = along_corrections(rooted);
    return (rooted.colwise().squaredNorm() - along.colwise().squaredNorm()).cwiseMax(0.0).transpose();
}

Eigen::MatrixXd ResidualNorm::products(const Eigen::MatrixXd& rooted) const
{
    const auto along = along_corrections(rooted);
    return rooted.transpose() * rooted - along.transpose() * along;
}

Eigen::MatrixXd ResidualNorm::conducted(const SeenByTerms& states) const
{
    Eigen::MatrixXd result = Eigen::MatrixXd::Zero(terms_->count(), states.factors.cols());
    for (std::size_t q = 0; q < terms_->terms(); ++q) {
        if (coefficients_[q] == 0)
            continue;
        result.middleRows(terms_->first_of_term(q), terms_->kept(q)) =
            coefficients_[q] * states.factors.middleRows(terms_->first[q], terms_->kept(q));
        const auto& [functional, factor] = loads_->of_term[q];
        result.row(terms_->first_functional() + functional) += coefficients_[q] * factor * states.means;
    }
    return result;
}

Eigen::VectorXd ResidualNorm::remainder_squares(const SeenByTerms& states) const
{
    return remainder_factor_ * (terms_->remainder * states.deviations).colwise().squaredNorm().transpose();
}

Eigen::VectorXd ResidualNorm::conducted_between(const SeenByTerms& z, const Eigen::MatrixXd& functionals,
                                                const SeenByTerms& x) const
{
    Eigen::RowVectorXd result = Eigen::RowVectorXd::Zero(x.factors.cols());
    for (std::size_t q = 0; q + 1 < terms_->terms(); ++q) {
        if (coefficients_[q] == 0)
            continue;
        const Eigen::Index first = terms_->first[q], kept = terms_->kept(q);
        const Eigen::MatrixXd whole =
            z.factors.middleRows(first, kept) + loads_->factors.segment(first, kept) * z.means;
        const auto& [functional, factor] = loads_->of_term[q];
        result += coefficients_[q] * (whole.cwiseProduct(x.factors.middleRows(first, kept)).colwise().sum() +
                                      factor * functionals.row(functional).cwiseProduct(x.means));
    }
    return result.transpose();
}

}  // namespace deadpoint::reduce
